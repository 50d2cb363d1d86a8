#!/usr/bin/env python3
"""Writes assets/scenes/fairground.toml: a swing ride, a shooting gallery, tents and lamps at night.

    python3 assets/source/make_fairground.py > assets/scenes/fairground.toml

Metres, +Y up. One comes in at +Z and looks down -Z. fairground_plan.py has the measures.
"""
import math

import fairground_plan as fair
from garden_things import at, turned
from scene_writer import array, ball, box, compound, entity, heading, out, prefab, prism, put, vec

RIDE, GALLERY = (-3.6, 0, -4.0), (6.3, 0, -2.2)
BALLOON = 0.28  # radius, m
WARM, ROSE, BLUE = (1, 0.62, 0.28), (1, 0.3, 0.22), (0.35, 0.5, 1)

put("""# The fairground: a swing ride, a shooting gallery, tents and strings of lamps, at night.
# Written by assets/source/make_fairground.py: change that and run it again.

[scene]
title = "The fairground"
description = "A swing ride, a shooting gallery and coloured lamps, at night"
include = ["materials.toml", "things.toml"]

[world]
kill_below_m = -20

[player]
position_m = [1.4, 0, 13.6]
yaw_deg = 6
pitch_deg = 4

[camera]
position_m = [0.9, 1.75, 9.4]
target_m = [0.5, 2.9, -3]
fov_deg = 60

[time]
hour = 20.1                             # the last light behind the hills
latitude_deg = 52
day_of_year = 235

[sun]
color = [1.0, 0.96, 0.9]
intensity = 20                          # of a long exposure: the sky is blue, and stars are out

[sky]
model = "atmosphere"
cloud_map = "skies/clouds"
clouds = 0.35

[flashlight]

[sound]
paths = true

[post]
exposure = 1.1
bloom = 0.1

[goal]
text = "Knock nine of eleven down"
things = ["target.*", "tin.*"]
below_m = 1.05                          # targets fall back on their hinges, tins from their shelves
count = 9
within_s = 60
throws = 16
with = "ball"
hands_off = true""")

heading("where the tour takes its images")
for name, position, target, extra in [
    ("arrival", (0.9, 1.75, 9.4), (0.5, 2.9, -3), ""),
    ("swing_ride", (1.6, 1.5, 2.6), (-4.0, 3.6, -4.6), ""),
    ("gallery", (5.6, 1.75, 2.4), (6.5, 1.5, -4), ""),
    ("tents", (-4.5, 1.7, 8.5), (-11, 1.9, 0), ""),
    ("from_above", (10.5, 8.5, 13.0), (-2.0, 1.2, -3.0), ""),
]:
    put(f'\n[[view]]\nname = "{name}"\nposition_m = {vec(*position)}\ntarget_m = {vec(*target)}\n{extra}'.rstrip())

heading("colours")
for name, color, more in [
    ("stripe", (0.42, 0.025, 0.03), "two_sided = true\nroughness = 0.75\nsurface = \"plank\""),
    ("stripe_blue", (0.03, 0.09, 0.3), "two_sided = true\nroughness = 0.75\nsurface = \"soft\""),
    ("cream", (0.62, 0.54, 0.38), "two_sided = true\nroughness = 0.75\nsurface = \"plank\""),
    ("gold", (0.7, 0.45, 0.13), "roughness = 0.4\nmetallic = 0.5\nsurface = \"metal\""),
    ("seat", (0.75, 0.33, 0.05), "roughness = 0.5\nsurface = \"plank\""),
    ("pennant", (0.6, 0.35, 0.05), "two_sided = true\nroughness = 0.8\nsurface = \"soft\""),
    ("boards", (0.3, 0.17, 0.1), "base_color_map = \"textures/wood_base.jpg\"\nnormal_map = \"textures/wood_normal.jpg\"\nroughness = 0.8\nsurface = \"wood\""),
    ("lit_glass", (0.6, 0.4, 0.2), "emissive = [0.75, 0.42, 0.14]\nsurface = \"glass\""),
    ("balloon_red", (0.62, 0.03, 0.04), "roughness = 0.25\nsurface = \"rubber\""),
    ("balloon_yellow", (0.75, 0.45, 0.04), "roughness = 0.25\nsurface = \"rubber\""),
    ("balloon_blue", (0.04, 0.16, 0.55), "roughness = 0.25\nsurface = \"rubber\""),
    ("bulb_warm", (0, 0, 0), "emissive = [5, 2.5, 0.7]\nsurface = \"glass\""),
    ("bulb_red", (0, 0, 0), "emissive = [5, 0.35, 0.2]\nsurface = \"glass\""),
    ("bulb_green", (0, 0, 0), "emissive = [0.4, 3.4, 0.6]\nsurface = \"glass\""),
    ("bulb_blue", (0, 0, 0), "emissive = [0.4, 1.2, 5.5]\nsurface = \"glass\""),
]:
    put(f'\n[[material]]\nname = "{name}"\nbase_color = {vec(*color)}\n{more}')

