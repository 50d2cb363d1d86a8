#!/usr/bin/env python3
"""`plumbline study` of scenarios, from outside: its files, what it refuses, and Ctrl-C."""
import csv
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

# Who runs this as a script's background job ignores SIGINT, and so would the program.
signal.signal(signal.SIGINT, signal.default_int_handler)
program = sys.argv[1]
folder = pathlib.Path(tempfile.mkdtemp())
environment = {**os.environ, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / "config")}
environment.pop("DISPLAY", None)


def run(*words, code=0, says=""):
    done = subprocess.run([program, "study", *map(str, words)], env=environment, capture_output=True, text=True,
                          timeout=300)
    output = done.stdout + done.stderr
    assert done.returncode == code, f"{words}: exit {done.returncode}, expected {code}\n{output}"
    assert says in output, f"{words}: expected to read {says!r} in\n{output}"
    return done


def workers_of(pid):
    """Worker processes whose parent is `pid`."""
    children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    return [int(child) for child in children]


def alive(pid):
    try:
        return "Z" not in pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except FileNotFoundError:
        return False


# Files: the same points in JSON and CSV, errors for every metric, twice the same work.
def findings(out):
    run("A01", "A22 10:1", "--quick", "--out", out, says="converges")
    with open(out / "findings.json") as file:
        return json.load(file)


first, second = findings(folder / "one"), findings(folder / "two")
assert first["complete"] and [subject["id"] for subject in first["subjects"]][:2] == ["A01", "A01 along a wall"]
lines = 0
for subject, again in zip(first["subjects"], second["subjects"]):
    assert subject["points"], subject["id"]
    for point, twin in zip(subject["points"], again["points"]):
        assert point["status"] == "done" and len(point["errors"]) == len(subject["metrics"])
        assert point["cost"]["repeats"] >= 1 and point["cost"]["ms_per_s_min"] > 0
        assert point["errors"] == twin["errors"], f"{subject['id']} {point['setting']}"
        assert point["cost"]["work_per_s"] == twin["cost"]["work_per_s"]
        lines += len(point["errors"])
with open(folder / "one" / "findings.csv") as file:
    assert len(list(csv.DictReader(file))) == lines
assert "<html" in (folder / "one" / "report.html").read_text()

# Threads: each number does the same, in its own time.
run("bench/boxes_100", "--threads", "1,2,auto", "--seconds", 0.3, "--out", folder / "threads", says="speed-up")
with open(folder / "threads" / "findings.json") as file:
    (subject,) = json.load(file)["subjects"]
assert [point["threads"] for point in subject["threads"]][:2] == [1, 2]
for point in subject["threads"]:
    assert point["status"] == "done" and point["same"], point
    assert point["cost"]["ms_per_s_min"] > 0 and point["cost"]["clock_ms_per_s"] > 0
run("A01", "--threads", 2, code=2, says="--threads needs a scene")
run("bench/boxes_100", "--threads", "0,2", code=2, says="expected auto or a whole number from 1 to 64")

run("--list", says="A20 H=1 e=0.5")
run("A2O", code=2, says="the nearest is")
run("no_such_scene.toml", code=4, says="no_such_scene.toml")
(folder / "a_file").write_text("")
run("A01", "--quick", "--out", folder / "a_file" / "below", code=1, says="a_file")

# Ctrl-C: what is done is kept, nobody is left over.
out = folder / "interrupted"
study = subprocess.Popen([program, "study", "A28", "A30", "--quiet", "--out", str(out)], env=environment,
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
time.sleep(3)
workers = workers_of(study.pid)
assert workers, "no workers at work"
study.send_signal(signal.SIGINT)
printed = study.communicate(timeout=20)
assert study.returncode == 130, (study.returncode, printed)
assert not json.loads((out / "findings.json").read_text())["complete"]
assert not any(alive(worker) for worker in workers), "a worker outlived the study"

# Killed outright: the workers go too.
study = subprocess.Popen([program, "study", "A28", "--quiet"], env=environment, stdout=subprocess.DEVNULL,
                         stderr=subprocess.DEVNULL)
time.sleep(2)
workers = workers_of(study.pid)
assert workers, "no workers at work"
study.kill()
study.wait()
time.sleep(0.5)
assert not any(alive(worker) for worker in workers), "a worker outlived the study that was killed"
print("plumbline study: good")
