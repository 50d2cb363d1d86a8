#!/usr/bin/env python3
"""Writes assets/thumbnails/: the small pictures of scenes that the menu shows, 320 x 180.

    python3 assets/source/make_thumbnails.py PROGRAM

PROGRAM is the built plumbline. It needs ImageMagick's convert. Pictures are taken large and
reduced, so that edges are smooth.
"""
import pathlib
import subprocess
import sys
import tempfile

ASSETS = pathlib.Path(__file__).resolve().parent.parent
# Scene -> seconds before the picture, and the camera x,y,z,yaw,pitch where the scene's own is far off.
SCENES = {
    "garden": (1.0, None),
    "falling_cube": (1.15, "3.2,2.0,5,32,-8"),
    "pile": (1.6, None),
    "playroom": (1.0, None),
    "joints": (0.8, "1.2,2.6,7.2,4,-9"),
    "hard/H01": (1.0, None),
    "hard/H05": (1.0, None),
    "hard/H12": (0.5, None),
    "hard/H14": (0.5, None),
    "hard/H17": (0.5, None),
    "hard/H30": (2.0, None),
    "hard/H34": (0.5, None),
}


def picture(program, scene, seconds, camera, folder):
    large, small = folder / "large.png", ASSETS / "thumbnails" / f"{scene}.jpg"
    small.parent.mkdir(parents=True, exist_ok=True)
    where = [f"--camera={camera}"] if camera else []
    subprocess.run([program, "render", scene, "--size", "1280x720", "--at", str(seconds), "--out", str(large), *where],
                   check=True)
    subprocess.run(["convert", str(large), "-filter", "Box", "-resize", "320x180", "-strip", "-quality", "86", str(small)],
                   check=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as text:
        for name, (at_s, view) in SCENES.items():
            picture(sys.argv[1], name, at_s, view, pathlib.Path(text))
