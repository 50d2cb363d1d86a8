#!/usr/bin/env python3
"""Random input plays for long: nothing crashes, and memory and the cost of a frame stay level.

soak.py PROGRAM [--seconds N] [--seeds N ...] [--scenes NAME ...] [--out FOLDER]

FOLDER gets a table SCENE_SEED.csv (s, MiB, CPU ms a frame) of every run and a graph of all: soak.svg.
"""
import argparse
import csv
import pathlib
import statistics
import subprocess

from support import expect, home, read_json, settings_in, virtual_screen

MOST_MIB = 450
LEVEL_AFTER_S = 180  # by then everything that a scene can show was shown once
MEMORY_GROWS = 1.10  # at most, from then on
FRAME_GROWS = 1.5  # the last third's median against the middle third's: things that were dropped cost as well


def play(program, environment, folder, scene, seed, seconds):
    """The rows of one run: seconds, MiB, CPU ms a frame."""
    report = folder / f"{scene}_{seed}.json"
    done = subprocess.run([program, "play", scene, "--size", "640x360", "--random-input", str(seed), "--seconds", str(seconds),
                           "--report", str(report)], env=environment, capture_output=True, text=True, timeout=2 * seconds + 120)
    crash = folder / "state/plumbline/crash.txt"
    expect(done.returncode == 0, f"{scene} {seed}: exit {done.returncode}\n{done.stderr[-4000:]}\n"
           + (crash.read_text() if crash.exists() else ""))
    return [(row["end_s"], row["resident_bytes"] / 2**20, row["process_cpu_ms_per_frame"]) for row in read_json(report)["intervals"]
            if row["frames"]]


def judge(name, rows):
    most = max(row[1] for row in rows)
    print(f"{name}: {rows[-1][0]:.0f} s, {most:.0f} MiB at most, {statistics.median(row[2] for row in rows):.1f} CPU ms a frame", flush=True)
    expect(most < MOST_MIB, f"{name}: {most:.0f} MiB")
    settled = [row for row in rows if row[0] > LEVEL_AFTER_S]
    if len(settled) < 10:
        return
    first, last = settled[0][1], max(row[1] for row in settled)
    expect(last < first * MEMORY_GROWS, f"{name}: {first:.0f} MiB after {LEVEL_AFTER_S} s, later {last:.0f}")
    third = len(settled) // 3
    middle, end = (statistics.median(row[2] for row in part) for part in (settled[third:2 * third], settled[2 * third:]))
    expect(end < middle * FRAME_GROWS, f"{name}: {middle:.1f} ms a frame, later {end:.1f}")


COLORS = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22", "#17becf")


def axis(least, most):
    """Round numbers from `least` to `most`, five or so."""
    step = 10 ** len(str(int(most - least))) / 100
    while (most - least) / step > 6:
        step *= 2 if str(step)[0] in "15" else 2.5
    return [step * i for i in range(int(most / step) + 1)]


def panel(top, title, unit, runs, column):
    """One diagram: every run as a line over the minutes."""
    left, width, height = 70, 720, 220
    end_s = max(rows[-1][0] for rows in runs.values())
    most = 1.1 * max(row[column] for rows in runs.values() for row in rows)

    def at(s, value):
        return left + width * s / end_s, top + height * (1 - value / most)
    parts = [f'<text x="{left}" y="{top - 10}" font-weight="bold">{title}</text>',
             f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="none" stroke="#888"/>']
    for value in axis(0, most):
        x, y = at(0, value)
        parts.append(f'<line x1="{x}" y1="{y:.1f}" x2="{x + width}" y2="{y:.1f}" stroke="#ddd"/>'
                     f'<text x="{x - 6}" y="{y + 4:.1f}" text-anchor="end">{value:g}</text>')
    for minute in axis(0, end_s / 60):
        x, y = at(minute * 60, 0)
        parts.append(f'<text x="{x:.1f}" y="{y + 16}" text-anchor="middle">{minute:g}</text>')
    parts.append(f'<text x="{left + width}" y="{top + height + 32}" text-anchor="end">minutes</text>'
                 f'<text x="{left - 50}" y="{top - 10}">{unit}</text>')
    for index, (name, rows) in enumerate(runs.items()):
        color = COLORS[index % len(COLORS)]
        points = " ".join("{:.1f},{:.1f}".format(*at(row[0], row[column])) for row in rows)
        parts.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="1.5"/>')
        if column == 1:
            parts.append(f'<text x="{left + width + 10}" y="{top + 12 + 16 * index}" fill="{color}">{name}</text>')
    return "\n".join(parts)


def draw(file, runs):
    file.write_text('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 940 610" font-family="sans-serif" font-size="12">\n'
                    '<rect width="940" height="610" fill="white"/>\n'
                    + panel(40, "Memory of play with random input", "MiB", runs, 1) + "\n"
                    + panel(350, "CPU time of a frame", "ms", runs, 2) + "\n</svg>\n")


def main():
    words = argparse.ArgumentParser()
    words.add_argument("program")
    words.add_argument("--seconds", type=int, default=8)
    words.add_argument("--seeds", type=int, nargs="+", default=[4711])
    words.add_argument("--scenes", nargs="+", default=["garden", "fairground", "playroom"])
    words.add_argument("--out", type=pathlib.Path)
    asked = words.parse_args()
    runs = {}
    for seed in asked.seeds:
        for scene in asked.scenes:
            with virtual_screen("640x360") as screen, home() as folder:
                rows = play(asked.program, {**settings_in(folder, screen), "XDG_STATE_HOME": str(folder / "state")}, folder, scene, seed,
                            asked.seconds)
            name = f"{scene} {seed}"
            runs[name] = rows
            if asked.out:
                asked.out.mkdir(parents=True, exist_ok=True)
                with open(asked.out / f"{scene}_{seed}.csv", "w", newline="", encoding="utf-8") as file:
                    table = csv.writer(file)
                    table.writerow(["s", "MiB", "CPU ms a frame"])
                    table.writerows([f"{value:.2f}" for value in row] for row in rows)
                draw(asked.out / "soak.svg", runs)
            judge(name, rows)


main()
