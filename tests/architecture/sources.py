"""What the architecture tests share: the repository's own files, and a way to fail."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def own_files(root, *folders, suffixes=()):
    """Files below `folders` that belong to the repository, as paths relative to `root`.

    Asks git, new files included; without git (a released archive) every file that is there counts.
    """
    listed = subprocess.run(
        ["git", "-C", str(root), "ls-files", "--cached", "--others", "--exclude-standard", *folders],
        capture_output=True, text=True, check=False)
    if listed.returncode == 0 and listed.stdout:
        names = listed.stdout.splitlines()
    else:
        names = [str(path.relative_to(root))
                 for folder in folders for path in (root / folder).rglob("*") if path.is_file()]
    wanted = [name for name in sorted(names) if not suffixes or name.endswith(suffixes)]
    return [name for name in wanted if (root / name).is_file()]


def finish(problems, what_was_checked):
    """Prints each problem on a line of its own and ends the program: 1 where there is any."""
    for problem in problems:
        print(problem)
    print(f"{what_was_checked}: {len(problems)} problem{'' if len(problems) == 1 else 's'}")
    sys.exit(1 if problems else 0)
