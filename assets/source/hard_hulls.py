"""Hard cases D01 to D04, D12, D13 and D16: hulls that stand, land and tumble."""
import math
import random

from hard_contacts import grid, model, write_obj
from hard_scene import Scene, about_x, about_y, box, numbers

G = 9.81
REST_MPS, REST_M = 0.002, 0.0005  # what rest means


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def hull_faces(points):
    """Triangles of the convex hull, anticlockwise from outside; one point after the other."""
    size = max(abs(value) for point in points for value in point)

    def face(a, b, c):
        normal = cross(minus(points[b], points[a]), minus(points[c], points[a]))
        length = math.sqrt(dot(normal, normal)) or 1.0
        normal = tuple(value / length for value in normal)
        return a, b, c, normal, dot(normal, points[a])

    def over(each, point):
        return dot(each[3], point) - each[4] > 1e-9 * size

    order = range(len(points))
    first = min(order, key=lambda i: points[i])
    second = max(order, key=lambda i: dot(minus(points[i], points[first]), minus(points[i], points[first])))

    def area(i):
        made = cross(minus(points[second], points[first]), minus(points[i], points[first]))
        return dot(made, made)

    third = max(order, key=area)
    base = face(first, second, third)
    fourth = max(order, key=lambda i: abs(dot(base[3], points[i]) - base[4]))
    if over(base, points[fourth]):
        second, third = third, second
    faces = [face(first, second, third), face(first, fourth, second), face(second, fourth, third),
             face(third, fourth, first)]
    for i in order:
        seen = [each for each in faces if over(each, points[i])]
        if not seen:
            continue
        edges = {edge for a, b, c, *_ in seen for edge in ((a, b), (b, c), (c, a))}
        faces = [each for each in faces if not over(each, points[i])]
        faces += [face(a, b, i) for a, b in sorted(edges) if (b, a) not in edges]
    return [each[:3] for each in faces]


def hull_volume(points):
    return sum(dot(points[a], cross(points[b], points[c])) for a, b, c in hull_faces(points)) / 6


def hull_m(points):
    """A line holds a hundred of them."""
    texts = [numbers(point) for point in points]
    return "hull_m = [" + ",\n".join(", ".join(texts[i:i + 100]) for i in range(0, len(texts), 100)) + "]"


def prism_points(sides, radius, height):
    return [(radius * math.cos(2 * math.pi * i / sides), y, radius * math.sin(2 * math.pi * i / sides))
            for y in (-height / 2, height / 2) for i in range(sides)]


TRIANGLE = [(x, y, z) for y in (-0.025, 0.025)
            for x, z in ((0.1 / math.sqrt(3), 0), (-0.05 / math.sqrt(3), 0.05), (-0.05 / math.sqrt(3), -0.05))]
# Centimetres: x, z, height.
SLAB_CM = ((-44.877, -91.660, -1.920), (-92.500, 51.015, 15.801), (-91.028, -9.444, 15.615), (90.238, 77.387, 15.936),
           (-85.535, 91.375, -1.366), (88.909, -87.298, -1.868), (83.793, -89.857, 15.417), (87.024, 88.978, -1.324),
           (-91.656, -85.495, 15.378), (-90.292, -87.207, -1.920), (-87.294, 89.951, 15.922), (79.234, 89.969, 15.972),
           (-91.674, 81.082, -1.400), (90.345, -76.446, 15.459), (-87.402, -89.226, 15.368), (76.326, 92.006, 1.829))
CRATE_CM = ((29.500, 17.149, 0.175), (29.500, -17.299, 0.125), (29.484, -17.306, 24.020), (29.484, 17.165, 24.178),
            (-29.135, 17.553, 0.125), (-29.135, 17.553, 23.790), (-29.144, 16.968, 24.375), (-29.135, -17.299, 24.375),
            (-29.135, -17.299, 0.175), (29.072, 17.553, 0.125), (29.086, 17.563, 23.812), (29.140, -17.299, 24.375),
            (29.112, 16.972, 24.403), (29.394, 17.254, 24.121), (-29.135, -17.299, 24.076), (-29.135, -16.972, 24.403),
            (29.112, -16.972, 24.403), (29.500, 17.343, 24.000))
SLAB, CRATE = ([(x / 100, y / 100, z / 100) for x, z, y in points] for points in (SLAB_CM, CRATE_CM))
BARREL = [(radius * math.cos(2 * math.pi * i / 24), y, radius * math.sin(2 * math.pi * i / 24))
          for y, radius in ((-0.4, 0.22), (0, 0.28), (0.4, 0.22)) for i in range(24)]
