#!/usr/bin/env python3
"""Writes assets/scenes/garden.toml: where every post, bed and flower of the garden stands.

    python3 assets/source/make_garden.py > assets/scenes/garden.toml

Metres, +Y up. The house looks down +Z to the fountain (house_plan.py has its measures); the gate is in the front fence at +Z.
Same script, same file: positions come from a seeded generator.
"""
import math
import random

import garden_things
import house_plan as plan
from scene_writer import array, box, compound, entity, heading, hinge, out, prefab, prism, put, vec

rng = random.Random(20)
WIND = (1, 0, -0.35)  # as [wind] has it
HALF_X, BACK_Z, FRONT_Z = 15.0, -13.0, 17.0

put("""# The garden: a house, trees, flower beds, a fountain, and things lying about to play with.
# Written by assets/source/make_garden.py: change that and run it again.

[scene]
title = "The garden"
description = "A house, trees, flowers and a fountain on a summer afternoon"
include = ["materials.toml", "things.toml"]

[world]
kill_below_m = -20

[player]
position_m = [1.2, 0, 13.2]
yaw_deg = 8

[camera]
position_m = [6.2, 2.3, 11.5]
target_m = [-0.4, 1.35, 0]
fov_deg = 55

[sun]
color = [1, 1, 1]
intensity = 4.6
shadow = { cascades = 2, size_px = 2048, distance_m = 150, angular_size_deg = 0.53 }
shafts = { density_per_m = 0.0025 }

[ambient]
occlusion = { radius_m = 0.45 }
indirect = { min_m = [-3.38, 0.12, -8.78], max_m = [3.38, 2.62, -3.62], spacing_m = 0.45, gain = 4 }

# South of the equator, the house looking north-west: the afternoon's sun and the evening's shine on
# its front.
[time]
hour = 16
latitude_deg = -38
day_of_year = 45
north_deg = 138

[sky]
model = "atmosphere"
haze = 1.5
visibility_m = 2200
cloud_map = "skies/clouds"

[flashlight]

[wind]
direction = [1, 0, -0.35]
speed_mps = 3.5
gusts = 0.6
sound = { file = "sounds/loop_wind.ogg", gain = 0.12 }

[sound]
paths = true
reverb = true

[grass]
on = ["lawn"]
height_m = 0.12
density_perm2 = 24

[post]
exposure = 1.5
adapts = true""")

heading("where the tour takes its images")
for name, position, target, extra in [
    ("arrival", (1.6, 1.7, 14.0), (0, 1.5, 0), ""),
    ("fountain", (3.9, 1.5, 7.0), (-0.6, 1.0, 2.2), "wait_s = 1.0\n"),
    ("house", (-4.2, 1.7, 1.4), (-1.2, 1.6, -4.0), ""),
    ("living_room", (-2.6, 1.7, -4.3), (-1.2, 1.0, -7.6), ""),
    ("bedroom", (2.4, 1.7, -3.9), (1.9, 0.8, -8.6), ""),
    ("living_room_with_flashlight", (0.3, 1.7, -6.4), (-2.6, 1.0, -6.9), "flashlight = true\nlight_scale = 0.03\n"),
    ("flower_bed", (-4.6, 0.75, -0.6), (-1.8, 0.55, -2.7), ""),
    ("crates", (8.6, 1.6, 6.4), (6.1, 0.7, 2.3), ""),
    ("from_above", (13.5, 9.5, 15.0), (-1.0, 0.2, -1.5), ""),
    ("horizon", (12.5, 1.7, 12.0), (-40, 4.0, -30), ""),
    ("noon", (7.5, 2.2, 9.5), (-1.5, 1.2, 0), "hour = 12.5\n"),
    ("golden_hour", (6.2, 2.3, 11.5), (-0.4, 1.35, 0), "hour = 18.1\n"),
    ("dusk", (-5.5, 1.7, 1.0), (4.0, 1.9, 4.8), "hour = 18.8\n"),
    ("night_with_flashlight", (5.2, 1.7, 10.2), (-0.2, 1.5, 0), "hour = 21.5\nflashlight = true\n"),
    ("shed_with_flashlight", (-10.9, 1.6, -5.3), (-11.7, 0.85, -9.2), "flashlight = true\nlight_scale = 0.06\n"),
]:
    put(f'\n[[view]]\nname = "{name}"\nposition_m = {vec(*position)}\ntarget_m = {vec(*target)}\n{extra}'.rstrip())

