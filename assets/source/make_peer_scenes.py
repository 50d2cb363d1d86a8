#!/usr/bin/env python3
"""Writes assets/scenes/bench/peers/*.toml, the scenes that other physics engines were measured on.

    python3 assets/source/make_peer_scenes.py

SI units, +Y up, the ground's top at y = 0. Mass and inertia are written out, nothing sleeps, so
that every engine gets the same bodies. The order of the bodies is part of the scene: stock Bullet
solves in that order.
"""
import math
import pathlib
import random

from card_house import SIZE_M, card_house
from hard_scene import LOOK

ASSETS = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ASSETS / "scenes" / "bench" / "peers"
MODELS = ASSETS / "models" / "bench"

HEAD = """# {about}.
# Written by assets/source/make_peer_scenes.py; tests/benchmarks/peer_scenes.cpp measures it.

[scene]
title = "{name}"
description = "{about}"
include = ["scenes/materials.toml"]

[world]
gravity_mps2 = [0, {gravity!r}, 0]

[camera]
position_m = {camera}
target_m = {target}
fov_deg = {fov}

""" + LOOK

CUBE = "box = [1, 1, 1]"
DENSITY_KGPM3 = 1000.0


def numbers(values):
    return "[" + ", ".join(repr(value) for value in values) + "]"


def box_inertia(mass, size):
    x, y, z = size
    return [mass / 12 * (y * y + z * z), mass / 12 * (x * x + z * z), mass / 12 * (x * x + y * y)]


def ball_inertia(mass, radius):
    return [0.4 * mass * radius * radius] * 3


def write_prism(path, outline, depth):
    """An outline in the xy plane, counter-clockwise, as a solid of that depth along z."""
    count, half = len(outline), depth / 2
    faces = [[(*corner, half) for corner in outline], [(*corner, -half) for corner in reversed(outline)]]
    for i in range(count):
        (ax, ay), (bx, by) = outline[i], outline[(i + 1) % count]
        faces.append([(ax, ay, half), (ax, ay, -half), (bx, by, -half), (bx, by, half)])
    lines = ["# A stone of the arch. Written by assets/source/make_peer_scenes.py."]
    for face in faces:
        lines += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in face]
    at = 1
    for face in faces:
        lines.append("f " + " ".join(str(at + i) for i in range(len(face))))
        at += len(face)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


class Scene:
    """The text of one scene file."""

    def __init__(self, name, about, camera, target, gravity=-9.81, fov=50, shadow=60):
        self.name = name
        self.parts = [HEAD.format(name=name, about=about, camera=numbers(camera),
                                  target=numbers(target), gravity=gravity, fov=fov, shadow=shadow)]

    def ground(self, friction, restitution=0.0):
        self.parts.append(f"""[[entity]]
name = "ground"
position_m = [0, -1, 0]
primitive = {{ box = [200, 2, 200] }}
material = "gravel"
casts_shadow = false
[entity.body]
kind = "static"
friction = {friction!r}
restitution = {restitution!r}
""")

    def backdrop(self, top):
        """Ground that is only seen: nothing of the scene reaches it."""
        self.parts.append(f"""[[entity]]
name = "ground"
position_m = [0, {top - 1!r}, 0]
primitive = {{ box = [200, 2, 200] }}
material = "gravel"
casts_shadow = false
""")

    def prefab(self, name, shape, mass, inertia, friction, restitution=0.0, extra="", material="wood", drawn=""):
        """`drawn`: a model or primitive in place of the body's shape, as its line of the file."""
        body = f"shape = {{ {shape} }}\n" if drawn else ""
        drawn = drawn or f"primitive = {{ {shape} }}"
        self.parts.append(f"""[[prefab]]
name = "{name}"
{drawn}
material = "{material}"
[prefab.body]
{body}mass_kg = {mass!r}
inertia_kgm2 = {numbers(inertia)}
friction = {friction!r}
restitution = {restitution!r}
can_sleep = false
{extra}""")

    def entity(self, name, prefab, position, orientation=None, body="", material=""):
        painted = f'material = "{material}"\n' if material else ""
        turned = f"orientation = {numbers(orientation)}\n" if orientation else ""
        moving = f"[entity.body]\n{body}" if body else ""
        self.parts.append(f'[[entity]]\nname = "{name}"\nprefab = "{prefab}"\n'
                          f"position_m = {numbers(position)}\n{turned}{painted}{moving}")

    def array(self, name, prefab, origin, count, spacing):
        self.parts.append(f'[[array]]\nname = "{name}"\nprefab = "{prefab}"\n'
                          f"origin_m = {numbers(origin)}\ncount = {list(count)}\n"
                          f"spacing_m = {numbers(spacing)}\n")

    def ball_joint(self, a, b, anchor):
        self.parts.append(f'[[joint]]\nkind = "ball_and_socket"\na = "{a}"\nb = "{b}"\n'
                          f"anchor_m = {numbers(anchor)}\n")

    def cubes(self, friction=0.6):
        self.ground(friction)
        self.prefab("cube", CUBE, DENSITY_KGPM3, box_inertia(DENSITY_KGPM3, (1, 1, 1)), friction)

    def write(self, folder):
        (folder / f"{self.name}.toml").write_text("\n".join(self.parts), encoding="utf-8")


