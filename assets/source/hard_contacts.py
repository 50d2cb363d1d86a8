"""Hard cases H49 to H73: meshes, small and fast things, odd places."""
import math
import random

from hard_scene import Scene, about_x, about_y, about_z, ball, box, capsule, cylinder, numbers

MODELS = "models/hard"


def write_obj(path, about, vertices, triangles):
    """Triangles anticlockwise from above; texture coordinates are metres along x and z."""
    lines = [f"# {about}. Written by assets/source/make_hard_scenes.py."]
    lines += [f"v {x:.6g} {y:.6g} {z:.6g}" for x, y, z in vertices]
    lines += [f"vt {x:.6g} {z:.6g}" for x, _, z in vertices]
    lines += ["f " + " ".join(f"{i + 1}/{i + 1}" for i in triangle) for triangle in triangles]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def grid(cells_x, cells_z, cell, height):
    """A net of quads about the origin, each cut in two; `height`: of (x, z)."""
    vertices, triangles = [], []
    for j in range(cells_z + 1):
        for i in range(cells_x + 1):
            x, z = cell * (i - cells_x / 2), cell * (j - cells_z / 2)
            vertices.append((x, height(x, z), z))
    for j in range(cells_z):
        for i in range(cells_x):
            a = j * (cells_x + 1) + i
            b, c, d = a + 1, a + cells_x + 1, a + cells_x + 2
            triangles += [(a, c, b), (b, c, d)]
    return vertices, triangles


def bowl(radius, cells):
    vertices = [(0.0, 0.0, 0.0)]
    for ring in range(1, cells + 1):
        polar = math.pi / 2 * ring / cells
        for i in range(cells):
            angle = 2 * math.pi * i / cells
            vertices.append((radius * math.sin(polar) * math.cos(angle), radius * (1 - math.cos(polar)),
                             radius * math.sin(polar) * math.sin(angle)))
    triangles = [(0, 1 + (i + 1) % cells, 1 + i) for i in range(cells)]
    for ring in range(cells - 1):
        for i in range(cells):
            a, b = 1 + ring * cells + i, 1 + ring * cells + (i + 1) % cells
            triangles += [(a, b, a + cells), (b, b + cells, a + cells)]
    return vertices, triangles


def seams():
    """Rows of quads, every second one shifted by half a cell: corners meet edges."""
    vertices, triangles = [], []
    for j in range(8):
        for i in range(30):
            x, z = i - 15 + 0.5 * (j % 2), j - 4
            a = len(vertices)
            vertices += [(x, 0, z), (x + 1, 0, z), (x, 0, z + 1), (x + 1, 0, z + 1)]
            triangles += [(a, a + 2, a + 1), (a + 1, a + 2, a + 3)]
    return vertices, triangles


def needles():
    """Strips of 20 m by 2 cm, and a triangle without area."""
    vertices, triangles = [], []
    for i in range(200):
        x = 0.02 * i - 2
        a = len(vertices)
        vertices += [(x, 0, -10), (x + 0.02, 0, -10), (x, 0, 10), (x + 0.02, 0, 10)]
        triangles += [(a, a + 2, a + 1), (a + 1, a + 2, a + 3)]
    a = len(vertices)
    vertices += [(0, 0, 0), (0.5, 0, 0), (1, 0, 0)]
    triangles.append((a, a + 1, a + 2))
    return vertices, triangles


def write_models(folder):
    flat = grid(64, 16, 1.0, lambda x, z: 0.0)
    waves = grid(32, 32, 0.75, lambda x, z: 0.35 * math.sin(1.3 * x) * math.cos(1.1 * z))
    for name, about, made in (("flat", "64 by 16 flat cells of 1 m", flat),
                              ("waves", "32 by 32 cells of 0.75 m in waves", waves),
                              ("bowl", "Half a sphere of 0.1 m, 24 by 24", bowl(0.1, 24)),
                              ("seams", "Rows of 1 m squares, shifted by half", seams()),
                              ("needles", "200 strips of 20 m by 2 cm and a triangle without area",
                               needles())):
        write_obj(folder / f"{name}.obj", about, *made)


