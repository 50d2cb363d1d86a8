#!/usr/bin/python3
"""Brings ACCURACY.md up to date with a study: docs/accuracy_of_study.py DIR

DIR is what `plumbline study --out DIR` wrote. The tables between <!-- NAME --> and <!-- end --> are made
anew from DIR/findings.json and assets/data/peers.csv; the images are diagrams of DIR/report.html, each an SVG of its
own on light paper, for which Node.js runs the page's scripts. The words between the tables are a person's: read them
again.
"""

import csv
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

SVG = "http://www.w3.org/2000/svg"
DOCS = pathlib.Path(__file__).resolve().parent
DATA = DOCS.parent / "assets/data"
DRAW = DOCS.parent / "tests/engine/study/report/draw_page.js"

# File: subject of the study, and which of its two diagrams.
IMAGES = {
    "accuracy_bounce.svg": ("A20 H=1 e=0.8", "cost"),
    "accuracy_pendulum.svg": ("A09 90 degrees", "cost"),
    "accuracy_pendulum_step.svg": ("A09 90 degrees", "step"),
    "accuracy_swung_chain.svg": ("P chainh", "cost"),
    "accuracy_heavy.svg": ("P heavy100", "cost"),
}

# What people set: name, solver, step rate, sub-steps (0: on demand), iterations.
SETTINGS = [
    ("small_step 60 Hz x 1 (least of draft)", "small_step", 60, 1, 1),
    ("small_step 60 Hz x 2-16 (balanced)", "small_step", 60, 0, 1),
    ("small_step 60 Hz x 4", "small_step", 60, 4, 1),
    ("small_step 120 Hz x 4 (least of precise)", "small_step", 120, 4, 1),
    ("small_step 240 Hz x 4 (half of reference)", "small_step", 240, 4, 1),
    ("bullet_si 60 Hz, 10 it (balanced)", "bullet_si", 60, 1, 10),
    ("bullet_si 60 Hz, 80 it", "bullet_si", 60, 1, 80),
    ("bullet_si 240 Hz, 10 it", "bullet_si", 240, 1, 10),
    ("bullet_dantzig 60 Hz", "bullet_dantzig", 60, 1, 10),
]


def error(point):
    """Of the first metric; infinite where it failed."""
    if point["status"] != "done" or not point["errors"] or not isinstance(point["errors"][0], (int, float)):
        return math.inf
    return abs(point["errors"][0])


def cost(point):
    return point["cost"]["ms_per_s_min"]


def cheapest(points, tolerance):
    good = [point for point in points if error(point) <= tolerance and point["cost"]["repeats"] > 0]
    return min(good, key=cost, default=None)


def of_solver(subject, word):
    return [point for point in subject["points"]
            if point["setting"]["solver"].startswith(word) and point["setting"]["precision"] == "float32"]


def setting_text(setting):
    steps = f"x {setting['substeps']}" if setting["substeps"] else f"x 2-{setting['substeps_max']}"
    effort = f" {steps}" if setting["solver"] == "small_step" else f", {setting['iterations']} it"
    return f"{setting['step_hz']} Hz{effort}"


def error_text(value):
    if math.isinf(value):
        return "none"
    if value == 0:
        return "0"
    return f"{value * 100:.2g} %" if value >= 1e-5 else f"{value:.0e}"


def price_text(point):
    if point is None:
        return "never"
    solver = point["setting"]["solver"]
    who = "" if solver == "small_step" else solver.removeprefix("bullet_") + " "
    return f"{cost(point):.3g} ({who}{setting_text(point['setting'])})"


def made_with(findings):
    runs = sum(len(subject["points"]) for subject in findings["subjects"])
    return (f"{findings['machine']}; {findings['build']}; {findings['made_on']}. "
            f"{len(findings['subjects'])} subjects, {runs} runs; the median of the repeats of a run lay "
            f"{findings['clock_spread'] * 100:.1f} % above the least (median over all runs).\n")


def settings_table(findings):
    yield "| setting | subjects | failed | within 5 % | 1 % | 0.1 % | median error | cost |"
    yield "|---|--:|--:|--:|--:|--:|--:|--:|"
    chosen = {name: {} for name, *_ in SETTINGS}
    for subject in findings["subjects"]:
        for point in subject["points"]:
            knobs = point["setting"]
            key = [knobs["solver"], knobs["step_hz"], knobs["substeps"], knobs["iterations"]]
            for name, *wanted in SETTINGS:
                if key == wanted and knobs["precision"] == "float32":
                    chosen[name][subject["id"]] = point
    # Only subjects in which every setting was run: who was run on the easy ones alone would look better.
    common = set.intersection(*(set(points) for points in chosen.values()))
    base = chosen[SETTINGS[1][0]]
    for name, points in chosen.items():
        points = {subject: point for subject, point in points.items() if subject in common}
        errors = [error(point) for point in points.values()]
        ratios = [cost(point) / cost(base[subject]) for subject, point in points.items()
                  if point["cost"]["repeats"] and base[subject]["cost"]["repeats"]]
        counts = " | ".join(str(sum(value <= limit for value in errors)) for limit in (0.05, 0.01, 0.001))
        yield (f"| {name} | {len(errors)} | {sum(map(math.isinf, errors))} | {counts} | "
               f"{error_text(statistics.median(errors))} | {statistics.median(ratios):.2f} |")


