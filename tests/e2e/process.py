#!/usr/bin/env python3
"""The program as a process: signals, crashes, memory, handles, threads, clocks and copies of itself."""
import json
import os
import pathlib
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

program, program_f64 = sys.argv[1:3]
# Who runs this as a script's background job ignores SIGINT, and so would the program.
signal.signal(signal.SIGINT, signal.default_int_handler)
folder = pathlib.Path(tempfile.mkdtemp())
environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
environment.update(HOME=str(folder), XDG_CONFIG_HOME=str(folder / "config"), XDG_DATA_HOME=str(folder / "data"),
                   XDG_STATE_HOME=str(folder / "state"))
CUBE = "assets/scenes/falling_cube.toml"
sanitized = b"__asan_init" in pathlib.Path(program).read_bytes()


def run(*words, of=program, code=0, says="", limits=(), **changes):
    def set_limits():
        for limit, value in limits:
            resource.setrlimit(limit, (value, value))

    done = subprocess.run([of, *map(str, words)], env={**environment, **changes}, capture_output=True, text=True, errors="replace",
                          timeout=200, preexec_fn=set_limits)
    output = done.stdout + done.stderr
    assert done.returncode == code, f"{words}: exit {done.returncode}, expected {code}\n{output}"
    assert says in output, f"{words}: expected to read {says!r} in\n{output}"
    assert "terminate called" not in output, output
    return done