lamps = 0


def lamp(place, color, intensity, radius, shadow=False):
    global lamps
    lamps += 1
    entity(f"lamp_{lamps}", place, light=f'{{ kind = "point", color = {vec(*color)}, intensity = {intensity}, radius_m = {radius}{", shadow = true" if shadow else ""} }}')


def model(name, piece, place, yaw_deg=0, parts=None, **keys):
    """Something that does not move; without parts nothing meets it."""
    entity(name, place, model=f'"models/{piece}.glb"', rotation_deg=vec(0, yaw_deg, 0), **keys,
           **({"body": ['kind = "static"', compound(parts)]} if parts else {}))


heading("ground")
entity("meadow", (0, -0.02, 0), primitive="{ plane = [120, 120] }", material='"grass"', casts_shadow="false", body=['kind = "static"', "friction = 0.8"])
entity("yard", (0, 0, 1), primitive="{ box = [25, 0.05, 27] }", material='"gravel"', casts_shadow="false", body=['kind = "static"', "friction = 0.8"])
for side in ("south", "east", "north", "west"):
    entity(f"land_{side}", (0, -0.02, 0), model=f'"models/land_{side}.glb"', casts_shadow="false")

heading("swing ride: the chairs start as they hang at its speed")


def swing_ride():
    radius, height = fair.PLATFORM
    _, low, high = (*fair.RIDE_DRUM[:1], *fair.RIDE_DRUM[1:])
    model("ride_base", "ride_base", RIDE, parts=[f"{{ cylinder = [{radius}, {height}], position_m = [0, {height / 2}, 0] }}",
                                                 f"{{ cylinder = [{fair.MAST[0]}, {fair.MAST[1]}], position_m = [0, {fair.MAST[1] / 2}, 0] }}"])
    rim, rim_y, _ = fair.CANOPY
    entity("ride_crown", RIDE, label='"swing ride"', model='"models/ride_crown.glb"', casts_shadow="false",
           body=[compound([f"{{ cylinder = [{fair.RIDE_DRUM[0]}, {high - low:.3f}], position_m = [0, {(high + low) / 2:.3f}, 0] }}",
                           f"{{ cylinder = [{rim}, 0.1], position_m = [0, {rim_y + 0.05}, 0] }}"]),
                 "mass_kg = 500", f"angular_velocity_radps = {vec(0, fair.RIDE_SPEED, 0)}"])
    put('\n[[joint]]\nname = "ride_axle"\nkind = "hinge"\na = "ride_crown"\nb = "ride_base"')
    put(f"anchor_m = {vec(RIDE[0], fair.RIDE_ARM_Y, RIDE[2])}\naxis = [0, 1, 0]\nmotor = {{ target = {fair.RIDE_SPEED}, max = 1500 }}\ncreak = 0.5")
    prefab("ride_chair", ['model = "models/ride_chair.glb"', "[prefab.body]", compound(box(c, s) for _, c, s in fair.CHAIR),
                          f"mass_kg = {fair.CHAIR_MASS}", "friction = 0.9"], "chair of the swing ride")
    lean = math.degrees(fair.chair_angle())
    for k in range(fair.RIDE_CHAIRS):
        turn = 360 * k / fair.RIDE_CHAIRS
        hook = at(RIDE, turn, (0, fair.RIDE_ARM_Y, fair.RIDE_RADIUS))
        onward = at((0, 0, 0), turn, (1, 0, 0))
        entity(f"ride_chair_{k + 1}", hook, prefab='"ride_chair"', rotation_deg=turned(turn + 90, -lean),
               body=[f"velocity_mps = {vec(*(fair.RIDE_SPEED * fair.RIDE_RADIUS * v for v in onward))}", f"angular_velocity_radps = {vec(0, fair.RIDE_SPEED, 0)}"])
        put(f'\n[[joint]]\nname = "ride_chain_{k + 1}"\nkind = "hinge"\na = "ride_chair_{k + 1}"\nb = "ride_crown"\nanchor_m = {vec(*hook)}\naxis = {vec(*onward)}\nmotor = {{ target = 0, max = 3 }}')
    for k in range(3):
        lamp(at(RIDE, 20 + 120 * k, (0, 3.7, 2.2)), WARM, 24, 8, shadow=True)
    lamp((RIDE[0] + 0.8, fair.CANOPY[1] + 1.1, RIDE[2] + 3.3), WARM, 8, 4.5)
    prefab("ring_post", ["primitive = { cylinder = [0.035, 1] }", 'material = "gold"', "[prefab.body]", 'kind = "static"'])
    prefab("ring_rail", ["primitive = { box = [0.03, 0.03, 1.95] }", 'material = "cream"', "[prefab.body]", 'kind = "static"',
                         "shape = { box = [0.03, 0.5, 1.95] }"])
    for k in range(20):
        turn = 18 * k
        entity(f"ring_post_{k + 1}", at(RIDE, turn - 9, (6.2, 0.5, 0)), prefab='"ring_post"')
        if k not in (6, 16):                        # ways in
            entity(f"ring_rail_{k + 1}", at(RIDE, turn, (6.12, 0.92, 0)), prefab='"ring_rail"', rotation_deg=vec(0, turn, 0))


