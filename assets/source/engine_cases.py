#!/usr/bin/env python3
"""assets/data/engine_cases.csv from `plumbline stability --solver small_step --engines all --out DIR`: engine_cases.py DIR/stability.json."""
import csv
import json
import sys

from hard_engines import NAMES

KEPT = "assets/data/engine_cases.csv"  # runs that the table lacks stay as they are there
table = json.load(open(sys.argv[1], encoding="utf-8"))
ran = {(run["case"], run["solver"]) for run in table["runs"]}
kept = [line for line in csv.reader(open(KEPT, encoding="utf-8")) if (line[0], line[1]) not in ran and line[0] != "case"]
out = csv.writer(open(KEPT, "w", encoding="utf-8", newline=""), lineterminator="\n")
out.writerow(["case", "engine", "verdict", "measure", "value", "why"])
lines = kept
for run in table["runs"]:
    result = run["result"]
    failed = sorted((rule for rule in result["rules"] if not rule["passed"]),
                    key=lambda rule: rule["margin"] if rule["margin"] is not None else float("-inf"))
    verdict = "lacks" if run.get("lacks") else "pass" if result["passed"] else "slow" if result["gave_up"] else "fail"
    measure, value = "", ""
    if failed:
        measure = failed[0]["text"].split()[0]
        value = "gone" if failed[0]["value"] is None else f"{failed[0]['value']:.3g}"
    lines.append([run["case"], run["solver"], verdict, measure, value, result["why"]])
ENGINES = list(NAMES)
out.writerows(sorted(lines, key=lambda line: (line[0], ENGINES.index(line[1]))))
