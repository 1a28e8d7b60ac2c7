# The figures of the derivations, drawn here as SVG from what they are about: the trim of a small shape is
# computed, and so is the safe region of a body on a slanting floor. No font, library or picture is needed.

import math
import os

KEPT, LOST, BED, INK, SAFE = "#9fb4cc", "#ee5a2a", "#555555", "#222222", "#8fd694"

# A side view, from the top layer down; '#' is matter.
SHAPE = ["......................",
         "...............####...",
         "..........######......",
         "..............##......",
         "..####................",
         ".######........##.....",
         "########.......##.....",
         ".####..........##.....",
         "..##....####...##.....",
         "..##...######..##.....",
         "..##..########.##....."]


def svg(width, height, parts):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
            f'height="{height}" font-family="sans-serif" font-size="13" fill="{INK}">\n'
            f'<rect width="{width}" height="{height}" fill="white"/>\n' + "\n".join(parts) + "\n</svg>\n")


def text(x, y, words, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" {more}>{words}</text>'


def line(x0, y0, x1, y1, colour=INK, width=1.5, more=""):
    return (f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" stroke="{colour}" '
            f'stroke-width="{width}" {more}/>')


def trimmed(layers):
    """Of layers from the bed up, what three cells below can carry: T[k] = S[k] and d(T[k-1])."""
    kept = [set(layers[0])]
    for layer in layers[1:]:
        kept.append({x for x in layer if kept[-1] & {x - 1, x, x + 1}})
    return kept


def trim():
    layers = [{x for x, c in enumerate(row) if c == "#"} for row in reversed(SHAPE)]
    kept, side = trimmed(layers), 20
    width, height = len(SHAPE[0]) * side + 40, len(SHAPE) * side + 50
    parts = []
    for k, layer in enumerate(layers):
        for x in sorted(layer):
            colour = KEPT if x in kept[k] else LOST
            parts.append(f'<rect x="{20 + x * side}" y="{10 + (len(SHAPE) - 1 - k) * side}" width="{side - 1}" '
                         f'height="{side - 1}" fill="{colour}"/>')
    floor = 10 + len(SHAPE) * side
    parts.append(line(10, floor + 1, width - 10, floor + 1, BED, 2))
    for x, colour, words in ((20, KEPT, "carried, and kept"), (190, LOST, "not carried, or on what is not")):
        parts += [f'<rect x="{x}" y="{floor + 14}" width="14" height="14" fill="{colour}"/>', text(x + 20, floor + 26, words)]
    return svg(width, height, parts)


def tilt():
    """A leaning body, its centre of mass, and what is safe for it at a tilt of gamma."""
    gamma, scale, left, floor = math.radians(8), 7.0, 60, 300
    foot, lean, tall = (0.0, 24.0), 22.0, 36.0

    def at(x, z):
        return left + x * scale, floor - z * scale

    def path(points, fill, more=""):
        return f'<polygon points="{" ".join(f"{a:.1f},{b:.1f}" for a, b in points)}" fill="{fill}" {more}/>'

    body = [at(foot[0], 0), at(foot[1], 0), at(foot[1] + lean, tall), at(foot[0] + lean, tall)]
    top = (foot[1] - foot[0]) / 2 / math.tan(gamma)
    roof = [(x, min(z, tall + 3)) for x, z in ((foot[0], 0.0), (foot[1], 0.0))]
    high = tall + 3
    inset = min(high, top) * math.tan(gamma)
    roof += [(foot[1] - inset, high), (foot[0] + inset, high)]
    com = ((foot[0] + foot[1] + lean) / 2, tall / 2)
    limit = foot[1] - com[1] * math.tan(gamma)
    x, y = at(*com)
    edge_x, edge_y = at(foot[1], 0)
    parts = [path(body, "#e6e8ec", f'stroke="{INK}"'), path([at(*p) for p in roof], SAFE, 'fill-opacity="0.55"'),
             line(20, floor, 550, floor, BED, 2), line(x, y, x, floor, INK, 1.2, 'stroke-dasharray="4 4"'),
             line(*at(limit, com[1]), x, y, LOST, 2.5) if com[0] > limit else "",
             f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5"/>', text(x + 9, y - 8, "c"),
             f'<circle cx="{edge_x:.1f}" cy="{edge_y:.1f}" r="4" fill="{LOST}"/>',
             text(edge_x + 6, edge_y + 18, "p"), text(x + 8, (y + floor) / 2 + 4, "h"),
             line(edge_x, floor - 10, edge_x - 40, floor - 10, INK, 1.2, 'marker-end="url(#tip)"'),
             text(edge_x - 52, floor - 6, "n"),
             '<defs><marker id="tip" markerWidth="8" markerHeight="8" refX="6" refY="3" orient="auto">'
             '<path d="M0,0 L6,3 L0,6 z"/></marker></defs>',
             f'<rect x="392" y="20" width="14" height="14" fill="{SAFE}"/>',
             text(412, 32, f"safe for c at {math.degrees(gamma):.0f} degrees"),
             text(412, 52, "here c lies outside;" if com[0] > limit else "here c lies inside"),
             text(412, 70, "red: how far it must go") if com[0] > limit else ""]
    return svg(570, 330, parts)


def draw(folder):
    os.makedirs(folder, exist_ok=True)
    for name, figure in (("trim.svg", trim()), ("tilt.svg", tilt())):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(figure)
