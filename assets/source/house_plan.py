"""The measures of the garden's house and shed, and of what stands in them: what the Blender scripts
draw and what make_garden.py gives to physics come from here, so that both agree.

Metres in the scene's axes: +X to the right and +Z towards one who looks at the front, +Y up. The
origin lies on the ground under the middle of the house.
"""

WIDTH, DEPTH = 7.2, 5.6             # outside
THICK, INNER_THICK = 0.22, 0.12     # of outer and inner walls
FLOOR, CEILING, EAVES = 0.12, 2.62, 2.9
RIDGE = 5.42                        # 42 degrees of pitch
PLINTH = 0.55                       # top of the bricks
ROOF_OVER_EAVES, ROOF_OVER_GABLE, ROOF_THICK = 0.45, 0.4, 0.14
CHIMNEY = (-3.0, -1.3)              # x, z
STEP = ((0, 0.06, 3.15), (1.7, 0.12, 0.7))  # before the door: centre, size

WINDOW = (0.95, 1.25)               # width, height
SILL = 1.05
DOOR = (1.05, 2.18)                 # of the opening: width, top
DOOR_LEAF = (0.948, 2.005, 0.05)
ROOM_DOOR_LEAF = (0.81, 1.945, 0.04)
DOOR_FRAME = 0.045                  # its thickness on either side
SHUTTER = (0.46, 1.21, 0.035)
GLASS_DEPTH = 0.15                  # of the panes, behind the wall's outer face
CURTAIN = (0.34, 3, 0.6, 0.2)       # as it hangs in folds: width, folds, its share of the flat width, how much is beside the window
CURTAIN_ROD = 0.12                  # above the window
CURTAIN_DEPTH = THICK + 0.075       # of rod and cloth, behind the wall's outer face


def window(u):
    return (u - WINDOW[0] / 2, u + WINDOW[0] / 2, SILL, SILL + WINDOW[1])


class Wall:
    """`place(u, y, d)` is the point u along the wall (to the right, seen from outside), y above the
    ground, d behind its face. Holes are (u0, u1, y0, y1)."""

    def __init__(self, name, place, half, thick, bottom, top, holes, yaw_deg):
        self.name, self.place, self.half, self.thick = name, place, half, thick
        self.bottom, self.top, self.holes, self.yaw_deg = bottom, top, holes, yaw_deg

    def windows(self):
        return [hole for hole in self.holes if hole[2] == SILL]

    def boxes(self):
        """The wall without its holes, as (centre, size) of upright boxes."""
        edges = sorted({-self.half, self.half, *(u for h in self.holes for u in h[:2])})
        for u0, u1 in zip(edges, edges[1:]):
            cuts = [(h[2], h[3]) for h in self.holes if h[0] <= u0 and u1 <= h[1]]
            y = self.bottom
            for y0, y1 in [*sorted(cuts), (self.top, self.top)]:
                if y0 > y:
                    yield self.box(u0, u1, y, y0, 0, self.thick)
                y = y1

    def box(self, u0, u1, y0, y1, d0, d1):
        a, b = self.place(u0, y0, d0), self.place(u1, y1, d1)
        return (tuple((p + q) / 2 for p, q in zip(a, b)), tuple(abs(p - q) for p, q in zip(a, b)))


HX, HZ = WIDTH / 2, DEPTH / 2
OUTER = [
    Wall("front", lambda u, y, d: (u, y, HZ - d), HX, THICK, -0.3, EAVES,
         [window(-2.3), window(2.3), (-DOOR[0] / 2, DOOR[0] / 2, FLOOR, DOOR[1])], 0),
    Wall("back", lambda u, y, d: (-u, y, d - HZ), HX, THICK, -0.3, EAVES,
         [window(-2.0), window(0), window(2.0)], 180),
    Wall("east", lambda u, y, d: (HX - d, y, -u), HZ - THICK, THICK, -0.3, EAVES,
         [window(-1.2), window(1.2)], 90),
    Wall("west", lambda u, y, d: (d - HX, y, u), HZ - THICK, THICK, -0.3, EAVES, [window(0)], -90),
]
# The hall lies behind the front door, the bedroom to the right of it; the rest is one room.
HALL_X, HALL_BACK_Z = 0.86, 0.1     # middles of the hall's walls
ARCH = (-0.55, 0.55, FLOOR, 2.25)
ROOM_DOOR_Z = 1.2                   # the middle of the bedroom's door
_half = INNER_THICK / 2
_front_z = HZ - THICK
_side = (_front_z - (HALL_BACK_Z - _half)) / 2
INNER = [
    Wall("hall_west", lambda u, y, d: (-HALL_X - _half + d, y, _front_z - _side + u), _side,
         INNER_THICK, FLOOR, CEILING, [], -90),
    Wall("hall_east", lambda u, y, d: (HALL_X - _half + d, y, u), _front_z, INNER_THICK, FLOOR,
         CEILING, [(ROOM_DOOR_Z - 0.45, ROOM_DOOR_Z + 0.45, FLOOR, 2.12)], -90),
    Wall("hall_back", lambda u, y, d: (-u, y, HALL_BACK_Z - _half + d), HALL_X - _half, INNER_THICK,
         FLOOR, CEILING, [ARCH], 180),
]

# --- furniture: parts as (material, centre, size), the origin on the floor under the middle


def _legs(material, x, z, top, thick):
    return [(material, (sx * x, top / 2, sz * z), (thick, top, thick)) for sx in (-1, 1) for sz in (-1, 1)]


