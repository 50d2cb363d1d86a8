#!/usr/bin/env python3
"""Writes assets/scenes/playroom.toml: stairs, ramps, things that move, dominoes.

    python3 assets/source/make_playroom.py

Metres, +Y up. The player comes in at +Z and looks down -Z; the walls of the far corner stand at
-X and -Z.
"""
import math
import pathlib

out = []


def vec(*numbers):
    return "[" + ", ".join(f"{round(n, 4) + 0:g}" for n in numbers) + "]"


def entity(name, position, body='kind = "static"', **keys):
    out.append(f'\n[[entity]]\nname = "{name}"\nposition_m = {vec(*position)}')
    for key, value in keys.items():
        out.append(f"{key} = {value}")
    if body:
        out.append(f"[entity.body]\n{body}")


def box(name, centre, size, material, **keys):
    entity(name, centre, primitive=f"{{ box = {vec(*size)} }}", material=f'"{material}"', **keys)


def thing(name, prefab, position, turn_deg=0.0):
    keys = {"prefab": f'"{prefab}"'}
    if turn_deg:
        keys["rotation_deg"] = vec(0, turn_deg, 0)
    entity(name, position, body=None, **keys)


def heading(text):
    out.append(f"\n# --- {text}")


out.append("""# The playroom: a yard to try everything in. Stairs from 15 to 35 cm, ramps from 15 to 60 degrees, a
# ferry, a lift and a turntable, a spiral of dominoes, crates and balls.
# Written by assets/source/make_playroom.py: change that and run it again.

[scene]
title = "The playroom"
description = "Stairs, ramps, moving platforms, dominoes, crates and balls"
include = ["materials.toml", "things.toml"]

[world]
kill_below_m = -20

[player]
position_m = [0, 0, 15]

[camera]
position_m = [13, 8.5, 18]
target_m = [-1.5, 0.5, -1]
fov_deg = 55

[sun]
direction = [-0.545, -0.53, -0.65]      # as in the sky's image
color = [1.0, 0.93, 0.82]
intensity = 3.4
shadow = { size_px = 2048, distance_m = 45 }

[sky]
skybox = "skies/garden"

[ambient]
color = [0.3, 0.33, 0.38]

[flashlight]

[post]
exposure = 0.95
bloom = 0.03

# paint for what is not made of a texture
[[material]]
name = "paint_blue"
base_color = [0.06, 0.22, 0.45]
roughness = 0.5
surface = "metal"

[[material]]
name = "paint_orange"
base_color = [0.8, 0.28, 0.04]
roughness = 0.5
surface = "metal"

[[material]]
name = "paint_green"
base_color = [0.1, 0.35, 0.14]
roughness = 0.5
surface = "metal"

[[material]]
name = "paint_cream"
base_color = [0.75, 0.68, 0.52]
roughness = 0.6
surface = "plank"

[[prefab]]
name = "cream_domino"
label = "cream domino"
prefab = "domino"
material = "paint_cream"

[[prefab]]
name = "blue_domino"
label = "blue domino"
prefab = "domino"
material = "paint_blue"

[[view]]
name = "yard"
position_m = [13, 8.5, 18]
target_m = [-1.5, 0.5, -1]

[[view]]
name = "dominoes"
position_m = [12.6, 3.2, 11.2]
target_m = [8.2, 0.3, 5.6]

[[view]]
name = "stairs_and_ramps"
position_m = [0.5, 3.4, 4.5]
target_m = [-6, 0.6, -9]

[[view]]
name = "turntable"
position_m = [-4.5, 2.6, 12.5]
target_m = [-9.5, 0.6, 6.5]
wait_s = 2""")

heading("ground and walls")
# Just below the floor, so that whoever leaves the yard has ground to walk on.
entity("meadow", (0, -0.02, 0), primitive="{ plane = [240, 240] }", material='"grass"', casts_shadow="false")
box("floor", (0, -0.25, 0), (40, 0.5, 40), "flagstone", casts_shadow="false")
box("wall_far", (0, 2, -19.8), (40, 4, 0.4), "plaster")
box("wall_left", (-19.8, 2, -0.2), (0.4, 4, 38.8), "brick")
box("wall_right", (19.8, 0.35, -0.2), (0.4, 0.7, 38.8), "brick")
for side, x in (("left", -11), ("right", 11)):
    box(f"wall_front_{side}", (x, 0.35, 19.8), (18, 0.7, 0.4), "brick")

heading("stairs: five flights to one balcony, each with its own step height")
TOP = 2.1
for i, rise in enumerate((0.15, 0.20, 0.25, 0.30, 0.35)):
    x = -17.6 + 2.0 * i
    steps = round(TOP / rise)
    tread = 0.32
    # The last tread is the balcony itself; each step reaches down to the floor.
    for k in range(1, steps):
        height = TOP * k / steps
        z = -16.0 + tread * (steps - k) - tread / 2
        box(f"stair_{round(rise * 100)}cm_{k}", (x, height / 2, z), (1.8, height, tread), "stone")
box("balcony", (-13.6, TOP / 2, -17.8), (12, TOP, 3.6), "stone")

