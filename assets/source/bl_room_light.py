"""Light that gets into rooms, baked into vertex colours."""
import math

from mathutils import Vector
from mathutils.bvhtree import BVHTree


def directions(count):
    """Directions about +Z, denser where a surface takes more light."""
    golden = math.pi * (3 - math.sqrt(5))
    made = []
    for i in range(count):
        r = math.sqrt((i + 0.5) / count)
        made.append(Vector((r * math.cos(golden * i), r * math.sin(golden * i), math.sqrt(1 - r * r))))
    return made


def bake(obj, closed_by):
    """Writes light into the vertices of vcol_ faces, which share none. `closed_by`: quads that stand for doors."""
    mesh = obj.data
    vertices = [v.co.copy() for v in mesh.vertices]
    faces = [list(p.vertices) for p in mesh.polygons if mesh.materials[p.material_index].name != "glass"]
    for points in closed_by:
        faces.append(list(range(len(vertices), len(vertices) + 4)))
        vertices += points
    tree = BVHTree.FromPolygons(vertices, faces)
    layer = mesh.color_attributes.new("Light", "FLOAT_COLOR", "POINT")
    rays, known = directions(160), {}

    def light_at(point, normal):
        turn = normal.to_track_quat("Z", "Y")
        seen = near = 0.0
        for ray in rays:
            hit, _, _, distance = tree.ray_cast(point, turn @ ray)
            if hit is None:
                seen += 1
            near += 1 if hit is None else min(1.0, distance / 0.9)
        seen, near = seen / len(rays), near / len(rays)
        return min(1.0, (0.42 + 2.0 * seen) * (0.5 + 0.5 * near))

    for polygon in mesh.polygons:
        baked = mesh.materials[polygon.material_index].name.startswith("vcol_")
        middle = sum((vertices[v] for v in polygon.vertices), Vector()) / len(polygon.vertices)
        for index in polygon.vertices:
            light = 1.0
            if baked:
                # A little inside the face: at an edge the ray's start would lie in the next wall.
                start = vertices[index].lerp(middle, 0.12) + polygon.normal * 0.03
                key = tuple(round(n, 2) for n in (*vertices[index], *polygon.normal))
                if key not in known:
                    known[key] = light_at(start, polygon.normal)
                light = known[key]
            layer.data[index].color = (light, light * (0.97 + 0.03 * light), light * (0.92 + 0.08 * light), 1)
