#!/usr/bin/env python3
"""A person plays: walks, looks, drops, throws, switches things, rebinds a key while the program
runs, resizes, hides and shows the window, and leaves through the menu. The report counts it all."""
import os
import sys
import time

from support import Program, expect, home, read_json, settings_in, virtual_screen

program_file = sys.argv[1]
images = os.environ.get("PL_E2E_IMAGES")  # a folder: keeps what was on the screen


def main():
    with virtual_screen() as screen, home() as folder:
        environment = settings_in(folder, screen)
        report = folder / "report.json"
        bindings = folder / "config" / "plumbline" / "bindings.toml"
        game = Program([program_file, "play", "playroom", "--size", "480x270", "--report", str(report)],
                       environment, folder / "log.txt")
        try:
            play(game, bindings, folder / "data/plumbline/shots")
            code = game.wait(60)
        finally:
            game.stop()
        expect(code == 0, f"exit code {code}:\n{game.log()}")
        judge(read_json(report))


def snap(game, name):
    if images:
        game.image(os.path.join(images, name + ".png"))


def play(game, bindings, shots):
    game.do("mousemove", 240, 135)
    game.ready(shots)
    snap(game, "1_start")
    game.hold("w", 1.5)
    for _ in range(10):
        game.do("mousemove_relative", "--", 12, 2)
        time.sleep(0.05)
    game.press("1")
    game.press("q", 5, 0.4)
    snap(game, "2_five_crates")
    game.press("2")
    game.do("mousedown", 1)
    time.sleep(0.8)
    game.do("mouseup", 1)
    game.press("f")
    game.press("g")
    time.sleep(0.4)
    snap(game, "3_light_and_fog")
    game.press("v")
    time.sleep(0.4)
    snap(game, "4_wireframe")
    game.press("n")
    bindings.write_text('format = 1\n[things]\ndrop = ["i"]\n')
    time.sleep(2)
    game.press("i", 2, 0.4)
    game.press("q")  # unbound now
    game.do("windowsize", game.window, 800, 450)
    time.sleep(0.5)
    snap(game, "5_resized")
    game.do("windowunmap", game.window)
    time.sleep(1)
    game.do("windowmap", game.window)
    time.sleep(1.5)
    game.focus()
    game.press("F3")
    time.sleep(0.5)
    snap(game, "6_statistics")
    game.press("Escape")
    time.sleep(0.7)
    snap(game, "7_menu")
    game.press("Down", 7, 0.1)  # quicker than the frames: none is lost
    time.sleep(0.5)
    snap(game, "8_quit_is_chosen")
    game.press("Return")


def judge(report):
    seen = report["actions_seen"]
    wanted = {"forward": 1, "select_1": 1, "drop": 7, "throw": 1, "flashlight": 1, "fog": 1,
              "wireframe": 1, "filled": 1, "stats": 1, "menu": 1, "select_2": 1}
    for action, presses in wanted.items():
        expect(seen.get(action) == presses, f"{action}: {seen.get(action)} presses seen, {presses} made; all: {seen}")
    longest = [frame["frame_ms"] for frame in report["longest_frames"]]
    expect(len(longest) == 5 and longest == sorted(longest, reverse=True) and longest[0] <= report["frame_ms"]["max"],
           f"the longest frames: {longest}")
    expect(report["frames"] > 20, f"only {report['frames']} frames")
    expect(report["bodies"] >= 7, "the dropped bodies are not there")
    effects = {line["name"]: line for line in report["effects"]}
    expect(effects["flashlight"]["constructions"] == 1, "the flashlight was made once")
    expect(effects["fog"]["constructions"] == 1, "fog was made once")
    for key in ("startup_ms", "frame_ms", "cpu_ms", "gpu_ms", "draw_calls", "triangles", "instances",
                "shadow_passes_rendered", "shadow_passes_cached", "physics", "lost_time_s", "peak_rss_bytes", "gl"):
        expect(key in report, f"the report lacks {key}")


main()