OCTAGON, TALL_OCTAGON = prism_points(8, 0.4, 0.5), prism_points(8, 0.5, 1)
TETRAHEDRON = [(0.8 / math.sqrt(3), 0, 0), (-0.4 / math.sqrt(3), 0, 0.4), (-0.4 / math.sqrt(3), 0, -0.4),
               (0, 0.8 * math.sqrt(2 / 3), 0)]
PYRAMID = [(0.4, 0, 0.4), (0.4, 0, -0.4), (-0.4, 0, 0.4), (-0.4, 0, -0.4), (0, 0.6, 0)]
DIAMOND = [(0.3, 0, 0), (-0.3, 0, 0), (0, 0.15, 0), (0, -0.15, 0), (0, 0, 0.15), (0, 0, -0.15)]
# From its foot up: radius, height. What is seen of a pin.
PIN = [(0, 0), (0.026, 0), (0.026, 0.18), (0.061, 0.18), (0.061, 0.3), (0.026, 0.3), (0.022, 0.32), (0.032, 0.348),
       (0.022, 0.371), (0, 0.38)]


def random_ball():
    rng = random.Random(1)
    points = []
    for _ in range(1000):
        y, turn = rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
        out = math.sqrt(1 - y * y)
        points.append((0.5 * out * math.cos(turn), 0.5 * y, 0.5 * out * math.sin(turn)))
    return points


def apart(points, triangles):
    """Each triangle with corners of its own, so that it looks flat."""
    return ([points[corner] for triangle in triangles for corner in triangle],
            [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(triangles))])


def turned_profile(profile, sides):
    vertices, triangles = [], []
    for (r, y), (r2, y2) in zip(profile, profile[1:]):
        for i in range(sides):
            a, b = 2 * math.pi * i / sides, 2 * math.pi * (i + 1) / sides
            corners = [(r * math.cos(a), y, r * math.sin(a)), (r * math.cos(b), y, r * math.sin(b)),
                       (r2 * math.cos(a), y2, r2 * math.sin(a)), (r2 * math.cos(b), y2, r2 * math.sin(b))]
            n = len(vertices)
            vertices += corners
            triangles += [(n, n + 2, n + 1)] if r else []
            triangles += [(n + 1, n + 2, n + 3)] if r2 else []
    return vertices, triangles


def write_models(folder):
    for name, about, points in (("triangle", "Triangular prism, edge 0.1 m", TRIANGLE),
                                ("slab", "Warped slab", SLAB), ("crate", "Crate with uneven faces", CRATE),
                                ("barrel", "Barrel of three rings of 24 points", BARREL),
                                ("octagon", "Octagonal prism, radius 0.4 m", OCTAGON),
                                ("octagon_tall", "Octagonal prism, radius 0.5 m", TALL_OCTAGON),
                                ("tetrahedron", "Tetrahedron, edge 0.8 m", TETRAHEDRON),
                                ("pyramid", "Pyramid of 5 points", PYRAMID),
                                ("diamond", "Stretched octahedron", DIAMOND)):
        write_obj(folder / f"{name}.obj", about, *apart(points, hull_faces(points)))
    points = random_ball()
    write_obj(folder / "random_ball.obj", "1000 random points on a sphere", points, hull_faces(points))
    write_obj(folder / "pin.obj", "What is seen of a bowling pin", *turned_profile(PIN, 20))
    write_obj(folder / "roof.obj", "A roof of 4 triangles", [(x, y, z) for z, y in ((-8, 0), (0, 0.4), (8, 0))
                                                             for x in (-4, 4)],
              [(0, 2, 1), (1, 2, 3), (2, 4, 3), (3, 4, 5)])
    write_obj(folder / "flat_wide.obj", "36 by 36 flat cells of 2 m", *grid(36, 36, 2.0, lambda x, z: 0.0))


