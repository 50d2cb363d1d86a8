"""Hard cases D18 to D23: motors, springs, limits, sleep, joints that break."""
import itertools
import math

from hard_contacts import model, write_obj
from hard_hulls import apart, hull_faces
from hard_scene import Scene, about_z, ball, box, number, numbers

G = 9.81
U = (((4, 0.4, 0.4), (0, 0, 0)), ((0.4, 4, 0.4), (-1.8, 2.2, 0)), ((0.4, 4, 0.4), (1.8, 2.2, 0)))


def write_models(folder):
    vertices, triangles = [], []
    for size, at in U:
        corners = [tuple(middle + side * edge / 2 for middle, side, edge in zip(at, sides, size))
                   for sides in itertools.product((-1, 1), repeat=3)]
        points, faces = apart(corners, hull_faces(corners))
        triangles += [tuple(len(vertices) + corner for corner in face) for face in faces]
        vertices += points
    write_obj(folder / "u.obj", "A bar with two uprights", vertices, triangles)


def beyond_half_a_turn():
    scene = Scene("D18", "limits beyond half a turn",
                  "Leaves on hinges, driven both ways by 50 N m towards limits of up to 350 degrees: each stops there, "
                  "holds for 5 s and never comes out of the back.",
                  "dimforge/rapier #499: stopped [0, 270] at 90 and [-200, 200] at 160 degrees; godot #18351: Bullet's "
                  "motor stops and starts every 360 degrees", 7.5, (1.5, 5, 14.5), (0, 3.1, 0), gravity=(0, 0, 0),
                  energy_from="the motors", energy_scale=100.0, shadow=40)
    scene.ground()
    limits = ((0, 270, 0), (-270, 0, 0), (-90, 200, 0), (-350, 0, 0), (45, 315, 60), (135, 225, 180), (-200, 200, 0))
    for i, (low, high, start) in enumerate(limits):
        for way, y in (("up", 4.6), ("down", 1.6)):
            sign = 1 if way == "up" else -1
            at, angle, name = (2.5 * i - 7.5, y, 0), math.radians(start), f"{way}_{i}"
            scene.scenery(f"pin_{name}", ball(0.14), at, "iron")
            scene.body(f"leaf_{name}", box(1, 0.2, 0.2),
                       (at[0] + 0.5 * math.cos(angle), y + 0.5 * math.sin(angle), 0), 2.0, turn=about_z(angle),
                       material="paint_orange" if sign > 0 else "paint_blue")
            scene.joint("hinge", f"leaf_{name}", "world", at, name, axis=(0, 0, 1), limits=(low - start, high - start),
                        more=f"motor = {{ target = {5 * sign}, max = 50 }}\n")
            end = (high if sign > 0 else low) - start
            scene.rule("joint_angle_deg", name, near=(end, 0.5), from_s=2.5)
        scene.rule("joint_angle_deg", [f"up_{i}", f"down_{i}"], below=high - start + 0.5)
        scene.rule("joint_angle_deg", [f"up_{i}", f"down_{i}"], above=low - start - 0.5)
    return scene


def balls_on_springs():
    stiffness, light, heavy = 1000.0, 0.524, 100.0
    critical = 2 * math.sqrt(stiffness * light)
    sag = (light + heavy) * G / stiffness
    scene = Scene("D19", "heavy cubes on light balls on springs",
                  "Thirty-one balls of 0.524 kg, drawn by springs of no length to points 3 m below, catch cubes of 100 kg "
                  "from 5 m above; damping from none to twice the critical. One more pair starts at its static sag and "
                  "must stay there. The speed of 20 m/s is judged of the cubes: the springs alone give a ball 131 m/s.",
                  "rapier joint_contact_solve_order.rs: where joints are solved after contacts every cube tunnels "
                  "through its ball, only with enough pairs for the threaded colouring", 3, (4, 5, 32), (0, 2, 0),
                  player=(4, -4, 34), penetration=0.02, shadow=70)
    scene.ground(top=-4)
    for i in range(32):
        x, settled = 1.5 * i - 23.25, i == 31
        top = 1.5 - sag if settled else 4.5
        name = "settled" if settled else str(i)
        scene.body(f"ball_{name}", ball(0.5), (x, top, 0), light, material="paint_blue")
        scene.body(f"cube_{name}", box(1, 1, 1), (x, top + (1.0 if settled else 5), 0), heavy,
                   material="paint_cream" if settled else "rustmetal")
        damping = critical * (15 if settled else i) / 15
        scene.joint("spring", f"ball_{name}", "world", name=f"spring_{name}",
                    more=f"anchor_a_m = {numbers((x, top, 0))}\nanchor_b_m = {numbers((x, 1.5, 0))}\n"
                         f"stiffness_Npm = {number(stiffness)}\ndamping_Nspm = {number(damping)}\n"
                         "rest_length_m = 0\n")
        scene.rule("height_m", f"cube_{name}", to=f"ball_{name}", above=0)
    scene.rule("speed_mps", "cube_*", below=20)
    scene.rule("height_m", "ball_settled", near=(1.5 - sag, 0.02 * sag))
    return scene


