#!/usr/bin/python3
"""docs/SOURCES.md: every row of a source that has a part there is there once, and its tests exist.

Tests are named as in docs/FAULTS.md (see faults.py); a row without one says why behind "none:".
"""

import re

from faults import check
from sources import ROOT

PAGE = "docs/SOURCES.md"
# How many rows each source has.
SOURCES = {"A": 41, "B": 37, "C": 25}
ROW = re.compile(r"^\| ([ABC]\d+) \|(.*)\|$", re.M)

if __name__ == "__main__":
    there = {number[0] for number, _ in ROW.findall((ROOT / PAGE).read_text(encoding="utf-8"))}
    check(PAGE, {source: most for source, most in SOURCES.items() if source in there}, ROW)
