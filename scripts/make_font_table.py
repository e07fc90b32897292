#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write src/draw/font_table.inc: the glyph outlines that PNG pictures use for text.

Usage: make_font_table.py Roboto-Regular.ttf > src/draw/font_table.inc
Needs the Debian packages python3-fonttools and fonts-roboto-unhinted (Roboto, Copyright 2011
Google Inc., Apache-2.0). Run only to add glyphs; the result is kept in the repository.

One glyph is a line {code point, advance, outline}. Lengths are in 1/1024 em. The outline is a
string of points, each four characters of a base-64 alphabet that begins at '#'. Two characters
are x + 512, plus 2048 if the point is a control point of a quadratic curve. Two characters are
y + 512, plus 2048 if the point ends its contour.
"""
import sys

from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont

EXTRA = "°·±²³µ×ΔΣαβγδεθλπτφω–—‘’“”…−≤≥≈∞•√"


def digits(value):
    return chr(35 + value // 64) + chr(35 + value % 64)


def outline(glyphs, name, scale):
    pen = DecomposingRecordingPen(glyphs)
    glyphs[name].draw(pen)
    contours, now = [], []
    for verb, points in pen.value:
        if verb == "moveTo":
            now = [(points[0], False)]
        elif verb == "lineTo":
            now.append((points[0], False))
        elif verb == "qCurveTo":
            now += [(p, True) for p in points[:-1] if p is not None]
            if points[-1] is not None:
                now.append((points[-1], False))
        elif verb in ("closePath", "endPath"):
            if len(now) > 1 and now[0] == now[-1]:
                now.pop()
            contours.append(now)
    text = ""
    for contour in contours:
        for i, ((x, y), off) in enumerate(contour):
            text += digits(round(x * scale) + 512 + 2048 * off)
            text += digits(round(y * scale) + 512 + 2048 * (i == len(contour) - 1))
    return text


def main():
    font = TTFont(sys.argv[1])
    scale = 1024 / font["head"].unitsPerEm
    glyphs, cmap = font.getGlyphSet(), font.getBestCmap()
    print("// SPDX-License-Identifier: Apache-2.0")
    print("// Outlines of Roboto Regular, Copyright 2011 Google Inc., Apache-2.0.")
    print("// Written by scripts/make_font_table.py, which describes the encoding. Do not edit.")
    for char in [chr(c) for c in range(32, 127)] + sorted(EXTRA):
        if ord(char) not in cmap:
            print(f"no glyph for {char}", file=sys.stderr)
            continue
        name = cmap[ord(char)]
        text = outline(glyphs, name, scale)
        lines = [text[i : i + 88] for i in range(0, len(text), 88)] or [""]
        body = "\n     ".join(f'R"({line})"' for line in lines)
        print(f"    {{0x{ord(char):X}, {round(font['hmtx'][name][0] * scale)},\n     {body}}},")


main()