heading("ground")
entity("lawn", (0, 0, 0), primitive="{ plane = [120, 120] }", material='"grass"', casts_shadow="false",
       body=['kind = "static"', "friction = 0.8"])
for side in ("south", "east", "north", "west"):
    entity(f"land_{side}", (0, 0, 0), model=f'"models/land_{side}.glb"', casts_shadow="false", body=['kind = "static"', 'shape = { mesh = "model" }'])
entity("plaza", (0, 0, 3.2), primitive="{ cylinder = [3.5, 0.06] }", material='"flagstone"',
       body=['kind = "static"', "friction = 0.7"])
for name, z0, z1 in [("path_to_gate", 6.4, 17.6), ("path_to_door", -2.4, 0.2)]:
    entity(name, (0, 0, (z0 + z1) / 2), primitive=f"{{ box = [1.7, 0.05, {z1 - z0:.2f}] }}", material='"flagstone"',
           body=['kind = "static"', "friction = 0.7"])
entity("path_round_house", (5.3, 0, -3.2), primitive="{ box = [7.2, 0.04, 1.1] }", material='"gravel"',
       body=['kind = "static"', "friction = 0.7"])

heading("the house: walls are boxes, the floor a body of its own")
HOUSE = (0, 0, -6.2)


def in_house(x, y, z):
    return (HOUSE[0] + x, HOUSE[1] + y, HOUSE[2] + z)


def solids(name):
    """The boards of a piece of furniture that other things feel."""
    return compound(box(c, s) for _, c, s in plan.BOXES[name] if min(s) >= 0.025 or name == "shelf")


HX, HZ, RISE = plan.HX, plan.HZ, plan.RIDGE - plan.EAVES
parts = [box(c, s) for wall in plan.OUTER + plan.INNER for c, s in wall.boxes()]
for wall in plan.OUTER:
    parts += [box(*wall.box(*hole, plan.GLASS_DEPTH - 0.015, plan.GLASS_DEPTH + 0.015)) for hole in wall.windows()]
u0, u1, y0, y1 = plan.OUTER[0].holes[2]
for a, b, low in ((u0, u0 + plan.DOOR_FRAME, y0), (u1 - plan.DOOR_FRAME, u1, y0), (u0, u1, y1 - plan.DOOR_FRAME)):
    parts.append(box(*plan.OUTER[0].box(a, b, low, y1, 0.07, 0.17)))
corners = [(x, y, z) for x in (-HX, HX) for y, z in ((plan.CEILING, -HZ), (plan.CEILING, HZ), (plan.EAVES, -HZ), (plan.EAVES, HZ), (plan.RIDGE, 0))]
parts.append("{ hull_m = [" + ", ".join(vec(*c) for c in corners) + "] }")
slope = math.atan2(RISE, HZ)
length = (HZ + plan.ROOF_OVER_EAVES) / math.cos(slope)
for side in (-1, 1):
    half, lift = length / 2, plan.ROOF_THICK / 2
    centre = (0, plan.RIDGE - half * math.sin(slope) + lift * math.cos(slope), side * (half * math.cos(slope) + lift * math.sin(slope)))
    parts.append(box(centre, (2 * (HX + plan.ROOF_OVER_GABLE), plan.ROOF_THICK, length), (side * math.degrees(slope), 0, 0)))
x, z = plan.CHIMNEY
parts += [box((x, plan.RIDGE, z), (0.62, 2, 0.62)), box(*plan.STEP)]
entity("house", HOUSE, model='"models/house.glb"', body=['kind = "static"', compound(parts), "friction = 0.7"])
entity("house_floor", in_house(0, plan.FLOOR / 2 - 0.15, 0), material='"vcol_floor"',
       body=['kind = "static"', f"shape = {{ box = {vec(2 * HX, plan.FLOOR + 0.3, 2 * HZ)} }}", "friction = 0.7"])

heading("doors and shutters on hinges; a little friction holds them where they were left")
w, h, t = plan.DOOR_LEAF
place = in_house(-w / 2 - 0.001, plan.FLOOR + 0.006, HZ - 0.12)
entity("front_door", place, model='"models/door.glb"',
       label='"front door"',
       body=[compound([box((w / 2, h / 2, 0), (w, h, t))]), "mass_kg = 28", "angular_damping_per_s = 0.8"])
