"""Critical velocities: closed forms, dense scans of the dispersion curves in floats, numbers of others."""

from __future__ import annotations

import json
import pickle
import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from called import calls
from catalogue_models import made

from mpsolve import critical_velocities, dispersion
from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact
from mpsolve.outcome import Status
from mpsolve.tracks import (
    CATALOGUE,
    EulerBernoulli,
    FloatingIce,
    Rayleigh,
    Slab,
    String,
    ThreeLayer,
    Timoshenko,
    TwoLayer,
)
from mpsolve.tracks.undamped import undamped
from mpsolve.tracks.waveguide import Waveguide
from mpsolve.waves.velocity import Kind

BEAM = EulerBernoulli(EI="6.4e6", m=60, k="1e7", c="1e3", eta="1e-4")
TIMOSHENKO = Timoshenko(EI="6.4e6", m=60, S="4e8", J="0.24", k="1e7", c=500)
LAYERS = TwoLayer(EI="6.4e6", m=60, k_pad="1e8", m_sleeper=250, k_ballast="5e7", c_pad=1000, c_ballast=2000)
BALLAST = ThreeLayer(
    EI="6.4e6", m=60, k_pad="1e8", m_sleeper=250, k_ballast="5e7", m_ballast=500, k_ground="3e7", shear="1e6"
)
SLAB = Slab(
    EI="1.29e7",
    m=120,
    k_pad="5e8",
    EI_slab=Fraction(30 * 10**9) * Fraction("1.25") * Fraction("0.35") ** 3 / 12,
    m_slab=Fraction(2500) * Fraction("1.25") * Fraction("0.35"),
)
ICE = FloatingIce(B="1e8", h=1, rho_ice=917, rho_water=1000, depth=10, c=3)
WAVES = {Kind.TOUCHING, Kind.MINIMUM, Kind.MAXIMUM}
SHORTEST = 3e3  # wavenumber of a scan: further out extrema are flatter than the rounding of floats


def scanned(track: Any, omega: float, top: float) -> list[float]:
    """Extrema in (0, top) of v(p) = (ω − Ω)/p along every branch, from floats: there the group velocity is v."""
    out = []
    x = np.geomspace(1e-4, SHORTEST, 60_001)
    for p in (x,) if not omega else (x, -x[::-1]):
        v = (omega - dispersion(undamped(track), p).real) / p[:, None]
        for branch in v.T:
            step = np.diff(branch)
            turn = np.flatnonzero(step[1:] * step[:-1] < 0) + 1
            noise = np.abs(step[turn]) + np.abs(step[turn - 1]) < 1e-12 * np.abs(branch[turn])
            out += [float(y) for y, bad in zip(branch[turn], noise, strict=True) if 0 < y < top and not bad]
    return sorted(out)


def velocities(found: Any, kinds: set[Kind]) -> list[float]:
    return [float(one.value) for one in found if one.kind in kinds]


@pytest.mark.parametrize("omega", [0, "0.5", 50, 300, 900])
@pytest.mark.parametrize("track", [BEAM, TIMOSHENKO, LAYERS, BALLAST, SLAB], ids=lambda x: x.name)
def test_all_that_a_dense_scan_finds_and_no_more(track: Any, omega: Any) -> None:
    found = critical_velocities(track, omega)
    assert found.status is Status.UNVERIFIED
    seen = [one for one in found if one.wavenumber is not None and abs(one.wavenumber) < SHORTEST]
    assert velocities(seen, WAVES) == pytest.approx(scanned(track, float(omega), 2000.0), rel=1e-6)
    assert len(found) - len(seen) == (track in (BALLAST,)) * (1 + (omega == "0.5"))


@pytest.mark.parametrize("omega", [0, "0.5", 5])
def test_the_same_for_an_ice_road(omega: Any) -> None:
    found = critical_velocities(ICE, omega, over={"v": (0, 200)})
    assert velocities(found, WAVES) == pytest.approx(scanned(ICE, float(omega), 200.0), rel=1e-6)


