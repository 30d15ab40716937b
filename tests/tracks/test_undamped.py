"""A track without its damping: by its parameters, and by its bare equations."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Problem, certify
from mpsolve.errors import InputError
from mpsolve.numbers.model import quantities
from mpsolve.tracks import CATALOGUE, FloatingIce, Slab, ThreeLayer, Track, TwoLayer, Waveguide
from mpsolve.tracks.undamped import damping_wanted, dissipates, is_reciprocal, undamped
from mpsolve.vehicles import Mass

LAYERS = {"EI": 4, "m": 1, "k_pad": 3, "m_sleeper": 2, "k_ballast": 5}
ICE = {"B": 100, "h": 1, "rho_ice": 9, "rho_water": 10, "depth": 2}


@pytest.mark.parametrize("kind", CATALOGUE)
def test_the_parameters_that_dissipate_are_those_that_are_called_damping(kind: type) -> None:
    for name, quantity in quantities(kind).items():
        assert dissipates(quantity) == ("damping" in quantity.meaning), name


def test_a_track_loses_its_damping_and_nothing_else() -> None:
    damped = TwoLayer(**LAYERS, c_pad=7, c_ballast="0.5", eta="0.1")
    assert undamped(damped) == TwoLayer(**LAYERS).waveguide
    assert undamped(FloatingIce(**ICE, c=3, eta=1)) == FloatingIce(**ICE).waveguide


def test_bare_equations_lose_odd_powers_entry_by_entry() -> None:
    """Not in the determinant, where two dampers make an even power."""
    damped = TwoLayer(**LAYERS, c_pad=7, c_ballast="0.5", eta="0.1").waveguide
    assert undamped(damped) == TwoLayer(**LAYERS).waveguide
    assert {key for key in damped.dispersion if key[1] % 2 == 0} == set(undamped(damped).dispersion)
    assert damped.dispersion[0, 2] != undamped(damped).dispersion[0, 2]


def test_equations_that_are_not_reciprocal_stay_or_are_refused() -> None:
    ice = FloatingIce(**ICE).waveguide
    assert not is_reciprocal(ice)
    assert undamped(ice) is ice
    with pytest.raises(InputError, match="not reciprocal"):
        undamped(FloatingIce(**ICE, c=3).waveguide)


def test_an_own_track_is_undamped_too() -> None:
    from sympy import I, symbols

    p, omega = symbols("p Omega")
    own = Waveguide([[2 * p**4 + 1 + I * omega / 10 - omega**2]])
    assert undamped(own).dispersion == {(4, 0): Fraction(2), (0, 0): Fraction(1), (0, 2): Fraction(1)}


def test_which_damping_is_wanted() -> None:
    said = damping_wanted(TwoLayer(**LAYERS))
    assert said.startswith("give a value above 0 to c_pad (30 kN s/m² is typical) or c_ballast (80 kN s/m²")
    assert "mpsolve work-out damping" in said
    assert damping_wanted(FloatingIce(**ICE)) == "give a value above 0 to c or eta"
    assert damping_wanted(undamped(TwoLayer(**LAYERS))) == "give it some damping"


BARE = {"EI": 1, "m": 1, "k_pad": 2}


@pytest.mark.parametrize(
    ("track", "wanted"),
    [
        (TwoLayer(**BARE), {"c_ballast", "eta"}),
        (TwoLayer(**BARE, c_pad="0.1"), {"c_ballast", "eta"}),  # sleepers without mass and ballast damp nothing
        (ThreeLayer(**BARE, k_ballast=3), {"c_ground", "eta"}),
        (ThreeLayer(**BARE, k_ballast=3, m_ballast=1, k_ground=1), {"c_pad", "c_ballast", "c_ground", "eta"}),
        (Slab(**BARE), {"c"}),
    ],
)
def test_only_damping_that_helps_is_asked_for(track: Track, wanted: set[str]) -> None:
    """Tried: `certify` takes the track with any of those that are named, and with none of the others."""
    said = damping_wanted(track)
    for name in (name for name, one in quantities(type(track)).items() if dissipates(one)):
        assert (f" {name} " in f"{said.replace(',', ' ')} ") == (name in wanted)
        problem = Problem(type(track)(**(track.parameters | {name: Fraction(1)})), Mass(1), v=0)
        if name in wanted:
            assert certify(problem, region="unstable", digits=15).stable
        else:
            with pytest.raises(InputError, match="without damping"):
                certify(problem)