hinge("front_door", "house", place, (-95, 95), 2, creak=0.4)
w, h, t = plan.ROOM_DOOR_LEAF
place = in_house(plan.HALL_X, plan.FLOOR + 0.012, plan.ROOM_DOOR_Z + w / 2 + 0.005)
entity("bedroom_door", place, model='"models/room_door.glb"', rotation_deg="[0, 30, 0]",
       label='"bedroom door"',
       body=[compound([box((w / 2, h / 2, 0), (w, h, t))]), "mass_kg = 18", "angular_damping_per_s = 0.8"])
hinge("bedroom_door", "house", place, (-35, 150), 1.5, creak=0.4)
w, h, t = plan.SHUTTER
prefab("shutter", ['model = "models/shutter.glb"', "[prefab.body]", compound([box((w / 2, 0, 0.025), (w, h, 0.045))]),
                   "mass_kg = 6", "angular_damping_per_s = 0.8"], "window shutter")
for wall in plan.OUTER:
    for i, hole in enumerate(wall.windows()):
        for side, u, turn, limits in (("left", hole[0] - 0.03, 180, (0, 172)), ("right", hole[1] + 0.03, 0, (-172, 0))):
            name = f"shutter_{wall.name}_{i + 1}_{side}"
            place = in_house(*wall.place(u, (hole[2] + hole[3]) / 2, -0.012))
            yaw = -wall.yaw_deg if turn else wall.yaw_deg
            entity(name, place, prefab='"shutter"', rotation_deg=f"[0, {yaw}, {turn}]")
            hinge(name, "house", place, limits, 0.4, creak=0.3)

heading("furniture")
PIECES = {"chair": ("kitchen chair", 5), "table": ("dining table", 24), "desk": ("desk", 18), "stool": ("stool", 4),
          "bench": ("oak bench", 11), "shelf": ("bookshelf", 32), "bed": ("bed", 45), "chest": ("wooden chest", 22)}
for name, (label, mass) in PIECES.items():
    prefab(name, [f'model = "models/furniture_{name}.glb"', "[prefab.body]", solids(name), f"mass_kg = {mass}", "friction = 0.5"], label)
for i, (name, x, z, turn) in enumerate([
    ("table", -1.15, -1.3, 0), ("chair", -1.5, -1.9, 4), ("chair", -0.82, -1.92, -7), ("chair", -1.47, -0.68, 176), ("chair", -0.75, -0.62, 160),
    ("shelf", -1.07, 1.25, -90), ("bench", -3.14, 0.05, 90), ("bench", -0.6, 0.72, 90), ("bed", 2.85, -1.5, 0), ("stool", 2.08, -2.3, 0),
    ("chest", 2.86, -0.1, 0), ("desk", 2.35, 2.25, 180), ("chair", 2.3, 1.72, 170),
]):
    entity(f"{name}_{i + 1}" if name in ("chair", "bench") else name, in_house(x, plan.FLOOR, z), prefab=f'"{name}"', rotation_deg=f"[0, {turn}, 0]")
entity("counter", in_house(-2.38, plan.FLOOR, 2.26), model='"models/furniture_counter.glb"', body=['kind = "static"', compound([box((0, 0.44, 0), (1.86, 0.88, 0.6))])])
entity("stove", in_house(*plan.CHIMNEY[:1], plan.FLOOR, plan.CHIMNEY[1]), model='"models/furniture_stove.glb"', rotation_deg="[0, 90, 0]",
       light='{ kind = "point", color = [1, 0.42, 0.14], intensity = 1.4, radius_m = 3.4, offset_m = [0, 0.34, 0.34], on = false }',
       body=['kind = "static"', compound([box((0, 0.4, 0), (0.56, 0.8, 0.48)), "{ cylinder = [0.075, 1.7], position_m = [0, 1.65, -0.06] }"])])
entity("rug", in_house(1.85, plan.FLOOR + 0.004, 0.35), primitive="{ box = [1.1, 0.008, 1.7] }", material='"cloth"', casts_shadow="false")
prefab("pot", ['model = "models/pot.glb"', "[prefab.body]", compound([box((0, 0.07, 0), (0.16, 0.14, 0.16)), prism(0.132, 0.14, 0.205)]), "mass_kg = 1.8", "restitution = 0.1"], "clay pot")
prefab("vase", ['model = "models/vase.glb"', "[prefab.body]",
                compound([box((0, 0.08, 0), (0.1, 0.16, 0.1)), prism(0.042, 0.16, 0.26)]), "mass_kg = 0.8", "restitution = 0.1"], "blue vase")
