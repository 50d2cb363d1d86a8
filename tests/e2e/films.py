#!/usr/bin/python3
"""Every frame as an image, and films: what ffmpeg is told and handed, and when there is none.

SOURCES C16. A stand-in for ffmpeg keeps its words and counts what it is given: the test needs none. Where
ffmpeg is installed, what it wrote is also played.
"""

import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from support import Program, settings_in, virtual_screen

PROGRAM = pathlib.Path(sys.argv[1])
SCENE = "viewer/shapes"
WIDTH, HEIGHT = 80, 60

STAND_IN = """#!/bin/sh
printf '%s\\n' "$@" > "$FILM_WORDS"
{body}
"""


def run(folder, path, *words, size=(WIDTH, HEIGHT), file_bytes=None):
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))

    environment = dict(os.environ, HOME=str(folder), PATH=path, FILM_WORDS=str(folder / "words"),
                       FILM_BYTES=str(folder / "bytes"))
    return subprocess.run([PROGRAM.resolve(), "render", SCENE, "--size", "{}x{}".format(*size), *words],
                          cwd=folder, env=environment, capture_output=True, text=True, timeout=120,
                          preexec_fn=limit if file_bytes else None)


def with_stand_in(folder, body):
    tools = folder / "tools"
    tools.mkdir()
    (tools / "ffmpeg").write_text(STAND_IN.format(body=body))
    (tools / "ffmpeg").chmod(0o755)
    return f"{tools}:/usr/bin:/bin"


def images_of_every_frame(folder):
    shown = run(folder, "/usr/bin:/bin", "--frames", "3", "--orbit", "90", "--out", "all")
    assert shown.returncode == 0, shown
    files = sorted(file.name for file in (folder / "all").iterdir())
    assert files == ["frame_00001.png", "frame_00002.png", "frame_00003.png"], files
    contents = {file.read_bytes() for file in (folder / "all").iterdir()}
    assert len(contents) == 3, "the camera goes round"


def one_image_as_before(folder):
    shown = run(folder, "/usr/bin:/bin", "--frames", "3", "--out", "last.png")
    assert shown.returncode == 0 and (folder / "last.png").is_file(), shown


def a_film_is_handed_to_ffmpeg(folder):
    path = with_stand_in(folder, 'cat > "$FILM_BYTES"')
    shown = run(folder, path, "--frames", "5", "--video", "odd name.mp4")
    assert shown.returncode == 0, shown
    words = (folder / "words").read_text().splitlines()
    assert words[words.index("-s") + 1] == f"{WIDTH}x{HEIGHT}", words
    assert words[words.index("-r") + 1] == "60", words
    assert words[-1].startswith("file:"), words
    assert (folder / "bytes").stat().st_size == 5 * WIDTH * HEIGHT * 3


def no_ffmpeg_is_said(folder):
    (folder / "empty").mkdir()
    shown = run(folder, str(folder / "empty"), "--frames", "5", "--video", "a.mp4")
    assert shown.returncode == 1, shown
    assert "films are written by ffmpeg, which is not installed" in shown.stderr, shown


def an_ffmpeg_that_stops_is_said(folder):
    path = with_stand_in(folder, f"head -c {WIDTH * HEIGHT * 3} > \"$FILM_BYTES\"; exit 3")
    shown = run(folder, path, "--frames", "40", "--video", "a.mp4")
    assert shown.returncode == 1, shown
    assert "the film a.mp4 was not written: ffmpeg ended with exit code 3\n" in shown.stderr, shown


def box(name, content):
    return (8 + len(content)).to_bytes(4, "big") + name + content


def half_a_fragment_is_cut_off(folder):
    whole = box(b"ftyp", b"isom") + box(b"moov", b"m" * 40) + box(b"moof", b"f" * 20) + box(b"mdat", b"d" * 99)
    for rest in (box(b"moof", b"f" * 20), box(b"moof", b"f" * 20) + box(b"mdat", b"d" * 99)[:50], b"\0\0\0"):
        with tempfile.TemporaryDirectory() as place:
            place = pathlib.Path(place)
            (place / "some").write_bytes(whole + rest)
            body = f'for last; do :; done; cp {place}/some "${{last#file:}}"; echo "No space left" >&2; echo more >&2; exit 1'
            shown = run(place, with_stand_in(place, body), "--frames", "9", "--video", "a.mp4")
            assert shown.returncode == 1, shown
            assert shown.stderr.count("ffmpeg ended with exit code 1 (No space left); what was written") == 1, shown
            assert (place / "a.mp4").read_bytes() == whole, len(rest)


