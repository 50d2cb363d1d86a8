#!/usr/bin/env python3
"""Writes assets/scenes/effects/NAME.toml: one small scene for each effect that bodies feel, named as the effect.

    python3 assets/source/make_effect_scenes.py

Each shows the effect beside what its formula says: marks on the ground or on a post stand where the formula puts things.
"""
import math
import pathlib

G = 9.81
RHO = 1.204
FOLDER = pathlib.Path(__file__).resolve().parents[1] / "scenes/effects"


def vec(*numbers):
    return "[" + ", ".join(f"{n:.6g}" for n in numbers) + "]"


class Scene:
    def __init__(self, name, title, description, camera, target, ground=True, extra=""):
        self.name = name
        self.parts = [f"""# Written by assets/source/make_effect_scenes.py.

[scene]
title = "{title}"
description = "{description}"
include = ["materials.toml"]

[world]
kill_below_m = -20

[player]
position_m = {vec(target[0], 0.1, camera[2] - 0.5)}

[camera]
position_m = {vec(*camera)}
target_m = {vec(*target)}
fov_deg = 50

[sun]
direction = [-0.545, -0.53, -0.65]
color = [1.0, 0.93, 0.82]
intensity = 3.4
shadow = {{ size_px = 2048, distance_m = 40 }}

[sky]
skybox = "skies/garden"

[ambient]
color = [0.3, 0.33, 0.38]

[flashlight]
{extra}"""]
        if ground:
            self.fixed("ground", "box = [40, 1, 40]", (0, -0.5, 0), "grass")

    def table(self, table, **keys):
        lines = [f"[[{table}]]"] + [f"{key} = {value}" for key, value in keys.items()]
        self.parts.append("\n".join(lines) + "\n")

    def thing(self, name, primitive, at, material, body="", turn=None):
        lines = ["[[entity]]", f'name = "{name}"', f"primitive = {{ {primitive} }}", f"position_m = {vec(*at)}", f'material = "{material}"']
        if turn:
            lines.append(f"rotation_deg = {vec(*turn)}")
        if body:
            lines += ["[entity.body]", body]
        self.parts.append("\n".join(lines) + "\n")

    def fixed(self, name, primitive, at, material, more="", turn=None):
        self.thing(name, primitive, at, material, 'kind = "static"' + (f"\n{more}" if more else ""), turn)

    def mark(self, name, at, size=(0.5, 0.02, 0.02)):
        """Where the formula says; nothing touches it."""
        self.thing(name, f"box = {vec(*size)}", at, "flag")

    def write(self):
        (FOLDER / f"{self.name}.toml").write_text("\n".join(self.parts))


def pendulums(scene, names_masses, angle_of):
    """Balls on bars of 1.5 m, which swing about x; marks where they come to rest."""
    for i, (name, mass) in enumerate(names_masses):
        x = 1.2 * (i - (len(names_masses) - 1) / 2)
        scene.thing(name, "sphere = 0.15", (x, 1.0, 0), "glaze_white", f"mass_kg = {mass}\ndrag = {{ coefficient = 0.47 }}\nlinear_damping_per_s = 0.3\n")
        scene.table("joint", name=f'"{name} bar"', kind='"distance"', a=f'"{name}"', b='"world"', anchor_a_m=vec(x, 1.0, 0), anchor_b_m=vec(x, 2.5, 0), bar_m=0.01)
        angle = angle_of(mass)
        scene.mark(f"mark {name}", (x, 2.5 - 1.5 * math.cos(angle), 1.5 * math.sin(angle)))
    scene.fixed("beam", "box = [4.4, 0.08, 0.08]", (0, 2.55, 0), "oak")
    for side in (-2.2, 2.2):
        scene.fixed(f"post {'left' if side < 0 else 'right'}", "box = [0.1, 2.6, 0.1]", (side, 1.3, 0), "oak")


def wind():
    speed = 12
    scene = Scene("wind", "Wind", "Balls on bars in the wind of a fan: tan a = 0.5 rho C A v2 / (m g); the marks stand there", (5.5, 2.2, 4.5), (0, 1.4, 0.4))
    scene.table("wind_zone", min_m=vec(-2.5, 0, -3), max_m=vec(2.5, 3, 3), velocity_mps=vec(0, 0, speed))
    force = 0.5 * RHO * 0.47 * math.pi * 0.15 ** 2 * speed ** 2
    pendulums(scene, [("light", 0.15), ("middle", 0.3), ("heavy", 0.6)], lambda mass: math.atan(force / (mass * G)))
    scene.write()