prefab("mug", ['model = "models/mug.glb"', "[prefab.body]", compound([box((0, 0.045, 0), (0.066, 0.09, 0.066))]), "mass_kg = 0.3"], "mug")
prefab("pillow", ["primitive = { box = [0.6, 0.1, 0.36] }", 'material = "linen"', "[prefab.body]", "mass_kg = 0.8", "friction = 0.8"], "pillow")
BOOK = (0.034, 0.21, 0.15)
for color in ("red", "blue", "green"):
    prefab(f"book_{color}", [f"primitive = {{ box = {vec(*BOOK)} }}", f'material = "book_{color}"', "[prefab.body]", "mass_kg = 0.6", "friction = 0.5"], f"{color} book")
table_top, counter_top, desk_top, chest_top, stool_top, bed_top = 0.7525, 0.88, 0.74, 0.46, 0.45, 0.50
for i, (name, x, y, z, turn) in enumerate([
    ("vase", -1.1, table_top, -1.25, 0), ("mug", -1.5, table_top, -1.5, 40), ("mug", -0.8, table_top, -1.08, 200),
    ("pot", -2.9, counter_top, 2.3, 0), ("pot", -2.55, counter_top, 2.35, 0), ("mug", -1.7, counter_top, 2.2, 90),
    ("vase", 2.7, chest_top, -0.08, 0), ("pot", -1.078, plan.SHELF_LEVELS[3], 1.5, 0), ("vase", -1.04, plan.SHELF_LEVELS[2], 0.97, 0),
]):
    entity(f"{name}_{i + 1}", in_house(x, plan.FLOOR + y, z), prefab=f'"{name}"', rotation_deg=f"[0, {turn}, 0]")
entity("pillow", in_house(2.85, plan.FLOOR + bed_top + 0.05, -2.22), prefab='"pillow"')
books = 0


def book(color, x, y, z, turn=(0, 0, 0)):
    global books
    books += 1
    entity(f"book_{books}", in_house(x, plan.FLOOR + y, z), prefab=f'"book_{color}"', rotation_deg=vec(*turn))


for level, first, count in ((1, 0.9, 6), (2, 1.34, 5)):
    for i in range(count):
        book(("red", "blue", "green")[(i + level) % 3], -1.04, plan.SHELF_LEVELS[level] + BOOK[1] / 2, first + 0.036 * i, (0, 90, 0))
for i, color in enumerate(("blue", "red", "green")):
    book(color, 2.6, desk_top + BOOK[0] * (i + 0.5), 2.3, (0, 0, 90))

heading("lamps")
GLOW = "color = [1, 0.72, 0.42]"
entity("pendant_lamp", in_house(-1.15, plan.CEILING - 0.6, -1.3), model='"models/lamp_pendant.glb"', casts_shadow="false",
       label='"hanging lamp"',
       light=f'{{ kind = "point", {GLOW}, intensity = 3.2, radius_m = 4.5, shadow = true, on = "dark" }}',
       body=["shape = { compound = [{ cylinder = [0.2, 0.2], position_m = [0, 0.04, 0] }] }", "mass_kg = 1.5", "angular_damping_per_s = 0.8"])
put(f'\n[[joint]]\nname = "pendant_cord"\nkind = "ball_and_socket"\na = "pendant_lamp"\nb = "house"\nanchor_m = {vec(*in_house(-1.15, plan.CEILING, -1.3))}')
# What comes back from ceiling and walls, else shadows would be black.
entity("pendant_glow", in_house(-1.15, plan.CEILING - 0.08, -1.3), light=f'{{ kind = "point", {GLOW}, intensity = 0.9, radius_m = 3.6, on = "dark" }}')
entity("bedside_glow", in_house(1.3, plan.CEILING - 0.3, -1.0), light=f'{{ kind = "point", {GLOW}, intensity = 0.45, radius_m = 3.6, on = "dark" }}')
entity("bedside_lamp", in_house(2.08, plan.FLOOR + stool_top, -2.3), model='"models/lamp_table.glb"', casts_shadow="false",
       label='"bedside lamp"',
       light=f'{{ kind = "point", {GLOW}, intensity = 1.6, radius_m = 3.2, offset_m = [0, 0.26, 0], shadow = true, on = "dark" }}',
       body=[compound([box((0, 0.015, 0), (0.13, 0.03, 0.13)), prism(0.03, 0.03, 0.2), prism(0.1, 0.2, 0.36)]), "mass_kg = 1.2"])

