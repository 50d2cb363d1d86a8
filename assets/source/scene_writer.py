"""Writes the tables of a scene file: what make_garden.py and make_fairground.py share.

Values of keys are TOML text already. What is put stands in `out`, line by line.
"""
import math

out = []


def put(text):
    out.append(text)


def heading(text):
    put(f"\n# --- {text}")


def vec(*numbers, digits=3):
    least = 0.5 * 10 ** -digits
    return "[" + ", ".join(f"{n:.{digits}f}".rstrip("0").rstrip(".") if abs(n) > least else "0" for n in numbers) + "]"


def entity(name, position, **keys):
    """One [[entity]]; `body` is a list of lines, `digits` those of the position."""
    body = keys.pop("body", None)
    digits = keys.pop("digits", 3)
    put(f'\n[[entity]]\nname = "{name}"\nposition_m = {vec(*position, digits=digits)}')
    for key, value in keys.items():
        put(f"{key} = {value}")
    if body:
        put("[entity.body]")
        for line in body:
            put(line)


def array(name, prefab, origin, count, spacing):
    put(f'\n[[array]]\nname = "{name}"\nprefab = "{prefab}"\norigin_m = {vec(*origin)}')
    put(f"count = {vec(*count)}\nspacing_m = {vec(*spacing)}")


def prefab(name, lines, label=None):
    put(f'\n[[prefab]]\nname = "{name}"')
    if label:
        put(f'label = "{label}"')
    for line in lines:
        put(line)


def box(centre, size, turn=None):
    turned = f", rotation_deg = {vec(*turn)}" if turn else ""
    return f"{{ box = {vec(*size)}, position_m = {vec(*centre)}{turned} }}"


def compound(parts):
    return "shape = { compound = [\n    " + ",\n    ".join(parts) + ",\n] }"


def prism(radius, y0, y1, sides=8):
    """An upright prism: it stands on a face where a cylinder would rock on its rim."""
    around = [2 * math.pi * (i + 0.5) / sides for i in range(sides)]
    return "{ hull_m = [" + ", ".join(vec(radius * math.cos(a), y, radius * math.sin(a)) for y in (y0, y1) for a in around) + "] }"


def hinge(name, b, anchor, limits, friction_Nm, axis=(0, 1, 0), creak=0):
    """`friction_Nm`: what holds it where it was left."""
    put(f'\n[[joint]]\nname = "{name}_hinge"\nkind = "hinge"\na = "{name}"\nb = "{b}"\nanchor_m = {vec(*anchor)}')
    put(f"axis = {vec(*axis)}\nlimits = {vec(*limits)}\nmotor = {{ target = 0, max = {friction_Nm} }}" + (f"\ncreak = {creak}" if creak else ""))


def ball(name, a, b, anchor):
    put(f'\n[[joint]]\nname = "{name}"\nkind = "ball_and_socket"\na = "{a}"\nb = "{b}"\nanchor_m = {vec(*anchor)}')