def model(name):
    return f'model = "{MODELS}/{name}.obj"'


def smooth_run(scene, of=()):
    scene.rule("up_speed_mps", of, below=0.02)
    scene.rule("speed_change", of, below=0.001)
    scene.rule("heading_deg", of, below=0.1)


def flat_mesh():
    scene = Scene("H49", "sliding over a flat mesh",
                  "A box and a ball without friction cross the inner edges of a flat mesh at 10 m/s, "
                  "along it and at 30 degrees.",
                  "Bullet's default: 10 m/s become 1.6, thrown up at 2.8 m/s, 29 degrees off; even a ball "
                  "6.6 m/s [measured, 3.24]; bullet3 #92, #1201, #676, #1853; godot #21341; rapier #95, "
                  "#404; Jolt #1155", 2.5, (4, 14, 40), (2, 0, 5))
    scene.ground(top=-0.5)
    for lane, z, turn in (("along", -8, None), ("askew", 17, about_y(math.radians(30)))):
        scene.fixed(f"mesh_{lane}", model("flat"), (0, 0, z), material="flagstone", friction=0.0, turn=turn)
        scene.body(f"box_{lane}", box(1, 1, 1), (-13, 0.5, z - 1.3), friction=0.0, velocity=(10, 0, 0))
        scene.body(f"ball_{lane}", ball(0.5), (-13, 0.5, z + 1.4), friction=0.0, velocity=(10, 0, 0),
                   material="paint_blue")
    smooth_run(scene)
    return scene


def coplanar():
    scene = Scene("H50", "sliding over four hundred boxes that lie level",
                  "A box, a plate, a ball, a capsule, cylinders and a hull without friction cross the seams of 20 "
                  "by 20 static boxes at 10 m/s, each from another place.",
                  "rapier's and Jolt's ghost hits; Box3D's GhostCollisions throw at over 0.5 m/s", 1.8,
                  (3, 7, 15), (0, 0, 0))
    scene.ground(top=-0.6)
    scene.parts.append('[[prefab]]\nname = "slab"\nprimitive = { box = [1, 0.5, 1] }\n'
                       'material = "flagstone"\n[prefab.body]\nkind = "static"\nfriction = 0.0\n')
    scene.array("slab", "slab", (-9.5, -0.25, -9.5), (20, 1, 20), (1, 1, 1))
    scene.body("box", box(1, 1, 1), (-9, 0.5, -3.2), friction=0.0, velocity=(10, 0, 0))
    scene.body("ball", ball(0.5), (-9, 0.5, 0.3), friction=0.0, velocity=(10, 0, 0), material="paint_blue")
    scene.body("capsule", capsule(0.4, 1), (-9, 0.4, 3.3), friction=0.0, velocity=(10, 0, 0),
               turn=about_x(math.pi / 2), material="paint_orange")
    corners = [[x * w, y, z * d] for y, w, d in ((-0.3, 0.5, 0.4), (0.3, 0.4, 0.3)) for x in (-1, 1) for z in (-1, 1)]
    run = {"friction": 0.0, "velocity": (10, 0, 0)}
    for i in range(3):
        scene.body(f"box_{i}", box(1, 1, 1), (-9.43 + 0.29 * i, 0.5, -9.1 + 1.07 * i), **run)
        scene.body(f"plate_{i}", box(1, 0.2, 0.6), (-9.37 + 0.23 * i, 0.1, -5.9 + 0.83 * i), **run)
        scene.body(f"cylinder_{i}", cylinder(0.4, 0.8), (-9.47 + 0.31 * i, 0.4, 4.6 + 0.91 * i),
                   turn=about_x(math.pi / 2) if i == 1 else None, material="paint_cream", **run)
        scene.body(f"hull_{i}", box(1, 0.6, 0.8), (-9.41 + 0.19 * i, 0.3, 7.33 + 0.87 * i),
                   own_shape=f"hull_m = {corners}", material="paint_blue", **run)
    smooth_run(scene)
    return scene


