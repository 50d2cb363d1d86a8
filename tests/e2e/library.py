#!/usr/bin/env python3
"""The physics as an installed library: the examples are built against it with CMake and with pkg-config, in a folder that was
moved after the installation, and say the same."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

build, source = map(pathlib.Path, sys.argv[1:3])
folder = pathlib.Path(tempfile.mkdtemp())
prefix = folder / "moved"


def run(*words, **options):
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, timeout=200, **options)
    assert done.returncode == 0, f"{words}: exit {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


def refused(*words):
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, timeout=200)
    assert done.returncode != 0, f"{words}: was not refused"
    return " ".join((done.stdout + done.stderr).split())


def install():
    run("cmake", "--install", build, "--prefix", folder / "first", "--component", "library")
    (folder / "first").rename(prefix)


def with_cmake(example, program):
    made = folder / ("made_" + program)
    run("cmake", "-S", example, "-B", made, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")
    run("cmake", "--build", made)
    return run(made / program)


def with_pkg_config(example, name, library, suffix=""):
    path = next(prefix.rglob("pkgconfig"))
    environment = {**os.environ, "PKG_CONFIG_PATH": str(path)}
    flags = run("pkg-config", "--cflags", "--libs", "--static", library + suffix, env=environment).split()
    program = folder / (name + suffix)
    run("c++", "-std=c++20", "-O2", example / f"{name}.cpp", "-o", program, *flags)
    return run(program, env={**os.environ, "LD_LIBRARY_PATH": str(path.parent)})


def heights(output):
    lines = [line.split() for line in output.splitlines()]
    assert [line[0] for line in lines] == ["small_step", "bullet_si"], output
    return [float(line[1]) for line in lines]


def stretches(output):
    lines = [line.split() for line in output.splitlines()]
    assert [line[0] for line in lines] == ["btDiscreteDynamicsWorld", "SmallStepDynamicsWorld"], output
    return [float(line[1]) for line in lines]


def found_twice(example):
    """As where two parts of a project each look for it."""
    other = folder / "twice"
    shutil.copytree(example, other)
    text = (example / "CMakeLists.txt").read_text()
    line = next(line for line in text.splitlines() if line.startswith("find_package"))
    (other / "CMakeLists.txt").write_text(text.replace(line, f"{line}\n{line}"))
    run("cmake", "-S", other, "-B", other / "made", f"-DCMAKE_PREFIX_PATH={prefix}")


def other_versions_and_components(example):
    text = (example / "CMakeLists.txt").read_text()
    for old, new, said in (("plumbline 0.1", "plumbline 7.0", "requested version \"7.0\""),
                           ("COMPONENTS physics", "COMPONENTS physics audio", "plumbline has no component audio")):
        other = folder / "other"
        shutil.rmtree(other, ignore_errors=True)
        shutil.copytree(example, other)
        (other / "CMakeLists.txt").write_text(text.replace(old, new))
        output = refused("cmake", "-S", other, "-B", other / "made", f"-DCMAKE_PREFIX_PATH={prefix}")
        assert said in output, output


try:
    install()
    example = source / "examples/physics_library"
    sunk = heights(with_cmake(example, "tower"))
    assert 0 < sunk[0] < 50 < sunk[1], f"the tower stands with small_step alone: {sunk}"
    assert heights(with_pkg_config(example, "tower", "plumbline-physics")) == sunk
    assert abs(heights(with_pkg_config(example, "tower", "plumbline-physics", "_f64"))[0] - sunk[0]) < 1
    found_twice(example)
    other_versions_and_components(example)
    example = source / "examples/bullet_program"
    stretched = stretches(with_cmake(example, "chain"))
    assert stretched[0] > 5 and abs(stretched[1]) < 0.1, f"the chain holds in our world alone: {stretched}"
    assert stretches(with_pkg_config(example, "chain", "plumbline-bullet-world")) == stretched
    assert abs(stretches(with_pkg_config(example, "chain", "plumbline-bullet-world", "_f64"))[1]) < 0.1
finally:
    shutil.rmtree(folder, ignore_errors=True)
print(f"the tower sank {sunk[0]} mm; with Bullet's solver {sunk[1]} mm; the chain stretched by {stretched[1]} % and {stretched[0]} %")
