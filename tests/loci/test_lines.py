"""Root loci: against certified spectra, floats, the crossings of ranges, slopes, and the engine for one beam."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
from free_cases import BEAM, LAYERS, PAIR

from mpsolve import Case, Problem, certify, frequencies, vehicles
from mpsolve.errors import InputError
from mpsolve.loci.answer import FrequencyLines
from mpsolve.loci.lines import frequency_lines
from mpsolve.outcome import Status
from mpsolve.proof.effort import Effort
from mpsolve.ranges.crossings import crossings
from mpsolve.ranges.sensitivity import sensitivity
from mpsolve.spectrum.regions import Below

BEAM_PAIR = Problem(BEAM, PAIR, v="0.9")
LAYERED = Problem(LAYERS, [vehicles.Mass(900).at(0), vehicles.Mass(900).at("2.5")], v=300)


@pytest.fixture(scope="module")
def beam() -> FrequencyLines:
    return frequency_lines(BEAM_PAIR, over={"v": ("0.6", "1.3")}, points=15)


@pytest.fixture(scope="module")
def layered() -> FrequencyLines:
    return frequency_lines(LAYERED, over={"v": (250, 450)}, points=9)


def test_each_point_is_a_certified_root(beam: FrequencyLines) -> None:
    """All roots of the region at three values: as many as counted, and each on one line."""
    assert beam.status is Status.UNVERIFIED
    assert beam.counts == (4, 2, 4)
    for k in (1, 9, 14):
        value = beam.values[k]
        spectrum = certify(BEAM_PAIR.changed("v", value), region=("below", beam.region.height), check=False)
        balls = [line.q[line.values.index(value)] for line in beam.lines if value in line.values]
        roots = [root.q for root in spectrum.roots if root.q.real > 0]
        assert len(balls) == len(roots)
        assert all(sum(bool(ball.overlaps(root)) for root in roots) == 1 for ball in balls)
        before = sum(float(event.value) < value for event in beam.events)
        assert beam.counts[before] == spectrum.count == 2 * len(balls)
    assert all(ball.rad() < 1e-15 for line in beam.lines for ball in line.q)


def test_lines_cross_the_real_axis_where_ranges_say(beam: FrequencyLines) -> None:
    found = crossings(BEAM_PAIR, over={"v": ("0.6", "1.3")}, check=False)
    mine = sorted((c for line in beam.lines for c in line.crossings), key=lambda c: float(c.value))
    assert len(mine) == len(found.crossings) == 3
    for one, other in zip(mine, found.crossings, strict=True):
        assert one.value.overlaps(other.value)
        assert one.q.overlaps(other.q)
        assert one.direction == other.direction


def test_ends_lie_on_the_border(beam: FrequencyLines) -> None:
    assert isinstance(beam.region, Below)
    kinds = [tuple(end.kind for end in line.ends) for line in beam.lines]
    assert kinds == [("range", "region"), ("range", "range"), ("region", "range")]
    for event in beam.events:
        assert abs(float(event.q.imag) - float(beam.region.height)) < 1e-12
        at = BEAM_PAIR.changed("v", Fraction(float(event.value)))
        box = certify(at, region=("below", beam.region.height * Fraction(17, 16)), check=False)
        assert min(abs(complex(root.q) - complex(event.q)) for root in box.roots) < 1e-12


def test_lines_on_two_layers_are_those_of_floats(layered: FrequencyLines) -> None:
    assert layered.status is Status.UNVERIFIED
    assert len(layered.events) == 4
    values = [float(value) for value in layered.values]
    seen = frequencies(LAYERED, {"v": values}, ("below", layered.region.height))  # type: ignore[union-attr]
    for k, value in enumerate(layered.values):
        balls = [complex(line.q[line.values.index(value)]) for line in layered.lines if value in line.values]
        roots = seen.roots[k]
        near = roots[np.isfinite(roots) & (roots.real > 0)]
        assert np.allclose(np.sort_complex(balls), np.sort_complex(near), rtol=1e-9)


def test_slopes_of_lines_are_those_of_sensitivity() -> None:
    low, high = Fraction("0.7"), Fraction("0.7") + Fraction(1, 10**5)
    found = frequency_lines(BEAM_PAIR, over={"v": (low, high)}, points=2, check=False)
    slopes = sensitivity(BEAM_PAIR.changed("v", low), region=found.region, check=False).roots
    for line in found.lines:
        rise = complex((line.q[1] - line.q[0]).mid()) * 1e5
        known = next(root.by["v"] for root in slopes if root.q.overlaps(line.q[0]))
        assert abs(rise - complex(known.mid())) < 1e-3 * abs(rise)


FOLLOWED = [
    ("0.1420701408271026 + 0.0019284630341332j", "0.1339067484810225 + 0.0034882116882939j",
     "0.1158604067122569 + 0.0076129399843296j", "0.0672152043096523 + 0.0263523624320638j"),
    ("0.1724907962251543 + 0.0007919853611851j", "0.1580875637570618 + 0.0001395775699802j",
     "0.14038843178024066 - 0.0014177098191263j", "0.12043972661542209 - 0.00160403599655308j"),
]  # fmt: skip
"""Two lines at α = 0.5, 0.65, 0.8, 0.95, as the engine for one beam followed them (`frequency_lines` in α)."""


def test_lines_are_those_of_the_engine_for_one_beam() -> None:
    case = Case(alpha="0.6", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    points = ["0.5", "0.65", "0.8", "0.95"]
    found = frequency_lines(case, over={"v": ("0.5", "0.95")}, points=points, check=False)
    for line, known in zip(found.lines, FOLLOWED, strict=True):
        for ball, text in zip(line.q, known, strict=True):
            assert abs(complex(ball) - complex(text.replace(" ", ""))) < 1e-15


@pytest.mark.parametrize("path", ["track.k", "track.c", "gap[0]", "scale.mass", "vehicles[0].M"])
def test_any_parameter_is_a_path(path: str) -> None:
    own = BEAM_PAIR.parameters[path]
    found = frequency_lines(BEAM_PAIR, over={path: (own, own * Fraction(5, 4))}, points=3, check=False)
    assert found.status is Status.UNVERIFIED
    assert found.counts is not None
    for value in found.values:
        spectrum = certify(BEAM_PAIR.changed(path, value), region=("below", found.region.height), check=False)  # type: ignore[union-attr]
        there = [line.q[line.values.index(value)] for line in found.lines if value in line.values]
        assert spectrum.count == 2 * len(there)
        assert all(any(root.q.overlaps(ball) for root in spectrum.roots) for ball in there)


@pytest.mark.parametrize("region", ["unstable", None])
def test_a_divergence_is_on_a_line_of_one_root(region: str | None) -> None:
    """Two masses joined by a spring: a root goes along the imaginary axis through q = 0; floats count the lines."""
    joined = vehicles.Vehicle(
        M=[[2, 0], [0, 2]], C=[[0, 0], [0, 0]], K=[[3, -3], [-3, 3]], B=[[1, 0], [0, 1]], places=["-0.5", "0.5"]
    )
    problem = Problem(BEAM, joined, v="1.2")
    values = np.sort(np.random.default_rng(3).uniform(1.05, 1.4, 6)).tolist()
    found = frequency_lines(problem, over={"v": ("1.05", "1.4")}, points=values, region=region, check=False)
    assert found.status is Status.UNVERIFIED, found.reason
    asked = "unstable" if region else ("below", found.region.height)  # type: ignore[union-attr]
    seen = frequencies(problem, {"v": values}, asked)
    for value, count in zip(found.values, seen.count.tolist(), strict=True):
        assert sum(line.weight for line in found.lines if value in line.values) == count
    (line,) = found.lines
    assert line.weight == 1
    assert all(q.real.is_zero() for q in line.q)
    crossed = line.ends[0] if region else line.crossings[0]
    assert abs(float(crossed.value) - 1.166872) < 1e-6  # type: ignore[arg-type]


def test_unstable_lines_begin_and_end_at_crossings() -> None:
    found = frequency_lines(BEAM_PAIR, over={"v": ("0.7", "0.9")}, points=5, region="unstable", check=False)
    known = crossings(BEAM_PAIR, over={"v": ("0.7", "0.9")}, check=False)
    assert found.counts == known.counts == (0, 2, 0)
    (line,) = found.lines
    assert [end.kind for end in line.ends] == ["region", "region"]
    for end, crossing in zip(line.ends, known.crossings, strict=True):
        assert end.value.overlaps(crossing.value)
    assert all(q.imag < 0 for q in line.q)


def test_an_answer_is_handed_on(beam: FrequencyLines) -> None:
    again = pickle.loads(pickle.dumps(beam))
    assert (again.rows(), again.counts, again.region) == (beam.rows(), beam.counts, beam.region)
    assert all(one.value.contains(other.value) for one, other in zip(again.events, beam.events, strict=True))
    assert beam.to_dict()["lines"][0]["ends"][1]["kind"] == "region"
    rows = beam.rows()
    assert len(rows) == sum(len(line.values) for line in beam.lines) + len(beam.events)
    assert sum(row["end"] == "region" for row in rows) == len(beam.events)
    assert rows[0] == {"line": 1, "value": 0.6, "re_q": float(beam.lines[0].q[0].real.mid()),
                       "im_q": float(beam.lines[0].q[0].imag.mid()), "end": ""}  # fmt: skip


def test_what_is_left_open_is_said() -> None:
    found = frequency_lines(BEAM_PAIR, over={"v": ("0.7", "0.9")}, effort=Effort(evaluations=500), check=False)
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "effort"
    assert found.counts is None


@pytest.mark.parametrize(
    ("options", "key"),
    [
        ({"over": {"w": (0, 1)}}, "w"),
        ({"over": {"v": ("0.5", "0.4")}}, "v"),
        ({"over": {"v": ("0.5", "0.6")}, "points": ["0.7"]}, "points"),
        ({"over": {"v": ("0.5", "0.6")}, "points": 1}, "points"),
        ({"over": {"v": ("0.5", "0.6")}, "region": ("below", "0.05")}, "region"),
        ({"over": {"v": ("0.5", "0.6")}, "region": "sheets"}, "region"),
    ],
)
def test_what_cannot_be_is_refused(options: dict[str, object], key: str) -> None:
    with pytest.raises(InputError) as error:
        frequency_lines(BEAM_PAIR, **options)  # type: ignore[arg-type]
    assert error.value.key == key
