#!/usr/bin/env python3
"""`plumbline study SCENE` and preset = "auto", from outside: what they say, keep and refuse."""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

program, program_f64 = sys.argv[1:3]
# Who runs this as a script's background job ignores SIGINT, and so would the program.
signal.signal(signal.SIGINT, signal.default_int_handler)
folder = pathlib.Path(tempfile.mkdtemp())
cache = folder / "cache"
environment = {**os.environ, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / "config"),
               "XDG_DATA_HOME": str(folder / "data"), "XDG_CACHE_HOME": str(cache)}
environment.pop("DISPLAY", None)

# Two spheres that fall, hit a floor and bounce: a few bodies, so that a study takes seconds.
BOUNCE = """
[world]
gravity_mps2 = [0, -9.81, 0]
{accuracy}
[[entity]]
name = "floor"
[entity.body]
kind = "static"
shape = {{ box = [20, 1, 20] }}
[[entity]]
name = "a"
position_m = [0, 1.5, 0]
[entity.body]
kind = "dynamic"
shape = {{ sphere = 0.2 }}
mass_kg = 1
restitution = 0.5
[[entity]]
name = "b"
position_m = [2, 1.1, 0]
[entity.body]
kind = "dynamic"
shape = {{ box = [0.4, 0.4, 0.4] }}
mass_kg = 1
"""


def scene(name, accuracy=""):
    path = folder / f"{name}.toml"
    path.write_text(BOUNCE.format(accuracy=accuracy))
    return path


def run(*words, of=program, code=0, says="", **changes):
    done = subprocess.run([of, *map(str, words)], env={**environment, **changes}, capture_output=True, text=True,
                          timeout=200)
    output = done.stdout + done.stderr
    assert done.returncode == code, f"{words}: exit {done.returncode}, expected {code}\n{output}"
    assert says in output, f"{words}: expected to read {says!r} in\n{output}"
    assert "terminate called" not in output and "Traceback" not in output, output
    return done


def studied():
    return list((cache / "plumbline" / "study").glob("*.json"))


def a_study_says_what_accuracy_costs():
    path = scene("bounce")
    said = run("study", path, "--seconds", 1).stdout
    for words in ("Cost to reach", "Error at a budget", "Settings that no other beats", "Paste under [accuracy]", "small_step", "bullet_si",
                  "T4 self-converged", "reference"):
        assert words in said, (words, said)
    assert len(studied()) == 1
    kept = json.loads(studied()[0].read_text())
    for point in kept["subject"]["points"]:
        cost = point["cost"]
        if cost["repeats"]:
            assert cost["bodies"] == 2 and cost["peak_bytes"] > 1 << 20, cost
            assert all(cost[key] > 0 for key in ("step_ms_p99", "step_ms_max", "frame_ms_p99", "frame_ms_max")), cost
    assert kept["grid"] == "full" and abs(kept["seconds"] - 1) < 1e-6
    # The lines alone come from what is kept, at once.
    start = time.time()
    lines = run("study", path, "--tolerance", 0.02, says="from the cached study").stdout
    assert time.time() - start < 5
    assert re.search(r"^solver = \"\w+\"$", lines, re.M) and re.search(r"^step_hz = \d+$", lines, re.M), lines
    run("study", path, "--tolerance", 1e-9, says="no setting stays under")
    run("study", path, "--budget-ms", 1e-6, says="no setting stays under")
    # What is recommended is taken by a scene.
    pasted = scene("pasted", "[accuracy]\n" + lines)
    run("check", pasted, says="good")


def auto_uses_what_is_kept_or_looks_for_itself():
    path = scene("auto", '[accuracy]\npreset = "auto"\ntolerance = 0.02')
    before = len(studied())
    said = run("simulate", path, "--seconds", 0.1, says='preset "auto" looks for').stderr
    assert 'preset "auto" for 2 %' in said, said
    assert len(studied()) == before + 1
    again = run("simulate", path, "--seconds", 0.1).stderr
    assert "looks for" not in again and 'preset "auto" for 2 %' in again, again
    # What is broken is not used, said once, and made anew.
    for file in studied():
        file.write_text(file.read_text()[:100])
    run("simulate", path, "--seconds", 0.1, says="is thrown away")
    assert "looks for" not in run("simulate", path, "--seconds", 0.1).stderr
    run("simulate", scene("hard", '[accuracy]\npreset = "auto"\ntolerance = 0.000000001'), "--seconds", 0.1,
        says="the best it saw is")
    run("simulate", path, "--seconds", 0.1, of=program_f64, says='falls back to "balanced"')


