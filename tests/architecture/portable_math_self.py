#!/usr/bin/python3
"""Proves that portable_math.py finds the C library's functions and nothing else: in small trees."""

import pathlib
import tempfile
import unittest

import portable_math


def problems_of(line, path="engine/core/a.cpp", exempt=None):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(line + "\n", encoding="utf-8")
        return portable_math.check(root, exempt or {})[0]


class PortableMath(unittest.TestCase):
    def test_every_way_to_the_c_library_is_seen(self):
        for call in ("std::sin(x)", "std::expf(x)", "glm::angleAxis(x, y)", "glm::slerp(a, b, t)", "::pow(x, 2)", "cos(x)", "sinf(x)"):
            self.assertEqual(len(problems_of(f"const auto y = {call};")), 1, call)

    def test_our_own_names_comments_and_texts_are_free(self):
        for line in ("portable_sin(x);", "std::sqrt(x);", "aim.sin(x);", "// std::sin(x)", 'say("cos(x)");', "arccos(x);"):
            self.assertEqual(problems_of(line), [], line)

    def test_exempt_files_and_other_folders_are_free(self):
        self.assertEqual(problems_of("std::sin(x);", exempt={"engine/core/a.cpp": "drawn"}), [])
        self.assertEqual(problems_of("std::sin(x);", path="engine/render/a.cpp"), [])
        self.assertEqual(len(problems_of("1;", exempt={"engine/core/a.cpp": "drawn"})), 1)


if __name__ == "__main__":
    unittest.main()
