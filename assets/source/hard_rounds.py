"""Hard cases D05 to D11, D14, D15 and D17: cylinders, balls, long and thin boxes."""
import math

from hard_contacts import grid, model, write_obj
from hard_scene import Scene, about_x, about_y, about_z, ball, box, cylinder

G = 9.81
REST_MPS, REST_M = 0.002, 0.0005  # what rest means


def terrain(x, z):
    return 0.8 * math.sin(0.6 * x) * math.cos(0.5 * z)


def write_models(folder):
    for name, about, made in (("terrain_fine", "64 by 64 cells of 1 m", grid(64, 64, 1.0, terrain)),
                              ("terrain_coarse", "8 by 8 cells of 8 m", grid(8, 8, 8.0, terrain)),
                              ("lane", "114 by 4 flat cells of 1 m", grid(114, 4, 1.0, lambda x, z: 0.0))):
        write_obj(folder / f"{name}.obj", about, *made)


def beside_the_middle():
    scene = Scene("D05", "cylinders that land beside the middle",
                  "Upright cylinders fall 0.24 m onto tables, in the middle and up to 0.5 m beside it: each comes down "
                  "flat and stays where it landed.",
                  "google-deepmind/mujoco #420: 2.2.1 leaves it upright only in the exact middle, elsewhere it slides "
                  "off in any direction, gaining great velocity", 5, (5.6, 1.2, 3.9), (2.6, -0.2, 0.4),
                  player=(6.2, -0.6, 4.4), penetration=0.0024, shadow=30, kill=-5)
    scene.ground(1.0, top=-0.6)
    for row, x in enumerate((0, 0.05)):
        for column in range(6):
            at = (3.0 * column - 7.5, 3.0 * row - 1.5)
            scene.fixed(f"table_{row}_{column}", box(0.6, 0.6, 1.2), (at[0], -0.3, at[1]), friction=1.0)
            scene.body(f"cylinder_{row}_{column}", cylinder(0.06, 0.12), (at[0] + x, 0.3, at[1] + 0.1 * column), 1.357,
                       friction=1.0, material="paint_orange")
    scene.rule("tilt_deg", below=0.5)
    scene.rule("drift_m", below=REST_M)
    scene.rule("height_m", near=(0.06, 0.0024), from_s=2)
    return scene


def on_the_rim():
    scene = Scene("D06", "boxes on a drum's rim",
                  "Boxes of 0.4 m come down on a drum's end from 1 cm, 0.3, 0.45 and 0.55 m from its axis: two stay, the "
                  "third tips over the rim without a hop. Not judged: that it turns about the rim's chord first, but "
                  "it must not leave its plane; and that the energy never rises, but it must not pass its start.",
                  "godotengine/godot #38426 (Bullet): bounces and rolls for no apparent reason, fine on a box", 6,
                  (2.6, 2.4, 4.6), (0.3, 0.7, 0), penetration=0.004, energy_gain=1e-5, shadow=15)
    scene.ground(0.8)
    for i, out in enumerate((0.3, 0.45, 0.55)):
        x = 2.0 * i - 2
        scene.fixed(f"drum_{i}", cylinder(0.5, 1), (x, 0.5, 0), material="rustmetal", friction=0.8)
        scene.body(f"box_{('inside', 'near', 'over')[i]}", box(0.4, 0.2, 0.2), (x + out, 1.11, 0), 16.0, friction=0.8)
    scene.rule("drift_m", ["box_inside", "box_near"], below=0.001)
    scene.rule("up_speed_mps", "box_over", below=0.2)
    scene.rule("height_m", "box_over", below=0.3, from_s=4)
    scene.rule("z_m", "box_over", near=(0, 0.001), to_s=0.7)
    return scene


