"""What stands and hangs in the garden and moves when it is touched: gate, swing, seesaw, windmill,
lantern, chimes, bench, wheelbarrow, and small things. garden_plan.py has their measures.
"""
import math

import garden_plan as garden
from scene_writer import ball, box, compound, entity, heading, hinge, prefab, prism, put, vec


def at(place, yaw_deg, point):
    """A point of something that stands at `place` turned by `yaw_deg` about +Y, in the world."""
    c, s = math.cos(math.radians(yaw_deg)), math.sin(math.radians(yaw_deg))
    x, y, z = point
    return (place[0] + c * x + s * z, place[1] + y, place[2] - s * x + c * z)


def across(yaw_deg):
    """The world's direction of its x axis."""
    return at((0, 0, 0), yaw_deg, (1, 0, 0))


def boards(name):
    return compound(box(*part[1:]) for part in garden.BOXES[name])


def standing(name, place, yaw_deg=0, parts=None):
    """Something of boards that does not move."""
    entity(name, place, model=f'"models/{name}.glb"', rotation_deg=vec(0, yaw_deg, 0), body=['kind = "static"', parts or boards(name)])


def gate(z):
    heading("gate: two leaves that open both ways and stay where they are left, or at their limits")
    x, thick, height = garden.GATE_POST
    prefab("gate_post", ['model = "models/gate_post.glb"', "[prefab.body]", 'kind = "static"', compound([box((0, height / 2, 0), (thick, height, thick))])])
    leaf = compound([box((garden.GATE_WIDTH / 2, 0.54, 0), (garden.GATE_WIDTH, 0.96, garden.GATE_THICK))])
    prefab("gate_leaf", ['model = "models/gate.glb"', "[prefab.body]", leaf, "mass_kg = 14"], "garden gate")
    for side, sign, turn in (("left", -1, 0), ("right", 1, 180)):
        entity(f"gate_post_{side}", (sign * x, 0, z), prefab='"gate_post"')
        place = (sign * garden.GATE_HINGE_X, 0.02, z)
        entity(f"gate_{side}", place, prefab='"gate_leaf"', rotation_deg=vec(0, turn, 0))
        hinge(f"gate_{side}", f"gate_post_{side}", place, (-100, 100), 1.5, creak=0.7)


def swing(place, yaw_deg):
    heading("swing")
    standing("swing_frame", place, yaw_deg)
    axis = at(place, yaw_deg, (0, garden.SWING_AXIS_Y, 0))
    entity("swing", axis, label='"swing"', model='"models/swing.glb"', rotation_deg=vec(0, yaw_deg, 0),
           body=[boards("swing"), "mass_kg = 18", "friction = 0.9", "angular_damping_per_s = 0.05"])
    hinge("swing", "swing_frame", axis, (-100, 100), 0.3, across(yaw_deg), creak=0.6)


def seesaw(place, yaw_deg):
    heading("seesaw: one end down; what the hinge holds by friction is 1.5 kg at one end")
    standing("seesaw_base", place, yaw_deg)
    axis, tip = at(place, yaw_deg, (0, garden.SEESAW_AXIS_Y, 0)), garden.SEESAW_TIP_DEG
    entity("seesaw", axis, label='"seesaw"', model='"models/seesaw.glb"', rotation_deg=turned(yaw_deg, tip),
           body=[boards("seesaw"), "mass_kg = 28", "friction = 0.9"])
    hinge("seesaw", "seesaw_base", axis, (-2 * tip, 0), 24, at((0, 0, 0), yaw_deg, (0, 0, 1)), creak=0.5)


def turned(yaw_deg, roll_deg):
    """rotation_deg of a turn about z and then about y: as the file takes x, y, z in this order."""
    yaw, roll = math.radians(yaw_deg), math.radians(roll_deg)
    # the matrix Ry Rz, read as Rz' Ry' Rx'
    y = math.asin(max(-1.0, min(1.0, math.sin(yaw) * math.cos(roll))))
    z = math.atan2(math.sin(roll), math.cos(yaw) * math.cos(roll))
    x = math.atan2(math.sin(yaw) * math.sin(roll), math.cos(yaw))
    return vec(*(math.degrees(angle) for angle in (x, y, z)))


