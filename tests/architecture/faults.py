#!/usr/bin/python3
"""docs/FAULTS.md: every row is there once, and every test that it names is in the tree.

A test is `path:Suite.Name` (GoogleTest), `path:function` (Python), or a whole file, in backticks. A
row without one says why behind "none:".
"""

import re

from sources import ROOT, finish

PAGE = ROOT / "docs/FAULTS.md"
# The groups of bad input and how many rows each has; numbers alone are what broke when it was tried.
GROUPS = {"": 33, "A": 18, "B": 9, "C": 15, "D": 21, "E": 14, "F": 24, "G": 26, "H": 20, "I": 14}
ROW = re.compile(r"^\| ([A-I]?\d+) \|(.*)\|$")
TEST = re.compile(r"`(tests/[^`:]+)(?::([\w.]+))?`")


def is_there(path, name):
    if not (ROOT / path).is_file():
        return False
    if not name:
        return True
    text = (ROOT / path).read_text(encoding="utf-8")
    if path.endswith(".py"):
        return re.search(rf"^def {re.escape(name)}\(", text, re.M) is not None
    suite, _, test = name.partition(".")
    return re.search(rf"^TEST\w*\(\s*{re.escape(suite)},\s*{re.escape(test)}\s*\)", text, re.M) is not None


def problems(rows):
    wanted = [f"{group}{number}" for group, most in GROUPS.items() for number in range(1, most + 1)]
    ids = [row for row, _ in rows]
    yield from (f"docs/FAULTS.md: no row {row}" for row in wanted if row not in ids)
    yield from (f"docs/FAULTS.md: a row {row} too many" for row in ids if row not in wanted or ids.count(row) > 1)
    for row, text in rows:
        tests = TEST.findall(text)
        if not tests and "none: " not in text:
            yield f"docs/FAULTS.md: row {row} has neither a test nor a reason"
        for path, name in tests:
            if not is_there(path, name):
                yield f"docs/FAULTS.md: row {row}: there is no test {path} {name}"


if __name__ == "__main__":
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    found = [ROW.match(line).groups() for line in lines if ROW.match(line)]
    finish(list(problems(found)), f"{len(found)} rows of docs/FAULTS.md")
