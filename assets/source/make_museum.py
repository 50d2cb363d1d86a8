#!/usr/bin/env python3
"""Writes assets/scenes/museum.toml: experiments that run for ever, each with a plaque: formula, measured value, error, cost.

    python3 assets/source/make_museum.py > assets/scenes/museum.toml

Metres, +Y up. Two rows of stands along a hall; one comes in at +Z and looks down -Z.
"""
import math

from scene_writer import entity, heading, out, put, vec

G, RHO, MU0 = 9.81, 1.204, 4e-7 * math.pi

put("""# The museum: experiments that run for ever, each with a plaque: formula, measured value, error, cost.
# Written by assets/source/make_museum.py: change that and run it again.

[scene]
title = "The museum"
description = "Eight experiments; look at a plaque: formula, measured value, error, cost"
include = ["materials.toml", "things.toml"]

[world]
kill_below_m = -20

[player]
position_m = [0, 0, 7.4]
yaw_deg = 0
pitch_deg = -4

[camera]
position_m = [0, 2.3, 8.6]
target_m = [0, 1.1, 0]
fov_deg = 60

[sun]
direction = [-0.35, -0.8, -0.48]
color = [1.0, 0.94, 0.85]
intensity = 3.2
shadow = { size_px = 2048, distance_m = 30 }

[sky]
skybox = "skies/garden"

[ambient]
color = [0.42, 0.43, 0.46]

[flashlight]""")

heading("where the tour takes its images")
for name, position, target in [
    ("hall", (0, 2.3, 8.6), (0, 1.1, 0)),
    ("left_row", (1.2, 1.8, 1.5), (-3.2, 1.1, -0.5)),
    ("right_row", (-1.2, 1.8, 1.5), (3.2, 1.1, -0.5)),
]:
    put(f'\n[[view]]\nname = "{name}"\nposition_m = {vec(*position)}\ntarget_m = {vec(*target)}')

heading("colours")
for name, color, more in [
    ("marble", (0.6, 0.58, 0.54), 'roughness = 0.35\nsurface = "stone"'),
    ("plate", (0.55, 0.4, 0.12), 'roughness = 0.35\nmetallic = 0.8\nsurface = "metal"'),
    ("red", (0.5, 0.04, 0.03), 'roughness = 0.4\nsurface = "metal"'),
    ("blue", (0.03, 0.09, 0.42), 'roughness = 0.4\nsurface = "metal"'),
    ("dark_felt", (0.03, 0.08, 0.05), 'roughness = 0.95\nsurface = "soft"'),
    ("pool", (0.08, 0.16, 0.18), 'roughness = 0.05\nalpha = 0.6\nalpha_mode = "blend"\nsurface = "water"'),
]:
    put(f'\n[[material]]\nname = "{name}"\nbase_color = {vec(*color)}\n{more}')


def fixed(name, at, size, material, *body, turn=None):
    keys = {"rotation_deg": vec(*turn)} if turn else {}
    entity(name, at, primitive=f"{{ box = {vec(*size)} }}", material=f'"{material}"', **keys, body=['kind = "static"', *body])


def joint(name, kind, a, digits=6, **keys):
    put(f'\n[[joint]]\nname = "{name}"\nkind = "{kind}"\na = "{a}"')
    for key, value in keys.items():
        put(f"{key} = {value}")


heading("the hall: open to the sky")
entity("land", (0, -0.03, 0), primitive="{ plane = [120, 120] }", material='"grass"', casts_shadow="false", body=['kind = "static"'])
fixed("floor", (0, -0.1, 0.5), (11, 0.2, 18), "flagstone", "friction = 0.7")
fixed("wall_back", (0, 1.8, -8.4), (11, 3.6, 0.3), "plaster")
for side in (-1, 1):
    fixed(f"wall_{side}", (side * 5.4, 1.8, 0.5), (0.3, 3.6, 17.7), "plaster")
    for i in range(5):
        entity(f"column_{side}_{i}", (side * 5.1, 1.8, -7 + i * 3.8), primitive="{ cylinder = [0.16, 3.6] }", material='"marble"', body=['kind = "static"'])

STAND = 0.6  # height
count = 0


def stand(side, row, title, formula, of, quantity, expected, more=(), size=(1.2, 1.2)):
    """Returns the middle of the stand's top."""
    global count
    count += 1
    x, z = side * 3.6, -5.6 + 3.6 * row
    heading(title)
    fixed(f"stand_{count}", (x, STAND / 2, z), (size[0], STAND, size[1]), "marble")
    # The plate leans towards the aisle, so that who stands there reads it.
    entity(f"plaque_{count}", (x - side * (size[0] / 2 + 0.22), 0.95, z), primitive="{ box = [0.02, 0.3, 0.44] }", material='"plate"',
           rotation_deg=vec(0, 0, side * -35), label=f'"plaque: {title}"', body=['kind = "static"'])
    put("[entity.plaque]")
    for key, value in {"title": f'"{title}"', "formula": f'"{formula}"', "of": f'"{of}"', "quantity": f'"{quantity}"', "expected": f"{expected:.7g}", **dict(more)}.items():
        put(f"{key} = {value}")
    fixed(f"plaque_post_{count}", (x - side * (size[0] / 2 + 0.22), 0.42, z), (0.04, 0.84, 0.04), "iron")
    return x, STAND, z