def test_random_tracks_against_the_scan() -> None:
    rng = np.random.default_rng(7)
    for _ in range(12):
        EI, m, k_pad, sleeper, ballast, omega = (Fraction(int(x), 10) for x in rng.integers(1, 100, 6))
        track = TwoLayer(EI=EI, m=m, k_pad=k_pad, m_sleeper=sleeper, k_ballast=ballast)
        found = critical_velocities(track, omega, over={"v": ("0.001", 50)})
        truth = [v for v in scanned(track, float(omega), 50.0) if v > 0.001]
        assert velocities(found, WAVES) == pytest.approx(truth, rel=1e-5), track


def test_the_papers_beam_is_exact() -> None:
    """v_cr = (4 k EI/m²)^{1/4}; 1 in the paper's units."""
    (one,) = critical_velocities(EulerBernoulli(EI="1/4", m=1, k=1, c="0.1"))
    assert (one.value, one.exact, one.kind) == (1, Exact(1), Kind.MINIMUM)
    (one,) = critical_velocities(BEAM)
    assert one.exact == Exact.root4(4 * BEAM.k * BEAM.EI / BEAM.m**2)
    assert one.value.overlaps(one.exact.ball())


@pytest.mark.parametrize("N", ["-2e6", "1e6", "1.5e7"])
def test_the_beam_with_axial_force(N: str) -> None:
    """m v² = 2√(k EI) − N, y = (m v² + N)/(2 EI)."""
    track = EulerBernoulli(EI="6.4e6", m=60, k="1e7", N=N)
    square = 2 * np.sqrt(6.4e6 * 1e7) - float(N)
    (one,) = critical_velocities(track)
    assert float(one.value) == pytest.approx(np.sqrt(square / 60), rel=1e-14)
    assert float(one.wavenumber) == pytest.approx((1e7 / 6.4e6) ** 0.25, rel=1e-14)
    assert float(one.frequency) == pytest.approx(-float(one.value * one.wavenumber), rel=1e-14)


def test_many_digits_are_given() -> None:
    (one,) = critical_velocities(EulerBernoulli(EI=2, m=3, k=5, N=1), digits=200)
    assert one.value.rel_accuracy_bits() > 664
    assert one.wavenumber.rel_accuracy_bits() > 640
    assert ((3 * one.value**2 + 1) ** 2).contains(40)


@pytest.mark.parametrize("omega", [1, 100, 1000, 5000, 40000])
def test_timoshenko_has_at_most_four_below_the_bending_speed_and_always_the_shear_speed(omega: int) -> None:
    """The literature's count for a harmonic load: the shear speed, at most three group velocities."""
    found = critical_velocities(TIMOSHENKO, omega, over={"v": (0, 5000)})
    names = [one.name for one in found if one.kind is Kind.WAVE_SPEED]
    assert names == ["shear waves, √(S/m)"]
    assert len(found) <= 4
    assert [one.value for one in found] == sorted(one.value for one in found)


def test_wave_speeds_are_named_and_exact() -> None:
    found = critical_velocities(TIMOSHENKO, over={"v": (0, 20000)})
    speeds = [(one.name, one.exact) for one in found if one.kind is Kind.WAVE_SPEED]
    assert speeds == [
        ("shear waves, √(S/m)", Exact.sqrt(Fraction(4 * 10**8, 60))),
        ("bending waves, √(EI/J)", Exact.sqrt(Fraction(6400000 * 100, 24))),
    ]
    (speed,) = [one for one in critical_velocities(BALLAST) if one.kind is Kind.WAVE_SPEED]
    assert speed.name.startswith("shear waves of the ballast")


def test_the_rayleigh_beam_without_frequency() -> None:
    found = critical_velocities(Rayleigh(EI=4, m=1, J=1, k=1), over={"v": (0, 3)})
    assert [one.kind for one in found] == [Kind.MINIMUM, Kind.WAVE_SPEED]
    # (EI − Jw) y² − m w y + k: w² = 4 (4 − w)
    assert float(found.velocities[0].value) ** 2 == pytest.approx(2 * np.sqrt(5) - 2, rel=1e-14)