def drag():
    scene = Scene("drag", "Drag and spin lift", "Balls fall at v = sqrt(2 m g / (rho C A)) in the end; one that spins curves aside", (3, 5, 13), (0, 4, 0))
    for i, mass in enumerate((0.08, 0.32, 1.28)):
        scene.thing(f"ball {i + 1}", "sphere = 0.3", (-3 + i, 12, 0), "glaze", f"mass_kg = {mass}\ndrag = {{ coefficient = 0.47 }}")
    for name, spin, x in (("straight", 0, 1), ("curved", 60, 3)):
        scene.thing(name, "sphere = 0.2", (x, 1.2, 6), "glaze_white", f"mass_kg = 1.4\nvelocity_mps = [0, 7, -16]\nangular_velocity_radps = [0, {spin}, 0]\n"
                    "drag = { coefficient = 0.25, spin_lift = 1 }")
    scene.write()


def basin(scene, size=(6, 1.4, 4), level=1.2):
    """Walls round a box of water that stands on the ground."""
    x, _, z = size
    for side in (-1, 1):
        scene.fixed(f"wall x {side}", f"box = {vec(0.2, size[1], z + 0.4)}", (side * (x / 2 + 0.1), size[1] / 2, 0), "stone")
    scene.fixed("wall back", f"box = {vec(x, size[1], 0.2)}", (0, size[1] / 2, -z / 2 - 0.1), "stone")
    scene.fixed("wall front", f"box = {vec(x, size[1], 0.2)}", (0, size[1] / 2, z / 2 + 0.1), "stone")
    return {"name": '"basin"', "min_m": vec(-x / 2, 0, -z / 2), "max_m": vec(x / 2, level, z / 2), "material": '"water"'}


def buoyancy():
    scene = Scene("buoyancy", "Buoyancy", "Blocks of a quarter, a half and three quarters of the water's density go so far under; one of 1.2 sinks", (4.2, 3.4, 5.6), (0, 1, 0))
    scene.table("water", **basin(scene))
    for i, density in enumerate((250, 500, 750, 1200)):
        scene.thing(f"block {density}", "box = [0.8, 0.4, 0.8]", (-2.1 + 1.4 * i, 1.7, 0), "oak" if density < 1000 else "stone", f"density_kgpm3 = {density}")
    scene.write()


def water():
    scene = Scene("water", "Waves", "A wave as long as twice the basin swings with omega2 = g k tanh(k H), and floats ride on it", (4.4, 4.6, 5.6), (0, 0.8, 0))
    scene.table("water", **basin(scene, (8, 1.6, 3), 1.1), surface='"waves"', start="{ amplitude_m = 0.12, nx = 1, nz = 0 }", probes_m="[[-4, 0]]")
    for i, x in enumerate((-3, -1, 1, 3)):
        scene.thing(f"float {i + 1}", "box = [0.5, 0.25, 0.5]", (x, 1.15 + 0.12 * math.cos((x + 4) * math.pi / 8), 0.4), "oak", "density_kgpm3 = 450")
    scene.write()


def cloth():
    scene = Scene("cloth", "Cloth", "A sheet that catches a ball, one that hangs, and one that falls in folds and touches itself", (4.4, 2.8, 4.8), (0, 0.9, 0))
    for x in (-2.3, -0.7):
        for z in (-0.8, 0.8):
            scene.fixed(f"post {x} {z}", "cylinder = [0.04, 1.2]", (x, 0.6, z), "oak")
    scene.table("cloth", name='"trampoline"', size_m=vec(1.6, 1.6), position_m=vec(-1.5, 1.2, 0), rotation_deg=vec(90, 0, 0), stretch_Npm=6000, density_kgpm2=0.4,
                thickness_m=0.01, damping_s=0.002, material='"curtain"', pins='[{ edge = "left" }, { edge = "right" }]')
    scene.thing("ball", "sphere = 0.15", (-1.5, 2.2, 0), "glaze", "mass_kg = 2")
    scene.table("cloth", name='"hanging"', size_m=vec(1, 1.2), position_m=vec(0.6, 1.4, -0.6), material='"linen"', drag=1.2, pins='[{ at = [0, 0] }, { at = [1, 0] }]')
    scene.table("cloth", name='"falling"', size_m=vec(0.9, 0.9), position_m=vec(2, 1.0, 0.4), rotation_deg=vec(4, 0, 3), cells="[18, 18]", bend_Nm="1e-4",
                stretch_Npm=800, thickness_m=0.012, friction=0.3, self_collision="true", material='"cloth"')
    scene.write()


