"""Passivity velocities against known ones, and against certified stability of very heavy masses on either side."""

from __future__ import annotations

import pickle
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import arb
from passive_subjects import RAIL

from mpsolve import InputError, Problem, Status, certify, passivity_velocity, receptance, tracks, vehicles
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.passivity import velocity
from mpsolve.passivity.answer import Kind
from mpsolve.passivity.corner import unscaled
from mpsolve.passivity.cover import Moving, Strip
from mpsolve.problem.reduced import track_guide
from mpsolve.proof.effort import Effort


def beam(eta_b: str) -> tracks.EulerBernoulli:
    return tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=2 * Fraction(eta_b))


@pytest.mark.parametrize(("eta_b", "known"), [("0.05", "1.0201285771054"), ("0.5", "1.1899209702955")])
def test_the_papers_beam(eta_b: str, known: str) -> None:
    found = passivity_velocity(beam(eta_b), over={"v": (0, 2)}, digits=40)
    assert found.kind is Kind.LOST
    assert found.status is Status.UNVERIFIED
    assert found.value.str(14, radius=False) == known
    assert found.value.rel_accuracy_bits() > 40 * 3.32
    assert pickle.loads(pickle.dumps(found)).to_dict() == found.to_dict()
    for side, count in ((-1, 0), (1, 2)):
        v = Fraction(known) * (1 + side * Fraction(1, 4000))
        heavy = certify(Problem(beam(eta_b), vehicles.Mass(10**7), v=v), region="unstable", check=False)
        assert heavy.count == count


@pytest.mark.parametrize("eta_b", ["0.003", "0.001"])
def test_light_damping(eta_b: str) -> None:
    """The sign of Im G next to the loss, from p-roots in mpmath; at q → 0 alone it changes there."""
    found, c = passivity_velocity(beam(eta_b), over={"v": (0, 2)}), 2 * mpmath.mpf(eta_b)
    assert found.kind is Kind.LOST
    with mpmath.workdps(30):
        for side, q in ((1, "1e-6"), (-1, "1e-6"), (-1, "1e-4"), (-1, "1e-2"), (-1, 1), (-1, 10)):
            v, s = mpmath.mpf(found.value.str(25, radius=False)) * (1 + side * c / 1000), mpmath.mpc(0, q)
            roots = mpmath.polyroots([0.25, 0, v**2, -v * (2 * s + c), s**2 + c * s + 1], maxsteps=200, extraprec=60)
            G = sum(1 / (P**3 + 2 * v**2 * P - v * (2 * s + c)) for P in roots if P.real < 0)
            assert G.imag * side > 0


def test_a_part_that_vibrates_without_damping() -> None:
    """A Timoshenko beam turns at √(S/J) without deflection: waves meet there. The signs of Im G are numpy's."""
    found = passivity_velocity(tracks.Timoshenko(EI="1/4", m=1, k=1, c="0.1", S=10, J="0.05"), over={"v": (0, "1.5")})
    assert found.kind is Kind.LOST
    for side, q in ((1, 1e-3), (-1, 1e-3), (-1, 0.1), (-1, 1), (-1, 200**0.5), (-1, 14.2), (-1, 30)):
        v = float(found.value.mid()) * (1 + side / 1000)
        s = np.poly1d([-v, 1j * q])
        rotation = np.poly1d([-0.25, 0, 10]) + 0.05 * s * s
        D = (np.poly1d([-10, 0, 1]) + s * s + 0.1 * s) * rotation + np.poly1d([100, 0, 0])
        ahead = D.roots[D.roots.real < 0]
        assert (rotation(ahead) / D.deriv()(ahead)).sum().imag * side > 0


