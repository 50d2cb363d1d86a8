"""Hard cases of effects that bodies feel: rope, water, belt, magnets, vehicle, cloth, soft body, explosion (E04 to E11)."""
import math

from hard_scene import Scene, ball, box, about_x, numbers

G = 9.81


def hoisted():
    scene = Scene("E04", "a thousand kilograms on a rope of one",
                  "A load of 1000 kg hangs on a rope of 1 kg and swings from 25 degrees: the rope may not grow longer by "
                  "2 cm in 3 m, nor the swing gain energy.",
                  "Jolt #1171: long ropes with heavy ends stretch and shake", 20, (5, 2.5, 6), (0, 2, 0))
    scene.ground()
    length, angle = 3.0, math.radians(25)
    x, y = length * math.sin(angle), 4.5 - length * math.cos(angle)
    scene.body("load", ball(0.3), (x, y, 0), 1000.0, material="iron")
    scene.parts.append(f'[[rope]]\nname = "rope"\na = "world"\nb = "load"\nanchor_a_m = [0.0, 4.5, 0.0]\nanchor_b_m = {numbers((x, y, 0))}\n'
                       'mass_kg = 1.0\nradius_m = 0.02\npieces = 20\nmaterial = "rope"\n')
    scene.rule("height_m", "load", above=4.5 - length - 0.02)
    return scene


def pond():
    scene = Scene("E05", "a gram and a thousand tonnes in one pond",
                  "A cork of 1 g, a barge of 1000 t and a ball that falls in at 50 m/s: the cork and the barge float where "
                  "Archimedes says, and the ball comes back up and lies still.",
                  "godot #106894: light bodies fly out of the water", 20, (26, 14, 34), (0, -1, 0), kill=-100)
    scene.fixed("bed", box(80, 1, 80), (0, -30.5, 0), shadow=False)
    scene.parts.append('[[water]]\nname = "pond"\nmin_m = [-40.0, -30.0, -40.0]\nmax_m = [40.0, 0.0, 40.0]\n')
    scene.body("cork", box(0.1, 0.1, 0.1), (-14, 0.04, 4), 0.001, material="paint_orange")
    scene.parts.append('[[entity]]\nname = "barge"\nposition_m = [4.0, 0.0, -4.0]\nprimitive = { box = [20.0, 5.0, 20.0] }\n'
                       'material = "wood"\n[entity.body]\ndensity_kgpm3 = 500.0\nfriction = 0.5\ncan_sleep = false\n')
    scene.body("diver", ball(0.2), (-14, 1, 8), 10.0, velocity=(0, -50, 0), material="paint_blue")
    scene.rule("height_m", "cork", near=(0.05 - 0.1 * 0.001, 0.005), from_s=15)
    scene.rule("height_m", "barge", near=(2.5 - 2.5, 0.01))
    # A ball that floats: the cap under water weighs as much as the ball, to be found by bisection.
    low, high = 0.0, 0.4
    for _ in range(60):
        deep = (low + high) / 2
        low, high = (deep, high) if 1000 * math.pi * deep ** 2 * (0.2 - deep / 3) < 10 else (low, deep)
    scene.rule("height_m", "diver", near=(0.2 - low, 0.01), from_s=15)
    return scene


def belt():
    scene = Scene("E06", "a belt at a hundred metres a second",
                  "A crate is put on a belt that runs at 100 m/s: friction speeds it up by mu g and does nothing else.",
                  "conveyors made by moving the surface's body fling what lies on them", 3, (30, 8, 24), (12, 0, 0), kill=-10,
                  energy_from="the belt")
    scene.fixed("belt", box(120, 1, 4), (50, -0.5, 0), friction=0.5, body="surface_velocity_mps = [100.0, 0.0, 0.0]\n")
    scene.body("crate", box(0.8, 0.5, 0.8), (0, 0.25, 0), 20.0, material="paint_orange")
    scene.rule("x_m", "crate", near=(0.5 * 0.5 * G * 3.0 ** 2, 0.4), from_s=2.99)
    scene.rule("lowest_m", "crate", above=-0.01)
    scene.rule("height_m", "crate", below=0.27)
    return scene


def poles():
    scene = Scene("E07", "magnets that snap together",
                  "Six magnets afloat turn, meet and stick: momentum, angular momentum and energy, that of their field "
                  "included, are kept or lost, never gained.",
                  "two dipoles at distance zero: 1 / r^4", 8, (0, 2, 6), (0, 1, 0), gravity=(0, 0, 0), kill=-100,
                  energy_scale=1.0)
    scene.ground(top=-50)
    for i in range(6):
        a = math.pi * i / 3
        scene.body(f"magnet_{i}", box(0.12, 0.12, 0.3), (0.7 * math.cos(a), 1 + 0.05 * i, 0.7 * math.sin(a)), 1.0,
                   material="paint_orange" if i % 2 else "paint_blue", turn=about_x(0.4 * i),
                   more="magnet = { moment_Am2 = [0.0, 0.0, 60.0] }\n")
    scene.rule("momentum_change", below=1e-3)
    scene.rule("kinetic_J", below=0.2, from_s=7)
    return scene


