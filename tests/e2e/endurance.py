#!/usr/bin/env python3
"""A program that is busy, hidden, capped or left alone for long. EXPERIENCE A17, H15, I6, I9, I10."""
import json
import os
import re
import signal
import subprocess
import sys
import time

from support import Program, expect, home, read_json, settings_in, virtual_screen

program_file = sys.argv[1]


def play(environment, *words, cpu=None):
    pin = ["taskset", "-c", str(cpu)] if cpu is not None else []
    done = subprocess.run([*pin, program_file, "play", "falling_cube", "--size", "320x180", *map(str, words)],
                          env=environment, capture_output=True, text=True, timeout=120)
    expect(done.returncode == 0, f"exit {done.returncode}\n{done.stderr}")


def where_vsync_does_nothing_a_sleep_caps_the_frames(environment, folder):  # EXPERIENCE A17
    """Xvfb has no vertical blank to wait for, so that only max_fps can hold the loop back."""
    settings = folder / "config/plumbline/app.toml"
    usual = settings.read_text()
    settings.write_text("[window]\nvsync = true\nmax_fps = 15\n")
    report = folder / "capped.json"
    play(environment, "--seconds", 4, "--report", report)
    frames = read_json(report)["frames"]
    settings.write_text(usual)
    expect(2 < frames <= 4 * 15 + 2, f"{frames} frames in 4 s at 15 a second")


def memory_kb(pid):
    with open(f"/proc/{pid}/status", encoding="utf-8") as status:
        return int(re.search(r"VmRSS:\s+(\d+)", status.read()).group(1))


def hidden_it_draws_ten_frames_a_second_and_grows_no_more(environment, folder):  # EXPERIENCE I6
    settings = folder / "config/plumbline/app.toml"
    usual = settings.read_text()
    settings.write_text("[window]\nmax_fps = 40\n")
    report = folder / "hidden.json"
    hidden_s = 10
    began = time.monotonic()
    game = Program([program_file, "play", "falling_cube", "--size", "320x180", "--report", str(report)], environment,
                   folder / "hidden.log")
    try:
        time.sleep(2)
        game.do("windowunmap", game.window)
        time.sleep(2)
        shown_s = time.monotonic() - began
        before_kb = memory_kb(game.process.pid)
        time.sleep(hidden_s)
        grown_kb = memory_kb(game.process.pid) - before_kb
        game.process.terminate()
        game.wait(30)
    finally:
        game.stop()
        settings.write_text(usual)
    expect(grown_kb < 2048, f"{grown_kb} KiB more after {hidden_s} s hidden")
    frames = read_json(report)["frames"]
    expect(frames <= 40 * (shown_s + 1) + 10 * (hidden_s + 2), f"{frames} frames, of them {hidden_s} s hidden")


def one_busy_core_is_enough(environment, folder):  # EXPERIENCE I9
    """One core, shared with a neighbour that never rests: threads that wait for each other would hang."""
    core = min(os.sched_getaffinity(0))
    neighbour = subprocess.Popen(["taskset", "-c", str(core), sys.executable, "-c", "while True: pass"])
    try:
        play(environment, "--seconds", 3, "--random-input", 3, "--report", folder / "busy.json", cpu=core)
        done = subprocess.run(["taskset", "-c", str(core), program_file, "study", "A02", "--quick", "--out", folder / "study"],
                              env=environment, capture_output=True, text=True, timeout=200)
        expect(done.returncode == 0, done.stderr)
    finally:
        neighbour.kill()
        neighbour.wait()
    report = read_json(folder / "busy.json")
    expect(report["frames"] > 0, report)


def eight_hours_change_nothing(environment, folder):  # EXPERIENCE I10
    """Eight simulated hours of a cube that rests and ten minutes of a room in motion: memory stays
    where it was, every number is one, and no energy comes from nowhere."""
    def simulated(scene, seconds):
        state = folder / f"{scene}_{seconds}.json"
        # In a process of its own, because the peak over all children of one process only ever grows.
        script = ("import json, resource, subprocess, sys\n"
                  "code = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL).returncode\n"
                  "print(json.dumps([code, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss]))\n")
        done = subprocess.run([sys.executable, "-c", script, program_file, "simulate", scene, "--seconds",
                               str(seconds), "--state", str(state)], env=environment, capture_output=True, text=True,
                              timeout=280)
        code, peak_kb = json.loads(done.stdout)
        expect(code == 0, done.stderr)
        return peak_kb, read_json(state)

    for scene, briefly_s, long_s in (("falling_cube", 10, 8 * 3600), ("playroom", 30, 600)):
        short_kb, short = simulated(scene, briefly_s)
        long_kb, long = simulated(scene, long_s)
        # The time of each step is kept for the median, 8 bytes each, in a list that doubles.
        expect(long_kb < short_kb + 4096 + long["steps"] * 16 // 1024, f"{scene}: {short_kb} KiB at most in {briefly_s} s, {long_kb} in {long_s} s")
        expect(long["steps"] == long_s * 60 and long["non_finite"] == 0, long["steps"])
        numbers = [number for body in long["bodies"] for number in body["position_m"]]
        expect(all(abs(number) < 1e4 for number in numbers), "a body left the scene")
        energy = [sum(state["energy_J"].values()) for state in (short, long)]
        expect(energy[1] <= energy[0] + 0.05 * abs(energy[0]), f"{scene}: {energy} J")


def paused_and_single_stepped_it_replays_bit_for_bit(environment, folder):  # EXPERIENCE H15
    tape = folder / "stepped.tape"
    game = Program([program_file, "play", "playroom", "--size", "320x180", "--no-sound", "--record", str(tape)], environment, folder / "stepped.log")
    try:
        game.ready(folder / "data/plumbline/shots")
        game.press("q", 6, 0.4)  # not all in one frame: one that takes too long drops what came in it
        game.press("p")
        game.press("o", 5, 0.25)
        game.press("p")
        game.press("q")
        time.sleep(1)
        game.process.send_signal(signal.SIGINT)
        code = game.wait(60)
    finally:
        game.stop()
    expect(code == 130, game.log())
    expected = re.search(r"state ([0-9a-f]{16})", game.log())[1]
    again = subprocess.run([program_file, "play", "playroom", "--size", "320x180", "--no-sound", "--replay", str(tape),
                            "--expect-hash", expected, "--report", str(folder / "stepped.json")], env=environment,
                           capture_output=True, text=True, timeout=200)
    expect(again.returncode == 0, f"exit {again.returncode}\n{again.stderr}")
    seen = read_json(folder / "stepped.json")["actions_seen"]
    expect(seen.get("drop", 0) >= 1, seen)


def main():
    with virtual_screen("640x360") as screen, home() as folder:
        environment = settings_in(folder, screen)
        for check in (where_vsync_does_nothing_a_sleep_caps_the_frames,
                      hidden_it_draws_ten_frames_a_second_and_grows_no_more, one_busy_core_is_enough,
                      paused_and_single_stepped_it_replays_bit_for_bit, eight_hours_change_nothing):
            check(environment, folder)
            print(f"good: {check.__name__}")


main()
