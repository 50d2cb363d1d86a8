"""The section of docs/GALLERY.md on other engines, from assets/data/engine_cases.csv."""

import csv

HEAD = """## Other engines

`plumbline stability --engines all` runs the gallery with the engines of [ENGINES.md](ENGINES.md) too, each with its own defaults
at 60 Hz, held to the same rules by the same code. A dot: the case holds what the engine lacks or is not handed (rolling
friction, effects, bodies that are led, rules that watch forces). Else the worst broken rule and its value; "gone": a body fell out of the world. The rules are
ours: 2 % of an edge, for example, is less than the 2 cm that Jolt lets a contact penetrate by design.

| engine | passes | small_step on the same cases |
|---|---|---|
{sums}

| case | {names} |
|---|{dashes}|
{rows}
"""

NAMES = {"small_step": "small_step", "jolt": "Jolt", "rapier": "Rapier", "physx": "PhysX", "havok": "Havok", "bullet": "Bullet", "ode": "ODE"}


def cell(run):
    if run["verdict"] == "lacks":
        return "·"
    if run["verdict"] in ("pass", "slow"):
        return run["verdict"]
    return f"{run['measure']} {run['value']}" if run["measure"] else run["why"]


def passes(runs):
    return sum(run["verdict"] == "pass" for run in runs)


def section():
    runs = list(csv.DictReader(open("assets/data/engine_cases.csv", encoding="utf-8")))
    by_case = {}
    for run in runs:
        by_case.setdefault(run["case"], {})[run["engine"]] = run
    sums = []
    for engine, name in NAMES.items():
        ran = [run for run in runs if run["engine"] == engine and run["verdict"] != "lacks"]
        ours = [by_case[run["case"]]["small_step"] for run in ran]
        sums.append(f"| {name} | {passes(ran)} of {len(ran)} | {passes(ours)} of {len(ours)} |")
    shared = {case: of for case, of in by_case.items() if any(of[engine]["verdict"] != "lacks" for engine in list(NAMES)[1:])}
    rows = [f"| {case} | " + " | ".join(cell(of[engine]) for engine in NAMES) + " |" for case, of in shared.items()]
    return HEAD.format(sums="\n".join(sums), names=" | ".join(NAMES.values()), dashes="---|" * (len(NAMES) - 1) + "---",
                       rows="\n".join(rows))