swing_ride()

heading("shooting gallery")


def gallery():
    parts = [box(c, s) for _, c, s in fair.GALLERY]
    parts.append(box((0, fair.GALLERY_Y + 0.38, 0.2), (fair.GALLERY_X + 0.4, 0.06, fair.GALLERY_Z + 0.9), (-9, 0, 0)))
    model("gallery", "gallery", GALLERY, parts=parts)
    leaf = fair.TARGET_STEM + fair.TARGET_RADIUS
    r = fair.TARGET_RADIUS
    prefab("target", ['model = "models/target.glb"', "[prefab.body]",
                      f"shape = {{ compound = [{{ cylinder = [{r}, 0.024], rotation_deg = [90, 0, 0] }}, {box((0, fair.TARGET_STEM / 2 - leaf, 0), (0.05, fair.TARGET_STEM, 0.02))}] }}",
                      "mass_kg = 1.5", "angular_damping_per_s = 0.6"], "target")
    for i, x in enumerate(fair.TARGET_X):
        place = at(GALLERY, 0, (x, fair.TARGET_Y, fair.TARGET_Z))
        entity(f"target.{i + 1}", at(place, 0, (0, leaf, 0)), prefab='"target"')
        put(f'\n[[joint]]\nname = "target_{i + 1}_hinge"\nkind = "hinge"\na = "target.{i + 1}"\nb = "gallery"\nanchor_m = {vec(*place)}\naxis = [1, 0, 0]\nlimits = [-105, 0]\nmotor = {{ target = 0, max = 0.4 }}\ncreak = 0.25')
    prefab("tin", ['model = "models/fair_tin.glb"', "[prefab.body]", f"shape = {{ cylinder = [{fair.TIN[0]}, {fair.TIN[1]}] }}", "mass_kg = 0.25", "friction = 0.6",
                   "restitution = 0.1", "rolling_friction = 0.004"], "tin")
    (low, low_z), (high, high_z) = fair.SHELVES
    tins = [(x, low + fair.TIN[1] / 2, low_z) for x in (-1.2, 0.0, 1.2)] + [(x, high + fair.TIN[1] / 2, high_z) for x in (0.51, 0.69)]
    tins.append((0.6, high + 1.5 * fair.TIN[1], high_z))
    for i, place in enumerate(tins):
        entity(f"tin.{i + 1}", at(GALLERY, 0, place), prefab='"tin"')
    for x in (-1.5, 1.5):
        lamp(at(GALLERY, 0, (x, 2.7, 0.2)), WARM, 13, 5, shadow=True)
    lamp(at(GALLERY, 0, (0, 3.2, 4.3)), WARM, 6, 5)