def start(*words):
    return subprocess.Popen([program, *map(str, words)], env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def pile_of(bodies):
    """A scene of so many boxes, in a grid that does not touch."""
    scene = folder / f"pile_{bodies}.toml"
    scene.write_text(f'[[prefab]]\nname = "b"\nprimitive = {{ box = [1, 1, 1] }}\n[prefab.body]\nmass_kg = 1\n'
                     f'[[array]]\nname = "a"\nprefab = "b"\ncount = [{bodies // 50}, 1, 50]\nspacing_m = [2, 2, 2]\n')
    return scene


def wait_until_it_catches_signals(process, numbers=(signal.SIGINT, signal.SIGTERM, signal.SIGHUP)):
    """From here on a signal is the program's, not the system's. What it does next is load the scene."""
    caught = sum(1 << (number - 1) for number in numbers)
    for _ in range(10_000):
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
        if int(status.split("SigCgt:")[1].split()[0], 16) & caught == caught:
            return
        time.sleep(0.001)
    raise AssertionError("it never catches signals")


# EXPERIENCE I1 and I2: the first signal ends the run with its files, the second ends the program.
def a_second_interrupt_leaves_at_once():
    for bodies, numbers, written in ((500, [signal.SIGINT], True), (40_000, [signal.SIGINT, signal.SIGTERM], False)):
        state = folder / "interrupted.json"
        busy = start("simulate", pile_of(bodies), "--seconds", 3600, "--state", state)
        wait_until_it_catches_signals(busy)
        # Stopped, it gets both together however fast it is.
        for number in [signal.SIGSTOP, *numbers, signal.SIGCONT]:
            busy.send_signal(number)
        said = busy.communicate(timeout=60)
        assert busy.returncode == 130, (busy.returncode, said)
        assert state.exists() == written, (numbers, said)
        assert not (folder / "state/plumbline/crash.txt").exists()
        state.unlink(missing_ok=True)


# FAULTS N12: render, tour, explain and check were ended by the system, without a line.
def every_command_hears_a_signal():
    many = [pile_of(5_000)] * 1000
    for number, *words in ((signal.SIGTERM, "render", CUBE, "--frames", 100_000, "--size", "64x64", "--out", folder / "frames"),
                           (signal.SIGHUP, "render", CUBE, "--at", 1e6), (signal.SIGTERM, "tour", "garden", "--out", folder / "tour"),
                           (signal.SIGTERM, "explain", "garden"), (signal.SIGTERM, "check", *many),
                           (signal.SIGTERM, "simulate", pile_of(49_950), "--seconds", 3600),
                           (signal.SIGTERM, "study", "A02", "--out", folder / "study"),
                           (signal.SIGTERM, "stability", "--out", folder / "stability")):
        busy = start(*words)
        wait_until_it_catches_signals(busy)
        busy.send_signal(number)
        _, said = busy.communicate(timeout=60)
        assert busy.returncode == 130 and said.count("plumbline: interrupted") == 1, (words[:2], busy.returncode, said)


# FAULTS N12: as a shell starts the background jobs of a script.
def what_is_ignored_at_the_start_stays_ignored():
    job = subprocess.Popen([program, "simulate", CUBE, "--seconds", "1e6"], env=environment, stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE, text=True, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
    wait_until_it_catches_signals(job, (signal.SIGTERM,))
    job.send_signal(signal.SIGINT)
    time.sleep(0.5)
    assert job.poll() is None, job.communicate()
    job.terminate()
    _, said = job.communicate(timeout=20)
    assert job.returncode == 130 and said.count("plumbline: interrupted") == 1, (job.returncode, said)


# FAULTS N10: SIGXFSZ ended it with 153, without a line.
def a_limit_on_files_is_a_line_and_a_code():
    save = folder / "limited.save"
    save.write_text("earlier")
    left = set(folder.glob(".plumbline-saving-*"))  # by programs that two signals ended
    for of in (program, program_f64):
        done = run("simulate", "assets/scenes/pile.toml", "--seconds", "0.05", "--save", save, of=of, code=1, says="File too large",
                   limits=[(resource.RLIMIT_FSIZE, 10 << 10)])
        assert done.stderr.count("\n") == 1, done
        assert save.read_text() == "earlier", done
        assert set(folder.glob(".plumbline-saving-*")) <= left


# EXPERIENCE I4
def a_crash_leaves_a_report_and_the_next_start_says_so():
    if sanitized:
        print("the sanitizer reports crashes itself: not tried")
        return
    running = start("simulate", CUBE, "--seconds", 1e6, "--hz", 1000)
    time.sleep(2)
    running.send_signal(signal.SIGSEGV)
    _, said = running.communicate(timeout=20)
    report = folder / "state/plumbline/crash.txt"
    assert running.returncode == -signal.SIGSEGV and str(report) in said, (running.returncode, said)
    text = report.read_text()
    assert "simulate" in text and "signal SIGSEGV" in text and "(_ZN9plumbline" in text.split("backtrace:")[1], text
    said = run("play", CUBE, "--no-sound", code=3, says="start with --safe to use built-in settings only").stderr
    assert "crash.old.txt" in said
    assert "crash" not in run("play", CUBE, "--no-sound", code=3).stderr, "told once"


# EXPERIENCE G26
def refused_memory_is_a_line_and_a_code():
    if sanitized:
        print("the sanitizer needs more addresses than this: not tried")
        return
    # In less than `least` the loader refuses the program's libraries.
    for of, solver, least in ((program, "small_step", 90), (program_f64, "bullet_si", 80),
                              (program_f64, "small_step", 80)):
        codes = []
        for room in (250, 200, 170, 140, 110, least):
            done = subprocess.run([of, "simulate", pile_of(49_950), "--seconds", "0.05", "--solver", solver], env=environment,
                                  capture_output=True, text=True, timeout=200,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (room << 20, room << 20)))
            codes.append(done.returncode)
            assert done.returncode in (0, 6), (room, done)
            assert done.stderr.count("out of memory") == (1 if done.returncode == 6 else 0), (room, done)
        assert 6 in codes, codes


# FAULTS 3: 2000 took 0.5 GB by small_step and 4 by Bullet's solvers; a matrix of theirs crashed.
def a_heap_on_one_spot_takes_memory_by_its_bodies():
    if sanitized:
        print("the sanitizer needs more addresses than this: not tried")
        return
    scene = folder / "heap.toml"
    scene.write_text('[scene]\ntitle = "heap"\n[[prefab]]\nname = "ball"\nprimitive = { sphere = 0.2 }\n'
                     'body = { kind = "dynamic", mass_kg = 1 }\n'
                     '[[array]]\nname = "heap"\nprefab = "ball"\ncount = [2000, 1, 1]\nspacing_m = [0, 0, 0]\n')
    room = 600 << 20
    for solver in ("small_step", "bullet_si", "bullet_pgs"):
        done = subprocess.run([program, "simulate", scene, "--seconds", "0.033", "--solver", solver], env=environment, capture_output=True,
                              text=True, timeout=200, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (room, room)))
        assert done.returncode == 0 and "2000 moving bodies" in done.stdout, done
        assert done.stderr.count("pairs of bodies in a crowd push nothing") == 1, done


