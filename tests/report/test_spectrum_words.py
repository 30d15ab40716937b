"""The verdict and the proved sentences say what the spectrum holds, and no more."""

from __future__ import annotations

from dataclasses import replace
from math import log, pi

import pytest
from flint import acb, arb
from reported import SPRUNG, fast, wire, without_theorem

from mpsolve import Case, Problem, Rectangle, Status, certify, tracks, vehicles
from mpsolve.outcome import Reason
from mpsolve.report.spectrum_words import (
    DIMENSIONLESS,
    SI,
    beyond,
    proved,
    units_of,
    verdict,
    verified,
    verified_briefly,
)
from mpsolve.spectrum.regions import Below, HalfPlane, Sheet

ZERO = [[0, 0], [0, 0]]


def test_stable() -> None:
    assert verdict(wire()) == "STABLE at 360 km/h (100 m/s): every vibration decays."
    said = " ".join(proved(wire()))
    assert "has exactly 2 zeros, counted with multiplicity, in the region below the branch cuts Im q < 0.876" in said
    assert (
        "None is missed: the track takes up power at all frequencies with |q| ≥ 35.7771" in said
    )  # the corner 32 − 16i
    assert "relative radius below 1e-20 that holds exactly one zero" in said


def test_large_matrices_are_told_by_their_size() -> None:
    matrix = str([[0] * 10] * 10)
    long = replace(wire(), status=Status.PROVED, verified=f"exactly 2\n  M = {matrix}\n  B = [[1], [0]]")
    assert matrix in verified(long)
    short = "exactly 2\n  M = … (10 rows, printed by mpsolve verify)\n  B = [[1], [0]]."
    assert verified_briefly(long) == f"The standalone verifier confirms: {short}"
    assert verified_briefly(wire()) == verified(wire())


def test_unstable_counts_vibrations_too() -> None:
    """Two roots q and −q̄ are one vibration, near the onset's 673.4/2π = 107.2 Hz."""
    said = verdict(fast())
    assert said.startswith("UNSTABLE at ")
    assert ": a vibration at 108.1 Hz doubles every " in said
    (root,) = (root for root in fast().roots if root.q.real > 0)
    assert float(said.split()[-2]) / (1000 if said.endswith("ms.") else 1) == pytest.approx(
        log(2) / -float(root.q.imag.mid()), rel=1e-3
    )
    assert "in the whole unstable half-plane Im q < 0" in proved(fast())[0]


def test_a_motion_without_oscillation() -> None:
    (root, *_) = fast().roots
    alone = replace(root, q=acb(0, -1))
    said = verdict(replace(fast(), roots=(alone,), unstable=1, count=1))
    assert said.endswith(": a deflection doubles every 0.6931 s, without oscillation.")


def test_the_fastest_of_several_is_named_where_it_is_proved() -> None:
    (root, *_) = fast().roots
    slow, quick = (replace(root, q=acb(3, y)) for y in (-1, -2))
    wide = replace(root, q=acb(5, arb(-2, 0.5)))
    assert verdict(replace(fast(), roots=(slow, quick), unstable=4)).endswith(
        ": 2 vibrations grow; the fastest, at 0.4775 Hz, doubles every 0.3466 s."
    )
    assert "; one, at " in verdict(replace(fast(), roots=(quick, wide), unstable=4))


def test_a_half_disc_proves_no_stability() -> None:
    assert verdict(without_theorem()).startswith("NO GROWTH where |q| < 1000: ")
    assert "not all that was asked for: no passivity beyond a frequency." in " ".join(proved(without_theorem()))
    assert verdict(replace(without_theorem(), region=Rectangle(0, 1, -1, 0))).startswith(
        "NO GROWTH in this rectangle"
    )


def test_undecided() -> None:
    reason = Reason("roots", "3 roots are counted, but 2 could be enclosed", {}, "ask for more digits")
    open_ = replace(wire(), status=Status.UNDECIDED, reason=reason, count=None, unstable=None, known={"count": 3})
    assert verdict(open_) == f"UNDECIDED: {reason}."
    assert proved(open_) == (
        f"The characteristic function Δ(q) has exactly 3 zeros in the region below the branch cuts {wire().region}; "
        "2 of them are enclosed.",
    )
    assert proved(replace(open_, known={})) == ()


def test_what_is_left_out_of_the_count_is_said() -> None:
    apart = " ".join(proved(replace(wire(), neutral=1, unfelt=(acb(1, 1), acb(-1, 1)))))
    assert "q = 0 is a root once by construction" in apart
    assert "2 roots of motions that no contact feels" in apart
    assert "Besides" not in " ".join(proved(wire()))


def test_the_verifiers_word() -> None:
    assert verified(wire()).startswith("Proved, not verified")
    assert verified(replace(wire(), status=Status.PROVED, verified="all of it")).endswith("confirms: all of it.")
    assert verified(replace(wire(), status=Status.UNDECIDED)) == ""


@pytest.mark.parametrize(("eta_b", "words"), [("0.05", "every vibration decays"), (0, "without damping")])
def test_a_case_has_the_papers_units(eta_b: object, words: str) -> None:
    found = certify(Case(alpha="0.5", eta_b=eta_b, eta_m=20), region="unstable", digits=15, check=False)
    assert (units_of(found), units_of(wire())) == (DIMENSIONLESS, SI)
    assert found.region == HalfPlane()
    assert words in verdict(found)


@pytest.mark.parametrize("v", [0, "0.5"])
def test_what_nothing_damps_is_not_said_to_decay(v: object) -> None:
    """A body on a spring that no contact feels swings for ever; so does a mass on a beam at rest without damping."""
    alone = vehicles.Vehicle(M=[[1, 0], [0, 1]], C=ZERO, K=[[0, 0], [0, 5]], B=[[1], [0]], places=[0])
    damped, undamped = (tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=c) for c in ("0.1", 0))
    found = certify(Problem(damped, alone, v=v), region="unstable", digits=15, check=False)
    assert verdict(found).endswith(": no vibration grows; one that no contact feels need not decay.")
    own = replace(found, unfelt=(acb(1, 1), acb(-1, 1)))
    assert verdict(own).endswith(": every vibration decays.")
    found = certify(Problem(undamped, vehicles.Mass(1), v=v), region="unstable", digits=15, check=False)
    assert verdict(found).endswith(": nothing grows; without damping of the track vibrations need not decay.")


def test_a_vehicle_that_moves_by_itself() -> None:
    assert units_of(certify(SPRUNG, region="unstable", digits=15, check=False)) == SI


def test_what_a_table_leaves_out_is_said() -> None:
    """Im q < h is a halving time of more than ln 2/h; the whole sheet and a chosen rectangle leave out nothing."""
    region = wire().region
    assert isinstance(region, Below)
    said = beyond(wire())
    assert said in proved(wire())
    shortest = float(said.split("less than ")[1].split(" s,")[0])
    assert shortest == pytest.approx(log(2) / float(region.height), rel=1e-3)
    assert float(said.split("above ")[1].split(" Hz")[0]) == pytest.approx(
        float(region.reach or 0) / (2 * pi), rel=1e-3
    )
    assert beyond(fast()).startswith("Not looked at: vibrations that decay;")
    for other in (Sheet(), Rectangle(-1, 1, -1, 0)):
        assert not beyond(replace(wire(), region=other))