def walking_prism():
    scene = Scene("D01", "a prism that walks off",
                  "Triangular prisms of edge 0.1 m stand for a minute on a plane, on a box, and with a needless point "
                  "in the middle of the bottom face. The sizes are ours.",
                  "google-deepmind/mujoco #3524: plane against mesh gives 2 points of 3, and it walks 80 mm in 6 s; with "
                  "the point in the middle 1 point on 44 % of the steps, and 300 mm", 60,
                  (0.2, 0.34, 0.6), (0, 0.02, 0), penetration=0.001, player=(0, 0, 1.4), shadow=6)
    scene.fixed("ground", "plane = [200, 200]", (0, 0, 0), material="gravel", friction=0.6, shadow=False)
    scene.fixed("plate", box(0.3, 0.02, 0.3), (0, 0.01, 0), friction=0.6)
    extra = [*TRIANGLE, (0, -0.025, 0)]
    for name, at, points, material in (("on_plane", (-0.3, 0.025, 0), TRIANGLE, "paint_orange"),
                                       ("on_box", (0, 0.045, 0), TRIANGLE, "paint_blue"),
                                       ("needless_point", (0.3, 0.025, 0), extra, "paint_cream")):
        scene.body(name, model("triangle"), at, 0.5, material=material, friction=0.6, own_shape=hull_m(points))
    scene.rule("drift_m", below=0.0001)
    scene.rule("tilt_deg", below=0.1)
    return scene


def warped_slab():
    scene = Scene("D02", "a crate on a warped slab",
                  "A hull of 18 points rests on one of 16 whose top is uneven by 6 mm: nearly coplanar facets on both "
                  "sides. From 2 s on it stands still and presses evenly.",
                  "erincatto/box3d samples/sample_issues.cpp, Convex Jitter: it jitters for ever; PhysX #287 is the same "
                  "class", 30, (-2.9, 3.0, 3.6), (-4.2, 2.1, 1.9), penetration=0.0035, player=(-2.5, 0, 5.2), shadow=12)
    scene.ground(0.6)
    scene.scenery("pillar", box(1.2, 1.98, 1.2), (-4.593, 0.99, 2.174), "stone")
    mass = 1000 * hull_volume(CRATE)
    scene.fixed("slab", model("slab"), (-4.593, 2.010, 2.174), friction=0.6, turn=about_y(-math.pi / 2),
                material="paint_cream", body=f"shape = {{ {hull_m(SLAB)} }}\n")
    scene.body("crate", model("crate"), (-4.023, 2.168, 1.573), mass, friction=0.6, own_shape=hull_m(CRATE),
               turn=about_y(math.radians(-0.17)), material="paint_orange")
    scene.rule("speed_mps", below=REST_MPS, from_s=2)
    scene.rule("drift_m", below=REST_M, from_s=2)
    scene.rule("contact_force_N", "crate", below=1.5 * mass * G, from_s=2)
    return scene


