#!/usr/bin/python3
"""docs/SOURCES.md: every row of a source that has a part there is there once, and its tests exist.

Tests are named as in docs/FAULTS.md (see faults.py); a row without one says why behind "none:".
"""

import re

from faults import TEST, is_there
from sources import ROOT, finish

PAGE = ROOT / "docs/SOURCES.md"
# How many rows each source has.
SOURCES = {"A": 41, "B": 37, "C": 25}
ROW = re.compile(r"^\| ([ABC])(\d+) \|(.*)\|$", re.M)


def problems(text):
    rows = ROW.findall(text)
    ids = [source + number for source, number, _ in rows]
    for source in dict.fromkeys(source for source, _, _ in rows):
        wanted = [f"{source}{number}" for number in range(1, SOURCES[source] + 1)]
        yield from (f"docs/SOURCES.md: no row {row}" for row in wanted if row not in ids)
        yield from (f"docs/SOURCES.md: a row {row} too many"
                    for row in ids if row[0] == source and (row not in wanted or ids.count(row) > 1))
    for source, number, cells in rows:
        tests = TEST.findall(cells)
        if not tests and "none: " not in cells:
            yield f"docs/SOURCES.md: row {source}{number} has neither a test nor a reason"
        for path, name in tests:
            if not is_there(path, name):
                yield f"docs/SOURCES.md: row {source}{number}: there is no test {path} {name}"


if __name__ == "__main__":
    page = PAGE.read_text(encoding="utf-8")
    finish(list(problems(page)), f"{len(ROW.findall(page))} rows of docs/SOURCES.md")
