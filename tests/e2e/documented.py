#!/usr/bin/env python3
"""Every command line of README.md, CONTRIBUTING.md and docs/ is one that the program takes, run as it is written.

A command that takes long is ended after half a second: by then a wrong option, scene or file has been refused. Windows are not
opened here: without a display `play` ends with 3, after it has read its options.
"""
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile

programs = {"plumbline": sys.argv[1], "plumbline-f64": sys.argv[2]}
folder = pathlib.Path(tempfile.mkdtemp())
environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
environment.update(HOME=str(folder), XDG_CONFIG_HOME=str(folder / "config"), XDG_DATA_HOME=str(folder / "data"),
                   XDG_CACHE_HOME=str(folder / "cache"), XDG_STATE_HOME=str(folder / "state"), ALSOFT_DRIVERS="null")
LONGEST_S = 0.5

IN_LINE = re.compile(r"`(?:\./play|plumbline(?:-f64)?)(?: [^`]*)?`")
OWN_LINE = re.compile(r"^\s*(?:\./play|plumbline(?:-f64)?)(?: .*)?$", re.MULTILINE)
# What stands for a word of the reader's: a name, a number, a file of the kind.
WORDS = {"SCENE": "falling_cube", "NAME": "falling_cube", "ID": "H05", "CASE": "H05", "DIR": "out", "N": "100", "LEVEL": "low", "FILE": "my_scene.toml",
         "F.ply": "model.ply", "F.json": "viewer/rings.json", "nature.obj": "model.obj",
         "x,y,z,yaw,pitch": "0,2,5,0,0"}
SHELL = re.compile(r"[$*{}|<>]|:::|--merge|\.\.\.")  # for a shell, or of what another command has made


def commands():
    """(place, words) of each command line, once."""
    seen = {}
    for page in ["README.md", "CONTRIBUTING.md", *sorted(map(str, pathlib.Path("docs").glob("*.md")))]:
        text = pathlib.Path(page).read_text(encoding="utf-8")
        for found in [*IN_LINE.finditer(text), *OWN_LINE.finditer(text)]:
            line = re.split(r"\s{3,}|\s+# |…", found.group(0).strip().strip("`"))[0].strip()
            if SHELL.search(line) or re.match(r"plumbline[:_(]|plumbline camera path", line):
                continue
            seen.setdefault(line, f"{page}:{text.count(chr(10), 0, found.start()) + 1}")
    return sorted((place, line) for line, place in seen.items())


def numbered_scene(name):
    """A scene of a series, such as bench/boxes_N."""
    return min(pathlib.Path("assets/scenes").glob(name[:-1] + "*.toml")).relative_to("assets/scenes").with_suffix("")


def words_of(line):
    first, *others = shlex.split(line)
    for option, name in (("--load", "game.save"), ("--save", "new.save")):
        if option in others:
            others[others.index(option) + 1] = name
    others = [str(numbered_scene(word)) if word.endswith("_N") else WORDS.get(word, word) for word in others]
    return programs.get(first, programs["plumbline"]), others


def prepare():
    """What the commands read, in the folder they run in."""
    shutil.copy("assets/scenes/falling_cube.toml", folder / "my_scene.toml")
    shutil.copytree("assets/scenes/viewer", folder / "viewer")
    (folder / "model.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (folder / "model.ply").write_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                                      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    (folder / "bindings.toml").write_text("format = 1\n")
    subprocess.run([programs["plumbline"], "simulate", "falling_cube", "--seconds", "0.1", "--save", "game.save"], cwd=folder,
                   env=environment, check=True, capture_output=True)


def run(place, line):
    program, words = words_of(line)
    running = subprocess.Popen([program, *words], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True)
    try:
        output, _ = running.communicate(timeout=LONGEST_S)
    except subprocess.TimeoutExpired:
        os.killpg(running.pid, signal.SIGKILL)
        running.communicate()
        return []
    names_a_command = len(words) < 2 and "is required" in output  # and no command line
    opens_no_window = words and words[0] in ("simulate", "render", "study", "stability", "explain", "check", "controls", "scenes")
    is_right = names_a_command or running.returncode == 0 or running.returncode == 3 and not opens_no_window
    return [] if is_right else [f"{place}: {line}: exit {running.returncode}\n{output}"]


prepare()
found = commands()
assert len(found) > 40, found
problems = [problem for place, line in found for problem in run(place, line)]
shutil.rmtree(folder, ignore_errors=True)
print("\n".join(problems))
print(f"{len(found)} commands of the pages: {len(problems)} problems")
sys.exit(1 if problems else 0)
