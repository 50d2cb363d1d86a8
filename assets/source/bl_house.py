"""The garden's house and shed and what moves on them: house.glb, shed.glb, door.glb, room_door.glb,
shutter.glb. The measures are house_plan.py's, where the axes are told.

    blender -b --factory-startup -P bl_house.py -- . MODELS

Rooms carry light in their vertex colours (materials vcol_*): how much of the sky each point sees
through the windows, and how near it is to other surfaces. Without it a room is as bright as a field.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bl_common import *  # noqa: E402,F403
from bl_room_light import bake  # noqa: E402
import house_plan as plan  # noqa: E402

CELL_M = 0.65  # of walls that carry baked light
TILE.update(vcol_plaster=2.0, vcol_floor=0.9, vcol_tiles=1.6, oak=0.9, gable=2.0)


def named(name, two_sided=False):
    """A material of which only the name counts: scenes bind it."""
    made = flat(name, (0.8, 0.8, 0.8))
    made.use_backface_culling = not two_sided
    return made


def blender(p):
    return Vector((p[0], -p[2], p[1]))


class HouseMesh(Mesh):
    """A mesh builder that takes the scene's axes."""

    def quad(self, points, material, uvs=None):
        self.face([blender(p) for p in points], named(material), uvs)

    def grid(self, a, b, c, d, material):
        """The quad a b c d in cells, so that colours at its vertices can vary."""
        a, b, c, d = (Vector(p) for p in (a, b, c, d))
        across = max(1, round((b - a).length / CELL_M))
        up = max(1, round((d - a).length / CELL_M))

        def at(i, j):
            return a.lerp(b, i / across).lerp(d.lerp(c, i / across), j / up)

        for i in range(across):
            for j in range(up):
                self.quad([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], material)

    def part(self, centre, size, material, yaw_deg=0.0, pitch_deg=0.0, bevel=0.0):
        """A box of one board or stone; boards differ in where their grain begins."""
        turn = Matrix.Rotation(math.radians(yaw_deg), 4, "Z") @ Matrix.Rotation(math.radians(pitch_deg), 4, "X")
        self.box(blender(centre), (size[0], size[2], size[1]), named(material), M=turn, bevel=bevel,
                 off=(random.random(), random.randrange(6) / 6))


def holed(m, u0, u1, y0, y1, holes, put):
    """Calls put(a, b, c, d) in u and y for what the holes leave of a rectangle."""
    us = sorted({u0, u1, *(min(max(u, u0), u1) for h in holes for u in h[:2])})
    ys = sorted({y0, y1, *(min(max(y, y0), y1) for h in holes for y in h[2:])})
    for a, b in zip(us, us[1:]):
        for c, d in zip(ys, ys[1:]):
            if not any(h[0] <= a and b <= h[1] and h[2] <= c and d <= h[3] for h in holes):
                put(a, b, c, d)


def reveals(m, wall, hole, d0, d1, material, open_top=False):
    """The sides of a hole from depth d0 to d1."""
    u0, u1, y0, y1 = hole
    sides = [((u0, y0), (u0, y1)), ((u1, y1), (u1, y0)), ((u1, y0), (u0, y0)), ((u0, y1), (u1, y1))]
    for (p, q), (r, s) in sides[:3] if open_top else sides:
        m.quad([wall.place(p, q, d0), wall.place(r, s, d0), wall.place(r, s, d1), wall.place(p, q, d1)], material)


