"""What the fairground is made of: one .glb a piece, in plain colours. The measures are
fairground_plan.py's.

    blender -b --factory-startup -P bl_fairground.py -- . MODELS
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bl_garden import *  # noqa: E402,F403
import fairground_plan as fair  # noqa: E402

STRIPES = ("stripe", "cream")
COLORS = ("bulb_warm", "bulb_red", "bulb_warm", "bulb_green", "bulb_warm", "bulb_blue")


def sectors(m, profile, materials, count, keep=lambda k: True, scallop=0.0):
    """A lathe of `count` flat sectors in turn of these materials; the profile is (radius, height).
    `scallop`: how far the middle of a sector's last edge hangs down."""
    def at(r, y, k):
        angle = 2 * math.pi * k / count
        return (r * math.sin(angle), y, r * math.cos(angle))

    for k in range(count):
        if not keep(k):
            continue
        material = materials[k % len(materials)]
        for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
            points = [at(r0, y0, k), at(r0, y0, k + 1), at(r1, y1, k + 1), at(r1, y1, k)]
            if r1 < 1e-5:
                points = points[:3]
            m.quad(points, material)
        if scallop:
            r, y = profile[0]
            m.quad([at(r, y, k), at(r, y - scallop * 0.45, k), at(r, y - scallop, k + 0.5), at(r, y - scallop * 0.45, k + 1), at(r, y, k + 1)], material)


def bulb(m, centre, material, size=0.05):
    """Few triangles that pass for a ball of light."""
    x, y, z = centre
    if size < 0.055:
        levels, count = ((0, 1.1), (1, 0), (0, -1.1)), 4
    else:
        levels, count = ((0, 1), (0.85, 0.5), (0.85, -0.5), (0, -1)), 6

    def at(level, k):
        r, up = level
        angle = 2 * math.pi * k / count
        return (x + r * size * math.sin(angle), y + up * size, z + r * size * math.cos(angle))

    for upper, lower in zip(levels, levels[1:]):
        for k in range(count):
            points = [at(lower, k), at(lower, k + 1), at(upper, k + 1), at(upper, k)]
            m.quad(points[1:] if not lower[0] else points[:3] if not upper[0] else points, material)


def bulbs_round(m, radius, y, count, size=0.06):
    for k in range(count):
        angle = 2 * math.pi * (k + 0.5) / count
        bulb(m, (radius * math.sin(angle), y, radius * math.cos(angle)), COLORS[k % len(COLORS)], size)


def ride_base():
    m = HouseMesh()
    radius, height = fair.PLATFORM
    sectors(m, [(radius, 0), (radius, height), (0, height)], ("boards", "stripe"), 16)
    r, top = fair.MAST
    for i in range(10):
        sectors(m, [(r, height + i * (top - height) / 10), (r, height + (i + 1) * (top - height) / 10)], STRIPES if i % 2 else STRIPES[::-1], 8)
    m.lathe([(0, top), (0.2, top + 0.1), (0.28, top + 0.3), (0.2, top + 0.5), (0, top + 0.6)], named("gold"), 10)
    return [m.obj("ride_base", autosmooth=40)]


def ride_crown():
    """Turns about the mast; the origin is on the ground."""
    m = HouseMesh()
    rim, rim_y, top = fair.CANOPY
    radius, low, high = fair.RIDE_DRUM
    sectors(m, [(radius * 0.75, low), (radius, low + 0.15), (radius, high)], ("gold", "stripe", "cream", "stripe"), 16)
    sectors(m, [(0.3, low), (radius * 0.75, low)], ("stripe",), 16)
    for y in (low + 0.2, high - 0.35):
        bulbs_round(m, radius + 0.03, y, 16, 0.04)
    sectors(m, [(rim, rim_y), (rim * 0.55, rim_y + 0.75), (0.3, top)], STRIPES, 20, scallop=0.4)
    m.lathe([(rim, rim_y - 0.03), (rim + 0.06, rim_y), (rim, rim_y + 0.05)], named("gold"), 20)
    bulbs_round(m, rim + 0.08, rim_y, 40)
    bulbs_round(m, rim * 0.55 + 0.06, rim_y + 0.76, 20, 0.05)
    for k in range(fair.RIDE_CHAIRS):
        angle = 360 * k / fair.RIDE_CHAIRS
        out = (0.3 + fair.RIDE_RADIUS) / 2
        board(m, "gold", (out * math.sin(math.radians(angle)), fair.RIDE_ARM_Y + 0.04, out * math.cos(math.radians(angle))),
              (0.07, 0.08, fair.RIDE_RADIUS), (0, angle, 0))
    return [m.obj("ride_crown", autosmooth=30)]