def gallows(name, at, height, reach=0.0):
    """A post behind the stand's middle, and an arm to above it."""
    x, y, z = at
    fixed(f"{name}_post", (x, y + height / 2, z - 0.55), (0.06, height, 0.06), "iron")
    fixed(f"{name}_arm", (x, y + height + 0.03, z - 0.28), (0.06, 0.06, 0.62), "iron")


# 1: a physical pendulum; the period to the fourth order of the amplitude
R, L, A = 0.08, 1.2, math.radians(20)
period = 2 * math.pi * math.sqrt((L * L + 0.4 * R * R) / (G * L)) * (1 + A ** 2 / 16 + 11 * A ** 4 / 3072)
x, y, z = stand(-1, 0, "Pendulum", "T = 2 pi sqrt((L^2 + 2/5 r^2) / (g L)) (1 + a^2 / 16 + ...)", "bob", "period_s", period, {"axis": '"x"'}.items())
gallows("pendulum", (x, y, z), 1.6)
top = y + 1.6
entity("bob", (x + L * math.sin(A), top - L * math.cos(A), z), digits=6, primitive=f"{{ sphere = {R} }}", material='"red"', body=["mass_kg = 3", "can_sleep = false"])
joint("pendulum_hinge", "hinge", "bob", b='"world"', anchor_m=vec(x, top, z), axis="[0, 0, 1]", bar_m=0.008)

# 2: a weight on a spring
M, K, PULL = 2.0, 80.0, 0.15
period = 2 * math.pi * math.sqrt(M / K)
x, y, z = stand(-1, 1, "Weight on a spring", "T = 2 pi sqrt(m / k)", "weight", "period_s", period, {"axis": '"y"'}.items())
gallows("spring", (x, y, z), 1.7)
top = y + 1.7
rest = 0.7 + M * G / K
entity("weight", (x, top - rest - PULL, z), digits=6, primitive="{ box = [0.14, 0.14, 0.14] }", material='"iron"', body=[f"mass_kg = {M}", "can_sleep = false"])
joint("spring", "spring", "weight", b='"world"', anchor_a_m=vec(x, top - rest - PULL, z, digits=6), anchor_b_m=vec(x, top, z), stiffness_Npm=K, rest_length_m=0.7, bar_m=0.015)

# 3: a conical pendulum
L, A = 1.0, math.radians(25)
period = 2 * math.pi * math.sqrt(L * math.cos(A) / G)
x, y, z = stand(-1, 2, "Conical pendulum", "T = 2 pi sqrt(L cos a / g)", "circling_ball", "period_s", period, {"axis": '"x"'}.items())
gallows("cone", (x, y, z), 1.5)
top = y + 1.5
speed = 2 * math.pi * L * math.sin(A) / period
entity("circling_ball", (x + L * math.sin(A), top - L * math.cos(A), z), digits=6, primitive="{ sphere = 0.07 }", material='"blue"',
       body=["mass_kg = 2", f"velocity_mps = {vec(0, 0, speed, digits=6)}", "can_sleep = false"])
joint("cone_bar", "distance", "circling_ball", b='"world"', anchor_a_m=vec(x + L * math.sin(A), top - L * math.cos(A), z, digits=6), anchor_b_m=vec(x, top, z), bar_m=0.006)

# 4: a gyroscope that precesses with its axle level: exact, as the term of the precession's square is 0 there
R, THICK, M, ARM, SPIN = 0.2, 0.04, 2.0, 0.3, 80.0
axial = M * R * R / 2
turn = M * G * ARM / (axial * SPIN)
x, y, z = stand(1, 0, "Gyroscope", "T = 2 pi I w / (m g r)", "gyroscope", "period_s", 2 * math.pi / turn, {"axis": '"x"'}.items())
fixed("gyroscope_post", (x, y + 0.25, z), (0.05, 0.5, 0.05), "iron")
top = y + 0.53
entity("gyroscope", (x + ARM, top, z), digits=6, primitive=f"{{ cylinder = [{R}, {THICK}] }}", material='"plate"', rotation_deg="[0, 0, -90]",
       body=[f"mass_kg = {M}", f"velocity_mps = {vec(0, 0, -turn * ARM, digits=6)}", f"angular_velocity_radps = {vec(SPIN, turn, 0, digits=6)}", "can_sleep = false"])
joint("gyroscope_pivot", "ball_and_socket", "gyroscope", b='"world"', anchor_m=vec(x, top, z), bar_m=0.012)

