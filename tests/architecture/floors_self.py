#!/usr/bin/python3
"""Proves that floors.py sees what it is there to see, in small trees."""

import pathlib
import tempfile
import unittest

import floors

ORDER = {"render": ["gl", "passes"]}


def problems_of(texts, still_upward=frozenset()):
    """What floors.py says of a tree that holds these files; `texts`: path -> what the file includes."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path, included in texts.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text("".join(f'#include "{name}"\n' for name in included), encoding="utf-8")
        return floors.check(root, ORDER, set(still_upward))[0]


GL, PASS, FACE, FACADE = ("engine/render/gl/program.h", "engine/render/passes/sky_pass.h", "engine/render/frame.h",
                          "engine/render/renderer.h")


class Floors(unittest.TestCase):
    def test_down_and_sideways_pass(self):
        self.assertEqual(problems_of({PASS: [GL, FACE], GL: [FACE], FACE: [], "engine/render/gl/a.cpp": [GL],
                                      "engine/render/renderer.cpp": [PASS, GL]}), [])

    def test_up_fails(self):
        self.assertEqual(problems_of({GL: [PASS], PASS: []}),
                         [f"{GL}:1: gl must not include {PASS}: passes is above it"])

    def test_up_through_the_root_fails(self):
        self.assertEqual(problems_of({GL: [FACADE], FACADE: [FACE], FACE: [PASS], PASS: []}),
                         [f"{GL}:1: gl must not include {FACADE}: passes is above it"])

    def test_a_folder_without_a_floor_fails(self):
        self.assertEqual(problems_of({"engine/render/sky/sky.h": []}),
                         ["render/sky is in no list of tests/architecture/floors.py"])

    def test_what_may_still_go_up(self):
        pair = ("render", "gl", "passes")
        self.assertEqual(problems_of({GL: [PASS], PASS: []}, {pair}), [])
        self.assertEqual(problems_of({GL: [], PASS: []}, {pair}),
                         ["tests/architecture/floors.py: render/gl includes nothing from passes any more: strike it off"])

    def test_circles_end(self):
        self.assertEqual(problems_of({FACE: [FACADE], FACADE: [FACE, GL], GL: []}), [])


if __name__ == "__main__":
    unittest.main()
