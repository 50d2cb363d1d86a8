#!/usr/bin/python3
"""Proves that tested.py finds what has no test and nothing else: in small trees."""

import pathlib
import tempfile
import unittest

import tested

DECIDES = "int f(int a) {\n    if (a > 1) return 1;\n    for (;;) {\n    }\n    return a > 0 ? 1 : 2;\n}\n"
UNTESTED = ["engine/x/a.cpp: decides something and has no test: write tests/engine/x/a_test.cpp"]


def problems_of(texts, exempt=None, not_yet=frozenset()):
    """What tested.py says of a tree that holds these files."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path, text in texts.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text, encoding="utf-8")
        return tested.check(root, exempt or {}, set(not_yet))[0]


class Tested(unittest.TestCase):
    def test_three_decisions_want_a_test(self):
        self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES}), UNTESTED)
        self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES.replace("for (;;)", "")}), [])
        self.assertEqual(problems_of({"tools/a.cpp": DECIDES}), [])

    def test_texts_and_comments_decide_nothing(self):
        words = '// if for while\nconst char* a = "if (this) ? that";\nconst char* b = R"(for while switch)";\n'
        self.assertEqual(problems_of({"engine/x/a.cpp": words}), [])

    def test_the_mirrored_place(self):
        for name in ("tests/engine/x/a_test.cpp", "tests/engine/x/a_gl_test.cpp"):
            self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES, name: ""}), [])
        for name in ("tests/engine/y/a_test.cpp", "tests/engine/x/ab_test.cpp"):
            self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES, name: ""}), UNTESTED)

    def test_its_own_header(self):
        include = '#include "engine/x/a.h"\n'
        self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES, "tests/engine/x/rig.h": include}), [])
        self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES, "tests/engine/x/rig.h": "// " + include}), UNTESTED)
        self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES, "engine/y/b.h": include}), UNTESTED)

    def test_entries_that_are_not_needed_go(self):
        self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES}, exempt={"engine/x/a.cpp": "a table"}), [])
        self.assertEqual(problems_of({"engine/x/a.cpp": DECIDES}, not_yet={"engine/x/a.cpp"}), [])
        both = {"engine/x/a.cpp": DECIDES, "tests/engine/x/a_test.cpp": ""}
        start = "tests/architecture/tested.py: engine/x/a.cpp needs no entry any more: strike it off "
        self.assertEqual(problems_of(both, exempt={"engine/x/a.cpp": "a table"}), [start + "EXEMPT"])
        self.assertEqual(problems_of(both, not_yet={"engine/x/a.cpp"}), [start + "NOT_YET"])


if __name__ == "__main__":
    unittest.main()
