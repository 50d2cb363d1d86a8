#!/usr/bin/env python3
"""A window around which something goes wrong: shaders, memory, the monitor, the folder for images."""
import ctypes
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time

from support import Program, expect, home, read_json, settings_in, virtual_screen

program_file = sys.argv[1]
sanitized = b"__asan_init" in pathlib.Path(program_file).read_bytes()
WRONG = "nonsense here;\n"


def own_shaders(folder, environment):
    """A copy of the shaders that may be broken; the environment in which it is used."""
    data = folder / "own data"
    shutil.copytree("shaders", data / "shaders")
    for name in ("assets", "config"):
        (data / name).symlink_to(pathlib.Path(name).absolute())
    return data / "shaders", {**environment, "PLUMBLINE_DATA": str(data)}


def shaders_that_do_not_compile_end_the_start(folder, environment):  # EXPERIENCE A6
    shaders, environment = own_shaders(folder, environment)
    image = folder / "none.png"
    for name, commands in (("mesh.frag", ("render", "play")), ("depth.frag", ("render",)), ("sky_dome.frag", ("render", "play")),
                           ("tone_map.frag", ("render", "play")), ("include/lighting.glsl", ("render",))):
        text = (shaders / name).read_text()
        (shaders / name).write_text(text + WRONG)
        place = f"{name}:{text.count(chr(10)) + 1}"
        for command in commands:
            words = ["--out", image, "--size", "64x36"] if command == "render" else ["--size", "160x90", "--no-sound"]
            done = subprocess.run([program_file, command, "garden", *map(str, words)], env=environment, capture_output=True,
                                  text=True, timeout=60)
            expect(done.returncode == 3, f"{command} with a broken {name}: exit {done.returncode}\n{done.stderr}")
            expect(done.stderr.count("does not compile") == 1 and place in done.stderr, f"not {place}, once:\n{done.stderr}")
        (shaders / name).write_text(text)
    expect(not image.exists(), "an image was written all the same")


def a_shader_saved_with_a_fault_keeps_the_image(folder, environment):  # EXPERIENCE A7
    shaders, environment = own_shaders(folder, environment)
    file = shaders / "tone_map.frag"
    text = file.read_text()
    report = folder / "shaders.json"
    game = Program([program_file, "play", "falling_cube", "--size", "320x180", "--no-sound", "--report", str(report)], environment,
                   folder / "shaders.txt")
    try:
        shots = folder / "data/plumbline/shots"
        game.ready(shots)
        game.screenshot(shots)  # in a second frame: a fault in the first one ends the start
        file.write_text(text + WRONG)
        game.until_said(f"tone_map.frag:{text.count(chr(10)) + 1}")
        game.screenshot(shots)
        snap(game, "shader_fault")
        file.write_text(text.replace("void main() {", "void main() {  // mended"))
        time.sleep(1.5)
        game.screenshot(shots)
        snap(game, "shader_mended")
        expect(game.log().count("does not compile") == 1, game.log())
        game.process.send_signal(signal.SIGTERM)
        expect(game.wait(20) == 130, game.log())
    finally:
        game.stop()
    expect(read_json(report)["frames"] > 10, "no frames went on")


def a_scene_too_large_for_memory_leaves_the_running_one(folder, environment):  # EXPERIENCE G26
    if sanitized:
        print("the sanitizer needs more addresses than this: not tried")
        return
    scene, report = folder / "grows.toml", folder / "grows.json"
    cube = '[[prefab]]\nname = "b"\nprimitive = { box = [1, 1, 1] }\n[prefab.body]\nmass_kg = 1\n'
    array = '[[array]]\nname = "a"\nprefab = "b"\ncount = [%d, 1, 50]\nspacing_m = [2, 2, 2]\n'
    head = '[scene]\ntitle = "grows"\n'
    scene.write_text(head + cube + array % 1)
    game = Program([program_file, "play", str(scene), "--size", "160x90", "--no-sound", "--report", str(report)], environment,
                   folder / "grows.txt")
    try:
        game.ready(folder / "data/plumbline/shots")
        time.sleep(2)  # what it needs for its frames it has by then
        used = int(pathlib.Path(f"/proc/{game.process.pid}/statm").read_text().split()[0]) * resource.getpagesize()
        usual = resource.prlimit(game.process.pid, resource.RLIMIT_AS)
        resource.prlimit(game.process.pid, resource.RLIMIT_AS, (used + (48 << 20), usual[1]))
        scene.write_text(head + cube + array % 999)
        game.until_said("not enough memory for this scene; the current scene stays open")
        resource.prlimit(game.process.pid, resource.RLIMIT_AS, usual)
        time.sleep(1)
        snap(game, "no_memory")
        expect(game.log().count("not enough memory") == 1, game.log())
        game.process.send_signal(signal.SIGTERM)
        expect(game.wait(20) == 130, game.log())
    finally:
        game.stop()
    expect(read_json(report)["bodies"] == 50, "the scene before did not stay")


