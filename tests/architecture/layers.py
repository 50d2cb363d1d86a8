#!/usr/bin/python3
"""Reads every #include of engine/ and game/ and fails on an edge that the tables do not have.

The tables are those of docs/ARCHITECTURE.md. A new edge or library is a decision: change them
together, with a note in docs/adr/.
"""

import re
import sys
import pathlib

from sources import ROOT, finish, own_files

# Module -> engine modules that it may include, besides itself.
FOUNDATION = {"core"}
WORLD = FOUNDATION | {"ecs", "assets", "physics", "audio", "render", "scene"}
MAY_INCLUDE = {
    "core": set(),
    "ecs": FOUNDATION,
    "platform": FOUNDATION,
    "input": FOUNDATION,
    "assets": FOUNDATION,
    "physics": FOUNDATION,
    "bullet_world": FOUNDATION | {"physics"},
    "audio": FOUNDATION | {"assets"},
    "render": FOUNDATION | {"assets"},
    "scene": WORLD,
    "effects": WORLD | {"effects"},
    "study": WORLD | {"effects", "study"},
    "app": WORLD | {"effects", "study", "app", "platform", "input"},
    "game": WORLD | {"effects", "study", "app", "platform", "input"},
}

# Modules whose folders are private: only the headers beside their CMakeLists.txt are for others.
PRIVATE_FOLDERS = {"physics"}

# Start of a library's headers -> the folders outside of which no file sees them, not even through
# another header.
BULLET = ("engine/physics/bullet/", "engine/bullet_world/")
CONFINED = {"bullet/": BULLET, "bt": BULLET, "Bullet": BULLET, "LinearMath/": BULLET}
# Names of a library's types -> the same: not even declared outside.
CONFINED_NAME = re.compile(r"\bbt[A-Z]\w+")
COMMENT = re.compile(r"//.*")

# Start of a third-party header -> modules that own it. GLM and fmt are everybody's.
ANY = set(MAY_INCLUDE)
THIRD_PARTY = {
    "glm/": ANY,
    "fmt/": ANY,
    "spdlog/": {"core"},
    "xxhash.h": {"core"},
    "GLFW/": {"platform"},
    "EGL/": {"platform"},
    "assimp/": {"assets"},
    "png.h": {"assets"},
    "jpeglib.h": {"assets"},
    "jerror.h": {"assets"},
    "OpenEXR/": {"assets"},
    "Imath": {"assets"},
    "Imf": {"assets"},
    "sndfile": {"assets"},
    "stb/": {"assets"},
    "stb_": {"assets"},
    "meshoptimizer.h": {"assets"},
    "bullet/": {"physics", "bullet_world"},
    "bt": {"physics", "bullet_world"},
    "Bullet": {"physics", "bullet_world"},
    "LinearMath/": {"physics", "bullet_world"},
    "AL/": {"audio"},
    "glad/": {"render"},
    "toml++/": {"input", "scene", "app"},
    "embree3/": {"render"},
    "nlohmann/": {"assets", "scene", "effects", "study", "app", "game"},
    "imgui": {"app"},
    "backends/imgui": {"app"},
    "CLI/": {"game"},
}
EVERYWHERE = {"glm/", "fmt/"}  # in public headers too
# Modules whose public headers extend a library's own types.
EXTENDS = {"bullet_world": {"bt", "Bullet"}}

# What the language and the operating system bring: any header without one of the prefixes above
# must be one of these.
SYSTEM = re.compile(
    r"^([a-z_]+|c[a-z]+"  # <vector>, <cmath>
    r"|(sys|linux|netinet)/[a-z_]+\.h"
    r"|(dlfcn|errno|execinfo|fcntl|malloc|poll|pthread|sched|signal|spawn|stdlib|string|time|unistd|setjmp)\.h)$")

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


def module_of(path):
    """engine/physics/body.h -> physics; game/main.cpp -> game."""
    parts = pathlib.PurePosixPath(path).parts
    return parts[1] if parts[0] == "engine" else parts[0]


def owners_of(header):
    """The prefix that a third-party header falls under and the modules that may use it."""
    matching = [prefix for prefix in THIRD_PARTY if header.startswith(prefix)]
    if not matching:
        return None, None
    prefix = max(matching, key=len)
    return prefix, THIRD_PARTY[prefix]


