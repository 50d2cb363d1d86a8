#!/usr/bin/python3
"""What one place of the sources owns, and nobody else does beside it.

core/process/process.cpp starts, waits for and ends processes, and has the pipes to them. engine/scene builds worlds of
scenes: everybody else opens them with scene::open_scene(), which misses none of the files that take part.
"""

import re

from sources import ROOT, finish, own_files

COMMENT = re.compile(r"//.*")

# (owner, pattern, lines that it finds, lines that it does not)
OWNED = [
    (("engine/core/process/process.cpp", "engine/core/process/sandbox.cpp"),
     re.compile(r"#\s*include\s*<((?:sys/)?(?:poll|wait|prctl|select|epoll)|spawn|sched)\.h>"
                r"|(?<![\w.>:])(?:::)?((?:v?fork|clone3?|posix_spawnp?|exec[vl]p?e?|wait(?:pid|id|3|4)|p?poll"
                r"|p?select|pipe2?|dup[23]?|prctl|popen|system|kill(?:pg)?|socketpair)\s*\()"),
     ["#include <poll.h>", "#include <sys/wait.h>", "    if (fork() == 0) {", "poll(&file, 1, 0);",
      "const int error = posix_spawnp(&pid,", "return ::kill(pid, SIGKILL);", "x = dup2(a, b);",
      "std::array<int, 2> e; pipe2(e.data(), O_CLOEXEC);"],
     ["#include <unistd.h>", "pipeline(a);", "// fork() is not ours", "window.poll();", "run_system(1);",
      "glfwPollEvents();", "Result<Done> files::select(int);"]),
    ("engine/scene/",
     re.compile(r"\bbuild_simulation\s*\("),
     ["auto built = scene::build_simulation(scene, {}, library, surfaces);"],
     ["/// what build_simulation() refuses", "opened->build(library);", "rebuild_simulation(x);"]),
]


def problems_of(name):
    for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").splitlines(), start=1):
        for owner, pattern, _, _ in OWNED:
            found = pattern.search(COMMENT.sub("", line))
            if found and not name.startswith(owner):
                yield f"{name}:{number}: {found.group(0).strip(' (')} is for {owner if isinstance(owner, str) else ' and '.join(owner)} alone"


if __name__ == "__main__":
    problems = []
    for owner, pattern, found, left in OWNED:
        for line in found + left:
            if bool(pattern.search(COMMENT.sub("", line))) != (line in found):
                problems.append(f"the check itself is wrong about: {line}")
        own = "".join((ROOT / name).read_text(encoding="utf-8")
                      for name in own_files(ROOT, *([owner] if isinstance(owner, str) else owner), suffixes=(".cpp",)))
        if not pattern.search(own):
            problems.append(f"{owner} has none of what it is to own")
    checked = own_files(ROOT, "engine", "game", suffixes=(".cpp", ".h"))
    problems += [problem for name in checked for problem in problems_of(name)]
    finish(problems, f"{len(checked)} files about what others own")
