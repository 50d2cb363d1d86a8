#!/usr/bin/env python3
"""Exit codes and messages of the command line, as scripts rely on them."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

program, program_f64 = sys.argv[1:3]
# Who runs this as a script's background job ignores SIGINT, and so would the program.
signal.signal(signal.SIGINT, signal.default_int_handler)
folder = pathlib.Path(tempfile.mkdtemp())
environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
environment.update(HOME=str(folder), XDG_CONFIG_HOME=str(folder / "config"), XDG_DATA_HOME=str(folder / "data"))
CUBE = "assets/scenes/falling_cube.toml"


def run(*words, of=program, code=0, says="", **changes):
    done = subprocess.run([of, *map(str, words)], env={**environment, **changes}, capture_output=True, text=True, errors="replace", timeout=120)
    output = done.stdout + done.stderr
    assert done.returncode == code, f"{words}: exit {done.returncode}, expected {code}\n{output}"
    assert says in output, f"{words}: expected to read {says!r} in\n{output}"
    assert "terminate called" not in output and "Traceback" not in output, output
    return done


def falls_as_galileo_says():
    for of in (program, program_f64):
        for hz in (30, 60, 240):
            state = folder / "s.json"
            run("simulate", CUBE, "--seconds", 1, "--hz", hz, "--state", state, of=of)
            cube = next(body for body in json.loads(state.read_text())["bodies"] if body["name"] == "cube")
            start = folder / "start.json"
            run("simulate", CUBE, "--seconds", 0, "--hz", hz, "--state", start, of=of)
            first = next(body for body in json.loads(start.read_text())["bodies"] if body["name"] == "cube")
            height = first["position_m"][1] - 0.5 * 9.81
            assert abs(cube["position_m"][1] - height) < 1e-5, (of, hz, cube["position_m"][1], height)


def one_hash_at_any_frame_rate():
    hashes = set()
    for words in ([], [], ["--drive-fps", 15], ["--drive-fps", 60], ["--drive-fps", 144], ["--drive-fps", 1000]):
        state = folder / "s.json"
        run("simulate", "assets/scenes/playroom.toml", "--seconds", 2, "--state", state, *words)
        hashes.add(json.loads(state.read_text())["hash"])
    assert len(hashes) == 1, hashes
    run("simulate", "assets/scenes/playroom.toml", "--seconds", 2, "--expect-hash", hashes.pop())
    run("simulate", "assets/scenes/playroom.toml", "--seconds", 2, "--expect-hash", "0" * 16, code=5)


def one_hash_on_any_number_of_threads():
    hashes = set()
    for words in ([], ["--threads", 1], ["--threads", 2], ["--threads", 5], ["--threads", "auto"]):
        state = folder / "s.json"
        run("simulate", "bench/peers/rubble", "--seconds", 0.5, "--state", state, *words)
        hashes.add(json.loads(state.read_text())["hash"])
    assert len(hashes) == 1, hashes
    for number in ("0", "65", "-1", "two", "1.5", ""):
        run("simulate", CUBE, "--threads", number, code=2, says="expected auto or a whole number from 1 to 64")


def usage():
    run("--version", says="plumbline 0.")
    run("--help", says="simulate")
    run("--help", says="6 out of memory", of=program_f64)
    run("simulate", CUBE, "--secnds", 1, code=2, says='the nearest is "--seconds"')
    run("simulate", CUBE, "--seconds", "many", code=2)
    run("simulate", CUBE, "--solver", "bullet_sj", code=2, says="bullet_si")
    run("render", CUBE, "--shading", "toon", code=2, says="expected pbr, blinn_phong or unlit")
    run("render", CUBE, "--camera", "1,2", code=2, says="expected x,y,z,yaw,pitch")
    run("render", CUBE, "--camera", "1,2,3,0,0", "--camera-path", "p", code=2, says="excludes")
    # EXPERIENCE D20
    for words in (["--replay", "a", "--record", "b"], ["--replay", "a", "--random-input", "3"], ["--safe", "--config", folder],
                  ["--quiet", "--verbose"]):
        options = [word for word in words if str(word).startswith("--")]
        said = run("play", CUBE, *words, code=2).stderr  # both are named
        assert all(option in said for option in options), said
    run("simulat", CUBE, code=2, says='unexpected word "assets/scenes/falling_cube.toml"; the commands are play, viewer, scenes, render')
    for words in (["simulate", "--seconds"], ["simulate", "--drive-fps"], ["simulate", "--every"], ["render", "--at"],
                  ["render", "--frames"], ["play", "--seconds"], ["study", "--seconds"], ["study", "--tolerance"],
                  ["study", "--budget-ms"]):
        for number in ("nan", "-nan", "inf", "-1", "1e400", "1,5", ""):
            done = run(words[0], CUBE, f"{words[1]}={number}", code=2, says=words[1])
            assert len(done.stderr) < 300, done.stderr
    run("render", CUBE, "--frames", 0, code=2, says="--frames: 0: expected a number from 1 to 1000000000")


# EXPERIENCE D19
def hostile_words():
    for command in ([], ["simulate"], ["render"]):
        run(*command, *["x"] * 10_000, code=2)
        done = run(*command, "--" + "y" * 100_000, code=2)
        assert len(done.stderr) < 500, len(done.stderr)
    done = subprocess.run([program, b"--\xff\xfe\x1b]0;title\x07"], env=environment, capture_output=True, timeout=60)
    assert done.returncode == 2 and b"\\xff\\xfe\\x1b]0;title\\x07" in done.stderr and b"\x1b" not in done.stderr, done
    done = subprocess.run([program, "check", b"no\x1b[2Jsuch\xff.toml"], env=environment, capture_output=True, timeout=60)
    assert done.returncode == 4 and b"no\\x1b[2Jsuch\\xff.toml" in done.stdout + done.stderr, done


# EXPERIENCE D21
def decimal_commas():
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"], capture_output=True, text=True)
    assert (folder / "de_DE.UTF-8" / "LC_NUMERIC").exists(), made.stderr
    said = {}
    for locale in ("C", "de_DE.UTF-8"):
        state = folder / "s.json"
        words = ("simulate", CUBE, "--seconds", "0.5", "--state", state)
        lines = run(*words, LOCPATH=str(folder), LC_ALL=locale, LANG=locale).stdout.splitlines()
        said[locale] = [json.loads(state.read_text())["hash"], lines[0], lines[2]]
        run("render", CUBE, "--at", "0.5", "--camera", "0,1.5,4,0,-10.5", "--size", "64x64", "--out", "-", LOCPATH=str(folder),
            LC_ALL=locale)
    assert said["C"] == said["de_DE.UTF-8"] and "0.500 s" in said["C"][1], said


def display():
    run("play", CUBE, "--no-sound", code=3, says="DISPLAY")


def scenes():
    run("simulate", "no_such_scene", code=4, says="no_such_scene")
    run("play", "gardn", code=4, says='there is no scene "gardn" here')
    run("render", "gardn", code=4, says='; the nearest is "garden"; plumbline scenes lists them')
    run("simulate", "scenes/gardn.toml", code=4, says='the nearest is "garden"')
    run("explain", "assets", code=4, says="it is a folder")
    circle = folder / "circle.toml"
    circle.symlink_to(circle)
    run("simulate", circle, code=4, says="Too many levels of symbolic links")
    listed = json.loads(run("scenes", "--json").stdout)
    names = [scene["name"] for scene in listed]
    assert names[0] == "garden" and {"falling_cube", "nature", "cans", "hard/H05"} <= set(names), names
    assert "materials" not in names and "things" not in names, names
    assert all(scene["title"] and scene["description"] and pathlib.Path(scene["file"]).is_file() for scene in listed), listed
    lines = run("scenes").stdout.splitlines()
    assert len(lines) == len(listed) and ["falling_cube", "Falling", "cube:", "One", "cube,", "8", "m", "above", "the", "ground"] in map(str.split, lines)
    run("simulate", names[-1], "--seconds", 0)
    # A person's own have names too, and one of a shipped name stands for that.
    own = folder / "data/plumbline/scenes"
    own.mkdir(parents=True)
    for name in ("cube-adopted", "pile"):
        (own / f"{name}.toml").write_text('[scene]\ntitle = "mine"\n[[entity]]\nname = "a"\n')
    listed = {scene["name"]: scene["file"] for scene in json.loads(run("scenes", "--json").stdout)}
    assert listed["cube-adopted"] == str(own / "cube-adopted.toml") and listed["pile"] == str(own / "pile.toml"), listed
    run("simulate", "cube-adopted", "--seconds", 0, says="0 moving bodies")
    run("simulate", "cube-adoptd", code=4, says='the nearest is "cube-adopted"')
    shutil.rmtree(own)
    bad = folder / "bad.toml"
    bad.write_text('[scene]\ntitle = "bad"\n[[entity]]\nname = "a"\npositon_m = [0, 1, 0]\n')
    run("simulate", bad, code=4, says="position_m")
    run("check", bad, code=4, says="bad.toml:5")
    bad.write_text('[[entity]]\nname = "a"\nmodel = "../../../etc/passwd"\n')
    run("check", bad, code=4, says="leads out of its folder")
    run("check", *sorted(pathlib.Path("assets/scenes").rglob("*.toml")), says="good")
    run("check", "config/bindings.toml", "config/app.toml", "config/surfaces.toml", says="good")


def the_door_of_the_docs_can_be_struck():
    docs = pathlib.Path("docs/SCENE-FORMAT.md").read_text()
    door = docs.split("A door that gives way", 1)[1].split("```toml\n", 1)[1].split("```", 1)[0]
    scene, state = folder / "door.toml", folder / "door.json"
    scene.write_text(door + '[[entity]]\nname = "ball"\nposition_m = [0.8, 1.1, 2]\nprimitive = { sphere = 0.2 }\n'
                     '[entity.body]\nmass_kg = 5\nvelocity_mps = [0, 1, -8]\n[[entity]]\nprimitive = { plane = [50, 50] }\n'
                     '[entity.body]\nkind = "static"\n')
    run("simulate", scene, "--seconds", 1, "--state", state)
    [hinge] = json.loads(state.read_text())["joints"]
    assert 0.1 < hinge["position"] < 1.75 and hinge["error_m"] < 1e-3, hinge


def settings():
    run("controls", says="drop")
    run("controls", "--bind", "drop=i", says='"i"')
    mine = folder / "config" / "plumbline"
    mine.mkdir(parents=True)
    (mine / "bindings.toml").write_text('format = 1\n[walk]\njump = ["spcae"]\n')
    run("controls", code=2, says='Nearest: "space"')
    run("controls", "--safe")
    (mine / "bindings.toml").write_text("[walk\n")
    run("controls", code=2, says="bindings.toml:1")


def images():
    png = folder / "p.png"
    report = folder / "r.json"
    run("render", CUBE, "--out", png, "--size", "320x180", "--at", 0.5, "--report", report)
    assert png.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
    read = json.loads(report.read_text())
    assert read["frames"] == 1 and read["draw_calls"] > 0 and read["gl"]["version"], read
    run("render", CUBE, "--out", "/proc/no/such/place.png", "--size", "64x64", code=1)
    named = {line["name"]: line for line in json.loads(run("explain", CUBE, "--json").stdout)}
    for name in ("flashlight", "fog", "skybox", "footsteps", "ambient_sounds", "gyroscopic_torque"):
        line = named[name]
        assert (line["constructions"], line["calls"], line["bytes_gpu"]) == (0, 0, 0), line


def camera_paths():
    """SOURCES B25: the same place by a path as by a camera, then on; a fault is named with its line."""
    path = folder / "flight.path"
    path.write_text("plumbline camera path 1\n0 0 1.5 4 1 0 0 0\n1 0 1.5 9 1 0 0 0\n")
    words = ("render", CUBE, "--size", "64x64")
    run(*words, "--camera-path", path, "--frames", 31, "--out", folder / "flight")
    frames = sorted((folder / "flight").iterdir())
    assert len(frames) == 31, frames
    run(*words, "--camera", "0,1.5,4,0,0", "--out", folder / "first.png")
    assert frames[0].read_bytes() == (folder / "first.png").read_bytes()
    run(*words, "--camera", "0,1.5,6.5,0,0", "--frames", 31, "--out", folder / "middle")
    assert frames[30].read_bytes() == (folder / "middle" / frames[30].name).read_bytes()
    path.write_text("plumbline camera path 1\n0 0 1.5 4 1 0 0 0\n1 0 1.5\n")
    for words in (("render", CUBE), ("play", CUBE)):
        run(*words, "--camera-path", path, code=4, says="flight.path:3: 3 numbers; expected 8 numbers")
    run("render", CUBE, "--camera-path", folder / "none.path", code=1, says="none.path")


def interruption():
    running = subprocess.Popen([program, "simulate", "assets/scenes/pile.toml", "--seconds", "3600", "--state", folder / "half.json"],
                               env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(2)
    running.send_signal(signal.SIGINT)
    assert running.wait(20) == 130
    assert json.loads((folder / "half.json").read_text())["steps"] > 0


for test in (usage, hostile_words, decimal_commas, falls_as_galileo_says, one_hash_at_any_frame_rate, display, scenes, the_door_of_the_docs_can_be_struck, settings, images, camera_paths, interruption):
    print(test.__name__, flush=True)
    test()