def pile():
    scene = Scene("pile", "1000 cubes in a loose grid fall 10 cm and settle", (14, 9, 18), (0, 4, 0))
    scene.cubes()
    for layer in range(10):  # a layer an array: bodies in the order x, z, y
        scene.array(f"layer_{layer}", "cube", (-4.95, 0.6 + 1.1 * layer, -4.95), (10, 1, 10),
                    (1.1, 1.1, 1.1))
    return scene


def rubble():
    scene = Scene("rubble", "1000 cubes, turned at random, fall into a heap", (18, 12, 22), (0, 5, 0))
    scene.cubes()
    rng = random.Random(12345)
    for i in range(1000):
        x, z, y = i % 10, i // 10 % 10, i // 100
        quaternion = [rng.gauss(0, 1) for _ in range(4)]
        length = math.sqrt(sum(part * part for part in quaternion))
        qx, qy, qz, qw = (part / length for part in quaternion)
        place = ((x - 4.5) * 1.8 + rng.uniform(-0.02, 0.02), 1.2 + 1.8 * y,
                 (z - 4.5) * 1.8 + rng.uniform(-0.02, 0.02))
        scene.entity(f"cube_{i}", "cube", place, (qw, qx, qy, qz))
    return scene


def pyramid():
    scene = Scene("pyramid", "A pyramid of 210 cubes, 20 wide", (6, 9, 26), (0, 7, 0))
    scene.cubes()
    for row in range(20):
        for i in range(20 - row):
            scene.entity(f"cube_{row}_{i}", "cube", ((i - (19 - row) / 2) * 1.05, 0.5 + row, 0.0))
    return scene


def stack():
    scene = Scene("stack", "30 cubes, one upon the other", (14, 16, 26), (0, 14, 0))
    scene.cubes()
    scene.array("cube", "cube", (0.0, 0.5, 0.0), (1, 30, 1), (1.0, 1.0, 1.0))
    return scene


def heavy(ratio):
    scene = Scene(f"heavy{ratio}", f"A cube with one {ratio} times as heavy on it", (3, 2, 5), (0, 1, 0))
    scene.cubes()
    mass = DENSITY_KGPM3 * ratio
    scene.prefab("load", CUBE, mass, box_inertia(mass, (1, 1, 1)), 0.6, material="rustmetal")
    scene.entity("lower", "cube", (0.0, 0.5, 0.0))
    scene.entity("upper", "load", (0.0, 1.5, 0.0))
    return scene