heading("ramps: 15, 30, 45 and 60 degrees (one can walk up to 45)")
for i, degrees in enumerate((15, 30, 45, 60)):
    angle = math.radians(degrees)
    length, thick, width = (7.0, 4.6, 3.6, 3.2)[i], 0.2, 2.0
    x, foot_z = -5.6 + 2.6 * i, -10.0
    # The upper face starts on the floor at foot_z and climbs towards -Z.
    y = length / 2 * math.sin(angle) - thick / 2 * math.cos(angle)
    z = foot_z - length / 2 * math.cos(angle) - thick / 2 * math.sin(angle)
    box(f"ramp_{degrees}deg", (x, y, z), (width, thick, length), "wood", rotation_deg=vec(degrees, 0, 0))
    top = length * math.sin(angle)
    box(f"ramp_{degrees}deg_top", (x, top / 2, foot_z - length * math.cos(angle) - 0.75), (width, top, 1.5), "plaster")

heading("corners: a right angle, an acute one, a doorway of 80 cm, a tunnel of 1.2 m")
box("corner_a", (6.5, 1.1, -14.5), (3.0, 2.2, 0.2), "plaster")
box("corner_b", (8.1, 1.1, -13.1), (0.2, 2.2, 3.0), "plaster")
for name, turn, z in (("acute_a", 15, -11.61), ("acute_b", -15, -10.39)):
    box(name, (10.6, 1.1, z), (4.4, 2.2, 0.2), "brick", rotation_deg=vec(0, turn, 0))
box("door_left", (14.2, 1.1, -13), (2.2, 2.2, 0.2), "plaster")
box("door_right", (17.2, 1.1, -13), (2.2, 2.2, 0.2), "plaster")
box("door_lintel", (15.7, 2.35, -13), (5.2, 0.3, 0.2), "wood")
for side, x in (("left", 13.9), ("right", 15.5)):
    box(f"tunnel_{side}", (x, 0.6, -8), (0.2, 1.2, 4), "stone")
box("tunnel_roof", (14.7, 1.3, -8), (1.8, 0.2, 4), "stone")

heading("things that move by themselves")
KINEMATIC = 'kind = "kinematic"\nfriction = 0.8'
box("ferry", (-16.5, 0.2, -1), (2.6, 0.2, 2.6), "paint_orange", body=KINEMATIC,
    motion="{ points_m = [[0, 0, 0], [11, 0, 0]], period_s = 16 }")
box("ferry_quay", (-2.6, 0.15, -1), (2.2, 0.3, 2.6), "stone")
box("lift", (15.2, 0.15, 7), (2.0, 0.2, 2.0), "paint_orange", body=KINEMATIC,
    motion="{ points_m = [[0, 0, 0], [0, 3.0, 0]], period_s = 10 }")
box("lift_tower", (17.3, 1.55, 7), (2.0, 3.1, 2.0), "brick")
entity("turntable", (-9.5, 0.1, 6.5), body=KINEMATIC, primitive="{ cylinder = [2.6, 0.2] }", material='"paint_orange"',
       motion="{ spin_degps = [0, 36, 0] }")
for i in range(3):
    a = math.radians(120 * i)
    thing(f"rider_{i + 1}", "crate", (-9.5 + 1.5 * math.sin(a), 0.2 + 0.407, 6.5 + 1.5 * math.cos(a)), 120 * i)

heading("dominoes: a spiral, the outermost first")
# Equal steps along an Archimedean spiral: the radius falls by 0.95 m a turn.
CX, CZ, STEP, PER_TURN = 8.5, 5.5, 0.44, 1.15
radius, angle, count = 5.0, math.radians(150), 0
while radius > 1.3:
    x, z = CX + radius * math.sin(angle), CZ + radius * math.cos(angle)
    heading_deg = math.degrees(math.atan2(math.cos(angle), -math.sin(angle)))
    count += 1
    thing(f"domino_{count}", "blue_domino" if count % 8 == 1 else "cream_domino", (x, 0.4, z), heading_deg)
    turn = STEP / radius
    angle += turn
    radius -= PER_TURN * turn / math.tau

heading("crates, barrels, balls, bricks")
for row in range(5):
    for i in range(5 - row):
        thing(f"pyramid_{row}_{i}", "crate", (-2.2 + 0.86 * (i + row / 2), 0.407 + 0.814 * row, 3.0))
for i in range(3):
    thing(f"barrel_{i + 1}", "barrel", (2.6 + 0.75 * i, 0, -1.0))
for i in range(2):
    thing(f"barrel_{i + 4}", "barrel", (2.975 + 0.75 * i, 0.88, -1.0))
for row in range(6):
    for i in range(8):
        thing(f"brick_{row}_{i}", "brick", (-4.2 + 0.26 * (i + row % 2 / 2), 0.033 + 0.066 * row, 8.0))
for i in range(4):
    thing(f"plank_{i + 1}", "plank", (3.5, 0.021 + 0.042 * i, 10.5), 3 * i)
for name, x, z, w, d in (("a", 16, -1.5, 3, 0.1), ("b", 16, 1.5, 3, 0.1), ("c", 14.5, 0, 0.1, 3.1), ("d", 17.5, 0, 0.1, 3.1)):
    box(f"pen_{name}", (x, 0.25, z), (w, 0.5, d), "paintwood")
out.append("""
[[array]]
name = "balls"
prefab = "ball"
origin_m = [15.1, 0.4, -0.9]
count = [7, 2, 7]
spacing_m = [0.3, 0.3, 0.3]""")

target = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "playroom.toml"
target.write_text("\n".join(out) + "\n")
print(f"{target}: {count} dominoes")