def outer_wall(m, wall, half):
    inner = half - plan.THICK

    def face(material, depth):
        def put(a, b, c, d):
            m.quad([wall.place(a, c, depth), wall.place(b, c, depth), wall.place(b, d, depth), wall.place(a, d, depth)],
                   material)
        return put

    def inside(a, b, c, d):
        m.grid(wall.place(b, c, plan.THICK), wall.place(a, c, plan.THICK), wall.place(a, d, plan.THICK),
               wall.place(b, d, plan.THICK), "vcol_plaster")

    holed(m, -half, half, plan.PLINTH, plan.EAVES, wall.holes, face("plaster", 0))
    holed(m, -half - 0.04, half + 0.04, -0.3, plan.PLINTH, wall.holes, face("brick", -0.04))
    holed(m, -inner, inner, plan.FLOOR, plan.CEILING, wall.holes, inside)
    for hole in wall.holes:
        reveals(m, wall, hole, 0, plan.THICK, "plaster")
        if hole[2] < plan.PLINTH:
            reveals(m, wall, (hole[0], hole[1], hole[2], plan.PLINTH), -0.04, 0, "brick", open_top=True)
    # A stone course on the bricks, broken by the door.
    breaks = sorted((h[0], h[1]) for h in wall.holes if h[2] < plan.PLINTH)
    u = -half - 0.06
    for u0, u1 in [*breaks, (half + 0.06, half + 0.06)]:
        length = u0 - u
        m.part(wall.place((u + u0) / 2, plan.PLINTH, -0.02), (length, 0.07, 0.1), "stone", wall.yaw_deg)
        u = u1


def fitting(m, wall, hole):
    """Frame, lintel, and what belongs to a window only."""
    u0, u1, y0, y1 = hole
    middle, height = (u0 + u1) / 2, y1 - y0
    is_door = y0 < plan.SILL

    def part(u, y, depth, size, material):
        m.part(wall.place(u, y, depth), size, material, wall.yaw_deg)

    frame = plan.DOOR_FRAME
    for side in (-1, 1):
        part(middle + side * ((u1 - u0) / 2 - frame / 2), (y0 + y1) / 2, 0.12, (frame, height, 0.1), "oak")
    part(middle, y1 - frame / 2, 0.12, (u1 - u0 - 2 * frame, frame, 0.1), "oak")
    part(middle, y1 + 0.09, -0.005, (u1 - u0 + 0.36, 0.18, 0.07), "oak" if not is_door else "stone")
    if is_door:
        return
    part(middle, y0 + 0.03, 0.12, (u1 - u0 - 2 * frame, 0.06, 0.1), "oak")
    part(middle, (y0 + y1) / 2 + 0.01, plan.GLASS_DEPTH, (0.04, height - 0.1, 0.045), "oak")
    for share in (0.36, 0.68):
        part(middle, y0 + height * share, plan.GLASS_DEPTH, (u1 - u0 - 2 * frame, 0.03, 0.03), "oak")
    part(middle, y0 - 0.035, 0.0, (u1 - u0 + 0.18, 0.07, 0.24), "stone")
    part(middle, y0 - 0.015, plan.THICK + 0.03, (u1 - u0 + 0.1, 0.03, 0.12), "oak")
    g = [wall.place(u, y, plan.GLASS_DEPTH) for u, y in ((u0, y0), (u1, y0), (u1, y1), (u0, y1))]
    m.quad(g, "glass", [(0, 0), (1, 0), (1, 1), (0, 1)])
    m.part(wall.place(middle, y1 + plan.CURTAIN_ROD, plan.CURTAIN_DEPTH), (u1 - u0 + 0.5, 0.025, 0.025), "iron", wall.yaw_deg)


def inner_wall(m, wall):
    for depth, turned in ((0, False), (wall.thick, True)):
        def put(a, b, c, d):
            if turned:
                a, b = b, a
            m.grid(wall.place(a, c, depth), wall.place(b, c, depth), wall.place(b, d, depth), wall.place(a, d, depth),
                   "vcol_plaster")
        holed(m, -wall.half, wall.half, wall.bottom, wall.top, wall.holes, put)
    for u0, u1, y0, y1 in wall.holes:
        reveals(m, wall, (u0, u1, y0, y1), 0, wall.thick, "vcol_plaster")
        for side, u in ((-1, u0), (1, u1)):
            m.part(wall.place(u - side * 0.02, (y0 + y1) / 2, wall.thick / 2), (0.04, y1 - y0, wall.thick + 0.04), "oak",
                   wall.yaw_deg)
        m.part(wall.place((u0 + u1) / 2, y1 - 0.02, wall.thick / 2), (u1 - u0 - 0.08, 0.04, wall.thick + 0.04), "oak",
               wall.yaw_deg)