def rope():
    scene = Scene("rope", "Ropes", "A slack rope hangs as a catenary, y = a cosh(x / a); one holds a weight, one swings", (4.6, 2.6, 5.4), (0, 1.5, 0))
    for x in (-3, 0):
        scene.fixed(f"post {x}", "cylinder = [0.06, 2.6]", (x, 1.3, 0), "oak")
    scene.table("rope", name='"catenary"', a='"world"', b='"world"', anchor_a_m=vec(-3, 2.5, 0), anchor_b_m=vec(0, 2.5, 0), length_m=4, material='"rope"')
    # 2 a sinh(1.5 / a) = 4
    a = 1.0
    for _ in range(60):
        value = 2 * a * math.sinh(1.5 / a) - 4
        slope = 2 * math.sinh(1.5 / a) - 3 / a * math.cosh(1.5 / a)
        a -= value / slope
    for i in range(1, 8):
        x = -1.5 + 3 * i / 8
        scene.mark(f"mark {i}", (x - 1.5, 2.5 - a * (math.cosh(1.5 / a) - math.cosh(x / a)), -0.06), (0.06, 0.02, 0.02))
    scene.fixed("beam", "box = [3, 0.1, 0.1]", (2.2, 2.9, 0), "oak")
    for x in (0.8, 3.6):
        scene.fixed(f"leg {x}", "box = [0.1, 2.9, 0.1]", (x, 1.45, 0), "oak")
    scene.thing("weight", "sphere = 0.15", (1.5, 1.2, 0), "iron", "mass_kg = 20")
    scene.table("rope", name='"holds"', a='"world"', b='"weight"', anchor_a_m=vec(1.5, 2.85, 0), anchor_b_m=vec(1.5, 1.35, 0), material='"rope"')
    scene.thing("bob", "sphere = 0.12", (2.8, 2.0, 1.2), "iron", "mass_kg = 5")
    scene.table("rope", name='"swings"', a='"world"', b='"bob"', anchor_a_m=vec(2.8, 2.85, 0), anchor_b_m=vec(2.8, 2.0, 1.2), material='"rope"')
    scene.write()


def soft():
    scene = Scene("soft", "Soft bodies", "Three blocks, each four times as stiff as the one before: under its own weight each sinks by rho g h2 / (2 E)", (2.2, 1.3, 2.9), (0, 0.45, 0))
    for i, young in enumerate((4e4, 1.6e5, 6.4e5)):
        x = -1.4 + 1.4 * i
        scene.table("soft", name=f'"block {i + 1}"', primitive="{ box = [0.6, 0.8, 0.6] }", position_m=vec(x, 0.42, 0), cell_m=0.2, density_kgpm3=1000, young_Pa=young,
                    poisson=0.3, damping_s=0.02, material='"glaze"')
        scene.mark(f"mark {i + 1}", (x, 0.8 - 1000 * G * 0.8 ** 2 / (2 * young), 0.4), (0.5, 0.01, 0.01))
    scene.thing("ball", "sphere = 0.15", (0, 2, 0), "iron", "mass_kg = 4")
    scene.write()


def explosion():
    scene = Scene("explosion", "An explosion", "A charge after two seconds: each ball gets J (R / d)2 / 4 as far as nothing stands between", (7, 5, 9), (0, 0.6, 0))
    scene.table("explosion", name='"charge"', at_s=2, position_m=vec(0, 0.4, 0), impulse_Ns=600)
    for i, distance in enumerate((1.5, 2.5, 3.5, 4.5)):
        for turn in (0, 140):
            angle = math.radians(40 * i + turn)
            scene.thing(f"ball {i + 1} {turn}", "sphere = 0.2", (distance * math.cos(angle), 0.2, distance * math.sin(angle)), "glaze_white", "mass_kg = 1")
    scene.fixed("wall", "box = [0.2, 1.4, 2]", (-1.2, 0.7, -1.2), "stone", turn=(0, -45, 0))
    scene.thing("sheltered", "sphere = 0.2", (-2.2, 0.2, -2.2), "glaze", "mass_kg = 1")
    scene.write()


def fracture():
    scene = Scene("fracture", "What breaks", "Beams of one strength bear M = strength b h2 / 6: the loads on the left are borne, that on the right is not", (4.2, 2.6, 4.6), (0, 0.6, 0))
    strength, span, wide, high = 1e6, 1.4, 0.25, 0.1
    bears = 2 * strength * wide * high ** 2 / (3 * span) / G
    for i, share in enumerate((0.5, 0.8, 1.3)):
        z = -1.2 + 1.1 * i
        for side in (-1, 1):
            scene.fixed(f"pier {i + 1} {side}", "box = [0.1, 0.6, 0.3]", (side * span / 2, 0.3, z), "stone")
        scene.thing(f"beam {i + 1}", f"box = {vec(span + 0.2, high, wide)}", (0, 0.6 + high / 2, z), "plaster",
                    f"mass_kg = 20\nfracture = {{ pieces = 16, strength_Pa = {strength:g} }}")
        scene.thing(f"load {i + 1}", "box = [0.08, 0.25, 0.25]", (0, 0.725 + high, z), "iron", f"mass_kg = {share * bears:.6g}")
    scene.write()