def barrels():
    scene = Scene("D03", "barrels and pins",
                  "Six barrels (hulls of three rings of 24 points) stand on a table and ten bowling pins (compounds) in "
                  "their triangle for a minute; a hull of 1000 random points on a sphere comes to rest within 10 s. How "
                  "the pins' parts stand on each other is ours; of 72 and 1000 points the engine keeps 64.",
                  "dimforge/rapier #417, #455: 0.16 rolls the barrels off the table, hulls with tips jump for ever; "
                  "schteppe/cannon.js #296: the pins are thrown at the start", 60, (1.2, 1.9, 4.2), (-0.1, 0.55, 0),
                  penetration=0.001, shadow=12)
    scene.ground()
    scene.fixed("table", box(2.4, 0.1, 1.6), (-1.6, 0.45, -0.3))
    for i in range(6):
        scene.body(f"barrel_{i}", model("barrel"), (-2.3 + 0.7 * (i % 3), 0.9, -0.65 + 0.7 * (i // 3)), 30.0,
                   material="paint_orange", own_shape=hull_m(BARREL))
    parts = ("shape = { compound = [{ cylinder = [0.026, 0.18], position_m = [0, 0.09, 0] }, "
             "{ cylinder = [0.061, 0.12], position_m = [0, 0.24, 0] }, "
             "{ sphere = 0.032, position_m = [0, 0.348, 0] }] }\n")
    scene.prefab("pin", model("pin"), 1.5, material="paint_cream", more=parts)
    pins = [(row, place) for row in range(4) for place in range(row + 1)]
    for i, (row, place) in enumerate(pins):
        scene.place(f"pin_{i}", "pin", (0.5 + 0.305 * (place - row / 2), 0, 0.9 - 0.305 * math.sqrt(0.75) * row))
    points = random_ball()
    scene.body("ball", model("random_ball"), (1.7, -min(y for _, y, _ in points), 0), 10.0, material="paint_blue",
               own_shape=hull_m(points), more="rolling_friction = 0.02\n")
    scene.rule("drift_m", ["barrel_*", "pin_*"], below=0.0002)
    scene.rule("tilt_deg", ["barrel_*", "pin_*"], below=0.1)
    scene.rule("speed_mps", "ball", below=REST_MPS, from_s=10)
    return scene


def field():
    scene = Scene("D04", "a hull as large as a field",
                  "Cubes of 1 m and octagonal prisms fall 0.5 m onto a hull of 500 by 1 by 500 m, 0 to 240 m from its "
                  "middle, and others onto one of 10 km (the case says 20, a shape may have 10): two worlds in one, by "
                  "groups.",
                  "dimforge/parry #166: normals flip and points lie on the cubes' upper side; 30 by 30 m works, 500 by "
                  "500 does not in float32", 6, (-3, 5, 9), (4, 0, -9), penetration=0.02, kill=-20, shadow=60)
    scene.ground(top=-2)
    scene.scenery("look", box(500, 0.1, 500), (0, -0.06, 0), "gravel")
    turn = math.radians(20)
    for name, half in (("near", 250.0), ("far", 5000.0)):
        only = f'group = "{name}"\ncollides_with = ["{name}"]\n'
        corners = [(x, y, z) for x in (-half, half) for y in (-0.5, 0.5) for z in (-half, half)]
        scene.fixed(f"field_{name}", hull_m(corners), (0, -0.5, 0), hidden=True, friction=0.6, body=only)
        octagon = 1000 * hull_volume(TALL_OCTAGON)
        scene.prefab(f"cube_{name}", box(1, 1, 1), 1000.0, friction=0.6, more=only,
                     material="wood" if name == "near" else "paint_cream")
        scene.prefab(f"prism_{name}", model("octagon_tall"), octagon, friction=0.6,
                     material="paint_orange" if name == "near" else "paint_blue",
                     more=f"shape = {{ {hull_m(TALL_OCTAGON)} }}\n{only}")
        for kind, row in (("cube", 0), ("prism", 1)):
            side = 2.0 * row + (4.0 if name == "far" else 0) - 3
            for i in range(20):
                away = 240 * i / 19
                at = (side * math.cos(turn) + away * math.sin(turn), 1.0,
                      side * math.sin(turn) - away * math.cos(turn))
                scene.place(f"{kind}_{name}_{i}", f"{kind}_{name}", at)
    for name in ("near", "far"):
        scene.rule("speed_mps", [f"cube_{name}_*", f"prism_{name}_*"], below=REST_MPS, from_s=3)
        scene.rule("drift_m", [f"cube_{name}_*", f"prism_{name}_*"], below=REST_M, from_s=3)
    scene.rule("height_m", ["cube_near_*", "prism_near_*"], near=(0.5, 0.001), from_s=3)
    scene.rule("height_m", ["cube_far_*", "prism_far_*"], near=(0.5, 0.02), from_s=3)
    return scene


def on_the_seam():
    scene = Scene("D12", "a hull on the seam",
                  "Prisms, tetrahedra and pyramids fall 2 cm across the edge of two triangles of 50 m, turned by 1 to "
                  "20 degrees; so do others where the edge is bent by half a degree to a valley and to a ridge (side by "
                  "side, by groups). On the ridge they may lean to a side: drift is judged on the other two.",
                  "NVIDIAGameWorks/PhysX #299: convex on the boundary of two triangles jitters endlessly, only if "
                  "slightly turned", 20, (8.5, 5.5, 25), (0, 0, 12), penetration=0.006, kill=-10, shadow=60)
    scene.ground(0.6, top=-0.6)
    scene.scenery("look", box(100, 0.1, 50), (0, -0.06, 0), "flagstone")
    hulls = (("prism", "octagon", OCTAGON, -0.25), ("tetrahedron", "tetrahedron", TETRAHEDRON, 0),
             ("pyramid", "pyramid", PYRAMID, 0))
    for name, x, bend in (("flat", 0.0, 0.0), ("valley", -2.4, 0.25), ("ridge", 2.4, -0.25)):
        only = f'group = "{name}"\ncollides_with = ["{name}"]\n'
        out, up = 25 * math.sqrt(3), 25 * math.sqrt(3) * math.tan(math.radians(bend))
        corners = [(0, 0, -25), (0, 0, 25), (out, up, 0), (-out, up, 0)]
        mesh = (f"mesh_m = [{', '.join(numbers(corner) for corner in corners)}], triangles = [[0, 1, 2], [1, 0, 3]]")
        scene.fixed(f"mesh_{name}", mesh, (x, 0, 0), hidden=True, friction=0.6, body=only)
        for kind, shown, points, _ in hulls:
            scene.prefab(f"{kind}_{name}", model(shown), 10.0, friction=0.6,
                         material={"flat": "paint_orange", "valley": "paint_blue", "ridge": "paint_cream"}[name],
                         more=f"shape = {{ {hull_m(points)} }}\n{only}")
        for i in range(20):
            kind, _, _, foot = hulls[i % 3]
            scene.place(f"{name}_{i}", f"{kind}_{name}", (x, 0.02 - foot, 19 - 2.0 * i), about_y(math.radians(i + 1)))
    for name in ("flat", "valley", "ridge"):
        scene.rule("speed_mps", f"{name}_*", below=REST_MPS, from_s=2)
    for name in ("flat", "valley"):
        scene.rule("drift_m", f"{name}_*", below=REST_M, from_s=2)
    return scene


def ridge():
    scene = Scene("D13", "a plate onto a ridge",
                  "Thirty plates of 1 by 0.1 by 2 m and 200 kg meet the ridge of a roof of 4 triangles at 50 m/s, turned "
                  "by -15 to 14 degrees about it: none gets through, all come to rest. Whether the ridge stands out of "
                  "the upper face is judged by the penetration, which must stay below the thickness. When they come "
                  "to rest is ours: within 8 s.",
                  "erincatto/box3d samples/sample_continuous.cpp, Hump Mesh: corners pass the slopes while the middle is "
                  "stopped", 10, (16, 9, 21), (0, 0, 0), penetration=0.002, kill=-2, shadow=80)
    scene.ground(0.6, top=-4)
    # As far beyond the outermost plates as a roof for each of them would reach.
    for i in range(7):
        scene.fixed(f"roof_{i}", model("roof"), (8.0 * i - 24, 0, 0), friction=0.6, material="flagstone")
    scene.prefab("plate", box(1, 0.1, 2), 200.0, friction=0.6, material="paint_orange")
    for i in range(30):
        scene.place(f"plate_{i}", "plate", (8.0 * (i // 6) - 16 + 1.3 * (i % 6) - 3.25, 5.4, 0),
                    about_x(math.radians(i - 15)), (0, -50.0, 0))
    scene.rule("lowest_m", above=0.0)
    scene.rule("penetration_m", below=0.1)
    scene.rule("speed_mps", below=REST_MPS, from_s=8)
    return scene


def tumbling():
    scene = Scene("D16", "tumbling with the sweep on",
                  "Octahedra of 0.6 by 0.3 by 0.3 m, thrown down at 15 m/s and 40 rad/s with restitution 0.1, twenty with "
                  "the sweep on and twenty with it off. Not judged: each impact by itself, and that both bounce alike; "
                  "judged is that no bounce is higher than 1 m, which turning tips may reach.",
                  "NVIDIAGameWorks/PhysX #470: super bouncy with the sweep on, and some bounces change speed but not "
                  "spin", 5, (9, 7, 17), (0, 0.5, 1), penetration=0.006, kill=-10, shadow=80)
    scene.ground(top=-2)
    scene.fixed("mesh", model("flat_wide"), (0, 0, 0), material="flagstone", restitution=0.1)
    for ccd, material, more in (("on", "paint_orange", 0.0), ("off", "paint_blue", 9.0)):
        for i in range(20):
            turn = math.radians(18 * i + more)
            ahead, across = (math.cos(turn), -math.sin(turn)), (math.sin(turn), math.cos(turn))
            scene.body(f"{ccd}_{i}", model("diamond"), (6 * ahead[0], 1.5, 6 * ahead[1]), 20.0, restitution=0.1,
                       material=material, turn=about_y(turn), velocity=(12 * ahead[0], -9, 12 * ahead[1]),
                       spin=(-40 * across[0], 0, -40 * across[1]), own_shape=hull_m(DIAMOND),
                       more=f'ccd = "{ccd}"\n')
    scene.rule("reach_m", ["on_*", "off_*"], below=1.15, from_s=0.25)
    scene.rule("lowest_m", above=0.05)
    return scene


def scenes():
    yield walking_prism()
    yield warped_slab()
    yield barrels()
    yield field()
    yield on_the_seam()
    yield ridge()
    yield tumbling()