def rolled():
    scene = Scene("H51", "a ball over seams where corners meet edges",
                  "A ball rolls at 5 m/s over a mesh whose rows are shifted by half a cell: it must not "
                  "dip into a seam or be thrown.",
                  "Rapier's own bar is 5 cm", 4, (2, 5, 10), (0, 0.3, 0))
    scene.ground(top=-0.5)
    scene.fixed("mesh", model("seams"), (0, 0, 0), material="flagstone")
    for i in range(3):
        scene.body(f"ball_{i}", ball(0.5), (-12, 0.5, -2.1 + 2.05 * i), velocity=(5, 0, 0.1),
                   spin=(0.2, 0, -10), material="paint_blue")
    scene.rule("height_m", near=(0.5, 0.001))
    return scene


def large():
    scene = Scene("H52", "triangles of ten kilometres",
                  "Boxes rest on two triangles with edges of 10 km, away from the middle.",
                  "PEEL keeps it as VeryLargeTriangle", 10, (8, 5, 12), (0, 0.5, 0),
                  penetration=0.01)
    scene.scenery("look", box(120, 0.02, 120), (0, -0.012, 0), "gravel")
    mesh = ("mesh_m = [[-5000, 0, -5000], [5000, 0, -5000], [-5000, 0, 5000], [5000, 0, 5000]], "
            "triangles = [[0, 2, 1], [1, 2, 3]]")
    scene.fixed("mesh", mesh, (0, 0, 0), hidden=True)
    for i in range(10):
        scene.body(f"box_{i}", box(1, 1, 1), (3 * (i % 4) - 4.4, 0.6 + 0.05 * i, 3 * (i // 4) - 3.2))
    scene.rule("speed_mps", below=0.005, from_s=5)
    scene.rule("height_m", near=(0.5, 0.01), from_s=5)
    return scene


def thin_triangles():
    scene = Scene("H53", "needle triangles and one without area",
                  "Boxes, balls and capsules fall on triangles of 20 m by 2 cm, one of which has no area.",
                  "Box3D keeps it as NeedleMesh", 8, (4, 3.5, 7), (0, 0.3, 0), kill=-5,
                  shadow=20)
    scene.fixed("mesh", model("needles"), (0, 0, 0), material="flagstone")
    scene.ground(top=-1)
    for i in range(9):
        at = (0.9 * (i % 3) - 0.9, 1 + 0.3 * i, 1.5 * (i // 3) - 1.5)
        shape = (box(0.5, 0.5, 0.5), ball(0.3), capsule(0.2, 0.4))[i % 3]
        scene.body(f"thing_{i}", shape, at, more="rolling_friction = 0.02\n",
                   material=("wood", "paint_blue", "paint_orange")[i % 3])
    scene.rule("lowest_m", above=0.1)
    return scene


def plates(name, count, tier):
    scene = Scene(name, f"{count} thin plates on a wavy mesh",
                  "Plates of 2 by 20 by 4 cm, turning at 5 rad/s, fall on a mesh in waves: none goes "
                  "through.",
                  "Box3D: plates of 1 by 10 by 2 cm are known to fail with 4 sub-steps", 6, (4.5, 3.2, 6),
                  (0, 0.2, 0), tier=tier, kill=-2, penetration=0.004, shadow=20)
    scene.ground(top=-3)
    scene.fixed("mesh", model("waves"), (0, 0, 0), material="stone")
    scene.prefab("plate", box(0.02, 0.2, 0.04), 0.16, material="paint_orange")
    rng = random.Random(54)
    side = math.isqrt(count) if count < 1000 else 16
    for i in range(count):
        x, z, y = i % side, i // side % side, i // (side * side)
        spin = tuple(rng.uniform(-5, 5) for _ in range(3))
        scene.place(f"plate_{i}", "plate", (0.28 * (x - (side - 1) / 2), 1 + 0.3 * y,
                                            0.28 * (z - (side - 1) / 2)), None, None, spin)
    scene.rule("lowest_m", above=-2)
    return scene


def slab():
    scene = Scene("H55", "a thin slab on two triangles",
                  "A slab of 2 by 0.06 by 2 m falls 5 m onto a mesh of two triangles and rests on it.",
                  "Rapier keeps it as a test; Bullet 3.24 leaves contacts of convex shapes and meshes out "
                  "(#4263)", 6, (5, 4, 8), (0, 1, 0), kill=-10, penetration=0.0012)
    mesh = ("mesh_m = [[-10, 0, -10], [10, 0, -10], [-10, 0, 10], [10, 0, 10]], "
            "triangles = [[0, 2, 1], [1, 2, 3]]")
    scene.ground(top=-0.5)
    scene.scenery("look", box(20, 0.02, 20), (0, -0.012, 0), "flagstone")
    scene.fixed("mesh", mesh, (0, 0, 0), hidden=True)
    scene.body("slab", box(2, 0.06, 2), (0.3, 5.03, 0.2), 24.0, material="paint_orange")
    scene.rule("height_m", "slab", near=(0.03, 0.003), from_s=4)
    scene.rule("speed_mps", "slab", below=0.005, from_s=4)
    return scene


def bombarded():
    scene = Scene("H56", "cubes of 10 cm at 20 m/s onto a disc of 10 cm",
                  "Twenty-five small cubes are shot down at a disc no thicker than they are: none gets "
                  "through.",
                  "Rapier keeps it as a test", 4, (3, 3, 5), (0, 1, 0), kill=-1,
                  penetration=0.002, shadow=15)
    scene.ground()
    scene.fixed("disc", cylinder(2, 0.1), (0, 1.05, 0), material="iron")
    for i in range(25):
        scene.body(f"cube_{i}", box(0.1, 0.1, 0.1), (0.4 * (i % 5) - 0.8, 3 + 0.13 * i, 0.4 * (i // 5) - 0.8),
                   velocity=(0, -20, 0), material="paint_orange")
    scene.rule("lowest_m", above=1.1)
    return scene


def bullets():
    scene = Scene("H57", "a hundred boxes at 200 and 400 m/s against 2 cm",
                  "Boxes of 40 cm, fifty at 200 and fifty at 400 m/s, meet a wall of 2 cm at a hundred "
                  "different fractions of a step.",
                  "Bullet #2228; rapier #810, #932, #984; godot #9071", 3, (-14, 7, 16), (-2, 3, 0),
                  penetration=0.05)
    scene.ground()
    scene.fixed("wall", box(0.02, 12, 30), (0, 6, 0), material="glass")
    scene.prefab("shot", box(0.4, 0.4, 0.4), material="paint_orange")
    for i in range(100):
        fast = i >= 50
        k = i % 50
        scene.place(f"shot_{i}", "shot", (-20 - 0.37 * k - (10 if fast else 0),
                                          (1 if not fast else 1.5) + 1.0 * (k // 10), 2.6 * (k % 10) - 12),
                    None, (400.0 if fast else 200.0, 0, 0))
    scene.rule("x_m", below=0.0)
    scene.rule("x_m", above=-70)
    return scene


def whirled():
    scene = Scene("H59", "a long rod that whirls at 50 rad/s",
                  "A rod of 4 m by 4 cm whirls into a post at 100 m/s at its tip, and another falls "
                  "whirling on the ground: neither may go past by 2 cm or through.",
                  "Bullet sweeps a ball and knows no turning [from its code]; PEEL keeps angular sweeps",
                  3, (4, 5, 9), (-1, 1.2, 0), kill=-5)
    scene.ground()
    scene.fixed("post", box(0.1, 4, 0.1), (1.2, 2, -1.0), material="iron")
    scene.body("struck", box(4, 0.04, 0.04), (0, 3, 0), velocity=(0, 0, 0), spin=(0, 50, 0),
               material="paint_orange")
    scene.body("falling", box(4, 0.04, 0.04), (-6, 3.5, 0), velocity=(0, -4, 0), spin=(0, 0, 50),
               material="paint_blue")
    scene.rule("spin_radps", "struck", below=45, from_s=0.5)
    scene.rule("lowest_m", above=-0.02)
    return scene


def rebound():
    speed, e, radius, start = 60.0, 0.9, 0.1, 2.1
    hit = math.sqrt(speed ** 2 + 2 * 9.81 * (start - radius))
    apex = radius + (e * hit) ** 2 / (2 * 9.81)
    scene = Scene("H60", "a ball thrown down at 60 m/s",
                  f"With continuous collision on and restitution 0.9 it must rise to {apex:.1f} m.",
                  "Bullet's swept contacts have no restitution and lose time (#2483)", 3, (3, 2.5, 7),
                  (0, 1.5, 0))
    scene.ground(0.5, e)
    for i in range(5):
        scene.body(f"ball_{i}", ball(radius), (i - 2.0, start, 0), restitution=e,
                   velocity=(0, -speed, 0), material="paint_blue", more='ccd = "on"\n')
    scene.rule("reach_m", near=(apex, 0.02 * (apex - radius)), from_s=0.5)
    return scene


def tiles():
    scene = Scene("H61", "swept over forty tiles",
                  "Bodies with continuous collision on cross forty tiles at 50 m/s: they must get on, "
                  "and one that is dropped must not hang in the air.",
                  "rapier #217 and #524", 0.9, (6, 6, 14), (0, 0, 0))
    scene.ground(top=-0.5)
    scene.parts.append('[[prefab]]\nname = "tile"\nprimitive = { box = [1.2, 0.4, 6] }\n'
                       'material = "flagstone"\n[prefab.body]\nkind = "static"\nfriction = 0.0\n')
    scene.array("tile", "tile", (-23.4, -0.2, 0), (40, 1, 1), (1.2, 1, 1))
    on = 'ccd = "on"\n'
    scene.body("box", box(0.5, 0.5, 0.5), (-23, 0.25, -1.5), friction=0.0, velocity=(50, 0, 0), more=on)
    scene.body("ball", ball(0.25), (-23, 0.25, 0), friction=0.0, velocity=(50, 0, 0), more=on,
               material="paint_blue")
    scene.body("dropped", box(0.5, 0.5, 0.5), (0, 2.25, 1.7), velocity=(0, -10, 0), more=on,
               material="paint_orange")
    scene.rule("x_m", ["box", "ball"], above=-23 + 0.2 * 45, from_s=0.9)
    scene.rule("height_m", "dropped", below=0.3, from_s=0.9)
    return scene


def dice():
    scene = Scene("H62", "dice of 1 cm and bolts of 2 mm",
                  "Fifty dice and fifty bolts of a gram fall on a table and lie still, less than 0.2 mm "
                  "in each other.",
                  "Bullet's margins of 4 cm: #2064, #2148, #2614, PR #2695", 4, (0.1, 1.16, 0.22),
                  (0, 1.0, 0), penetration=0.0002, kill=-1, shadow=4, player=(0, 0, 1.5))
    scene.ground()
    scene.fixed("table", box(1.2, 0.1, 0.8), (0, 0.95, 0))
    for i in range(50):
        at = (0.016 * (i % 10) - 0.072, 1.02 + 0.002 * (i % 3), 0.016 * (i // 10) - 0.032)
        scene.body(f"die_{i}", box(0.01, 0.01, 0.01), at, 0.0025, material="paint_cream",
                   turn=about_z(0.2 + 0.1 * i))
        at = (0.008 * (i % 10) - 0.036, 1.012 + 0.001 * (i % 4), 0.008 * (i // 10) + 0.05)
        scene.body(f"bolt_{i}", cylinder(0.001, 0.004), at, 0.001, material="iron",
                   turn=about_x(0.3 + 0.2 * i), more="rolling_friction = 0.00005\n")
    scene.rule("speed_mps", below=0.002, from_s=3)
    scene.rule("lowest_m", above=1.0)
    return scene


def marble():
    scene = Scene("H63", "a marble in a small bowl",
                  "A marble of 1 cm rolls in a bowl of 10 cm made of triangles: no energy from the seams.",
                  "expected: margins of 4 cm", 5, (0.24, 1.3, 0.3), (0, 1.06, 0), kill=-1,
                  penetration=0.0002, shadow=4, player=(0, 0, 1.5), energy_scale=0.0013 * 9.81 * 0.07)
    scene.ground()
    scene.fixed("table", box(1.2, 0.1, 0.8), (0, 0.9, 0))
    scene.fixed("bowl", model("bowl"), (0, 1, 0), material="paint_orange")
    scene.body("marble", ball(0.005), (0.0662, 1.0358, 0), 0.0013, material="paint_blue")
    scene.rule("lowest_m", above=1.0)
    scene.rule("height_m", below=1.0358 + 0.0001)
    return scene


def balanced():
    scene = Scene("H65", "a cone on its tip and a coin on its edge",
                  "The cone stands one degree off upright, the coin three; both fall over smoothly and lie down.",
                  "Bullet #2148: wrong moments from the margin", 8, (2.5, 2, 4.5), (0, 0.5, 0),
                  penetration=0.002, shadow=12)
    scene.ground()
    off, coin_off = math.radians(1), math.radians(3)
    scene.body("cone", "cone = [0.5, 1.0]", (-1.2, 0.5, 0), turn=about_z(math.pi - off), material="paint_orange",
               more="rolling_friction = 0.01\n")
    scene.body("coin", cylinder(0.5, 0.02), (1, 0.5, 0), turn=about_x(math.pi / 2 - coin_off), material="iron",
               more="rolling_friction = 0.005\n")
    scene.rule("up_speed_mps", below=0.5)
    scene.rule("tilt_deg", "cone", above=45, from_s=8)
    scene.rule("height_m", "coin", below=0.03, from_s=8)
    return scene


def overlapped():
    scene = Scene("H66", "a hundred balls on one spot",
                  "Afloat, a hundred balls start at one point and two boxes in one pose: they part within "
                  "5 s, never faster than 6 m/s.",
                  "Bullet's split impulses and Baumgarte speeds [from its code]; Box3D keeps it", 6,
                  (4, 4, 9), (0.8, 2.5, 0), gravity=(0, 0, 0), penetration=0.01,
                  settled=5, unsettled="they start inside each other and have 5 s to part",
                  energy_scale=102 * 18.0,  # all of them at 6 m/s
                  energy_from="the penetration at the start")
    scene.ground()
    for i in range(100):
        scene.body(f"ball_{i}", ball(0.25), (-1.5, 2.5, 0),
                   material=("paint_blue", "paint_orange", "paint_cream")[i % 3])
    for i in range(2):
        scene.body(f"box_{i}", box(1, 1, 1), (4, 2.5, 0))
    scene.rule("speed_mps", below=6)
    return scene


def stuck():
    scene = Scene("H68", "boxes that start inside static ones",
                  "Boxes begin 80, 50 and 20 cm inside a static block, one 80 cm through a mesh: each "
                  "comes out slower than 5 m/s or stays.",
                  "expected", 4, (7, 5, 12), (0.5, 1.5, 0), penetration=1.0, kill=-20,
                  removed=1, energy_from="the penetration at the start")
    scene.ground()
    scene.fixed("block", box(4, 4, 12), (-2, 2, 0), material="stone")
    for i, inside in enumerate((0.8, 0.5, 0.2)):
        scene.body(f"box_{i}", box(1, 1, 1), (0.5 - inside, 2, 3.0 * i - 3), material="paint_orange")
    scene.fixed("mesh", model("seams"), (20, 3, 0), material="flagstone")
    scene.body("through", box(1, 1, 1), (14.3, 2.7, 0.2))
    scene.rule("horizontal_speed_mps", "box_*", below=5)
    scene.rule("up_speed_mps", "through", below=5)
    return scene


def phantom():
    scene = Scene("H70", "a millimetre apart",
                  "Afloat, a box slides along a wall at 5 m/s, 1 mm away from it: no force may act.",
                  "mujoco #3476; Bullet's boxes have no contact before they penetrate (#2646)", 2, (2, 4, 8),
                  (0, 1, 0), gravity=(0, 0, 0), energy_scale=12.5)
    scene.ground()
    scene.fixed("wall", box(14, 2, 0.4), (0, 1, -0.7), material="brick")
    scene.body("box", box(1, 1, 1), (-5, 1, 0.001), velocity=(5, 0, 0))
    scene.rule("contact_force_N", "box", below=6e-5)
    scene.rule("speed_change", "box", below=1e-4)
    return scene


def edges():
    scene = Scene("H71", "on corners, edges and slopes",
                  "A box on a slope of 15 degrees stays; a ball comes off the edge of a box and a box "
                  "balanced on a corner falls, all without gaining energy.",
                  "bullet3 #4631: boxes and balls on slopes", 6, (3, 3.5, 8), (0, 0.8, 0))
    scene.ground()
    angle = math.radians(15)
    scene.fixed("slope", box(4, 0.4, 2), (-3.5, 0.7, 0), turn=about_z(-angle), material="stone")
    out = (math.sin(angle), math.cos(angle))
    scene.body("on_slope", box(0.6, 0.6, 0.6), (-3.5 + 0.5 * out[0], 0.7 + 0.5 * out[1], 0), turn=about_z(-angle))
    scene.fixed("block", box(1, 1, 1), (0, 0.5, 0), material="stone")
    scene.body("on_edge", ball(0.3), (0.51, 1.3, 0), material="paint_blue")
    scene.fixed("table", box(1, 1, 1), (3, 0.5, 0), material="stone")
    tip = math.atan(math.sqrt(2))  # a space diagonal upright
    half = 0.4
    w, x, y, z = about_z(math.pi / 4)
    cw, sx = math.cos(tip / 2), math.sin(tip / 2)
    turn = (cw * w, sx * w, cw * y - sx * z, cw * z + sx * y)
    scene.body("on_corner", box(2 * half, 2 * half, 2 * half), (3, 1 + math.sqrt(3) * half, 0), turn=turn,
               material="paint_orange")
    scene.rule("speed_mps", "on_slope", below=0.001, from_s=1)
    scene.rule("displacement_m", "on_slope", below=0.001)
    scene.rule("up_speed_mps", below=0.5)
    return scene


def far():
    scene = Scene("H72", "a tower ten kilometres out",
                  "A tower of five, ten kilometres from the origin, stands as it does nearby. A float32 "
                  "coordinate has steps of 1 mm there.",
                  "Box2D keeps a pyramid as Far", 10, (10_005, 5, 10_009), (10_000, 2.4, 10_000))
    scene.fixed("ground", box(60, 2, 60), (10_000, -1, 10_000), material="gravel", shadow=False)
    for i in range(5):
        scene.body(f"box_{i}", box(1, 1, 1), (10_000, 0.5 + i, 10_000))
    scene.rule("displacement_m", below=0.02)
    return scene


def poisoned():
    scene = Scene("H73", "numbers that are none",
                  "One ball gets a velocity that is no number, one 1e9 N for a step, one is put 1e11 m "
                  "away: they go alone, the tower beside them stands.",
                  "Bullet goes on with numbers that are none, its asserts are off in release: #976; "
                  "shock2quest #507", 8, (7, 4, 11), (0, 1.8, 0), kill=-50, non_finite=2,
                  removed=2, energy_from="the force, and a ball 1e11 m away")
    scene.ground()
    for i in range(5):
        scene.body(f"box_{i}", box(1, 1, 1), (2.5, 0.5 + i, 0))
    for name, x in (("no_number", -2), ("pushed", -4), ("away", -6)):
        scene.body(name, ball(0.5), (x, 0.5, 1), material="paint_orange")
    scene.event("not_finite", "no_number", 0.5)
    scene.event("force", "pushed", 0.5, value=(-1e9, 0, 0))
    scene.event("teleport", "away", 0.5, value=(1e11, 0, 0))
    scene.rule("displacement_m", "box_*", below=0.02)
    scene.rule("speed_mps", "box_*", below=0.005, from_s=5)
    return scene


def scenes():
    yield flat_mesh()
    yield coplanar()
    yield rolled()
    yield large()
    yield thin_triangles()
    yield plates("H54", 256, "ci")
    yield plates("H54b", 1024, "nightly")
    yield slab()
    yield bombarded()
    yield bullets()
    yield whirled()
    yield rebound()
    yield tiles()
    yield dice()
    yield marble()
    yield balanced()
    yield overlapped()
    yield stuck()
    yield phantom()
    yield edges()
    yield far()
    yield poisoned()
