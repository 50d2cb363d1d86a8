#!/usr/bin/env python3
"""Exit codes and messages of the command line, as scripts rely on them."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

program, program_f64 = sys.argv[1:3]
folder = pathlib.Path(tempfile.mkdtemp())
environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
environment.update(HOME=str(folder), XDG_CONFIG_HOME=str(folder / "config"), XDG_DATA_HOME=str(folder / "data"))
CUBE = "assets/scenes/falling_cube.toml"


def run(*words, of=program, code=0, says="", **changes):
    done = subprocess.run([of, *map(str, words)], env={**environment, **changes}, capture_output=True, text=True, timeout=120)
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


def usage():
    run("--version", says="plumbline 0.")
    run("--help", says="simulate")
    run("simulate", CUBE, "--secnds", 1, code=2, says='the nearest is "--seconds"')
    run("simulate", CUBE, "--seconds", "many", code=2)
    run("simulate", CUBE, "--solver", "bullet_sj", code=2, says="bullet_si")
    run("render", CUBE, "--shading", "toon", code=2, says="expected pbr, blinn_phong or unlit")
    run("render", CUBE, "--camera", "1,2", code=2, says="expected x,y,z,yaw,pitch")
    run("play", CUBE, "--replay", "a", "--record", "b", code=2)


def display():
    run("play", CUBE, "--no-sound", code=3, says="DISPLAY")


def scenes():
    run("simulate", "no_such_scene", code=4, says="no_such_scene")
    bad = folder / "bad.toml"
    bad.write_text('[scene]\ntitle = "bad"\n[[entity]]\nname = "a"\npositon_m = [0, 1, 0]\n')
    run("simulate", bad, code=4, says="position_m")
    run("check", bad, code=4, says="bad.toml:5")
    bad.write_text('[[entity]]\nname = "a"\nmodel = "../../../etc/passwd"\n')
    run("check", bad, code=4, says="leads out of its folder")
    run("check", *sorted(pathlib.Path("assets/scenes").rglob("*.toml")), says="good")
    run("check", "config/bindings.toml", "config/app.toml", "config/surfaces.toml", says="good")


def settings():
    run("controls", says="drop")
    run("controls", "--bind", "drop=k", says='"k"')
    mine = folder / "config" / "plumbline"
    mine.mkdir(parents=True)
    (mine / "bindings.toml").write_text('format = 1\n[walk]\njump = ["spcae"]\n')
    run("controls", code=2, says='Nearest: "space"')
    run("controls", "--safe")
    (mine / "bindings.toml").write_text("[walk\n")
    run("controls", code=2, says="bindings.toml:1")


def pictures():
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


def interruption():
    running = subprocess.Popen([program, "simulate", "assets/scenes/pile.toml", "--seconds", "3600", "--state", folder / "half.json"],
                               env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(2)
    running.send_signal(signal.SIGINT)
    assert running.wait(20) == 130
    assert json.loads((folder / "half.json").read_text())["steps"] > 0


for test in (usage, falls_as_galileo_says, one_hash_at_any_frame_rate, display, scenes, settings, pictures, interruption):
    print(test.__name__, flush=True)
    test()