# FAULTS 21: it was "std::bad_alloc".
def a_model_too_large_for_memory_is_a_line_and_a_code():
    if sanitized:
        print("the sanitizer needs more addresses than this: not tried")
        return
    model = folder / "many.ply"
    corners = 900_000
    model.write_bytes(f"ply\nformat binary_little_endian 1.0\nelement vertex {corners}\nproperty float x\nproperty float y\n"
                      f"property float z\nelement face {corners // 3}\nproperty list uchar int vertex_indices\nend_header\n".encode()
                      + b"".join(struct.pack("<3f", i % 3 == 1, i % 3 == 2, i * 0.01) for i in range(corners))
                      + b"".join(struct.pack("<B3i", 3, i, i + 1, i + 2) for i in range(0, corners, 3)))
    codes = []
    for room in (400, 200, 150, 100):
        done = subprocess.run([program, "simulate", model, "--seconds", "0.05"], env=environment, capture_output=True, text=True,
                              timeout=200, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (room << 20, room << 20)))
        codes.append(done.returncode)
        assert done.returncode in (0, 4, 6), (room, done)  # refused while it is read, or while the scene is made of it
        lines = done.stderr.splitlines()
        assert len(lines) == (done.returncode != 0) and all("memory" in line for line in lines), (room, done)
        assert "bad_alloc" not in done.stderr, (room, done)
    assert codes[0] == 0 and any(codes), codes


# EXPERIENCE I14
def threads_that_cannot_be_made_are_not_needed():
    if os.geteuid() != 0 or sanitized:
        print("only root can become somebody who may have few threads: not tried")
        return
    # The program and its files in folders that everybody may read, whatever those above the clone are.
    prefix = folder / "everybody's"
    (prefix / "bin").mkdir(parents=True)
    shutil.copy(program, prefix / "bin")
    for data in ("assets", "shaders", "config"):
        shutil.copytree(data, prefix / "share/plumbline" / data, ignore=shutil.ignore_patterns("source"))
    home = folder / "nobody"
    home.mkdir()
    os.chown(home, 65533, 65533)
    os.chmod(folder, 0o755)
    for path in prefix.rglob("*"):
        path.chmod(0o755 if path.is_dir() or path.parent.name == "bin" else 0o644)
    prefix.chmod(0o755)

    def become_somebody_without_threads():
        resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))
        os.setgid(65533)
        os.setuid(65533)

    # Without an image: Mesa's software rasterizer waits for ever for threads that it did not get.
    done = subprocess.run([prefix / "bin" / pathlib.Path(program).name, "simulate", "playroom", "--seconds", "0.1"],
                          env={**environment, "HOME": str(home), "XDG_STATE_HOME": str(home)}, cwd=prefix,
                          capture_output=True, text=True, timeout=200, preexec_fn=become_somebody_without_threads)
    assert done.returncode == 0, done


# EXPERIENCE I8
def few_file_handles_do():
    for handles in (256, 24):
        run("render", "garden", "--size", "160x90", "--out", folder / "p.png", limits=[(resource.RLIMIT_NOFILE, handles)])
    run("simulate", "playroom", "--seconds", 0.1, limits=[(resource.RLIMIT_NOFILE, 12)])


