#!/usr/bin/env python3
"""Writes the two models of assets/scenes/book that no primitive stands for: pyramid.obj and
dumbbell.obj.

    python3 assets/source/make_book_models.py
"""
import math
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "book"


def minus(a, b):
    return tuple(p - q for p, q in zip(a, b))


def flat(*points):
    """A face whose corners share its normal; counter-clockwise from outside."""
    a, b = minus(points[1], points[0]), minus(points[2], points[0])
    cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    normal = tuple(part / math.hypot(*cross) for part in cross)
    return [(point, normal) for point in points]


def ball(center_x, radius, rings=12, sides=20):
    def corner(ring, side):
        polar, about = math.pi * ring / rings, 2 * math.pi * (side % sides) / sides
        normal = (math.sin(polar) * math.cos(about), math.cos(polar), math.sin(polar) * math.sin(about))
        return (center_x + radius * normal[0], radius * normal[1], radius * normal[2]), normal

    faces = []
    for ring in range(rings):
        for side in range(sides):
            upper = [corner(ring, side), corner(ring, side + 1)]
            lower = [corner(ring + 1, side + 1), corner(ring + 1, side)]
            faces.append(upper[:1] + lower if ring == 0 else upper + lower[:1] if ring == rings - 1 else upper + lower)
    return faces


def rod(x, y, z):
    """The four long sides: the ends lie inside the balls."""
    return [flat((-x, y, z), (x, y, z), (x, y, -z), (-x, y, -z)),
            flat((-x, -y, -z), (x, -y, -z), (x, -y, z), (-x, -y, z)),
            flat((-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)),
            flat((x, -y, -z), (-x, -y, -z), (-x, y, -z), (x, y, -z))]


def pyramid():
    a, b, c, d, top = (-1, -0.5, -1), (1, -0.5, -1), (1, -0.5, 1), (-1, -0.5, 1), (0, 1.5, 0)
    return [flat(a, b, c, d), flat(d, c, top), flat(c, b, top), flat(b, a, top), flat(a, d, top)]


def words(vector):
    return " ".join(f"{round(part, 5) + 0.0:g}" for part in vector)


def write(name, comment, faces):
    places, normals, lines = {}, {}, []
    for face in faces:
        corners = [f"{places.setdefault(words(place), len(places) + 1)}//{normals.setdefault(words(normal), len(normals) + 1)}"
                   for place, normal in face]
        lines.append("f " + " ".join(corners))
    text = [f"# {comment}"] + [f"v {place}" for place in places] + [f"vn {normal}" for normal in normals] + lines
    (FOLDER / name).write_text("\n".join(text) + "\n")


if __name__ == "__main__":
    write("pyramid.obj", "The hull of five points.", pyramid())
    write("dumbbell.obj", "A rod of 3 by 0.4 by 0.4 m, and a ball of 0.5 m round 1.75 m to each side.",
          rod(1.5, 0.2, 0.2) + ball(-1.75, 0.5) + ball(1.75, 0.5))