# 5: a ball in the wind of a fan
R, M, C, SPEED = 0.12, 0.1, 0.47, 10.0
lean = math.degrees(math.atan(0.5 * RHO * C * math.pi * R * R * SPEED ** 2 / (M * G)))
x, y, z = stand(1, 1, "Drag in the wind of a fan", "tan a = rho C A v^2 / (2 m g)", "wind_ball", "lean_deg", lean, {"from": '"fan_hook"', "effect": '"drag"'}.items())
gallows("fan", (x, y, z), 1.6)
top = y + 1.6
entity("fan_hook", (x, top, z), primitive="{ sphere = 0.03 }", material='"iron"')
put(f"\n[[wind_zone]]\nmin_m = {vec(x - 0.6, y, z - 0.6)}\nmax_m = {vec(x + 1.2, y + 1.8, z + 0.6)}\nvelocity_mps = {vec(SPEED, 0, 0)}")
L, a = 1.0, math.radians(lean)
entity("wind_ball", (x + L * math.sin(a), top - L * math.cos(a), z), digits=6, primitive=f"{{ sphere = {R} }}", material='"glaze_white"',
       body=[f"mass_kg = {M}", f"drag = {{ coefficient = {C} }}", "linear_damping_per_s = 0.3"])
joint("wind_bar", "distance", "wind_ball", b='"world"', anchor_a_m=vec(x + L * math.sin(a), top - L * math.cos(a), z, digits=6), anchor_b_m=vec(x, top, z), bar_m=0.004)
entity("fan", (x - 0.75, y + 0.75, z), primitive="{ cylinder = [0.3, 0.08] }", rotation_deg="[0, 0, 90]", material='"zinc"', body=['kind = "static"'])
fixed("fan_foot", (x - 0.75, (y + 0.5) / 2, z), (0.06, y + 0.5, 0.06), "iron")

# 6: a float
SIZE, DENSITY, DEPTH = (0.5, 0.2, 0.5), 400.0, 0.4
draught = SIZE[1] * DENSITY / 1000
x, y, z = stand(1, 2, "Floating board", "draught = h rho / rho_w", "board", "height_m", STAND + DEPTH + SIZE[1] / 2 - draught, {"effect": '"buoyancy"'}.items(), size=(1.5, 1.5))
HALF, WALL = 0.7, 0.04
for i, (dx, dz, size) in enumerate(((HALF, 0, (WALL, 0.5, 2 * HALF)), (-HALF, 0, (WALL, 0.5, 2 * HALF)), (0, HALF, (2 * HALF, 0.5, WALL)), (0, -HALF, (2 * HALF, 0.5, WALL)))):
    fixed(f"tank_{i}", (x + dx, y + 0.25, z + dz), size, "glass")
inner = HALF - WALL / 2
put(f'\n[[water]]\nname = "tank"\nmin_m = {vec(x - inner, y, z - inner)}\nmax_m = {vec(x + inner, y + DEPTH, z + inner)}\nmaterial = "pool"')
entity("board", (x, y + DEPTH + SIZE[1] / 2 - draught, z), digits=6, primitive=f"{{ box = {vec(*SIZE)} }}", material='"oak"', body=[f"density_kgpm3 = {DENSITY}"])

# 7: a magnet that floats above another
R, M, MOMENT = 0.06, 0.3, 30.0
gap = (3 * MU0 * MOMENT ** 2 / (2 * math.pi * M * G)) ** 0.25
x, y, z = stand(-1, 3, "Magnets", "d^4 = 3 mu0 m1 m2 / (2 pi M g)", "upper_magnet", "distance_m", gap, {"from": '"lower_magnet"', "effect": '"magnets"'}.items())
for name, high, colour, moment, body in (("lower_magnet", 0.03, "red", MOMENT, ['kind = "static"']), ("upper_magnet", 0.03 + gap, "blue", -MOMENT, [f"mass_kg = {M}"])):
    entity(name, (x, y + high, z), digits=6, primitive=f"{{ cylinder = [{R}, 0.05] }}", material=f'"{colour}"', body=[*body, f"magnet = {{ moment_Am2 = [0, {moment}, 0] }}"])
joint("magnet_slide", "slider", "upper_magnet", b='"world"', axis="[0, 1, 0]")
entity("magnet_rod", (x, y + 0.3, z), primitive="{ cylinder = [0.012, 0.6] }", material='"zinc"')

# 8: a thing on a turntable
SPIN_DEG = 90.0
x, y, z = stand(1, 3, "Turntable", "T = 360 deg / w: friction carries what lies there", "rider", "period_s", 360 / SPIN_DEG, {"axis": '"x"', "effect": '"conveyor"'}.items())
entity("turntable", (x, y + 0.03, z), primitive="{ cylinder = [0.5, 0.06] }", material='"dark_felt"',
       body=['kind = "static"', "friction = 0.9", f"surface_spin_degps = [0, {SPIN_DEG}, 0]"])
entity("rider", (x + 0.3, y + 0.06 + 0.05, z), primitive="{ box = [0.1, 0.1, 0.1] }", material='"red"',
       body=["mass_kg = 0.5", "friction = 0.9", f"velocity_mps = {vec(0, 0, -math.radians(SPIN_DEG) * 0.3, digits=6)}", f"angular_velocity_radps = {vec(0, math.radians(SPIN_DEG), 0, digits=6)}"])

print("\n".join(out))