def images_that_cannot_be_saved_cost_a_line(folder, environment):  # EXPERIENCE E10
    shots = folder / "data/plumbline/shots"
    shots.parent.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(shots, ignore_errors=True)
    shots.write_text("a file stands where the folder would be")
    game = Program([program_file, "play", "falling_cube", "--size", "320x180", "--no-sound"], environment, folder / "shots.txt")
    try:
        game.focus()
        time.sleep(1.5)
        game.press("F12", pause_s=1)
        snap(game, "no_image")
        expect(game.process.poll() is None and shots.is_file(), game.log())
        shots.unlink()
        game.screenshot(shots)
        expect(len(list(shots.glob("falling_cube*.png"))) == 1, "one press, one image")
        game.process.send_signal(signal.SIGTERM)
        expect(game.wait(20) == 130, game.log())
    finally:
        game.stop()


class Resources(ctypes.Structure):
    _fields_ = [("timestamp", ctypes.c_ulong), ("config_timestamp", ctypes.c_ulong), ("crtc_count", ctypes.c_int),
                ("crtcs", ctypes.POINTER(ctypes.c_ulong)), ("output_count", ctypes.c_int), ("outputs", ctypes.POINTER(ctypes.c_ulong))]


def unplug_the_monitor(display):
    """By RandR, as an X server does it when the cable goes."""
    x11, randr = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXrandr.so.2")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XDefaultRootWindow.restype, x11.XDefaultRootWindow.argtypes = ctypes.c_ulong, [ctypes.c_void_p]
    x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
    randr.XRRGetScreenResources.restype = ctypes.POINTER(Resources)
    randr.XRRGetScreenResources.argtypes = [ctypes.c_void_p, ctypes.c_ulong]
    randr.XRRSetCrtcConfig.argtypes = [ctypes.c_void_p, ctypes.POINTER(Resources), ctypes.c_ulong, ctypes.c_ulong, ctypes.c_int,
                                       ctypes.c_int, ctypes.c_ulong, ctypes.c_ushort, ctypes.c_void_p, ctypes.c_int]
    server = x11.XOpenDisplay(display.encode())
    found = randr.XRRGetScreenResources(server, x11.XDefaultRootWindow(server))
    off = randr.XRRSetCrtcConfig(server, found, found.contents.crtcs[0], 0, 0, 0, 0, 1, None, 0)
    x11.XCloseDisplay(server)
    expect(off == 0, f"RandR says {off}")


def size_of(game):
    shown = subprocess.run(["xdotool", "getwindowgeometry", game.window], env=game.environment, capture_output=True, text=True)
    return shown.stdout.split("Geometry: ")[1].split()[0]


def a_monitor_that_goes_leaves_a_window(folder):  # EXPERIENCE A13
    with virtual_screen() as screen:  # its own: the monitor does not come back
        environment = settings_in(folder, screen)
        game = Program([program_file, "play", "falling_cube", "--size", "320x180", "--no-sound"], environment, folder / "monitor.txt")
        try:
            game.ready(folder / "data/plumbline/shots")
            game.press("F11")
            game.until(lambda: size_of(game) == "1280x720", "full screen")
            game.screenshot(folder / "data/plumbline/shots")
            unplug_the_monitor(environment["DISPLAY"])
            game.until(lambda: size_of(game) == "320x180", "back to its size")
            game.process.send_signal(signal.SIGTERM)
            expect(game.wait(20) == 130, game.log())
        finally:
            game.stop()
        expect("the fullscreen monitor was disconnected" in game.log(), game.log())


def snap(game, name):
    if "PL_E2E_IMAGES" in os.environ:
        game.image(os.path.join(os.environ["PL_E2E_IMAGES"], name + ".png"))


def main():
    with virtual_screen() as screen:
        for test in (shaders_that_do_not_compile_end_the_start, a_shader_saved_with_a_fault_keeps_the_image,
                     a_scene_too_large_for_memory_leaves_the_running_one, images_that_cannot_be_saved_cost_a_line):
            print(test.__name__, flush=True)
            with home() as folder:
                test(folder, settings_in(folder, screen))
    with home() as folder:
        a_monitor_that_goes_leaves_a_window(folder)


main()
