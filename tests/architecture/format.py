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


def complaints(path):
    """The formatter's first complaint about one file, or nothing."""
    done = subprocess.run([FORMATTER, "--dry-run", "-Werror", path],
                          cwd=ROOT, capture_output=True, text=True, check=False)
    return done.stderr.splitlines()[:1] if done.returncode else []


if __name__ == "__main__":
    if shutil.which(FORMATTER) is None:
        print(f"{FORMATTER} is not installed")
        sys.exit(SKIPPED)
    files = own_files(ROOT, "engine", "game", "tests", suffixes=(".h", ".cpp"))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [line for lines in pool.map(complaints, files) for line in lines]
    finish(found, f"format of {len(files)} files")