def test_strings() -> None:
    """Its own speed always; below its cut-off frequency v² = T(k − mω²)/(mk) too, at which a force at rest ends."""
    for omega in (0, 5):
        (one,) = critical_velocities(String(T=4, m=1, k=9), omega)
        assert (one.kind, one.exact) == (Kind.WAVE_SPEED, Exact(2))
    found = critical_velocities(String(T=4, m=1, k=9), 1)
    assert [one.exact for one in found] == [Exact.sqrt(Fraction(32, 9)), Exact(2)]
    found = critical_velocities(String(T=4, m=1, k=9), 3)
    assert [(one.kind, one.exact) for one in found] == [(Kind.LONG_WAVES, Exact(0)), (Kind.WAVE_SPEED, Exact(2))]
    assert "infinitely long wave" in found.always[0]
    (one,) = critical_velocities(String(T=4, m=1), 0)
    assert (one.kind, one.exact, one.wavenumber) == (Kind.EVERY, Exact(2), None)


def test_a_standing_force_at_the_cut_off_frequency_of_a_beam_is_listed_once() -> None:
    """Ω² = 4 p⁴ + 1, ω = 1: p = 0 at v = 0, and v⁴ = 108 where p⁴ = 3/4, Ω = −2."""
    found = critical_velocities(EulerBernoulli(EI=4, m=1, k=1), 1)
    assert [(one.kind, one.exact) for one in found] == [
        (Kind.LONG_WAVES, Exact(0)),
        (Kind.TOUCHING, Exact.root4(108)),
    ]


def test_wave_speeds_that_coincide_are_named_together() -> None:
    found = critical_velocities(Timoshenko(EI=4, m=1, S=4, J=1, k=1))
    assert found.velocities[-1].name == "shear waves, √(S/m) and bending waves, √(EI/J)"
    assert [one.exact for one in found] == [Exact.root4(Fraction(400, 81)), Exact(2)]


def test_long_waves_of_an_ice_road_run_at_the_speed_of_shallow_water() -> None:
    found = critical_velocities(ICE)
    assert [one.kind for one in found] == [Kind.MINIMUM, Kind.LONG_WAVES]
    assert found.velocities[1].exact == Exact.sqrt(Fraction(980665, 10000))
    assert found.always


def test_branches_that_cross_are_told_from_waves_that_run_with_the_force() -> None:
    """Two uncoupled strings, Ω² = 4p² + 9 and Ω² = p² + 12: their branches cross at p = 1, Ω² = 13."""
    one, two = (String(T=T, m=1, k=k).waveguide.matrix[0][0] for T, k in ((4, 9), (1, 12)))
    guide = Waveguide(((one, {}), ({}, two)))
    found = critical_velocities(guide, over={"v": (0, 10)})
    assert [(x.kind, x.exact) for x in found] == [
        (Kind.WAVE_SPEED, Exact(1)),
        (Kind.WAVE_SPEED, Exact(2)),
        (Kind.MEETING, Exact.sqrt(13)),
    ]
    assert found.velocities[2].wavenumber.contains(1)
    found = critical_velocities(guide, 1, over={"v": (0, 10)})
    truth = sorted(abs(1 + sign * np.sqrt(13)) for sign in (1, -1))
    assert velocities(found, {Kind.MEETING}) == pytest.approx(truth, rel=1e-12)


def test_a_maximum_and_a_stationary_point_of_the_phase_velocity() -> None:
    """Ω² = p² w(p²), w a cubic: its extrema are those of the phase velocity."""

    def track(*w: int) -> Waveguide:
        """D = −s² + … with Ω² = y·w(y), as s² + y w(y) in P: y = −P²."""
        terms = {(0, 2): Fraction(1)}
        for k, c in enumerate(w):
            if c:
                terms[2 * (k + 1), 0] = Fraction(c * (-1) ** (k + 1))
        return Waveguide(((terms,),))

    found = critical_velocities(track(5, 9, -6, 1))  # w = y³ − 6y² + 9y + 5: w(1) = 9, w(3) = 5
    assert {(one.kind, one.exact) for one in found} == {
        (Kind.MINIMUM, Exact.sqrt(5)),
        (Kind.LONG_WAVES, Exact.sqrt(5)),
        (Kind.MAXIMUM, Exact(3)),
    }
    assert len(found) == 3
    flat = critical_velocities(track(2, 3, -3, 1))  # w = (y − 1)³ + 3
    assert [(one.kind, one.exact) for one in flat if one.kind is not Kind.LONG_WAVES] == [
        (Kind.STATIONARY, Exact.sqrt(3))
    ]


