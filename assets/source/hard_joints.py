"""Hard cases H26 to H47: joints, chains, mechanisms."""
import math

from hard_scene import Scene, about_x, about_z, ball, box, capsule, cylinder, number


def chain(name, title, links, length, known):
    top = links * length + 2
    scene = Scene(name, title,
                  f"{links} links of 1 kg hang straight down and hold 100 kg at their end.", known, 10,
                  (0.45 * top + 2, 0.6 * top, 0.9 * top + 3), (0, 0.5 * top, 0))
    scene.ground()
    scene.scenery("beam", box(3, 0.3, 0.3), (0, top + 0.15, 0), "iron")
    above = "world"
    for i in range(links):
        last = i + 1 == links
        scene.body(f"link_{i}", box(0.1, length, 0.1), (0, top - length * (i + 0.5), 0),
                   100.0 if last else 1.0, material="rustmetal" if last else "paint_orange")
        scene.joint("ball_and_socket", f"link_{i}", above, (0, top - length * i, 0))
        above = f"link_{i}"
    scene.rule("sag_m", f"link_{links - 1}", below=0.01 * links * length)
    scene.rule("speed_mps", below=0.01, from_s=5)
    return scene


def bridge():
    planks, spread = 160, 0.6  # rad of the arc to either side: 6 % of slack
    radius = planks / (2 * spread)
    centre = radius + 4
    scene = Scene("H30", "a bridge of 160 planks catches 500 kg",
                  "Planks of 5 kg hinged between two cliffs; half a tonne falls 2 m onto the middle.",
                  "Box2D keeps it as Bridge", 10, (8, 30, 105), (0, 14, 0), shadow=200,
                  penetration=0.05)
    scene.ground()

    def on_arc(angle):
        return (radius * math.sin(angle), centre - radius * math.cos(angle), 0)

    before = "world"
    for i in range(planks):
        angle = spread * (2 * (i + 0.5) / planks - 1)
        scene.body(f"plank_{i}", box(0.98, 0.25, 2), on_arc(angle), 5.0, turn=about_z(angle))
        scene.joint("hinge", f"plank_{i}", before, on_arc(spread * (2 * i / planks - 1)), axis=(0, 0, 1))
        before = f"plank_{i}"
    scene.joint("hinge", before, "world", on_arc(spread), axis=(0, 0, 1))
    ledge = on_arc(spread)
    for side in (-1, 1):
        scene.fixed(f"cliff_{side}", box(8, ledge[1], 6), (side * (ledge[0] + 4.3), ledge[1] / 2, 0),
                    material="stone")
    scene.body("load", box(1, 1, 1), (-ledge[0] - 4, ledge[1] + 0.5, 0), 500.0, material="rustmetal")
    # The bridge has settled a little by then; the load starts 2 m above it.
    scene.event("teleport", "load", 2, value=(0, on_arc(0)[1] + 0.125 + 0.5 + 2, 0))
    scene.rule("max_joint_error_m", below=0.05)
    scene.rule("tilt_deg", "plank_*", below=90)
    scene.rule("height_m", "load", to=f"plank_{planks // 2}", above=-1, from_s=2)
    return scene


def net(name, side, seconds, tier):
    link = 0.5
    high = link * side + 1
    scene = Scene(name, f"a net of {side} by {side}",
                  f"{side * side} balls joined to their neighbours, held along one edge, swing down.",
                  "Rapier, PEEL and Box3D keep it as a test of joint grids", seconds,
                  (1.4 * high, 1.1 * high, 1.6 * high), (0.25 * high, 0.5 * high, 0.4 * high), tier=tier,
                  penetration=0.02, energy_scale=9.81 * side * side * link * side)
    scene.ground()
    scene.prefab("knot", ball(0.1), material="paint_orange")
    for x in range(side):
        for z in range(side):
            scene.place(f"knot_{x}_{z}", "knot", (link * x, high, link * z))
    for x in range(side):
        for z in range(side):
            here = f"knot_{x}_{z}"
            if z > 0:
                scene.joint("ball_and_socket", here, f"knot_{x}_{z - 1}", (link * x, high, link * (z - 0.5)))
            if x > 0:
                scene.joint("ball_and_socket", here, f"knot_{x - 1}_{z}", (link * (x - 0.5), high, link * z))
            else:
                scene.joint("ball_and_socket", here, "world", (0, high, link * z))
    scene.rule("max_joint_error_m", below=0.02 * link)
    scene.rule("speed_mps", below=100)
    return scene