def chain(name, about, along, size):
    """50 links of 0.4 m and 1 kg from an anchor at y = 30, a ball of 100 kg at the end. Drawn three
    times as thick as they are, to be seen as a whole."""
    scene = Scene(name, about, (10, 19, 24), (5 * along[0], 20.5 + 1.5 * along[0], 0), fov=60)
    scene.backdrop(0)
    untouched = "collides_with = []\n"
    scene.parts.append("""[[entity]]
name = "anchor"
position_m = [0, 30, 0]
primitive = { sphere = 0.3 }
material = "paint_blue"
[entity.body]
shape = { sphere = 0.05 }
kind = "static"
friction = 0.6
restitution = 0
collides_with = []
""")
    thick = numbers([side if side == max(size) else round(3 * side, 3) for side in size])
    scene.prefab("link", f"box = {numbers(size)}", 1.0, box_inertia(1.0, size), 0.6, extra=untouched,
                 material="paint_orange", drawn=f"primitive = {{ box = {thick} }}")
    scene.prefab("weight", "sphere = 0.25", 100.0, ball_inertia(100.0, 0.25), 0.6, extra=untouched,
                 material="rustmetal", drawn="primitive = { sphere = 0.6 }")

    def at(distance):
        return [0.0 + along[0] * distance, 30.0 + along[1] * distance, 0.0]

    names = ["anchor"] + [f"link_{i}" for i in range(50)] + ["ball"]
    for i in range(50):
        scene.entity(names[i + 1], "link", at(0.4 * i + 0.2), material="paint_cream" if i % 2 else "")
    scene.entity("ball", "weight", at(50 * 0.4 + 0.25))
    for i in range(51):
        scene.ball_joint(names[i + 1], names[i], at(0.4 * i))
    return scene


def ball_on_ground(name, about, friction, restitution, mass, place, body):
    scene = Scene(name, about, (place[0] + 4, max(4, place[1] / 2), place[2] + 16), (place[0], place[1] / 2, place[2]))
    scene.ground(friction, restitution)
    scene.prefab("ball", "sphere = 0.5", mass, ball_inertia(mass, 0.5), friction, restitution, material="paint_orange")
    scene.entity("ball", "ball", place, body=body)
    return scene


def bounce():
    return ball_on_ground("bounce", "A ball falls 10 m and bounces without loss", 0.0, 1.0, 1000.0,
                          (0.0, 10.5, 0.0), "")


def slideroll():
    return ball_on_ground("slideroll", "A ball slides until it rolls", 0.3, 0.0, 500.0,
                          (0.0, 0.5, 0.0), "velocity_mps = [5, 0, 0]\n")


def flatroll():
    angle = math.radians(17)
    vx, vz = 5 * math.cos(angle), 5 * math.sin(angle)
    return ball_on_ground("flatroll", "A ball rolls without sliding", 0.6, 0.0, 500.0,
                          (-9.03, 0.5, -8.37),
                          f"velocity_mps = {numbers((vx, 0.0, vz))}\n"
                          f"angular_velocity_radps = {numbers((vz / 0.5, 0.0, -vx / 0.5))}\n")


def dzhani():
    """Bar 1 x 0.2 x 0.2 m and stem 0.2 x 0.4 x 0.2 m: only their mass and inertia, and a box."""
    scene = Scene("dzhani", "A T-handle turns about its middle axis, weightless", (1, 1, 2.5),
                  (0, 0, 0), gravity=0.0)
    scene.backdrop(-1.5)
    bar, stem = (1.0, 0.2, 0.2), (0.2, 0.4, 0.2)
    bar_mass, stem_mass = DENSITY_KGPM3 * math.prod(bar), DENSITY_KGPM3 * math.prod(stem)
    mass = bar_mass + stem_mass
    # Along y: the bar's centre at 0, the stem's 0.3 below it; reduced mass about the common centre.
    apart = bar_mass * stem_mass / mass * 0.3 * 0.3
    inertia = [a + b for a, b in zip(box_inertia(bar_mass, bar), box_inertia(stem_mass, stem))]
    inertia[0] += apart
    inertia[2] += apart
    scene.prefab("handle", "box = [1, 0.6, 0.2]", mass, inertia, 0.6,
                 extra="angular_velocity_radps = [0.01, 5, 0.01]\ncollides_with = []\n", material="paint_orange")
    scene.entity("handle", "handle", (0.0, 0.0, 0.0))
    return scene