def batteries():
    scene = Scene("D07", "batteries on their sides",
                  "Ten cylinders of the size of AA batteries lie down at ten headings from 5 mm, ten stand up: all rest "
                  "within 1.5 s, less than 0.1 mm deep. Their tilt takes rolling along.",
                  "google-deepmind/mujoco_warp #1555: one contact point that alternates between the two ends each step: "
                  "sinks in and rocks", 5, (0.16, 0.3, 0.42), (0, 0.03, 0), penetration=0.0001,
                  player=(0, 0, 1.2), shadow=4)
    scene.ground()
    scene.fixed("board", box(0.5, 0.02, 0.5), (0, 0.01, 0), material="wood")
    for i in range(10):
        x, z = 0.085 * (i % 5) - 0.17, 0.09 * (i // 5)
        # A cylinder's axis is y: laid along z, then turned.
        lay, turn = about_x(math.pi / 2), about_y(math.radians(18 * i))
        scene.body(f"lying_{i}", cylinder(0.007, 0.05), (x, 0.032, z - 0.17), 0.023, material="paint_orange",
                   turn=(turn[0] * lay[0], turn[0] * lay[1], turn[2] * lay[0], -turn[2] * lay[1]),
                   more="rolling_friction = 0.0005\n")
        scene.body(f"standing_{i}", cylinder(0.007, 0.05), (x, 0.05, z + 0.06), 0.023, material="paint_blue",
                   more="rolling_friction = 0.0005\n")
    scene.rule("speed_mps", below=REST_MPS, from_s=1.5)
    scene.rule("drift_m", below=REST_M, from_s=1.5)
    scene.rule("tilt_deg", below=0.1, from_s=1.5)
    scene.rule("height_m", "lying_*", near=(0.027, 0.0001), from_s=1.5)
    scene.rule("height_m", "standing_*", near=(0.045, 0.0001), from_s=1.5)
    return scene


def still_points():
    scene = Scene("D08", "points that stay where they are",
                  "Two cylinders stand and two lie for 10 s: none moves by a micrometre a step, and each presses as it "
                  "weighs. Not judged: how far the points themselves move, and how many are warm-started.",
                  "Genesis-Embodied-AI/genesis-world PR #3245: the patch travels 15.2 and 22.6 mm a step", 10,
                  (0.12, 0.16, 0.3), (0, 0.02, 0), penetration=0.0008, player=(0, 0, 1.2), shadow=3)
    scene.ground()
    for i, (radius, high) in enumerate(((0.02, 0.04), (0.03, 0.06))):
        mass = 1000 * math.pi * radius ** 2 * high
        x = 0.1 * i - 0.05
        scene.body(f"standing_{i}", cylinder(radius, high), (x, high / 2, -0.04), mass, material="paint_blue")
        scene.body(f"lying_{i}", cylinder(radius, high), (x, radius, 0.05), mass, material="paint_orange",
                   turn=about_x(math.pi / 2))
        load = mass * G
        scene.rule("contact_force_N", [f"standing_{i}", f"lying_{i}"], near=(load, 0.05 * load), from_s=1)
    scene.rule("speed_mps", below=6e-5, from_s=1)
    scene.rule("drift_m", below=0.0001)
    return scene


def rolling_cylinders():
    slope = math.radians(10)
    way = 0.5 * 2 / 3 * G * math.sin(slope) * 9
    scene = Scene("D09", "cylinders that roll",
                  "A disc and a roller run down 10 degrees with 2/3 g sin; wheels at 20 m/s run 100 m over a box and over "
                  "a flat mesh. Not judged: the heading of what starts at rest and the lean of a wheel, but sideways way "
                  "and height, which follow from them.",
                  "Autodesk/synthesis #490: cylinder wheels hop when fast; godot #25468 (Bullet): a driven cylinder "
                  "dances; jrouwe/JoltPhysics PR #1539, #1540: flat cylinders sank and rolled oddly until March 2025", 5,
                  (50, 4, 15), (44, 0.8, -1), penetration=0.002, shadow=60, kill=-5)
    scene.ground(top=-0.5)
    scene.fixed("lane_box", box(114, 0.5, 3), (0, -0.25, 4), material="stone")
    scene.fixed("lane_mesh", model("lane"), (0, 0, 8.5), material="flagstone")
    # The slope's upper face begins 0.5 m up the hill from the cylinders.
    start = (34.0, 3.0)
    along, out = (math.cos(slope), -math.sin(slope)), (math.sin(slope), math.cos(slope))
    middle = tuple(start[i] + 8.5 * along[i] - (0.3 + 0.1) * out[i] for i in range(2))
    scene.fixed("slope", box(18, 0.2, 5), (middle[0], middle[1], -2.5), turn=about_z(-slope), material="wood")
    for name, wide, z in (("disc", 0.1, -0.8), ("roller", 2.0, -3.0)):
        scene.body(name, cylinder(0.3, wide), (start[0], start[1], z), 20.0, turn=about_x(math.pi / 2),
                   material="paint_orange")
        scene.rule("z_m", name, near=(z, way * math.tan(math.radians(0.1))), to_s=3)
    scene.rule("displacement_m", ["disc", "roller"], near=(way, 0.005 * way), from_s=3, to_s=3)
    for name, z in (("on_box", 4.0), ("on_mesh", 8.4)):
        scene.body(f"wheel_{name}", cylinder(0.3, 0.2), (-52, 0.3, z), 20.0, turn=about_x(math.pi / 2),
                   velocity=(20, 0, 0), spin=(0, 0, -20 / 0.3), material="paint_blue")
        scene.rule("z_m", f"wheel_{name}", near=(z, 100 * math.tan(math.radians(0.1))))
    scene.rule("x_m", "wheel_*", near=(48, 0.2), from_s=5)
    scene.rule("height_m", "wheel_*", near=(0.3, 0.001))
    scene.rule("speed_change", "wheel_*", below=0.002)
    return scene


def left_alone():
    scene = Scene("D10", "balls that are left alone",
                  "Fifteen balls touch in a billiard triangle on a table, one lies alone, one of 1 m on the ground: for a "
                  "minute none rolls.",
                  "jrouwe/JoltPhysics #1686: a ball put down at rest starts to roll and the rack drifts, because of the "
                  "contact cache; neither damping of 1 nor zeroing the velocity stops it", 60, (1.1, 1.3, 2.2),
                  (0.55, 0.2, -0.3), penetration=0.001, player=(0.5, 0, 2.6), shadow=12)
    scene.ground(0.2)
    radius, friction = 0.028575, 0.06
    scene.fixed("table", box(1.27, 0.03, 2.54), (0, 0.015, 0), friction=0.04 / friction, material="grass")
    rows = [(row, place) for row in range(5) for place in range(row + 1)]
    for i, (row, place) in enumerate(rows):
        scene.body(f"ball_{i}", ball(radius), (2 * radius * (place - row / 2), 0.03 + radius,
                                               -2 * radius * math.sqrt(0.75) * row), 0.17, friction=friction,
                   material=("paint_blue", "paint_orange", "paint_cream")[i % 3])
    scene.body("alone", ball(radius), (0, 0.03 + radius, 0.5), 0.17, friction=friction, material="paint_cream")
    scene.body("large", ball(0.5), (1.5, 0.5, -1.2), friction=0.2, material="paint_orange")
    scene.rule("drift_m", below=0.0001)
    scene.rule("spin_radps", below=0.0001)
    return scene


def long_boxes():
    scene = Scene("D11", "long boxes on terrain",
                  "Sixty boxes, of 2 by 0.1 by 0.1 m, 1 by 0.05 by 0.2 and 0.5, and twenty balls of 2 cm radius fall "
                  "turning from 3 m onto hills of 1 m cells, and as many onto hills of 8 m cells: none goes through. The "
                  "balls have rolling friction, or they would rightly roll in the valleys for ever. Depth is that of "
                  "contact points.",
                  "bullet3 #1022, #57, PR #1021: elongated boxes touch, then slip through, and normals point into the "
                  "ground; google-deepmind/mujoco #2883: a 2 cm ball is sucked in at 3 m/s", 10, (10, 9, 24),
                  (0, -1, 0), penetration=0.0008, kill=-3, shadow=60)
    scene.ground(top=-6)
    for name, x in (("fine", -34), ("coarse", 34)):
        scene.fixed(f"terrain_{name}", model(f"terrain_{name}"), (x, 0, 0), material="grass")
    shapes = (((2, 0.1, 0.1), "wood"), ((1, 0.05, 0.2), "paint_orange"), ((0.5, 0.5, 0.5), "paint_blue"))
    for k, (size, material) in enumerate(shapes):
        scene.prefab(f"box_{k}", box(*size), 500 * math.prod(size), material=material)
    scene.prefab("ball", ball(0.02), 500 * 4 / 3 * math.pi * 0.02 ** 3, material="paint_cream",
                 more="rolling_friction = 0.01\n")
    for name, side in (("fine", -1), ("coarse", 1)):
        for i in range(80):
            row, column = divmod(i, 10)
            # Away from the edges of the terrains, whose middles are 34 m from the origin: what tumbles stays on them.
            at = (side * (9 + 2.3 * column), -8.3 + 2.3 * row)
            top = terrain(at[0] + 34 if side < 0 else at[0] - 34, at[1])
            prefab = "ball" if i % 4 == 3 else f"box_{i % 4}"
            scene.place(f"{prefab}_{name}_{i}", prefab, (at[0], top + 3, at[1]), None, None, (3, 1, 2))
    scene.rule("penetration_m", below=0.005)
    scene.rule("lowest_m", above=-0.805)
    scene.rule("up_speed_mps", below=4)
    scene.rule("speed_mps", below=0.05, from_s=8)
    return scene


def sheets():
    scene = Scene("D14", "sixty-four sheets",
                  "Three piles of 64 sheets exactly on each other: 20 by 0.2 by 20 m and 1 kg each, 1 by 0.02 by 1 m and "
                  "1 kg, 1 by 0.002 by 1 m and 0.1 kg.",
                  "PEEL's PileOfThinBoxes: all engines that it drives shift or fall when a sheet is touched", 20,
                  (6, 4, 14), (0.5, 3.2, -4), penetration=0.00004, shadow=60, tier="ci")
    scene.ground()
    for name, side, high, mass, x, z, material in (("large", 20, 0.2, 1.0, 0, -18, "wood"),
                                                   ("small", 1, 0.02, 1.0, 1.0, 5, "paint_orange"),
                                                   ("thin", 1, 0.002, 0.1, 3.0, 6, "paint_blue")):
        scene.prefab(name, box(side, high, side), mass, material=material)
        scene.array(name, name, (x, high / 2, z), (1, 64, 1), (1, high, 1))
    for name in ("large", "small", "thin"):
        scene.rule("sag_m", f"{name}.0.63.0", below=0.001)
    scene.rule("drift_m", below=0.001)
    scene.rule("speed_mps", below=0.002, from_s=3)
    return scene


def two_bullets():
    scene = Scene("D15", "two bullets",
                  "Afloat, balls of 5 cm meet at 600 m/s, 24 pairs with restitution 1 and 24 with 0, each pair a 24th of "
                  "a step later; 24 pairs of spinning boxes too. None passes the other, balls bounce or stop as they "
                  "must.",
                  "dimforge/rapier #984; rapier ccd_semantics.rs states that bullets never sweep against bullets; "
                  "godot-rapier #610; Box2D by design", 0.5, (2.5, 3.6, 8), (0, 2.6, 0), gravity=(0, 0, 0),
                  penetration=0.002, shadow=30)
    scene.ground()
    on = 'ccd = "on"\n'
    scene.prefab("elastic", ball(0.05), restitution=1.0, material="paint_orange", more=on)
    scene.prefab("dead", ball(0.05), material="paint_blue", more=on)
    scene.prefab("box", box(0.1, 0.1, 0.1), material="wood", more=on)
    for k, name in enumerate(("elastic", "dead", "box")):
        spin = (0, 0, 20) if name == "box" else None
        for i in range(24):
            away, y, z = 10 + 5 * i / 24, 1.0 + 0.4 * (i // 6) + 1.6 * k - 0.3, 0.6 * (i % 6) - 1.5
            if name == "box":  # glances off in a plane of its own
                z += 0.12 * (1 + i // 6)
            scene.place(f"{name}_left_{i}", name, (-away, y, z), None, (300.0, 0, 0), spin)
            scene.place(f"{name}_right_{i}", name, (away, y, z), None, (-300.0, 0, 0), spin)
    scene.rule("x_m", ["elastic_left_*", "dead_left_*"], below=0)
    scene.rule("x_m", ["elastic_right_*", "dead_right_*"], above=0)
    scene.rule("speed_x_mps", "elastic_left_*", near=(-300, 1.5), from_s=0.1)
    scene.rule("speed_x_mps", "elastic_right_*", near=(300, 1.5), from_s=0.1)
    scene.rule("speed_mps", "dead_*", below=0.5, from_s=0.1)
    scene.rule("x_m", "box_left_*", below=0.1)
    scene.rule("x_m", "box_right_*", above=-0.1)
    return scene


def overshoot():
    scene = Scene("D17", "a box on a pedestal that bounces without loss",
                  "A cube of 1 m and 1000 kg falls level from 10 m onto a pedestal smaller than its face, with "
                  "restitution 1: four times it comes back to 10 m, never higher, never tilted.",
                  "erincatto/box3d, Restitution Overshoot: rises above where it started, because the points lie inside "
                  "the cube's face and get their restitution one after the other", 11.3, (5, 4.5, 14), (0, 4.6, 0),
                  penetration=0.01, shadow=30)
    scene.ground(top=-0.5)
    scene.fixed("pedestal", box(0.75, 0.5, 0.75), (0, -0.25, 0), material="stone", friction=0.0, restitution=1.0)
    scene.body("cube", box(1, 1, 1), (0, 10, 0), 1000.0, friction=0.0, restitution=1.0, material="paint_orange")
    fall = math.sqrt(2 * 9.5 / G)
    for i in range(4):
        hit = fall * (2 * i + 1)
        scene.rule("reach_m", "cube", near=(10, 0.05), from_s=round(hit + 0.2, 2),
                   to_s=round(min(hit + 2 * fall - 0.2, 11.3), 2))
    scene.rule("height_m", "cube", below=10.05)
    scene.rule("tilt_deg", "cube", below=0.5)
    return scene


def scenes():
    yield beside_the_middle()
    yield on_the_rim()
    yield batteries()
    yield still_points()
    yield rolling_cylinders()
    yield left_alone()
    yield long_boxes()
    yield sheets()
    yield two_bullets()
    yield overshoot()
