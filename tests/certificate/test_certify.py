"""The public verb: in which units and region it answers, what it refuses, and how it ends early."""

from __future__ import annotations

import pickle
from fractions import Fraction
from pathlib import Path
from typing import Any

import flint
import pytest

from mpsolve import (
    Case,
    Effort,
    InputError,
    PhysicalCase,
    Problem,
    Rectangle,
    Spectrum,
    Status,
    certify,
    read_problem,
)
from mpsolve.certificate import verify2
from mpsolve.spectrum.regions import Below, HalfPlane, Sheet
from mpsolve.tracks import EulerBernoulli, Rayleigh, String, Timoshenko, TwoLayer
from mpsolve.vehicles import Bogie, Mass, Oscillator

EXAMPLES = Path(__file__).parents[2] / "examples"
CASE = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
BEAM = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}
RAIL = PhysicalCase(**BEAM, v=100, masses=[(10_000, 0), (10_000, "3.4")])
AS_PROBLEM = Problem(EulerBernoulli(**BEAM), [Mass(10_000).at("3.4"), Mass(10_000).at(0)], v=100)
WIRE = Problem(String(T=27_000, m="1.07", k=500, c=2), [Mass("8.5")], v=100)
SPRUNG = Problem(EulerBernoulli(**BEAM), [Oscillator(wheel=1000, body=5000, k="1e6", c="1e4")], v=60)


def roots(found: Spectrum) -> list[complex]:
    return [complex(root.q.mid()) for root in found.roots]


# --- units and regions -------------------------------------------------------------------------------------

KNOWN = ["0.1323182116", "0.0038489335", "0.1558609631", "-0.0000272301"]
"""Re and Im of the right roots of CASE in ten digits, as the one-beam program had them."""


@pytest.mark.parametrize("region", [None, "sheet"])
def test_a_case_is_answered_on_its_whole_sheet(region: str | None) -> None:
    found = certify(CASE, region=region, digits=20)
    assert (found.status, found.count, found.unstable, found.stable) == (Status.PROVED, 4, 2, False)
    assert found.region == Sheet()
    right = [root.q for root in found.roots if root.q.real > 0]
    assert [f"{float(x.mid()):.10f}" for q in right for x in (q.real, q.imag)] == KNOWN
    assert found.certificate.content["version"] == 2
    assert found.problem is CASE
    assert found.verified.startswith("exactly 4 induced frequencies")


@pytest.mark.parametrize("given", [RAIL, AS_PROBLEM], ids=["case", "problem"])
def test_si_is_answered_in_radians_per_second(given: Any) -> None:
    """Frequencies and times as the one-beam program has them, in SI."""
    found = certify(given, digits=20)
    assert found.proved
    assert found.region == Sheet()
    for root in found.roots:
        assert (root.q - root.q.mid()).abs_upper() <= 1e-20 * root.q.abs_upper()
    slow = found.roots[2]
    assert abs(float(slow.frequency) - 2.93926598) < 1e-8
    assert abs(float(slow.doubling_time) - 4.26466395) < 1e-8
    assert slow.growth < 0


def test_a_height_and_a_rectangle_hold_what_the_sheet_has() -> None:
    sheet = certify(RAIL, digits=20)
    below = certify(RAIL, digits=20, region=("below", 6), check=False)
    assert below.status is Status.UNVERIFIED
    assert isinstance(below.region, Below)
    assert below.problem is RAIL
    for one, other in zip(sheet.roots, below.roots, strict=True):
        assert one.q.overlaps(other.q)
        assert one.symmetry is other.symmetry
    box = certify(RAIL, digits=20, region=Rectangle(10, 20, "-0.1", "0.2"), check=False)
    assert roots(box) == pytest.approx([q for q in roots(sheet) if 10 < q.real < 20], abs=1e-15)
    assert box.stable is None


