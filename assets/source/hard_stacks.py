"""Hard cases H01 to H25: stacks and mass ratios."""
import math
import random

from card_house import SIZE_M, card_house
from hard_scene import Scene, about_x, about_y, about_z, ball, box, capsule, cylinder


def tower(name, title, masses, shows, known, seconds, *, sag, drift, speed=0.005, tier="ci"):
    high = len(masses)
    scene = Scene(name, title, shows, known, seconds,
                  (0.7 * high + 1.5, 0.6 * high + 1, 1.1 * high + 2), (0, 0.48 * high, 0),
                  tier=tier)
    scene.ground()
    for i, mass in enumerate(masses):
        scene.body(f"box_{i}", box(1, 1, 1), (0, 0.5 + i, 0), mass,
                   material="wood" if mass < 50 else "rustmetal")
    scene.rule("drift_m", below=drift)
    scene.rule("sag_m", f"box_{high - 1}", below=sag)
    if speed:
        scene.rule("speed_mps", below=speed, from_s=5)
    return scene


def towers():
    yield tower("H01", "a tower of ten", [1.0] * 10,
                "Ten boxes exactly on each other: the solver must carry the weight of nine through one.",
                "Bullet's default leans by 0.65 m at 0.11 m/s [measured, 3.24]", 10, sag=0.2, drift=0.01)
    yield tower("H02", "a tower of twenty", [1.0] * 20,
                "Twenty boxes exactly on each other, for a minute.",
                "Bullet with 10 iterations falls at 4.95 s, with 50 it leans 2.07 m; NNCG falls at 7.3 s, "
                "Dantzig at 4.97 s [measured, 3.24]", 60, sag=0.4, drift=0.01)
    yield tower("H03", "a tower of forty", [1.0] * 40,
                "Forty boxes exactly on each other, for a minute.",
                "Bullet's detector: more than 7 boxes exploded (dart #867)", 60, sag=0.8, drift=0.01)
    yield tower("H04", "a hundredfold load on four boxes", [1, 1, 1, 1, 100.0],
                "Four light boxes carry one of a hundred times their mass.",
                "Bullet with 10 iterations collapses at 0.5 s, with 50 at 3.55 s; Dantzig at 0.63 s; soft "
                "contacts capped at 30 Hz at 4.8 s; Lemke explodes [measured, 3.24]",
                10, sag=0.1, drift=0.01)
    yield tower("H05", "a thousandfold load on one box", [1, 1000.0],
                "A light box carries one of a thousand times its mass, for a minute.",
                "Bullet is crushed at 0.38 s at 60 Hz, 1.78 s at 240 Hz, 5.77 s at 480 Hz; Dantzig at "
                "1.18 s [measured, 3.24]", 60, sag=0.1, drift=0.01)
    yield tower("H24", "light and heavy by turns", [1, 100.0] * 3,
                "Six boxes, every second one a hundred times as heavy as the one below it.",
                "Bullet with 10 iterations falls at 0.43 s, with 50 at 4.98 s; at 240 Hz it leans 0.6 m "
                "[measured, 3.24]; experiments#4", 10, sag=0.6, drift=0.01)


def huge():
    scene = Scene("H08", "a giant on two small boxes",
                  "A box of 20 m and 8000 kg stands on two of 1 m and 1 kg near its edges.",
                  "Box2D keeps it as HighMassRatio2 and 3", 20, (32, 14, 42), (0, 9, 0),
                  penetration=0.2, shadow=90)
    scene.ground()
    scene.body("small_left", box(1, 1, 1), (-9, 0.5, 0), material="paint_orange")
    scene.body("small_right", box(1, 1, 1), (9, 0.5, 0), material="paint_orange")
    scene.body("huge", box(20, 20, 20), (0, 11, 0), 8000.0, material="stone")
    scene.rule("displacement_m", "small_*", below=0.1)
    scene.rule("sag_m", "huge", below=0.3)
    return scene


def pyramid(name, base, shows, known, seconds, mean_m, tier):
    scene = Scene(name, f"a pyramid {base} wide", shows, known, seconds,
                  (0.35 * base, 0.45 * base + 1, 1.25 * base), (0, 0.4 * base, 0), tier=tier,
                  shadow=40 if base < 50 else 160)
    scene.ground()
    scene.prefab("cube", box(1, 1, 1))
    for row in range(base):
        wide = base - row
        scene.array(f"row_{row}", "cube", (-0.525 * (wide - 1), 0.5 + row, 0), (wide, 1, 1), (1.05, 1, 1))
    scene.rule("mean_displacement_m", below=mean_m)
    scene.rule("drift_m", f"row_{base - 1}.0.0.0", below=0.5)
    if base < 50:
        scene.rule("speed_mps", below=0.005, from_s=5)
    return scene