def lopsided():
    load = 10 * G
    scene = Scene("D20", "a motor that holds a lopsided load",
                  "Sliders with a motor that stands still hold boxes of 10 kg, one with its middle of mass 1 m beside, "
                  "one held 1 m beside. Not judged: the moment of 98.1 N m.",
                  "NVIDIAGameWorks/PhysX #304: 3.4 and 4.1 slip down, faster the farther the mass is off", 20,
                  (1.5, 2.4, 4.6), (0.4, 1.3, 0), penetration=0.008, shadow=12)
    scene.ground()
    for name, x, held, more in (("mass", -0.8, -0.8, "center_of_mass_m = [1, 0, 0]\n"), ("anchor", 1.6, 0.6, "")):
        scene.scenery(f"rail_{name}", box(0.06, 2.4, 0.06), (held, 1.2, -0.26), "iron")
        scene.body(f"box_{name}", box(0.4, 0.4, 0.4), (x, 1.4, 0), 10.0, material="paint_orange", more=more)
        scene.joint("slider", f"box_{name}", "world", (held, 1.4, 0), f"slider_{name}", axis=(0, 1, 0),
                    more="motor = { target = 0, max = 1e6 }\n")
    scene.rule("sag_m", below=0.001)
    scene.rule("joint_force_N", ["slider_*"], near=(load, 0.01 * load), from_s=1)
    return scene


def twisted_arm():
    scene = Scene("D21", "an arm under a steady twist",
                  "Afloat, an arm of two limbs on cone joints is twisted by a couple of 40 N m on the lower one for 6 s: "
                  "limits hold, and at the end it rests against them. Damping of 60/s is ours: without it such a couple "
                  "whirls the arm round its cones for ever. Anchors and twist are judged together, within half a "
                  "degree (8.7 mm).",
                  "jrouwe/JoltPhysics #1993: pyramid limits are passed by far when the anchor is off the middle of "
                  "mass", 6, (1.2, 2.5, 2.2), (0.3, 2, 0), gravity=(0, 0, 0), energy_from="the couple",
                  energy_scale=40.0, penetration=0.002, shadow=12)
    scene.ground()
    scene.fixed("shoulder", box(0.1, 0.3, 0.3), (-0.05, 2, 0), material="iron")
    above = "shoulder"
    for i, name in enumerate(("upper", "lower")):
        scene.body(name, box(0.4, 0.1, 0.1), (0.4 * i + 0.2, 2, 0), 2.0,
                   material=("paint_blue", "paint_orange")[i], more="angular_damping_per_s = 60\n")
        scene.joint("cone", name, above, (0.4 * i, 2, 0), f"joint_{name}", axis=(1, 0, 0), limits=(0, 60),
                    more="twist = [-4, 135]\n")
        above = name
    # Two forces of 100 N, 0.4 m apart, across (1, 1, 1).
    arm = tuple(0.2 * value / math.sqrt(2) for value in (1, -1, 0))
    force = tuple(100 * value / math.sqrt(6) for value in (1, 1, -2))
    for sign in (1, -1):
        scene.event("force", "lower", 0.0, value=tuple(sign * value for value in force),
                    point_m=tuple(sign * value for value in arm), duration_s=6)
    scene.rule("joint_angle_deg", below=60.5)
    scene.rule("joint_error_m", below=math.radians(0.5))
    scene.rule("speed_mps", below=0.002, from_s=5.5)
    return scene


