#!/usr/bin/env python3
"""The .deb that CPack makes: what it asks for, what it holds, and that dpkg takes all of it away.

Skipped where there is no dpkg. The installation goes into an empty root of its own.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
build = pathlib.Path(sys.argv[1])

for tool in ("dpkg", "dpkg-deb", "dpkg-shlibdeps", "cpack"):
    if shutil.which(tool) is None:
        print(f"{tool} is not installed")
        sys.exit(SKIPPED)


def told(*words, **options):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, **options)
    assert done.returncode == 0, f"{words}: {done.stdout[-2000:]}{done.stderr[-2000:]}"
    return done.stdout


def asks_for_what_it_needs(package):
    def field(name):
        return told("dpkg-deb", "--field", package, name).strip()
    assert field("Package") == "plumbline"
    depends = [word.split()[0] for word in field("Depends").split(", ")]
    for library in ("libc6", "libassimp5", "libglfw3", "libopenal1", "libgl1"):
        assert library in depends, f"{library} is not in {depends}"
    assert not any("-dev" in word for word in depends), depends
    assert "libgl1-mesa-dri" in field("Recommends") and "libpulse0" in field("Recommends")
    assert field("Suggests") == ""


def holds_system_files_only(package):
    for line in told("dpkg-deb", "--contents", package).splitlines():
        mode, owner, _, _, _, name = line.split(maxsplit=5)
        assert owner == "root/root", line
        assert name.startswith("./usr") or name == "./", line
        wanted = "rwxr-xr-x" if mode[0] == "d" or name.startswith(("./usr/bin/", "./usr/libexec/")) else "rw-r--r--"
        assert mode[1:] == wanted, line


def goes_without_a_trace(package, root):
    """Installs into an empty root as root does, runs it there, purges it."""
    for name in ("info", "updates", "triggers", "parts"):
        (root / "var/lib/dpkg" / name).mkdir(parents=True)
    for name in ("status", "available"):
        (root / "var/lib/dpkg" / name).touch()
    dpkg = ["dpkg", f"--root={root}", "--force-not-root", "--force-depends", "--force-script-chrootless",
            f"--log={root}/log"]
    told(*dpkg, "--install", package)
    program = root / "usr/bin/plumbline"
    assert program.is_file()
    told(program, "simulate", "falling_cube", "--seconds", "0.5", cwd="/", env={"PATH": "/usr/bin:/bin"})
    told(*dpkg, "--purge", "plumbline")
    left = [path for path in root.rglob("*") if not str(path).startswith(str(root / "var"))]
    assert left == [root / "log"], left


with tempfile.TemporaryDirectory() as text:
    folder = pathlib.Path(text)
    (folder / "root").mkdir()
    told("cpack", "--config", build / "CPackConfig.cmake", "-B", folder / "made")
    [made] = (folder / "made").glob("*.deb")
    asks_for_what_it_needs(made)
    holds_system_files_only(made)
    goes_without_a_trace(made, folder / "root")
    if shutil.which("lintian"):
        told("lintian", "--fail-on", "error,warning", "--allow-root", made)
    else:
        print("left out: lintian is not installed")
