"""The work of a study: the results of one block of cases, the same wherever and whenever it is done."""

from __future__ import annotations

import hashlib
import json
import zlib
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import astuple, dataclass, replace
from threading import Lock
from typing import TYPE_CHECKING, Any

from mpsolve import __version__
from mpsolve.certificate.format import Certificate
from mpsolve.errors import InputError, MpsolveError, StudyError
from mpsolve.model.specs import ONE_MASS, case_of
from mpsolve.studies.design import Value
from mpsolve.studies.spec import PARAMETERS, Spec, spec_of

if TYPE_CHECKING:
    from mpsolve.numbers.rootball import RootBall

FORMAT = 2
"""Raised when the results of a case, or the way they are written, change."""
ENGINE = f"mpsolve {__version__}, results {FORMAT}"

STATUSES = {
    "certified": ("proved", "undecided", "refused"),
    "float64": ("certified", "tracked", "unresolved", "refused"),
}
"""What can become of a case. "refused": it breaks a bound, see its reason."""
GOOD = ("proved", "certified", "tracked")
"""Those that come with roots and counts; a tracked case has them from float64, without proof."""

_LEVEL = 3  # of compression
_OFF_LINE = "the case leaves 0 ≤ eta_b < 1, eta_n − eta_s < √(1 − eta_b²), where the cuts lie on a line"
_UNRESOLVED = 'float64 does not tell the roots of this case: use kind = "certified"'
_alone = Lock()  # the precision of balls belongs to the process, so that threads take turns


@dataclass(frozen=True)
class Root:
    """A root: re, im as floats (float64), or as decimals within re_radius, im_radius of the exact number.

    axis: the axis on which the root is proved to lie, "none", "real" or "imaginary"; "" in float64.
    """

    re: float | str
    im: float | str
    re_radius: str | None = None
    im_radius: str | None = None
    multiplicity: int = 1
    axis: str = ""


@dataclass(frozen=True)
class Result:
    """The result of one case. status: see STATUSES; reason: "" if all is well.

    count, unstable: the number of roots with multiplicity, and of those with Im q < 0, or None where that is open.
    roots: sorted by (Re q, Im q). certificate: its content, if the study keeps certificates and there is one.
    """

    status: str
    reason: str
    count: int | None
    unstable: int | None
    roots: tuple[Root, ...]
    certificate: Certificate | None = None

    @property
    def width(self) -> int:
        """The number of roots, each as often as its multiplicity says."""
        return sum(root.multiplicity for root in self.roots)


@dataclass(frozen=True)
class Block:
    """The results of a block, packed. key: see `key`; width: most roots of a case; tally: JSON, cases by status.

    seal: SHA-256 of all the rest, by which damage is noticed.
    """

    number: int
    key: str
    data: bytes
    width: int
    tally: str
    seal: str = ""

    @property
    def sealed(self) -> Block:
        """The same with its seal."""
        return replace(self, seal=self._seal)

    @property
    def whole(self) -> bool:
        """Whether it is as it was sealed."""
        return self.seal == self._seal

    @property
    def _seal(self) -> str:
        head = json.dumps([self.number, self.key, self.width, self.tally])
        return hashlib.sha256(head.encode("ascii") + self.data).hexdigest()


def work(text: str, number: int, place: int | None = None) -> Block:
    """The block `number` of the study whose spec has this `text`, or of a larger one; `place`: its number here."""
    spec = spec_of(text)
    values = [spec.values(index) for index in spec.indices(number if place is None else place)]
    with _alone:
        results = _certified(spec, values) if spec.kind == "certified" else _float64(spec, values)
    found = Counter(result.status for result in results)
    tally = {status: found[status] for status in STATUSES[spec.kind] if found[status]}
    width = max(result.width for result in results)
    return Block(number, key(spec, values), pack(results), width, json.dumps(tally)).sealed


def key(spec: Spec, values: Sequence[dict[str, Value]]) -> str:
    """SHA-256 of the engine, of what is asked, and of the exact cases."""
    lines = (",".join(f"{name}={value}" for name, value in case.items()) for case in values)
    return hashlib.sha256("\n".join((ENGINE, spec.asked, *lines)).encode("utf-8")).hexdigest()