heading("lamps of the garden: they come on when the sun is low")
prefab("garden_lamp", ["primitive = { sphere = 0.1 }", 'material = "lamp_bulb"', "casts_shadow = false",
                       # Above its globe, or its post would hide the ground.
                       f'light = {{ kind = "point", {GLOW}, intensity = 3, radius_m = 6.5, offset_m = [0, 0.3, 0], shadow = true, on = "dark" }}'], "garden lamp")
prefab("garden_lamp_post", ["primitive = { cylinder = [0.035, 2.1] }", 'material = "iron"', "[prefab.body]", 'kind = "static"'], "lamp post")
for i, (x, z) in enumerate([(1.35, 15.6), (-3.0, 6.6), (3.9, 1.2), (-6.4, -1.4)]):
    entity(f"garden_lamp_post_{i + 1}", (x, 1.05, z), prefab='"garden_lamp_post"')
    entity(f"garden_lamp_{i + 1}", (x, 2.18, z), prefab='"garden_lamp"')
x, y, z = in_house(0.72, plan.FLOOR + 2.02, HZ + 0.2)
entity("door_lamp_arm", (x, y + 0.1, z - 0.06), primitive="{ box = [0.03, 0.03, 0.28] }", material='"iron"', casts_shadow="false")
entity("door_lamp", (x, y, z), prefab='"garden_lamp"', scale="[0.8, 0.8, 0.8]", light="{ intensity = 0.9 }")

heading("fountain")
parts = ["{ cylinder = [1.5, 0.18], position_m = [0, 0.09, 0] }"]
for i in range(8):
    turn = 22.5 + 45 * i
    x, z = 1.5 * math.sin(math.radians(turn)), 1.5 * math.cos(math.radians(turn))
    parts.append(f"{{ box = [1.4, 0.61, 0.29], position_m = {vec(x, 0.305, z)}, rotation_deg = [0, {turn}, 0] }}")
parts += ["{ cylinder = [0.22, 1.2], position_m = [0, 0.6, 0] }", "{ cylinder = [0.74, 0.16], position_m = [0, 1.4, 0] }",
          "{ cylinder = [0.11, 0.7], position_m = [0, 1.8, 0] }"]
entity("fountain", (0, 0.03, 3.2), model='"models/fountain.glb"',
       sound='{ file = "sounds/loop_fountain.ogg", loop = true, gain = 1.0, radius_m = 14, by_flow = true }',
       body=['kind = "static"', "friction = 0.6", "shape = { compound = [\n    " + ",\n    ".join(parts) + ",\n] }"])

heading("birds over the garden, butterflies over the beds")
for kind, count, center, radius, height in [("birds", 6, (2, 13, -6), 24, 6), ("butterflies", 4, (-2.4, 0.95, -2.4), 1.6, 0.7), ("butterflies", 4, (2.4, 0.95, 8.6), 1.8, 0.8)]:
    put(f'\n[[flock]]\nkind = "{kind}"\ncount = {count}\ncenter_m = {vec(*center)}\nradius_m = {radius}\nheight_m = {height}')

heading("a flag")
FLAG = (4.85, 0, -1.9)
entity("flagpole", FLAG, model='"models/flagpole.glb"', body=['kind = "static"', "shape = { compound = [{ cylinder = [0.05, 5.2], position_m = [0, 2.6, 0] }] }"])
DOWNWIND = math.degrees(math.atan2(-WIND[2], WIND[0]))


def cloth(name, size, center, turn, material, cells, pins, density=0.12, bend="2e-5", stretch=825, hangs=""):
    put(f'\n[[cloth]]\nname = "{name}"\nsize_m = {vec(*size)}\n{hangs}position_m = {vec(*center)}\nrotation_deg = {vec(0, turn, 0)}\n'
        f'cells = [{cells[0]}, {cells[1]}]\ndensity_kgpm2 = {density}\nstretch_Npm = {stretch * density:.0f}\nbend_Nm = {bend}\ndamping_s = 0.002\ndrag = 1.2\n'
        f'material = "{material}"\npins = [{", ".join(pins)}]')


# From the pole, along the wind.
reach = 0.04 + 0.75
cloth("flag", (1.5, 0.95), (FLAG[0] + reach * math.cos(math.radians(DOWNWIND)), 4.58, FLAG[2] - reach * math.sin(math.radians(DOWNWIND))),
      DOWNWIND, "flag", (14, 9), ['{ edge = "left", to = "flagpole" }'])

