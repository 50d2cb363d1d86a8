#!/usr/bin/python3
"""./play and ./test against stand-ins for apt, cmake, ninja, ctest and the program.

A copy of the scripts runs in a folder of its own with a PATH of stand-ins that write down how they
were called; what is asserted is that list, the exit status and what the person reads.
"""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from sources import ROOT

TOOLS = ("bash", "dirname", "env", "mkdir", "nproc", "touch", "tr")  # the only real ones within reach

STAND_IN = '#!/bin/bash\n{{ printf "%s" "${{0##*/}}"; printf " [%s]" "$@"; echo; }} >>"$CALLS"\n{}\n'
PACKAGES = "# comment\nlibone-dev\nlibtwo-dev\n\nmaybe: tool-14\n\ntest: libtest-dev\n"


class Machine:
    """A folder with the scripts and a PATH of stand-ins."""

    def __init__(self, folder, installed, user="0"):
        self.root = pathlib.Path(folder) / "a clone"
        self.calls = pathlib.Path(folder) / "calls"
        self.bin = pathlib.Path(folder) / "bin"
        (self.root / "cmake").mkdir(parents=True)
        for script in ("play", "test", "cmake/packages.sh"):
            shutil.copy(ROOT / script, self.root / script)
        (self.root / "cmake/packages.txt").write_text(PACKAGES, encoding="utf-8")
        self.bin.mkdir()
        for tool in TOOLS:
            (self.bin / tool).symlink_to(shutil.which(tool))
        listing = "".join(f"echo 'installed {name}'\n" for name in installed)
        self.stand_in("dpkg-query", listing)
        self.stand_in("apt-cache", '[ "$2" = tool-14 ] && echo "Package: tool-14"')
        self.stand_in("apt-get")
        self.stand_in("id", f"echo {user}")
        self.stand_in("cmake", "for b in release ci; do mkdir -p build/$b/game; "
                               "touch build/$b/build.ninja; done")
        self.stand_in("ninja", 'echo "ninja: no work to do."')
        self.stand_in("ctest")
        self.stand_in(self.root / "build/release/game/plumbline", "exit 5")

    def stand_in(self, name, body=""):
        path = self.bin / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(STAND_IN.format(body), encoding="utf-8")
        path.chmod(0o755)

    def run(self, *command, **environment):
        """Runs one of the scripts from another folder; gives the finished process."""
        return subprocess.run(
            [str(self.root / command[0]), *command[1:]], cwd="/", stdin=subprocess.DEVNULL,
            env={"PATH": str(self.bin), "CALLS": str(self.calls), **environment},
            capture_output=True, text=True, check=False, timeout=60)

    def called(self, name):
        """The arguments of each call of `name`, in order."""
        lines = self.calls.read_text(encoding="utf-8").splitlines() if self.calls.exists() else []
        return [line[len(name) + 1:] for line in lines if line.startswith(name + " ")]


