#!/usr/bin/python3
"""The page of a study as a reader of XML and HTML sees it, diagrams included.

page.py FIXTURE: the program that writes an awkward page. Diagrams are expected where gnuplot is.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

SVG = "{http://www.w3.org/2000/svg}"
ROOT = pathlib.Path(__file__).resolve().parents[4]
RUNS = 36  # of a sample subject


def page(gnuplot):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], folder], check=True, timeout=100,
                       env={**os.environ, "PLUMBLINE_GNUPLOT": gnuplot, "PLUMBLINE_DATA": str(ROOT)})
        text = (pathlib.Path(folder) / "report.html").read_text(encoding="utf-8")
    # HTML of our kind is XML but for its first line.
    return text, ElementTree.fromstring(text.split("\n", 1)[1])


def texts(root):
    return "\n".join(root.itertext())


class Page(unittest.TestCase):
    def check_any(self, text, root):
        ids = [element.get("id") for element in root.iter() if element.get("id")]
        self.assertEqual(len(ids), len(set(ids)), "an id is there twice")
        links = [element.get("href") for element in root.iter("a")]
        for link in links:
            self.assertTrue(link in ("findings.json", "findings.csv") or link[1:] in ids, link)
        for name in ("src=", "<script", "<link", "@import", "url("):
            self.assertNotIn(name, text)
        self.assertEqual([], [found for found in re.findall(r"https?://[^\"' <]+", text)
                              if not found.startswith("http://www.w3.org/")])
        said = texts(root)
        for part in ("A15 </h2> & 'co'", "a chain hangs ]]> `date` $x {y}", "faster than <1e4> m/s",
                     "plumbline study 'a & b' <\"c\">\N{REPLACEMENT CHARACTER}", "No run was made.", "Interrupted"):
            self.assertIn(part, said)
        rows = [row for details in root.iter("details") if "runs" in details.find("summary").text
                for row in details.iter("tr")]
        self.assertEqual(len(rows), 2 * RUNS + 1 + 3)  # three subjects, a heading each
        self.assertEqual(sum(row.get("class") == "bad" for row in rows), 1)

    def test_without_gnuplot(self):
        text, root = page("no-such-drawer")
        self.check_any(text, root)
        self.assertIsNone(root.find(f".//{SVG}svg"))
        self.assertIn("No diagrams: cannot start no-such-drawer", texts(root))

    @unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot here")
    def test_with_gnuplot(self):
        text, root = page("gnuplot")
        self.check_any(text, root)
        images = root.findall(f".//{SVG}svg")
        # Two for each subject with runs at several steps, one for the single run, none for the empty one.
        self.assertEqual([image.get("aria-label").split(":")[0] for image in images],
                         ["Error against cost", "Error against step"] * 2 + ["Error against cost"])
        plain, chain = images[0], images[2]
        # Symbols are uses of shapes: one a run, one in the key for each of six lines, and the rings with theirs.
        rings = [use for use in plain.iter(f"{SVG}use") if use.get("color") == "rgb(  0,   0,   0)"]
        runs = [use for use in plain.iter(f"{SVG}use") if (use.get("color") or "").startswith("rgb(") and use not in rings]
        self.assertEqual(len(runs), RUNS + 6)
        self.assertGreater(len(rings), 2)
        self.assertIn("ode-lcp", texts(chain))
        self.assertNotIn("ode-lcp", texts(plain))
        self.assertIn("All ", texts(root))
        self.assertNotIn("This diagram is missing", texts(root))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
