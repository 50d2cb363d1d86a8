#!/usr/bin/env python3
"""Writes assets/scenes/workshop.toml: a machine of belt, rope, weight, dominoes, magnets, charge and pendulum that runs once.

    python3 assets/source/make_workshop.py > assets/scenes/workshop.toml

Metres, +Y up. The machine runs from left (-X) to right along the back wall; one stands before it and looks down -Z.
"""
import math

from scene_writer import box, compound, entity, heading, out, put, vec

put("""# The workshop: a machine of belt, rope, weight, dominoes, magnets, charge and pendulum that runs through once.
# Written by assets/source/make_workshop.py: change that and run it again.

[scene]
title = "The workshop"
description = "A machine that runs through once, the same way every time"
include = ["materials.toml", "things.toml"]

[world]
kill_below_m = -20

[player]
position_m = [-0.6, 0, 3.2]
yaw_deg = 0
pitch_deg = -2

[camera]
position_m = [-0.5, 1.9, 4.9]
target_m = [-0.35, 1.55, 0]
fov_deg = 60

[sun]
direction = [-0.45, -0.62, -0.72]
color = [1.0, 0.93, 0.82]
intensity = 3.6
shadow = { size_px = 2048, distance_m = 30 }

[sky]
skybox = "skies/garden"

[ambient]
color = [0.5, 0.5, 0.52]

[flashlight]

[sound]
paths = true""")

heading("where the tour takes its images")
for name, position, target in [
    ("machine", (-0.5, 1.9, 4.9), (-0.35, 1.55, 0)),
    ("belt_and_gate", (-3.4, 2.2, 2.4), (-2.7, 1.9, 0)),
    ("dominoes", (-0.2, 1.5, 1.6), (-0.1, 0.95, 0)),
    ("pendulum", (2.4, 1.8, 2.9), (2.3, 1.7, 0)),
]:
    put(f'\n[[view]]\nname = "{name}"\nposition_m = {vec(*position)}\ntarget_m = {vec(*target)}')

heading("colours")
for name, color, more in [
    ("belt", (0.05, 0.05, 0.055), 'roughness = 0.85\nsurface = "rubber"'),
    ("north", (0.5, 0.05, 0.04), 'roughness = 0.5\nmetallic = 0.4\nsurface = "metal"'),
    ("south", (0.04, 0.1, 0.45), 'roughness = 0.5\nmetallic = 0.4\nsurface = "metal"'),
    ("ivory", (0.62, 0.56, 0.42), 'roughness = 0.5\nsurface = "wood"'),
    ("watched", (0.1, 0.5, 0.2), 'alpha = 0.12\nalpha_mode = "blend"'),
    ("bulb", (0.35, 0.34, 0.3), 'emissive = [1.2, 1.0, 0.6]\nsurface = "glass"'),
]:
    put(f'\n[[material]]\nname = "{name}"\nbase_color = {vec(*color)}\n{more}')


def fixed(name, at, size, material, turn=None, *body, **keys):
    if turn:
        keys["rotation_deg"] = vec(*turn)
    entity(name, at, primitive=f"{{ box = {vec(*size)} }}", material=f'"{material}"', **keys, body=['kind = "static"', *body])


def block(name, at, size, material, *body):
    entity(name, at, primitive=f"{{ box = {vec(*size)} }}", material=f'"{material}"', body=list(body))


def ball(name, at, radius, material, *body):
    entity(name, at, primitive=f"{{ sphere = {radius} }}", material=f'"{material}"', body=list(body))


def trigger(name, at, size, *lines):
    entity(name, at, primitive=f"{{ box = {vec(*size)} }}", material='"watched"', casts_shadow="false")
    put("[entity.trigger]")
    for line in lines:
        put(line)


def slider(name, body, limits, grip_N, axis):
    """`grip_N`: what holds it where it is."""
    put(f'\n[[joint]]\nname = "{name}"\nkind = "slider"\na = "{body}"\nb = "world"\naxis = {vec(*axis)}\nlimits = {vec(*limits)}')
    put(f"motor = {{ target = 0, max = {grip_N} }}")


heading("the shed: open to the front")
entity("yard", (0, -0.02, 0), primitive="{ plane = [80, 80] }", material='"gravel"', casts_shadow="false", body=['kind = "static"', "friction = 0.8"])
fixed("floor", (0, -0.1, 0.8), (10.4, 0.22, 5.2), "flagstone", None, "friction = 0.7")
fixed("back_wall", (0, 1.94, -1.4), (10.4, 3.88, 0.3), "brick")
for side in (-1, 1):
    fixed(f"side_wall_{side}", (side * 5.05, 1.94, 0), (0.3, 3.88, 2.5), "brick")
    fixed(f"post_{side}", (side * 5.05, 1.75, 3.2), (0.16, 3.5, 0.16), "oak")
for i, x in enumerate((-5.05, -1.7, 1.7, 5.05)):
    fixed(f"rafter_{i}", (x, 3.72, 1.0), (0.14, 0.2, 5.0), "oak")