def kapla(name, seconds, tier):
    """Storeys of three lines of two planks on edge, each storey across the one below."""
    scene = Scene(name, f"forty-eight planks for {seconds} s",
                  "A tower of thin planks on edge, eight storeys of six, without glue. The planks are "
                  "SimBenchmark's Kapla planks; how they stand is ours.",
                  "SimBenchmark: Bullet 52 steps with 10 iterations, 846 with 100; DART 17; RaiSim needs "
                  "1000", seconds, (0.9, 0.75, 1.3), (0, 0.36, 0), tier=tier,
                  penetration=0.001, player=(0.9, 0, 2.2), shadow=8)
    scene.ground()
    scene.prefab("plank", box(0.2, 0.1, 0.05), 0.7)
    for storey in range(8):
        for line in (-1, 0, 1):
            for end in (-1, 1):
                along, across = 0.1 * end, 0.17 * line
                at = (along, across) if storey % 2 == 0 else (across, along)
                scene.place(f"plank_{storey}_{line + 1}_{(end + 1) // 2}", "plank",
                            (at[0], 0.05 + 0.1 * storey, at[1]),
                            about_y(math.pi / 2) if storey % 2 else None)
    scene.rule("displacement_m", below=0.02)
    scene.rule("speed_mps", below=0.005, from_s=5)
    return scene


def cards():
    scene = Scene("H15", "a house of forty cards",
                  "Forty cards of 2 mm lean on each other by friction alone; neighbours start 2 mm inside "
                  "each other.",
                  "PEEL and Box2D keep it as CardHouse", 10, (1.6, 1.2, 3.0), (0.85, 0.8, 0),
                  penetration=0.002, shadow=10,
                  energy_from="the penetration of the cards at the start")
    scene.ground(0.7)
    scene.prefab("card", box(*SIZE_M), 1000 * math.prod(SIZE_M), friction=0.7, material="paint_cream")
    cards = list(card_house())
    for i, (x, y, angle_deg) in enumerate(cards):
        scene.place(f"card_{i}", "card", (x, y, 0), about_z(math.radians(angle_deg)))
    scene.rule("sag_m", [f"card_{len(cards) - 2}", f"card_{len(cards) - 1}"], below=0.05)
    return scene


def dominoes():
    scene = Scene("H17", "a double row of dominoes",
                  "Two rows of fifteen tall dominoes, the first of each pushed: all fall, none flies.",
                  "Box2D keeps it as DoubleDomino, PEEL for the drift of dominoes", 15, (5, 5, 12),
                  (0, 0.5, 0.5), penetration=0.005)
    scene.ground(0.6)
    scene.prefab("domino", box(0.25, 1, 0.5), 0.25, friction=0.6, material="paint_orange")
    for row in range(2):
        for i in range(15):
            scene.place(f"domino_{row}_{i}", "domino", (1.01 * i * 0.7 - 5, 0.5, 1.2 * row))
        scene.event("impulse", f"domino_{row}_0", 0.5, value=(0.2, 0, 0), point_m=(0, 0.5, 0))
    scene.rule("tilt_deg", above=25, from_s=15)
    scene.rule("speed_mps", below=10)
    return scene


def rounds():
    scene = Scene("H18", "capsules across each other, cylinders on end",
                  "Ten lying capsules in five crossed pairs, which only rolling friction holds, and a "
                  "column of twenty cylinders on their flat ends.",
                  "PEEL keeps CapsuleStack, Box3D CylinderStack", 10, (12, 8, 20), (0, 7, 0))
    scene.ground()
    scene.prefab("log", capsule(0.4, 2), material="bark", more="rolling_friction = 0.02\n")
    for i in range(10):
        side, layer = 0.8 * (2 * (i % 2) - 1), i // 2
        across = layer % 2 == 1
        # A capsule lies along z, or along x on every second layer.
        scene.place(f"log_{i}", "log", (-4 + (0 if across else side), 0.4 + 0.8 * layer,
                                        side if across else 0),
                    about_z(math.pi / 2) if across else about_x(math.pi / 2))
    scene.prefab("drum", cylinder(0.5, 0.75), material="rustmetal")
    for i in range(20):
        scene.place(f"drum_{i}", "drum", (3, 0.375 + 0.75 * i, 0))
    scene.rule("sag_m", ["log_8", "log_9", "drum_19"], below=0.1)
    scene.rule("drift_m", "drum_*", below=0.05)
    return scene


def column():
    scene = Scene("H19", "a column of ten balls",
                  "Ten balls exactly on each other: they may come down, but nothing may make them jump.",
                  "PEEL keeps it as StackedSpheres", 10, (7, 6, 12), (0, 4.8, 0),
                  energy_gain=0.001)
    scene.ground()
    for i in range(10):
        scene.body(f"ball_{i}", ball(0.5), (0, 0.5 + i, 0),
                   material="paint_blue" if i % 2 else "paint_orange")
    scene.rule("up_speed_mps", below=0.1, to_s=2)
    return scene


