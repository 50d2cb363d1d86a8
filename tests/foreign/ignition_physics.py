#!/usr/bin/env python3
"""Two worlds through Gazebo's Bullet plugin, as Debian has it, with Bullet's world and with ours.

    tests/foreign/ignition_physics.py BUILD [FOLDER]

BUILD is a build folder of this project; FOLDER keeps the packages, which `apt-get download` brings, and the program.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = ["libignition-physics5-bullet-plugin5", "libignition-physics-core-dev", "libignition-physics-sdf-dev", "libsdformat-dev",
            "libeigen3-dev"]
STEPS = 600  # of 1/60 s


def unpack(folder: pathlib.Path) -> pathlib.Path:
    """The packages, and what they need and is not installed, below folder/usr. Nothing is installed."""
    if (folder / "usr").is_dir():
        return folder / "usr"
    plan = subprocess.run(["apt-get", "install", "--simulate", "--no-install-recommends", *PACKAGES],
                          capture_output=True, text=True, check=True).stdout
    names = {line.split()[1] for line in plan.splitlines() if line.startswith("Inst ")} | set(PACKAGES)
    subprocess.run(["apt-get", "download", *sorted(names)], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    for package in sorted(folder.glob("*.deb")):
        subprocess.run(["dpkg-deb", "-x", package, folder], check=True)
    return folder / "usr"


def compile_host(build: pathlib.Path, usr: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
    host = folder / "ignition_host"
    libraries = usr / "lib/x86_64-linux-gnu"
    headers = [f"-I{each}" for each in sorted((usr / "include/ignition").iterdir())]
    headers += [f"-I{each}" for each in usr.glob("include/sdformat-*")] + [f"-I{usr}/include/eigen3", "-I/usr/include/bullet", f"-I{ROOT}"]
    ours = [build / "engine" / name / f"libplumbline_{name}.a" for name in ("bullet_world", "physics", "core")]
    subprocess.run(["g++", "-std=c++20", "-O1", "-w", "-rdynamic", *headers, ROOT / "tests/foreign/ignition_host.cpp", "-o", host, *ours,
                    "-lBulletDynamics", "-lBulletCollision", "-lLinearMath", "-lfmt", "-lspdlog", "-lxxhash", "-lz", "-ltbb",
                    f"-L{libraries}", f"-Wl,-rpath,{libraries}", f"-Wl,-rpath-link,{libraries}", "-lignition-plugin1-loader",
                    "-lignition-plugin1", "-lsdformat12", "-lignition-math6", "-lignition-physics5", "-ldl"], check=True)
    return host


def link(name: str, size: tuple, mass_kg: float, height_m: float) -> str:
    x, y, z = size
    moment = lambda a, b: mass_kg * (a * a + b * b) / 12
    return f"""<link name="{name}"><pose>0 0 {height_m} 0 0 0</pose>
<inertial><mass>{mass_kg}</mass><inertia><ixx>{moment(y, z)}</ixx><iyy>{moment(x, z)}</iyy><izz>{moment(x, y)}</izz></inertia></inertial>
<collision name="shape"><geometry><box><size>{x} {y} {z}</size></box></geometry></collision></link>"""


def world(models: str) -> str:
    return f"""<?xml version="1.0"?><sdf version="1.6"><world name="yard"><gravity>0 0 -9.81</gravity>
<physics type="bullet"><max_step_size>0.0166667</max_step_size></physics>{models}</world></sdf>"""


def stack() -> str:
    """Nine cubes of 1 kg under one of 100 kg."""
    models = f'<model name="ground"><static>true</static>{link("link", (50, 50, 1), 1, -0.5)}</model>'
    for i in range(10):
        models += f'<model name="cube {i}">{link("link", (1, 1, 1), 1 if i < 9 else 100, i + 0.5)}</model>'
    return world(models)


def chain() -> str:
    """Ten links of 0.5 m on revolute joints, the last of 100 kg, the others of 1 kg."""
    parts = link("base", (0.1, 0.1, 0.1), 1, 10)
    parts += '<joint name="held" type="fixed"><parent>world</parent><child>base</child></joint>'
    for i in range(10):
        parts += link(f"link {i}", (0.1, 0.1, 0.4), 1 if i < 9 else 100, 9.75 - 0.5 * i)
        parent = f"link {i - 1}" if i else "base"
        parts += f"""<joint name="joint {i}" type="revolute"><pose>0 0 0.25 0 0 0</pose><parent>{parent}</parent><child>link {i}</child>
<axis><xyz>0 1 0</xyz><limit><lower>-1e16</lower><upper>1e16</upper></limit></axis></joint>"""
    return world(f'<model name="chain">{parts}</model>')


def run(host: pathlib.Path, usr: pathlib.Path, text: str, ours: bool, folder: pathlib.Path) -> tuple:
    """Heights of the bodies in m, ms in all, and what our world says that it does not do."""
    file = folder / "world.sdf"
    file.write_text(text)
    surroundings = dict(os.environ, LD_LIBRARY_PATH=str(usr / "lib/x86_64-linux-gnu"))
    surroundings.pop("PLUMBLINE", None)
    if ours:
        surroundings["PLUMBLINE"] = "1"
    said = subprocess.run([host, usr / "lib/x86_64-linux-gnu/libignition-physics5-bullet-plugin.so.5", file, str(STEPS)], env=surroundings,
                          capture_output=True, text=True, check=True).stdout.splitlines()
    heights = [float(line.split()[3]) for line in said if line.startswith("body ")]
    return heights, float(said[-1].split()[1]), [line[5:] for line in said if line.startswith("note ")]


def main() -> int:
    build = pathlib.Path(sys.argv[1]).resolve()
    folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp()).resolve()
    folder.mkdir(exist_ok=True)
    usr = unpack(folder)
    host = compile_host(build, usr, folder)
    good = True
    for name, text, top, due_m in (("stack of ten cubes, the top one 100 times as heavy", stack(), -1, 9.5),
                                   ("chain of ten links, the last one 100 times as heavy", chain(), -1, 5.25)):
        for ours in (False, True):
            heights, spent_ms, notes = run(host, usr, text, ours, folder)
            off_mm = 1000 * abs(heights[top] - due_m)
            print(f"{name}, {'small_step' if ours else 'Bullet'}: {off_mm:.1f} mm from where it belongs, {spent_ms:.1f} ms")
            for note in notes:
                print("  " + note)
            good = good and (not ours or off_mm < 20)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