def windmill(place, yaw_deg):
    heading("windmill: a motor turns it")
    height, foot, top = 2.45, 0.45, 0.16
    tower = "{ hull_m = [" + ", ".join(vec(sx * w, y, sz * w) for y, w in ((0, foot), (height, top)) for sx in (-1, 1) for sz in (-1, 1)) + "] }"
    _, hub, forward = garden.MILL_HUB
    standing("windmill", place, yaw_deg, compound([tower, box((0, hub, -0.03), (0.3, 0.42, 0.5)), box((0, hub + 0.06, -0.7), (0.03, 0.4, 0.6))]))
    axis = at(place, yaw_deg, garden.MILL_HUB)
    entity("windmill_rotor", axis, label='"sails of the windmill"', model='"models/windmill_rotor.glb"', rotation_deg=vec(0, yaw_deg, 0), casts_shadow="false",
           body=[compound(box(*part[1:]) for part in garden.BOXES["windmill_rotor"] if part[0] == "blade"), "mass_kg = 5"])
    put('\n[[joint]]\nname = "windmill_axle"\nkind = "hinge"\na = "windmill_rotor"\nb = "windmill"')
    put(f"anchor_m = {vec(*axis)}\naxis = {vec(*at((0, 0, 0), yaw_deg, (0, 0, 1)))}\nmotor = {{ target = 1.4, max = 4 }}\ncreak = 0.35")


def hook_post(name, place, yaw_deg):
    """Where its hook ends."""
    entity(name, place, model='"models/hook_post.glb"', rotation_deg=vec(0, yaw_deg, 0), body=['kind = "static"', boards("hook_post")])
    return at(place, yaw_deg, (-garden.HOOK_REACH, garden.HOOK_POST_Y - 0.08, 0))


def lantern_on_chain(place, yaw_deg, links):
    heading("a lantern on a chain, and another that stands about")
    hook = hook_post("lantern_post", place, yaw_deg)
    width, height = garden.LANTERN
    prefab("lantern", ['model = "models/lantern.glb"', 'light = { kind = "point", color = [1, 0.66, 0.34], intensity = 1.2, radius_m = 4, offset_m = [0, 0.165, 0], shadow = true, on = "dark" }', "[prefab.body]", compound([box((0, height / 2, 0), (width, height, width))]),
                       "mass_kg = 1.6", "angular_damping_per_s = 0.4", "linear_damping_per_s = 0.5"], "lantern")
    prefab("chain_link", ['model = "models/chain_link.glb"', "casts_shadow = false", "[prefab.body]",
                          compound([box((0, -garden.LINK / 2, 0), (0.03, garden.LINK, 0.03))]), "mass_kg = 0.08",
                          "linear_damping_per_s = 2", "angular_damping_per_s = 6"], "chain")
    above = "lantern_post"
    for i in range(links):
        top = (hook[0], hook[1] - i * garden.LINK, hook[2])
        entity(f"lantern_chain_{i + 1}", top, prefab='"chain_link"', rotation_deg=vec(0, yaw_deg + 90 * (i % 2), 0))
        ball(f"lantern_chain_{i + 1}_joint", f"lantern_chain_{i + 1}", above, top)
        above = f"lantern_chain_{i + 1}"
    ring = (hook[0], hook[1] - links * garden.LINK, hook[2])
    entity("lantern_hanging", (ring[0], ring[1] - garden.LANTERN_RING, ring[2]), prefab='"lantern"', rotation_deg=vec(0, yaw_deg, 0))
    ball("lantern_hanging_joint", "lantern_hanging", above, ring)
    put("creak = 0.4")


def chimes(place, yaw_deg):
    heading("wind chimes: tubes about a clapper, each on a cord")
    hook = hook_post("chimes_post", place, yaw_deg)
    y = hook[1] - 0.1
    entity("chimes_ring", (hook[0], y + 0.008, hook[2]), primitive="{ cylinder = [0.1, 0.016] }", material='"oak"', casts_shadow="false", body=['kind = "static"'])
    entity("chimes_cord", (hook[0], y + 0.055, hook[2]), primitive="{ cylinder = [0.004, 0.1] }", material='"rope"', casts_shadow="false")
    for i, length in enumerate(garden.CHIME_TUBES):
        turn = 360 * i / len(garden.CHIME_TUBES)
        top = at((hook[0], y, hook[2]), turn, (garden.CHIME_RADIUS, 0, 0))
        entity(f"chime_{i + 1}", top, label='"chime"', model='"models/chime_tube.glb"', scale=vec(1, length, 1), material='"chime"', casts_shadow="false",
               body=[compound([f"{{ cylinder = [{garden.CHIME_TUBE}, 1], position_m = [0, -0.7, 0] }}"]), f"mass_kg = {1.3 * length:.3f}", "linear_damping_per_s = 0.4", "angular_damping_per_s = 0.6"])
        ball(f"chime_{i + 1}_cord", f"chime_{i + 1}", "chimes_ring", top)
    top = (hook[0], y, hook[2])
    entity("chime_clapper", top, label='"clapper of the chimes"', model='"models/chime_clapper.glb"', casts_shadow="false",
           body=[compound(["{ cylinder = [0.035, 0.02], position_m = [0, -0.34, 0] }", box((0, -0.74, 0), (0.085, 0.13, 0.012))]), "mass_kg = 0.3", "linear_damping_per_s = 0.4", "angular_damping_per_s = 0.6"])
    ball("chime_clapper_cord", "chime_clapper", "chimes_ring", top)


