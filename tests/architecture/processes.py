#!/usr/bin/python3
"""Only core/process.cpp starts, waits for and ends processes, and owns the pipes to them."""

import re

from sources import ROOT, finish, own_files

OWNER = "engine/core/process.cpp"
HEADERS = re.compile(r"#\s*include\s*<((?:sys/)?(?:poll|wait|prctl|select|epoll)|spawn|sched)\.h>")
CALLS = re.compile(r"(?<![\w.>:])(?:::)?((?:v?fork|clone3?|posix_spawnp?|exec[vl]p?e?|wait(?:pid|id|3|4)|p?poll"
                   r"|p?select|pipe2?|dup[23]?|prctl|popen|system|kill(?:pg)?|socketpair)\s*\()")
COMMENT = re.compile(r"//.*")

# What the patterns are worth: these lines are found, those are not.
FOUND = ["#include <poll.h>", "#include <sys/wait.h>", "    if (fork() == 0) {", "poll(&file, 1, 0);",
         "const int error = posix_spawnp(&pid,", "return ::kill(pid, SIGKILL);", "x = dup2(a, b);",
         "std::array<int, 2> e; pipe2(e.data(), O_CLOEXEC);"]
LEFT = ["#include <unistd.h>", "pipeline(a);", "// fork() is not ours", "window.poll();", "run_system(1);",
        "glfwPollEvents();", "Result<Done> files::select(int);"]


def found_in(line):
    return HEADERS.search(line) or CALLS.search(COMMENT.sub("", line))


def problems_of(name):
    for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").splitlines(), start=1):
        found = found_in(line)
        if found:
            yield f"{name}:{number}: {found.group(1).rstrip('( ')} is for {OWNER} alone"


if __name__ == "__main__":
    problems = [f"the check itself does not find: {line}" for line in FOUND if not found_in(line)]
    problems += [f"the check itself finds: {line}" for line in LEFT if found_in(line)]
    checked = own_files(ROOT, "engine", "game", suffixes=(".cpp", ".h"))
    problems += [problem for name in checked if name != OWNER for problem in problems_of(name)]
    if not list(problems_of(OWNER)):
        problems.append(f"{OWNER} has none of it: does it still own processes?")
    finish(problems, f"{len(checked)} files about processes")
