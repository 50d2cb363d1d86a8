#!/usr/bin/env python3
"""`cmake --install` into an empty prefix, and the program that lies there then.

EXPERIENCE I7: no HOME, an unrelated current folder, an installed folder that nobody may write.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

build = pathlib.Path(sys.argv[1])
source = pathlib.Path(sys.argv[2])
folder = pathlib.Path(tempfile.mkdtemp())
prefix = folder / "a prefix"
elsewhere = folder / "elsewhere"
elsewhere.mkdir()
BARE = {"PATH": "/usr/bin:/bin", "ALSOFT_DRIVERS": "null"}  # no HOME, no XDG_..., no display
PROGRAMS = ("plumbline", "plumbline-f64")


def run(*words, code=0, says="", of="plumbline", **changes):
    done = subprocess.run([prefix / "bin" / of, *map(str, words)], cwd=elsewhere, env={**BARE, **changes},
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=200)
    output = done.stdout + done.stderr
    assert done.returncode == code, f"{of} {words}: exit {done.returncode}, expected {code}\n{output}"
    assert says in output, f"{of} {words}: expected to read {says!r} in\n{output}"
    return done


def everything_below(root):
    return {str(path.relative_to(root)): (path.stat().st_mtime_ns, path.stat().st_size)
            for path in sorted(root.rglob("*")) if path.is_file()}


def install():
    subprocess.run(["cmake", "--install", build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)


def what_is_there():
    there = set(everything_below(prefix))
    data = "share/plumbline/"
    for name in [f"bin/{program}" for program in PROGRAMS] + [
            data + "assets/scenes/garden.toml", data + "assets/scenes/hard/H05.toml", data + "assets/data/peers.csv",
            data + "shaders/mesh.vert", data + "config/bindings.toml", "share/applications/plumbline.desktop",
            "share/icons/hicolor/scalable/apps/plumbline.svg", "share/icons/hicolor/48x48/apps/plumbline.png",
            "share/metainfo/alt.plumbline.plumbline.metainfo.xml", "share/man/man1/plumbline.1.gz",
            "share/bash-completion/completions/plumbline-f64", data + "assets/report/page.html"]:
        assert name in there, f"{name} is not installed"
    # Every shipped file of the sources is there, and nothing that only makes or measures it.
    for below in ("assets", "shaders", "config"):
        tracked = subprocess.run(["git", "-C", source, "ls-files", below], capture_output=True, text=True).stdout
        for name in tracked.splitlines():
            left_out = name.startswith(("assets/source/", "assets/models/bench/", "assets/scenes/bench/"))
            assert left_out == (data + name not in there), f"{name}: left out is {left_out}"
    assert not any("/source/" in name or "/bench/" in name for name in there), there
    programs = [name for name in there if os.access(prefix / name, os.X_OK)]
    assert sorted(programs) == sorted([f"bin/{program}" for program in PROGRAMS] + ["libexec/plumbline/plumbline-engines"]), programs


def runs_from_anywhere():
    for of in PROGRAMS:
        run("simulate", "falling_cube", "--seconds", 1, of=of)
        run("--version", says="Bullet", of=of)
    run("render", "falling_cube", "--out", folder / "cube.png", "--size", "64x36")
    assert (folder / "cube.png").read_bytes().startswith(b"\x89PNG")
    run("controls", says="flashlight")
    run("explain", "falling_cube")
    run("stability", "H36", "--solver", "small_step", "--engines", "bullet", "--no-pictures", says="bullet           60 Hz  1 of 1 pass")
    # The study starts both programs; without a HOME it keeps nothing and says nothing wrong.
    run("study", "A02", "--quick", "--out", folder / "study")
    assert len((folder / "study/findings.csv").read_text().splitlines()) > 3
    assert "function diagram(" in (folder / "study/report.html").read_text()


def a_link_to_it_works():
    link = folder / "linked"
    link.symlink_to(prefix / "bin/plumbline")
    done = subprocess.run([link, "simulate", "falling_cube", "--seconds", "0.1"], cwd=elsewhere, env=BARE,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def moved_it_finds_its_data():
    moved = folder / "moved"
    shutil.copytree(prefix, moved)
    done = subprocess.run([moved / "bin/plumbline", "check", moved / "share/plumbline/assets/scenes/garden.toml"],
                          cwd=elsewhere, env=BARE, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def without_data_it_names_where_it_looked():
    alone = folder / "alone/bin"
    alone.mkdir(parents=True)
    shutil.copy(prefix / "bin/plumbline", alone)

    def answer(*words, **changes):
        return subprocess.run([alone / "plumbline", *words, "simulate", "falling_cube", "--seconds", "0.1"],
                              cwd=elsewhere, env={**BARE, **changes}, capture_output=True, text=True)
    lost = answer()
    assert lost.returncode != 0
    for tried in (folder / "alone/share/plumbline", alone, folder / "alone"):
        assert f"\n  {tried}\n" in lost.stderr, (tried, lost.stderr)
    assert "--data or PLUMBLINE_DATA" in lost.stderr, lost.stderr
    data = prefix / "share/plumbline"
    assert answer("--data", str(data)).returncode == 0
    assert answer("--data", os.path.relpath(data, elsewhere)).returncode == 0
    assert answer(PLUMBLINE_DATA=str(data)).returncode == 0
    wrong = answer("--data", str(folder))
    assert wrong.returncode != 0 and str(folder) in wrong.stderr, wrong.stderr
    assert answer("--data", "/nowhere/at/all").returncode == 2


def documented_words(program):
    """(command, option) pairs that --help shows; the command of the program's own options is ""."""
    own = run("--help", of=program).stdout
    commands = re.findall(r"^  ([a-z][a-z-]*) ", own.split("Subcommands:")[1], re.M)
    pairs = [("", word) for word in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", own, re.M)]
    for command in commands:
        text = run(command, "--help", of=program).stdout
        pairs += [(command, word) for word in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.M) if word != "--help"]
    return commands, pairs