gallery()

heading("tents, kiosk, entrance")
WALL = [box((fair.TENT[0] * math.sin(a), fair.TENT[1] / 2, fair.TENT[0] * math.cos(a)), (1.0, fair.TENT[1], 0.06), (0, math.degrees(a), 0))
        for a in (2 * math.pi * (k + 0.5) / 16 for k in range(1, 15))]
for name, piece, place, turn, light in [
    ("tent_1", "fair_tent", (-9.6, 0, 5.2), 70, WARM), ("tent_2", "fair_tent_blue", (10.6, 0, 6.6), -80, BLUE),
    ("tent_3", "fair_tent_blue", (-9.2, 0, -9.0), 35, WARM), ("tent_4", "fair_tent", (2.0, 0, -9.6), -5, WARM),
]:
    model(name, piece, place, turn, WALL)
    lamp((place[0], 1.9, place[2]), light, 12, 3.8)
radius, wall = fair.KIOSK
model("kiosk", "kiosk", (8.0, 0, 5.6), 20, [prism(radius, 0, wall + 0.5)])
lamp((7.0, 2.3, 6.9), WARM, 6, 4.5, shadow=True)
model("entrance", "fair_entrance", (0, 0, 15.2), 180, [box((side * 2.1, 1.75, 0), (0.35, 3.5, 0.35)) for side in (-1, 1)] + [box((0, 3.75, 0), (4.9, 1.1, 0.16))])
lamp((0, 3.2, 14.2), WARM, 6, 5, shadow=True)

heading("strings of lamps from pole to pole")
POLES = [(-3.4, 11.2), (3.6, 11.2), (-4.4, 3.6), (2.6, 3.8), (10.6, 2.0), (11.4, 11.0), (-11.0, 10.6), (-11.6, -1.5), (2.4, -5.2)]
for i, (x, z) in enumerate(POLES):
    model(f"pole_{i + 1}", "fair_pole", (x, 0, z), parts=[f"{{ cylinder = [0.07, {fair.POLE_Y}], position_m = [0, {fair.POLE_Y / 2}, 0] }}"])
TOPS = [(x, fair.POLE_Y + 0.05, z) for x, z in POLES]
GATE = [(-2.1, 3.5, 15.2), (2.1, 3.5, 15.2)]
STRINGS = [(GATE[0], TOPS[0]), (GATE[1], TOPS[1]), (TOPS[0], TOPS[1]), (TOPS[0], TOPS[2]), (TOPS[1], TOPS[3]), (TOPS[2], TOPS[3]), (TOPS[3], TOPS[4]), (TOPS[1], TOPS[5]),
           (TOPS[0], TOPS[6]), (TOPS[2], TOPS[7]), (TOPS[3], TOPS[8]), (TOPS[1], TOPS[2])]
for i, (a, b) in enumerate(STRINGS):
    run = [q - p for p, q in zip(a, b)]
    length = math.dist(a, b)
    yaw, roll = math.degrees(math.atan2(-run[2], run[0])), math.degrees(math.asin(run[1] / length))
    stretch = length / fair.STRING
    entity(f"string_{i + 1}", a, model='"models/light_string.glb"', rotation_deg=turned(yaw, roll), scale=vec(stretch, 1, 1), casts_shadow="false")
    middle = [p + 0.5 * w - (fair.STRING_SAG + 0.25 if j == 1 else 0) for j, (p, w) in enumerate(zip(a, run))]
    lamp(middle, {3: ROSE, 8: BLUE, 9: ROSE}.get(i, WARM), 17, 6.5, shadow=True)

