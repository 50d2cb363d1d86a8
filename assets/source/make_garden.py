#!/usr/bin/env python3
"""Writes assets/scenes/garden.toml: where every post, bed and flower of the garden stands.

    python3 assets/source/make_garden.py > assets/scenes/garden.toml

Metres, +Y up. The house looks down +Z to the fountain; the gate is in the front fence at +Z.
Same script, same file: positions come from a seeded generator.
"""
import math
import random

rng = random.Random(20)
out = []


def put(text):
    out.append(text)


def vec(*numbers):
    return "[" + ", ".join(f"{n:.3f}".rstrip("0").rstrip(".") if abs(n) > 5e-4 else "0" for n in numbers) + "]"


def entity(name, position, **keys):
    """One [[entity]]; values are TOML text already, `body` a list of lines."""
    body = keys.pop("body", None)
    put(f'\n[[entity]]\nname = "{name}"\nposition_m = {vec(*position)}')
    for key, value in keys.items():
        put(f"{key} = {value}")
    if body:
        put("[entity.body]")
        for line in body:
            put(line)


def array(name, prefab, origin, count, spacing):
    put(f'\n[[array]]\nname = "{name}"\nprefab = "{prefab}"\norigin_m = {vec(*origin)}')
    put(f"count = {vec(*count)}\nspacing_m = {vec(*spacing)}")


def prefab(name, lines):
    put(f'\n[[prefab]]\nname = "{name}"')
    for line in lines:
        put(line)


def heading(text):
    put(f"\n# --- {text}")


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
direction = [-0.545, -0.53, -0.65]      # as in the sky's picture
color = [1.0, 0.93, 0.82]
intensity = 3.4
shadow = { cascades = 1, size_px = 2048, distance_m = 34 }

[sky]
skybox = "skies/garden"

[ambient]
color = [0.26, 0.3, 0.36]

[flashlight]

