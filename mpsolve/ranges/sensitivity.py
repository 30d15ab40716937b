"""How each root moves with each parameter: d(root)/d(parameter) in balls, by implicit differentiation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from time import process_time
from typing import TYPE_CHECKING, Any

from mpsolve.certificate.solve import certify_problem
from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.characteristic.splitting import upper_count
from mpsolve.characteristic.symbol import Symbol
from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import acb, precision, rational_ball
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.reduction import Reduction
from mpsolve.outcome import Reason, Status
from mpsolve.parallel.threads import one_thread
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.family import Family, family_of
from mpsolve.problem.problem import Problem
from mpsolve.progress import Progress, silent
from mpsolve.proof.effort import Effort
from mpsolve.ranges.answer import Answer, Spent

if TYPE_CHECKING:
    from mpsolve.spectrum.spectrum import Spectrum

_GUARD = 64


@dataclass(frozen=True)
class Moved(Portable):
    """A root and its slopes: `by[path]` is a ball of dq/d(parameter), Im below 0 where growth comes with it."""

    q: Any
    by: Mapping[str, acb]


@dataclass(frozen=True)
class Sensitivity(Answer):
    """The slopes of every simple root that was found, and the spectrum of which the roots are.

    left_out: parameters at which the problem has no slope, or none that is known, with the reason.
    """

    roots: tuple[Moved, ...] = ()
    left_out: Mapping[str, str] = field(default_factory=dict)
    spectrum: Spectrum | None = field(default=None, repr=False)

    def rows(self) -> list[Mapping[str, Any]]:
        """The answer as a table, numbers as floats: one mapping for each row."""
        return [{"q": complex(root.q.mid()), "parameter": path, "slope": complex(slope.mid())}
                for root in self.roots for path, slope in root.by.items()]  # fmt: skip


def sensitivity(
    problem: Given,
    *,
    region: object = None,
    digits: int = 15,
    effort: Effort | None = None,
    progress: Progress | None = None,
    check: bool = True,
) -> Sensitivity:
    """d(root)/d(parameter) of every root of the region, for every parameter of the problem, in balls.

    region, digits, effort, progress, check: as of `certify`; digits are those of the roots, slopes have some fewer.
    """
    started = process_time()
    given, tell = as_problem(problem), progress or silent
    with one_thread():
        found = certify_problem(given, region=region, digits=digits, effort=effort, progress=tell, check=check)
        by: list[dict[str, Any]] = [{} for _ in found.roots]
        left: dict[str, str] = {}
        paths = list(given.parameters)
        for k, path in enumerate(paths):
            tell("slopes", k / len(paths))
            try:
                slopes = _slopes(given, path, [root.q for root in found.roots])
            except (InputError, PrecisionError) as error:
                left[path] = str(error)
                continue
            for row, slope in zip(by, slopes, strict=True):
                if slope is not None:
                    row[path] = slope
    roots = tuple(Moved(root.q, row) for root, row in zip(found.roots, by, strict=True))
    multiple = any(root.multiplicity > 1 for root in found.roots)
    reason = found.reason
    if reason is None and multiple:
        reason = Reason(
            "multiple", "a multiple root has no slope", {}, "ask for more digits, so that close roots part"
        )
    status = Status.UNVERIFIED if reason is None else Status.UNDECIDED
    cost = Spent.since(started, found)
    note = "" if reason else "the roots have one, in .spectrum.certificate, and their slopes have none"
    return Sensitivity(problem, {}, status, reason, cost=cost, note=note, roots=roots, left_out=left, spectrum=found)


def _slopes(problem: Problem, path: str, roots: list[acb]) -> list[acb]:
    """dq/d(parameter) for each root; None where balls do not tell."""
    value = problem.parameters[path]
    family = family_of(problem, {path: (value, value)})
    proved = FreeProved(family, upper_count(Symbol.of(family.guide(family.ring.point).D)))
    return [_slope(family, proved, q) for q in roots]


def _slope(family: Family, proved: FreeProved, q: Any) -> Any:
    with precision(max(int(q.bits()), 53) + _GUARD):
        unit = rational_ball(family.frequency_unit)
        sigma = acb(0, 1) * q / unit
        x = rational_ball(family.ring.point[0])
        try:
            reduction = Reduction.of(proved.matrices(sigma.mid(), [x], slopes=False)[0], near_root=True)
            A, (A_sigma, A_x) = proved.matrices(sigma, [x])
            moved = -reduction.scalar_slope(A, A_x) / reduction.scalar_slope(A, A_sigma)
        except PrecisionError:
            return None
        slope = acb(0, -1) * moved * unit / rational_ball(family.units[0])
        return slope if slope.is_finite() else None