def tube():
    scene = Scene("H20", "twenty balls in a tube under a piston",
                  "A tight tube keeps twenty balls of 1 kg upright under a piston of 100 kg.",
                  "expected of Bullet: slow to converge (PR #2145)", 10, (14, 12, 24), (0, 10, 0))
    scene.ground()
    inner = 1.02
    for side in (-1, 1):
        at = side * (inner / 2 + 0.1)
        scene.fixed(f"wall_x{side}", box(0.2, 24, 1.42), (at, 12, 0), material="glass", shadow=False)
        scene.fixed(f"wall_z{side}", box(1.42, 24, 0.2), (0, 12, at), material="glass", shadow=False)
    for i in range(20):
        scene.body(f"ball_{i}", ball(0.5), (0.001 * (i % 2), 0.5 + i, 0.001 * (i % 3)),
                   material="paint_blue" if i % 2 else "paint_orange")
    scene.body("piston", box(1, 1, 1), (0, 20.5, 0), 100.0, material="rustmetal")
    scene.rule("sag_m", "piston", below=0.4)
    scene.rule("speed_mps", below=0.01, from_s=8)
    return scene


def pile():
    scene = Scene("H22", "a pile of 512 boxes",
                  "Eight by eight by eight boxes fall by their gaps and come to rest.",
                  "Bullet keeps 5.76 J and 4 cm of penetration; at 240 Hz 2.27 J [measured, 3.24]", 6,
                  (13, 9, 16), (0, 3.5, 0))
    scene.ground()
    scene.prefab("cube", box(1, 1, 1))
    for layer in range(8):  # a layer an array: bodies in the order x, z, y
        scene.array(f"layer_{layer}", "cube", (-3.85, 0.6 + 1.1 * layer, -3.85), (8, 1, 8),
                    (1.1, 1.1, 1.1))
    scene.rule("kinetic_J", below=0.1, from_s=5)
    scene.rule("penetration_m", below=0.02, from_s=5)
    return scene


def balls():
    scene = Scene("H23", "216 balls without friction",
                  "Six by six by six smooth balls of 10 kg fall and run apart. The sum of the squared "
                  "penetrations may be 1e-3 m2; no single one may be more than the root of that.",
                  "SimBenchmark at 100 Hz: Bullet 37 m2, MuJoCo 0.37 m2, DART endless", 5,
                  (3, 2, 4.4), (0, 0.6, 0.5), penetration=0.004, shadow=12,
                  settled=2.5, unsettled="the row's own limit holds: 0.0316 m")
    scene.ground(0.0)
    scene.prefab("ball", ball(0.1), 10.0, friction=0.0, material="paint_blue")
    rng = random.Random(42)
    for i in range(216):
        x, z, y = i // 36, i // 6 % 6, i % 6
        scene.place(f"ball_{i}", "ball", (-0.6 + 0.21 * x + 0.001 * rng.random(),
                                          1.101 + 0.21 * y + 0.001 * rng.random(),
                                          0.21 * z + 0.001 * rng.random()))
    scene.rule("penetration_m", below=0.0316)
    return scene


def impact():
    scene = Scene("H25", "a box meets one of a hundred times its mass",
                  "Afloat, 1 kg at 20 m/s meets 100 kg without bouncing: both go on at 20/101 m/s.",
                  "PEEL keeps it as HighMassRatioCollisions", 2, (1, 4, 9), (-0.5, 1.5, 0),
                  gravity=(0, 0, 0))
    scene.ground()
    scene.body("light", box(1, 1, 1), (-3, 1.5, 0), velocity=(20, 0, 0))
    scene.body("heavy", box(1, 1, 1), (0, 1.5, 0), 100.0, material="rustmetal")
    common = 20 / 101
    scene.rule("speed_x_mps", near=(common, 0.01 * common), from_s=1)
    scene.rule("speed_mps", "light", to="heavy", below=0.2, from_s=1)
    return scene


def scenes():
    yield from towers()
    yield huge()
    yield pyramid("H11", 20, "A wall of 210 boxes, twenty wide at its foot, keeps its shape.",
                  "Bullet at 60 Hz with 10 iterations moves by 4.75 cm [measured, 3.24]", 10, 0.02, "ci")
    yield pyramid("H12", 99, "A wall of 4950 boxes, 99 wide at its foot, stands for 1000 steps.",
                  "Box3D's author: the version with 80 falls after about 1000 steps", 16.7, 0.1,
                  "nightly")
    yield kapla("H14", 60, "ci")
    yield kapla("H14b", 600, "nightly")
    yield cards()
    yield dominoes()
    yield rounds()
    yield column()
    yield tube()
    yield pile()
    yield balls()
    yield impact()