heading("washing on a line")
LINE, LINE_END, LINE_HIGH = (9.1, 0.2), (11.5, -2.8), 1.78
along = (LINE_END[0] - LINE[0], LINE_END[1] - LINE[1])
LINE_LONG, LINE_TURN = math.hypot(*along), math.degrees(math.atan2(-along[1], along[0]))
for i, (x, z) in enumerate([LINE, LINE_END]):
    entity(f"washing_post_{i + 1}", (x, 0.92, z), primitive="{ cylinder = [0.04, 1.84] }", material='"wood"', body=['kind = "static"'])
entity("washing_line", ((LINE[0] + LINE_END[0]) / 2, LINE_HIGH, (LINE[1] + LINE_END[1]) / 2), primitive=f"{{ cylinder = [0.006, {LINE_LONG:.3f}] }}",
       material='"rope"', rotation_deg=vec(90, 90 + LINE_TURN, 0))
for name, share, size, material, cells in [("sheet", 0.27, (1.2, 0.9), "linen", (10, 8)), ("towel", 0.57, (0.55, 0.8), "cloth", (6, 8)),
                                           ("cloth", 0.8, (0.6, 0.6), "curtain", (6, 6))]:
    cloth(f"washing_{name}", size, (LINE[0] + share * along[0], LINE_HIGH - size[1] / 2, LINE[1] + share * along[1]), LINE_TURN, material, cells,
          ["{ at = [0, 0] }", "{ at = [0.5, 0] }", "{ at = [1, 0] }"], density=0.6)  # wet

heading("curtains: no wind blows in the house")
put(f'\n[[wind_zone]]\nmin_m = {vec(*in_house(-plan.HX, plan.FLOOR, -plan.HZ))}\nmax_m = {vec(*in_house(plan.HX, plan.CEILING, plan.HZ))}\nwind_share = 0')
width, folds, gather, beside = plan.CURTAIN
for wall in plan.OUTER:
    for i, (u0, u1, y0, y1) in enumerate(wall.windows()):
        height = y1 - y0 + plan.CURTAIN_ROD - 0.01
        for side, u in (("left", u0 - beside + width / 2), ("right", u1 + beside - width / 2)):
            cloth(f"curtain_{wall.name}_{i + 1}_{side}", (width / gather, height),
                  in_house(*wall.place(u, y1 + plan.CURTAIN_ROD - height / 2, plan.CURTAIN_DEPTH)), wall.yaw_deg, "curtain", (2 * folds, 8),
                  ['{ edge = "top" }'], density=0.25, bend="1e-7", stretch=3300, hangs=f"folds = {folds}\ngather = {gather}\nasleep = true\n")

put(f'\n[[water]]\nname = "pool"\nbasin = "fountain"\nlevel_m = 0.5')

heading("its water: a jet into the upper bowl, and what runs over from bowl to bowl")
# Of the water's surface in the model: radius, height.
BOWLS = [(0.27, 1.87), (0.68, 1.485), (1.46, 0.47)]
pools = ", ".join(f"{{ center_m = {vec(0, 0.03 + y, 3.2)}, radius_m = {r} }}" for r, y in BOWLS)
for y, ring, speed, spread, flow, drop in [
    (2.23, None, 3.9, 2.5, 0.2, 10), (1.9, (0.335, 20), 0.3, 4, 0.13, 7), (1.53, (0.775, 40), 0.35, 3.5, 0.3, 7.5),
]:
    put(f"\n[[fountain]]\nposition_m = {vec(0, 0.03 + y, 3.2)}")
    if ring:
        put(f"ring = {{ radius_m = {ring[0]}, streams = {ring[1]} }}")
    put(f"speed_mps = {speed}\nspread_deg = {spread}\nflow_lps = {flow}\ndrop_mm = {drop}")
    if not ring:
        put(f"pools = [{pools}]")

heading("trees")
TRUNK = ['kind = "static"', "shape = { compound = [ { cylinder = [0.2, 3.4], position_m = [0, 1.7, 0] } ] }"]
TREES = [("oak", -9.5, 6.5, 1.0, 40), ("linden", 9.8, -6.5, 1.15, 120), ("linden", -7.2, -11.0, 1.1, 200),
         ("oak", 12.2, 10.5, 0.95, 300), ("oak", 5.5, -19.0, 1.2, 75), ("linden", 20.0, -13.0, 1.4, 260)]
for i, (kind, x, z, scale, turn) in enumerate(TREES):
    rustle = '{ file = "sounds/loop_leaves.ogg", loop = true, gain = 0.25, radius_m = 9, by_wind = true }'
    entity(f"tree_{i + 1}", (x, 0, z), model=f'"models/tree_{kind}.glb"', rotation_deg=f"[0, {turn}, 0]",
           scale=vec(scale, scale, scale), **({"sound": rustle} if i < 2 else {}), body=TRUNK)

