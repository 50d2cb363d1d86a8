#!/usr/bin/python3
"""Every header of engine/ and game/ compiles alone: unity builds and the precompiled header hide what one lacks.

    headers.py BUILD [HEADER ...]     BUILD is a build folder, configured, as for tidy.py
"""

import concurrent.futures
import os
import pathlib
import subprocess
import sys

from sources import ROOT, finish, own_files
from tidy import options_of


def faults_of(header, options):
    """What g++ says of a source file that includes this header and nothing else."""
    done = subprocess.run(["g++", *options, "-fsyntax-only", "-w", f"-I{ROOT}", "-"], cwd=ROOT, capture_output=True,
                          text=True, check=False, input=f'#include "{header}"\n')
    return [] if done.returncode == 0 else [f"{header} does not compile alone:\n{done.stderr.strip()}"]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    options = options_of(pathlib.Path(sys.argv[1]))
    headers = sys.argv[2:] or own_files(ROOT, "engine", "game", suffixes=(".h",))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        problems = [fault for found in workers.map(lambda header: faults_of(header, options), headers) for fault in found]
    finish(problems, f"{len(headers)} headers")


if __name__ == "__main__":
    main()
