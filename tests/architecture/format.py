#!/usr/bin/python3
"""Fails where clang-format 14 would change a file. Fix: clang-format-14 -i FILE."""

import concurrent.futures
import os
import shutil
import subprocess
import sys

from sources import ROOT, finish, own_files

FORMATTER = "clang-format-14"  # other versions format differently
SKIPPED = 77  # the exit status that CTest is told to read as "skipped"


def complaints(paths):
    """The formatter's first complaint about each file."""
    done = subprocess.run([FORMATTER, "--dry-run", "-Werror", *paths],
                          cwd=ROOT, capture_output=True, text=True, check=False)
    first = {}
    for line in done.stderr.splitlines():
        path = line.split(":")[0]
        if path in paths:
            first.setdefault(path, line)
    return list(first.values()) or done.stderr.splitlines()[:1] if done.returncode else []


if __name__ == "__main__":
    if shutil.which(FORMATTER) is None:
        print(f"{FORMATTER} is not installed")
        sys.exit(SKIPPED)
    files = own_files(ROOT, "engine", "game", "tests", suffixes=(".h", ".cpp"))
    shares = [files[first::16] for first in range(16)]  # a process for each file takes ten times as long
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [line for lines in pool.map(complaints, shares) for line in lines]
    finish(found, f"format of {len(files)} files")
