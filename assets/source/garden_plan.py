"""The measures of what stands and hangs in the garden: what bl_garden.py draws and what
garden_things.py gives to physics come from here, so that both agree.

Metres in the scene's axes, +Y up. A piece is a list of boards (material, centre, size) or, with the
angles that rotation_deg takes, (material, centre, size, turn_deg). Pieces stand on their origin;
what hangs or turns has it on the axis.
"""
import math

GATE_WIDTH, GATE_HEIGHT, GATE_THICK = 0.905, 1.12, 0.045
GATE_HINGE_X = 0.925                # of either leaf, from the middle of the way
GATE_POST = (1.02, 0.16, 1.42)      # x, thickness, height


def _gate():
    """A leaf that reaches from its hinge along +x; pickets rise to the middle of the gate."""
    boards = [("paintwood", (GATE_WIDTH / 2, y, 0.012), (GATE_WIDTH, 0.09, 0.022)) for y in (0.22, 0.86)]
    run, rise = GATE_WIDTH - 0.12, 0.86 - 0.22
    boards.append(("paintwood", (GATE_WIDTH / 2, 0.54, 0.012), (math.hypot(run, rise), 0.075, 0.018), (0, 0, math.degrees(math.atan2(rise, run)))))
    for i in range(7):
        top = 0.98 + 0.14 * math.sin(math.pi / 2 * i / 6)
        boards.append(("paintwood", (0.05 + i * (GATE_WIDTH - 0.1) / 6, (top + 0.06) / 2, -0.011), (0.085, top - 0.06, 0.022)))
    boards += [("iron", (0.16, y, 0.025), (0.32, 0.035, 0.006)) for y in (0.22, 0.86)]
    boards.append(("iron", (GATE_WIDTH - 0.05, 0.7, 0.03), (0.03, 0.16, 0.02)))
    return boards


# --- swing: a frame of two A's, and a seat on two ropes

SWING_AXIS_Y = 2.65                 # of the hooks; who stands on the seat has room
SWING_HALF_X, SWING_FOOT_Z = 0.95, 0.95
ROPE_X, ROPE_THICK = 0.42, 0.028
SEAT_TOP = 0.46                     # above the ground
SEAT = (0.92, 0.045, 0.3)


def _swing_frame():
    lean = math.degrees(math.atan2(SWING_FOOT_Z, SWING_AXIS_Y + 0.05))
    length = math.hypot(SWING_FOOT_Z, SWING_AXIS_Y + 0.05)
    boards = [("oak", (0, SWING_AXIS_Y + 0.06, 0), (2.3, 0.11, 0.11))]
    for x in (-SWING_HALF_X, SWING_HALF_X):
        for side in (-1, 1):
            boards.append(("oak", (x, (SWING_AXIS_Y + 0.05) / 2, side * SWING_FOOT_Z / 2), (0.085, length, 0.085), (-side * lean, 0, 0)))
        boards.append(("oak", (x, 0.95, 0), (0.06, 0.07, 2 * SWING_FOOT_Z * (1 - 0.95 / (SWING_AXIS_Y + 0.05)))))
    return boards


def _swing():
    """Its origin is the middle of the axis that it swings about."""
    bottom = SEAT_TOP - SEAT[1] - SWING_AXIS_Y
    boards = [("paintwood", (0, bottom + SEAT[1] / 2, 0), SEAT)]
    for x in (-ROPE_X, ROPE_X):
        boards.append(("rope", (x, (bottom + SEAT[1]) / 2, 0), (ROPE_THICK, -bottom - SEAT[1], ROPE_THICK)))
    return boards


# --- seesaw

SEESAW_AXIS_Y, SEESAW_HALF, SEESAW_TIP_DEG = 0.56, 1.6, 15.0
SEESAW = [("paintwood", (0, 0, 0), (2 * SEESAW_HALF, 0.055, 0.3)),
          *[("iron", (x, 0.15, z), (0.03, 0.25, 0.03)) for x in (-1.0, 1.0) for z in (-0.1, 0.1)],
          *[("oak", (x, 0.275, 0), (0.04, 0.04, 0.36)) for x in (-1.0, 1.0)]]
SEESAW_BASE = [*[("oak", (side * 0.13, 0.24, z), (0.09, 0.53, 0.06), (0, 0, side * 26)) for side in (-1, 1) for z in (-0.2, 0.2)],
               *[("oak", (0, 0.035, z), (0.7, 0.07, 0.07)) for z in (-0.2, 0.2)],
               ("iron", (0, 0.46, 0), (0.06, 0.06, 0.5))]

# --- a bench to sit on, with a back

GARDEN_BENCH = [*[("oak", (0, 0.435, z), (1.5, 0.03, 0.085)) for z in (-0.16, -0.065, 0.03, 0.125)],
                *[("oak", (0, y, -0.225), (1.5, 0.085, 0.025)) for y in (0.56, 0.68, 0.8)],
                *[("iron", (x, 0.21, 0.13), (0.05, 0.42, 0.05)) for x in (-0.66, 0.66)],
                *[("iron", (x, 0.42, -0.215), (0.05, 0.84, 0.03)) for x in (-0.66, 0.66)],
                *[("iron", (x, 0.4, -0.04), (0.05, 0.04, 0.36)) for x in (-0.66, 0.66)],
                *[("iron", (x, 0.63, -0.03), (0.05, 0.03, 0.38)) for x in (-0.66, 0.66)],
                *[("iron", (x, 0.53, 0.14), (0.04, 0.22, 0.04)) for x in (-0.66, 0.66)]]
BENCH_TOP = 0.45

# --- a windmill as tall as a person can reach

