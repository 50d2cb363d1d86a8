"""The text of one scene of the gallery: used by make_hard_scenes.py.

SI units, +Y up, the ground's top at y = 0. Unless said otherwise boxes weigh 1 kg, friction is 0.5,
nothing bounces, nothing sleeps. The order of the bodies is part of the scene.
"""
import math
import textwrap

# Light, sky and paints of a scene on open ground; peer scenes have the same.
LOOK = """[sun]
direction = [-0.545, -0.53, -0.65]
color = [1.0, 0.93, 0.82]
intensity = 3.4
shadow = {{ size_px = 2048, distance_m = {shadow} }}

[sky]
skybox = "skies/garden"

[ambient]
color = [0.3, 0.33, 0.38]

[post]
exposure = 0.95

[[material]]
name = "paint_orange"
base_color = [0.8, 0.28, 0.04]
roughness = 0.5

[[material]]
name = "paint_blue"
base_color = [0.06, 0.22, 0.45]
roughness = 0.5

[[material]]
name = "paint_cream"
base_color = [0.75, 0.68, 0.52]
roughness = 0.6
"""

HEAD = """# {id}: {title}.
#
{comment}
#
# Written by assets/source/make_hard_scenes.py: change that and run it again.

[scene]
title = "{id} {title}"
description = "{shows}"
include = ["scenes/materials.toml"]

[world]
gravity_mps2 = {gravity}
{kill}
[player]
position_m = {player}
yaw_deg = {yaw}
pitch_deg = {pitch}

[camera]
position_m = {camera}
target_m = {target}
fov_deg = 50

""" + LOOK


def number(value):
    """Short, and the same on every machine."""
    if isinstance(value, int):
        return repr(value)
    text = f"{value:.9g}"
    return text if any(c in text for c in ".einf") else text + ".0"


def reached_text(reached):
    return "a body of it is gone" if reached is None else f"it reaches {number(reached)}"


def numbers(values):
    return "[" + ", ".join(number(value) for value in values) + "]"


def about_x(angle):
    return (math.cos(angle / 2), math.sin(angle / 2), 0.0, 0.0)


def about_y(angle):
    return (math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0)


def about_z(angle):
    return (math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2))


def box(x, y, z):
    return f"box = {numbers((x, y, z))}"


def ball(radius):
    return f"sphere = {number(radius)}"


def cylinder(radius, height):
    return f"cylinder = {numbers((radius, height))}"


def capsule(radius, height):
    return f"capsule = {numbers((radius, height))}"


