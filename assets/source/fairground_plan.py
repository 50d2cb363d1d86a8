"""The measures of the fairground: what bl_fairground.py draws and what make_fairground.py gives to
physics come from here, so that both agree. Metres in the scene's axes, +Y up.
"""
import math

# --- swing ride: chairs on chains round a mast

RIDE_CHAIRS, RIDE_RADIUS, RIDE_ARM_Y = 10, 2.7, 4.35    # the hooks' circle
RIDE_SPEED = 1.15                   # rad/s
CHAIR_DROP = 3.2                    # from the hook to the seat
CHAIR_MASS = 14.0
CANOPY = (3.45, 4.75, 6.3)          # radius and height of the rim, height of the top
RIDE_DRUM = (0.95, 3.3, 4.75)       # radius, bottom, top
PLATFORM = (1.5, 0.4)               # radius, height
MAST = (0.24, 7.0)                  # radius, height
CHAIR = [("seat", (0, -CHAIR_DROP, 0), (0.5, 0.045, 0.42)),
         ("seat", (0, -CHAIR_DROP + 0.26, -0.2), (0.5, 0.34, 0.035)),
         ("gold", (0, -CHAIR_DROP + 0.24, 0.2), (0.5, 0.03, 0.03)),
         *[("gold", (side * 0.25, -CHAIR_DROP + 0.24, 0), (0.03, 0.03, 0.42)) for side in (-1, 1)]]


def chair_center_of_mass():
    """Of its boards, as physics takes it: one density."""
    volumes = [size[0] * size[1] * size[2] for _, _, size in CHAIR]
    return tuple(sum(v * centre[i] for v, (_, centre, _) in zip(volumes, CHAIR)) / sum(volumes) for i in range(3))


def chair_angle():
    """How far out a chair hangs while the ride turns, rad: tan(a) = w^2 r / g at its centre of mass."""
    drop, angle = -chair_center_of_mass()[1], 0.5
    for _ in range(60):
        angle = math.atan(RIDE_SPEED ** 2 * (RIDE_RADIUS + drop * math.sin(angle)) / 9.81)
    return angle


# --- shooting gallery: x to both sides, open at +z

GALLERY_X, GALLERY_Z, GALLERY_Y = 5.2, 4.4, 3.1         # outside
COUNTER_Y, COUNTER_Z = 1.0, 2.0
SHELVES = ((1.62, -1.5), (2.12, -1.85))                # height of the top, z of the middle
SHELF_DEPTH = 0.34
TARGET_Y, TARGET_Z = 0.78, -0.75                        # of the hinges; the origin of a target is its disc's middle
TARGET_X = (-1.8, -0.9, 0.0, 0.9, 1.8)
TARGET_RADIUS, TARGET_STEM = 0.23, 0.2                  # disc above a stem
TIN = (0.085, 0.22)                                     # radius, height

GALLERY = [("boards", (0, GALLERY_Y / 2, -GALLERY_Z / 2 + 0.05), (GALLERY_X, GALLERY_Y, 0.1)),
           *[("boards", (side * (GALLERY_X / 2 - 0.05), GALLERY_Y / 2, 0), (0.1, GALLERY_Y, GALLERY_Z - 0.2)) for side in (-1, 1)],
           ("boards", (0, COUNTER_Y / 2, COUNTER_Z), (GALLERY_X - 0.2, COUNTER_Y - 0.06, 0.12)),
           ("oak", (0, COUNTER_Y - 0.03, COUNTER_Z), (GALLERY_X - 0.1, 0.06, 0.5)),
           *[("oak", (0, y - 0.025, z), (GALLERY_X - 0.8, 0.05, SHELF_DEPTH)) for y, z in SHELVES],
           *[("oak", (side * 1.9, y / 2 - 0.025, z), (0.08, y - 0.05, 0.2)) for y, z in SHELVES for side in (-1, 0, 1)],
           ("oak", (0, TARGET_Y - 0.06, TARGET_Z), (GALLERY_X - 0.8, 0.08, 0.1)),
           *[("oak", (x, TARGET_Y / 2 - 0.05, TARGET_Z), (0.09, TARGET_Y - 0.1, 0.09)) for x in (-2.15, 0, 2.15)],
           *[("gold", (side * (GALLERY_X / 2 - 0.05), GALLERY_Y / 2, GALLERY_Z / 2), (0.14, GALLERY_Y, 0.14)) for side in (-1, 1)]]

# --- tents, lights

TENT = (2.5, 2.1, 4.0)              # radius and height of the wall, height of the top
KIOSK = (0.95, 2.3)                 # radius, height of the wall
POLE_Y = 4.4
STRING, STRING_SAG, STRING_BULBS = 8.0, 0.55, 11