fixed("roof", (0, 3.92, 0.1), (11, 0.08, 3.2), "wood")

# --- measures of the machine
BENCH = 0.9  # its top
HALF_DEPTH = 0.4

heading("bench")
fixed("bench", (-0.7, BENCH - 0.03, 0), (4.0, 0.06, 2 * HALF_DEPTH), "oak", None, "friction = 0.5")
for i, (x, z) in enumerate((x, z) for x in (-2.55, 1.15) for z in (-0.3, 0.3)):
    fixed(f"bench_leg_{i}", (x, (BENCH - 0.06) / 2, z), (0.09, BENCH - 0.06, 0.09), "oak")

heading("1: a belt carries a weight to its end")
BELT_END, BELT_TOP = -3.0, 2.4
fixed("belt", (BELT_END - 0.6, BELT_TOP - 0.05, 0), (1.2, 0.1, 0.3), "belt", None, "friction = 0.8", "surface_velocity_mps = [0.1, 0, 0]")
for i, x in enumerate((BELT_END - 1.1, BELT_END - 0.1)):
    fixed(f"belt_leg_{i}", (x, (BELT_TOP - 0.1) / 2, -0.1), (0.08, BELT_TOP - 0.1, 0.08), "oak")
WEIGHT = 0.12
weight_x = BELT_END - 0.45
block("weight", (weight_x, BELT_TOP + WEIGHT / 2, 0), (WEIGHT, WEIGHT, WEIGHT), "iron", "mass_kg = 4")

heading("2: the falling weight lifts a gate by a rope over a log, and a ball rolls down")
LOG = (-2.6, 2.62)
RADIUS, ROPE = 0.12, 0.008
entity("log", (*LOG, 0), primitive=f"{{ cylinder = [{RADIUS}, 0.7] }}", rotation_deg="[90, 0, 0]", material='"oak"', body=['kind = "static"', "friction = 0.1"])
for side in (-1, 1):
    fixed(f"log_post_{side}", (LOG[0], LOG[1] / 2, side * 0.3), (0.09, LOG[1], 0.06), "oak")

SLOPE = math.radians(22)
RAMP_LOW = (-1.3, BENCH + 0.02)  # of its surface
RAMP = 1.55
along, normal = (math.cos(SLOPE), -math.sin(SLOPE)), (math.sin(SLOPE), math.cos(SLOPE))


def on_ramp(way, above):
    """`way` up from the low end."""
    return RAMP_LOW[0] - along[0] * way + normal[0] * above, RAMP_LOW[1] - along[1] * way + normal[1] * above


turn = (0, 0, -math.degrees(SLOPE))
fixed("ramp", (*on_ramp(RAMP / 2, -0.02), 0), (RAMP, 0.04, 0.2), "oak", turn, "friction = 0.6")
for side in (-1, 1):
    fixed(f"ramp_rail_{side}", (*on_ramp(RAMP / 2, 0.02), side * 0.09), (RAMP, 0.06, 0.02), "oak", turn, "friction = 0.1")
BALL = 0.05
gate_x = LOG[0] + RADIUS + ROPE
gate_way = (RAMP_LOW[0] - gate_x) / along[0]
ball("runner", (*on_ramp(gate_way + 0.09, BALL + 0.001), 0), BALL, "iron", "mass_kg = 0.4", "friction = 0.6", "restitution = 0.1")
fixed("ramp_end", (*on_ramp(gate_way + 0.18, 0.06), 0), (0.02, 0.14, 0.2), "oak", turn)
foot = on_ramp(gate_way, 0.012)[1]
GATE = 0.3
block("gate", (gate_x, foot + GATE / 2, 0), (0.02, GATE, 0.15), "wood", "mass_kg = 0.5", "friction = 0.1")
slider("gate_slide", "gate", (0, 0.3), 1, (0, 1, 0))
top = foot + GATE
over = [(LOG[0] - (RADIUS + ROPE) * math.cos(a), LOG[1] + (RADIUS + ROPE) * math.sin(a)) for a in (math.radians(d) for d in range(60, 181, 12))]
path = [(weight_x + WEIGHT / 2, BELT_TOP + WEIGHT)] + over + [(gate_x, top)]
put('\n[[rope]]\nname = "lifting_rope"\na = "weight"\nb = "gate"')
put("path_m = [" + ", ".join(vec(x, y, 0) for x, y in path) + "]")
put(f'pieces = 44\nmass_kg = 0.15\nradius_m = {ROPE}\nfriction = 0.1\nmaterial = "rope"')

heading("3: the ball knocks a row of dominoes over")
DOMINO = (0.03, 0.2, 0.1)
first, spacing, count = -1.06, 0.11, 13
for i in range(count):
    block(f"domino_{i + 1}", (first + i * spacing, BENCH + DOMINO[1] / 2, 0), DOMINO, "ivory", "mass_kg = 0.25", "friction = 0.4", "restitution = 0.05")
last = first + (count - 1) * spacing

