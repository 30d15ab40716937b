"""The work of a study: the results of one block of cases, the same wherever and whenever it is done."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import astuple, dataclass, replace
from threading import Lock
from typing import Any

from mpsolve import __version__
from mpsolve.certificate.format import Certificate
from mpsolve.errors import InputError, MpsolveError, StudyError
from mpsolve.studies.design import Value
from mpsolve.studies.spec import Spec, spec_of

FORMAT = 3
"""Raised when the results of an entry, or the way they are written, change."""
ENGINE = f"mpsolve {__version__}, results {FORMAT}"

STATUSES = {
    "certified": ("proved", "proved, not verified", "undecided", "refused"),
    "float64": ("ok", "unresolved", "refused"),
    "stable": ("proved", "proved, not verified", "undecided", "refused"),
}
"""What can become of an entry. "refused": it cannot be, see its reason."""
GOOD = ("proved", "ok")
"""Those that come with counts; an "ok" entry has them from float64, without proof."""

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
    """The result of one entry. status: see STATUSES; reason: "" if all is well.

    count, unstable: the number of roots with multiplicity, and of those with Im q < 0, or None where that is open.
    Of a part of a box (stable): 0 where nothing grows all over it, else those of a point in it where some do.
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
    """The results of a block, packed. key: see `key`; width: most roots of an entry; tally: JSON, entries by status.

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
    def results(self) -> tuple[Result, ...]:
        """The results of its entries in order."""
        return tuple(unpack(self.data))

    @property
    def _seal(self) -> str:
        head = json.dumps([self.number, self.key, self.width, self.tally])
        return hashlib.sha256(head.encode("ascii") + self.data).hexdigest()


def work(text: str, number: int, place: int | None = None) -> Block:
    """The block `number` of the study whose spec has this `text`, or of a larger one; `place`: its number here."""
    spec = spec_of(text)
    indices = spec.indices(number if place is None else place)
    with _alone:
        one = {"certified": _certify, "stable": _stable}.get(spec.kind)
        results = _float64(spec, indices) if one is None else [_told(one, spec, index) for index in indices]
    return block_of(spec, number, [spec.values(index) for index in indices], results)


def block_of(spec: Spec, number: int, values: Sequence[dict[str, Value]], results: Sequence[Result]) -> Block:
    """The sealed block of these results."""
    found = Counter(result.status for result in results)
    tally = {status: found[status] for status in STATUSES[spec.kind] if found[status]}
    width = max(result.width for result in results)
    return Block(number, key(spec, values), pack(results), width, json.dumps(tally)).sealed


def key(spec: Spec, values: Sequence[dict[str, Value]]) -> str:
    """SHA-256 of the engine, of what is asked, and of the exact entries."""
    lines = (",".join(f"{name}={value}" for name, value in entry.items()) for entry in values)
    return hashlib.sha256("\n".join((ENGINE, spec.asked, *lines)).encode("utf-8")).hexdigest()


def pack(results: Sequence[Result]) -> bytes:
    """The results as JSON, a list each; floats in the shortest text that gives them back."""
    rows = [
        [r.status, r.reason, r.count, r.unstable, [_short(root) for root in r.roots]]
        + ([] if r.certificate is None else [r.certificate.content])
        for r in results
    ]
    return json.dumps(rows, separators=(",", ":"), allow_nan=False).encode("ascii")


def _short(root: Root) -> list[Any]:
    return [root.re, root.im] if isinstance(root.re, float) else list(astuple(root))


def unpack(data: bytes) -> Iterator[Result]:
    """The results that `pack` packed."""
    for status, reason, count, unstable, roots, *rest in json.loads(data):
        certificate = Certificate(rest[0]) if rest else None
        yield Result(status, reason, count, unstable, tuple(Root(*root) for root in roots), certificate)


def _told(one: Callable[[Spec, int], Result], spec: Spec, index: int) -> Result:
    """The result of one entry; an error is a result, too."""
    try:
        return one(spec, index)
    except InputError as error:
        return Result("refused", str(error), None, None, ())
    except MpsolveError as error:
        return Result("undecided", str(error), None, None, ())


def _certify(spec: Spec, index: int) -> Result:
    from mpsolve.certificate.certify import certify

    given = spec.given if not spec.axes else spec.problem(index)
    found = certify(given, digits=spec.digits, region=spec.region)
    roots = tuple(_root(root, spec.digits) for root in found.roots)
    certificate = found.certificate if spec.certificates else None
    reason = "" if found.reason is None else str(found.reason)
    return Result(found.status.value, reason, found.count, found.unstable, roots, certificate)


def _stable(spec: Spec, index: int) -> Result:
    from mpsolve.proof.effort import Effort
    from mpsolve.ranges.robust import prove_box

    effort = Effort(evaluations=spec.boxes)
    found = prove_box(spec.problem(index), over=spec.part(index), effort=effort, check=spec.certificates)
    if found.reason is not None and found.reason.code == "interrupted":
        raise KeyboardInterrupt
    grow = {True: 0, False: getattr(found.spectrum, "unstable", None), None: None}[found.stable]
    certificate = (found.certificate or getattr(found.spectrum, "certificate", None)) if spec.certificates else None
    reason = str(found.reason or found.note)
    return Result(found.status.value, reason, grow, grow, (), certificate)


def _root(root: Any, digits: int) -> Root:
    from mpsolve.numbers.balls import precision
    from mpsolve.numbers.decimals import decimal, working_bits

    with precision(working_bits(digits)):
        re, im = (decimal(part, digits + 2) for part in (root.q.real, root.q.imag))
    return Root(re.text, im.text, re.radius_text, im.radius_text, root.multiplicity, root.symmetry.value)


def _float64(spec: Spec, indices: range) -> list[Result]:
    import numpy as np

    from mpsolve.batch.frequencies import frequencies
    from mpsolve.spectrum.regions import Below

    columns: dict[str, list[float]] = {name: [] for name in spec.names}
    for index in indices:
        for name, value in spec.values(index).items():
            columns[name].append(float(value))
    region = ("below", spec.region.height) if isinstance(spec.region, Below) else spec.region
    found = frequencies(spec.given, columns, region, roots=spec.roots or region != "unstable")
    q = found.roots if found.roots is not None else np.zeros((len(indices), 0), complex)
    results = []
    rows = zip(
        found.status.tolist(), found.reason.tolist(), found.count.tolist(), found.unstable.tolist(), q, strict=True
    )
    for status, reason, count, unstable, row in rows:
        roots = tuple(Root(x.real, x.imag) for x in row[np.isfinite(row)].tolist()) if spec.roots else ()
        known = count >= 0
        results.append(Result(status, reason, count if known else None, unstable if known else None, roots))
    return results


def checked(spec: Spec, block: Block, path: object) -> tuple[list[dict[str, Value]], list[Result]]:
    """The parameters and the results of a stored block; StudyError if it is damaged or is of other entries."""
    indices = spec.indices(block.number)
    values = [spec.values(index) for index in indices]
    if not block.whole or key(spec, values) != block.key:
        stated = f"holds damaged results of the entries {indices[0]} to {indices[-1]}"
        raise StudyError(f"{path} {stated}: run the study again on this file, which computes them anew")
    return values, list(block.results)