def pack(results: Sequence[Result]) -> bytes:
    """The results as compressed JSON, a list each; floats in the shortest text that gives them back."""
    rows = [
        [r.status, r.reason, r.count, r.unstable, [_short(root) for root in r.roots]]
        + ([] if r.certificate is None else [r.certificate.content])
        for r in results
    ]
    return zlib.compress(json.dumps(rows, separators=(",", ":"), allow_nan=False).encode("ascii"), _LEVEL)


def _short(root: Root) -> list[Any]:
    return [root.re, root.im] if isinstance(root.re, float) else list(astuple(root))


def unpack(data: bytes) -> Iterator[Result]:
    """The results that `pack` packed."""
    for status, reason, count, unstable, roots, *rest in json.loads(zlib.decompress(data)):
        certificate = Certificate(rest[0]) if rest else None
        yield Result(status, reason, count, unstable, tuple(Root(*root) for root in roots), certificate)


def _certified(spec: Spec, cases: Sequence[dict[str, Value]]) -> list[Result]:
    return [_certify(spec, values) for values in cases]


def _certify(spec: Spec, values: dict[str, Value]) -> Result:
    from mpsolve.certificate.sheet import certify_sheet, known_count

    try:
        found = certify_sheet(case_of(values, spec.masses), spec.digits, spec.region)
    except InputError as error:
        return Result("refused", str(error), None, None, ())
    except MpsolveError as error:
        return Result("undecided", str(error), None, None, ())
    roots = tuple(_root(root, spec.digits) for root in found.roots)
    certificate = found.certificate if spec.certificates else None
    return Result(found.status.value, found.reason, known_count(found), found.unstable, roots, certificate)


def _root(root: RootBall, digits: int) -> Root:
    from mpsolve.fields import ball_arithmetic
    from mpsolve.numbers.decimals import decimal, working_bits

    with ball_arithmetic(working_bits(digits)):
        re, im = (decimal(part, digits + 2) for part in (root.q.real, root.q.imag))
    return Root(re.text, im.text, re.radius_text, im.radius_text, root.multiplicity, root.symmetry.value)


def _float64(spec: Spec, cases: Sequence[dict[str, Value]]) -> list[Result]:
    import numpy as np

    from mpsolve.fast.frequencies import frequencies

    columns = {name: np.array([_float(case[name]) for case in cases]) for name in spec.names}
    absent = {"mass_ratio": 1.0, "d": np.nan, "eta_n": 0.0, "eta_s": 0.0}
    alpha, eta_b, eta_m, share, d, eta_n, eta_s = (
        columns[name] if name in columns else np.full(len(cases), absent[name]) for name in PARAMETERS
    )
    share, d = np.where(np.isnan(d), 0.0, share), np.nan_to_num(d, nan=1.0)  # no d: one mass alone
    inside = (eta_b < 1) & (eta_n - eta_s < np.sqrt(np.maximum(1 - eta_b**2, 0)))
    results = [Result("refused", _OFF_LINE, None, None, ())] * len(cases)
    if not inside.any():
        return results
    found = frequencies(*(array[inside] for array in (alpha, eta_b, eta_m, d, eta_n, eta_s, share)))
    labels, counts = found.status.tolist(), found.count.tolist()
    for place, status, count, q in zip(np.flatnonzero(inside).tolist(), labels, counts, found.q, strict=True):
        roots = tuple(Root(x.real, x.imag) for x in q[np.isfinite(q)].tolist())
        if count < 0:
            results[place] = Result("unresolved", _UNRESOLVED, None, None, roots)
        else:
            results[place] = Result(status, "", count, int((q.imag < 0).sum()), roots)
    return results


def _float(value: Value) -> float:
    return float("nan") if value == ONE_MASS else float(value)


def checked(spec: Spec, block: Block, path: object) -> tuple[list[dict[str, Value]], list[Result]]:
    """The parameters and the results of a stored block; StudyError if it is damaged or is of other cases."""
    indices = spec.indices(block.number)
    values = [spec.values(index) for index in indices]
    if not block.whole or key(spec, values) != block.key:
        stated = f"holds damaged results of the cases {indices[0]} to {indices[-1]}"
        raise StudyError(f"{path} {stated}: run the study again on this file, which computes them anew")
    return values, list(unpack(block.data))
