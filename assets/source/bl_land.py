"""The country round the garden, as far as one sees: land_south.glb, _east, _north, _west.

    blender -b --factory-startup -P bl_land.py -- . MODELS

Each is a quarter of a ring from the lawn's edge to the hills: fields in their colours, hedges, single
trees and woods, all coloured at the vertices and of few triangles (about 1500 together).
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bl_common import *  # noqa: E402,F403

LAWN_HALF_M = 60.0
RINGS_M = (60, 72, 92, 122, 165, 225, 300, 400)
COLUMNS = 12
GRASS = (0.073, 0.104, 0.0215)  # the lawn's mean
FIELDS = [(0.10, 0.15, 0.035), (0.14, 0.18, 0.05), (0.30, 0.26, 0.10), (0.075, 0.12, 0.03), (0.20, 0.20, 0.07), (0.11, 0.14, 0.04)]
LEAVES = [(0.065, 0.11, 0.024), (0.085, 0.13, 0.03), (0.07, 0.10, 0.03)]


def rise(x, y):
    """Height of the land: flat at the lawn, hills behind."""
    far = math.hypot(x, y)
    share = min(1.0, max(0.0, (far - 95) / 240))
    rolling = noise.noise(Vector((x / 150, y / 150, 3.7))) + 0.5 * noise.noise(Vector((x / 60, y / 60, 9.1)))
    return share * share * (3 - 2 * share) * (17 + 15 * rolling)


class Land:
    """Triangles whose corners have a colour and a normal of their own."""

    def __init__(self):
        self.points, self.normals, self.colors, self.faces, self.known = [], [], [], [], {}

    def corner(self, point, normal, color):
        key = tuple(round(n, 3) for n in (*point, *normal, *color))
        if key not in self.known:
            self.known[key] = len(self.points)
            self.points.append(point)
            self.normals.append(normal)
            self.colors.append(color)
        return self.known[key]

    def face(self, points, colors, normals):
        self.faces.append([self.corner(*c) for c in zip(points, normals, colors)])

    def ground(self, ring, column, turn):
        """A point of the ring: square at the lawn, round at the hills."""
        u = 2 * column / COLUMNS - 1
        side = RINGS_M[ring]
        square = Vector((u * side, -side, 0))
        circle = Vector((math.sin(u * math.pi / 4), -math.cos(u * math.pi / 4), 0)) * side
        mixed = square.lerp(circle, min(1.0, ring / 4))
        at = Matrix.Rotation(turn, 3, "Z") @ mixed
        return Vector((at.x, at.y, rise(at.x, at.y)))

    def object(self, name):
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(self.points, [], self.faces)
        mesh.uv_layers.new(name="UVMap")
        layer = mesh.color_attributes.new("Col", "FLOAT_COLOR", "POINT")
        for data, color in zip(layer.data, self.colors):
            data.color = (*color, 1)
        for polygon in mesh.polygons:
            polygon.use_smooth = True
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set_from_vertices(self.normals)
        mesh.materials.append(flat("vcol_land", (0.8, 0.8, 0.8)))
        made = bpy.data.objects.new(name, mesh)
        bpy.context.scene.collection.objects.link(made)
        return made


def slope(point):
    """The land's normal, from the land as drawn: its cells are some 20 m wide."""
    step = 12.0
    dx = (rise(point.x + step, point.y) - rise(point.x - step, point.y)) / (2 * step)
    dy = (rise(point.x, point.y + step) - rise(point.x, point.y - step)) / (2 * step)
    return Vector((-dx, -dy, 1)).normalized()


def shaded(color, light):
    return tuple(c * light for c in color)


def tree(land, x, y, height):
    """A round crown of six sides, uneven: dark below, light above."""
    color = random.choice(LEAVES)
    base, wide, sides = rise(x, y), height * random.uniform(0.4, 0.55), 6
    rings = []
    for level, radius in ((0.05, 0.5), (0.42, 1.0), (0.8, 0.72)):
        ring = []
        for k in range(sides):
            angle, reach = 2 * math.pi * k / sides, wide * radius * random.uniform(0.8, 1.15)
            ring.append(Vector((x + reach * math.cos(angle), y + reach * math.sin(angle), base + height * level * random.uniform(0.9, 1.1))))
        rings.append(ring)
    top, middle = Vector((x, y, base + height)), Vector((x, y, base + height * 0.3))
    shades = [shaded(color, 0.55), color, shaded(color, 1.25), shaded(color, 1.35)]

    def face(points, colors):
        land.face(points, colors, [(p - middle).normalized() for p in points])

    for k in range(sides):
        n = (k + 1) % sides
        for level in (0, 1):
            low, high = rings[level], rings[level + 1]
            face([low[k], low[n], high[n], high[k]], [shades[level]] * 2 + [shades[level + 1]] * 2)
        face([rings[2][k], rings[2][n], top], [shades[2], shades[2], shades[3]])


def wood(land, points, height):
    """The edge of a wood, or a hedge, along points on the ground; its top is uneven."""
    color = random.choice(LEAVES)
    tops = [p + Vector((0, 0, height * random.uniform(0.7, 1.25))) for p in points]
    tops[0], tops[-1] = points[0] + Vector((0, 0, 0.5)), points[-1] + Vector((0, 0, 0.5))
    backs = [Vector((t.x * 1.06, t.y * 1.06, rise(t.x * 1.06, t.y * 1.06) + 0.5 * (t.z - p.z))) for t, p in zip(tops, points)]
    up = Vector((0, 0, 1))
    for a, b, c, d, e, f in zip(points, points[1:], tops, tops[1:], backs, backs[1:]):
        out = (Vector((-a.x, -a.y, 0)).normalized() + up * 0.4).normalized()
        land.face([a, b, d, c], [shaded(color, 0.6)] * 2 + [shaded(color, 1.1)] * 2, [out, out, (out + up).normalized(), (out + up).normalized()])
        land.face([c, d, f, e], [shaded(color, 1.1)] * 2 + [color] * 2, [(out + up).normalized()] * 2 + [up] * 2)


def quarter(name, turn):
    land = Land()
    for ring in range(len(RINGS_M) - 1):
        column = 0
        while column < COLUMNS:
            width = random.choice((1, 2, 2, 3)) if ring > 1 else COLUMNS
            color = random.choice(FIELDS) if ring > 1 else GRASS
            for c in range(column, min(column + width, COLUMNS)):
                corners = [land.ground(ring, c, turn), land.ground(ring, c + 1, turn), land.ground(ring + 1, c + 1, turn), land.ground(ring + 1, c, turn)]
                corners = [corners[1], corners[0], corners[3], corners[2]]
                land.face(corners, [color] * 4, [slope(p) for p in corners])
            column += width
    for _ in range(6):
        ring, column = random.uniform(2.5, 4.7), random.uniform(0, COLUMNS)
        low = land.ground(int(ring), int(column), turn)
        high = land.ground(int(ring) + 1, int(column), turn)
        at = low.lerp(high, ring % 1)
        tree(land, at.x, at.y, random.uniform(6, 11))
    for ring, first, count, height in ((2, 1, 3, 2), (2, 8, 3, 2.5), (3, 5, 3, 3), (3, 0, 3, 5), (4, 6, 5, 8), (5, 0, 5, 11), (6, 5, 7, 13)):
        points = [land.ground(ring, first + k, turn) for k in range(count + 1)]
        wood(land, points[::-1], height)
    return land.object(name)


if __name__ == "__main__":
    reset()
    random.seed(23)
    for index, name in enumerate(("south", "east", "north", "west")):
        export([quarter("land_" + name, index * math.pi / 2)], "land_" + name, "NONE")