MILL_HUB = (0, 2.75, 0.3)           # the sails turn before the tower, about +z
MILL_REACH = 0.85
_BLADES = 8


def _mill_tower():
    boards, height, foot, top = [], 2.45, 0.42, 0.13
    lean = math.degrees(math.atan2(foot - top, height))
    for sx in (-1, 1):
        for sz in (-1, 1):
            # leans to the middle both ways; the angles are small enough to turn one after the other
            boards.append(("oak", (sx * (foot + top) / 2, height / 2, sz * (foot + top) / 2),
                           (0.065, height / math.cos(math.radians(lean)) ** 2, 0.065), (-sz * lean, 0, sx * lean)))
    for y in (0.35, 1.05, 1.75):
        half = foot + (top - foot) * y / height
        for side in (-1, 1):
            boards.append(("oak", (0, y, side * half), (2 * half, 0.05, 0.03)))
            boards.append(("oak", (side * half, y, 0), (0.03, 0.05, 2 * half)))
    boards.append(("paintwood", (0, MILL_HUB[1], -0.03), (0.26, 0.3, 0.46)))
    boards.append(("oak", (0, MILL_HUB[1] + 0.19, -0.03), (0.34, 0.05, 0.54)))
    boards.append(("oak", (0, MILL_HUB[1] - 0.19, -0.03), (0.32, 0.08, 0.5)))
    boards.append(("oak", (0, MILL_HUB[1] + 0.02, -0.55), (0.04, 0.05, 0.7)))
    boards.append(("paintwood", (0, MILL_HUB[1] + 0.06, -0.88), (0.025, 0.42, 0.36)))
    return boards


def _mill_rotor():
    """The origin is the hub. A blade is one board, set at 20 degrees to the wind."""
    boards = [("iron", (0, 0, -0.03), (0.12, 0.12, 0.2))]
    middle = (0.2 + MILL_REACH) / 2
    for i in range(_BLADES):
        turn = 360 * i / _BLADES
        across = math.radians(turn)
        for material, r0, r1, width in (("oak", 0.05, 0.32, 0.035), ("blade", 0.3, MILL_REACH, 0.2)):
            r = (r0 + r1) / 2
            boards.append((material, (-r * math.sin(across), r * math.cos(across), 0), (width, r1 - r0, 0.018), (0, 20, turn)))
    return boards


# --- what hangs from an arm

HOOK_POST_Y = 2.35                  # of the arm
HOOK_REACH = 0.5                    # of the hook from the post, along -x
HOOK_POST = [("iron", (0, 1.2, 0), (0.055, 2.4, 0.055)), ("stone", (0, 0.05, 0), (0.26, 0.1, 0.26)),
             ("iron", (-0.26, HOOK_POST_Y, 0), (0.56, 0.035, 0.035)),
             ("iron", (-0.14, HOOK_POST_Y - 0.14, 0), (0.36, 0.025, 0.025), (0, 0, -45)),
             ("iron", (-HOOK_REACH, HOOK_POST_Y - 0.04, 0), (0.014, 0.08, 0.014))]
LINK = 0.075                        # from one link of the chain to the next
LANTERN = (0.17, 0.3)               # width, height of the frame; its ring is 7 cm higher
LANTERN_RING = 0.37
CHIME_TUBES = (0.34, 0.38, 0.42, 0.46, 0.5)     # lengths
CHIME_RADIUS, CHIME_TUBE = 0.075, 0.013         # of the ring that they hang in; of a tube
CHIME_CORD = 0.08

# --- wheelbarrow: it runs towards +z, the handles at -z. Put down it stands on four stays

BARROW_WHEEL = (0.19, 0.07)         # radius, width
BARROW_AXLE = (0, 0.196, 0.62)       # the wheel is 6 mm over the ground until the handles are lifted
BARROW = [("rustmetal", (0, 0.36, 0.05), (0.5, 0.025, 0.62)),
          ("rustmetal", (0, 0.47, 0.39), (0.54, 0.26, 0.025), (28, 0, 0)),
          ("rustmetal", (0, 0.46, -0.28), (0.54, 0.22, 0.025), (-18, 0, 0)),
          *[("rustmetal", (side * 0.28, 0.46, 0.05), (0.025, 0.23, 0.7), (0, 0, -side * 16)) for side in (-1, 1)],
          *[("oak", (side * 0.21, 0.335, -0.06), (0.045, 0.045, 1.55), (8, 0, 0)) for side in (-1, 1)],
          *[("iron", (side * 0.21, 0.165, -0.28), (0.035, 0.33, 0.035)) for side in (-1, 1)],
          *[("iron", (side * 0.21, 0.14, 0.36), (0.03, 0.28, 0.03)) for side in (-1, 1)],
          ("iron", (0, 0.1, -0.28), (0.4, 0.025, 0.025)),
          *[("iron", (side * 0.21, 0.225, BARROW_AXLE[2]), (0.02, 0.13, 0.035)) for side in (-1, 1)]]

GATE_POST_BOARDS = [("oak", (0, GATE_POST[2] / 2, 0), (GATE_POST[1], GATE_POST[2], GATE_POST[1])),
                    ("oak", (0, GATE_POST[2] - 0.1, 0), (GATE_POST[1] + 0.03, 0.03, GATE_POST[1] + 0.03))]

BOXES = {"gate": _gate(), "gate_post": GATE_POST_BOARDS, "swing_frame": _swing_frame(), "swing": _swing(), "seesaw": SEESAW, "seesaw_base": SEESAW_BASE,
         "garden_bench": GARDEN_BENCH, "windmill": _mill_tower(), "windmill_rotor": _mill_rotor(), "hook_post": HOOK_POST,
         "wheelbarrow": BARROW}
