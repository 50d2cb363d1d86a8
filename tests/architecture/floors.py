#!/usr/bin/python3
"""Order of the folders inside each module: an include leads to the same folder or to a lower one.

A file in a module's root stands on the highest floor of what it includes: plain data that others include is low, what
joins the folders is high. So no folder includes, even through the root, what includes it.
"""

import pathlib
import sys

from layers import INCLUDE, module_of
from sources import ROOT, finish, own_files

# Module -> its folders, the lowest first. Modules without folders have none to order.
FLOORS = {
    "core": ["time", "threads", "process", "io", "text"],
    "assets": ["image", "model", "gltf", "mesh_files", "foreign"],
    "physics": ["collision/shape", "collision/narrow_phase", "collision/mesh", "collision", "collision/sweep", "dynamics/joint/block", "dynamics/joint", "dynamics/contact",
                "dynamics/impact", "dynamics", "deformable", "world", "bullet/shape", "bullet/contact", "bullet/archive", "bullet",
                "copy", "fracture", "character"],
    "render": ["gl", "shaders", "culling", "resources", "sky", "light", "setup", "passes", "passes/screen"],
    "scene": ["environment", "formats", "paths", "sections", "sections/fields", "json_scene", "build", "level", "gltf_scene", "simulation"],
    "effects": ["light", "nature", "fields", "physics", "sound", "screen"],
    "study": ["findings", "fields", "image", "report", "workers", "scenarios/world", "scenarios", "scenarios/families", "engines", "gallery", "ghost",
              "scenes", "auto_preset"],
    "app": ["capture", "settings", "controls", "accuracy", "ui", "overlay", "frame"],
    "game": ["command_line", "rules/hands", "rules", "offscreen", "commands/export", "commands/study", "commands"],
}

# Pairs of folders of one module where the first still includes from the second, which is higher. An entry that is not
# needed any more fails, so that it goes.
STILL_UPWARD = {
    ("physics", "bullet/archive", "bullet"),
    ("physics", "bullet/contact", "bullet"),
    ("physics", "bullet/shape", "bullet"),
    ("physics", "collision", "world"),
    ("physics", "collision/sweep", "dynamics"),
    ("physics", "collision/sweep", "world"),
    ("physics", "dynamics", "bullet"),
    ("physics", "dynamics", "world"),
    ("physics", "dynamics/contact", "dynamics"),
    ("physics", "dynamics/joint", "dynamics"),
    ("physics", "world", "bullet"),
    ("physics", "world", "bullet/archive"),
    ("physics", "world", "bullet/contact"),
    ("physics", "world", "bullet/shape"),
}


def folder_of(path):
    """A file's folder inside its module; "" is the module's root."""
    parts = pathlib.PurePosixPath(path).parts
    return "/".join(parts[2:-1] if parts[0] == "engine" else parts[1:-1])


def includes_of(root, files):
    """Path -> the files of the same module that it includes, with their lines."""
    found = {}
    for path in files:
        lines = (root / path).read_text(encoding="utf-8").splitlines()
        named = [(number, match.group(1)) for number, line in enumerate(lines, start=1) if (match := INCLUDE.match(line))]
        found[path] = [(number, name) for number, name in named
                       if name and name in files and module_of(name) == module_of(path)]
    return found


def check(root, floors, still_upward):
    """Every problem in the tree at `root`, and what was checked in words."""
    files = set(own_files(root, "engine", "game", suffixes=(".h", ".cpp")))
    includes = includes_of(root, files)
    problems, upward = [], set()
    for folder in sorted({(module_of(path), folder_of(path)) for path in files if folder_of(path)}):
        if folder[1] not in floors.get(folder[0], []):
            problems.append(f"{folder[0]}/{folder[1]} is in no list of tests/architecture/floors.py")
    heights = {}

    def height(path):
        """The floor a file stands on; of one in the root, the highest floor that it includes from."""
        if folder_of(path):
            order = floors.get(module_of(path), [])
            return order.index(folder_of(path)) if folder_of(path) in order else -1
        if path not in heights:
            heights[path] = -1  # files that include each other in a circle see this
            heights[path] = max([height(name) for _, name in includes[path]], default=-1)
        return heights[path]

    for path in sorted(files):
        for number, name in includes[path]:
            if folder_of(path) and height(name) > height(path):
                order = floors[module_of(path)]
                arrow = (module_of(path), folder_of(path), order[height(name)])
                upward.add(arrow)
                if arrow not in still_upward:
                    problems.append(f"{path}:{number}: {arrow[1]} must not include {name}: {arrow[2]} is above it")
    problems += [f"tests/architecture/floors.py: {module}/{low} includes nothing from {high} any more: strike it off"
                 for module, low, high in sorted(still_upward - upward)]
    return problems, f"floors of {len(floors)} modules, {len(upward)} pairs of folders still upward"


if __name__ == "__main__":
    checked_root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    finish(*check(checked_root, FLOORS, STILL_UPWARD))
