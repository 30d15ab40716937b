"""Starting guesses for other solvers: certified roots over a grid, each with a proved basin of Newton's method."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

import flint
import numpy as np
from flint import acb, arb

from mpsolve.certificate.certify import certify
from mpsolve.characteristic.proved import Proved
from mpsolve.errors import InputError, MpsolveError, PrecisionError
from mpsolve.files import csv_text, write_whole
from mpsolve.numbers.arrays import Integers, Reals
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.exact import Exact, Number
from mpsolve.numbers.taylor import Taylor, taylor
from mpsolve.parallel.pool import run
from mpsolve.problem.case import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.progress import Progress

FORMAT, VERSION = "mpsolve seeds", 2
PARAMETERS = ("alpha", "eta_b", "eta_m", "d", "eta_n", "eta_s", "mass_ratio")
CLAIM = (
    "From any start with |q - seed| <= radius, Newton's method on Delta converges to the one root in that disc, and "
    "each step at least halves the distance to it; a step with an error of at most radius/4 stays in the disc."
)
_BITS = 96
_WIDER = 1.001  # the proof is for a disc that also holds the one about the root itself
_CIRCLES, _ARCS, _SHRINK = 40, 32, 3

Row = tuple[str, ...]
Delta = Callable[[Any], Any]
Found = list[tuple[complex, float | None]]  # every root of a case with its radius, None where none is proved


@dataclass(frozen=True)
class Seeds:
    """Row k: the case `cases[k]` (exact texts in the order of PARAMETERS), a root q[k] and its proved radius[k].

    q: complex128, shape (n,), the roots of a case together, sorted by (Re q, Im q), each within |q|·10^−15 of the
    root; radius: float64; roots: int, how many roots the case has. Where its rows are fewer, `missing` has the
    others, (case, q) each: proved roots without a proved radius, next to a cut or to one another. undecided: the
    cases whose roots are not proved, which have no row. The claim is CLAIM, for exact arithmetic.
    """

    cases: tuple[Row, ...]
    q: Any
    radius: Reals
    roots: Integers
    missing: tuple[tuple[Row, complex], ...]
    undecided: tuple[Row, ...]

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes .npz, .csv (rows alone) or .json. InputError for another name, CertificateError if it fails."""
        file = Path(path)
        writers: dict[str, Callable[[], str | bytes]] = {".npz": self._npz, ".csv": self._csv, ".json": self._json}
        if file.suffix.lower() not in writers:
            raise InputError("output", f"{path} does not end in {', '.join(writers)}: give a name that does")
        return write_whole(file, writers[file.suffix.lower()]())

    def _npz(self) -> bytes:
        buffer = io.BytesIO()
        content: dict[str, Any] = dict(zip(PARAMETERS, _table(self.cases).T, strict=True))
        content |= {"q": self.q, "radius": self.radius, "roots": self.roots, "claim": np.array(CLAIM)}
        content["missing"] = _table([case for case, _ in self.missing])
        content["missing_q"] = np.array([q for _, q in self.missing], dtype=complex)
        np.savez(buffer, undecided=_table(self.undecided), **content)
        return buffer.getvalue()

    def _csv(self) -> str:
        rows = ([*case, repr(q.real), repr(q.imag), repr(radius), roots] for case, q, radius, roots in self._rows())
        return csv_text([[*PARAMETERS, "q_re", "q_im", "radius", "roots"], *rows])

    def _json(self) -> str:
        content = {
            "format": FORMAT,
            "version": VERSION,
            "claim": CLAIM,
            "parameters": PARAMETERS,
            "seeds": [
                {"case": case, "q": [q.real, q.imag], "radius": radius, "roots": roots}
                for case, q, radius, roots in self._rows()
            ],
            "missing": [{"case": case, "q": [q.real, q.imag]} for case, q in self.missing],
            "undecided": self.undecided,
        }
        return json.dumps(content, indent=1) + "\n"

    def _rows(self) -> Iterator[tuple[Row, complex, float, int]]:
        return zip(self.cases, self.q.tolist(), self.radius.tolist(), self.roots.tolist(), strict=True)


def _table(cases: Sequence[Row]) -> Any:
    return np.array(cases, dtype=str).reshape(-1, len(PARAMETERS))


def seeds(
    alpha: Sequence[Number],
    eta_b: Sequence[Number],
    eta_m: Sequence[Number],
    d: Sequence[Number],
    eta_n: Sequence[Number] = (0,),
    eta_s: Sequence[Number] = (0,),
    mass_ratio: Sequence[Number] = (1,),
    *,
    workers: int = 1,
    tell: Progress | None = None,
) -> Seeds:
    """A table over all combinations of the values given, rational each: masses eta_m at 0, mass_ratio·eta_m at d.

    mass_ratio = 0 is a single mass. Every root of the sheet is proved by `certify`, and has a row or is named as
    missing, or the case is named as undecided. workers as in `frequencies`. InputError for values that no case can
    have, before any work is done.
    """
    given = (alpha, eta_b, eta_m, d, eta_n, eta_s, mass_ratio)
    grids = []
    for name, values in zip(PARAMETERS, given, strict=True):
        listed = isinstance(values, Sequence) and not isinstance(values, str)
        if not (listed or (isinstance(values, np.ndarray) and values.ndim == 1)) or not len(values):
            raise InputError(name, f"is {values!r}: give a list of one or more values")
        grids.append([str(Exact.parse(value, name)) for value in values])
    rows = list(product(*grids))
    for row in rows:
        if not _case(row).cuts_on_line:
            raise InputError(
                "eta_b", f"of the case {row} leaves no sheet with its cuts on a line: lower it, or eta_n"
            )
    results = run(_seeds_of, rows, workers, tell, "proving")
    proved = [(row, found) for row, found in zip(rows, results, strict=True) if found is not None]
    every = [(row, q, radius, len(found)) for row, found in proved for q, radius in found]
    there = [entry for entry in every if entry[2] is not None]
    return Seeds(
        tuple(row for row, _, _, _ in there),
        np.array([q for _, q, _, _ in there], dtype=complex),
        np.array([radius for _, _, radius, _ in there], dtype=float),
        np.array([number for _, _, _, number in there], dtype=int),
        tuple((row, q) for row, q, radius, _ in every if radius is None),
        tuple(row for row, found in zip(rows, results, strict=True) if found is None),
    )