# EXPERIENCE I12
def two_copies_do_not_meet():
    running = [start("render", CUBE, "--size", "64x64", "--at", 0.2) for _ in range(4)]
    files = {one.communicate(timeout=60)[0].strip() for one in running}
    assert all(one.returncode == 0 for one in running)
    assert len(files) == 4 and all(pathlib.Path(file).stat().st_size > 0 for file in files), files
    # Ended or not, what each was told to write is its own.
    running = [start("simulate", CUBE, "--seconds", 1e6, "--hz", 1000) for _ in range(2)]
    time.sleep(1)
    for one in running:
        one.send_signal(signal.SIGTERM)
    assert [one.wait(20) for one in running] == [130, 130]
    states = [folder / f"copy_{i}.json" for i in range(2)]
    running = [start("simulate", CUBE, "--seconds", 2, "--state", state) for state in states]
    assert [one.wait(60) for one in running] == [0, 0]
    assert len({json.loads(state.read_text())["hash"] for state in states}) == 1


# EXPERIENCE I13 and E13
def any_date_will_do():
    faketime = shutil.which("faketime")
    if faketime is None:
        print("there is no faketime: not tried")
        return
    hashes = set()
    for date in ("1970-01-02 00:00:00", "2038-01-20 00:00:00", "2100-01-01 00:00:00"):
        state = folder / "dated.json"
        run(date, program, "simulate", CUBE, "--seconds", 0.5, "--state", state, of=faketime)
        hashes.add(json.loads(state.read_text())["hash"])
        images = {run(date, program, "render", CUBE, "--size", "64x64", of=faketime).stdout for _ in range(2)}
        assert len(images) == 2 and date[:4] in min(images), images
    assert len(hashes) == 1, hashes


# EXPERIENCE E14
def names_may_be_anything():
    for name in (b"two words", b"it's \"quoted\"", b"line\nbreak", b"$(reboot); `x` & *", b"not utf-8 \xff\xfe", b"-rf", b"%2e", b"n" * 230):
        base = os.fsencode(folder) + b"/names/" + (name if len(name) < 200 else b"long")
        os.makedirs(base, exist_ok=True)
        scene = base + b"/" + name + b".toml"
        shutil.copy(CUBE, scene)
        state = base + b"/" + name + b".json"
        image = base + b"/" + name + b".png"
        report = base + b"/report"
        for words in ([b"simulate", scene, b"--seconds", b"0.1", b"--state", state], [b"check", scene],
                      [b"render", scene, b"--size", b"64x64", b"--out", image, b"--report", report]):
            done = subprocess.run([program, *words], env=environment, capture_output=True, timeout=60)
            assert done.returncode == 0, done
            assert all(byte >= 32 or byte == 10 for byte in done.stdout + done.stderr), done
        read = json.loads(open(state, "rb").read().decode())
        assert read["steps"] == 6, read
        json.loads(open(report, "rb").read().decode())
        assert open(image, "rb").read(4) == b"\x89PNG"
        done = subprocess.run([program, b"render", scene, b"--size", b"64x64"], env=environment, capture_output=True, timeout=60)
        assert done.returncode == 0 and b"shots" in done.stdout, done


for test in (a_second_interrupt_leaves_at_once, every_command_hears_a_signal, what_is_ignored_at_the_start_stays_ignored,
             a_limit_on_files_is_a_line_and_a_code, a_crash_leaves_a_report_and_the_next_start_says_so, refused_memory_is_a_line_and_a_code,
             a_heap_on_one_spot_takes_memory_by_its_bodies,
             a_model_too_large_for_memory_is_a_line_and_a_code,
             threads_that_cannot_be_made_are_not_needed, few_file_handles_do, two_copies_do_not_meet, any_date_will_do, names_may_be_anything):
    print(test.__name__, flush=True)
    test()