heading("4: the last one pushes a magnet; the other, which faces it with the same pole, runs away and pushes a ball off the bench")
PUCK = 0.1
puck_x, gap = last + 0.19, 0.38
for i, (x, colours) in enumerate(((puck_x, "north"), (puck_x + gap, "south"))):
    moment = 60 if i == 0 else -60
    block(f"magnet_{i + 1}", (x, BENCH + PUCK / 2 + 0.002, 0), (PUCK, PUCK, PUCK), colours, "mass_kg = 0.25", "friction = 0.05", f"magnet = {{ moment_Am2 = [{moment}, 0, 0] }}")
slider("magnet_slide_1", "magnet_1", (0, 0.24), 0.15, (1, 0, 0))
slider("magnet_slide_2", "magnet_2", (0, 0.25), 0.1, (1, 0, 0))
runner_x = 1.1
ball("second_ball", (runner_x, BENCH + BALL + 0.001, 0), BALL, "rubber", "mass_kg = 0.15", "friction = 0.6", "rolling_friction = 0.0003", "restitution = 0.3")

heading("5: it falls into a box and sets a charge off, which blows a weight off its shelf")
TRAY = (1.58, 0.35)
entity("tray", (*TRAY, 0), primitive="{ box = [0.5, 0.03, 0.4] }", material='"oak"',
       body=['kind = "static"', "friction = 0.8"])
for i, (x, z, size) in enumerate(((-0.25, 0, (0.02, 0.2, 0.4)), (0.25, 0, (0.02, 0.2, 0.4)), (0, -0.2, (0.5, 0.2, 0.02)), (0, 0.2, (0.5, 0.2, 0.02)))):
    fixed(f"tray_side_{i}", (TRAY[0] + x, TRAY[1] + 0.08, z), size, "oak")
fixed("tray_foot", (TRAY[0], TRAY[1] / 2, 0), (0.2, TRAY[1], 0.2), "stone")
trigger("fuse", (TRAY[0], TRAY[1] + 0.12, 0), (0.46, 0.2, 0.36), 'of = ["second_ball"]', 'explode = "charge"', 'message = "Charge!"')

PIVOT = (2.75, 3.5)
SHELF_TOP, BOB = 2.1, 0.12
bob = (3.75, SHELF_TOP + BOB)
fixed("shelf", (bob[0] + 0.02, SHELF_TOP - 0.02, 0), (0.3, 0.04, 0.3), "oak", None, "friction = 0.3")
fixed("shelf_lip", (bob[0] - 0.1, SHELF_TOP + 0.005, 0), (0.02, 0.014, 0.3), "oak")
fixed("shelf_post", (bob[0] + 0.3, (SHELF_TOP + 0.3) / 2, 0), (0.16, SHELF_TOP + 0.3, 0.3), "stone")
put(f'\n[[explosion]]\nname = "charge"\nposition_m = {vec(bob[0] + 0.17, bob[1] - 0.02, 0)}\nimpulse_Ns = 60\nreach_m = 1.2')
ball("bob", (*bob, 0), BOB, "iron", "mass_kg = 6", "friction = 0.3")
fixed("gallows", (PIVOT[0], PIVOT[1] + 0.06, -0.5), (0.12, 0.12, 1.5), "oak")
put('\n[[rope]]\nname = "pendulum_rope"\na = "world"\nb = "bob"')
reach = math.hypot(PIVOT[0] - bob[0], PIVOT[1] - bob[1])
toward = ((PIVOT[0] - bob[0]) / reach, (PIVOT[1] - bob[1]) / reach)
put(f"anchor_a_m = {vec(*PIVOT, 0)}\nanchor_b_m = {vec(bob[0] + toward[0] * BOB, bob[1] + toward[1] * BOB, 0)}")
put(f'length_m = {1.02 * (reach - BOB):.3f}\nmass_kg = 0.1\nradius_m = {ROPE}\nmaterial = "rope"')

heading("6: and it breaks a vase, whose pieces switch the lamp on")
LOWEST = PIVOT[1] - 1.02 * reach
POST = LOWEST - 0.12
fixed("pedestal", (PIVOT[0], POST / 2, 0), (0.26, POST, 0.26), "stone", None, "friction = 0.6")
entity("vase", (PIVOT[0], POST + 0.15, 0), primitive="{ cylinder = [0.09, 0.3] }", material='"glaze"', label='"vase"',
       body=["mass_kg = 3", "friction = 0.6", "fracture = { pieces = 18, strength_Pa = 1e5, seed = 3 }"])
trigger("pieces_on_the_floor", (PIVOT[0] - 0.9, 0.1, 0), (1.5, 0.16, 2.4), 'light = "lamp"', 'message = "The machine ran through"')
entity("lamp", (0, 3.2, 0.6), primitive="{ sphere = 0.07 }", material='"bulb"', casts_shadow="false",
       light='{ kind = "point", color = [1, 0.8, 0.5], intensity = 6, radius_m = 7, on = false }')
fixed("lamp_cord", (0, 3.45, 0.6), (0.012, 0.44, 0.012), "iron")

print("\n".join(out))
