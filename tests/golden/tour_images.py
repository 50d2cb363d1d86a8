#!/usr/bin/python3
"""The tours of garden and fairground, twenty cameras, against images that were looked at.

    tour_images.py make PLUMBLINE    draws tests/golden/tour/SCENE/*.png anew: look at them first
    tour_images.py check PLUMBLINE   an image may be off by MEAN on average, and by FAR in few places

Another driver rounds otherwise along edges; a light, a shadow or a thing that is missing shows.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/e2e"))
from png import read_png  # noqa: E402

GOLDEN = ROOT / "tests/golden/tour"
SCENES = {"garden": 15, "fairground": 5}
SIZE = "320x180"
MEAN = 1.0          # of 255
FAR = 32            # of 255, in any colour
FAR_SHARE = 0.01    # of the pixels


def draw(program, scene, folder):
    subprocess.run([program, "--safe", "--quiet", "tour", scene, "--size", SIZE, "--out", str(folder)],
                   cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    (folder / "contact_sheet.png").unlink()
    return sorted(folder.glob("*.png"))


def difference(one, other):
    """(mean difference of a colour, share of pixels that are far off)."""
    total, far, count = 0, 0, 0
    for a_row, b_row in zip(one, other, strict=True):
        for a, b in zip(a_row, b_row, strict=True):
            parts = [abs(x - y) for x, y in zip(a, b)]
            total += sum(parts)
            far += max(parts) > FAR
            count += 1
    return total / (3 * count), far / count


def check(program):
    faults = []
    for scene, count in SCENES.items():
        with tempfile.TemporaryDirectory() as folder:
            drawn = draw(program, scene, pathlib.Path(folder))
            wanted = sorted((GOLDEN / scene).glob("*.png"))
            names = [file.name for file in drawn]
            if names != [file.name for file in wanted] or len(names) != count:
                faults.append(f"{scene}: the tour has {names}")
                continue
            for ours, theirs in zip(drawn, wanted):
                mean, far = difference(read_png(ours), read_png(theirs))
                print(f"{scene}/{ours.name}: mean {mean:.3f} of 255, {100 * far:.2f} % far off")
                if mean > MEAN or far > FAR_SHARE:
                    faults.append(f"{scene}/{ours.name} is another image")
    return faults


def make(program):
    for scene in SCENES:
        with tempfile.TemporaryDirectory() as folder:
            shutil.rmtree(GOLDEN / scene, ignore_errors=True)
            (GOLDEN / scene).mkdir(parents=True)
            for file in draw(program, scene, pathlib.Path(folder)):
                shutil.copy(file, GOLDEN / scene / file.name)


if __name__ == "__main__":
    if sys.argv[1:2] == ["make"]:
        make(sys.argv[2])
    else:
        found = check(sys.argv[2])
        print(*found, sep="\n")
        sys.exit(bool(found))