[post]
exposure = 1.2""")

heading("where the tour takes its pictures")
for name, position, target, extra in [
    ("arrival", (1.6, 1.7, 14.0), (0, 1.5, 0), ""),
    ("fountain", (3.9, 1.5, 7.0), (-0.6, 1.0, 2.2), "wait_s = 1.0\n"),
    ("flower_bed", (-4.6, 0.75, -0.6), (-1.8, 0.55, -2.7), ""),
    ("crates", (8.6, 1.6, 6.4), (6.1, 0.7, 2.3), ""),
    ("from_above", (13.5, 9.5, 15.0), (-1.0, 0.2, -1.5), ""),
    ("shed_with_flashlight", (-10.9, 1.6, -5.3), (-11.7, 0.85, -9.2), "flashlight = true\nlight_scale = 0.06\n"),
]:
    put(f'\n[[view]]\nname = "{name}"\nposition_m = {vec(*position)}\ntarget_m = {vec(*target)}\n{extra}'.rstrip())

heading("ground")
entity("lawn", (0, 0, 0), primitive="{ plane = [240, 240] }", material='"grass"', casts_shadow="false",
       body=['kind = "static"', "friction = 0.8"])
entity("plaza", (0, 0, 3.2), primitive="{ cylinder = [3.5, 0.06] }", material='"flagstone"',
       body=['kind = "static"', "friction = 0.7"])
for name, z0, z1 in [("path_to_gate", 6.4, 17.6), ("path_to_door", -2.4, 0.2)]:
    entity(name, (0, 0, (z0 + z1) / 2), primitive=f"{{ box = [1.7, 0.05, {z1 - z0:.2f}] }}", material='"flagstone"',
           body=['kind = "static"', "friction = 0.7"])
entity("path_round_house", (5.3, 0, -3.2), primitive="{ box = [7.2, 0.04, 1.1] }", material='"gravel"',
       body=['kind = "static"', "friction = 0.7"])

heading("house and fountain")
entity("house", (0, 0, -6.2), model='"models/house.glb"', body=['kind = "static"', 'shape = { mesh = "model" }', "friction = 0.7"])
parts = ["{ cylinder = [1.5, 0.18], position_m = [0, 0.09, 0] }"]
for i in range(8):
    turn = 22.5 + 45 * i
    x, z = 1.5 * math.sin(math.radians(turn)), 1.5 * math.cos(math.radians(turn))
    parts.append(f"{{ box = [1.4, 0.61, 0.29], position_m = {vec(x, 0.305, z)}, rotation_deg = [0, {turn}, 0] }}")
parts += ["{ cylinder = [0.22, 1.2], position_m = [0, 0.6, 0] }", "{ cylinder = [0.74, 0.16], position_m = [0, 1.42, 0] }",
          "{ cylinder = [0.11, 0.7], position_m = [0, 1.8, 0] }"]
entity("fountain", (0, 0.03, 3.2), model='"models/fountain.glb"',
       sound='{ file = "sounds/loop_fountain.ogg", loop = true, gain = 1.0, radius_m = 14 }',
       body=['kind = "static"', "friction = 0.6", "shape = { compound = [\n    " + ",\n    ".join(parts) + ",\n] }"])

heading("trees")
TRUNK = ['kind = "static"', "shape = { compound = [ { cylinder = [0.2, 3.4], position_m = [0, 1.7, 0] } ] }"]
TREES = [("oak", -9.5, 6.5, 1.0, 40), ("linden", 9.8, -6.5, 1.15, 120), ("linden", -7.2, -11.0, 1.1, 200),
         ("oak", 12.2, 10.5, 0.95, 300), ("oak", 5.5, -19.0, 1.2, 75), ("linden", 20.0, -13.0, 1.4, 260)]
for i, (kind, x, z, scale, turn) in enumerate(TREES):
    rustle = '{ file = "sounds/loop_leaves.ogg", loop = true, gain = 0.25, radius_m = 9 }'
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
        entity(f"fence_{name}_{half}", (x0 + 7, 0.6, z), body=['kind = "static"', "shape = { box = [14.1, 1.3, 0.1] }"])
    if not gate:
        array("fence_back_middle_rails", "fence_rail_x", (0, 0.5, z), (1, 2, 1), (2, 0.5, 1))
        entity("fence_back_middle", (0, 0.6, z), body=['kind = "static"', "shape = { box = [2, 1.3, 0.1] }"])
for name, x in [("west", -HALF_X), ("east", HALF_X)]:
    array(f"fence_{name}_posts", "fence_post", (x, 0.6, BACK_Z + 2), (1, 1, 14), (1, 1, 2))
    array(f"fence_{name}_rails", "fence_rail_z", (x, 0.5, BACK_Z + 1), (1, 2, 15), (1, 0.5, 2))
    entity(f"fence_{name}", (x, 0.6, (BACK_Z + FRONT_Z) / 2), body=['kind = "static"', f"shape = {{ box = [0.1, 1.3, {FRONT_Z - BACK_Z}] }}"])

heading("shed: a dark corner for the flashlight")
SX, SZ = -11.6, -8.6
for name, position, size in [
    ("back", (SX, 1.15, SZ - 1.3), (3.2, 2.3, 0.06)), ("left", (SX - 1.57, 1.15, SZ), (0.06, 2.3, 2.6)), ("right", (SX + 1.57, 1.15, SZ - 0.65), (0.06, 2.3, 1.3)),
    ("front_left", (SX - 1.1, 1.15, SZ + 1.3), (1.0, 2.3, 0.06)), ("front_right", (SX + 1.35, 1.15, SZ + 1.3), (0.5, 2.3, 0.06)),
    ("floor", (SX, 0.03, SZ), (3.2, 0.06, 2.6)),
]:
    entity(f"shed_{name}", position, primitive=f"{{ box = {vec(*size)} }}", material='"paintwood"' if name != "floor" else '"wood"', body=['kind = "static"'])
entity("shed_roof", (SX, 2.42, SZ), primitive="{ box = [3.7, 0.08, 3.2] }", rotation_deg="[5, 0, 0]", material='"roof"', body=['kind = "static"'])

heading("things lying about")
THINGS = [("crate", 6.2, 0.407, 2.0, 12), ("crate", 5.2, 0.407, 1.7, -9), ("crate", 5.75, 1.222, 1.85, 28), ("crate", 7.4, 0.407, 3.6, 55),
          ("barrel", 6.9, 0, 0.9, 0), ("barrel", 7.7, 0, 1.6, 30), ("crate", -12.4, 0.47, -9.3, 8), ("crate", -12.4, 1.285, -9.35, 20), ("barrel", -10.7, 0.07, -9.4, 0)]
for i, (kind, x, y, z, turn) in enumerate(THINGS):
    entity(f"{kind}_{i + 1}", (x, y, z), prefab=f'"{kind}"', rotation_deg=f"[0, {turn}, 0]")
entity("barrel_lying", (8.6, 0.31, 4.9), prefab='"barrel"', rotation_deg="[90, 35, 0]")
for i, (x, z, h) in enumerate([(2.6, 10.4, 0.12), (-2.2, 7.3, 0.12), (4.1, 5.6, 0.12)]):
    entity(f"ball_{i + 1}", (x, h, z), prefab='"ball"')
for row in range(3):
    for i in range(4 - row):
        entity(f"brick_{row}_{i}", (-6.6 + 0.27 * (i + row / 2), 0.033 + 0.066 * row, -0.9), prefab='"brick"')
for i in range(3):
    entity(f"plank_{i + 1}", (-7.2 + 0.1 * i, 0.021, 0.6 + 0.3 * i), prefab='"plank"', rotation_deg=f"[0, {5 * i}, 0]")
for i in range(12):
    entity(f"domino_{i + 1}", (-8.2 + 0.06 * i, 0.4, 12.6 - 0.42 * i), prefab='"domino"', rotation_deg=f"[0, {-6 - 1.5 * i:.1f}, 0]")

print("\n".join(out))
