#!/usr/bin/env python3
"""What is written where a person says: files, links, devices, pipes, the standard output, and places that refuse."""
import json
import os
import pathlib
import signal
import stat
import subprocess
import sys
import tempfile
import threading
import time

program, program_f64 = sys.argv[1:3]
# Who runs this as a script's background job ignores SIGINT, and so would the program.
signal.signal(signal.SIGINT, signal.default_int_handler)
folder = pathlib.Path(tempfile.mkdtemp())
environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
environment.update(HOME=str(folder), XDG_CONFIG_HOME=str(folder / "config"), XDG_DATA_HOME=str(folder / "data"))
CUBE = "assets/scenes/falling_cube.toml"


def run(*words, of=program, code=0, says="", stdout=subprocess.PIPE, **more):
    done = subprocess.run([of, *map(str, words)], env=environment, stdout=stdout, stderr=subprocess.PIPE, timeout=120, **more)
    output = ((done.stdout or b"") + done.stderr).decode(errors="replace")
    assert done.returncode == code, f"{words}: exit {done.returncode}, expected {code}\n{output}"
    assert says in output, f"{words}: expected to read {says!r} in\n{output}"
    assert "terminate called" not in output, output
    return done


def reads(pipe):
    """A thread that reads a FIFO to its end; join() it for the bytes."""
    got = []
    thread = threading.Thread(target=lambda: got.append(pathlib.Path(pipe).read_bytes()))
    thread.start()
    return lambda: (thread.join(60), got[0])[1]


def regular_files_keep_mode_and_links():
    real, link = folder / "real.json", folder / "link.json"
    real.write_text("old")
    real.chmod(0o600)
    link.symlink_to(real)
    run("simulate", CUBE, "--seconds", 0.1, "--state", link)
    assert link.is_symlink() and json.loads(real.read_text())["steps"] == 6
    assert stat.S_IMODE(real.stat().st_mode) == 0o600
    long = folder / ("n" * 240 + ".json")
    run("simulate", CUBE, "--seconds", 0.1, "--state", long)
    assert json.loads(long.read_text())["steps"] == 6