def test_both_ends_of_the_range_are_inside_and_nothing_beyond() -> None:
    beam = EulerBernoulli(EI="1/4", m=1, k=1)
    assert len(critical_velocities(beam, over={"v": (0, 1)})) == 1
    assert len(critical_velocities(beam, over={"v": (1, 2)})) == 1
    assert len(critical_velocities(beam, over={"v": (0, "0.9999999999999999999999999")})) == 0
    assert len(critical_velocities(beam, over={"v": ("1.0000000000000000000000001", 2)})) == 0


def test_a_wave_of_train_crit_speed_in_the_answer() -> None:
    """It is the wave of a force that runs at twice its speed, with Ω = −ω: a bending wave's group velocity is 2 c."""
    omega, speed = Fraction(5148484848484848, 10**15), 42.320550453416544
    first = critical_velocities(SLAB, omega).velocities[0]
    assert float(first.value) == pytest.approx(2 * speed, rel=1e-4)
    assert float(first.wavenumber) == pytest.approx(float(omega) / speed, rel=1e-4)


@pytest.mark.parametrize("track", [*map(made, CATALOGUE), BALLAST], ids=lambda track: track.name)
def test_with_little_work(track: Any) -> None:
    """Every track that there is, with and without frequency: some milliseconds' worth of calls."""
    for omega in (0, "2.5", 301):
        found: list[Any] = []
        assert calls(lambda omega=omega, found=found: found.append(critical_velocities(track, omega))) < 20_000
        assert found[0].status is Status.UNVERIFIED
    assert track != BALLAST or len(found[0]) == 5


def test_an_answer_travels_and_speaks() -> None:
    found = critical_velocities(LAYERS, 200)
    again = pickle.loads(pickle.dumps(found))
    assert [one.value.mid() for one in again] == [one.value.mid() for one in found]
    assert len(json.loads(json.dumps(found.to_dict()))["velocities"]) == len(found)
    assert found.sentence.startswith("proved, without certificate: the list is complete for 0 ≤ v ≤ 2000")


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        ({"over": {"v": (-1, 5)}}, "over"),
        ({"over": {"v": (5, 1)}}, "over"),
        ({"over": {"k": (1, 5)}}, "over"),
        ({"over": (0, 5)}, "over"),
        ({"omega": "fast"}, "omega"),
        ({"digits": 0}, "digits"),
    ],
)
def test_bad_arguments_are_named(arguments: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError, match=key):
        critical_velocities(BEAM, **arguments)


def test_a_track_that_buckles_has_none() -> None:
    with pytest.raises(InputError, match="buckles"):
        critical_velocities(EulerBernoulli(EI=1, m=1, k=1, N=3))
    with pytest.raises(InputError, match="track"):
        critical_velocities(3)  # type: ignore[arg-type]


def test_the_page_of_the_site() -> None:
    """Its code runs; every dot of the picture lies on a curve, and damping leaves a finite deflection."""
    pytest.importorskip("matplotlib").use("Agg")
    text = (Path(__file__).parents[2] / "docs/how-to/critical-velocities.md").read_text("utf-8")
    names: dict[str, Any] = {}
    for cell in re.findall(r"```{code-cell} ipython3\n(?::tags: [^\n]*\n)?(.*?)```", text, flags=re.DOTALL):
        if "myst_nb" not in cell:  # what hands numbers to the text of the page
            exec(cell, names)
    labels = [line.get_label() for ax in names["axes"].flat for line in ax.lines]
    assert sum("shear waves" in str(label) for label in labels) == 1
    for track, listed in names["found"].values():
        assert len(listed) > 1
        for one in listed:
            if one.wavenumber is not None:
                near = dispersion(undamped(track), [float(one.wavenumber)]).real - float(one.frequency)
                assert abs(near).min() < 1e-9 * abs(float(one.frequency))
        assert np.isfinite(names["curves"](track, listed, 1.0)[3]).all()
    names["plt"].close("all")