@pytest.mark.parametrize(("alpha", "unstable"), [("0.66", 0), ("0.67", 2)])
def test_the_onset_of_the_paper(alpha: str, unstable: int) -> None:
    """It lies at α = 0.66691895728…"""
    case = Case(alpha=alpha, eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
    found = certify(case, region="unstable", digits=15, check=False)
    assert (found.region, found.unstable) == (HalfPlane(), unstable)


@pytest.mark.parametrize("region", [None, "sheet", "unstable", ("below", "0.01")])
def test_an_irrational_case_is_refused_with_what_to_give(region: Any) -> None:
    with pytest.raises(InputError, match="irrational: give the PhysicalCase"):
        certify(RAIL.dimensionless, region=region)
    assert certify(RAIL, region="unstable", digits=15, check=False).stable is True  # what the refusal asks for


def test_undamped_beams() -> None:
    case = Case(alpha="0.5", eta_b=0, eta_m=(20, 20), positions=(0, 1))
    assert certify(case, digits=15).stable is True
    assert certify(case, digits=15, region="unstable").count == 0
    undamped = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=100, masses=[(10_000, 0)])
    assert certify(undamped, digits=15).region == Sheet()
    with pytest.raises(InputError, match="without damping"):
        certify(Problem(String(T=27_000, m=1, k=500), [Mass(8)], v=100))


# --- regions -----------------------------------------------------------------------------------------------


def test_a_stable_track_is_not_answered_with_an_empty_table() -> None:
    """The contact wire's root as an independent program has it."""
    found = certify(WIRE, digits=15, check=False)
    assert isinstance(found.region, Below)
    assert found.stable is True
    assert roots(found) == pytest.approx(
        [-15.641876611743 + 0.715988110564j, 15.641876611743 + 0.715988110564j], abs=1e-11
    )


def test_the_default_region() -> None:
    assert isinstance(certify(SPRUNG, digits=15, check=False).region, Below)
    three = [(5_000, x) for x in ("0", "3", "7")]
    assert isinstance(certify(PhysicalCase(**BEAM, v=50, masses=three), digits=15, check=False).region, Below)
    over = PhysicalCase(**(BEAM | {"c": "1.2e5"}), v=100, masses=[(10_000, 0)])  # its cuts are not on a line
    assert isinstance(certify(over, digits=15, check=False).region, Below)
    touching = ONSETS["timoshenko"][0]  # without damping of the rotation its cuts come down to the real axis
    assert certify(Problem(touching, [Mass(1000)], v=60), digits=15, check=False).region == HalfPlane()


def test_without_a_proof_below_a_height_the_unstable_half_plane_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    real = verify2.verify_bytes
    refused = verify2.Verdict(False, "no")
    monkeypatch.setattr(verify2, "verify_bytes", lambda raw: refused if b'"below"' in raw else verify2.Verdict(True))
    found = certify(WIRE, digits=15)
    assert (found.proved, found.region, found.stable) == (True, HalfPlane(), True)
    assert "above the real axis" in found.note
    assert real is not verify2.verify_bytes