def ride_chair():
    """Hangs from its origin and looks along +z."""
    m = HouseMesh()
    for part in fair.CHAIR:
        board(m, *part)
    for side in (-1, 1):
        for z in (-0.18, 0.18):
            bar(m, "iron", (side * 0.25, -fair.CHAIR_DROP + 0.24, z), (side * 0.03, -0.1, 0), 0.014)
    board(m, "iron", (0, -0.05, 0), (0.08, 0.1, 0.03))
    return [m.obj("ride_chair")]


def bar(m, material, a, b, thick):
    """A square bar between any two points."""
    way = Vector(b) - Vector(a)
    pitch = math.degrees(math.atan2(math.hypot(way.x, way.z), way.y))
    yaw = math.degrees(math.atan2(way.x, way.z))
    board(m, material, [(p + q) / 2 for p, q in zip(a, b)], (thick, way.length, thick), (pitch, yaw, 0))


def target():
    """The origin is the middle of the disc, which stands on a stem."""
    m = HouseMesh()
    radius, stem = fair.TARGET_RADIUS, fair.TARGET_STEM

    def ring(r, z, side=1):
        return [(side * r * math.sin(2 * math.pi * i / 16), r * math.cos(2 * math.pi * i / 16), z) for i in range(16)]

    board(m, "iron", (0, -radius - stem / 2, 0), (0.05, stem, 0.02))
    for k, (r, material) in enumerate(((radius, "cream"), (radius * 0.66, "stripe"), (radius * 0.3, "gold"))):
        for side in (-1, 1):
            m.quad(ring(r, side * (0.012 + 0.002 * k), -side), material)
    front, back = ring(radius, 0.012), ring(radius, -0.012)
    for i in range(16):
        j = (i + 1) % 16
        m.quad([front[i], back[i], back[j], front[j]], "stripe")
    return [m.obj("target")]


def tin():
    m = HouseMesh()
    r, h = fair.TIN
    for y0, y1, material in ((0, h * 0.25, "zinc"), (h * 0.25, h * 0.75, "stripe"), (h * 0.75, h, "zinc")):
        m.lathe([(r, y0 - h / 2), (r, y1 - h / 2)], named(material), 12)
    m.lathe([(r, h / 2), (0, h / 2)], named("zinc"), 12)
    m.lathe([(0, -h / 2), (r, -h / 2)], named("zinc"), 12)
    return [m.obj("fair_tin", autosmooth=40)]


LETTERS = {"T": "### .#. .#. .#. .#.", "I": "# # # # #", "N": "#..# ##.# #.## #..# #..#", "S": ".## #.. .#. ..# ##.", "C": ".## #.. #.. #.. .##",
           "A": ".#. #.# ### #.# #.#", "R": "##. #.# ##. #.# #.#", "G": ".## #.. #.# #.# .##", "E": "### #.. ##. #.. ###", "F": "### #.. ##. #.. #.."}


def lettering(m, text, middle, step, material, size):
    """Text of bulbs across x."""
    rows = [LETTERS[c].split() for c in text]
    width = sum(len(r[0]) + 1 for r in rows) - 1
    x = -(width - 1) / 2
    for letter in rows:
        for j, row in enumerate(letter):
            for i, dot in enumerate(row):
                if dot == "#":
                    bulb(m, (middle[0] + (x + i) * step, middle[1] + (2 - j) * step, middle[2]), material, size)
        x += len(letter[0]) + 1


def gallery():
    m = HouseMesh()
    random.seed(3)
    for part in fair.GALLERY:
        board(m, *part)
    half, top, front = fair.GALLERY_X / 2, fair.GALLERY_Y, fair.GALLERY_Z / 2
    count = 14
    for k in range(count):                          # the roof: a striped sheet that slopes back, and a valance
        x0, x1 = (-half - 0.2 + (2 * half + 0.4) * i / count for i in (k, k + 1))
        material = STRIPES[k % 2]
        ridge, eave = (top + 0.75, front + 0.7), (top - 0.05, -front - 0.15)
        m.quad([(x0, *ridge), (x1, *ridge), (x1, *eave), (x0, *eave)], material)
        m.quad([(x0, *ridge), (x0, ridge[0] - 0.25, ridge[1]), ((x0 + x1) / 2, ridge[0] - 0.42, ridge[1]), (x1, ridge[0] - 0.25, ridge[1]), (x1, *ridge)], material)
    board(m, "stripe", (0, top + 1.25, front + 0.66), (3.4, 0.85, 0.06))
    for y in (top + 0.82, top + 1.68):
        board(m, "gold", (0, y, front + 0.68), (3.5, 0.06, 0.09))
    lettering(m, "TARGETS", (0, top + 1.25, front + 0.73), 0.125, "bulb_warm", 0.045)
    for k in range(13):
        bulb(m, (-half + 2 * half * k / 12, top + 0.28, front + 0.76), COLORS[k % len(COLORS)], 0.055)
    return [m.obj("gallery")]