heading("flower beds: a kerb of stone, soil, and what grows in it")
beds = 0


def bed(x0, x1, z0, z1, kinds, count):
    global beds
    beds += 1
    cx, cz, w, d = (x0 + x1) / 2, (z0 + z1) / 2, x1 - x0, z1 - z0
    entity(f"bed_{beds}", (cx, 0.05, cz), primitive=f"{{ box = [{w:.2f}, 0.14, {d:.2f}] }}", material='"soil"', body=['kind = "static"'])
    for side, (px, pz, sx, sz) in enumerate([(cx, z0, w + 0.16, 0.12), (cx, z1, w + 0.16, 0.12), (x0, cz, 0.12, d), (x1, cz, 0.12, d)]):
        entity(f"bed_{beds}_kerb_{side + 1}", (px, 0.08, pz), primitive=f"{{ box = [{sx:.2f}, 0.2, {sz:.2f}] }}", material='"stone"', body=['kind = "static"'])
    for i in range(count):
        kind = kinds[i % len(kinds)]
        t = (i + 0.5) / count
        x, z = (x0 + 0.3 + (w - 0.6) * t, cz + rng.uniform(-1, 1) * max(0, d / 2 - 0.3)) if w > d else (cx + rng.uniform(-1, 1) * max(0, w / 2 - 0.3), z0 + 0.3 + (d - 0.6) * t)
        s = rng.uniform(0.8, 1.1)
        entity(f"bed_{beds}_{kind}_{i + 1}", (x, 0.12, z), model=f'"models/flowers_{kind}.glb"', rotation_deg=f"[0, {rng.randrange(360)}, 0]", scale=vec(s, s, s), casts_shadow="false")


bed(-3.7, -0.95, -3.05, -2.15, ["lavender", "tulip", "daisy"], 6)
bed(0.95, 3.7, -3.05, -2.15, ["tulip", "lavender", "daisy"], 6)
bed(-5.6, -4.2, 1.2, 5.4, ["daisy", "lavender"], 7)
bed(-3.4, -1.25, 8.6, 9.5, ["tulip", "daisy"], 4)
bed(1.25, 3.4, 8.6, 9.5, ["tulip", "lavender"], 4)

heading("grass in tufts, thicker along edges")
tufts = 0
while tufts < 110:
    edge = rng.random()
    if edge < 0.5:
        angle = rng.uniform(0, 2 * math.pi)
        r = rng.uniform(3.5, 4.0)
        x, z = r * math.sin(angle), 3.2 + r * math.cos(angle)
    elif edge < 0.75:
        x, z = rng.choice([-1, 1]) * rng.uniform(0.9, 1.25), rng.uniform(6.8, 16)
    else:
        x, z = rng.uniform(-13.5, 13.5), rng.uniform(-11, 15.5)
    if abs(x) < 0.86 and (z > 6 or z < 0) or abs(x) < 4.3 and -9.6 < z < -2.0:
        continue
    tufts += 1
    s = rng.uniform(0.7, 1.3)
    entity(f"tuft_{tufts}", (x, 0, z), model='"models/grass_tuft.glb"', rotation_deg=f"[0, {rng.randrange(360)}, 0]", scale=vec(s, s, s), casts_shadow="false")

heading("fence")
prefab("fence_post", ["primitive = { box = [0.1, 1.25, 0.1] }", 'material = "wood"'])
prefab("fence_rail_x", ["primitive = { box = [2.0, 0.11, 0.035] }", 'material = "wood"'])
prefab("fence_rail_z", ["primitive = { box = [0.035, 0.11, 2.0] }", 'material = "wood"'])
for name, z in [("back", BACK_Z), ("front", FRONT_Z)]:
    gate = 1 if name == "front" else 0  # two metres of the front stay open
    for half, x0 in [("left", -HALF_X), ("right", 1.0)]:
        array(f"fence_{name}_{half}_posts", "fence_post", (x0, 0.6, z), (8, 1, 1), (2, 1, 1))
        array(f"fence_{name}_{half}_rails", "fence_rail_x", (x0 + 1, 0.5, z), (7, 2, 1), (2, 0.5, 1))
        entity(f"fence_{name}_{half}", (x0 + 7, 0.6, z), body=['kind = "static"', "shape = { box = [14, 1.3, 0.1] }"])
    if not gate:
        array("fence_back_middle_rails", "fence_rail_x", (0, 0.5, z), (1, 2, 1), (2, 0.5, 1))
        entity("fence_back_middle", (0, 0.6, z), body=['kind = "static"', "shape = { box = [2, 1.3, 0.1] }"])