def s666():
    scene = Scene("s666", "6 x 6 x 6 frictionless balls fall and run apart", (3, 2, 4), (0, 0.5, 0))
    scene.ground(0.0)
    scene.prefab("ball", "sphere = 0.1", 10.0, ball_inertia(10.0, 0.1), 0.0, material="paint_orange")
    rng = random.Random(42)
    for i in range(216):
        x, z, y = i // 36, i // 6 % 6, i % 6
        scene.entity(f"ball_{i}", "ball", (-0.6 + 0.21 * x + 0.001 * rng.random(),
                                           1.101 + 0.21 * y + 0.001 * rng.random(),
                                           0.21 * z + 0.001 * rng.random()))
    return scene


def arch():
    """15 blocks between circles of 4 and 5 m, as straight-sided hulls, 1 m deep, 2000 kg/m3."""
    scene = Scene("arch", "An arch of 15 stones without mortar", (0, 3, 12), (0, 2.5, 0))
    scene.ground(0.6)
    half = math.radians(6)
    low, high = 4 * math.cos(half), 5 * math.cos(half)
    a, b = 4 * math.sin(half), 5 * math.sin(half)  # half widths, inner and outer
    depth, height = 1.0, high - low
    centre = low + height * (a + 2 * b) / (3 * (a + b))
    mass = 2000.0 * (a + b) * height * depth
    # Second moments of a trapezoid about its centre: across (x) and along (y) the height.
    along = height * height * (a * a + 4 * a * b + b * b) / (18 * (a + b) ** 2)
    across = (a * a + b * b) / 6
    inertia = [mass * (along + depth * depth / 12), mass * (across + depth * depth / 12),
               mass * (along + across)]
    outline = [(-a, low - centre), (a, low - centre), (b, high - centre), (-b, high - centre)]
    points = [numbers((x, y, z)) for z in (-depth / 2, depth / 2) for x, y in outline]
    write_prism(MODELS / "arch_stone.obj", outline, depth)
    scene.prefab("stone", f"hull_m = [{', '.join(points)}]", mass, inertia, 0.6, material="paint_cream",
                 drawn='model = "models/bench/arch_stone.obj"')
    for i in range(15):
        angle = half + 2 * half * i
        turn = (angle - math.pi / 2) / 2
        scene.entity(f"stone_{i}", "stone", (centre * math.cos(angle), centre * math.sin(angle), 0.0),
                     (math.cos(turn), 0.0, 0.0, math.sin(turn)), material="paint_orange" if i % 2 else "")
    return scene


def cards():
    """A house of 40 cards; neighbours start about 2 mm inside each other."""
    scene = Scene("cards", "A house of 40 cards", (0.9, 1, 3), (0.8, 0.8, 0))
    scene.ground(0.7)
    mass = DENSITY_KGPM3 * math.prod(SIZE_M)
    scene.prefab("card", f"box = {numbers(SIZE_M)}", mass, box_inertia(mass, SIZE_M), 0.7, material="paint_cream")
    for i, (x, y, angle_deg) in enumerate(card_house()):
        turn = math.radians(angle_deg) / 2
        scene.entity(f"card_{i}", "card", (x, y, 0.0), (math.cos(turn), 0.0, 0.0, math.sin(turn)))
    return scene


def scenes():
    yield pile()
    yield rubble()
    yield pyramid()
    yield stack()
    for ratio in (1, 10, 100, 1000):
        yield heavy(ratio)
    yield chain("chainv", "A chain of 50 links hangs with 100 kg at its end", (0, -1), (0.1, 0.4, 0.1))
    yield chain("chainh", "A chain of 50 links with 100 kg at its end swings down", (1, 0),
                (0.4, 0.1, 0.1))
    yield bounce()
    yield slideroll()
    yield flatroll()
    yield dzhani()
    yield s666()
    yield arch()
    yield cards()


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    for made in scenes():
        made.write(FOLDER)
