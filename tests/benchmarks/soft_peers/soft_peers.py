#!/usr/bin/env python3
"""Error and cost of one sheet and one block by our deformables, Jolt's and Bullet's:

    soft_peers.py BUILD [ENGINES]      # ENGINES: where npm installed jolt-physics

Both hang from their upper end, and in the end are longer by w g L2 / (2 k) and rho g L2 / (2 E). Prints tables for
docs/PERFORMANCE.md."""
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

GRAVITY_MPS2 = 9.81
SECONDS, TIMED_S = 6, 1.5
SHEET = {"length_m": 2.0, "cells": 40, "density_kgpm2": 0.3, "height_m": 3.0}
BLOCK = {"size_m": (0.5, 1.0, 0.5), "cells": (4, 8, 4), "density_kgpm3": 1000, "young_Pa": 1e5, "poisson": 0.3, "height_m": 3.0}
HEAD = """[scene]
title = "A deformable by itself"
[player]
position_m = [0, 0.1, 30]
[camera]
position_m = [4, 3, 6]
target_m = [0, 1, 0]
[world]
gravity_mps2 = [0, -9.81, 0]
"""


def sheet_scene(stretch_Npm):
    return HEAD + f"""[[cloth]]
name = "it"
size_m = [{SHEET["length_m"]}, {SHEET["length_m"]}]
cells = [{SHEET["cells"]}, {SHEET["cells"]}]
position_m = [0, {SHEET["height_m"]}, 0]
density_kgpm2 = {SHEET["density_kgpm2"]}
stretch_Npm = {stretch_Npm}
damping_s = 0.01
pins = [{{ edge = "top" }}]
"""


def block_scene():
    top_m = BLOCK["height_m"] + BLOCK["size_m"][1] / 2
    return HEAD + f"""[[soft]]
name = "it"
primitive = {{ box = {list(BLOCK["size_m"])} }}
position_m = [0, {BLOCK["height_m"]}, 0]
cell_m = {BLOCK["size_m"][1] / BLOCK["cells"][1]}
density_kgpm3 = {BLOCK["density_kgpm3"]}
young_Pa = {BLOCK["young_Pa"]}
poisson = {BLOCK["poisson"]}
damping_s = 0.02
pins = [{{ min_m = [-1, {top_m - 0.01}, -1], max_m = [1, {top_m + 0.01}, 1] }}]
"""


def ours(build, folder, scene, kind, fidelity):
    file = folder / "scene.toml"
    file.write_text(scene + f"[effects.{kind}]\nfidelity = \"{fidelity}\"\n", encoding="utf-8")

    def state_after(seconds):
        out = folder / "state.json"
        subprocess.run([build / "game/plumbline", "simulate", file, "--seconds", str(seconds), "--state", out],
                       check=True, capture_output=True)
        return json.loads(out.read_text(encoding="utf-8"))

    timed = state_after(TIMED_S)
    used = next(effect["cpu_ms"] for effect in timed["effects"] if effect["name"] == kind)
    ended = state_after(SECONDS)["cloths" if kind == "cloth" else "softs"][0]
    return {"points_m": ended["points_m"], "step_ms": used / timed["steps"]}


def sheet_problem(stretch_Npm):
    """Threads only: a sheet that hangs is not sheared. Those of the borders stand for half a cell."""
    n, cell_m = SHEET["cells"], SHEET["length_m"] / SHEET["cells"]
    number = lambda column, row: row * (n + 1) + column
    half = lambda i: 0.5 if i in (0, n) else 1.0
    points, masses = [], []
    for row, column in itertools.product(range(n + 1), range(n + 1)):
        points.append([(column - n / 2) * cell_m, SHEET["height_m"] + (n / 2 - row) * cell_m, 0])
        masses.append(SHEET["density_kgpm2"] * cell_m**2 * half(row) * half(column) if row else 0)
    edges, faces = [], []
    for row, column in itertools.product(range(n + 1), range(n + 1)):
        if column < n:
            edges.append([number(column, row), number(column + 1, row), stretch_Npm * half(row)])
        if row < n:
            edges.append([number(column, row), number(column, row + 1), stretch_Npm * half(column)])
        if row < n and column < n:
            a, b, c, d = number(column, row), number(column + 1, row), number(column + 1, row + 1), number(column, row + 1)
            faces += [[a, c, b], [a, d, c]]
    return {"points_m": points, "masses_kg": masses, "edges": edges, "faces": faces, "tetrahedra": [], "spring_Npm": stretch_Npm}