RAGDOLL = (  # part, shape, size, place from the hips, kg, parent, joint's place, limits in degrees
    ("hips", "box", (0.34, 0.22, 0.22), (0, 0, 0), 12.0, None, None, None),
    ("chest", "box", (0.4, 0.4, 0.24), (0, 0.34, 0), 20.0, "hips", (0, 0.12, 0), 30),
    ("head", "ball", 0.13, (0, 0.7, 0), 5.0, "chest", (0, 0.56, 0), 40),
    ("arm_l", "limb", (0.06, 0.22), (-0.29, 0.32, 0), 3.0, "chest", (-0.29, 0.47, 0), 80),
    ("arm_r", "limb", (0.06, 0.22), (0.29, 0.32, 0), 3.0, "chest", (0.29, 0.47, 0), 80),
    ("hand_l", "limb", (0.05, 0.2), (-0.29, 0.02, 0), 2.0, "arm_l", (-0.29, 0.18, 0), None),
    ("hand_r", "limb", (0.05, 0.2), (0.29, 0.02, 0), 2.0, "arm_r", (0.29, 0.18, 0), None),
    ("leg_l", "limb", (0.08, 0.28), (-0.11, -0.34, 0), 8.0, "hips", (-0.11, -0.13, 0), 60),
    ("leg_r", "limb", (0.08, 0.28), (0.11, -0.34, 0), 8.0, "hips", (0.11, -0.13, 0), 60),
    ("foot_l", "limb", (0.07, 0.28), (-0.11, -0.76, 0), 5.0, "leg_l", (-0.11, -0.55, 0), None),
    ("foot_r", "limb", (0.07, 0.28), (0.11, -0.76, 0), 5.0, "leg_r", (0.11, -0.55, 0), None))


def add_ragdoll(scene, name, at, velocity=None):
    for part, kind, size, off, mass, parent, pivot, limit in RAGDOLL:
        shape = {"box": lambda s: box(*s), "ball": ball, "limb": lambda s: capsule(*s)}[kind](size)
        place = tuple(a + o for a, o in zip(at, off))
        scene.body(f"{name}_{part}", shape, place, mass, velocity=velocity,
                   material="paint_cream" if kind == "ball" else "paint_blue")
        if parent is None:
            continue
        where = tuple(a + o for a, o in zip(at, pivot))
        if limit:
            scene.joint("cone", f"{name}_{part}", f"{name}_{parent}", where, axis=(0, 1, 0),
                        limits=(0, limit), more="twist = [-45, 45]\n")
        else:  # elbows and knees
            scene.joint("hinge", f"{name}_{part}", f"{name}_{parent}", where, axis=(1, 0, 0),
                        limits=(-120, 0) if part.startswith("hand") else (0, 120))


