"""Curves with marks: names do not lie over each other, and what is beyond the model is grey."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np

from mpsolve.pictures.lines import Curve, Mark, lines_picture


def drawn(**more: object) -> ET.Element:
    x = np.linspace(0, 10, 41)
    curves = [Curve(x, np.sin(x) * 1e-3 + k * 1e-6, f"wheel {k}", beyond=4.0 if k == 0 else None) for k in range(5)]
    return ET.fromstring(lines_picture(curves, "t, s", "w, m", "Motion", name="m", **more))  # type: ignore[arg-type]


def test_long_names_stand_in_a_key_below() -> None:
    tree = drawn()
    words = [e for e in tree.iter("text") if (e.text or "").startswith("wheel")]
    places = {(e.attrib["x"], e.attrib["y"]) for e in words}
    assert len(places) == 5
    title = max(float(e.attrib["y"]) for e in tree.iter("text") if e.text == "t, s")
    assert min(float(e.attrib["y"]) for e in words) > title + 10
    assert max(float(e.attrib["y"]) for e in words) < float(tree.attrib["viewBox"].split()[-1])


def test_no_two_of_twelve_curves_look_alike() -> None:
    x = np.linspace(0, 1, 30)
    tree = ET.fromstring(lines_picture([Curve(x, x + k, f"{k}") for k in range(12)], "t", "w", "M", name="m"))
    looks = [e.attrib["class"] for e in tree.iter("polyline")]
    assert len(set(looks)) == 12
    assert len({e.attrib["d"].split("m", 1)[1] for e in tree.iter("path") if e.get("class") == "point"}) == 2


def test_short_names_lie_over_no_curve_and_no_other_name() -> None:
    x = np.linspace(0, 10, 80)
    curves = [Curve(x, 0.05 * x + 1e-3 * k, f"{k}") for k in range(3)] + [Curve(x, 1 - 0.1 * x, "3")]
    tree = ET.fromstring(lines_picture(curves, "t", "w", "M", name="m", marks=[Mark(5.0, "this case")]))
    words = [
        e for e in tree.iter("text") if e.text in ("0", "1", "2", "3", "this case") and "halo" in e.get("class", "")
    ]
    assert len(words) == 5
    at = [(float(e.attrib["x"]), float(e.attrib["y"])) for e in words]
    assert all(abs(a[0] - b[0]) > 7 or abs(a[1] - b[1]) > 13 for k, a in enumerate(at) for b in at[:k])
    for line in tree.iter("polyline"):
        px, py = np.array([point.split(",") for point in line.attrib["points"].split()], float).T
        for e, (wx, wy) in zip(words, at, strict=True):
            reach = (wx - 7.5, wx) if e.get("text-anchor") == "end" else (wx, wx + 7.5 * len(e.text or ""))
            fine = np.linspace(*reach, 9)
            y = np.interp(fine, px, py)
            assert not ((y > wy - 11) & (y < wy + 3)).any()


def test_a_number_stands_nearest_to_its_own_curve() -> None:
    """Two close lines, with a third over the upper one's end: there is room further left."""
    x = np.linspace(0, 10, 80)
    curves = [Curve(x, 0 * x + 2, "1"), Curve(x, 0 * x + 8, "2"), Curve(x, np.where(x > 6, 14, np.nan), "3")]
    tree = ET.fromstring(lines_picture(curves, "t", "w", "M", name="m", y=(-15, 100)))
    at = {
        e.text: float(e.attrib["y"]) - 4 for e in tree.iter("text") if e.text in "12" and "halo" in e.get("class", "")
    }
    low, high = (float(e.attrib["points"].split(",")[1].split()[0]) for e in list(tree.iter("polyline"))[:2])
    assert abs(at["1"] - low) < abs(at["1"] - high)
    assert abs(at["2"] - high) < abs(at["2"] - low)


def test_a_word_at_a_mark_lies_over_no_other_mark() -> None:
    x = np.linspace(0, 10, 30)
    marks = [Mark(4.0, "onset, proved"), Mark(5.0, "this case")]
    tree = ET.fromstring(lines_picture([Curve(x, x)], "t", "w", "M", name="m", marks=marks))
    lines = [float((e.get("d") or "").split()[1]) for e in tree.iter("path") if e.get("class") == "here"]
    (word,) = [e for e in tree.iter("text") if e.text == "onset, proved"]
    start, wide = float(word.attrib["x"]), 7.5 * len(word.text or "")
    left = start if word.get("text-anchor") == "start" else start - wide
    assert not any(left < at < left + wide for at in lines)


def test_what_is_beyond_is_grey() -> None:
    grey = [e for e in drawn().iter("polyline") if "beyond" in e.attrib["class"]]
    assert len(grey) == 1


def test_marks_outside_are_left_out() -> None:
    tree = drawn(marks=[Mark(5.0, "onset"), Mark(50.0, "far")], grows_above=0.0)
    said = [e.text for e in tree.iter("text")]
    assert "onset" in said
    assert "far" not in said
    assert "grows" in said


def test_an_end_at_a_cut_has_its_own_mark() -> None:
    x = np.array([0.0, 1.0, 2.0])
    picture = lines_picture([Curve(x, x, ends=(False, False, True)), Curve(x, -x)], "x", "y", "t", name="n")
    assert picture.count('class="end"') == 1