def conveyor():
    scene = Scene("conveyor", "Belts and a turntable", "A crate that falls on a belt slides v2 / (2 mu g) before it moves along; the turntable carries coins round", (5, 4, 6), (0, 0.4, 0))
    scene.fixed("belt", "box = [7, 0.4, 1]", (0, 0.2, 1), "rubber", "friction = 0.6\nsurface_velocity_mps = [2, 0, 0]")
    scene.fixed("back", "box = [7, 0.4, 1]", (0, 0.2, -0.2), "rubber", "friction = 0.6\nsurface_velocity_mps = [-2, 0, 0]")
    for i in range(3):
        scene.thing(f"crate {i + 1}", "box = [0.5, 0.5, 0.5]", (-3 + 0.9 * i, 0.9 + 0.4 * i, 1), "wood", "mass_kg = 8\nfriction = 0.6")
    scene.thing("returning", "box = [0.5, 0.5, 0.5]", (3, 0.9, -0.2), "wood", "mass_kg = 8\nfriction = 0.6")
    scene.fixed("turntable", "cylinder = [1.2, 0.3]", (0, 0.15, -2.6), "oak", "friction = 0.6\nsurface_spin_degps = [0, 90, 0]")
    for i in range(3):
        scene.thing(f"coin {i + 1}", "cylinder = [0.12, 0.06]", (0.3 + 0.3 * i, 0.34, -2.6), "zinc", "mass_kg = 0.4\nfriction = 0.6")
    scene.write()


def magnets():
    scene = Scene("magnets", "Magnets", "Compass needles turn to a field and swing with omega2 = m B / I; two dipoles on the table meet", (1.6, 1.9, 2.2), (0, 0.85, 0))
    scene.parts[0] = scene.parts[0].replace("kill_below_m = -20", "kill_below_m = -20\nmagnetic_field_T = [0, 0, -0.05]")
    scene.fixed("table", "box = [3, 0.1, 1.6]", (0, 0.75, 0), "oak", "friction = 0.05")
    for i in range(3):
        x = -1.2 + 0.5 * i
        scene.thing(f"needle {i + 1}", "box = [0.03, 0.02, 0.3]", (x, 0.9, -0.4), "iron", f"mass_kg = 0.05\nmagnet = {{ moment_Am2 = [0, 0, {-0.05 * 4 ** i:g}] }}", (0, 60, 0))
        scene.table("joint", name=f'"pivot {i + 1}"', kind='"hinge"', a=f'"needle {i + 1}"', b='"world"', anchor_m=vec(x, 0.9, -0.4), axis=vec(0, 1, 0))
    for name, x, moment in (("left", 0.55, 40), ("right", 0.95, 40)):
        scene.thing(name, "box = [0.12, 0.06, 0.06]", (x, 0.83, 0.3), "rustmetal", f"mass_kg = 0.3\nfriction = 0.05\nmagnet = {{ moment_Am2 = [{moment}, 0, 0] }}")
    scene.write()


def vehicles():
    scene = Scene("vehicles", "Vehicles", "A cart that nobody drives goes round: its rear axle's middle on a circle of L / tan(steer)", (9, 7, 9), (0, 0, 0))
    wheels = ", ".join(f"{{ position_m = [{x}, -0.25, {z}], steers = {str(z < 0).lower()}, drives = {str(z > 0).lower()} }}" for x in (-0.8, 0.8) for z in (-1.2, 1.2))
    scene.thing("chassis", "box = [1.4, 0.4, 3]", (4, 0.7, 0), "paintwood", "mass_kg = 400\nfriction = 0.9")
    scene.table("vehicle", name='"cart"', body='"chassis"', throttle=0.12, steer_deg=28, material='"iron"', wheels=f"[{wheels}]")
    scene.thing("can", "cylinder = [0.2, 0.5]", (-3, 0.25, -2), "zinc", "mass_kg = 2")
    scene.write()


FOLDER.mkdir(parents=True, exist_ok=True)
for write in (wind, drag, buoyancy, water, cloth, rope, soft, explosion, fracture, conveyor, magnets, vehicles):
    write()