CHAIR = [("oak", (0, 0.445, 0), (0.42, 0.03, 0.42)), *_legs("oak", 0.185, 0.185, 0.43, 0.04),
         ("oak", (-0.185, 0.68, -0.195), (0.04, 0.44, 0.03)), ("oak", (0.185, 0.68, -0.195), (0.04, 0.44, 0.03)),
         ("oak", (0, 0.84, -0.195), (0.33, 0.1, 0.02)), ("oak", (0, 0.64, -0.195), (0.33, 0.07, 0.02))]
TABLE = [("oak", (0, 0.735, 0), (1.35, 0.035, 0.82)), *_legs("oak", 0.6, 0.34, 0.7175, 0.06),
         ("oak", (0, 0.665, 0.34), (1.14, 0.09, 0.025)), ("oak", (0, 0.665, -0.34), (1.14, 0.09, 0.025)),
         ("oak", (0.6, 0.665, 0), (0.025, 0.09, 0.62)), ("oak", (-0.6, 0.665, 0), (0.025, 0.09, 0.62))]
DESK = [("wood", (0, 0.725, 0), (1.05, 0.03, 0.5)), *_legs("wood", 0.48, 0.21, 0.71, 0.05),
        ("wood", (0, 0.66, -0.21), (0.91, 0.1, 0.02)), ("wood", (0, 0.66, 0.21), (0.91, 0.1, 0.02))]
STOOL = [("wood", (0, 0.435, 0), (0.36, 0.03, 0.36)), *_legs("wood", 0.14, 0.14, 0.42, 0.04)]
BENCH = [("oak", (0, 0.43, 0), (1.0, 0.04, 0.34)), ("oak", (-0.42, 0.205, 0), (0.05, 0.41, 0.3)),
         ("oak", (0.42, 0.205, 0), (0.05, 0.41, 0.3)), ("oak", (0, 0.15, 0), (0.79, 0.07, 0.03))]
SHELF_LEVELS = (0.1, 0.52, 0.94, 1.36)  # tops of the boards that things stand on
SHELF = [("oak", (-0.44, 0.9, 0), (0.03, 1.8, 0.28)), ("oak", (0.44, 0.9, 0), (0.03, 1.8, 0.28)),
         *[("oak", (0, top - 0.0125, 0.005), (0.85, 0.025, 0.27)) for top in (*SHELF_LEVELS, 1.79)],
         ("oak", (0, 0.91, -0.135), (0.85, 1.76, 0.01)), ("oak", (0, 0.0375, 0), (0.85, 0.075, 0.26))]
BED = [("oak", (0, 0.27, 0), (0.96, 0.14, 1.96)), ("oak", (0, 0.5, -1.0), (1.0, 1.0, 0.04)),
       ("oak", (0, 0.34, 1.0), (1.0, 0.68, 0.04)), ("linen", (0, 0.42, 0), (0.9, 0.16, 1.94)),
       ("cloth", (0, 0.438, 0.3), (0.93, 0.17, 1.35))]
CHEST = [("paintwood", (0, 0.2, 0), (0.86, 0.4, 0.44)), ("paintwood", (0, 0.43, 0), (0.9, 0.06, 0.48)),
         ("iron", (-0.28, 0.22, 0.005), (0.04, 0.44, 0.445)), ("iron", (0.28, 0.22, 0.005), (0.04, 0.44, 0.445)),
         ("iron", (0, 0.38, 0.225), (0.08, 0.1, 0.02))]
COUNTER = [("paintwood", (0, 0.45, 0.01), (1.8, 0.78, 0.54)), ("stone", (0, 0.86, 0), (1.86, 0.04, 0.6)),
           ("oak", (0, 0.03, 0.03), (1.78, 0.06, 0.48)),
           *[("wood", (x, 0.45, -0.265), (0.56, 0.7, 0.02)) for x in (-0.6, 0, 0.6)],
           *[("iron", (x + 0.22, 0.62, -0.285), (0.02, 0.1, 0.02)) for x in (-0.6, 0, 0.6)]]
STOVE = [("iron", (0, 0.45, 0), (0.5, 0.62, 0.42)), ("iron", (0, 0.78, 0), (0.56, 0.04, 0.48)),
         *_legs("iron", 0.2, 0.16, 0.14, 0.05), ("ember", (0, 0.42, 0.212), (0.24, 0.14, 0.006)),
         ("rustmetal", (0, 0.36, 0.214), (0.3, 0.03, 0.02)), ("rustmetal", (0.19, 0.45, 0.22), (0.03, 0.12, 0.03))]
BOXES = {"chair": CHAIR, "table": TABLE, "desk": DESK, "stool": STOOL, "bench": BENCH, "shelf": SHELF,
         "bed": BED, "chest": CHEST, "counter": COUNTER, "stove": STOVE}
PIPE = (0.075, 0.8)                 # the stove's: radius, from this height to the ceiling

# --- the shed: walls of boards under a roof that slopes to the back

SHED_X, SHED_Z, SHED_WALL = 3.2, 2.6, 0.06
SHED_FLOOR, SHED_FRONT, SHED_BACK = 0.06, 2.55, 2.15  # heights of the walls' tops
SHED_DOOR = (-0.6, 1.1, 2.1)        # x0, x1, top
SHED_OVER, SHED_ROOF_THICK = 0.28, 0.08