def bench_with_dominoes(place, yaw_deg, count):
    heading("a bench, and dominoes on it")
    top = garden.BENCH_TOP
    seat = [box((0, top - 0.015, -0.0175), (1.5, 0.03, 0.37)), box((0, 0.68, -0.225), (1.5, 0.325, 0.03))]
    seat += [box((x, 0.21, z), (0.05, 0.42, 0.05)) for x in (-0.66, 0.66) for z in (0.13, -0.215)]
    # Contacts are springs: both are placed as deep as they sink in, else the dominoes hop off their places.
    bench_sinks, domino_sinks = 1e-5, 1e-4
    entity("garden_bench", at(place, 0, (0, -bench_sinks, 0)), digits=5, label='"garden bench"', model='"models/garden_bench.glb"', rotation_deg=vec(0, yaw_deg, 0),
           body=[compound(seat), "mass_kg = 32", "friction = 0.6"])
    prefab("small_domino", ["primitive = { box = [0.02, 0.12, 0.06] }", 'material = "glaze_white"', "casts_shadow = false", "[prefab.body]", "mass_kg = 0.1", "friction = 0.4",
                            "restitution = 0"], "little domino")
    for i in range(count):
        x = 0.07 * (i - (count - 1) / 2)
        entity(f"small_domino_{i + 1}", at(place, yaw_deg, (x, top + 0.06 - bench_sinks - domino_sinks, 0.0)), digits=5, prefab='"small_domino"', rotation_deg=vec(0, yaw_deg, 0))


def wheelbarrow(place, yaw_deg):
    heading("wheelbarrow")
    entity("wheelbarrow", place, label='"wheelbarrow"', model='"models/wheelbarrow.glb"', rotation_deg=vec(0, yaw_deg, 0), body=[boards("wheelbarrow"), "mass_kg = 14", "friction = 0.5"])
    radius, width = garden.BARROW_WHEEL
    axle = at(place, yaw_deg, garden.BARROW_AXLE)
    entity("barrow_wheel", axle, label='"wheel of the barrow"', model='"models/barrow_wheel.glb"', rotation_deg=turned(yaw_deg, 90),
           body=[f"shape = {{ cylinder = [{radius}, {width}] }}", "mass_kg = 0.9", "friction = 0.9", "rolling_friction = 0.003"])
    put(f'\n[[joint]]\nname = "barrow_axle"\nkind = "hinge"\na = "barrow_wheel"\nb = "wheelbarrow"\nanchor_m = {vec(*axle)}\naxis = {vec(*across(yaw_deg))}\nmotor = {{ target = 0, max = 0.2 }}')


def small_things(can, table, table_yaw_deg, table_top):
    heading("watering can, potting table, pots")
    prefab("watering_can", ['model = "models/watering_can.glb"', "[prefab.body]", compound([box((0, 0.07, 0), (0.15, 0.14, 0.15)), prism(0.1, 0.14, 0.235), box((0, 0.17, 0.19), (0.03, 0.2, 0.2))]),
                            "mass_kg = 1.2", "friction = 0.5"], "watering can")
    entity("watering_can_1", can, prefab='"watering_can"', rotation_deg="[0, 130, 0]")
    entity("potting_table", table, prefab='"desk"', label='"potting table"', rotation_deg=vec(0, table_yaw_deg, 0))
    for name, kind, x, z, turn in (("pot_on_table_1", "pot", -0.38, -0.06, 0), ("watering_can_2", "watering_can", 0.3, 0.02, 60)):
        entity(name, at(table, table_yaw_deg, (x, table_top, z)), prefab=f'"{kind}"', rotation_deg=vec(0, turn, 0))
    for i, (x, z) in enumerate(((0.75, 0.2), (0.8, -0.1))):
        entity(f"pot_outside_{i + 1}", at(table, table_yaw_deg, (x, 0, z)), prefab='"pot"')
    entity("lantern_standing", at(table, table_yaw_deg, (-0.05, table_top, -0.06)), prefab='"lantern"', rotation_deg=vec(0, table_yaw_deg + 20, 0))


def put_things(front_z):
    gate(front_z)
    swing((-9.2, 0, -2.6), 35)
    seesaw((6.3, 0, 8.1), 30)
    windmill((7.5, 0, -0.9), 20)
    lantern_on_chain((-1.3, 0, 7.75), 0, 5)
    chimes((4.6, 0, 4.6), 180)
    bench_with_dominoes((-3.5, 0, 6.7), 135, 13)
    wheelbarrow((-6.6, 0, 4.6), 200)
    small_things((-3.1, 0, -1.8), (-9.5, 0, -8.6), 90, 0.74)
