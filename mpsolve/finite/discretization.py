"""The equations of a track at the wavenumbers of a finite, simply supported length: matrices mode by mode.

On 0 < x < L a field of the track is Σ a_j sin κ_j x or Σ a_j cos κ_j x, κ_j = jπ/L. Where ∂x occurs an even number of
times in an entry of A(∂x, ∂t), its two fields are of one kind; where it occurs an odd number of times, they are of
both. With P → iκ and a phase of each field (1 for sines, i for cosines) every entry is real then. The field under
the contacts expands in sines: it vanishes at the supports. Guided ends, where its slope vanishes, make it cosines
with the same matrices, and a constant.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

import numpy as np

from mpsolve.errors import InputError
from mpsolve.numbers.arrays import Reals
from mpsolve.tracks.waveguide import Matrix, Polynomial, Waveguide, cofactor, determinant

SINE, COSINE = 0, 1
_HIGHEST = 2
_NEARLY_0 = 1e-3
_BEYOND = 40
"""Times the modes of a track: as far as those beyond count."""


@dataclass(frozen=True)
class Discretization:
    """`matrix`: real polynomials {(power of κ, power of s): c}; `kinds`: SINE or COSINE of each field; exact.

    loaded: the field under the contacts. wavenumbers (J,): κ_j = jπ/length, float64. guided: the ends hold slopes and
    not deflections; kinds turn about, and j = 0 comes before the others, a little above 0, where roots may meet.
    """

    matrix: Matrix
    kinds: tuple[int, ...]
    loaded: int
    length: float
    modes: int
    guided: bool = False

    @property
    def wavenumbers(self) -> Reals:
        first = [_NEARLY_0] if self.guided else []
        return np.concatenate([first, np.arange(1, self.modes + 1)]) * (np.pi / self.length)

    @property
    def mass(self) -> Reals:
        """The coefficients of s², (J, fields, fields)."""
        return self._coefficient(2)

    @property
    def damping(self) -> Reals:
        """The coefficients of s, (J, fields, fields)."""
        return self._coefficient(1)

    @property
    def stiffness(self) -> Reals:
        """The coefficients of 1, (J, fields, fields)."""
        return self._coefficient(0)

    @cached_property
    def dispersion(self) -> Polynomial:
        """det of the matrix."""
        return determinant(self.matrix)

    @cached_property
    def numerator(self) -> Polynomial:
        """The cofactor of the field under the contacts."""
        return cofactor(self.matrix, self.loaded)

    def _coefficient(self, power: int) -> Reals:
        rows = [[in_s(entry, self.wavenumbers, _HIGHEST)[power] for entry in row] for row in self.matrix]
        return np.moveaxis(np.array(rows), -1, 0)


def discretized(waveguide: Waveguide, length: float, modes: int, guided: bool = False) -> Discretization:
    """The track on this length in this number of sines; InputError where no phases make its equations real."""
    kinds = _kinds(waveguide)
    size = range(len(waveguide.matrix))
    matrix = tuple(tuple(_real(waveguide.matrix[m][n], kinds[n]) for n in size) for m in size)
    if any(power > _HIGHEST for row in matrix for entry in row for _, power in entry):
        raise InputError("track", "has a third derivative in time: split a field in two, so that s² is the highest")
    found = Discretization(matrix, kinds, waveguide.loaded, length, modes, guided)
    if _degree(found.numerator) >= _degree(found.dispersion):
        stated = "has neither mass nor damping in the field under the contacts, so that it answers a force at once"
        raise InputError("track", f"{stated}: give the field some mass or damping")
    return found


def compliance_beyond(track: Discretization, velocity: float, away: Reals) -> Reals:
    """What the modes beyond those of the track give way to constant forces that move, at these distances from them.

    Such a mode is stiff, and follows the force as if at rest in the moving frame. Images in the supports are left
    out.
    """
    more = replace(track, modes=_BEYOND * track.modes, guided=False)
    k = more.wavenumbers[track.modes :]
    turn = (1j * velocity * k) ** np.arange(_HIGHEST * len(track.matrix) + 1)[:, None]
    D, N = ((in_s(part, k, len(turn) - 1) * turn).sum(0) for part in (track.dispersion, track.numerator))
    give = (N / D).real / track.length
    return np.reshape([np.cos(gap * k) @ give for gap in np.ravel(away)], np.shape(away))


def in_s(polynomial: Polynomial, wavenumbers: Reals, degree: int) -> Reals:
    """The coefficients of s⁰ … s^degree at each wavenumber, (degree + 1, J)."""
    out = np.zeros((degree + 1, len(wavenumbers)))
    for (i, j), value in polynomial.items():
        out[j] += float(value) * wavenumbers**i
    return out


def _degree(polynomial: Polynomial) -> int:
    return max((j for _, j in polynomial), default=-1)


def _kinds(waveguide: Waveguide) -> tuple[int, ...]:
    """The kind of each field, by walking from the one under the contacts; what it does not reach is of no account."""
    matrix = waveguide.matrix
    kinds = {waveguide.loaded: SINE}
    queue = [waveguide.loaded]
    while queue:
        m = queue.pop()
        for n in range(len(matrix)):
            for entry, where in ((matrix[m][n], (m, n)), (matrix[n][m], (n, m))):
                parities = {i % 2 for i, _ in entry}
                if len(parities) > 1:
                    raise _one_way(where)
                for parity in parities:
                    kind = (kinds[m] + parity) % 2
                    if n not in kinds:
                        kinds[n] = kind
                        queue.append(n)
                    elif kinds[n] != kind:
                        raise _one_way(where)
    return tuple(kinds.get(n, SINE) for n in range(len(matrix)))


def _one_way(where: tuple[int, int]) -> InputError:
    stated = f"has even and odd powers of p in conflict at row {where[0] + 1}, column {where[1] + 1} of its matrix"
    remedy = (
        "only fields that are sines or cosines each, as of a track that is the same in both directions, are known"
    )
    return InputError("track", f"{stated}, so that it does not expand on a simply supported length: {remedy}")


def _real(entry: Polynomial, kind: int) -> Polynomial:
    """The entry that acts on sin κx or cos κx: ∂² = −κ², ∂ sin = κ cos, ∂ cos = −κ sin."""
    out: Polynomial = {}
    for (i, j), value in entry.items():
        sign = Fraction(-1) ** (i // 2) * (-1 if i % 2 and kind == COSINE else 1)
        out[i, j] = sign * value
    return out