def block_problem():
    """Five tetrahedra a cell. Edges as stiff as Lloyd, Szekely and Harders 2007, "Identification of Spring Parameters for Deformable
    Object Simulation", have it for a modulus: 2 sqrt(2) / 25 E l a tetrahedron."""
    size, cells = BLOCK["size_m"], BLOCK["cells"]
    counts = [n + 1 for n in cells]
    number = lambda x, y, z: (z * counts[1] + y) * counts[0] + x
    points = [[size[0] * (x / cells[0] - 0.5), BLOCK["height_m"] + size[1] * (y / cells[1] - 0.5), size[2] * (z / cells[2] - 0.5)]
              for z, y, x in itertools.product(*map(range, reversed(counts)))]
    tetrahedra = []
    for z, y, x in itertools.product(*map(range, reversed(cells))):
        c = [number(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)) for i in range(8)]
        fives = [[0, 1, 2, 4], [3, 2, 1, 7], [5, 4, 7, 1], [6, 7, 4, 2], [1, 2, 4, 7]]
        if (x + y + z) % 2:
            fives = [[1, 0, 5, 3], [2, 3, 6, 0], [4, 5, 0, 6], [7, 6, 3, 5], [0, 3, 5, 6]]
        tetrahedra += [[c[i] for i in five] for five in fives]
    masses, stiff, faces = [0.0] * len(points), {}, {}
    for corners in tetrahedra:
        if volume_of(points, corners) < 0:
            corners[0], corners[1] = corners[1], corners[0]
        for corner in corners:
            masses[corner] += BLOCK["density_kgpm3"] * volume_of(points, corners) / 4
        for a, b in itertools.combinations(sorted(corners), 2):
            length = sum((p - q) ** 2 for p, q in zip(points[a], points[b])) ** 0.5
            stiff[a, b] = stiff.get((a, b), 0) + 2 * 2**0.5 / 25 * BLOCK["young_Pa"] * length
        for face in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)):
            outer = [corners[i] for i in face]
            faces.setdefault(tuple(sorted(outer)), []).append(outer)
    top_m = max(point[1] for point in points)
    masses = [0 if point[1] == top_m else mass for point, mass in zip(points, masses)]
    return {"points_m": points, "masses_kg": masses, "edges": [[a, b, k] for (a, b), k in stiff.items()], "tetrahedra": tetrahedra,
            "faces": [sides[0] for sides in faces.values() if len(sides) == 1], "spring_Npm": 0}


def volume_of(points, corners):
    a, b, c, d = (points[i] for i in corners)
    u, v, w = ([q - p for p, q in zip(a, other)] for other in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


def other(command, folder, problem, hz, iterations=5):
    file = folder / "problem.json"
    rest = {"hz": hz, "iterations": iterations, "seconds": SECONDS, "timed_s": TIMED_S, "gravity_mps2": GRAVITY_MPS2,
            "damping_s": 0.01, "young_Pa": BLOCK["young_Pa"], "poisson": BLOCK["poisson"]}
    file.write_text(json.dumps(problem | rest), encoding="utf-8")
    done = subprocess.run([*command, file], capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        sys.exit(f"{command}: {done.stderr[-500:]}")
    return json.loads(done.stdout)


def longer_m(result, length_m, height_m):
    """By the mean of the lowest layer, which the points nearest to the lowest one are."""
    lowest = sorted(point[1] for point in result["points_m"])[:25]
    return height_m - length_m / 2 - sum(lowest) / len(lowest)


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    packages = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path.home() / ".local/share/plumbline/engines"
    here = pathlib.Path(__file__).parent
    jolt = ["node", here / "jolt_soft.mjs", packages]
    bullet = [build / "tests/benchmarks/bullet_soft"]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)

        def table(title, exact_m, size, kind, scene, problem, ladder):
            print(f"\n{title}: {exact_m * 1e3:.2f} mm longer\n\n| engine | mm longer | of the exact | ms for 1/60 s |\n|---|--:|--:|--:|")

            def row(name, result, hz=60):
                found_m = longer_m(result, *size)
                print(f"| {name} | {found_m * 1e3:.2f} | {found_m / exact_m:.3f} | {result['step_ms'] * hz / 60:.2f} |", flush=True)

            for fidelity in ("draft", "balanced", "precise"):
                row(f"ours, {fidelity}", ours(build, folder, scene, kind, fidelity))
            for hz, iterations in ladder:
                row(f"Jolt, {hz} Hz x {iterations}", other(jolt, folder, problem, hz, iterations), hz)
            for hz in (60, 240):
                row(f"Bullet, {hz} Hz", other(bullet, folder, problem, hz), hz)

        for stretch_Npm in (500, 5000):
            exact_m = SHEET["density_kgpm2"] * GRAVITY_MPS2 * SHEET["length_m"] ** 2 / (2 * stretch_Npm)
            table(f"Sheet of {stretch_Npm} N/m", exact_m, (SHEET["length_m"], SHEET["height_m"]), "cloth", sheet_scene(stretch_Npm),
                  sheet_problem(stretch_Npm), ((60, 5), (60, 20), (60, 100), (240, 5), (480, 20)))
        exact_m = BLOCK["density_kgpm3"] * GRAVITY_MPS2 * BLOCK["size_m"][1] ** 2 / (2 * BLOCK["young_Pa"])
        table("Block", exact_m, (BLOCK["size_m"][1], BLOCK["height_m"]), "soft", block_scene(), block_problem(),
              ((60, 5), (60, 20), (240, 5), (240, 20)))


if __name__ == "__main__":
    main()