def ragdolls():
    scene = Scene("H34", "ragdolls crammed into a pit, and one hit at 30 m/s",
                  "Eight ragdolls fall into a pit too small for them; a ninth is struck by a ball of "
                  "20 kg at 30 m/s. Joints hold and limits are kept.",
                  "Box2D and Box3D keep RagdollStress; JoltPhysics #170", 8, (3.6, 3, 5.4), (0.8, 0.8, 0), shadow=20,
                  penetration=0.01)
    scene.ground()
    for name, size, at in (("left", (0.2, 1.2, 2.4), (-1.2, 0.6, 0)),
                           ("right", (0.2, 1.2, 2.4), (1.2, 0.6, 0)),
                           ("back", (2.2, 1.2, 0.2), (0, 0.6, -1.1)),
                           ("front", (2.2, 1.2, 0.2), (0, 0.6, 1.1))):
        scene.fixed(f"pit_{name}", box(*size), at, material="glass" if name == "front" else "brick")
    for i in range(8):
        add_ragdoll(scene, f"doll_{i}", (-0.5 + 1.0 * (i % 2), 2.2 + 1.9 * (i // 4), -0.5 + 1.0 * (i // 2 % 2)))
    add_ragdoll(scene, "struck", (4, 0.98, 0))
    scene.body("shot", ball(0.2), (4, 1.3, -6), 20.0, velocity=(0, 0.5, 30), material="iron")
    scene.rule("joint_error_m", below=0.0873)
    scene.rule("speed_mps", below=60)
    return scene


def contraption():
    """A scissor lift of crossed bars: rigid, and held many times over."""
    stages, half, rise = 10, 1.0, 0.8
    scene = Scene("H35", "a scissor lift of thirty-two joints",
                  "Ten crossed pairs of bars, hinged at the middle and at their ends, carry 50 kg. Every "
                  "hinge holds the plane again: most rows say the same twice.",
                  "JoltPhysics #170: Bullet too soft, PhysX explodes, Jolt erratic", 20, (6, 6, 13),
                  (0, 4.2, 0), energy_scale=2000.0)
    scene.ground()
    angle = math.atan2(rise, 2 * half)
    length = math.hypot(rise, 2 * half)
    base = 0.3
    scene.fixed("base", box(2.6, 0.2, 0.8), (0, 0.1, 0), material="stone")
    z_bars = {"a": 0.06, "b": -0.06}
    for k in range(stages):
        low = base + rise * k
        for bar, sign in (("a", 1), ("b", -1)):
            scene.body(f"bar_{bar}{k}", box(length, 0.08, 0.08), (0, low + rise / 2, z_bars[bar]), 2.0,
                       turn=about_z(sign * angle), material="paint_orange" if bar == "a" else "paint_blue")
        scene.joint("hinge", f"bar_a{k}", f"bar_b{k}", (0, low + rise / 2, 0), axis=(0, 0, 1))
        # a comes from the left foot, b from the right one.
        below_left = f"bar_b{k - 1}" if k else "world"
        below_right = f"bar_a{k - 1}" if k else "world"
        scene.joint("hinge", f"bar_a{k}", below_left, (-half, low, 0), axis=(0, 0, 1))
        scene.joint("hinge", f"bar_b{k}", below_right, (half, low, 0), axis=(0, 0, 1))
    top = base + rise * stages
    scene.body("table", box(2.4, 0.15, 0.8), (0, top, 0), 50.0, material="rustmetal")
    scene.joint("hinge", "table", f"bar_b{stages - 1}", (-half, top, 0), axis=(0, 0, 1))
    scene.joint("hinge", "table", f"bar_a{stages - 1}", (half, top, 0), axis=(0, 0, 1))
    scene.rule("max_joint_error_m", below=0.02)
    scene.rule("displacement_m", below=0.02)
    return scene


def door():
    scene = Scene("H36", "a door on two hinges that do not line up",
                  "The lower hinge stands 1 mm aside and 0.5 degrees askew: the rows contradict each "
                  "other, and the door must hang still all the same.",
                  "expected: redundant rows; Lemke", 5, (2.2, 1.8, 3.6), (0.4, 1.1, 0),
                  shadow=12, energy_scale=20 * 9.81)
    scene.ground()
    scene.scenery("post", box(0.12, 2.3, 0.12), (-0.08, 1.15, 0), "bark")
    scene.body("door", box(1, 2, 0.05), (0.5, 1.1, 0), 20.0)
    scene.joint("hinge", "door", "world", (0, 1.9, 0), axis=(0, 1, 0))
    off = math.radians(0.5)
    scene.joint("hinge", "door", "world", (0.001, 0.3, 0), axis=(math.sin(off), math.cos(off), 0))
    scene.rule("speed_mps", below=0.001, from_s=3)
    scene.rule("displacement_m", below=0.005)
    return scene


def singular():
    scene = Scene("H38", "joints turned through their singular poses",
                  "Afloat, a rod on a cone joint swings through the pose in which its axis points back, "
                  "once with and once without limits of twist; a hinge goes round and round.",
                  "Jolt keeps ConstraintSingularity; Bullet's 6dof has a gimbal", 10, (0.5, 3.4, 8),
                  (0.3, 1.5, 0), gravity=(0, 0, 0), shadow=20)
    scene.ground()
    for name, x, kind, more in (("free", -3, "cone", ""), ("limited", 0, "cone", "twist = [-28.6, 28.6]\n"),
                                ("leaf", 3, "hinge", "")):
        scene.body(name, box(1, 0.1, 0.2), (x + 0.5, 1.5, 0), velocity=(0, 1, 0), spin=(0, 0, 2),
                   material="paint_orange")
        scene.scenery(f"pin_{name}", ball(0.08), (x, 1.5, 0), "iron")
        axis = (0, 0, 1) if kind == "hinge" else (1, 0, 0)
        scene.joint(kind, name, "world", (x, 1.5, 0), axis=axis, more=more)
    scene.rule("max_joint_error_m", below=0.01)
    scene.rule("speed_mps", below=1.05)
    scene.rule("spin_radps", "leaf", near=(2, 0.002))
    return scene


def at_limit():
    scene = Scene("H38b", "a rod that leans on the limit of its cone",
                  "A heavy rod falls to the edge of its cone and stays there.",
                  "Bullet's cone-twist at its limit", 6, (2.2, 2.4, 4), (0.4, 1.6, 0),
                  shadow=12, energy_scale=9.81)
    scene.ground()
    scene.scenery("post", box(0.12, 2, 0.12), (-0.07, 1, 0), "iron")
    scene.body("rod", box(1, 0.1, 0.1), (0.5, 2, 0), material="paint_orange")
    scene.joint("cone", "rod", "world", (0, 2, 0), name="cone", axis=(1, 0, 0), limits=(0, 40))
    scene.rule("speed_mps", below=0.01, from_s=4)
    scene.rule("joint_angle_deg", "cone", near=(40, 0.6), from_s=4)
    return scene


def fast_limit():
    scene = Scene("H39", "limits met at 50 m/s",
                  "Afloat, a slider and a hinge run into their limits at 50 m/s and stop within 1 cm and "
                  "1 degree.",
                  "Bullet has limit rows only when violated at set-up", 2, (1.2, 4, 9), (0.8, 1.4, 0),
                  gravity=(0, 0, 0), shadow=20)
    scene.ground()
    scene.body("box", box(1, 1, 1), (-2, 1.5, 0.8), velocity=(50, 0, 0))
    scene.joint("slider", "box", "world", (-2, 1.5, 0.8), name="slider", axis=(1, 0, 0), limits=(-1, 3.3))
    scene.body("rod", box(1, 0.1, 0.1), (4.5, 1.5, 0), velocity=(0, 25, 0), spin=(0, 0, 50),
               material="paint_orange")
    scene.joint("hinge", "rod", "world", (4, 1.5, 0), name="hinge", axis=(0, 0, 1), limits=(-60, 115))
    scene.rule("joint_error_m", "slider", below=0.01)
    scene.rule("joint_error_m", "hinge", below=math.radians(1))
    return scene


def motor():
    scene = Scene("H40", "an endless motor against a limit",
                  "A motor of 1e6 N m drives a leaf against its limit for 5 s and is switched off: it must "
                  "not have wound anything up.",
                  "PR #2145", 6, (0.8, 3, 4), (0.3, 1.5, 0), gravity=(0, 0, 0), shadow=12,
                  energy_from="the motor")
    scene.ground()
    scene.body("leaf", box(1, 0.1, 0.5), (0.5, 1.5, 0), material="paint_orange")
    scene.joint("hinge", "leaf", "world", (0, 1.5, 0), name="hinge", axis=(0, 0, 1), limits=(-57, 57),
                more="motor = { target = 10, max = 1e6 }\n")
    scene.event("motor_off", "hinge", 5)
    scene.rule("joint_angle_deg", "hinge", near=(57, 1), from_s=1, to_s=5)
    scene.rule("spin_radps", "leaf", below=2, from_s=5)
    return scene


def torn():
    scene = Scene("H41", "anchors five metres apart",
                  "Afloat, joined bodies are put 5 m from where their joints hold them: they come together "
                  "within 2 s and never faster than 10 m/s.",
                  "Bullet's error reduction asks for 0.2 x 5 m in a step: 60 m/s [from its code]", 4,
                  (5, 5, 13), (0.5, 4, 0), gravity=(0, 0, 0), shadow=25,
                  energy_scale=150.0,  # three boxes at 10 m/s
                  energy_from="the joints, which pull 5 m together")
    scene.ground()
    scene.body("alone", box(1, 1, 1), (-4, 1.5, 0), material="paint_orange")
    scene.scenery("pin", ball(0.12), (-3, 1.5, 0), "iron")
    scene.joint("ball_and_socket", "alone", "world", (-3, 1.5, 0))
    scene.body("a", box(1, 1, 1), (2, 1.5, 0))
    scene.body("b", box(1, 1, 1), (4, 1.5, 0))
    scene.joint("ball_and_socket", "a", "b", (3, 1.5, 0))
    scene.event("teleport", "alone", 0, value=(-4, 6.5, 0))
    scene.event("teleport", "a", 0, value=(2, 6.5, 0))
    scene.rule("speed_mps", below=10)
    scene.rule("max_joint_error_m", below=0.01, from_s=2)
    scene.rule("speed_mps", below=0.5, from_s=2)
    return scene


def stiff():
    scene = Scene("H42", "a spring of 1e7 N/m and a damper of 1e5 N s/m",
                  "A spring a hundred times too stiff for the step stays bounded and keeps its stretch of "
                  "10 cm at most; a heavy damper lets its ball creep as m g / c says.",
                  "explicit springs; Bullet's 6DofSpring2 clamps [from its code]", 10, (1.5, 3, 5),
                  (0.4, 1.8, 0), shadow=12)
    scene.ground()
    scene.scenery("frame", box(3, 0.1, 0.1), (0, 3, 0), "iron")
    scene.body("swing", ball(0.2), (-1, 1.9, 0), material="paint_orange")
    scene.joint("spring", "swing", "world", name="spring",
                more="anchor_a_m = [-1, 1.9, 0]\nanchor_b_m = [-1, 3, 0]\nstiffness_Npm = 1e7\n"
                     "rest_length_m = 1\n")
    scene.body("creep", ball(0.2), (1, 2, 0), material="paint_blue")
    scene.joint("spring", "creep", "world", name="damper",
                more="anchor_a_m = [1, 2, 0]\nanchor_b_m = [1, 3, 0]\nstiffness_Npm = 100\n"
                     "damping_Nspm = 1e5\n")
    way = 9.81 / 100 * (1 - math.exp(-100 / 1e5 * 10))
    scene.rule("joint_displacement_m", "spring", near=(1, 0.101))
    scene.rule("sag_m", "creep", near=(way, 0.02 * way), from_s=10)
    return scene


def dragged():
    scene = Scene("H43", "1e5 N drag a light body at a wall",
                  "A body of 0.1 kg with two more on joints is pressed against a wall by 1e5 N for a "
                  "second: nothing gets through, the chain holds together.",
                  "bullet3 #471", 4, (-3.5, 3, 6), (0, 1, 0), shadow=15,
                  energy_from="the force")
    scene.ground()
    scene.fixed("wall", box(0.4, 3, 6), (1, 1.5, 0), material="brick")
    for i in range(3):
        scene.body(f"part_{i}", box(0.4, 0.4, 0.4), (-1 - 0.5 * i, 1, 0), 0.1, material="paint_orange",
                   more='ccd = "on"\n')
        if i:
            scene.joint("ball_and_socket", f"part_{i}", f"part_{i - 1}", (-0.75 - 0.5 * i, 1, 0))
    scene.event("force", "part_0", 0.5, value=(1e5, 0, 0), duration_s=1)
    scene.rule("x_m", below=0.7)  # 10 cm past where the first one's centre meets the wall
    scene.rule("max_joint_error_m", below=0.05, from_s=2.5)
    return scene


def snapped():
    scene = Scene("H44", "one link of a chain put 100 m away",
                  "The middle link of a hanging chain is put 100 m aside for one frame; the chain "
                  "recovers and nothing goes faster than 30 m/s. A fall of 100 m would give 44.",
                  "expected: a kick from the warm start", 8, (5, 8, 16), (1, 6, 0),
                  energy_from="the joints, which pull 100 m together")
    scene.ground()
    scene.scenery("beam", box(3, 0.3, 0.3), (0, 12.15, 0), "iron")
    above = "world"
    for i in range(10):
        scene.body(f"link_{i}", box(0.1, 1, 0.1), (0, 11.5 - i, 0),
                   material="paint_blue" if i == 5 else "paint_orange")
        scene.joint("ball_and_socket", f"link_{i}", above, (0, 12 - i, 0))
        above = f"link_{i}"
    scene.event("teleport", "link_5", 1, value=(100, 6.5, 0))
    scene.rule("speed_mps", below=30)
    scene.rule("max_joint_error_m", below=0.01, from_s=6)
    return scene


def slender():
    thin = 2 / 141.4
    scene = Scene("H45", "a slender rod carries a weight",
                  "A rod whose moments are as 1 to 10 000 swings with 1 kg hinged to its end.",
                  "Bullet's row-wise ball joints weakly [measured, 3.24]; Nu #656", 10, (1.5, 4, 6.5),
                  (0.3, 3, 0), shadow=15, energy_scale=3.1 * 9.81)
    scene.ground()
    scene.scenery("pin", ball(0.06), (0, 4, 0), "iron")
    scene.body("rod", box(2, thin, thin), (1, 4, 0), material="paint_cream")
    scene.body("weight", box(0.2, 0.2, 0.2), (2.1, 4, 0), material="rustmetal")
    scene.joint("ball_and_socket", "rod", "world", (0, 4, 0))
    scene.joint("hinge", "weight", "rod", (2, 4, 0), axis=(0, 0, 1))
    scene.rule("max_joint_error_m", below=0.01)
    scene.rule("speed_mps", below=math.sqrt(2 * 3.1 * 9.81))
    return scene


def wheel():
    scene = Scene("H46", "a wheel at 300 rad/s on its axle",
                  "A motor spins a wheel up to 300 rad/s, 286 degrees a step; it stays on its axle and the "
                  "block that carries it does not walk.",
                  "Bullet clamps at a quarter turn a step: 47 rad/s at 60 Hz [from its code]", 25,
                  (2, 2, 3.6), (0, 0.6, 0.2), shadow=12, energy_from="the motor")
    scene.ground()
    scene.body("block", box(1, 1, 1), (0, 0.5, 0), 10.0, material="stone")
    scene.body("wheel", cylinder(0.4, 0.1), (0, 0.7, 0.6), 2.0, turn=about_x(math.pi / 2),
               material="paint_orange")
    scene.joint("hinge", "wheel", "block", (0, 0.7, 0.6), name="axle", axis=(0, 0, 1),
                more="motor = { target = 300, max = 5 }\n")
    scene.rule("spin_radps", "wheel", near=(300, 3), from_s=20)
    scene.rule("joint_error_m", "axle", below=math.radians(1), from_s=20)
    scene.rule("horizontal_speed_mps", "block", below=0.01, from_s=20)
    return scene


def cantilever():
    scene = Scene("H47", "a beam of twenty fixed joints",
                  "Twenty boxes glued end to end stick out of a wall; the last may come down by 2 % of "
                  "the length.",
                  "Jolt keeps ConstraintPriority", 10, (10, 7, 15), (5, 4, 0))
    scene.ground()
    scene.fixed("wall", box(1, 8, 3), (-1, 4, 0), material="brick")
    before = "world"
    for i in range(20):
        scene.body(f"part_{i}", box(0.48, 0.3, 0.3), (-0.25 + 0.5 * i, 5, 0),
                   material="paint_orange" if i % 2 else "paint_blue")
        scene.joint("fixed", f"part_{i}", before, (-0.5 + 0.5 * i, 5, 0))
        before = f"part_{i}"
    scene.rule("sag_m", "part_19", below=0.2)
    scene.rule("speed_mps", below=0.01, from_s=5)
    return scene


def scenes():
    yield chain("H26", "ten links hold a hundredfold end", 10, 1.0,
                "Bullet's default stretches by 24.8 %, with 50 iterations 5.3 % [measured, 3.24]")
    yield chain("H28", "fifty links hold a hundredfold end", 50, 0.4,
                "Bullet's default stretches by 14.1 % [measured, 3.24]")
    yield bridge()
    yield net("H31", 12, 5, "ci")
    yield net("H31b", 40, 10, "nightly")
    yield ragdolls()
    yield contraption()
    yield door()
    yield singular()
    yield at_limit()
    yield fast_limit()
    yield motor()
    yield torn()
    yield stiff()
    yield dragged()
    yield snapped()
    yield slender()
    yield wheel()
    yield cantilever()
