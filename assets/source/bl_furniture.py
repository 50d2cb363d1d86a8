"""What stands in the garden's house: one .glb a piece. Pieces of boards are house_plan.BOXES, which
physics takes too; what is turned on a lathe is here.

    blender -b --factory-startup -P bl_furniture.py -- . MODELS
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bl_house import *  # noqa: E402,F403


def boards(name):
    random.seed(len(name))
    m = HouseMesh()
    for material, centre, size in plan.BOXES[name]:
        soft = material in ("linen", "cloth")
        m.part(centre, size, material, bevel=0.03 if soft else 0.0)
    if name == "stove":
        radius, bottom = plan.PIPE
        top = plan.CEILING - plan.FLOOR
        m.lathe([(radius, bottom), (radius, top)], named("iron"), 10, (0, 0.06, 0))
        m.lathe([(radius, top - 0.03), (radius + 0.05, top - 0.03), (radius + 0.05, top)], named("iron"), 10, (0, 0.06, 0))
    return m.obj(name)


def turned(name, profile, material, segments):
    m = HouseMesh()
    m.lathe(profile, named(material), segments)
    return m.obj(name, autosmooth=50)


def pot():
    return turned("pot", [(0, 0), (0.085, 0), (0.12, 0.17), (0.135, 0.17), (0.135, 0.205), (0.115, 0.205), (0.1, 0.14),
                          (0, 0.14)], "clay", 14)


def vase():
    return turned("vase", [(0, 0), (0.045, 0), (0.07, 0.06), (0.075, 0.11), (0.05, 0.18), (0.032, 0.22), (0.045, 0.26),
                           (0.038, 0.26), (0.025, 0.22), (0, 0.2)], "glaze", 14)


def mug():
    m = HouseMesh()
    m.lathe([(0, 0), (0.04, 0), (0.042, 0.09), (0.037, 0.09), (0.035, 0.01), (0, 0.01)], named("glaze_white"), 12)
    for centre, size in (((0.055, 0.068, 0), (0.03, 0.01, 0.012)), ((0.055, 0.028, 0), (0.03, 0.01, 0.012)),
                         ((0.068, 0.048, 0), (0.01, 0.05, 0.012))):
        m.part(centre, size, "glaze_white")
    return m.obj("mug", autosmooth=50)


def shade(m, bottom, top, y0, y1):
    """Cloth about a bulb: the outside, and an inside that glows."""
    for radii, material in (((bottom, top), "lamp_shade"), ((bottom - 0.004, top - 0.004), "lamp_shade")):
        profile = [(radii[0], y0), (radii[1], y1)]
        m.lathe(profile if radii[0] == bottom else profile[::-1], named(material), 14)


def pendant():
    """The origin is the bulb; the cord hangs from 0.6 m above it."""
    m = HouseMesh()
    m.part((0, 0.37, 0), (0.012, 0.46, 0.012), "iron")
    m.part((0, 0.105, 0), (0.04, 0.07, 0.04), "iron")
    shade(m, 0.22, 0.1, -0.06, 0.15)
    m.lathe([(0, -0.045), (0.03, -0.03), (0.04, 0.0), (0.03, 0.04), (0.015, 0.07)], named("lamp_bulb"), 10)
    return m.obj("lamp_pendant", autosmooth=50)


def table_lamp():
    """Stands on its origin."""
    m = HouseMesh()
    m.lathe([(0, 0), (0.075, 0), (0.075, 0.015), (0.03, 0.03), (0.018, 0.08), (0.03, 0.13), (0.014, 0.19), (0.01, 0.24)],
            named("glaze"), 12)
    shade(m, 0.12, 0.075, 0.2, 0.36)
    m.lathe([(0.012, 0.23), (0.03, 0.26), (0.03, 0.28), (0, 0.31)], named("lamp_bulb"), 8)
    return m.obj("lamp_table", autosmooth=50)


if __name__ == "__main__":
    reset()
    for piece in plan.BOXES:
        export([boards(piece)], "furniture_" + piece, "NONE")
    for make in (pot, vase, mug, pendant, table_lamp):
        made = make()
        export([made], made.name, "NONE")