def rooms(m):
    """Floors, ceilings and beams; each room's floor of its own kind."""
    x, z, half = plan.HX - plan.THICK, plan.HZ - plan.THICK, plan.INNER_THICK / 2
    west, east, back = -plan.HALL_X, plan.HALL_X, plan.HALL_BACK_Z
    floors = [(-x, west - half, -z, z, "vcol_floor"), (west - half, east - half, -z, back - half, "vcol_floor"),
              (west + half, east - half, back - half, z, "vcol_tiles"), (east - half, x, -z, z, "vcol_floor")]
    for x0, x1, z0, z1, material in floors:
        m.grid((x0, plan.FLOOR, z1), (x1, plan.FLOOR, z1), (x1, plan.FLOOR, z0), (x0, plan.FLOOR, z0), material)
        m.grid((x0, plan.CEILING, z0), (x1, plan.CEILING, z0), (x1, plan.CEILING, z1), (x0, plan.CEILING, z1),
               "vcol_plaster")
    for bx in (-2.75, -1.85):
        m.part((bx, plan.CEILING - 0.07, 0), (0.14, 0.14, 2 * z), "oak")
    m.part((0, plan.CEILING - 0.07, (back - half - z) / 2), (0.14, 0.14, z + back - half), "oak")
    for bx in (1.6, 2.55):
        m.part((bx, plan.CEILING - 0.07, 0), (0.14, 0.14, 2 * z), "oak")
    # The doors' thresholds.
    m.part((0, plan.FLOOR - 0.03, plan.HZ - plan.THICK / 2), (plan.DOOR[0], 0.061, plan.THICK + 0.1), "stone")
    m.part((east, plan.FLOOR, plan.ROOM_DOOR_Z), (plan.INNER_THICK, 0.012, 0.9), "oak")


def roof(m):
    hz, top, over = plan.HZ, plan.RIDGE, plan.ROOF_OVER_GABLE
    pitch = math.atan2(plan.RIDGE - plan.EAVES, hz)
    cs, sn = math.cos(pitch), math.sin(pitch)
    length, x1, rows = (hz + plan.ROOF_OVER_EAVES) / cs, plan.HX + over, 10
    step = length / rows
    for side in (-1, 1):
        def at(x, s, lift):
            return (x, top - s * sn + lift * cs, side * (s * cs + lift * sn))

        def strip(near, far, lift_near, lift_far, material, uv=None):
            points = [at(-x1, far, lift_far), at(x1, far, lift_far), at(x1, near, lift_near), at(-x1, near, lift_near)]
            if side < 0:
                points = [points[1], points[0], points[3], points[2]]
            m.quad(points, material, uv and [uv(p, s) for p, s in zip(points, (far, far, near, near))])

        tile = 1 / TILE["roof"]
        for k in range(rows):  # courses of tiles, each a slab that stands out at its lower edge
            s0, s1 = k * step, (k + 1) * step + 0.05
            strip(s0, s1, 0.035, 0.10, "roof", lambda p, s: (p[0] * tile, -s * tile))
            edge = [at(-x1, s1, 0.06), at(x1, s1, 0.06), at(x1, s1, 0.10), at(-x1, s1, 0.10)]
            edge = edge if side > 0 else [edge[1], edge[0], edge[3], edge[2]]
            m.quad(edge, "roof", [(p[0] * tile, v) for p, v in zip(edge, (0, 0, 0.03, 0.03))])
        under = [at(-x1, 0, 0), at(x1, 0, 0), at(x1, length, 0), at(-x1, length, 0)]
        m.quad(under if side > 0 else under[::-1], "wood")
        front = [at(-x1, length, 0), at(x1, length, 0), at(x1, length, 0.09), at(-x1, length, 0.09)]
        m.quad(front if side > 0 else [front[1], front[0], front[3], front[2]], "wood")
        slope_deg = side * math.degrees(pitch)
        for end in (-1, 1):
            m.part(at(end * x1, length / 2 + 0.02, 0.02), (0.045, 0.2, length + 0.04), "oak", pitch_deg=slope_deg)
        for k in range(11):
            m.part(at(-plan.HX + 0.1 + k * (plan.WIDTH - 0.2) / 10, length - 0.35, -0.05), (0.08, 0.1, 0.7), "oak",
                   pitch_deg=slope_deg)
    ridge_tiles(m, x1)


