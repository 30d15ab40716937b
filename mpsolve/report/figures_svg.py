"""Figures as SVG inside a page: ids of their own, colours that follow the page's, a text for screen readers."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING

from mpsolve.report.figures import COLOUR, rendered

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SVG, _LINK = "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"
_VARIABLES = {
    "#000000": "currentColor",
    "#ffffff": "var(--card, #ffffff)",
    COLOUR.stable.lower(): "var(--blue, #0072b2)",
    COLOUR.unstable.lower(): "var(--red, #d55e00)",
    COLOUR.series[2].lower(): "var(--green, #009e73)",
    COLOUR.series[3].lower(): "var(--pink, #cc79a7)",
    COLOUR.shade.lower(): "var(--shade, #f9e5d9)",
    COLOUR.cut: "var(--cut, #444444)",
    COLOUR.faint: "var(--faint, #777777)",
} | {fill.lower(): f"var(--count-{k}, {fill.lower()})" for k, fill in enumerate(COLOUR.counts) if k}
_REM_PER_INCH = 6.5  # widest on the page, so that the text of all figures has one size
_COLOUR = re.compile("|".join(map(re.escape, _VARIABLES)))
_REFERENCE = re.compile(r"url\(#([^)]*)\)")


def inline_svg(figure: Figure, name: str, title: str, description: str) -> str:
    """The figure as an <svg> element with role img, whose ids begin with `name` and a hyphen.

    The axes of id axes carry their limits as data-x0, data-x1, data-y0, data-y1 (data-y0: the lower edge), so that
    every position in the picture can be read back.
    """
    root = ET.fromstring(rendered(figure, "svg"))
    _clear(root)
    limits = {ax.get_gid(): (*ax.get_xlim(), *ax.get_ylim()) for ax in figure.axes if ax.get_gid()}
    for element in root.iter():
        known = element.get("id")
        if known in limits:
            for key, value in zip(("x0", "x1", "y0", "y1"), limits[known], strict=True):
                element.set(f"data-{key}", repr(float(value)))
        _rename(element, name)
        for key in ("style", "fill", "stroke"):
            if key in element.attrib:
                element.set(key, _COLOUR.sub(lambda found: _VARIABLES[found[0]], element.attrib[key]))
    root.set("style", f"max-width: {_REM_PER_INCH * figure.get_figwidth():.1f}rem; fill: currentColor")
    _describe(root, name, title, description)
    ET.register_namespace("", _SVG)
    ET.register_namespace("xlink", _LINK)
    return ET.tostring(root, encoding="unicode")


def _clear(root: ET.Element) -> None:
    """Without the size in points, the metadata, and the style sheet, which would hold for the whole page."""
    for key in ("width", "height"):
        root.attrib.pop(key, None)
    for parent in list(root.iter()):
        for child in list(parent):
            if child.tag in (f"{{{_SVG}}}metadata", f"{{{_SVG}}}style"):
                parent.remove(child)


def _rename(element: ET.Element, name: str) -> None:
    """Puts the name before each id and each reference to one."""
    for key, value in element.attrib.items():
        if key == "id":
            element.set(key, f"{name}-{value}")
        elif key == f"{{{_LINK}}}href" and value.startswith("#"):
            element.set(key, f"#{name}-{value[1:]}")
        else:
            element.set(key, _REFERENCE.sub(rf"url(#{name}-\1)", value))


def _describe(root: ET.Element, name: str, title: str, description: str) -> None:
    """The name and the description that a screen reader says."""
    for place, (tag, text) in enumerate((("title", title), ("desc", description))):
        element = ET.Element(f"{{{_SVG}}}{tag}", {"id": f"{name}-{tag}"})
        element.text = text
        root.insert(place, element)
    root.set("role", "img")
    root.set("aria-labelledby", f"{name}-title")
    root.set("aria-describedby", f"{name}-desc")
