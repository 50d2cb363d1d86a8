"""Hard cases H74 to H87: carried, spinning, heaped, sleeping."""
import math
import random

from hard_scene import Scene, about_z, ball, box, capsule

G = 9.81


def crusher():
    scene = Scene("H74", "a crusher",
                  "A plate comes down until 5 cm too little room is left for the box, and goes up again: "
                  "nothing is shot out, not even afterwards.",
                  "expected of any solver that turns penetration into speed", 9, (4, 3, 7), (0, 1.2, 0), shadow=15,
                  settled=5, unsettled="the plate leaves 5 cm less room than the box is high",
                  energy_from="the plate")
    scene.ground()
    scene.kinematic("plate", box(3, 0.5, 3), (0, 2.25, 0), material="rustmetal",
                  motion="points_m = [[0, 0, 0], [0, -1.05, 0]], period_s = 8")
    scene.body("box", box(1, 1, 1), (0, 0.5, 0))
    scene.rule("speed_mps", "box", below=6)
    scene.rule("speed_mps", "box", below=3, from_s=4.5)
    scene.rule("drift_m", "box", below=0.5)
    return scene


def lift():
    scene = Scene("H75", "a lift that stops at once",
                  "Five boxes ride up at 3 m/s, are stopped at once, hop and land, then go down at 5 m/s: the "
                  "stack stays.",
                  "expected: what a kinematic body's velocity means differs between engines", 6.9,
                  (10, 10, 16), (0, 8, 0), shadow=50, energy_from="the lift")
    scene.ground()
    scene.kinematic("lift", box(4, 1, 4), (0, 5.5, 0), material="rustmetal")
    for i in range(5):
        scene.body(f"box_{i}", box(1, 1, 1), (0, 6.5 + i, 0))
    for at_s, speed in ((1, 3.0), (3, 0.0), (5.15, -5.0)):
        scene.event("velocity", "lift", at_s, value=(0, speed, 0))
    scene.rule("displacement_m", to="lift", below=0.02, to_s=2.9)
    scene.rule("displacement_m", to="lift", below=0.05, from_s=4.5, to_s=5)
    scene.rule("displacement_m", to="lift", below=0.05, from_s=6.8)
    return scene


def turntables():
    limit = math.sqrt(0.5 * G / 2)
    scene = Scene("H76", "two turntables, one just too fast",
                  "A box 2 m from the axis slips where the path asks for more than friction: on the "
                  "slower table it stays, on the one 3 % above the limit it goes.",
                  "expected: friction that does not see outer torques", 6, (0, 7, 13), (0, 0.4, 0),
                  energy_from="the tables")
    scene.ground()
    for name, x, share in (("slow", -4.5, 0.97), ("fast", 4.5, 1.03)):
        rate = share * limit
        scene.kinematic(f"table_{name}", "cylinder = [4, 0.4]", (x, 0.2, 0), material="stone",
                      motion=f"points_m = [], spin_degps = [0, {math.degrees(rate):.9g}, 0]")
        scene.body(f"box_{name}", box(0.25, 0.25, 0.25), (x + 2, 0.525, 0), velocity=(0, 0, -2 * rate),
                   spin=(0, rate, 0), material="paint_orange")
    scene.rule("from_axis_m", "box_slow", to="table_slow", below=2.02)
    scene.rule("from_axis_m", "box_fast", to="table_fast", above=2.1, from_s=6)
    return scene


def turning_mesh():
    rate = 0.5
    scene = Scene("H77", "a box on a turning mesh",
                  "A mesh of triangles turns about its middle; a box 3 m out rides on it.",
                  "PEEL keeps it as BoxOnRotatingMesh", 12, (0, 8, 14), (0, 0, 0),
                  energy_from="the mesh")
    scene.ground(top=-0.5)
    scene.kinematic("mesh", 'model = "models/hard/seams.obj"', (0, 0, 0), material="flagstone",
                  motion=f"points_m = [], spin_degps = [0, {math.degrees(rate):.9g}, 0]")
    scene.body("box", box(1, 1, 1), (3, 0.5, 0), velocity=(0, 0, -3 * rate), spin=(0, rate, 0))
    scene.rule("from_axis_m", "box", near=(3, 0.05))
    return scene


