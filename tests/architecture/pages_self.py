#!/usr/bin/python3
"""Proves that pages.py sees a folder without a line, a line without a folder, and a walk that goes astray."""

import pathlib
import tempfile
import unittest

import pages

FILES = ("engine/core/a.cpp", "engine/core/io/b.h", "engine/render/c.cpp", "game/main.cpp", "tests/e2e/run.py",
         "tests/engine/core/a_test.cpp")
FOLDERS = ["engine/core/      numbers", "engine/core/io/   files", "engine/render/    frames", "game/             play",
           "tests/e2e/        from outside"]
STEPS = ["1. `game/main.cpp` `f`: begins", "2. `engine/render/c.cpp` `f`: goes on", "3. `engine/core/a.cpp` `f`: goes on",
         "4. `engine/core/io/b.h` `f`: ends"]


def problems_of(folders=FOLDERS, steps=STEPS, walks=4):
    """What pages.py says of a small tree whose page has these lines."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path in (*FILES, pages.PAGE):
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text("void f();\n", encoding="utf-8")
        (root / pages.PAGE).write_text("\n".join(
            ["## Folders", "```", *folders, "```", "## Four walks",
             *(f"### {i}\n" + "\n".join(steps) for i in range(walks)), "## More", "engine/none/ of no matter"]), encoding="utf-8")
        return pages.check(root)


class Pages(unittest.TestCase):
    def test_all_there(self):
        self.assertEqual(problems_of(), [])

    def test_folders(self):
        self.assertEqual(problems_of(FOLDERS[1:]), [f"{pages.PAGE}: no line for engine/core/"])
        self.assertEqual(problems_of([*FOLDERS, FOLDERS[0]]), [f"{pages.PAGE}: engine/core/ has 2 lines"])
        self.assertEqual(problems_of([*FOLDERS, "engine/old/ what was"]), [f"{pages.PAGE}: engine/old/ is no folder of sources"])

    def test_walks(self):
        def walk(steps):
            return sorted(set(problem.split(": ", 2)[2] for problem in problems_of(steps=steps)))
        self.assertEqual(problems_of(walks=3), [f"{pages.PAGE}: 3 walks; expected 4"])
        self.assertEqual(walk([STEPS[0].replace("`f`", "`g`"), *STEPS[1:]]), ["game/main.cpp has no g()"])
        self.assertEqual(walk([STEPS[0].replace("main", "gone"), *STEPS[1:]]), ["game/gone.cpp is not there"])
        self.assertEqual(walk([*STEPS, "5. `engine/render/c.cpp` `f`: again"]), ["comes back to render"])
        self.assertEqual(walk(STEPS[:2] + STEPS[3:]), ["its steps are not numbered `file` `function`: …"])


if __name__ == "__main__":
    unittest.main()
