"""Stability charts: proved columns, and a picture that says what is proved and what is not."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from mpsolve.errors import CertificateError, InputError
from mpsolve.model.specs import Grid
from mpsolve.numbers.exact import Exact
from mpsolve.stability import chart as charts
from mpsolve.stability.chart import Band, Column, Point, StabilityChart, stability_chart
from mpsolve.stability.search import Strip

EXAMPLES = Path(__file__).parents[2] / "examples"
SPEC: dict[str, Any] = {
    "title": "One mass",
    "digits": 18,
    "fixed": {"eta_b": "0.05", "masses": 1, "alpha": ["1.05", "1.1"]},
    "x": {"parameter": "eta_m", "values": [80, 70]},
}


@pytest.fixture(scope="module")
def chart() -> StabilityChart:
    return stability_chart(SPEC, workers=1)


@pytest.fixture
def ax() -> Any:
    pytest.importorskip("matplotlib", reason="a picture needs matplotlib")
    from matplotlib.figure import Figure

    return Figure().add_subplot()


def column(*bands: Band, points: tuple[Point, ...] = (), strips: tuple[Strip, ...] = ()) -> Column:
    return Column(points, bands, strips, not strips, "")


MADE = StabilityChart(
    "",
    15,
    {"masses": "2", "eta_b": "0.05", "eta_m": "70"},
    (Exact(0), Exact(1)),
    Grid("d", (Exact(1), Exact(2), Exact(4))),
    (
        column(Band(0, 0.5, 0), Band(0.5, 1, 2), points=(Point("0.5", "0.2", 1),)),
        column(
            Band(0, 0.25, 0),
            Band(0.25, 0.625, 2),
            Band(0.625, 1, 4),
            points=(Point("0.25", "0.9", 1), Point("0.625", "0.2", 1)),
        ),
        column(Band(0, 0.25, 0), Band(0.25, 0.375, None), Band(0.375, 1, 0), strips=(Strip(0.25, 0.375, "why"),)),
    ),
)


def test_columns(chart: StabilityChart) -> None:
    assert chart.proved
    heavy, light = chart.columns
    assert light.points[0].alpha == "1.07490045713867405"
    assert light.points[0].direction == 1
    assert [(band.start, band.end, band.unstable) for band in light.bands] == [
        (1.05, float(light.points[0].alpha), 0),
        (float(light.points[0].alpha), 1.1, 2),
    ]
    assert float(heavy.points[0].alpha) < float(light.points[0].alpha)
    assert light.certificate is not None


def test_any_number_of_workers(chart: StabilityChart) -> None:
    assert stability_chart(SPEC, workers=2).to_json() == chart.to_json()


def test_data(chart: StabilityChart) -> None:
    data = json.loads(chart.to_json())
    assert (data["format"], data["fixed"]) == ("mpsolve chart", {"masses": "1", "eta_b": "0.05"})
    assert data["x"] == {"parameter": "eta_m", "values": ["80", "70"]}
    assert "between columns nothing is proved" in data["proved"]
    assert data["columns"][1]["points"] == [vars(chart.columns[1].points[0])]


def test_undamped_columns_are_open_next_to_the_critical_velocity() -> None:
    found = stability_chart(SPEC | {"fixed": {"eta_b": 0, "masses": 1}}, workers=1)
    assert not found.proved
    below, strip, above = found.columns[0].bands
    assert (below.start, below.unstable, strip.unstable) == (0, 0, None)
    assert (above.end, above.unstable) == (pytest.approx(1.4), 2)
    assert abs(below.end - 1) < 1e-9
    assert (below.end, strip.end) == (strip.start, above.start)
    assert strip.end < 1.05


def test_the_picture(chart: StabilityChart, ax: Any) -> None:
    from mpsolve.report.chart import draw

    draw(chart, ax)
    assert ax.get_xlim() == (65, 85)
    assert ax.get_ylim() == (1.05, 1.1)
    assert ax.get_title(loc="left").startswith("One mass\nmasses = 1")
    (legend,) = ax.figure.legends
    assert "between columns nothing is proved" in legend.get_title().get_text().replace("\n", " ")
    assert [text.get_text() for text in legend.get_texts()] == [
        "stable",
        "2 unstable roots",
        "two roots become unstable",
    ]
    joins = [line for line in ax.lines if line.get_linestyle() == ":"]
    assert [tuple(line.get_xdata()) for line in joins] == [(70, 80)]


def test_open_strips_are_hatched_and_counts_coloured(ax: Any) -> None:
    from mpsolve.report.chart import draw

    draw(MADE, ax)
    hatched = [patch for patch in ax.patches if patch.get_hatch()]
    assert [(patch.get_x(), patch.get_y(), patch.get_height()) for patch in hatched] == [(3, 0.25, 0.125)]
    assert len({patch.get_facecolor() for patch in ax.patches}) == 4
    (legend,) = ax.figure.legends
    texts = [text.get_text() for text in legend.get_texts()]
    assert "undecided (the widest: 0.125 in α)" in texts
    assert "4 unstable roots" in texts
    joins = [line for line in ax.lines if line.get_linestyle() == ":"]
    assert [tuple(line.get_ydata()) for line in joins] == [(0.5, 0.625)]  # the nearer one in α and q


@pytest.mark.parametrize("kind", ["png", "svg", "pdf"])
def test_files(kind: str, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="a picture needs matplotlib")
    first, second = MADE.save(tmp_path / f"a.{kind}"), MADE.save(tmp_path / f"b.{kind.upper()}")
    assert first.read_bytes() == second.read_bytes()
    assert len(first.read_bytes()) > 5000
    with pytest.raises(CertificateError, match="cannot be written"):
        MADE.save(tmp_path / "none" / f"a.{kind}")


def test_data_as_a_file(tmp_path: Path) -> None:
    assert MADE.save(tmp_path / "a.json").read_text("utf-8") == MADE.to_json()
    with pytest.raises(InputError, match=r"does not end in \.png, \.svg, \.pdf, \.json"):
        MADE.save(tmp_path / "a.gif")


def test_without_matplotlib(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
    with pytest.raises(InputError, match=r"^matplotlib: is needed .* pip install matplotlib"):
        MADE.save(tmp_path / "a.png")


def test_a_single_column(ax: Any) -> None:
    from mpsolve.report.chart import draw

    single = replace(MADE, x=Grid("d", (Exact(1),)), columns=MADE.columns[:1])
    assert draw(single, ax).get_xlim() == (0.5, 1.5)


def test_the_example(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(charts, "run_bunches", lambda _work, jobs, *_: [MADE.columns[0]] * len(jobs))
    found = stability_chart(EXAMPLES / "stability_chart.toml")
    assert found.x.labels == tuple(map(str, range(30, 75, 5)))
    assert found.fixed == {"masses": "2", "eta_b": "0.05", "d": "1.5"}


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"x": {"parameter": "alpha", "values": [1]}}, r"^x.parameter: is 'alpha'"),
        ({"x": {"parameter": "eta_m", "values": [1, -1]}}, r"^x.values\[2\]: is -1"),
        ({"x": {"parameter": "d", "values": ["one mass"]}, "fixed": {}}, r"^x.values: holds one mass"),
        ({"x": {"parameter": "d", "values": [1]}}, r"^fixed.masses: is 1, but a distance"),
        ({"y": 1}, r"^y: is unknown"),
        ({"fixed": {"eta_b": 1}}, r"^fixed.d: is missing"),
        ({"fixed": {"eta_b": 1, "masses": 1, "alpha": "all"}}, r"^fixed.alpha: is a text"),
    ],
)
def test_bad_specs_name_their_key(changes: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        stability_chart(SPEC | changes, workers=1)


def test_what_is_proved_leaves_out_what_is_open(chart: StabilityChart) -> None:
    assert chart.proved
    assert "all along its height; between" in json.loads(chart.to_json())["proved"]
    assert not MADE.proved
    assert "all along its height except where it is open" in json.loads(MADE.to_json())["proved"]