def _case(row: Row) -> Case:
    alpha, eta_b, eta_m, d, eta_n, eta_s, ratio = map(Exact, row)
    if ratio.sign < 0:
        raise InputError("mass_ratio", f"is {ratio.short()}: give a ratio from 0")
    two = ratio.sign > 0
    return Case(
        alpha=alpha,
        eta_b=eta_b,
        eta_m=[eta_m, eta_m * ratio] if two else [eta_m],
        positions=[Exact(0), d] if two else [0],
        eta_n=eta_n,
        eta_s=eta_s,
    )


def _seeds_of(row: Row) -> Found | None:
    """Every root, a multiple one as often as it counts; None where they are not proved."""
    case = _case(row)
    try:
        spectrum = certify(case, region="sheet")
    except MpsolveError:
        return None
    if not spectrum.proved:
        return None
    delta = characteristic(case)
    return [
        (complex(root.q.mid()), _radius(delta, root.q)) for root in spectrum.roots for _ in range(root.multiplicity)
    ]


def characteristic(case: Case) -> Delta:
    """Δ(q) of (26) in balls, up to its sign; `PrecisionError` where a ball may meet a cut."""
    reduced = reduce_problem(as_problem(case))
    proved = Proved(reduced, eliminate=False)

    def delta(q: Any) -> Any:
        return proved.matrices(flint.acb(0, 1) * q / rational_ball(reduced.frequency_unit), slope=False)[0].det()

    return delta


def _radius(delta: Delta, root: acb) -> float | None:
    try:
        return basin(delta, root)
    except PrecisionError:
        return None


def basin(delta: Delta, root: acb) -> float:
    """A radius ρ about the float64 midpoint c of the root's ball: Newton's method on Δ from |q − c| ≤ ρ is proved
    to halve the distance to the root z with every step. Raises `PrecisionError` where no ρ can be proved.

    Let |Δ' − Δ'(c)| ≤ e in the disc. Newton's step from q ends at z + (1 − a/b)(q − z), where b = Δ'(q) and a is a
    mean of Δ' between z and q, so that |1 − a/b| ≤ 2e/(|Δ'(c)| − e) ≤ 1/2 if e ≤ |Δ'(c)|/5. The same shows that
    z is alone.
    """
    centre = complex(root.mid())
    best = 0.0
    with precision(_BITS):
        c = flint.acb(centre.real, centre.imag)
        for k in range(_CIRCLES):
            outer = abs(centre) * 2.0 ** (-1 - k)
            if outer <= 2 * best:
                break
            try:
                bound = _on_circle(delta, c, outer)
                series = taylor(delta, c, flint.arb(outer), bound, _SHRINK)
            except PrecisionError:
                continue
            radii = (outer * 2.0 ** (-1 - j / 4) for j in range(48))
            best = max(best, next((radius for radius in radii if _contracts(series, _WIDER * radius)), 0.0))
        if best > 0 and abs(flint.acb(root) - c) < (_WIDER - 1) / 2 * best:
            return best
    raise PrecisionError(
        f"no basin could be proved about {centre:.6g}: the root is too close to a cut or another root"
    )


def _on_circle(delta: Delta, c: acb, r: float) -> arb:
    """A bound of |Δ| on |q − c| = r, and so within: the cuts are unbounded, a disc whose rim meets none is free of
    them. `PrecisionError` where an arc may meet a cut.
    """
    bound = flint.arb(0)
    for k in range(_ARCS):
        turn = (2 * k + 1 + flint.arb(0, 1)) / _ARCS
        bound = bound.max(flint.arb(delta(c + r * flint.acb(turn).exp_pi_i()).abs_upper()))
    if not bound.is_finite():
        raise PrecisionError("the arcs of a circle are too wide: take a smaller circle")
    return bound


def _contracts(series: Taylor, radius: float) -> bool:
    """e ≤ |a₁|/5 with e = Σ k |a_k| ρ^(k−1), k ≥ 2, whose end is bounded by |a_k| ≤ bound/outer^k."""
    rho, x, n = flint.arb(radius), radius / series.outer, len(series.coefficients)
    tail = series.bound / series.outer * x ** (n - 1) * (n - (n - 1) * x) / (1 - x) ** 2
    e = sum((k * abs(series.coefficients[k]) * rho ** (k - 1) for k in range(2, n)), tail)
    return bool(x < 1 and 5 * e <= abs(series.coefficients[1]))