def tent(stripes=STRIPES):
    m = HouseMesh()
    radius, wall, top = fair.TENT
    sectors(m, [(radius, 0), (radius, wall)], stripes, 16, keep=lambda k: k not in (0, 15))
    sectors(m, [(radius + 0.25, wall - 0.05), (radius * 0.5, wall + 1.0), (0, top)], stripes, 16, scallop=0.35)
    for k in (1, 15):
        angle = 2 * math.pi * k / 16
        board(m, "gold", (radius * math.sin(angle), wall / 2, radius * math.cos(angle)), (0.07, wall, 0.07))
    board(m, "gold", (0, top + 0.3, 0), (0.04, 0.7, 0.04))
    m.quad([(0, top + 0.62, 0), (0, top + 0.34, 0), (0.5, top + 0.48, 0)], "pennant")
    bulbs_round(m, radius + 0.27, wall - 0.03, 24, 0.045)
    return [m.obj("fair_tent")]


def kiosk():
    m = HouseMesh()
    radius, wall = fair.KIOSK
    sectors(m, [(radius, 0), (radius, 1.05)], ("boards", "stripe"), 8)
    sectors(m, [(radius + 0.08, 1.05), (radius + 0.08, 1.12), (0, 1.12)], ("gold",), 8)
    sectors(m, [(radius - 0.04, 1.12), (radius - 0.04, wall - 0.2)], ("lit_glass",), 8)
    for k in range(8):
        angle = 2 * math.pi * k / 8
        board(m, "gold", (radius * math.sin(angle), (1.1 + wall) / 2, radius * math.cos(angle)), (0.07, wall - 1.1, 0.07))
    sectors(m, [(radius, wall - 0.2), (radius, wall)], ("boards", "stripe"), 8)
    sectors(m, [(radius + 0.35, wall - 0.05), (0.35, wall + 0.75), (0, wall + 1.25)], STRIPES, 16, scallop=0.25)
    bulbs_round(m, radius + 0.38, wall - 0.04, 16, 0.045)
    m.lathe([(0, wall + 1.2), (0.1, wall + 1.28), (0.1, wall + 1.38), (0, wall + 1.46)], named("gold"), 8)
    return [m.obj("kiosk", autosmooth=30)]


def light_string():
    """Bulbs on a wire that sags from (0, 0, 0) to (STRING, 0, 0)."""
    m = HouseMesh()
    pieces = fair.STRING_BULBS + 1

    def at(t):
        return (fair.STRING * t, -4 * fair.STRING_SAG * t * (1 - t), 0)

    for i in range(pieces):
        bar(m, "iron", at(i / pieces), at((i + 1) / pieces), 0.018)
    for i in range(1, pieces):
        x, y, z = at(i / pieces)
        bulb(m, (x, y - 0.09, z), COLORS[i % len(COLORS)], 0.062)
    return [m.obj("light_string")]


def pole():
    m = HouseMesh()
    for i in range(8):
        sectors(m, [(0.06, i * fair.POLE_Y / 8), (0.06, (i + 1) * fair.POLE_Y / 8)], (STRIPES[i % 2],), 6)
    sectors(m, [(0.2, 0), (0.16, 0.16), (0, 0.18)], ("iron",), 8)
    m.lathe([(0, fair.POLE_Y - 0.02), (0.09, fair.POLE_Y + 0.06), (0, fair.POLE_Y + 0.16)], named("gold"), 8)
    return [m.obj("fair_pole", autosmooth=40)]


def entrance():
    """An arch over the way in: two pillars and a board of bulbs, looking along -z and +z."""
    m = HouseMesh()
    for side in (-1, 1):
        board(m, "stripe", (side * 2.1, 1.75, 0), (0.35, 3.5, 0.35))
        for y in (0.1, 1.2, 2.3, 3.45):
            board(m, "gold", (side * 2.1, y, 0), (0.42, 0.1, 0.42))
    board(m, "stripe", (0, 3.75, 0), (4.9, 1.1, 0.16))
    for y in (3.2, 4.3):
        board(m, "gold", (0, y, 0), (5.0, 0.08, 0.22))
    lettering(m, "FAIR", (0, 3.75, 0.12), 0.19, "bulb_warm", 0.065)
    for k in range(17):
        x = -2.4 + 4.8 * k / 16
        bulb(m, (x, 4.42, 0), COLORS[k % len(COLORS)], 0.06)
        bulb(m, (x, 3.08, 0), COLORS[(k + 3) % len(COLORS)], 0.06)
    return [m.obj("fair_entrance")]


if __name__ == "__main__":
    reset()
    for make, name in ((ride_base, "ride_base"), (ride_crown, "ride_crown"), (ride_chair, "ride_chair"), (target, "target"), (tin, "fair_tin"),
                       (gallery, "gallery"), (tent, "fair_tent"), (lambda: tent(("stripe_blue", "cream")), "fair_tent_blue"), (kiosk, "kiosk"), (light_string, "light_string"), (pole, "fair_pole"), (entrance, "fair_entrance")):
        export(make(), name, "NONE")