def tops():
    scene = Scene("H78", "tops",
                  "Afloat, a plate tumbles at 10 rad/s, a rod spins at 500, 64 blocks turn every way: "
                  "energy and angular momentum stay for 10 s.",
                  "Bullet's explicit torque gains 17 %, its implicit one loses 13 % and 7 % of the "
                  "momentum [measured, 3.24]; PR #346, #357; Jolt #803; avian #993", 10, (2, 5, 12),
                  (0, 2.2, 0), gravity=(0, 0, 0), energy_gain=0.001)
    scene.ground()
    scene.body("plate", box(1, 0.6, 0.2), (-4, 2.2, 0), spin=(10, 1, 0), material="paint_orange")
    scene.body("rod", box(0.05, 1, 0.05), (4, 2.2, 0), spin=(5, 500, 0), material="paint_blue")
    scene.prefab("block", box(0.2, 0.3, 0.4), 1.0)
    rng = random.Random(78)
    for i in range(64):
        at = (0.7 * (i % 4) - 1.05, 1.2 + 0.7 * (i // 4 % 4), 0.7 * (i // 16) - 1.05)
        scene.place(f"block_{i}", "block", at, spin=tuple(rng.uniform(-6, 6) for _ in range(3)))
    scene.rule("energy_loss", below=0.001)
    scene.rule("angular_momentum_change", below=0.02)
    return scene


def bounce_house():
    scene = Scene("H80", "a bounce house",
                  "Afloat in a closed room, a ball, a capsule, a box and an octahedron bounce without loss "
                  "or friction: none gets faster, none gets out.",
                  "Box3D keeps it; Jolt PR #545; rapier #974, #919; bullet3 #1530, #4341", 20,
                  (14, 12, 26), (0, 9, 0), gravity=(0, 0, 0), energy_gain=0.001, shadow=60,
                  penetration=0.02)
    scene.ground(top=-0.1)
    for axis in range(3):
        for side in (-1, 1):
            at, size = [0.0, 10.0, 0.0], [24, 24, 24]
            at[axis] += side * 11
            size[axis] = 2
            scene.fixed(f"wall_{'xyz'[axis]}{side}", box(*size), tuple(at), hidden=True, friction=0.0,
                        restitution=1.0)
    points = "hull_m = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]"
    # The octahedron is seen as the ball that fits into it.
    things = (("ball", ball(0.5), "", (10, 20, 5)), ("capsule", capsule(0.5, 1), "", (-12, 15, 7)),
              ("box", box(1, 1, 1), "", (9, -14, 12)), ("octahedron", ball(0.577), points, (-7, 9, -16)))
    for i, (name, shape, own, velocity) in enumerate(things):
        scene.body(name, shape, (4.0 * (i % 2) - 2, 10, 4.0 * (i // 2) - 2), friction=0.0, restitution=1.0,
                   velocity=velocity, own_shape=own,
                   material=("paint_blue", "paint_orange", "wood", "paint_cream")[i])
    scene.rule("energy_loss", below=0.05)
    scene.rule("x_m", near=(0, 10))
    scene.rule("height_m", near=(10, 10))
    return scene


def confined():
    scene = Scene("H81", "balls crammed into a box, afloat",
                  "Sixty-four balls start a tenth inside each other in a box that just has room for them: "
                  "within 10 s they lie still.",
                  "Box2D keeps Confined, Rush", 12, (5, 5, 9), (0, 2, 0), gravity=(0, 0, 0),
                  settled=10, unsettled="they start a tenth inside each other and have 10 s to part",
                  energy_scale=64 * 4.5,  # all of them at 3 m/s
                  energy_from="the penetration at the start")
    scene.ground(top=-0.21)
    room = 4.2
    for axis in range(3):
        for side in (-1, 1):
            at, size = [0.0, 2.1, 0.0], [room + 0.4] * 3
            at[axis] += side * (room / 2 + 0.1)
            size[axis] = 0.2
            scene.fixed(f"wall_{'xyz'[axis]}{side}", box(*size), tuple(at), material="glass", shadow=False)
    scene.prefab("ball", ball(0.5), material="paint_blue")
    scene.array("ball", "ball", (-1.35, 0.75, -1.35), (4, 4, 4), (0.9, 0.9, 0.9))
    scene.rule("speed_mps", below=0.05, from_s=10)
    return scene


def slope():
    angle = math.radians(20)
    scene = Scene("H84", "a box on a slope of 20 degrees",
                  "Friction of 0.5 holds it: in a minute awake it may creep by 0.1 mm.",
                  "Bullet creeps by 0.13 mm in 10 s [measured, 3.24]", 60, (3, 2.5, 5), (0, 0.6, 0),
                  shadow=12, energy_scale=G)
    scene.ground()
    scene.fixed("slope", box(6, 0.4, 3), (0, 1, 0), turn=about_z(-angle), material="stone")
    out = 0.7
    scene.body("box", box(1, 1, 1), (out * math.sin(angle), 1 + out * math.cos(angle), 0),
               turn=about_z(-angle))
    scene.rule("drift_m", below=1e-4 * math.cos(angle))  # along the slope
    return scene


def rolling():
    radius, length, speed = 0.5, 0.02, 2.0
    way = speed ** 2 / (2 * length * G / (1.4 * radius))
    spin, spin_loss = 10.0, 0.02 * G / (0.4 * radius ** 2)
    scene = Scene("H85", "rolling and spinning friction",
                  f"A ball with rolling friction stops after {way:.2f} m, one with spinning friction after "
                  f"{spin / spin_loss:.2f} s, both within 5 %.",
                  "Bullet #4188, #2117, #2138: the torque is capped", 12, (4, 4, 9), (2.5, 0.4, 0))
    scene.ground()
    scene.body("roller", ball(radius), (0, radius, 0), velocity=(speed, 0, 0), spin=(0, 0, -speed / radius),
               material="paint_blue", more=f"rolling_friction = {length}\n")
    scene.body("spinner", ball(radius), (2, radius, 2), spin=(0, spin, 0), material="paint_orange",
               more="spinning_friction = 0.02\n")
    scene.rule("x_m", "roller", near=(way, 0.05 * way), from_s=11)
    scene.rule("speed_mps", "roller", below=0.001, from_s=11)
    scene.rule("spin_radps", "spinner", above=0.05, to_s=0.95 * spin / spin_loss)
    scene.rule("spin_radps", "spinner", below=0.05, from_s=1.05 * spin / spin_loss)
    return scene


def slow():
    scene = Scene("H86", "slow things that may not freeze",
                  "A box slides at 0.1 m/s, a ball rolls at 0.05, another spins at 0.5 rad/s, a rod stands "
                  "a thousandth off its balance: all may sleep, none may.",
                  "Bullet sends to sleep below 0.8 m/s and 1 rad/s after 2 s [from its code]", 20,
                  (1.5, 3.5, 8), (0.5, 1, 0))
    scene.ground(0.5)
    scene.fixed("ice", box(6, 0.2, 1.6), (0, 0.1, 2), material="paint_cream", friction=0.0)
    scene.body("slider", box(1, 1, 1), (-1, 0.7, 2), friction=0.0, velocity=(0.1, 0, 0), sleep=True)
    scene.body("roller", ball(0.5), (0, 0.5, 0), velocity=(0.05, 0, 0), spin=(0, 0, -0.1), sleep=True,
               material="paint_blue")
    scene.body("spinner", ball(0.5), (2, 0.7, 2), friction=0.0, spin=(0, 0.5, 0), sleep=True,
               material="paint_orange")
    off = 1e-3
    scene.scenery("pin", ball(0.08), (-3, 2, 0), "iron")
    scene.body("rod", box(0.1, 1, 0.1), (-3 + 0.5 * math.sin(off), 2 + 0.5 * math.cos(off), 0),
               turn=about_z(-off), sleep=True)
    scene.joint("hinge", "rod", "world", (-3, 2, 0), axis=(0, 0, 1))
    scene.rule("x_m", "slider", near=(1, 0.02), from_s=20)
    scene.rule("x_m", "roller", near=(1, 0.02), from_s=20)
    scene.rule("spin_radps", "spinner", near=(0.5, 0.005))
    scene.rule("lowest_m", "rod", below=2, from_s=12)
    return scene


def sleepers():
    scene = Scene("H87", "sleepers that must wake at once",
                  "Three stacks sleep. One loses its support, one gets a push, then gravity turns: each "
                  "wakes within a step.",
                  "Bullet #554: a force does not wake, neighbours are not woken", 16, (6, 5, 11),
                  (0, 2, 0), energy_from="gravity, which is turned upwards at 14 s")
    scene.ground()
    for s, x in enumerate((-4, 0, 4)):
        scene.fixed(f"block_{s}", box(2, 1, 2), (x, 0.5, 0), material="stone")
        for i in range(3):
            scene.body(f"stack_{s}_{i}", box(1, 1, 1), (x, 1.5 + i, 0), sleep=True)
    scene.event("remove", "block_0", 10)
    scene.event("impulse", "stack_1_2", 12, value=(1, 0, 0))
    scene.event("gravity", "", 14, value=(0, 2, 0))
    woken = 0.05  # a step at 30 Hz and a bit
    scene.rule("awake", below=0.5, from_s=9, to_s=9.9)
    scene.rule("awake", "stack_0_*", above=0.5, from_s=10 + woken, to_s=10.2)
    fallen = 0.5 * G * 0.25 ** 2
    scene.rule("sag_m", "stack_0_*", near=(fallen, 0.1 * fallen), from_s=10.25, to_s=10.25)
    scene.rule("awake", "stack_1_*", above=0.5, from_s=12 + woken, to_s=12.2)
    scene.rule("awake", "stack_2_*", above=0.5, from_s=14 + woken, to_s=14.2)
    scene.rule("height_m", "stack_2_*", above=2.4, from_s=15.5)
    return scene


def scenes():
    yield crusher()
    yield lift()
    yield turntables()
    yield turning_mesh()
    yield tops()
    yield bounce_house()
    yield confined()
    yield slope()
    yield rolling()
    yield slow()
    yield sleepers()