for name, x in [("west", -HALF_X), ("east", HALF_X)]:
    array(f"fence_{name}_posts", "fence_post", (x, 0.6, BACK_Z + 2), (1, 1, 14), (1, 1, 2))
    array(f"fence_{name}_rails", "fence_rail_z", (x, 0.5, BACK_Z + 1), (1, 2, 15), (1, 0.5, 2))
    entity(f"fence_{name}", (x, 0.6, (BACK_Z + FRONT_Z) / 2), body=['kind = "static"', f"shape = {{ box = [0.1, 1.3, {FRONT_Z - BACK_Z}] }}"])

heading("shed: a dark corner for the flashlight")
SX, SZ = -11.6, -8.6
hx, hz, t = plan.SHED_X / 2, plan.SHED_Z / 2, plan.SHED_WALL
d0, d1, top = plan.SHED_DOOR
slope = math.atan2(plan.SHED_FRONT - plan.SHED_BACK, 2 * hz)
middle = (plan.SHED_FRONT + plan.SHED_BACK) / 2
over, thick = plan.SHED_OVER, plan.SHED_ROOF_THICK


def upright(x0, x1, z0, z1, y0, y1):
    return box(((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2), (x1 - x0, y1 - y0, z1 - z0))


parts = [
    upright(-hx, d0, hz - t, hz, 0, plan.SHED_FRONT), upright(d1, hx, hz - t, hz, 0, plan.SHED_FRONT),
    upright(d0, d1, hz - t, hz, top, plan.SHED_FRONT), upright(-hx, hx, -hz, t - hz, 0, plan.SHED_BACK),
    *["{ hull_m = [" + ", ".join(vec(x, y, z) for x in (x0, x0 + t) for y, z in ((0, -hz), (0, hz), (plan.SHED_BACK, -hz), (plan.SHED_FRONT, hz))) + "] }"
      for x0 in (-hx, hx - t)],
    upright(-hx, hx, -hz, hz, 0, plan.SHED_FLOOR),
    box((0, middle + thick / 2 / math.cos(slope), 0), (2 * (hx + over), thick, 2 * (hz + over) / math.cos(slope)), (-math.degrees(slope), 0, 0)),
]
entity("shed", (SX, 0, SZ), model='"models/shed.glb"', body=['kind = "static"', compound(parts)])

heading("things lying about")
THINGS = [("crate", 6.2, 0.407, 2.0, 12), ("crate", 5.2, 0.407, 1.7, -9), ("crate", 5.75, 1.222, 1.85, 28), ("crate", 7.4, 0.407, 3.6, 55),
          ("barrel", 6.9, 0, 0.9, 0), ("barrel", 7.7, 0, 1.6, 30), ("crate", -12.4, 0.467, -9.3, 8), ("crate", -12.4, 1.281, -9.27, 20), ("barrel", -10.7, 0.06, -9.4, 0)]
for i, (kind, x, y, z, turn) in enumerate(THINGS):
    entity(f"{kind}_{i + 1}", (x, y, z), prefab=f'"{kind}"', rotation_deg=f"[0, {turn}, 0]")
entity("barrel_lying", (8.6, 0.304, 4.9), prefab='"barrel"', rotation_deg="[90, 35, 0]")
for i, (x, z, h) in enumerate([(2.6, 10.4, 0.12), (-2.2, 7.3, 0.12), (4.1, 5.6, 0.12)]):
    entity(f"ball_{i + 1}", (x, h, z), prefab='"ball"')
for row in range(3):
    for i in range(4 - row):
        entity(f"brick_{row}_{i}", (-6.6 + 0.27 * (i + row / 2), 0.033 + 0.066 * row, -0.9), prefab='"brick"')
for i in range(3):
    entity(f"plank_{i + 1}", (-7.2 + 0.1 * i, 0.021, 0.6 + 0.3 * i), prefab='"plank"', rotation_deg=f"[0, {5 * i}, 0]")
for i in range(12):
    entity(f"domino_{i + 1}", (-8.2 + 0.06 * i, 0.4, 12.6 - 0.42 * i), prefab='"domino"', rotation_deg=f"[0, {-6 - 1.5 * i:.1f}, 0]")

garden_things.put_things(FRONT_Z)

print("\n".join(out))
