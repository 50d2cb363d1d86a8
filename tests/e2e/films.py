#!/usr/bin/python3
"""Every frame as a picture, and films: what ffmpeg is told and handed, and when there is none.

SOURCES C16. A stand-in for ffmpeg keeps its words and counts what it is given: the test needs none.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[1])
SCENE = "viewer/shapes"
WIDTH, HEIGHT = 80, 60

STAND_IN = """#!/bin/sh
printf '%s\\n' "$@" > "$FILM_WORDS"
{body}
"""


def run(folder, path, *words):
    environment = dict(os.environ, HOME=str(folder), PATH=path, FILM_WORDS=str(folder / "words"),
                       FILM_BYTES=str(folder / "bytes"))
    return subprocess.run([PROGRAM.resolve(), "render", SCENE, "--size", f"{WIDTH}x{HEIGHT}", *words],
                          cwd=folder, env=environment, capture_output=True, text=True, timeout=120)


def with_stand_in(folder, body):
    tools = folder / "tools"
    tools.mkdir()
    (tools / "ffmpeg").write_text(STAND_IN.format(body=body))
    (tools / "ffmpeg").chmod(0o755)
    return f"{tools}:/usr/bin:/bin"


def pictures_of_every_frame(folder):
    shown = run(folder, "/usr/bin:/bin", "--frames", "3", "--orbit", "90", "--out", "all")
    assert shown.returncode == 0, shown
    files = sorted(file.name for file in (folder / "all").iterdir())
    assert files == ["frame_00001.png", "frame_00002.png", "frame_00003.png"], files
    contents = {file.read_bytes() for file in (folder / "all").iterdir()}
    assert len(contents) == 3, "the camera goes round"


def one_picture_as_before(folder):
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
    assert "ffmpeg ended with exit code 3; what was written until then plays" in shown.stderr, shown


TESTS = (pictures_of_every_frame, one_picture_as_before, a_film_is_handed_to_ffmpeg, no_ffmpeg_is_said,
         an_ffmpeg_that_stops_is_said)

if __name__ == "__main__":
    for test in TESTS:
        with tempfile.TemporaryDirectory() as place:
            test(pathlib.Path(place))
        print(f"{test.__name__}: good")