def ridge_tiles(m, x1):
    count = 20
    width = 2 * x1 / count
    profile = [(math.cos(math.pi * q / 6) * 0.15, math.sin(math.pi * q / 6) * 0.17) for q in range(7)]
    for k in range(count):
        left, right = -x1 + k * width - 0.01, -x1 + (k + 1) * width + 0.01
        for i, ((z0, y0), (z1, y1)) in enumerate(zip(profile, profile[1:])):
            base = plan.RIDGE - 0.1  # their lower edges lie in the courses
            m.quad([(left, base + y0 * 1.1, z0 * 1.1), (right, base + y0, z0), (right, base + y1, z1),
                    (left, base + y1 * 1.1, z1 * 1.1)], "roof",
                   [(0.05, 0.27 + 0.012 * (i + 1)), (0.25, 0.27 + 0.012 * (i + 1)), (0.25, 0.27 + 0.012 * i), (0.05, 0.27 + 0.012 * i)])


def gables(m):
    for side in (-1, 1):
        x = side * plan.HX
        points = [(x, plan.EAVES, plan.HZ), (x, plan.EAVES, -plan.HZ), (x, plan.RIDGE, 0)]
        m.quad(points if side > 0 else [points[1], points[0], points[2]], "plaster")
        y = plan.EAVES + 0.85
        for across, up, out in ((0.62, 0.62, 0.04), (0.46, 0.46, 0.06)):
            m.part((x, y, 0), (out * 2, up, across), "oak" if out < 0.05 else "iron")
        m.part((x, y, 0), (0.15, 0.48, 0.035), "oak")
        m.part((x, y, 0), (0.15, 0.035, 0.48), "oak")
    x, z = plan.CHIMNEY
    corners = [(x - 0.31, z + 0.31), (x + 0.31, z + 0.31), (x + 0.31, z - 0.31), (x - 0.31, z - 0.31)]
    low, high = plan.RIDGE - 1, plan.RIDGE + 0.9
    for (x0, z0), (x1, z1) in zip(corners, corners[1:] + corners[:1]):  # not a part: its courses lie level
        m.quad([(x0, low, z0), (x1, low, z1), (x1, high, z1), (x0, high, z0)], "brick")
    m.part((x, plan.RIDGE + 0.94, z), (0.74, 0.1, 0.74), "stone")
    m.lathe([(0.13, 0), (0.12, 0.3), (0.14, 0.34), (0.09, 0.34), (0.09, 0.1)], named("roof"), 10,
            blender((x, plan.RIDGE + 0.98, z)))


def house():
    random.seed(7)
    m = HouseMesh()
    for wall in plan.OUTER:
        outer_wall(m, wall, plan.HX if wall.name in ("front", "back") else plan.HZ)
        for hole in wall.holes:
            fitting(m, wall, hole)
    for wall in plan.INNER:
        inner_wall(m, wall)
    west = plan.INNER[0]  # the one whose end stands free
    m.grid(west.place(-west.half, plan.FLOOR, west.thick), west.place(-west.half, plan.FLOOR, 0),
           west.place(-west.half, plan.CEILING, 0), west.place(-west.half, plan.CEILING, west.thick), "vcol_plaster")
    rooms(m)
    roof(m)
    gables(m)
    m.part(plan.STEP[0], plan.STEP[1], "stone", bevel=0.015)
    made = m.obj("house", weld=0)
    front = plan.OUTER[0]
    u0, u1, y0, y1 = front.holes[2]
    bake(made, [[blender(front.place(u, y, 0.11)) for u, y in ((u0, y0), (u1, y0), (u1, y1), (u0, y1))]])
    return made


# --- what turns on hinges: the origin lies on the hinge


