#!/usr/bin/python3
"""The report pages from outside: what the program writes, and, where node is, what the page's scripts make of it.

page.py FIXTURE: the program that writes awkward pages.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[3]
SVG = "{http://www.w3.org/2000/svg}"
FOLDER = pathlib.Path(tempfile.mkdtemp())
SCRIPT = re.compile(r"<script([^>]*)>\n(.*?)</script>", re.DOTALL)
PAGES = ("study", "stability", "empty")


def text_of(name):
    return (FOLDER / f"{name}.html").read_text(encoding="utf-8")


def findings(name):
    return json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))


def drawn(name, *words):
    done = subprocess.run(["node", HERE / "draw_page.js", FOLDER / f"{name}.html", *words], capture_output=True, text=True,
                          check=True, timeout=60)
    return ElementTree.fromstring(done.stdout)


def said(element):
    return " ".join("".join(element.itertext()).split())


def cells(element):
    return [[said(cell) for cell in row.iter("td")] for row in element.iter("tr")]


class Written(unittest.TestCase):
    def test_loads_nothing(self):
        for name in PAGES:
            text = text_of(name)
            for part in ("src=\"", "<link", "@import", "url("):
                self.assertNotIn(part, text.replace('src="data:', ""), name)
            self.assertEqual({"http://www.w3.org/2000/svg"}, set(re.findall(r"https?://[^\"' `<)]+", text)), name)

    def test_findings_are_embedded_and_stay_in_their_element(self):
        for name in PAGES:
            scripts = SCRIPT.findall(text_of(name))
            self.assertEqual(len(scripts), 11, name)
            self.assertEqual(text_of(name).count("</script"), 11, name)
            embedded = json.loads(dict((attributes, text) for attributes, text in scripts)
                                  [' type="application/json" id="findings"'])
            for key, value in findings(name).items():
                self.assertEqual(embedded[key], value, f"{name} {key}")
        self.assertIn("</script><script>alert(1)</script>", findings("study")["subjects"][1]["id"])


@unittest.skipUnless(shutil.which("node"), "no node here")
class Drawn(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = drawn("study")

    def section(self, anchor):
        return next(each for each in self.page.iter("section") if each.get("id") == anchor)

    def test_every_run_has_a_row_with_its_errors(self):
        for i, subject in enumerate(findings("study")["subjects"]):
            section = self.section(f"s{i + 1}")
            rows = [cells(details) for details in section.iter("details") if re.fullmatch(r"All \d+ runs", said(details.find("summary")))]
            rows = rows[0][1:] if rows else []
            self.assertEqual(len(rows), len(subject["points"]))
            for row, point in zip(rows, subject["points"]):
                setting = point["setting"]
                self.assertTrue(row[0].startswith(f"{setting['solver']} {setting['step_hz']} Hz"), row)
                self.assertEqual(row[1], f"{point['status']}: {point['why']}" if point["why"] else point["status"])
                for shown, error in zip(row[2:], point["errors"]):
                    if error is None:
                        self.assertEqual(shown, "not a number")
                    elif abs(error) >= 1e-5:
                        self.assertAlmostEqual(float(shown.removesuffix(" %")) / 100 / error, 1, delta=0.006)
            for verdict in subject["verdicts"]:
                self.assertIn(verdict["held"], said(section))
            for text in [subject["set_up"], subject["reference"], subject["id"], *subject["notes"],
                         *(metric["scale"] for metric in subject["metrics"])]:
                self.assertIn(" ".join(text.split()), said(section))

    def test_advice_comes_first_and_then_the_diagram(self):
        section = self.section("s1")
        # 2 % at 60 Hz and first order: 1 % at 120 Hz, for 0.04 ms a second.
        self.assertEqual(said(section[1]), "Use small_step 120 Hz x 1: it is 1 % off and takes 0.000667 ms of a 16.7 ms frame on one core. "
                         "For 1 % small_step, float64 takes 1 times as long (120 Hz x 1). Not within 1 % at any setting: bullet_si. "
                         "0.1 % costs 16 times as much: small_step 480 Hz x 4.")
        self.assertEqual(section[2].tag, "figure")
        self.assertEqual(said(self.section("s3")[1]), "No run was made.")

    def test_diagrams(self):
        images = {section.get("id"): [image.get("aria-label").split(":")[0] for image in section.iter(f"{SVG}svg")]
                  for section in self.page.iter("section")}
        both = ["Error against cost", "Error against step"]
        self.assertEqual([images[f"s{i}"] for i in (1, 2, 3, 4)], [both, both, [], both[:1]])
        self.assertEqual(images["image1"], ["Error of the image of yard.toml against its cost"])
        cost = next(self.section("s1").iter(f"{SVG}svg"))
        tips = [title.text for title in cost.iter(f"{SVG}title")]
        runs = [tip for tip in tips if tip.startswith(("small_step", "bullet_si"))]
        self.assertEqual(len(runs), len(findings("study")["subjects"][0]["points"]))
        self.assertTrue(any(tip.startswith("ode-lcp 60 Hz: ") for tip in tips), tips)
        self.assertIn("Jolt Physics 9.9 (wasm) 60 Hz, 50 iterations: 2 %, 0.1 ms a frame", tips)
        self.assertIn("ODE 0.1, 60 Hz: refused: it lacks a cone", said(self.section("s1")))

    def test_both_layouts_hold_the_same(self):
        narrow = drawn("study", "narrow")
        self.assertEqual(cells(narrow), cells(self.page))
        self.assertIn("0 0 380 ", next(narrow.iter(f"{SVG}svg")).get("viewBox"))

    def test_warnings_images_and_effects(self):
        text = said(self.page)
        for part in ("Interrupted: this page has what was done by then.", "The clock of this machine was noisy",
                     "plumbline study 'a & b' <\"c\">", "1 of 36 runs failed: 1 exploded.", "exploded: faster than <1e4> m/s"):
            self.assertIn(part, text)
        self.assertIn(["level <high>", "10 %", "5 %", "50", "what the others are compared to"], cells(self.section("image1")))
        self.assertIn("The most expensive effect is wind <1>: switching it off saves 0.5 ms.", text)
        self.assertIn(["wind <1>", "step", "0.5 \u00b1 0.1", "below the noise (\u00b1 0.01)", "120", "0 KiB", "0 KiB", "[wind] (a.toml:3)"],
                      cells(self.section("effects1")))

    def test_no_findings(self):
        self.assertIn("No subject was studied.", said(drawn("empty")))

    def test_a_scene_is_named_by_its_title_and_its_file(self):
        heads = [said(head) for head in self.page.iter("h2")]
        self.assertIn("a chain hangs ]]> `date` $x {y} (script> & 'co')", heads)
        self.assertIn("a ball falls (A01)", heads)

    def test_stability(self):
        page = drawn("stability")
        rows = {row.get("id"): row for row in page.iter("tr") if row.get("id")}
        shown = {name: [" ".join(" ".join(cell.itertext()).split()) for cell in row if cell.get("class") in ("pass", "fail", "none")] for name, row in rows.items()}
        self.assertEqual(shown, {
            "H01": ["pass 63 % inside sag_m at most 1 1.5 ms/s 0.25 J braked in 2 islands", "FAIL its worker <crashed>"],
            "H02": ["FAIL 25 % outside sag_m at most 1 1.5 ms/s", "not run"]})
        image = next(rows["H01"].iter("img"))
        self.assertEqual(image.get("src"), "data:image/png;base64,TWE=")
        self.assertIsNone(next(rows["H02"].iter("img"), None))
        for part in ("small_step fails \"sag_m\", it reaches 2: not <yet>", "it reaches nothing: a body is gone: so",
                     "0 s, nightly", "Known to fail: most & all.", "It stands."):
            self.assertIn(part, said(rows["H02"]))
        self.assertIn(["small_step 60 Hz", "sag_m at most 1", "0.37", "63 % inside", "box 2 s"], cells(rows["H01"]))
        for part in ("no images: <why>", "Interrupted", "Use small_step at 60 Hz: it passes 1 of 2 hard cases"):
            self.assertIn(part, said(page))


if __name__ == "__main__":
    subprocess.run([sys.argv[1], FOLDER], check=True, timeout=100, env={**os.environ, "PLUMBLINE_DATA": str(ROOT)})
    unittest.main(argv=sys.argv[:1])