class Scene:
    """Parts are added in the order in which the file lists them."""

    def __init__(self, name, title, shows, known, seconds, camera, target, *, tier="ci",
                 gravity=(0, -9.81, 0), player=None, kill=None, shadow=40, settled=0, unsettled="",
                 penetration=0.02, energy_gain=None, energy_scale=None, energy_from="",
                 non_finite=0, removed=0):
        self.id, self.title, self.shows, self.known = name, title, shows, known
        self.seconds, self.tier, self.known_red = seconds, tier, ()
        self.camera, self.target, self.gravity = camera, target, gravity
        away = 1.15
        self.player = player or (target[0] + away * (camera[0] - target[0]), 0,
                                 target[2] + away * (camera[2] - target[2]))
        to_x, to_z = target[0] - self.player[0], target[2] - self.player[2]
        self.yaw_deg = math.degrees(math.atan2(-to_x, -to_z))
        eyes = self.player[1] + 1.7
        self.pitch_deg = math.degrees(math.atan2(target[1] - eyes, math.hypot(to_x, to_z)))
        self.kill, self.shadow = kill, shadow
        self.general, self.unsettled = {"penetration_m": penetration}, unsettled
        for key, value in (("settled_s", settled), ("energy_gain", energy_gain),
                           ("energy_scale_J", energy_scale), ("non_finite", non_finite), ("removed", removed)):
            if value:
                self.general[key] = value
        self.energy_from = energy_from
        self.parts, self.rules, self.events = [], [], []
        self.bodies = 0

    # --- things

    def _looks(self, shape, material, hidden):
        if shape.startswith("model"):
            return f'{shape}\nmaterial = "{material}"\n'
        return "" if hidden else f'primitive = {{ {shape} }}\nmaterial = "{material}"\n'

    def fixed(self, name, shape, at, *, material="flagstone", friction=0.5, restitution=0.0,
              turn=None, hidden=False, shadow=True, kind="static", extra="", body=""):
        """A body that the world does not move."""
        turned = f"orientation = {numbers(turn)}\n" if turn else ""
        own = f"shape = {{ {shape} }}\n" if hidden else ""
        casts = "" if shadow else "casts_shadow = false\n"
        self.parts.append(
            f'[[entity]]\nname = "{name}"\nposition_m = {numbers(at)}\n{turned}'
            f"{self._looks(shape, material, hidden)}{casts}{extra}[entity.body]\n"
            f'kind = "{kind}"\n{own}friction = {number(friction)}\n'
            f"restitution = {number(restitution)}\n{body}")

    def kinematic(self, name, shape, at, *, motion="", **options):
        """A kinematic body; `motion`: its table, or none."""
        extra = f"motion = {{ {motion} }}\n" if motion else ""
        self.fixed(name, shape, at, kind="kinematic", extra=extra, **options)

    def ground(self, friction=0.5, restitution=0.0, material="gravel", top=0):
        self.fixed("ground", box(200, 2, 200), (0, top - 1, 0), material=material, friction=friction,
                   restitution=restitution, shadow=False)

    def scenery(self, name, shape, at, material="paint_cream", turn=None):
        """Seen, not felt."""
        turned = f"orientation = {numbers(turn)}\n" if turn else ""
        self.parts.append(f'[[entity]]\nname = "{name}"\nposition_m = {numbers(at)}\n{turned}'
                          f'primitive = {{ {shape} }}\nmaterial = "{material}"\n')

    @staticmethod
    def _body(mass, friction, restitution, sleep, more):
        return (f"mass_kg = {number(mass)}\nfriction = {number(friction)}\n"
                f"restitution = {number(restitution)}\n"
                f"can_sleep = {'true' if sleep else 'false'}\n{more}")

    def body(self, name, shape, at, mass=1.0, *, material="wood", friction=0.5, restitution=0.0,
             velocity=None, spin=None, turn=None, sleep=False, own_shape="", more=""):
        """`own_shape`: what collides, where that is not what is seen."""
        turned = f"orientation = {numbers(turn)}\n" if turn else ""
        moving = f"velocity_mps = {numbers(velocity)}\n" if velocity else ""
        moving += f"angular_velocity_radps = {numbers(spin)}\n" if spin else ""
        own = f"shape = {{ {own_shape} }}\n" if own_shape else ""
        self.parts.append(
            f'[[entity]]\nname = "{name}"\nposition_m = {numbers(at)}\n{turned}'
            f"{self._looks(shape, material, False)}[entity.body]\n{own}{moving}"
            f"{self._body(mass, friction, restitution, sleep, more)}")
        self.bodies += 1

    def prefab(self, name, shape, mass=1.0, *, material="wood", friction=0.5, restitution=0.0,
               sleep=False, more=""):
        self.parts.append(f'[[prefab]]\nname = "{name}"\n{self._looks(shape, material, False)}'
                          f"[prefab.body]\n"
                          f"{self._body(mass, friction, restitution, sleep, more)}")

    def place(self, name, prefab, at, turn=None, velocity=None, spin=None):
        turned = f"orientation = {numbers(turn)}\n" if turn else ""
        moving = ""
        if velocity or spin:
            moving = "[entity.body]\n"
            moving += f"velocity_mps = {numbers(velocity)}\n" if velocity else ""
            moving += f"angular_velocity_radps = {numbers(spin)}\n" if spin else ""
        self.parts.append(f'[[entity]]\nname = "{name}"\nprefab = "{prefab}"\n'
                          f"position_m = {numbers(at)}\n{turned}{moving}")
        self.bodies += 1

    def array(self, name, prefab, origin, count, spacing):
        self.parts.append(f'[[array]]\nname = "{name}"\nprefab = "{prefab}"\n'
                          f"origin_m = {numbers(origin)}\ncount = {list(count)}\n"
                          f"spacing_m = {numbers(spacing)}\n")
        self.bodies += math.prod(count)

    def joint(self, kind, a, b="world", at=None, name="", axis=None, limits=None, more=""):
        lines = [f'[[joint]]\nkind = "{kind}"\na = "{a}"\nb = "{b}"']
        if name:
            lines.append(f'name = "{name}"')
        for key, value in (("anchor_m", at), ("axis", axis), ("limits", limits)):
            if value is not None:
                lines.append(f"{key} = {numbers(value)}")
        self.parts.append("\n".join(lines) + "\n" + more)

    # --- what passes, what happens

    def rule(self, measure, of=(), below=None, above=None, near=None, from_s=None, to_s=None, to=""):
        """`near`: (value, within)."""
        self.rules.append({"measure": measure, "of": [of] if isinstance(of, str) else list(of),
                           "relative_to": to, "from_s": from_s, "to_s": to_s, "below": below,
                           "above": above, "near": near[0] if near else None,
                           "within": near[1] if near else None})

    def event(self, do, of="", at_s=0.0, **values):
        self.events.append((do, of, at_s, values))

    # --- the file

    @staticmethod
    def _in_words(rule):
        of = " of " + ", ".join(rule["of"]) if rule["of"] else ""
        against = f" against {rule['relative_to']}" if rule["relative_to"] else ""
        limit = (f"within {number(rule['within'])} of {number(rule['near'])}"
                 if rule["near"] is not None else f"at most {number(rule['below'])}"
                 if rule["below"] is not None else f"at least {number(rule['above'])}")
        when = f", from {number(rule['from_s'])} s" if rule["from_s"] else ""
        when += f", until {number(rule['to_s'])} s" if rule["to_s"] else ""
        return f"{rule['measure']}{of}{against} {limit}{when}"

    def rules_in_words(self):
        return [self._in_words(rule) for rule in self.rules]

    def _comment(self):
        general = self.general
        rules = self.rules_in_words()
        since = (f" from {number(general['settled_s'])} s (before, {self.unsettled})"
                 if self.unsettled else "")
        rules.append(f"and as every case: all finite, penetration at most "
                     f"{number(general['penetration_m'])} m{since}")
        gain = number(100 * general.get("energy_gain", 0.01))
        rules.append(f"energy never {gain} % above its start" if not self.energy_from
                     else f"energy not judged: {self.energy_from}")
        text = [("Shows: ", self.shows), ("Passes: ", "; ".join(rules) + f"; {number(self.seconds)} s."),
                ("Known to fail: ", self.known)]
        text += [("small_step fails: ", f"{rule}; {reached_text(reached)}: {why}")
                 for rule, reached, why in self.known_red]
        lines = []
        for label, words in text:
            lines += textwrap.wrap(label + words, 98, initial_indent="# ", subsequent_indent="#   ")
        return "\n".join(lines)

    def _case(self):
        lines = ["[hard_case]", f'id = "{self.id}"', f'shows = "{self.shows}"',
                 f'known_to_fail = "{self.known}"', f"seconds = {number(self.seconds)}",
                 f'tier = "{self.tier}"']
        lines += [f"{key} = {number(value)}" for key, value in self.general.items()]
        if self.unsettled:
            lines.append(f'unsettled = "{self.unsettled}"')
        if self.energy_from:
            lines.append(f'energy_from = "{self.energy_from}"')
        for rule in self.rules:
            lines += ["", "[[hard_case.pass]]", f'measure = "{rule["measure"]}"']
            if rule["of"]:
                lines.append("of = [" + ", ".join(f'"{name}"' for name in rule["of"]) + "]")
            if rule["relative_to"]:
                lines.append(f'relative_to = "{rule["relative_to"]}"')
            lines += [f"{key} = {number(rule[key])}" for key in ("from_s", "to_s", "below", "above",
                                                                 "near", "within")
                      if rule[key] is not None]
        for rule, reached, why in self.known_red:
            lines += ["", "[[hard_case.known_red]]", f'rule = "{rule}"',
                      "gone = true" if reached is None else f"reached = {number(reached)}", f'why = "{why}"']
        for do, of, at_s, values in self.events:
            lines += ["", "[[hard_case.event]]", f'do = "{do}"']
            if of:
                lines.append(f'of = "{of}"')
            lines.append(f"at_s = {number(at_s)}")
            for key, value in values.items():
                lines.append(f"{key} = "
                             + (numbers(value) if isinstance(value, tuple) else number(value)))
        return "\n".join(lines) + "\n"

    def text(self):
        head = HEAD.format(id=self.id, title=self.title, shows=self.shows, comment=self._comment(),
                           gravity=numbers(self.gravity), player=numbers(self.player),
                           yaw=number(round(self.yaw_deg, 1)), pitch=number(round(self.pitch_deg, 1)),
                           camera=numbers(self.camera), target=numbers(self.target),
                           shadow=number(self.shadow),
                           kill="" if self.kill is None else f"kill_below_m = {number(self.kill)}\n")
        return "\n".join([head, self._case(), *self.parts])

    def write(self, folder):
        (folder / f"{self.id}.toml").write_text(self.text(), encoding="utf-8")