class Scripts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def machine(self, installed=("libone-dev", "libtwo-dev"), user="0"):
        return Machine(self.folder, installed, user)

    def test_nothing_missing_installs_nothing(self):
        machine = self.machine()
        machine.run("play", DISPLAY=":1")
        self.assertEqual(machine.called("apt-get"), [])

    def test_root_installs_what_is_missing_and_says_so(self):
        machine = self.machine(installed=("libone-dev",))
        done = machine.run("play", DISPLAY=":1")
        self.assertEqual(machine.called("apt-get"),
                         ["[update]", "[install] [--yes] [--no-install-recommends] [libtwo-dev]"])
        self.assertIn("plumbline: installing Debian packages: libtwo-dev", done.stderr)

    def test_tests_need_their_own_packages_too(self):
        machine = self.machine()
        machine.run("test")
        self.assertEqual(
            machine.called("apt-get")[-1],
            "[install] [--yes] [--no-install-recommends] [tool-14] [libtest-dev]")

    def test_a_package_that_the_release_lacks_is_left_out_if_it_may_be(self):
        machine = self.machine()
        machine.stand_in("apt-cache", "exit 100")
        machine.run("test")
        self.assertEqual(machine.called("apt-get")[-1],
                         "[install] [--yes] [--no-install-recommends] [libtest-dev]")

    def test_others_without_a_terminal_are_told_and_nothing_is_done(self):
        machine = self.machine(installed=("libtwo-dev",), user="1000")
        machine.stand_in("sudo")
        done = machine.run("play", DISPLAY=":1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("apt-get install --no-install-recommends libone-dev", done.stderr)
        self.assertEqual(machine.called("apt-get") + machine.called("sudo"), [])
        self.assertEqual(machine.called("plumbline"), [])

    def test_a_failed_installation_ends_it(self):
        machine = self.machine(installed=())
        machine.stand_in("apt-get", '[ "$1" = update ]')
        done = machine.run("play", DISPLAY=":1")
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(machine.called("plumbline"), [])

    def test_unreachable_lists_do_not_end_it(self):
        machine = self.machine(installed=("libone-dev",))
        machine.stand_in("apt-get", '[ "$1" != update ]')
        machine.run("play", DISPLAY=":1")
        self.assertEqual(len(machine.called("plumbline")), 1)

    def test_arguments_reach_the_program_as_they_are(self):
        machine = self.machine()
        done = machine.run("play", "my scene.toml", "--bind", "drop=key.x", DISPLAY=":1")
        self.assertEqual(machine.called("plumbline"), ["[my scene.toml] [--bind] [drop=key.x]"])
        self.assertEqual((done.returncode, done.stdout), (5, ""))

    def test_without_a_display_there_is_a_tour(self):
        machine = self.machine()
        done = machine.run("play", "garden.toml")
        self.assertEqual(machine.called("plumbline"),
                         [f"[tour] [--out] [{machine.root}/out] [garden.toml]"])
        self.assertIn("no display here: drawing a tour", done.stderr)
        machine.run("play")
        self.assertEqual(machine.called("plumbline")[1], f"[tour] [--out] [{machine.root}/out]")

    def test_commands_need_no_display(self):
        for words in (["controls"], ["--version"], ["simulate", "a.toml", "--seconds", "1"]):
            machine = Machine(pathlib.Path(self.folder) / words[0], ("libone-dev", "libtwo-dev"))
            machine.run("play", *words)
            self.assertEqual(machine.called("plumbline"), [" ".join(f"[{word}]" for word in words)])

    def test_a_scene_s_name_means_a_window_too(self):
        machine = self.machine()
        scenes = machine.root / "assets/scenes"
        scenes.mkdir(parents=True)
        (scenes / "pile.toml").touch()
        for name in ("pile", "hard/H05", "a model.glb"):
            machine.run("play", name)
        self.assertEqual([line.split("] ")[-1] for line in machine.called("plumbline")],
                         ["[pile]", "[hard/H05]", "[a model.glb]"])
        self.assertTrue(all(line.startswith("[tour]") for line in machine.called("plumbline")))

    def test_all_that_the_program_starts_is_built(self):
        """plumbline-f64 too: no target is named, and nothing that is built is optional."""
        machine = self.machine()
        machine.stand_in("ninja")
        machine.run("play", DISPLAY=":1")
        build = machine.root / "build/release"
        self.assertEqual(machine.called("ninja"), [f"[-C] [{build}] [-n]", f"[-C] [{build}]"])

    def test_configures_once(self):
        machine = self.machine()
        machine.run("play", DISPLAY=":1")
        machine.run("play", DISPLAY=":1")
        self.assertEqual(machine.called("cmake"), ["[--preset] [release]"])

    def test_a_failed_build_runs_nothing(self):
        machine = self.machine()
        machine.stand_in("ninja", "exit 1")
        done = machine.run("play", DISPLAY=":1")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(machine.called("plumbline"), [])
        self.assertEqual(machine.run("test").returncode, 1)
        self.assertEqual(machine.called("ctest"), [])

    def test_test_hands_its_arguments_and_its_verdict_through(self):
        machine = self.machine(installed=("libone-dev", "libtwo-dev", "tool-14", "libtest-dev"))
        machine.stand_in("ctest", "echo the summary; exit 8")
        done = machine.run("test", "-L", "unit")
        self.assertEqual(done.returncode, 8)
        self.assertTrue(done.stdout.endswith("the summary\n"))
        self.assertRegex(machine.called("ctest")[0],
                         r"^\[--preset\] \[ci\] \[--parallel\] \[\d+\] \[-L\] \[unit\]$")


if __name__ == "__main__":
    unittest.main()