def leaf(name, size, planks, handle):
    """A door of boards: both sides alike, the hinge at x = 0, standing on y = 0."""
    random.seed(11)
    m = HouseMesh()
    width, height, thick = size
    for i in range(planks):
        m.part(((i + 0.5) * width / planks, height / 2, 0), (width / planks - 0.004, height, thick * 0.7), "paintwood")
    m.part((width / 2, height / 2, 0), (width - 0.01, height - 0.01, thick * 0.4), "oak")  # behind the gaps
    for y in (0.25, height / 2, height - 0.25):
        m.part((width / 2, y, 0), (width - 0.06, 0.12, thick), "paintwood")
    for side in (-1, 1):
        m.part((width - 0.09, handle, side * (thick / 2 + 0.004)), (0.04, 0.16, 0.012), "iron")
        m.part((width - 0.12, handle + 0.02, side * (thick / 2 + 0.045)), (0.12, 0.02, 0.02), "iron")
        m.part((width - 0.075, handle + 0.02, side * (thick / 2 + 0.025)), (0.02, 0.02, 0.05), "iron")
    return m.obj(name)


def shutter():
    """Hinge at x = 0, origin at half its height, the wall behind z = 0; half a turn about z makes it
    a left one."""
    random.seed(13)
    m = HouseMesh()
    width, height, thick = plan.SHUTTER
    for i in range(4):
        m.part(((i + 0.5) * width / 4, 0, thick / 2), (width / 4 - 0.003, height, thick), "paintwood")
    for y in (-height / 2 + 0.18, height / 2 - 0.18):
        m.part((width / 2, y, thick + 0.008), (width - 0.04, 0.09, 0.018), "paintwood")
    return m.obj("shutter")


def shed():
    random.seed(17)
    m = HouseMesh()
    x, z, t = plan.SHED_X / 2, plan.SHED_Z / 2, plan.SHED_WALL
    front, back, floor = plan.SHED_FRONT, plan.SHED_BACK, plan.SHED_FLOOR
    d0, d1, top = plan.SHED_DOOR

    def height(at_z):
        return back + (front - back) * (at_z + z) / (2 * z)

    def board_wall(a, b, flip, low=0.0):
        """Both faces of a wall from a to b (x, z), its top under the roof."""
        for points, turned in ((a, False), (b, True)):
            (x0, z0), (x1, z1) = points
            quad = [(x0, low, z0), (x1, low, z1), (x1, height(z1), z1), (x0, height(z0), z0)]
            m.quad(quad if turned == flip else quad[::-1], "paintwood" if turned else "wood")

    board_wall(((-x, z), (d0, z)), ((-x, z - t), (d0, z - t)), True)
    board_wall(((d1, z), (x, z)), ((d1, z - t), (x, z - t)), True)
    board_wall(((d0, z), (d1, z)), ((d0, z - t), (d1, z - t)), True, top)
    board_wall(((x, -z), (-x, -z)), ((x, -z + t), (-x, -z + t)), True)
    board_wall(((x, z), (x, -z)), ((x - t, z), (x - t, -z)), True)
    board_wall(((-x, -z), (-x, z)), ((-x + t, -z), (-x + t, z)), True)
    for side, u in ((1, d0), (-1, d1)):
        m.part((u + side * 0.03, top / 2, z - t / 2), (0.07, top, t + 0.05), "wood")
    m.part(((d0 + d1) / 2, top - 0.03, z - t / 2), (d1 - d0 - 0.08, 0.07, t + 0.05), "wood")
    m.part((0, floor / 2, 0), (2 * x - 0.01, floor, 2 * z - 0.01), "wood")
    for corner_x in (-x, x):
        for corner_z in (-z, z):
            m.part((corner_x, height(corner_z) / 2, corner_z), (0.09, height(corner_z), 0.09), "wood")
    slope = math.atan2(front - back, 2 * z)
    over, thick = plan.SHED_OVER, plan.SHED_ROOF_THICK
    for material, bottom, layer, rim in (("wood", 0, 0.025, 0.02), ("roof", 0.025, thick - 0.025, 0)):
        m.part((0, height(0) + (bottom + layer / 2) / math.cos(slope), 0),
               (2 * (x + over - rim), layer, 2 * (z + over - rim) / math.cos(slope)), material, pitch_deg=-math.degrees(slope))
    return m.obj("shed")


if __name__ == "__main__":
    reset()
    export([house()], "house", "NONE")
    export([leaf("door", plan.DOOR_LEAF, 5, 0.98)], "door", "NONE")
    export([leaf("room_door", plan.ROOM_DOOR_LEAF, 4, 0.95)], "room_door", "NONE")
    export([shutter()], "shutter", "NONE")
    export([shed()], "shed", "NONE")
