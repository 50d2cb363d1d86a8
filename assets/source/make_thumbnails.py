#!/usr/bin/env python3
"""Writes assets/thumbnails/: the small images of scenes that the menu shows, 320 x 180; those of
the hard cases, of which there are many, 256 x 144.

    python3 assets/source/make_thumbnails.py PROGRAM [SCENE ...]

PROGRAM is the built plumbline; without scenes all are made. It needs ImageMagick's convert. Images
are taken large and reduced, so that edges are smooth.
"""
import math
import pathlib
import subprocess
import sys
import tempfile
import tomllib

ASSETS = pathlib.Path(__file__).resolve().parent.parent
# Scene -> seconds before the image; and where the scene's own camera is far off, x,y,z,yaw,pitch of
# another one, or how many times nearer it goes.
SCENES = {
    "garden": (1.0, None),
    "fairground": (2.0, None),
    "falling_cube": (1.15, "3.2,2.0,5,32,-8"),
    "pile": (1.6, None),
    "playroom": (1.0, None),
    "nature": (1.0, None),
    "pond": (5.0, "5.5,3.5,7.7,40,-22"),
    "ropes": (1.0, "5.6,2.6,8.2,34,-4"),
    "cloth": (2.0, None),
    "smash": (1.0, None),
    "workshop": (8.5, 1.3),
    "museum": (1.0, "-1.2,1.8,8.2,12,-8"),
    "games/tower": (0.5, 1.15),
    "games/ferry": (2.0, 1.15),
    "cans": (1.0, "-0.1,1.9,-2.6,3,-8"),
    "lamps": (0.8, None),
    "joints": (0.8, "1.2,2.6,7.2,4,-9"),
    **{f"effects/{name}": (seconds, None) for name, seconds in
       [("buoyancy", 3.0), ("cloth", 1.5), ("conveyor", 2.5), ("drag", 1.0), ("explosion", 2.3), ("fracture", 1.0),
        ("magnets", 0.3), ("rope", 0.5), ("soft", 2.0), ("vehicles", 2.5), ("water", 1.0), ("wind", 4.0)]},
}
HARD = {
    "hard/E04": (2.0, None),
    "hard/E05": (0.5, None),
    "hard/E06": (1.5, None),
    "hard/E07": (3.0, None),
    "hard/E08": (0.3, None),
    "hard/E09": (0.8, None),
    "hard/E10": (1.0, None),
    "hard/E11": (1.7, None),
    "hard/H01": (1.0, None),
    "hard/H05": (1.0, None),
    "hard/H30": (2.0, None),
    "hard/H36": (0.5, 1.7),
    "hard/H39": (0.5, 1.7),
    "hard/H40": (0.5, 1.6),
    "hard/H41": (0.5, 1.6),
    "hard/H45": (0.5, 1.8),
    "hard/H46": (0.3, 1.6),
    "hard/H50": (0.5, 1.4),
    "hard/H55": (0.2, None),
    "hard/H59": (0.3, 1.5),
    "hard/H60": (0.05, 1.6),
    "hard/H61": (0.5, 2.0),
    "hard/H75": (0.5, 1.5),
    "hard/H77": (0.5, 1.8),
}
SCENES.update({f"hard/{file.stem}": HARD.get(f"hard/{file.stem}", (0.5, None))
               for file in sorted((ASSETS / "scenes" / "hard").glob("*.toml"))})
# The book's stages; where they show what happens, the moment in which it does.
BOOK = {"falling_cube": 1.1, "many_objects": 1.5, "events": 1.9, "trigger": 1.75, "shapes": 1.6, "filters": 1.2}
SCENES.update({f"book/{file.stem}": (BOOK.get(file.stem, 0.1), None)
               for file in sorted((ASSETS / "scenes" / "book").glob("*.toml")) if file.stem != "common"})
SCENES.update({f"viewer/{file.stem}": (0.5, None)
               for file in sorted((ASSETS / "scenes" / "viewer").iterdir()) if file.suffix in (".json", ".toml")})


def nearer(scene, times):
    """The scene's own camera, that many times nearer to what it looks at, as --camera takes it."""
    camera = tomllib.loads((ASSETS / "scenes" / f"{scene}.toml").read_text())["camera"]
    away = [p - t for p, t in zip(camera["position_m"], camera["target_m"])]
    x, y, z = (t + a / times for t, a in zip(camera["target_m"], away))
    yaw, pitch = math.atan2(away[0], away[2]), -math.asin(away[1] / math.dist(away, (0, 0, 0)))
    return f"{x},{y},{z},{math.degrees(yaw)},{math.degrees(pitch)}"


def image(program, scene, seconds, camera, folder):
    large, small = folder / "large.png", ASSETS / "thumbnails" / f"{scene}.jpg"
    small.parent.mkdir(parents=True, exist_ok=True)
    if isinstance(camera, float):
        camera = nearer(scene, camera)
    where = [f"--camera={camera}"] if camera else []
    subprocess.run([program, "render", scene, "--size", "1280x720", "--at", str(seconds), "--out", str(large), *where],
                   check=True)
    size = "256x144" if scene.startswith("hard/") else "320x180"
    subprocess.run(["convert", str(large), "-filter", "Box", "-resize", size, "-strip", "-quality", "86", str(small)],
                   check=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as text:
        for name in sys.argv[2:] or SCENES:
            image(sys.argv[1], name, *SCENES[name], pathlib.Path(text))