def is_private(path):
    """Whether a header is its module's own: by its folder or, where a module has no such, its name."""
    parts = pathlib.PurePosixPath(path).parts
    return path.endswith("_impl.h") or (module_of(path) in PRIVATE_FOLDERS and len(parts) > 3)


def is_public_header(path):
    return path.endswith(".h") and not is_private(path)


def problem_with_own(path, included):
    """An include in quotes: from the repository's root, along an allowed edge."""
    parts = pathlib.PurePosixPath(included).parts
    if parts[:2] == ("shaders", "shared"):
        return None if module_of(path) == "render" else "only render shares headers with the shaders"
    if parts[0] not in ("engine", "game") or len(parts) < 2:
        return "includes in quotes begin at the repository's root: engine/... or game/..."
    source, target = module_of(path), module_of(included)
    if target == source:
        if is_public_header(path) and is_private(included):
            return "a public header must not include a private one"
        return None
    if target == "game":
        return "the engine never includes the game"
    if source not in MAY_INCLUDE:
        return f"module {source} is not in the table"
    if target not in MAY_INCLUDE[source]:
        return f"{source} must not include {target}"
    if is_private(included):
        return f"{included} is private to {target}"
    return None


def problem_with_foreign(path, included):
    """An include in angle brackets: the system's, or a library that this module owns."""
    prefix, owners = owners_of(included)
    if prefix is None:
        return None if SYSTEM.match(included) else f"{included} is in no table"
    module = module_of(path)
    if module not in owners:
        return f"{module} must not include {included}; it belongs to {', '.join(sorted(owners))}"
    if is_public_header(path) and prefix not in EVERYWHERE | EXTENDS.get(module, set()):
        return f"{included} must stay in .cpp files and private headers"
    return None


def confined_to(header):
    """The folder that a library's header is confined to, or none."""
    matching = [prefix for prefix in CONFINED if header.startswith(prefix)]
    return CONFINED[max(matching, key=len)] if matching else None


def problems_with_confined(includes):
    """Files that see a confined library from outside its folder. `includes`: path -> what it names."""
    seen_through = {}  # path -> the folders whose library it sees

    def folders_seen_by(path, on_the_way=()):
        if path not in seen_through and path not in on_the_way:
            for _, own, foreign in includes.get(path, ()):
                folders = (confined_to(foreign) if foreign
                           else folders_seen_by(own, on_the_way + (path,)))
                if folders:
                    seen_through[path] = folders
                    break
            else:
                seen_through[path] = None
        return seen_through.get(path)

    for path, lines in includes.items():
        for number, own, foreign in lines:
            name = own or foreign
            folders = folders_seen_by(own) if own else confined_to(foreign)
            if folders and not path.startswith(folders):
                yield f"{path}:{number}: {name} shows what only {' and '.join(folders)} may see"


def problems_of_tests(root):
    """Tests of other modules that include what is private to one."""
    for path in own_files(root, "tests", suffixes=(".h", ".cpp")):
        lines = (root / path).read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines, start=1):
            found = INCLUDE.match(line)
            included = found.group(1) if found else None
            if not included or not included.startswith("engine/"):
                continue
            module = module_of(included)
            if module in PRIVATE_FOLDERS and is_private(included) \
                    and not path.startswith(f"tests/engine/{module}/"):
                yield f"{path}:{number}: {included} is private to {module}"


def check(root):
    """Every problem in the tree at `root`, and how many files were read."""
    files = own_files(root, "engine", "game", suffixes=(".h", ".cpp"))
    problems = list(problems_of_tests(root))
    includes = {}
    for path in files:
        lines = (root / path).read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines, start=1):
            found = INCLUDE.match(line)
            if not found:
                named = CONFINED_NAME.search(COMMENT.sub("", line))
                if named and not path.startswith(BULLET):
                    problems.append(f"{path}:{number}: {named.group()} is named outside "
                                    f"{' and '.join(BULLET)}")
                continue
            own, foreign = found.groups()
            includes.setdefault(path, []).append((number, own, foreign))
            problem = problem_with_own(path, own) if own else problem_with_foreign(path, foreign)
            if problem:
                problems.append(f"{path}:{number}: {problem}")
    problems.extend(problems_with_confined(includes))
    if not files:
        problems.append(f"{root}: no sources found in engine/ and game/")
    return problems, len(files)


if __name__ == "__main__":
    checked_root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    found_problems, file_count = check(checked_root)
    finish(found_problems, f"includes of {file_count} files")