@pytest.mark.parametrize(
    ("given", "region", "key", "words"),
    [
        (WIRE, "sheet", "region", "which is known for a beam on one layer"),
        (WIRE, ("below", 1), "region", "begin at Im q = 0.9345"),
        (WIRE, ("below", 0), "region", "must be above 0"),
        (WIRE, ("below", "x"), "region", "x"),
        (WIRE, ("above", 1), "region", 'give "sheet"'),
        (WIRE, "half", "region", "is 'half'"),
        (WIRE, 3, "region", "is '3'"),
        (WIRE, Rectangle(0, 20, -1, 1), "region.im_max", "give im_max up to 0.934"),
        (CASE, Rectangle(0, 1, -1, 1), "region.im_max", "cut line"),
        ("case.toml", None, "problem", "type str"),
    ],
)
def test_what_is_refused(given: Any, region: Any, key: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        certify(given, region=region)
    assert caught.value.key == key
    assert words in str(caught.value)


def test_remedies_of_refused_regions_help() -> None:
    assert certify(WIRE, region=("below", "0.934"), digits=15, check=False).count == 2
    assert certify(WIRE, region=Rectangle(0, 20, -1, "0.934"), digits=15, check=False).count == 1


def test_old_positional_arguments_are_gone() -> None:
    with pytest.raises(TypeError):
        certify(CASE, 20)  # type: ignore[misc]


# --- results -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("given", [CASE, RAIL, WIRE, SPRUNG], ids=["case", "si", "wire", "sprung"])
def test_a_result_travels_and_has_no_truth_value(given: Any) -> None:
    found = certify(given, digits=30, check=False)
    again = pickle.loads(pickle.dumps(found))
    for name in ("status", "region", "count", "unstable", "cost", "problem", "verified"):
        assert getattr(again, name) == getattr(found, name)
    for one, other in zip(found.roots, again.roots, strict=True):
        assert other.q.contains(one.q)
        assert other.q.mid().real.man_exp() == one.q.mid().real.man_exp()
        assert (other.q - other.q.mid()).abs_upper() <= 1.00001 * (one.q - one.q.mid()).abs_upper()
        assert other.shape.bodies.keys() == one.shape.bodies.keys()
    assert again.certificate.text == found.certificate.text
    with pytest.raises(TypeError, match="truth value"):
        bool(again)


def test_the_shape_of_a_root() -> None:
    found = certify(SPRUNG, digits=20, check=False)
    shape = found.roots[-1].shape
    assert {"wheel", "body"} == {name.split(" ")[0] for name in shape.bodies}
    assert max(abs(complex(x.mid())) for x in shape.bodies.values()) == pytest.approx(1)


def test_what_the_verifier_refuses_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(verify2, "verify_bytes", lambda _raw: verify2.Verdict(False, "piece 3 is too long"))
    found = certify(WIRE, region="unstable", digits=15)
    assert (found.status, found.count, found.unstable, found.stable) == (Status.UNDECIDED, None, None, None)
    assert found.reason is not None
    assert found.reason.code == "verifier"
    assert "piece 3 is too long" in str(found.reason)
    kept = certify(WIRE, region="unstable", digits=15, check=False)
    assert (kept.status, kept.count) == (Status.UNVERIFIED, 0)


def test_proved_means_verified() -> None:
    bogie = read_problem(EXAMPLES / "two_layer_bogie.toml").problem
    for given in (WIRE, SPRUNG, bogie):
        for region in (None, "unstable"):
            found = certify(given, region=region, digits=15)
            assert found.status is Status.PROVED, found.reason
            assert found.verified
            assert found.stable is True
            assert found.cost.verification > 0


# --- effort, progress, interruption ------------------------------------------------------------------------


@pytest.mark.parametrize("given", [CASE, WIRE], ids=["sheet", "general"])
def test_effort_ends_the_work_and_more_of_it_helps(given: Any) -> None:
    options: dict[str, Any] = {"digits": 15, "region": None if given is CASE else ("below", "0.9"), "check": False}
    for effort in (Effort(evaluations=5), Effort(seconds=1e-6)):
        found = certify(given, effort=effort, **options)
        assert found.status is Status.UNDECIDED
        assert "effort=Effort(seconds=…)" in str(found.reason)
    spare = Effort(seconds=100)
    assert certify(given, effort=spare, **options).proved
    assert certify(given, effort=spare, **options).proved
    with pytest.raises(InputError, match="effort: is of type int"):
        certify(given, effort=3)  # type: ignore[arg-type]


@pytest.mark.parametrize("given", [CASE, WIRE], ids=["sheet", "general"])
def test_progress_is_told_and_an_interruption_leaves_nothing_behind(given: Any) -> None:
    stages: list[str] = []

    def tell(stage: str, fraction: float) -> None:
        assert 0 <= fraction <= 1
        stages.append(stage)

    whole = certify(given, digits=15, progress=tell, check=given is CASE)
    assert whole.proved
    before = flint.ctx.prec
    for stage in dict.fromkeys(stages):

        def stop(now: str, _fraction: float, stage: str = stage) -> None:
            if now == stage:
                raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            certify(given, digits=15, progress=stop, check=given is CASE)
        assert flint.ctx.prec == before
    assert roots(certify(given, digits=15, check=given is CASE)) == roots(whole)


# --- numbers that others made ------------------------------------------------------------------------------

SHEAR = Fraction("0.393") * Fraction("80.769e9") * Fraction("76.70e-4")
INERTIA = Fraction("3.037e-5")
BALLAST = {"k_pad": "300e6", "c_pad": "3e4", "m_sleeper": 250, "k_ballast": "100e6", "c_ballast": "8e4"}
TIGHT = Bogie(
    wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e6", c=250, body=12500, k2="2.708e6", c2="64e3"
)
PAIR = [Mass(10_000).at(0), Mass(10_000).at("3.4")]
ONSETS = {
    "timoshenko": (
        Timoshenko(EI=210 * 10**9 * INERTIA, m="60.2", S=SHEAR, J=7860 * INERTIA, k="1e6", c=770),
        [Mass(10_000)],
        "309.445688",
        "309.4456867",
    ),
    "two-layer": (
        TwoLayer(EI=210 * 10**9 * Fraction("3038.30e-8"), m="60.2", **BALLAST),
        [Mass(900)],
        "1413.817865",
        "1413.8178654",
    ),
    "kelvin-voigt pair": (EulerBernoulli(**BEAM, eta="1e-4"), PAIR, "197.878094", "197.8780954"),
    "tight bogie": (EulerBernoulli(**BEAM), [TIGHT], "334.590808", "334.5908074"),
}


@pytest.mark.parametrize("name", ONSETS)
def test_onset_velocities_that_two_independent_programs_found(name: str) -> None:
    """Proved stable 1e-6 below, proved unstable 1e-6 above; a second program has a digit more, within 1e-7."""
    track, vehicles, first, second = ONSETS[name]
    for published, part in ((first, Fraction(1, 10**6)), (second, Fraction(1, 10**7))):
        for side in (-1, 1):
            v = Fraction(published) * (1 + side * part)
            found = certify(Problem(track, vehicles, v), region="unstable", digits=15)
            assert found.status is Status.PROVED, found.reason
            assert (found.region, found.stable) == (HalfPlane(), side < 0)
            assert found.unstable == (0 if side < 0 else 2)


def test_a_rayleigh_beam_with_two_contacts_faster_than_its_waves_says_so() -> None:
    """Where no theorem closes the half-plane the region carries a radius, and stability stays open."""
    track = Rayleigh(EI="6.4e6", m=60, J=60, k="1e6", c=770)  # waves of at most √(EI/J) = 327 m/s
    found = certify(Problem(track, PAIR, v=400), region="unstable", digits=15, check=False)
    assert found.proved, found.reason
    assert isinstance(found.region, HalfPlane)
    assert found.region.radius is not None
    assert found.stable is not True
    assert found.note


def test_a_stated_effort_is_shared_by_the_regions_that_are_asked() -> None:
    """Half is for the default region, the rest for those that are asked for where it stays open."""
    one = Problem(EulerBernoulli(EI="0.25", m=1, k=1, c="0.2"), Mass(3), v="0.8")
    whole, less = (certify(one, region=region, check=False).cost.evaluations for region in ("sheet", "unstable"))
    enough = certify(one, effort=Effort(evaluations=2 * whole), check=False)
    assert (enough.region, enough.cost.evaluations) == (Sheet(), whole)
    assert less < whole // 2 - 2
    short = certify(one, effort=Effort(evaluations=2 * whole - 4), check=False)
    assert short.proved
    assert not isinstance(short.region, Sheet)
    assert short.cost.evaluations < whole // 2
