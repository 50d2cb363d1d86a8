#!/usr/bin/python3
"""clang-tidy 14 with .clang-tidy, one process for each core.

    tidy.py BUILD            what differs from the last landed state, and what is not committed
    tidy.py BUILD --all      every source file of engine/ and game/
    tidy.py BUILD --alone    of each module the source that was changed last, compiled by itself with the build's compiler

BUILD is a build folder, configured: its compile_commands.json says where libraries are. The last landed state is
$PLUMBLINE_LANDED, or else where this branch left its upstream, origin's HEAD or main. On that state itself, as in a fresh
clone, the RECENT sources that were committed last are checked. A changed header is checked with the source file of its name.

Unity builds share includes and options between files; --alone finds a source that leans on its neighbours.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from sources import ROOT, own_files

SKIPPED = 77
PROGRAM = "clang-tidy-14"
FOLDERS = ("engine", "game")
RECENT = 4  # sources


def git(*words):
    done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, check=False)
    return done.stdout.strip() if done.returncode == 0 else ""


def landed():
    """The commit that the work here began from, or "" where nothing tells."""
    for name in (os.environ.get("PLUMBLINE_LANDED", ""), "@{upstream}", "origin/HEAD", "main"):
        base = git("merge-base", "HEAD", name) if name else ""
        if base:
            return base
    return ""


def changed(base):
    names = git("diff", "--name-only", base).splitlines()
    names += git("ls-files", "--others", "--exclude-standard", *FOLDERS).splitlines()
    return sorted({name for name in names if name.split("/")[0] in FOLDERS and (ROOT / name).is_file()})


def committed_last(folders, most):
    """The sources below `folders` that were committed last, at most so many, the newest first."""
    names = git("log", "-n", "200", "--no-renames", "--format=", "--name-only", "--", *folders).splitlines()
    sources = [name for name in dict.fromkeys(names) if name.endswith(".cpp") and (ROOT / name).is_file()]
    return sources[:most]


def sources_of(names):
    """The source files that show what `names` say; a header alone is checked as it is."""
    found = set()
    for name in names:
        if name.endswith(".cpp"):
            found.add(name)
        elif name.endswith(".h"):
            of_its_name = re.sub(r"(_impl)?\.h$", ".cpp", name)
            found.add(of_its_name if (ROOT / of_its_name).is_file() else name)
    return sorted(found)


def options_of(build):
    """Where headers are and what is defined, of all that is built: clang-tidy shares one set of options, as unity
    builds and precompiled headers do not name single files."""
    options = []
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        words = shlex.split(entry["command"])
        for at, word in enumerate(words):
            pair = ["-isystem", words[at + 1]] if word == "-isystem" else [word]
            is_wanted = word == "-isystem" or word.startswith(("-I", "-D"))
            if is_wanted and "DOUBLE_PRECISION" not in word and pair not in options:
                options.append(pair)
    return ["-std=c++20", "-xc++", *(word for pair in options for word in pair)]


def said_by(command):
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    said = [line for line in (done.stdout + (done.stderr if done.returncode != 0 else "")).splitlines() if line.strip()]
    return said or ([f"{command[0]}: exit {done.returncode}"] if done.returncode != 0 else [])


def compile_alone(build):
    """The source of each module that was changed last, without its neighbours and the precompiled header."""
    modules = [*(f"engine/{folder.name}" for folder in sorted((ROOT / "engine").iterdir()) if folder.is_dir()), "game"]
    names = [name for module in modules for name in committed_last([module], 1) or own_files(ROOT, module, suffixes=(".cpp",))[:1]]
    compiler = shlex.split(json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))[0]["command"])[0]
    compiler = compiler.replace("gcc", "g++").replace("/cc", "/c++")
    command = [compiler, "-fsyntax-only", *options_of(build)]
    return names, lambda name: said_by([*command, str(ROOT / name)])


def names_to_check(everything):
    if everything:
        return own_files(ROOT, *FOLDERS, suffixes=(".cpp",))
    base = landed()
    return sources_of(changed(base)) or committed_last(FOLDERS, RECENT) if base else []


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1])
    if "--alone" in sys.argv[2:]:
        names, check = compile_alone(build)
    else:
        if shutil.which(PROGRAM) is None:
            print(f"not checked: {PROGRAM} is not installed (cmake/packages.txt names it)")
            return SKIPPED
        names = names_to_check("--all" in sys.argv[2:])
        options = options_of(build)
        check = lambda name: said_by([PROGRAM, "--quiet", str(ROOT / name), "--", *options])
    if not names:
        print("not checked: nothing tells the last landed state (set PLUMBLINE_LANDED to a commit)")
        return SKIPPED
    seen = set()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        for said in workers.map(check, names):
            text = "\n".join(said)
            for found in re.split(r"\n(?=/[^ ]+:\d+:\d+: (?:error|warning))", text):
                if found and found not in seen:  # a header's, with each of its users
                    seen.add(found)
                    print(found.replace(f"{ROOT}/", ""), flush=True)
    print(f"{len(names)} files: {len(seen)} finding{'' if len(seen) == 1 else 's'}")
    return 1 if seen else 0


if __name__ == "__main__":
    sys.exit(main())