def completed(program, *words):
    """What bash would offer for the last of `words`."""
    script = f"""source '{prefix}/share/bash-completion/completions/{program}'
        COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _{program.replace("-", "_")}; printf '%s\\n' "${{COMPREPLY[@]}}" """
    done = subprocess.run(["bash", "-c", script, "bash", program, *words], cwd=elsewhere, capture_output=True, text=True)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    return done.stdout.split("\n")


def pages_and_completion_say_what_help_says():
    for program in PROGRAMS:
        commands, pairs = documented_words(program)
        assert "simulate" in commands and ("simulate", "--seconds") in pairs and ("", "--data") in pairs, pairs
        page = subprocess.run(["gzip", "-dc", prefix / f"share/man/man1/{program}.1.gz"], capture_output=True,
                              text=True, check=True).stdout.replace("\\-", "-")
        sections = dict(re.findall(r"^\.SS ([a-z-]+).*?\n(.*?)(?=^\.S[SH] )", page, re.M | re.S))
        sections[""] = re.search(r"^\.SH OPTIONS\n(.*?)^\.SH ", page, re.M | re.S).group(1)
        for command in commands:
            assert command in sections, f"{program}.1 has no {command}"
            assert command in completed(program, command[:2]), f"bash does not offer {command}"
        for command, word in pairs:
            where = f"{program} {command} {word}"
            assert f"\\fB{word}\\fR" in re.sub(r"\\fB-\w, ", r"\\fB", sections[command]), f"{where}: not in the page"
            assert word in completed(program, *([command] if command else []), word[:4]), f"{where}: not in bash"
        script = (prefix / f"share/bash-completion/completions/{program}").read_text()
        assert "study-worker" not in page + script, "a hidden command shows"


def the_tools_take_them():
    checks = [["bash", "-n", *(prefix / "share/bash-completion/completions").iterdir()],
              ["desktop-file-validate", prefix / "share/applications/plumbline.desktop"],
              ["appstreamcli", "validate", "--no-net", prefix / "share/metainfo/alt.plumbline.plumbline.metainfo.xml"]]
    checks += [["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page]
               for page in (prefix / "share/man/man1").iterdir()]
    for words in checks:
        if shutil.which(words[0]) is None:
            print(f"left out: {words[0]} is not installed")
            continue
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True,
                              env={**os.environ, "MANROFFSEQ": "", "MANWIDTH": "80"})
        assert done.returncode == 0, f"{words}: {done.stdout[-400:]}{done.stderr}"
        assert words[0] != "man" or done.stderr == "", done.stderr


def nothing_was_written_into_it(before):
    assert everything_below(prefix) == before


install()
what_is_there()
for path in [prefix, *prefix.rglob("*")]:
    path.chmod(path.stat().st_mode & ~0o222)
files = everything_below(prefix)
for check in (runs_from_anywhere, a_link_to_it_works, moved_it_finds_its_data, without_data_it_names_where_it_looked,
              pages_and_completion_say_what_help_says, the_tools_take_them):
    check()
    print(f"good: {check.__name__}")
nothing_was_written_into_it(files)
for path in folder.rglob("*"):
    if path.is_dir():
        path.chmod(0o755)
shutil.rmtree(folder)
