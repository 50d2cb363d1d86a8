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

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "bench" / "peers"

HEAD = """# {about}.
# Written by assets/source/make_peer_scenes.py; tests/benchmarks/peer_scenes.cpp measures it.

[scene]
title = "{name}"
description = "{about}"

[world]
gravity_mps2 = [0, {gravity!r}, 0]

[camera]
position_m = {camera}
target_m = {target}

[sun]
direction = [-0.4, -1, -0.3]
"""

CUBE = "box = [1, 1, 1]"
DENSITY_KGPM3 = 1000.0


def numbers(values):
    return "[" + ", ".join(repr(value) for value in values) + "]"


def box_inertia(mass, size):
    x, y, z = size
    return [mass / 12 * (y * y + z * z), mass / 12 * (x * x + z * z), mass / 12 * (x * x + y * y)]


def ball_inertia(mass, radius):
    return [0.4 * mass * radius * radius] * 3


class Scene:
    """The text of one scene file."""

    def __init__(self, name, about, camera, target, gravity=-9.81):
        self.name = name
        self.parts = [HEAD.format(name=name, about=about, camera=numbers(camera),
                                  target=numbers(target), gravity=gravity)]

    def ground(self, friction, restitution=0.0):
        self.parts.append(f"""[[entity]]
name = "ground"
position_m = [0, -1, 0]
primitive = {{ box = [200, 2, 200] }}
[entity.body]
kind = "static"
friction = {friction!r}
restitution = {restitution!r}
""")

    def prefab(self, name, shape, mass, inertia, friction, restitution=0.0, extra="", looks=True):
        """`looks`: the shape is drawn too; hulls are shapes of bodies only."""
        drawn = f"primitive = {{ {shape} }}\n" if looks else ""
        body = "" if looks else f"shape = {{ {shape} }}\n"
        self.parts.append(f"""[[prefab]]
name = "{name}"
{drawn}[prefab.body]
{body}mass_kg = {mass!r}
inertia_kgm2 = {numbers(inertia)}
friction = {friction!r}
restitution = {restitution!r}
can_sleep = false
{extra}""")

    def entity(self, name, prefab, position, orientation=None, body=""):
        turned = f"orientation = {numbers(orientation)}\n" if orientation else ""
        moving = f"[entity.body]\n{body}" if body else ""
        self.parts.append(f'[[entity]]\nname = "{name}"\nprefab = "{prefab}"\n'
                          f"position_m = {numbers(position)}\n{turned}{moving}")

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
    scene.prefab("load", CUBE, mass, box_inertia(mass, (1, 1, 1)), 0.6)
    scene.entity("lower", "cube", (0.0, 0.5, 0.0))
    scene.entity("upper", "load", (0.0, 1.5, 0.0))
    return scene


def chain(name, about, along, size):
    """50 links of 0.4 m and 1 kg from an anchor at y = 30, a ball of 100 kg at the end."""
    scene = Scene(name, about, (22, 26, 30), (5, 24, 0))
    untouched = "collides_with = []\n"
    scene.parts.append("""[[entity]]
name = "anchor"
position_m = [0, 30, 0]
primitive = { sphere = 0.05 }
[entity.body]
kind = "static"
friction = 0.6
restitution = 0
collides_with = []
""")
    scene.prefab("link", f"box = {numbers(size)}", 1.0, box_inertia(1.0, size), 0.6, extra=untouched)
    scene.prefab("weight", "sphere = 0.25", 100.0, ball_inertia(100.0, 0.25), 0.6, extra=untouched)

    def at(distance):
        return [0.0 + along[0] * distance, 30.0 + along[1] * distance, 0.0]

    names = ["anchor"] + [f"link_{i}" for i in range(50)] + ["ball"]
    for i in range(50):
        scene.entity(names[i + 1], "link", at(0.4 * i + 0.2))
    scene.entity("ball", "weight", at(50 * 0.4 + 0.25))
    for i in range(51):
        scene.ball_joint(names[i + 1], names[i], at(0.4 * i))
    return scene


def ball_on_ground(name, about, friction, restitution, mass, place, body):
    scene = Scene(name, about, (4, 4, 16), (place[0], 2, place[2]))
    scene.ground(friction, restitution)
    scene.prefab("ball", "sphere = 0.5", mass, ball_inertia(mass, 0.5), friction, restitution)
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
    bar, stem = (1.0, 0.2, 0.2), (0.2, 0.4, 0.2)
    bar_mass, stem_mass = DENSITY_KGPM3 * math.prod(bar), DENSITY_KGPM3 * math.prod(stem)
    mass = bar_mass + stem_mass
    # Along y: the bar's centre at 0, the stem's 0.3 below it; reduced mass about the common centre.
    apart = bar_mass * stem_mass / mass * 0.3 * 0.3
    inertia = [a + b for a, b in zip(box_inertia(bar_mass, bar), box_inertia(stem_mass, stem))]
    inertia[0] += apart
    inertia[2] += apart
    scene.prefab("handle", "box = [1, 0.6, 0.2]", mass, inertia, 0.6,
                 extra="angular_velocity_radps = [0.01, 5, 0.01]\ncollides_with = []\n")
    scene.entity("handle", "handle", (0.0, 0.0, 0.0))
    return scene


def s666():
    scene = Scene("s666", "6 x 6 x 6 frictionless balls fall and run apart", (3, 2, 4), (0, 0.5, 0))
    scene.ground(0.0)
    scene.prefab("ball", "sphere = 0.1", 10.0, ball_inertia(10.0, 0.1), 0.0)
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
    scene.prefab("stone", f"hull_m = [{', '.join(points)}]", mass, inertia, 0.6, looks=False)
    for i in range(15):
        angle = half + 2 * half * i
        turn = (angle - math.pi / 2) / 2
        scene.entity(f"stone_{i}", "stone", (centre * math.cos(angle), centre * math.sin(angle), 0.0),
                     (math.cos(turn), 0.0, 0.0, math.sin(turn)))
    return scene


def cards():
    """A house of 40 cards; neighbours start about 2 mm inside each other."""
    scene = Scene("cards", "A house of 40 cards", (0.9, 1, 3), (0.8, 0.8, 0))
    scene.ground(0.7)
    mass = DENSITY_KGPM3 * math.prod(SIZE_M)
    scene.prefab("card", f"box = {numbers(SIZE_M)}", mass, box_inertia(mass, SIZE_M), 0.7)
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
