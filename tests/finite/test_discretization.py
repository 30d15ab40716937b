"""The matrices of the modes are the exact equations at P = iκ, up to the phases of the fields."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from track_models import DAMPED, random_tracks

from mpsolve.errors import InputError
from mpsolve.finite.discretization import COSINE, SINE, discretized
from mpsolve.tracks.waveguide import Track, Waveguide


def _equations(waveguide: Waveguide, P: complex, s: complex) -> np.ndarray:
    return np.array([[sum(float(c) * P**i * s**j for (i, j), c in entry.items()) for entry in row]
                     for row in waveguide.matrix])  # fmt: skip


@pytest.mark.parametrize("name", DAMPED)
def test_matrices_are_the_equations_at_imaginary_wavenumbers(name: str) -> None:
    waveguide = DAMPED[name].waveguide
    found = discretized(waveguide, 30.0, 9)
    s = 3.0 + 700j
    phases = np.where(np.array(found.kinds) == COSINE, 1j, 1)
    for j in (0, 4, 8):
        whole = found.stiffness[j] + s * found.damping[j] + s**2 * found.mass[j]
        truth = _equations(waveguide, 1j * found.wavenumbers[j], s)
        assert np.allclose(whole, truth * phases / phases[:, None], rtol=1e-12)


def test_the_rotation_of_a_timoshenko_beam_is_a_cosine_and_its_stiffness_symmetric() -> None:
    found = discretized(DAMPED["timoshenko"].waveguide, 30.0, 5)
    assert found.kinds == (SINE, COSINE)
    assert np.array_equal(found.stiffness, found.stiffness.transpose(0, 2, 1))
    assert (np.linalg.eigvalsh(found.stiffness) > 0).all()


@settings(max_examples=30)
@given(random_tracks())
def test_phases_leave_the_determinant_as_it_is(track: Track) -> None:
    waveguide = track.waveguide
    found = discretized(waveguide, 30.0, 8)
    for mine, theirs in ((found.dispersion, waveguide.dispersion), (found.numerator, waveguide.numerator)):
        assert mine == {(i, j): Fraction(-1) ** (i // 2) * c for (i, j), c in theirs.items()}


@pytest.mark.parametrize(
    "matrix",
    [
        ((({(4, 0): Fraction(1), (1, 0): Fraction(1), (0, 2): Fraction(1)}),),),
        (({(0, 2): Fraction(1), (2, 0): Fraction(-1)}, {(1, 0): Fraction(1), (0, 0): Fraction(1)}),
         ({(1, 0): Fraction(-1)}, {(0, 2): Fraction(1)})),
        (({(0, 2): Fraction(1)}, {(1, 0): Fraction(1)}), ({(0, 0): Fraction(1)}, {(0, 2): Fraction(1)})),
    ],
)  # fmt: skip
def test_a_track_that_runs_one_way_is_refused(matrix: object) -> None:
    with pytest.raises(InputError, match="sines or cosines"):
        discretized(Waveguide(matrix), 30.0, 8)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        ({(4, 0): Fraction(1), (0, 3): Fraction(1)}, "third derivative"),
        ({(4, 0): Fraction(1), (0, 0): Fraction(1)}, "neither mass nor damping"),
    ],
)
def test_a_track_without_a_march_is_refused(entry: dict[tuple[int, int], Fraction], words: str) -> None:
    with pytest.raises(InputError, match=words):
        discretized(Waveguide(((entry,),)), 30.0, 8)