def subjects_table(findings):
    yield "| subject | | tier | small_step: 1 % costs, ms/s | the best bullet_*: 1 % costs, ms/s | least error: ours | Bullet's |"
    yield "|---|---|---|---|---|--:|--:|"
    for subject in findings["subjects"]:
        ours, bullet = of_solver(subject, "small_step"), of_solver(subject, "bullet_")
        best = [min(map(error, points), default=math.inf) for points in (ours, bullet)]
        yield (f"| {subject['id']} | {subject['title']} | {subject['tier'][:2]} | {price_text(cheapest(ours, 0.01))} | "
               f"{price_text(cheapest(bullet, 0.01))} | {error_text(best[0])} | {error_text(best[1])} |")


def verdicts_table(findings):
    trends = ["exact", "converges", "stalls", "diverges", "too few"]
    yield "| solver | knob | " + " | ".join(trends) + " |"
    yield "|---|---|" + "--:|" * len(trends)
    verdicts = [verdict for subject in findings["subjects"] for verdict in subject["verdicts"]]
    for solver, knob in sorted({(verdict["solver"], verdict["knob"]) for verdict in verdicts}, reverse=True):
        counts = [sum(verdict["trend"] == trend for verdict in verdicts
                      if (verdict["solver"], verdict["knob"]) == (solver, knob)) for trend in trends]
        yield f"| {solver} | {knob} | " + " | ".join(map(str, counts)) + " |"


def table_of(name):
    lines = (DATA / name).read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def peers_of(subject):
    """(engine and its steps a second, CPU ms per simulated second, error) of the other engines on a subject's scene."""
    figures = [row for row in table_of("peers.csv") if row["scene"] == subject["peer_scene"]]
    fallen = {(row["engine"], row["substeps"]) for row in figures if row["metric"] == "stands" and float(row["value"]) == 0}
    for same in table_of("peer_metrics.csv"):
        if (same["scene"], same["metric"]) != (subject["peer_scene"], subject["metrics"][0]["name"]):
            continue
        for row in figures:
            if row["metric"] == same["figure"]:
                fell = (row["engine"], row["substeps"]) in fallen
                yield (f"{row['engine']} {60 * int(row['substeps'])} Hz", 60 * float(row["cpu_ms_per_frame"]),
                       max(abs(float(row["value"])) * float(same["factor"]), 1.0 if fell else 0.0))


def peers_table(findings):
    yield "| subject | 1 % costs, ms/s: small_step | the cheapest other engine | least error: small_step | the best other engine |"
    yield "|---|---|---|--:|---|"
    for subject in findings["subjects"]:
        peers = list(peers_of(subject))
        if not peers:
            continue
        ours = of_solver(subject, "small_step")
        near = min((peer for peer in peers if peer[2] <= 0.01), key=lambda peer: peer[1], default=None)
        best = min(peers, key=lambda peer: peer[2])
        yield (f"| {subject['id']}: {subject['title']} | {price_text(cheapest(ours, 0.01))} | "
               f"{f'{near[1]:.3g} ({near[0]})' if near else 'none'} | {error_text(min(map(error, ours)))} | "
               f"{error_text(best[2])} ({best[0]}) |")


def update_tables(findings):
    path = DOCS / "ACCURACY.md"
    text = path.read_text(encoding="utf-8")
    tables = {"made with": [made_with(findings)], "settings": settings_table(findings),
              "verdicts": verdicts_table(findings), "peers": peers_table(findings),
              "subjects": subjects_table(findings)}
    for name, rows in tables.items():
        pattern = re.compile(f"(<!-- {name} -->\n).*?(<!-- end -->)", re.DOTALL)
        if not pattern.search(text):
            sys.exit(f"ACCURACY.md has no place for the table \"{name}\"")
        table = "\n" + "\n".join(rows).rstrip() + "\n\n"
        text = pattern.sub(lambda found: found.group(1) + table + found.group(2), text)
    path.write_text(text, encoding="utf-8")


def standalone(image):
    width, height = image.get("viewBox").split()[2:]
    image.set("width", width)
    image.set("height", height)
    image.set("color", "#1b1d21")
    image.insert(0, ElementTree.Element(f"{{{SVG}}}rect", {"width": width, "height": height, "fill": "#fbfbf9"}))
    return ElementTree.tostring(image, encoding="unicode")


def update_images(findings, page):
    ElementTree.register_namespace("", SVG)
    drawn = subprocess.run(["node", DRAW, page], capture_output=True, text=True, check=True).stdout
    sections = {section.get("id"): section for section in ElementTree.fromstring(drawn).iter("section")}
    numbers = {subject["id"]: i + 1 for i, subject in enumerate(findings["subjects"])}
    for name, (subject, kind) in IMAGES.items():
        if subject not in numbers:
            sys.exit(f"the study has no {subject}")
        figure = sections[f"s{numbers[subject]}"].find(f"figure[@class='{kind}']")
        if figure is None:
            sys.exit(f"the page has no diagram of error against {kind} for {subject}")
        (DOCS / "images" / name).write_text(standalone(figure.find(f"{{{SVG}}}svg")) + "\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.splitlines()[0])
    folder = pathlib.Path(sys.argv[1])
    study = json.loads((folder / "findings.json").read_text(encoding="utf-8"))
    update_tables(study)
    update_images(study, folder / "report.html")