def what_cannot_be_studied_is_refused():
    still = folder / "still.toml"
    still.write_text('[[entity]]\nname = "floor"\n[entity.body]\nkind = "static"\nshape = { box = [2, 1, 2] }\n')
    run("study", still, code=4, says="nothing in it moves")
    still.write_text('[accuracy]\npreset = "auto"\n' + still.read_text())
    run("simulate", still, "--seconds", 0.1, says='falls back to "balanced"')
    run("study", folder / "none.toml", code=4, says="none.toml")
    run("study", scene("bad", "[accuracy]\ntolerance = 0.1\nbudget_ms = 1"), code=4, says="budget_ms")


def an_interrupt_keeps_what_is_done():
    study = subprocess.Popen([program, "study", "garden", "--seconds", "20"], env=environment,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(4)
    study.send_signal(signal.SIGINT)
    out, err = study.communicate(timeout=20)
    assert study.returncode == 130, (study.returncode, out, err)
    assert "Interrupted" in out, (out, err)


def effects_have_their_price():
    out = folder / "effects_out"
    shaded = scene("effects")
    shaded.write_text(shaded.read_text() + "\n[sun]\ndirection = [-0.3, -1, -0.2]\nshadow = { size_px = 256, distance_m = 10 }\n")
    said = run("study", "--effects", shaded, "--seconds", 0.5, "--out", out).stdout
    assert "what switching an effect off saves" in said and str(out / "report.html") in said, said
    effects = json.loads((out / "findings.json").read_text())["effects"][0]
    assert effects["scene"] == "effects.toml" and effects["rows"], effects
    for row in effects["rows"]:
        assert row["domain"] in ("step", "image", "sound") and row["step_ms"]["pairs"] + row["frame_ms"]["pairs"] > 0, row
        assert (row["name"] in said), said


def effects_that_are_cut_short_leave_a_page():
    out = folder / "cut"
    study = subprocess.Popen([program, "study", "--effects", "garden", "--seconds", "1", "--out", str(out)], env=environment,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(4)
    study.send_signal(signal.SIGINT)
    said = study.communicate(timeout=60)
    assert study.returncode == 130, (study.returncode, said)
    findings = json.loads((out / "findings.json").read_text())
    assert not findings["complete"] and len(findings["effects"]) == 1, findings
    assert '"complete": false' in (out / "report.html").read_text()


def a_image_has_its_price():
    out = folder / "image"
    said = run("study", "--picture", "falling_cube", "--seconds", 0.2, "--out", out).stdout
    rows = {row["name"]: row for row in json.loads((out / "findings.json").read_text())["images"][0]["rows"]}
    assert rows["4 samples a pixel"]["rms_error"] < rows["level high"]["rms_error"], rows
    assert rows["level low"]["rms_error"] > rows["level high"]["rms_error"], rows
    assert all(row["cpu_ms"] > 0 for row in rows.values()), rows
    assert "level low" in said and str(out / "report.html") in said, said
    assert '"scene": "falling_cube.toml"' in (out / "report.html").read_text()
    assert (out / "falling_cube_reference.png").read_bytes().startswith(b"\x89PNG")
    run("study", "--picture", code=2, says="--picture needs a scene")
    run("study", "--picture", "A20", code=4, says="A20")


a_study_says_what_accuracy_costs()
auto_uses_what_is_kept_or_looks_for_itself()
what_cannot_be_studied_is_refused()
an_interrupt_keeps_what_is_done()
effects_have_their_price()
effects_that_are_cut_short_leave_a_page()
a_image_has_its_price()
