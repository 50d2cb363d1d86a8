"""Hard cases of effects: a parked cart (H90), and bodies that break (E01 to E03)."""
import math

from hard_scene import Scene, ball, box, cylinder, about_x

G = 9.81


def parked():
    slope = math.radians(10)
    scene = Scene("H90", "a cart parked on ten degrees",
                  "A cart of 440 kg stands with its brake on, on a plane that gravity makes a slope of ten degrees: in a minute "
                  "it may not creep by a centimetre.",
                  "Bullet #119: the raycast vehicle trembles as it stands", 60, (5, 2.5, 5), (0, 0.6, 0),
                  gravity=(0, -G * math.cos(slope), G * math.sin(slope)))
    scene.ground(friction=0.9)
    scene.body("chassis", box(1.4, 0.4, 3), (0, 0.65, 0), 400, friction=0.9, sleep=True)
    wheels = ",\n".join(f"    {{ position_m = [{x}, -0.3, {z}], steers = {str(z < 0).lower()}, drives = {str(z > 0).lower()} }}"
                        for x in (-0.8, 0.8) for z in (-1.2, 1.2))
    scene.parts.append(f'[[vehicle]]\nname = "cart"\nbody = "chassis"\nbrake = 1\nmaterial = "iron"\nwheels = [\n{wheels},\n]\n')
    scene.rule("displacement_m", "chassis", below=0.03)
    scene.rule("drift_m", "chassis", below=0.01)
    return scene


STRENGTH = 1e6
SPAN, WIDE, HIGH = 1.8, 0.3, 0.12


def fragile(pieces, strength=STRENGTH, seed=1):
    return f"fracture = {{ pieces = {pieces}, strength_Pa = {strength:g}, seed = {seed} }}\n"


def lintels():
    bears = 2 * STRENGTH * WIDE * HIGH ** 2 / (3 * SPAN) / G
    scene = Scene("E01", "lintels below and above their load",
                  "Two lintels of 2 m bear 0.8 of what beam theory lets them bear, and one 1.2 of it: the two bear it for a minute, "
                  "the other breaks at once.",
                  "o3de #1799: gravity damages bonds a little each frame until the wall falls", 60, (4.5, 3.2, 6.5), (0, 0.5, -0.5))
    scene.ground()
    for i, share in enumerate((0.8, 0.8, 1.2)):
        z = 2.5 * i - 3.5
        for side in (-1, 1):
            scene.fixed(f"pier_{i}_{side}", cylinder(0.1, 0.4), (side * SPAN / 2, 0.6, z), turn=about_x(math.pi / 2),
                        material="stone")
        scene.body(f"lintel_{i}", box(2.0, HIGH, WIDE), (0, 0.7 + HIGH / 2, z), 5.0, material="plaster",
                   sleep=True, more=fragile(21))
        scene.body(f"load_{i}", box(0.06, 0.3, 0.3), (0, 0.85 + HIGH, z), share * bears, material="iron", sleep=True)
        scene.joint("slider", f"load_{i}", at=(0, 0.85 + HIGH, z), axis=(0, 1, 0))
    scene.rule("sag_m", ("lintel_0", "lintel_1"), below=0.005)
    scene.rule("height_m", "load_2", below=0.6, from_s=1)
    return scene


def torn():
    scene = Scene("E02", "rods that spin until they break",
                  "Five rods afloat spin faster than they bear, two about an axis and three about none: whatever they fall "
                  "into keeps momentum, angular momentum and energy.",
                  "IsaacLab #2619: joints that break throw their bodies", 1, (0, 8, 26), (0, 4, 0), gravity=(0, 0, 0),
                  energy_gain=1e-4, kill=-1000)
    scene.ground(top=-500)
    for i, spin in enumerate(((0, 60, 0), (0, 0, 60), (5, 55, 40), (30, 60, 0), (10, 40, 50))):
        scene.body(f"rod_{i}", box(2, 0.2, 0.2), (6.0 * i - 12, 4, 0), 80.0, spin=spin, velocity=(0, 0, 1.0 + i),
                   material="paint_orange", more=fragile(16, seed=i + 1))
    scene.rule("momentum_change", below=1e-4)
    scene.rule("angular_momentum_change", below=1e-4)
    return scene


def rammed():
    scene = Scene("E03", "a wall of bricks that break, rammed",
                  "A ball of 60 kg meets a wall of forty bricks at 12 m/s; each may fall into four pieces. What is left must not "
                  "overlap, gain energy or tremble once it lies.",
                  "Blast: graph reduction can lead to interlocked actors", 8, (4, 2.5, 5), (0, 0.4, 0), settled=7,
                  unsettled="the wall falls", penetration=0.01)
    scene.ground(0.7)
    scene.prefab("brick", box(0.25, 0.1, 0.12), 3.8, material="brick", friction=0.7, sleep=True,
                 more=fragile(4, 1.5e6))
    for row in range(8):
        for column in range(5):
            scene.place(f"brick_{row}_{column}", "brick", (0.2502 * (column - 2) + 0.125 * (row % 2), 0.05 + 0.1 * row, 0))
    scene.body("ram", ball(0.2), (0.1, 0.55, 2.5), 60.0, velocity=(0, 0.6, -12), material="iron", friction=0.7,
               sleep=True, more="rolling_friction = 0.05\nspinning_friction = 0.02\n")
    scene.rule("kinetic_J", below=0.05, from_s=7)
    scene.rule("lowest_m", "ram", above=-0.01)
    return scene


def scenes():
    return [parked(), lintels(), torn(), rammed()]