def fair_sleep():
    scene = Scene("D22", "sleep that is fair",
                  "A wide U must sleep within 4 s, a beam whose tips creep must not; a cube that turns may. Who sleeps on "
                  "a pushed cube rides along, what creeps into a sleeper from 14 s on wakes it, a sleeping pendulum "
                  "follows its carrier.",
                  "rapier sleep_wide_bodies.rs, sleep_wake.rs, issue_287: wide bodies never slept, riders were left "
                  "floating, slow kinematics tunnelled through sleepers", 20, (10, 8, 17), (0, 1.6, -1),
                  penetration=0.002, energy_from="the bodies that are moved", shadow=50)
    friction = 0.6
    scene.ground(friction)
    scene.body("u", model("u"), (-7, 0.2, 1), 10.0, friction=friction, sleep=True, material="paint_orange",
               own_shape="compound = [" + ", ".join(f"{{ {box(*size)}, position_m = {numbers(at)} }}"
                                                    for size, at in U) + "]")
    scene.body("beam", box(20, 0.2, 0.2), (0, 5, -7), 10.0, spin=(0, 0.02, 0), sleep=True)
    scene.scenery("mast", box(0.1, 5, 0.1), (0, 2.5, -7), "iron")
    scene.joint("hinge", "beam", "world", (0, 5, -7), "beam", axis=(0, 1, 0))
    scene.body("turning", box(0.1, 0.1, 0.1), (-3.6, 1, 1), spin=(0, 0.06, 0), sleep=True, material="paint_blue")
    scene.joint("hinge", "turning", "world", (-3.6, 1, 1), "turning", axis=(0, 1, 0))
    scene.kinematic("pusher", box(1, 1, 1), (-1.52, 0.5, 1), material="rustmetal", friction=friction)
    scene.body("pushed", box(1, 1, 1), (-0.5, 0.5, 1), friction=friction, sleep=True)
    scene.body("rider", box(1, 1, 1), (-0.5, 1.5, 1), friction=friction, sleep=True, material="paint_cream")
    scene.kinematic("creeper", box(1, 1, 1), (2.97, 0.5, 1), material="rustmetal", friction=friction)
    scene.body("crept", box(1, 1, 1), (4, 0.5, 1), friction=friction, sleep=True)
    scene.kinematic("carrier", box(0.5, 0.5, 0.5), (7, 4, 0), material="rustmetal")
    scene.body("bob", ball(0.5), (7, 2, 0), sleep=True, material="paint_blue")
    scene.joint("ball_and_socket", "bob", "carrier", (7, 4, 0), "string")
    for body, velocity, begin, end in (("pusher", (0.15, 0, 0), 7, 13), ("creeper", (0.005, 0, 0), 8, 20),
                                       ("carrier", (0, 0, 1), 8, 12)):
        scene.events.append(("velocity", body, begin, {"value": velocity}))
        if end < 20:
            scene.events.append(("velocity", body, end, {"value": (0, 0, 0)}))
    scene.events.sort(key=lambda event: event[2])
    scene.rule("awake", "u", below=0.5, from_s=4)
    scene.rule("awake", "beam", above=0.5)
    turned = math.degrees(0.4)
    scene.rule("joint_angle_deg", "beam", near=(turned, 0.01 * turned), from_s=20)
    scene.rule("awake", ["pushed", "rider", "crept", "bob"], below=0.5, from_s=6, to_s=6.9)
    scene.rule("awake", "rider", above=0.5, from_s=7.5, to_s=13)
    scene.rule("displacement_m", "rider", to="pushed", below=0.05)
    scene.rule("x_m", "pushed", near=(-0.5 + 0.15 * 6 - 0.02, 0.005), from_s=13, to_s=13)
    scene.rule("x_m", "crept", near=(4 + 0.005 * 12 - 0.03, 0.001), from_s=20)
    scene.rule("x_m", "crept", to="creeper", above=0.999)
    swing = math.acos(1 - 1 / (2 * G * 2))  # of a point on a string: the ball's is smaller
    scene.rule("awake", "bob", above=0.5, from_s=8.1, to_s=12)
    scene.rule("from_axis_m", "bob", to="carrier", below=2 * math.sin(swing), to_s=12)
    return scene


def breaking():
    scene = Scene("D23", "a joint that breaks quietly",
                  "Afloat, pairs of boxes on joints that break at 50 N are pulled apart by 49 N for 2 s, then by 60: they "
                  "hold, break in one step and then fly off at 60 m/s2 (at 60 Hz), without a turn. So they do with anchors 0.5 m off the "
                  "line, but for the ball joint, which holds no moment. The slider is held by its limit.",
                  "isaac-sim/IsaacLab #2619: a PhysX D6 at its breakForce: bodies part violently, turn, or go through "
                  "each other", 2.5, (3.6, 4, 8), (0, 1.2, 0), gravity=(0, 0, 0), energy_from="the forces",
                  energy_scale=100.0, penetration=0.004, shadow=40)
    scene.ground()
    kinds = (("fixed", None), ("hinge", (0, 1, 0)), ("ball_and_socket", None), ("slider", (1, 0, 0)))
    row = 0
    for off in (0, 0.5):
        for kind, axis in kinds:
            if off and kind == "ball_and_socket":
                continue
            name, z = f"{kind}_{'off' if off else 'on'}", 1.2 * row - 3.6
            row += 1
            for side, sign in (("left", -1), ("right", 1)):
                scene.body(f"{name}_{side}", box(0.2, 0.2, 0.2), (0.15 * sign, 1.5, z),
                           material="paint_blue" if off else "paint_orange")
                scene.event("force", f"{name}_{side}", 0.0, value=(49.0 * sign, 0, 0), duration_s=2)
                scene.event("force", f"{name}_{side}", 2.0, value=(60.0 * sign, 0, 0), duration_s=0.5)
            scene.joint(kind, f"{name}_left", f"{name}_right", (0, 1.5 + off, z), name, axis=axis,
                        limits=(0, 0.1) if kind == "slider" else None, more="break_N = 50\n")
    scene.events.sort(key=lambda event: event[2])
    scene.rule("displacement_m", below=0.0001, to_s=2)
    scene.rule("joint_force_N", near=(49, 0.49), from_s=0.1, to_s=2)
    for at_s in (2.1, 2.5):  # in the step in which it breaks the joint still holds
        speed = 60 * (at_s - 2 - 1 / 60)
        scene.rule("speed_mps", near=(speed, 0.01 * speed), from_s=at_s, to_s=at_s)
    scene.rule("momentum_change", below=1e-6)
    scene.rule("spin_radps", below=1e-6)
    return scene


def scenes():
    yield beyond_half_a_turn()
    yield balls_on_springs()
    yield lopsided()
    yield twisted_arm()
    yield fair_sleep()
    yield breaking()
