#!/usr/bin/env python3
"""Writes assets/scenes/bench/boxes_{100,1000,3000}.toml, the scene that other engines were measured with,
lamps_{0,8,24,64,256}.toml, one floor under so many lamps, and stacks_3000.toml and block_3000.toml, as many boxes in
three hundred islands and in one.

    python3 assets/source/make_bench_scenes.py

N unit boxes in layers of 100, each layer shifted a little so that the columns topple. Integer
divisions and remainders only: the boxes are at the same places in every engine.
"""
import pathlib

MATERIALS = """[[material]]
name = "box"
base_color = [0.75, 0.42, 0.2]
roughness = 0.7

[[material]]
name = "ground"
base_color = [0.35, 0.4, 0.33]
roughness = 0.95
"""

HEAD = """# {count} boxes fall and topple: the scene that other engines were measured with
# (docs/PERFORMANCE.md). Written by assets/source/make_bench_scenes.py.

[scene]
title = "{count} boxes"
description = "Bench: sun and flashlight with shadows, sky, two plain materials"

[accuracy]
preset = "balanced"
step_hz = 60

[camera]
position_m = [0, 9, 24]
target_m = [0, 4, 0]
fov_deg = 60

[sun]
direction = [-16, -40, -12]
color = [1, 0.96, 0.9]
intensity = 3.0
shadow = {{ cascades = 1, size_px = 2048, distance_m = 60 }}

[sky]
skybox = "skies/garden"

[ambient]
color = [0.25, 0.27, 0.3]

[flashlight]                        # half angle 22 degrees
on = true
at = "eye"
intensity = 200
radius_m = 60
inner_deg = 18
outer_deg = 22

{materials}
[[entity]]
name = "ground"
position_m = [0, -0.5, 0]
primitive = {{ box = [120, 1, 120] }}
material = "ground"
[entity.body]
kind = "static"
friction = 0.5
restitution = 0

[[prefab]]
name = "box"
primitive = {{ box = [1, 1, 1] }}
material = "box"
[prefab.body]
mass_kg = 1
friction = 0.5
restitution = 0
"""


def position(i):
    layer = i // 100
    x = (i % 10 - 4.5) * 1.6 + 0.28 * ((i * 7 + layer * 3) % 11 - 5) / 5
    z = ((i // 10) % 10 - 4.5) * 1.6 + 0.28 * ((i * 5 + layer * 4) % 13 - 6) / 6
    return x, 3 + 1.25 * layer, z


def scene(count):
    parts = [HEAD.format(count=count, materials=MATERIALS)]
    for i in range(count):
        x, y, z = position(i)
        parts.append(f'[[entity]]\nname = "box_{i}"\nprefab = "box"\nposition_m = [{x:.9g}, {y:.9g}, {z:.9g}]\n')
    return "\n".join(parts)


STACKS = """# 3000 boxes that stay awake: {what}. What threads give (docs/PERFORMANCE.md).
# Written by assets/source/make_bench_scenes.py.

[scene]
title = "{title}"
description = "Bench: {what}"

[camera]
position_m = [0, 6, {from_m}]
target_m = [0, 1, 0]
fov_deg = 60

[sun]
direction = [-16, -40, -12]
intensity = 3.0
shadow = {{ cascades = 1, size_px = 2048, distance_m = 60 }}

[sky]
skybox = "skies/garden"

{materials}
[[entity]]
name = "ground"
position_m = [0, -0.5, 0]
primitive = {{ box = [60, 1, 60] }}
material = "ground"
[entity.body]
kind = "static"

[[prefab]]
name = "box"
primitive = {{ box = [0.2, 0.2, 0.2] }}
material = "box"
[prefab.body]
mass_kg = 1
can_sleep = false

[[array]]
name = "box"
prefab = "box"
origin_m = [{x:g}, 0.1, {z:g}]
count = [{columns}, 10, {rows}]
spacing_m = [{apart_m:g}, 0.2, {apart_m:g}]
"""


def stacks(what, title, columns, rows, apart_m, from_m):
    return STACKS.format(materials=MATERIALS, what=what, title=title, columns=columns, rows=rows, apart_m=apart_m, from_m=from_m,
                         x=-apart_m * (columns - 1) / 2, z=-apart_m * (rows - 1) / 2)


LAMPS = """# One floor under {count} lamps that reach 4 m each: what a light costs (docs/PERFORMANCE.md).
# Written by assets/source/make_bench_scenes.py.

[scene]
title = "{count} lamps"
description = "Bench: one floor of 32 m, lit by point lights only"

[camera]
position_m = [0, 9, 22]
target_m = [0, 0, 2]
fov_deg = 60
clear_color = [0, 0, 0]

[ambient]
color = [0.02, 0.02, 0.02]

[[material]]
name = "floor"
base_color = [0.5, 0.5, 0.5]
roughness = 0.9

[[entity]]
name = "floor"
position_m = [0, -0.5, 0]
primitive = {{ box = [32, 1, 32] }}
material = "floor"
[entity.body]
kind = "static"

[[prefab]]
name = "lamp"
light = {{ intensity = {intensity}, radius_m = 4 }}
"""
LAMP_ROWS = """
[[array]]
name = "lamp"
prefab = "lamp"
origin_m = [{x:g}, 0.8, {z:g}]
count = [{across}, 1, {deep}]
spacing_m = [{step_x:g}, 1, {step_z:g}]
"""


def lamps(across, deep):
    text = LAMPS.format(count=across * deep, intensity=0.7 if across * deep > 64 else 2)
    if across == 0:
        return text
    step_x, step_z = 32 / across, 32 / deep
    return text + LAMP_ROWS.format(x=step_x / 2 - 16, z=step_z / 2 - 16, across=across, deep=deep,
                                   step_x=step_x, step_z=step_z)


folder = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "bench"
folder.mkdir(parents=True, exist_ok=True)
for count in (100, 1000, 3000):
    (folder / f"boxes_{count}.toml").write_text(scene(count))
for across, deep in ((0, 0), (4, 2), (6, 4), (8, 8), (16, 16)):
    (folder / f"lamps_{across * deep}.toml").write_text(lamps(across, deep))
for name, words in (("stacks_3000", ("300 stacks of ten", "3000 boxes in stacks", 20, 15, 1, 16)),
                    ("block_3000", ("one block, each touching its neighbours", "3000 boxes in one block", 20, 15, 0.2, 7))):
    (folder / f"{name}.toml").write_text(stacks(*words))