def test_the_velocities_up_to_the_loss_itself_are_covered(monkeypatch: pytest.MonkeyPatch) -> None:
    """The float nearest to the loss lies below it for about half of these beams."""
    tops = []

    def cover(strip: Strip, first: float, effort: Effort) -> Any:
        tops.append(strip.high)
        return whole(strip, first, effort)

    whole = velocity.cover
    monkeypatch.setattr(velocity, "cover", cover)
    for eta_b in ("0.3", "0.35", "0.4", "0.45", "0.5"):
        tops.clear()
        found = passivity_velocity(beam(eta_b), over={"v": (0, 2)})
        assert found.kind is Kind.LOST
        unit = unscaled(Moving(track_guide(beam(eta_b), Fraction(0)), 0))
        with precision(200):
            assert arb(max(tops)) * rational_ball(unit) >= found.value


def test_a_whole_range() -> None:
    found = passivity_velocity(RAIL, over={"v": (0, 200)})
    assert found.kind is Kind.WHOLE
    assert found.value is None
    assert float(found.passive_to) == 200
    assert "no passive vehicle with one contact is unstable at any velocity" in found.sentence


def test_not_passive_from_the_start() -> None:
    found = passivity_velocity(RAIL, over={"v": (300, 400)})
    assert found.kind is Kind.FROM_START
    assert found.proved
    assert found.passive_to is None


def test_wave_speeds_are_named() -> None:
    beam = tracks.Timoshenko(EI=RAIL.EI, m=RAIL.m, S="5e6", J="0.24", k=RAIL.k, c=RAIL.c)
    found = passivity_velocity(beam, over={"v": (0, 400)}, effort=Effort(evaluations=3000))
    assert float(found.wave_speeds[0]) == pytest.approx(np.sqrt(5e6 / 60))
    above = passivity_velocity(beam, over={"v": (300, 400)})
    assert above.reason is not None
    assert above.reason.code == "wave-speed"


def test_ice_is_left_open_with_a_reason() -> None:
    ice = tracks.FloatingIce(B=1e7, h="0.5", rho_ice=917, rho_water=1000, depth=5, g="9.81", c=100)
    found = passivity_velocity(ice, over={"v": (0, 10)})
    assert found.status is Status.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "waves-meet"


def test_an_effort_that_is_spent() -> None:
    found = passivity_velocity(beam("0.05"), over={"v": (0, 2)}, effort=Effort(evaluations=60))
    assert found.kind is Kind.UNDECIDED
    assert found.reason is not None
    assert found.reason.code == "effort"


@pytest.mark.parametrize(
    ("over", "track"),
    [({"w": (0, 1)}, RAIL), ({"v": (-1, 1)}, RAIL), ({"v": (2, 1)}, RAIL),
     ({"v": (0, 1)}, tracks.EulerBernoulli(EI=1, m=1, k=1)),
     ({"v": (0, 1)}, tracks.EulerBernoulli(EI=1, m=1, k=1, c=1, N=3))],
)  # fmt: skip
def test_bad_input(over: object, track: object) -> None:
    with pytest.raises(InputError):
        passivity_velocity(track, over=over)  # type: ignore[arg-type]


WIRE = tracks.String(T=27000, m="1.07", k=500, c=2)


def test_a_string_takes_up_to_the_speed_of_its_waves() -> None:
    found = passivity_velocity(WIRE, over={"v": (0, 200)}, digits=40)
    assert found.kind is Kind.LOST
    assert float(found.value) == float(found.wave_speeds[0]) == pytest.approx(np.sqrt(27000 / 1.07))
    assert found.value.rel_accuracy_bits() > 40 * 3.32
    assert passivity_velocity(WIRE, over={"v": (0, "158.8")}).kind is Kind.WHOLE
    above = passivity_velocity(WIRE, over={"v": (160, 200)})
    assert above.reason is not None
    assert above.reason.code == "wave-speed"


@pytest.mark.parametrize("v", [0, 80, 150, "158.8"])
def test_slower_than_its_waves_it_takes(v: object) -> None:
    q = np.geomspace(1e-2, 1e3, 200)
    assert (receptance(WIRE, xi=[0], omega=q, v=v)[0].imag < 0).all()
    assert certify(Problem(WIRE, vehicles.Mass(1000), v=v), region="unstable", check=False).count == 0
