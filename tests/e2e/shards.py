#!/usr/bin/env python3
"""Four shards of a study and of the stability table, made by GNU parallel on this machine, and their merged tables
against those of one run. Skipped where there is no GNU parallel."""
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

program = sys.argv[1]
if shutil.which("parallel") is None:
    print("GNU parallel is not installed (cmake/packages.txt names it)")
    sys.exit(77)
folder = pathlib.Path(tempfile.mkdtemp())
environment = {**os.environ, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / "config")}
environment.pop("DISPLAY", None)
CLOCKS = {"ms_per_s_min", "ms_per_s_median", "ms_per_s_max", "clock_ms_per_s", "repeats", "step_ms_median", "step_ms_p99",
          "cpu_ms_per_s", "step_ms_max", "frame_ms_p99", "frame_ms_max", "peak_bytes"}


def run(*words, code=0, says=""):
    done = subprocess.run([str(word) for word in words], env=environment, capture_output=True, text=True, timeout=300)
    output = done.stdout + done.stderr
    assert done.returncode == code, f"{words}: exit {done.returncode}, expected {code}\n{output}"
    assert says in output, f"{words}: expected to read {says!r} in\n{output}"


def in_four(name, *words):
    """`words` once, and in four shards that are merged: both folders."""
    once, parts, merged = folder / f"{name}_once", folder / f"{name}_parts", folder / f"{name}_merged"
    run(program, *words, "--out", once)
    run("parallel", "--will-cite", "--jobs", "2", program, *words, "--jobs", "1", "--shard", "{}/4",
        "--out", f"{parts}/{{}}", ":::", "1", "2", "3", "4")
    run(program, words[0], "--merge", *(parts / str(i) for i in (3, 1, 4, 2)), "--out", merged)
    run(program, words[0], "--merge", parts / "1", parts / "2", parts / "4", "--out", folder / "none", code=4,
        says="shard 3 is missing")
    return once, merged


def without_clocks(thing):
    if isinstance(thing, dict):
        return {key: without_clocks(value) for key, value in thing.items() if key not in CLOCKS}
    return [without_clocks(each) for each in thing] if isinstance(thing, list) else thing


once, merged = in_four("study", "study", "A01", "A22", "--quick")
tables = [[without_clocks(row) for row in csv.DictReader((each / "findings.csv").open())] for each in (once, merged)]
assert len(tables[0]) > 40 and tables[0] == tables[1]
found = [without_clocks(json.loads((each / "findings.json").read_text())["subjects"]) for each in (once, merged)]
assert found[0] == found[1]
assert "<html" in (merged / "report.html").read_text()

once, merged = in_four("stability", "stability", "H25", "H39", "H70", "H85", "--no-pictures")
found = [without_clocks(json.loads((each / "stability.json").read_text())["runs"]) for each in (once, merged)]
assert len(found[0]) == 20 and found[0] == found[1]

run(program, "stability", "H25", "--shard", "5/4", "--out", folder / "none", code=2, says="expected I/N")
run(program, "study", "A01", "--shard", "1/4", code=2, says="--out")
