#!/usr/bin/env python3
"""Draws where the time of a run went: plumbline simulate SCENE --trace-events FILE; flame_graph.py OUT.svg TITLE=FILE…

One row of boxes for each depth of spans, each as wide as its share of the steps' time; spans of the same names within the
same spans are one box. Several files are drawn one below the other, to one scale: the first file's."""
import html
import json
import sys
from pathlib import Path

WIDTH, ROW, MARGIN, HEAD = 1000, 22, 10, 26
LEAST_LABELLED = 34  # px


class Box:
    """All spans of one name within the same spans."""

    def __init__(self, name):
        self.name, self.ms, self.within = name, 0.0, {}

    def child(self, name):
        return self.within.setdefault(name, Box(name))

    def depth(self):
        return 1 + max((box.depth() for box in self.within.values()), default=0)


def boxes_of(path):
    """The steps of all threads as one tree."""
    root = Box("")
    spans = [event for event in json.loads(Path(path).read_text()) if event["ph"] == "X"]
    spans.sort(key=lambda span: (span["tid"], span["ts"], -span["dur"]))
    open_spans = []  # (end, box)
    thread = None
    for span in spans:
        if span["tid"] != thread:
            thread, open_spans = span["tid"], []
        while open_spans and open_spans[-1][0] <= span["ts"]:
            open_spans.pop()
        box = (open_spans[-1][1] if open_spans else root).child(span["name"])
        box.ms += span["dur"] / 1000
        open_spans.append((span["ts"] + span["dur"], box))
    root.ms = sum(box.ms for box in root.within.values())
    return root


def color_of(name):
    hue = sum(ord(letter) * (i + 3) for i, letter in enumerate(name)) % 60
    return f"hsl({hue},75%,{68 + hue % 12}%)"


def draw(box, left, top, px_per_ms, total_ms, svg):
    width = box.ms * px_per_ms
    if width < 0.4:
        return
    share = f"{box.name}: {box.ms:.1f} ms, {100 * box.ms / total_ms:.1f} %"
    svg.append(f'<g><title>{html.escape(share)}</title><rect x="{left:.1f}" y="{top}" width="{width:.1f}" '
               f'height="{ROW - 1}" fill="{color_of(box.name)}"/>')
    if width > LEAST_LABELLED:
        label = f"{box.name} {100 * box.ms / total_ms:.0f} %"
        letters = int(width / 6.3)
        label = label if len(label) <= letters else box.name[:letters]
        svg.append(f'<text x="{left + 3:.1f}" y="{top + 15}">{html.escape(label)}</text>')
    svg.append("</g>")
    for inner in box.within.values():
        draw(inner, left, top + ROW, px_per_ms, total_ms, svg)
        left += inner.ms * px_per_ms


def main(out, *graphs):
    trees = [(title, boxes_of(path)) for title, path in (graph.split("=", 1) for graph in graphs)]
    px_per_ms = WIDTH / trees[0][1].ms
    svg, top = [], MARGIN
    for title, tree in trees:
        svg.append(f'<text x="{MARGIN}" y="{top + 16}" class="title">{html.escape(title)}: {tree.ms:.0f} ms</text>')
        top += HEAD
        left = MARGIN
        for box in tree.within.values():
            draw(box, left, top, px_per_ms, tree.ms, svg)
            left += box.ms * px_per_ms
        top += (tree.depth() - 1) * ROW + MARGIN
    right = max(tree.ms for _, tree in trees) * px_per_ms
    Path(out).write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {right + 2 * MARGIN:.0f} {top}" '
                         'font-family="sans-serif" font-size="12"><style>.title{font-size:14px;font-weight:bold}</style>'
                         f'<rect width="100%" height="100%" fill="white"/>{"".join(svg)}</svg>\n')


if __name__ == "__main__":
    if len(sys.argv) < 3 or not all("=" in word for word in sys.argv[2:]):
        sys.exit(__doc__)
    main(*sys.argv[1:])
