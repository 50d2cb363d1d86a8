#!/usr/bin/env python3
"""Saved games: from the command line in both precisions, with files that are no such games, on a disk that is full;
and in a window, in the middle of the garden with a crate in hand: quit, load, go on, and the bits are the same."""
import contextlib
import pathlib
import resource
import signal
import subprocess
import sys
import time

from support import Program, Recording, expect, home, settings_in, virtual_screen

program, program_f64 = sys.argv[1:3]


def run(*words, environment, of=program, code=0, says="", limit=None):
    done = subprocess.run([of, *map(str, words)], env=environment, capture_output=True, text=True, timeout=200,
                          preexec_fn=limit)
    said = done.stdout + done.stderr
    expect(done.returncode == code, f"{words}: exit {done.returncode}, expected {code}\n{said}")
    expect(says in said, f"{words}: does not say \"{says}\"\n{said}")
    return said


def state_of(said):
    lines = [line for line in said.splitlines() if "state " in line]
    expect(lines, "no state line:\n" + said)
    return lines[-1].rsplit(" ", 1)[-1]


def goes_on_to_the_same_bits(folder, environment):
    for of in (program, program_f64):
        whole = state_of(run("simulate", "playroom", "--seconds", 4, environment=environment, of=of))
        file = folder / "half.save"
        half = state_of(run("simulate", "playroom", "--seconds", 2, "--save", file, environment=environment, of=of))
        expect(half != whole, "nothing moved between 2 s and 4 s")
        said = run("simulate", "playroom", "--load", file, "--seconds", 2, environment=environment, of=of)
        expect(state_of(said) == whole, "the second half ends elsewhere:\n" + said)
        expect(said.startswith("4.000 s in 480 steps") or "4.000 s in" in said, said)
        run("simulate", "playroom", "--load", file, "--hz", 60, environment=environment, of=of, code=2, says="--hz")


def what_is_no_saved_game_is_refused_and_named(folder, environment):
    file = folder / "one.save"
    run("simulate", "pile", "--seconds", 0.5, "--save", file, environment=environment)
    bytes_ = file.read_bytes()

    def refused(name, content, says):
        other = folder / name
        other.write_bytes(content)
        run("simulate", "pile", "--load", other, environment=environment, code=4, says=f"{other}: {says}")

    refused("cut.save", bytes_[:1000], f"a saved game cut short: 1000 bytes of {len(bytes_)}")
    refused("head.save", bytes_[:20], "a saved game cut short: 20 bytes, its head alone has 28")
    refused("empty.save", b"", "no saved game: it does not begin with \"PLUMSAVE\"")
    refused("text.save", b"hello there, this is no saved game", "no saved game")
    refused("newer.save", bytes_[:8] + b"\x0d" + bytes_[9:], "a saved game of format 13; this program reads format 12")
    refused("flipped.save", bytes_[:5000] + bytes([bytes_[5000] ^ 1]) + bytes_[5001:],
            "a damaged saved game: its checksum is ")
    run("simulate", "pile", "--load", folder / "none.save", environment=environment, code=4, says="none.save")
    run("simulate", "playroom", "--load", file, environment=environment, code=4,
        says=f"{file}: a saved game of pile.toml, not of playroom.toml")
    run("simulate", "pile", "--load", file, environment=environment, of=program_f64, code=4,
        says=f"{file}: a saved game of float32; this program computes in float64")
    # The same scene, changed since.
    scene = folder / "pile.toml"
    scene.write_text(pathlib.Path("assets/scenes/pile.toml").read_text() + "\n# another line\n")
    run("simulate", scene, "--load", file, environment=environment, code=4, says="a saved game of pile.toml when pile.toml had the hash ")


def a_full_disk_leaves_the_save_before(folder, environment):
    file = folder / "kept.save"
    run("simulate", "pile", "--seconds", 0.5, "--save", file, environment=environment)
    before = file.read_bytes()

    def full():  # stands for a full disk: no file may grow further
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
    run("simulate", "pile", "--seconds", 1, "--save", file, environment=environment, code=1, says="kept.save",
        limit=full)
    expect(file.read_bytes() == before, "the save before is not what it was")
    expect([each.name for each in folder.iterdir() if "kept" in each.name] == ["kept.save"], "a half file was left")


@contextlib.contextmanager
def playing(environment, folder, *words):
    command = [program, "play", *map(str, words), "--size", "320x180", "--no-sound"]
    running = Program(command, environment, folder / "play.log")
    try:
        time.sleep(2)
        yield running
    finally:
        running.stop()


def end(running):
    running.process.send_signal(signal.SIGINT)
    running.wait(60)
    return state_of(running.log())


def wait_for(file, running):
    for _ in range(200):
        if file.exists():
            return
        time.sleep(0.1)
    raise AssertionError(f"no {file} within 20 s:\n" + running.log())


def play_with_a_crate_in_hand(folder, environment, tape, slot):
    """Looks down, so that the crate is put on the ground where one looks; saves with it in hand, walks on. The state in the end."""
    with playing(environment, folder, "garden", "--record", tape) as running:
        running.ready(folder / "data/plumbline/shots")
        for _ in range(5):
            running.do("mousemove_relative", "--", 0, 200)
            time.sleep(0.2)
        running.do("key", "q")
        time.sleep(2)  # it comes to rest, also at a few frames a second
        running.do("key", "e")
        time.sleep(2)
        running.press("F5")
        wait_for(slot, running)
        running.hold("w", 1.5)
        running.hold("a", 0.5)
        return end(running)


def a_crate_in_hand_stays_there(folder, environment):
    tape = folder / "session.tape"
    slot = folder / "data" / "plumbline" / "saves" / "garden-1.save"
    state = play_with_a_crate_in_hand(folder, environment, tape, slot)
    expect("grab" in Recording(tape).held, f"nothing is in the hand at the end: {Recording(tape).held}")
    said = run("play", "--load", slot, "--replay", tape, "--size", "320x180", "--no-sound", "--expect-hash", state,
               environment=environment)
    expect(state_of(said) == state, "the game that was loaded ends elsewhere:\n" + said)
    expect("differs" not in said, said)


def the_keys_save_and_load(folder, environment):
    slot = folder / "data" / "plumbline" / "saves" / "playroom-1.save"
    with playing(environment, folder, "playroom") as running:
        running.press("p", pause_s=1)
        running.press("F5")
        wait_for(slot, running)
        saved = end(running)
    with playing(environment, folder, "playroom") as running:
        running.press("p", pause_s=1)
        running.press("F9", pause_s=2)
        expect(end(running) == saved, "F9 did not bring back what F5 saved")
    # A damaged one leaves what runs, and says so.
    slot.write_bytes(slot.read_bytes()[:-1])
    with playing(environment, folder, "playroom") as running:
        running.press("F9", pause_s=2)
        expect("a saved game cut short" in running.log(), running.log())
        expect(running.process.poll() is None, "it ended")
    run("play", "playroom", "--load", slot, "--no-sound", environment=environment, code=4, says="a saved game cut short")


with virtual_screen() as screen:
    for test in (goes_on_to_the_same_bits, what_is_no_saved_game_is_refused_and_named, a_full_disk_leaves_the_save_before,
                 a_crate_in_hand_stays_there, the_keys_save_and_load):
        with home() as folder:
            test(folder, settings_in(folder, screen))
