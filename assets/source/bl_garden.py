"""What stands and hangs in the garden: one .glb a piece. Pieces of boards are garden_plan.BOXES,
which physics takes too; what is turned on a lathe is here.

    blender -b --factory-startup -P bl_garden.py -- . MODELS
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bl_house import *  # noqa: E402,F403
import garden_plan as garden  # noqa: E402

AXES = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))  # the scene's to Blender's


def turned_by(turn_deg):
    """As rotation_deg turns: about x, then y, then z, in Blender's axes."""
    turn = Matrix.Identity(4)
    for angle, axis in zip(turn_deg, "XYZ"):
        turn = Matrix.Rotation(math.radians(angle), 4, axis) @ turn
    return AXES @ turn @ AXES.inverted()


def board(m, material, centre, size, turn_deg=(0, 0, 0)):
    m.box(blender(centre), (size[0], size[2], size[1]), named(material), M=turned_by(turn_deg),
          off=(random.random(), random.randrange(6) / 6))


def boards(name):
    random.seed(len(name))
    m = HouseMesh()
    for part in garden.BOXES[name]:
        board(m, *part)
    return m


def square(angle):
    """The radius of a square of which the sides are at 1, for a lathe of eight segments."""
    return 1 / max(abs(math.cos(angle)), abs(math.sin(angle)))


def rod(m, material, a, b, thick):
    """A square rod between two points across x."""
    way = [q - p for p, q in zip(a, b)]
    lean = math.degrees(math.atan2(way[2], way[1]))
    board(m, material, [(p + q) / 2 for p, q in zip(a, b)], (thick, math.dist(a, b), thick), (lean, 0, 0))


def watering_can():
    """Stands on its origin, the spout along +z."""
    m = HouseMesh()
    m.lathe([(0, 0), (0.1, 0), (0.105, 0.01), (0.1, 0.2), (0.085, 0.235), (0.06, 0.24), (0, 0.225)], named("zinc"), 14)
    rod(m, "zinc", (0, 0.06, 0.08), (0, 0.25, 0.27), 0.028)
    spout = HouseMesh()
    spout.lathe([(0, 0), (0.018, 0), (0.05, 0.04), (0.045, 0.045), (0, 0.05)], named("zinc"), 10)
    rose = spout.obj("rose")
    rose.rotation_euler = (math.radians(45), 0, 0)
    rose.location = blender((0, 0.245, 0.265))
    around = [(0.04 + 0.14 * math.cos(a), 0.135 - 0.15 * math.sin(a)) for a in (math.pi * i / 6 for i in range(7))]
    for (y0, z0), (y1, z1) in zip(around, around[1:]):
        rod(m, "zinc", (0, y0, z0 - 0.06), (0, y1, z1 - 0.06), 0.016)
    made = m.obj("watering_can", autosmooth=40)
    return [made, rose]


def lantern():
    """Stands on its origin and hangs from its ring."""
    m = HouseMesh()
    width, height = garden.LANTERN
    for y in (0.012, height - 0.06):
        m.part((0, y, 0), (width, 0.024, width), "iron")
    for sx in (-1, 1):
        for sz in (-1, 1):
            m.part((sx * (width / 2 - 0.012), height / 2 - 0.03, sz * (width / 2 - 0.012)), (0.018, height - 0.08, 0.018), "iron")
    m.lathe([(0.1, height - 0.05), (0.05, height), (0.02, height + 0.02), (0, height + 0.02)], named("iron"), 8, ring=square)
    m.lathe([(0.028, 0.02), (0.028, 0.13), (0, 0.135)], named("glaze_white"), 8)
    m.lathe([(0, 0.135), (0.013, 0.155), (0, 0.195)], named("lamp_bulb"), 6)
    for side in (-1, 1):
        m.part((side * 0.018, garden.LANTERN_RING - 0.025, 0), (0.006, 0.05, 0.006), "iron")
    m.part((0, garden.LANTERN_RING, 0), (0.042, 0.006, 0.006), "iron")
    return [m.obj("lantern", autosmooth=30)]


def chain_link():
    """Hangs from its origin."""
    m = HouseMesh()
    long, thick = garden.LINK + 0.014, 0.009
    for side in (-1, 1):
        m.part((side * 0.014, -garden.LINK / 2, 0), (thick, long, thick), "iron")
        m.part((0, -garden.LINK / 2 + side * (long - thick) / 2, 0), (0.02, thick, thick), "iron")
    return [m.obj("chain_link")]


def chime_tube():
    """A tube of length 1 on a cord of a fifth of that, below the origin."""
    m = HouseMesh()
    r = garden.CHIME_TUBE
    m.lathe([(r * 0.8, -0.2), (r, -0.2), (r, -1.2), (r * 0.8, -1.2), (r * 0.8, -0.2)][::-1], named("chime"), 8)
    m.part((0, -0.12, 0), (0.003, 0.24, 0.003), "rope")
    return [m.obj("chime_tube", autosmooth=50)]


def chime_clapper():
    m = HouseMesh()
    m.lathe([(0, -0.35), (0.035, -0.35), (0.035, -0.33), (0, -0.33)], named("oak"), 12)
    m.part((0, -0.34, 0), (0.003, 0.68, 0.003), "rope")
    m.part((0, -0.74, 0), (0.085, 0.13, 0.008), "oak")
    return [m.obj("chime_clapper", autosmooth=30)]


def barrow_wheel():
    """Its axle is the model's y axis."""
    m = HouseMesh()
    radius, width = garden.BARROW_WHEEL
    half = width / 2
    m.lathe([(radius - 0.045, -half), (radius - 0.01, -half), (radius, -half + 0.012), (radius, half - 0.012), (radius - 0.01, half),
             (radius - 0.045, half), (radius - 0.045, -half)], named("rubber"), 18)
    m.lathe([(0, -0.07), (0.025, -0.07), (0.025, 0.07), (0, 0.07)], named("iron"), 8)
    for i in range(3):
        m.part((0, 0, 0), (2 * radius - 0.08, 0.022, 0.022), "iron", yaw_deg=60 * i)
    return [m.obj("barrow_wheel", autosmooth=40)]


if __name__ == "__main__":
    reset()
    for piece in garden.BOXES:
        made = boards(piece)
        if piece == "gate_post":
            x, thick, top = garden.GATE_POST
            made.lathe([(thick * 0.6, top), (0, top + 0.12)], named("oak"), 8, ring=square)
        export([made.obj(piece)], piece, "NONE")
    for make in (watering_can, lantern, chain_link, chime_tube, chime_clapper, barrow_wheel):
        parts = make()
        export(parts, make.__name__, "NONE")
