#!/usr/bin/env python3
"""The same bits on every processor: the C library is told that this one has neither AVX nor FMA, and takes its other
variants of sin, exp and so on; the state must not notice. Wind, motion paths, spin, damping and joints are in these scenes."""
import os
import subprocess
import sys

from support import expect

program, program_f64 = sys.argv[1:3]
OLDER = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-AVX512F,-FMA,-AVX"}


def state(of, scene, seconds, solver, environment):
    done = subprocess.run([of, "simulate", scene, "--seconds", str(seconds), "--solver", solver],
                          env={**os.environ, **environment}, capture_output=True, text=True, timeout=200)
    expect(done.returncode == 0, done.stderr)
    lines = [line for line in (done.stdout + done.stderr).splitlines() if "state " in line]
    expect(lines, "no state line:\n" + done.stdout + done.stderr)
    return lines[-1].rsplit(" ", 1)[-1]


def an_older_processor_gives_the_same_bits():
    for scene, seconds, solver in (("fairground", 1.5, "small_step"), ("joints", 2, "small_step"),
                                   ("joints", 2, "bullet_si"), ("hard/H59", 0.5, "small_step")):
        for of in (program, program_f64):
            here, there = (state(of, scene, seconds, solver, environment) for environment in ({}, OLDER))
            expect(here == there, f"{of} {scene} {solver}: {here} here, {there} without AVX and FMA")


if __name__ == "__main__":
    an_older_processor_gives_the_same_bits()