heading("fence, benches, and things lying about")
prefab("fence_board", ["primitive = { box = [2.4, 0.12, 0.04] }", 'material = "cream"', "casts_shadow = false"])
prefab("fence_post", ["primitive = { box = [0.12, 1.15, 0.12] }", 'material = "stripe"', "casts_shadow = false"])
for name, x0, z in [("back", -12, -12.4), ("front_left", -12, 15.2), ("front_right", 2.4, 15.2)]:
    count = 10 if name == "back" else 4
    array(f"fence_{name}_posts", "fence_post", (x0, 0.55, z), (count + 1, 1, 1), (2.4, 1, 1))
    array(f"fence_{name}_boards", "fence_board", (x0 + 1.2, 0.45, z), (count, 2, 1), (2.4, 0.45, 1))
    entity(f"fence_{name}", (x0 + 1.2 * count, 0.6, z), body=['kind = "static"', f"shape = {{ box = [{2.4 * count:.1f}, 1.2, 0.12] }}"])
for name, x in [("west", -12.4), ("east", 12.4)]:
    array(f"fence_{name}_posts", "fence_post", (x, 0.55, -12.4), (1, 1, 13), (1, 1, 2.3))
    entity(f"fence_{name}", (x, 0.6, 1.4), primitive="{ box = [0.05, 0.5, 27.6] }", material='"cream"', casts_shadow="false", body=['kind = "static"', "shape = { box = [0.12, 1.2, 27.6] }"])
for i, (x, z, turn) in enumerate([(4.6, 3.6, 200), (-6.4, 7.6, 140), (7.4, 8.8, 250)]):
    entity(f"bench_{i + 1}", (x, 0.025, z), label='"garden bench"', model='"models/garden_bench.glb"', rotation_deg=vec(0, turn, 0),
           body=[compound([box((0, 0.435, -0.0175), (1.5, 0.03, 0.37)), box((0, 0.68, -0.225), (1.5, 0.325, 0.03))] +
                          [box((x0, 0.21, z0), (0.05, 0.42, 0.05)) for x0 in (-0.66, 0.66) for z0 in (0.13, -0.215)]), "mass_kg = 32", "friction = 0.6"])
for i, (kind, x, y, z, turn) in enumerate([("crate", 9.6, 0.432, -5.6, 10), ("crate", 10.5, 0.432, -5.2, -14), ("crate", 10.0, 1.247, -5.4, 33), ("barrel", 9.6, 0.025, -4.4, 0),
                                           ("crate", -10.4, 0.432, 5.0, 50), ("barrel", -9.9, 0.025, 4.2, 0), ("crate", 1.3, 0.432, -10.4, 15), ("crate", 2.5, 0.432, -10.5, -8),
                                           ("barrel", 9.4, 0.025, 5.2, 40), ("crate", -6.9, 0.432, 11.6, 24), ("barrel", -7.9, 0.025, 11.2, 0)]):
    entity(f"{kind}_{i + 1}", (x, y, z), prefab=f'"{kind}"', rotation_deg=f"[0, {turn}, 0]")
for i in range(4):
    entity(f"ball_{i + 1}", at(GALLERY, 0, (-1.2 + 0.8 * i, fair.COUNTER_Y + 0.12, fair.COUNTER_Z)), prefab='"ball"')

heading("balloons: 110 g of air lift 55 g of rubber and helium, and a cord; each hangs from a weight that one can carry, or cut")
for color, x, z, length in [("red", -2.9, 10.4, 1.7), ("yellow", -2.2, 10.0, 1.45), ("blue", -1.6, 10.6, 1.9)]:
    top = 0.08 + length + BALLOON
    entity(f"balloon_{color}", (x, top, z), label=f'"{color} balloon"', primitive=f"{{ sphere = {BALLOON} }}", material=f'"balloon_{color}"',
           body=["mass_kg = 0.055", "restitution = 0.6", "drag = { buoyant = true }"])
    entity(f"weight_{color}", (x, 0.05, z), label='"weight of a balloon"', primitive="{ cylinder = [0.05, 0.05] }", material='"gold"', body=["mass_kg = 0.4"])
    put(f'\n[[rope]]\nname = "cord_{color}"\na = "balloon_{color}"\nb = "weight_{color}"')
    put(f"anchor_a_m = {vec(x, top - BALLOON, z)}\nanchor_b_m = {vec(x, 0.075, z)}")
    put('pieces = 10\nmass_kg = 0.012\nradius_m = 0.004\nmaterial = "rope"')

print("\n".join(out))
