#!/usr/bin/python3
"""docs/FAULTS.md: every row is there once, and every test that it names is in the tree.

A test is `path:Suite.Name` (GoogleTest), `path:function` (Python), or a whole file, in backticks. A
row without one says why behind "none:".
"""

import re

from sources import ROOT, finish

PAGE = "docs/FAULTS.md"
# The groups of bad input and how many rows each has; numbers alone are what broke when it was tried.
GROUPS = {"": 33, "A": 18, "B": 9, "C": 15, "D": 21, "E": 14, "F": 24, "G": 26, "H": 20, "I": 14, "J": 10, "K": 6, "N": 83}
ROW = re.compile(r"^\| ([A-KN]?\d+) \|(.*)\|$", re.M)
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


def problems(page, wanted, rows):
    """What is wrong with a page's table: `wanted` are the numbers it must have, `rows` pairs of number and cells."""
    ids = [row for row, _ in rows]
    yield from (f"{page}: no row {row}" for row in wanted if row not in ids)
    yield from (f"{page}: a row {row} too many" for row in ids if row not in wanted or ids.count(row) > 1)
    for row, cells in rows:
        tests = TEST.findall(cells)
        if not tests and "none: " not in cells:
            yield f"{page}: row {row} has neither a test nor a reason"
        for path, name in tests:
            if not is_there(path, name):
                yield f"{page}: row {row}: there is no test {path} {name}"


def numbered(groups):
    return [f"{group}{number}" for group, most in groups.items() for number in range(1, most + 1)]


def check(page, groups, row):
    """Ends the program. `groups` says how many rows each has; `row` matches a row's number and cells."""
    rows = row.findall((ROOT / page).read_text(encoding="utf-8"))
    finish(list(problems(page, numbered(groups), rows)), f"{len(rows)} rows of {page}")


if __name__ == "__main__":
    check(PAGE, GROUPS, ROW)
