"""Anybody's own track, given by the matrix of its equations of motion."""

from __future__ import annotations

from typing import Any

from mpsolve.errors import InputError
from mpsolve.tracks import waveguide


class Waveguide(waveguide.Waveguide):
    """A track A u = e λ, A a sympy matrix in the symbols p and Omega (∂/∂x → ip, ∂/∂t → iΩ), in rational numbers.

    loaded: the number of the field that carries the contacts, counted from 0. The track must be the same in both
    directions, passive, and stable at rest: this is decided exactly when it is made. InputError says what is not.

    >>> from sympy import I, symbols
    >>> p, Omega = symbols("p Omega")
    >>> Waveguide([[2 * p**4 + 1 + I * Omega / 10 - Omega**2]]).dispersion[4, 0]
    Fraction(2, 1)
    """

    def __repr__(self) -> str:
        rows = [[_written(entry) for entry in row] for row in self.matrix]
        return f"Waveguide({rows}, loaded={self.loaded})"

    def __init__(self, matrix: Any, loaded: int = 0) -> None:
        from mpsolve.tracks.at_rest import Status, at_rest
        from mpsolve.tracks.from_sympy import exact_matrix
        from mpsolve.tracks.passive import passivity
        from mpsolve.tracks.structure import balanced

        rows = exact_matrix(matrix)
        if isinstance(loaded, bool) or not isinstance(loaded, int) or not 0 <= loaded < len(rows):
            last = len(rows) - 1
            raise InputError("loaded", f"is {loaded!r}: give the number of the field under the contacts, 0 to {last}")
        super().__init__(balanced(rows, loaded), loaded)
        found = at_rest(self)
        if found.status is Status.UNSTABLE:
            raise InputError("matrix", f"is no track to stand on: {found.sentence}; check the signs of its entries")
        energy = passivity(self)
        if energy.witness is not None:
            p, omega = energy.witness
            raise InputError("matrix", f"is not passive: it gives energy to a force near p = {p:.4g}, "
                             f"Omega = {omega:.4g}; check the signs of its entries")  # fmt: skip


def _written(entry: waveguide.Polynomial) -> str:
    """A polynomial in P = ip and s = iΩ, in p and Omega again: P^i s^j is i^(i+j) p^i Ω^j."""
    terms = []
    for (i, j), value in sorted(entry.items(), reverse=True):
        number = -value if (i + j) % 4 > 1 else value
        factors = [str(abs(number)), "I" * ((i + j) % 2), "p" * bool(i) + f"**{i}" * (i > 1)]
        factors.append("Omega" * bool(j) + f"**{j}" * (j > 1))
        terms.append(("-" if number < 0 else "+") + " " + "*".join(filter(None, factors)))
    text = " ".join(terms) or "0"
    return text.removeprefix("+ ")