def overturned():
    scene = Scene("E08", "a cart that lands on its roof at two hundred metres a second",
                  "A cart slides on its roof at 200 m/s with its wheels turning in the air: it slows down by friction, stays above "
                  "the ground and in one piece.",
                  "raycast vehicles push what is above them; suspensions explode when turned over", 6, (40, 20, 60), (60, 0, 0),
                  kill=-10)
    scene.fixed("plain", box(4000, 2, 400), (1500, -1, 0), friction=0.6, shadow=False)
    scene.body("chassis", box(1.4, 0.4, 3), (0, 0.25, 0), 400.0, friction=0.6, turn=(0, 0, 0, 1.0), velocity=(200, 0, 0))
    wheels = ", ".join(f"{{ position_m = [{x}, -0.3, {z}] }}" for x in (-0.8, 0.8) for z in (-1.2, 1.2))
    scene.parts.append(f'[[vehicle]]\nname = "cart"\nbody = "chassis"\nmaterial = "iron"\nwheels = [{wheels}]\n')
    scene.rule("lowest_m", "chassis", above=-0.05)
    scene.rule("height_m", "chassis", below=3.0)
    scene.rule("max_joint_error_m", below=0.02)
    return scene


def trampoline():
    scene = Scene("E09", "a hundred kilograms on a sheet",
                  "A ball of 100 kg falls on a sheet of 1 kg held by its four corners: it may not come through, and loses its bounce.",
                  "Obi, PhysX: heavy bodies sink through light cloth", 8, (3.5, 2.6, 4.2), (0, 1, 0))
    scene.ground()
    scene.body("ball", ball(0.3), (0, 2.3, 0), 100.0, material="iron")
    pins = ", ".join(f"{{ at = [{x}, {y}] }}" for x in (0, 1) for y in (0, 1))
    scene.parts.append('[[cloth]]\nname = "sheet"\nsize_m = [2.0, 2.0]\nposition_m = [0.0, 1.6, 0.0]\nrotation_deg = [-90.0, 0.0, 0.0]\n'
                       'cells = [20, 20]\ndensity_kgpm2 = 0.25\nstretch_Npm = 40000.0\nthickness_m = 0.02\ndamping_s = 0.1\ndrag = 0.0\n'
                       f'material = "linen"\npins = [{pins}]\n')
    scene.rule("lowest_m", "ball", above=0.3)
    scene.rule("kinetic_J", below=20.0, from_s=7)
    return scene


def pressed():
    scene = Scene("E10", "a tonne on a cushion of ten kilograms",
                  "A block of 1 t is put on a soft body of 10 kg: it sinks in as far as stress and stiffness say, between a "
                  "cushion that is free to bulge and one that is not, and no further.",
                  "soft bodies invert under loads of a hundred times their weight", 8, (3.4, 2, 3.8), (0, 0.5, 0))
    scene.ground(0.8)
    scene.parts.append('[[soft]]\nname = "cushion"\nprimitive = { box = [1.0, 0.5, 1.0] }\nposition_m = [0.0, 0.26, 0.0]\ncell_m = 0.25\n'
                       'density_kgpm3 = 20.0\nyoung_Pa = 2e5\npoisson = 0.3\ndamping_s = 0.004\nfriction = 0.8\nmaterial = "cloth"\n')
    scene.body("block", box(1.1, 1.0, 1.1), (0, 1.02, 0), 1e3, friction=0.8, material="stone")
    # p / E, less where it cannot bulge: p (1 + n) (1 - 2 n) / (E (1 - n)).
    free = 0.5 * 1e3 * G / 2e5
    held = free * 1.3 * 0.4 / 0.7
    scene.rule("height_m", "block", near=(1.0 - (free + held) / 2, (free - held) / 2 + 0.01), from_s=7)
    scene.rule("lowest_m", "block", above=0.3)
    return scene


def blast():
    scene = Scene("E11", "a charge in the middle of a body, and three hundred around it",
                  "A charge goes off in the very centre of a block, which stays where it is; another above it, with 300 crates in "
                  "reach, none of which goes through the ground.",
                  "1 / distance at distance zero", 4, (14, 8, 18), (0, 0, 0), energy_from="the charges", kill=-20)
    scene.ground()
    scene.body("core", box(1, 1, 1), (0, 0.5, 0), 50.0, material="iron")
    scene.prefab("crate", box(0.3, 0.3, 0.3), 5.0, sleep=True)
    for ring in range(6):
        for i in range(50):
            a = 2 * math.pi * (i + 0.5 * (ring % 2)) / 50
            r = 4.0 + ring * 0.8
            scene.place(f"crate_{ring}_{i}", "crate", (r * math.cos(a), 0.15, r * math.sin(a)))
    scene.parts.append('[[explosion]]\nname = "charge"\nat_s = 0.5\nposition_m = [0.0, 0.5, 0.0]\nimpulse_Ns = 4000.0\nreach_m = 30.0\n')
    scene.parts.append('[[explosion]]\nname = "second"\nat_s = 1.5\nposition_m = [0.0, 3.0, 0.0]\nimpulse_Ns = 4000.0\nreach_m = 30.0\n')
    scene.rule("displacement_m", "core", below=0.02, to_s=1.5)
    scene.rule("lowest_m", "core", above=-0.02)
    return scene


def scenes():
    return [hoisted(), pond(), belt(), poles(), overturned(), trampoline(), pressed(), blast()]