def pipes_are_written_through():
    pipe = folder / "pipe"
    os.mkfifo(pipe)
    for of in (program, program_f64):
        for option in ("--state", "--trace"):
            reader = reads(pipe)
            run("simulate", CUBE, "--seconds", 0.1, option, pipe, of=of)
            assert json.loads(reader().splitlines()[0] if option == "--trace" else reader())["bodies"]
            assert stat.S_ISFIFO(pipe.lstat().st_mode)
    reader = reads(pipe)
    run("render", CUBE, "--size", "64x64", "--out", pipe)
    assert reader().startswith(b"\x89PNG")
    reader = reads(pipe)
    run("render", CUBE, "--size", "64x64", "--report", pipe)
    assert json.loads(reader())["frames"] == 1
    # Nobody reads: Ctrl-C ends the waiting.
    waiting = subprocess.Popen([program, "simulate", CUBE, "--seconds", "0.1", "--state", pipe], env=environment,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(2)
    waiting.send_signal(signal.SIGINT)
    assert waiting.wait(20) == 1


def devices_stay_devices():
    null, full = folder / "null", folder / "full"
    try:
        os.mknod(null, 0o666 | stat.S_IFCHR, os.makedev(1, 3))
        os.mknod(full, 0o666 | stat.S_IFCHR, os.makedev(1, 7))
        os.close(os.open(null, os.O_WRONLY))
    except PermissionError:
        print("only root may make devices: not tried")
        return
    run("simulate", CUBE, "--seconds", 0.1, "--state", null, "--trace", null)
    run("render", CUBE, "--size", "64x64", "--out", null, "--report", null)
    run("simulate", CUBE, "--seconds", 0.1, "--state", full, code=1, says="No space left on device")  # EXPERIENCE E1
    for device in (null, full):
        assert stat.S_ISCHR(device.lstat().st_mode), device


def the_standard_output_has_a_name():
    for name in ("-", "/dev/stdout"):
        done = run("simulate", CUBE, "--seconds", 0.1, "--state", name)
        assert json.loads(done.stdout)["steps"] == 6, "the file alone"
        assert b"moving bodies" in done.stderr, "the summary goes beside it"
    assert run("render", CUBE, "--size", "64x64", "--out", "-").stdout.startswith(b"\x89PNG")
    log = folder / "log"
    with open(log, "w") as file:  # a redirected output is not replaced
        file.write("before\n")
        file.flush()
        run("simulate", CUBE, "--seconds", 0.1, "--trace", "/dev/stdout", stdout=file)
    assert log.read_text().startswith("before\n{")


def what_cannot_be_written_is_found_first():
    blocked = folder / "a_file"
    blocked.write_text("")
    nowhere = str(blocked / "below")  # a file is no folder, for root too
    run("play", CUBE, "--record", nowhere, code=1, says=nowhere)  # not: no display
    run("play", CUBE, "--report", nowhere, code=1, says=nowhere)
    run("simulate", "assets/scenes/pile.toml", "--seconds", 1e6, "--state", nowhere, code=1, says=nowhere)
    run("simulate", "assets/scenes/pile.toml", "--seconds", 1e6, "--trace", folder, code=1, says="Is a directory")
    run("render", "garden", "--at", 1e6, "--report", nowhere, code=1, says=nowhere)
    for command in ("study", "stability", "tour"):
        done = run(command, "--out", blocked / "below", code=1, says="a_file/below")
        assert not done.stdout, done.stdout


def an_earlier_study_stays_until_the_new_one_is_done():
    out = folder / "study"
    out.mkdir()
    (out / "findings.csv").write_text("earlier")
    running = subprocess.Popen([program, "study", "--out", out], env=environment, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, start_new_session=True)
    time.sleep(2)
    os.killpg(running.pid, signal.SIGKILL)
    running.wait()
    assert (out / "findings.csv").read_text() == "earlier"


def a_trace_grows_while_it_runs():
    """It was kept in memory and written at the end: after a kill there was none."""
    trace = folder / "growing.jsonl"
    endless = subprocess.Popen([program, "simulate", CUBE, "--seconds", "1e6", "--trace", str(trace), "--every", "1"],
                               env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end_s = time.monotonic() + 60
    while not trace.exists() or trace.read_bytes().count(b"\n") < 3:
        assert endless.poll() is None and time.monotonic() < end_s, "nothing is traced while it runs"
        time.sleep(0.05)
    endless.kill()
    endless.wait()
    whole = trace.read_bytes().split(b"\n")[:-1]
    assert [json.loads(line)["time_s"] for line in whole[:3]] == [0, 1, 2]


def trace_events_are_spans_within_steps():
    events = folder / "events.json"
    scene = "bench/boxes_100"
    plain = run("simulate", scene, "--seconds", 1).stdout.split()[-1]
    done = run("simulate", scene, "--seconds", 1, "--threads", 2, "--trace-events", events)
    assert done.stdout.split()[-1] == plain, "who watches changes nothing"
    spans = [event for event in json.loads(events.read_text()) if event["ph"] == "X"]
    steps = [span for span in spans if span["name"] == "step"]
    assert len(steps) == 60 and {"broad phase", "narrow phase", "solve islands", "island"} <= {span["name"] for span in spans}
    for name in ("narrow phase", "solve islands"):
        for span in (each for each in spans if each["name"] == name):
            assert any(step["ts"] <= span["ts"] + 0.01 and span["ts"] + span["dur"] <= step["ts"] + step["dur"] + 0.01
                       for step in steps), span
    assert all(span["args"]["bodies"] >= 1 for span in spans if span["name"] == "island")
    for solver in ("bullet_si", "small_step"):
        run("simulate", CUBE, "--seconds", 0, "--solver", solver, "--trace-events", events)
        assert len(json.loads(events.read_text())) == 1, "no step, no span"
    run("simulate", CUBE, "--seconds", 1e6, "--trace-events", folder, code=1, says="Is a directory")
    endless = subprocess.Popen([program, "simulate", CUBE, "--seconds", "1e6", "--trace-events", str(events)],
                               env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(1)
    endless.send_signal(signal.SIGINT)
    assert endless.wait(20) != 0
    assert len(json.loads(events.read_text())) > 1000, "whole after Ctrl-C"


# EXPERIENCE I3
def a_reader_may_leave():
    for words in (["controls"], ["scenes"], ["explain", CUBE], ["--help"]):
        read_end, write_end = os.pipe()
        os.close(read_end)
        done = run(*words, stdout=write_end)
        os.close(write_end)
        assert not done.stderr, done.stderr
        with open("/dev/full", "w") as full:
            run(*words, stdout=full, code=1, says="cannot write to the standard output: ")


def what_has_no_name_gets_one():
    done = run("render", CUBE, "--size", "64x64")
    image = pathlib.Path(done.stdout.decode().strip())
    assert image.parent == folder / "data/plumbline/shots" and image.read_bytes().startswith(b"\x89PNG"), image
    assert image.name.startswith("falling_cube_")
    again = pathlib.Path(run("render", CUBE, "--size", "64x64").stdout.decode().strip())
    assert again != image
    done = run("study", "A01", "--quick")
    page = pathlib.Path(done.stdout.decode().splitlines()[-1])
    assert page.is_relative_to(folder / "data/plumbline/studies") and page.name == "report.html", page
    assert "<html" in page.read_text() and (page.parent / "findings.json").exists()


for test in (regular_files_keep_mode_and_links, pipes_are_written_through, devices_stay_devices, the_standard_output_has_a_name,
             what_cannot_be_written_is_found_first, an_earlier_study_stays_until_the_new_one_is_done,
             a_trace_grows_while_it_runs, trace_events_are_spans_within_steps, a_reader_may_leave, what_has_no_name_gets_one):
    print(test.__name__, flush=True)
    test()