def an_earlier_film_stays_until_the_new_one_is_whole(folder):  # FAULTS N11
    film = folder / "a.mp4"
    film.write_text("earlier")
    film.chmod(0o600)
    into_its_file = 'for last; do :; done; cat > "${last#file:}"'
    path = with_stand_in(folder, f"{into_its_file}; exit 3")
    shown = run(folder, path, "--frames", "3", "--video", "a.mp4")
    assert shown.returncode == 1 and "ffmpeg ended with exit code 3; the earlier one stays\n" in shown.stderr, shown
    assert film.read_text() == "earlier"
    for number, code in ((signal.SIGTERM, 130), (signal.SIGKILL, -signal.SIGKILL)):
        environment = dict(os.environ, HOME=str(folder), PATH=path, FILM_WORDS=str(folder / "words"))
        running = subprocess.Popen([PROGRAM.resolve(), "render", SCENE, "--size", "80x60", "--frames", "100000", "--video", "a.mp4"],
                                   cwd=folder, env=environment, stderr=subprocess.PIPE, text=True)
        while not any(part.stat().st_size for part in folder.glob(".plumbline-saving-*")):
            assert running.poll() is None, running.communicate()
            time.sleep(0.05)
        running.send_signal(number)
        assert running.wait(60) == code, running.communicate()
        assert film.read_text() == "earlier"
        # Killed it could not remove what it had begun.
        left = list(folder.glob(".plumbline-saving-*"))
        assert len(left) == (number == signal.SIGKILL) and all(part.suffix == ".mp4" for part in left), left
        for part in left:
            part.unlink()
    (folder / "tools/ffmpeg").write_text(STAND_IN.format(body=into_its_file))
    shown = run(folder, path, "--frames", "3", "--video", "a.mp4")
    assert shown.returncode == 0 and film.stat().st_size == 3 * WIDTH * HEIGHT * 3, shown
    assert film.stat().st_mode & 0o777 == 0o600 and not list(folder.glob(".plumbline-saving-*"))


def frames_that_play(film):
    """All of them decode without a word."""
    played = subprocess.run(["ffmpeg", "-v", "error", "-i", film, "-f", "null", "-"], capture_output=True, text=True)
    assert played.returncode == 0 and played.stderr == "", played
    told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames", "-of",
                           "csv=p=0", film], capture_output=True, text=True)
    return int(told.stdout.strip().rstrip(","))


def is_there(program):
    if shutil.which(program) is None:
        print(f"{program} is not installed: not tried")
    return shutil.which(program) is not None


def a_film_plays(folder):  # odd sides too
    if not is_there("ffmpeg"):
        return
    shown = run(folder, os.environ["PATH"], "--frames", "40", "--orbit", "90", "--video", "a.mp4", size=(81, 61))
    assert shown.returncode == 0, shown
    assert frames_that_play(folder / "a.mp4") == 40


def a_full_disk_leaves_a_film_that_plays(folder):  # stands for a full disk: no file may grow further
    if not is_there("ffmpeg"):
        return
    shown = run(folder, os.environ["PATH"], "--frames", "240", "--orbit", "360", "--video", "a.mp4", size=(320, 240),
                file_bytes=120_000)
    assert shown.returncode == 1, shown
    assert shown.stderr.count("a.mp4 is not whole: ffmpeg ended with exit code ") == 1, shown
    assert "File too large); what was written until then plays" in shown.stderr, shown
    assert 30 <= frames_that_play(folder / "a.mp4") < 240


def films_in(folder, body, act):
    """Plays with a film being taken; gives the log and the films."""
    with virtual_screen("640x360") as environment:
        environment = settings_in(folder, environment)
        if body:
            environment["PATH"] = with_stand_in(folder, body)
        game = Program([PROGRAM, "play", "falling_cube", "--size", "320x180", "--no-sound"], environment, folder / "log.txt")
        try:
            time.sleep(2)
            game.press("shift+F12")
            time.sleep(3)
            act(game)
        finally:
            game.stop()
    return game.log(), sorted((folder / "data" / "plumbline" / "films").glob("*.mp4"))


def a_window_that_closes_ends_the_film(folder):
    if not is_there("ffmpeg") or not is_there("xdotool"):
        return

    def close(game):
        game.process.send_signal(signal.SIGTERM)
        assert game.wait(30) == 130, game.log()

    log, films = films_in(folder, None, close)
    assert log.count("video saved: ") == 1 and len(films) == 1, log
    assert frames_that_play(films[0]) >= 10
    told = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "format=duration", "-of", "csv=p=0", films[0]],
                          capture_output=True, text=True)
    assert 2 < float(told.stdout) < 10, "as long as it was taken, however many images there were"


def a_film_that_breaks_is_told_and_play_goes_on(folder):
    if not is_there("xdotool"):
        return

    def look(game):
        for _ in range(100):
            if "was not written" in game.log():
                break
            time.sleep(0.1)
        game.press("shift+F12")
        time.sleep(1)
        game.process.send_signal(signal.SIGTERM)
        assert game.wait(30) == 130, game.log()

    log, _ = films_in(folder, "head -c 1000 >/dev/null; exit 3", look)
    # Once while it is taken, and once of the next one, when the game ends or before.
    assert log.count("was not written: ffmpeg ended with exit code 3") == 2, log


TESTS = (images_of_every_frame, one_image_as_before, a_film_is_handed_to_ffmpeg, no_ffmpeg_is_said,
         an_ffmpeg_that_stops_is_said, half_a_fragment_is_cut_off,
         an_earlier_film_stays_until_the_new_one_is_whole, a_film_plays, a_full_disk_leaves_a_film_that_plays,
         a_window_that_closes_ends_the_film, a_film_that_breaks_is_told_and_play_goes_on)

if __name__ == "__main__":
    for test in TESTS:
        with tempfile.TemporaryDirectory() as place:
            test(pathlib.Path(place))
        print(f"{test.__name__}: good")
