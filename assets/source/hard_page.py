"""docs/GALLERY.md: what the gallery of hard cases holds, and what of PHYSICS.md it does not."""

INTRODUCTION = """# The gallery of hard cases

Scenes that are known to make physics engines fall over, fly apart, tunnel or creep, each with its own
pass rule in numbers. `assets/source/make_hard_scenes.py` writes them and this page; the rules' words are
explained in [SCENE-FORMAT.md](SCENE-FORMAT.md#hard-cases).

```
plumbline stability                            # every case of the CI tier, every solver
plumbline stability H05 H30 --solver small_step
plumbline stability --tier all --rates --out DIR   # the long ones too, at 30, 60 and 240 Hz; JSON and a page
plumbline play hard/H05                        # walk round in one; its rules stand on the screen
```

Every solver runs at the game's setting: 60 Hz and the default preset. A case passes when every rule of its own
holds to the end, all bodies stay finite, none falls out of the world, the deepest contact after settling stays
under 2 % of the smallest edge (or what the case says), and the energy never rises 1 % above its start where
nothing feeds energy in. `stability` ends with exit code 0 once it ran; with `--expect-green` with 5 when small_step
fails a case without a `known_red` that says why.

| case | shows | passes | known to fail |
|---|---|---|---|
"""

# What small_step does not reach, as far as it is understood; shown on every table.
KNOWN_RED = {
    "H15": "the house comes down within 6 s; so it does with Bullet",
    "H34": "limbs that others lie on overlap by 2.1 cm where 1 is asked",
    "H51": "the ball dips by 1.12 mm where 1 mm is asked",
    "H54": "some plates fall through the mesh: the sweep follows their middles, and Bullet finds their points",
    "H56": "a cube that lands flat on the cylinder's end at 20 m/s gets points off centre from Bullet's detector "
           "and is thrown aside",
    "H59": "the sweep follows the way of a body, not its turning: tips at 100 m/s pass a post",
    "H62": "bolts of 1 mm radius do not come to rest: Bullet's cylinders change their points from step to step",
    "H63": "the marble sinks 2 mm into the mesh where 0.2 are asked, and is pushed out of it",
    "H65": "the coin overlaps by 7 mm where 2 are asked in the step in which it lies down",
}

LEFT_OUT = """
Long cases (nightly tier): {nightly}.

## What small_step fails

| case | why |
|---|---|
{reds}

## What is not here

| row | why |
|---|---|
| H83 | the slope of a heap has no closed form; it needs a converged reference, which `plumbline study` makes for any scene |
| H88 | a scene steps at one rate; `tests/scenarios/families/life_test.cpp` steps unevenly |
| H89 | it compares several runs; the same file does, bit for bit |
| H90 | there are no vehicles |
| C01 to C14 | the walking character is tested in `tests/engine/physics/character/character_test.cpp` |

Smaller than the row asks, so that they load without a warning or end in minutes: H12 is 99 wide, not 100; H31b is 40
by 40, not 100 by 100, and 10 s, not 10 000 steps; H34 has 9 ragdolls, not 32. In H73 the tower beside the faulty bodies is
held to standing still; that it is bit-identical is a test (`odd_contact_test.cpp`). The planks of H14 stand in an
order of our own.
"""


def page(scenes):
    rows = [f"| {scene.id} | {scene.title}: {scene.shows} | {'; '.join(scene.rules_in_words())}; "
            f"{scene.seconds:g} s | {scene.known} |" for scene in scenes]
    nightly = ", ".join(scene.id for scene in scenes if scene.tier == "nightly")
    reds = "\n".join(f"| {scene.id} | {scene.known_red} |" for scene in scenes if scene.known_red)
    return INTRODUCTION + "\n".join(rows) + "\n" + LEFT_OUT.format(nightly=nightly, reds=reds)
