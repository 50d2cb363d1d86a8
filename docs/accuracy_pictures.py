#!/usr/bin/python3
"""Takes the pictures of ACCURACY.md out of the page of a study: docs/accuracy_pictures.py DIR/report.html

Each becomes an SVG of its own on light paper, drawn by the page's own plotting code.
"""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

SVG = "http://www.w3.org/2000/svg"
FOLDER = pathlib.Path(__file__).resolve().parent / "pictures"

# File: subject of the study, and which of its two diagrams.
PICTURES = {
}


def figure_of(page, subject, kind):
    """The diagram "cost" or "step" of a subject."""
    for section in page.iter("section"):
        title = section.find("h2")
        if title.text != subject and not title.text.startswith(subject + ":"):
            continue
        for figure in section.iter("figure"):
            if figure.get("id").endswith("-" + kind):
                return figure.find(f"{{{SVG}}}svg")
    sys.exit(f"the page has no diagram of error against {kind} for {subject}")


def standalone(picture):
    width, height = picture.get("viewBox").split()[2:]
    picture.set("width", width)
    picture.set("height", height)
    paper = ElementTree.Element(f"{{{SVG}}}rect", {"width": width, "height": height, "fill": "#fbfbf9"})
    picture.insert(0, paper)
    return ElementTree.tostring(picture, encoding="unicode")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.splitlines()[0])
    ElementTree.register_namespace("", SVG)
    ElementTree.register_namespace("xlink", "http://www.w3.org/1999/xlink")
    text = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    page = ElementTree.fromstring(text.split("\n", 1)[1])  # XML but for its first line
    for name, (subject, kind) in PICTURES.items():
        path = FOLDER / name
        path.write_text(standalone(figure_of(page, subject, kind)) + "\n", encoding="utf-8")
        print(path)


if __name__ == "__main__":
    main()
