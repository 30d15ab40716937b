"""Conclusions (i) and (iii): one or two equal masses without damping, above the critical velocity."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import product

from mpsolve.certificate.format import Certificate
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import shown
from mpsolve.errors import PrecisionError
from mpsolve.problem.case import Case
from mpsolve.problem.cases import as_problem

from .below import stays_below
from .cases import certificate, pair, single, spectrum
from .justabove import STEPS, unstable_up_to
from .theory import symmetries, undamped_roots_are_real

_STRIPS = ("1.1", "1.08", "1.04", "1.02", "1.01")  # where the strip above α_C may end, the widest first
_HALVINGS = 6
_CERTIFIED = "1.1"


def onset_at_critical(claim: Claim) -> Finding:
    """Conclusion (i) over the box: stable below α_C by the theorem, unstable all the way above it."""
    return _onset(claim, list(product(claim.values("eta_m"), claim.values("d"))))


def one_mass_onset_at_critical(claim: Claim) -> Finding:
    """The same for one mass, as Section 3 recalls."""
    return _onset(claim, [(eta_m, None) for eta_m in claim.values("eta_m")])


def _onset(claim: Claim, models: Sequence[tuple[str, str | None]]) -> Finding:
    proof, top = undamped_roots_are_real(), claim.number("alpha")
    stable: list[str] = []
    undecided: list[str] = []
    numbers = [("α_C = α_cr,ex without damping", "1")]
    certificates: list[tuple[str, Certificate | None]] = []
    for eta_m, d in models:
        name = f"η_M = {eta_m}" if d is None else f"η_M = {eta_m}, d = {d}"
        strip = next((end for end in _STRIPS if unstable_up_to(end, eta_m, d)), None)
        start = Fraction(strip or "1")
        for low, high in not_followed(eta_m, d, start, Fraction(top)):
            at = f"{name}, α from {float(low):.7g} to {float(high):.7g}"
            (stable if _is_stable(eta_m, d, (low + high) / 2) else undecided).append(at)
        how = f"up to {strip} by the count just above α_C; " if strip else ""
        numbers.append((f"{name}: unstable", f"{how}unstable roots followed over {float(start):.4g} to {top}"))
        if eta_m == models[0][0] or d in (None, "1"):
            certificates.append((f"{claim.id}_eta{eta_m}_d{d or 0}_alpha{_CERTIFIED}", _certified(eta_m, d)))
    steps = (*proof.steps, *STEPS)
    if stable:
        sentence = f"Stable above α_C: {'; '.join(stable)}."
        return Finding(Verdict.REFUTED, sentence, numbers, steps, certificates=certificates)
    if undecided or not proof.holds:
        sentence = f"Open above α_C: {'; '.join(undecided)}."
        return Finding(Verdict.UNDECIDABLE, sentence, numbers, steps, certificates=certificates)
    sentence = (
        "Below α_C every root is real, for any masses (theorem). Just above it there is exactly one root near the "
        f"branch point, an unstable one (proved for every α of a strip at once), and each of the {len(models)} cases "
        f"that are looked at is proved unstable from there to α = {top}; for other masses and distances the part "
        "above α_C is not proved."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, steps, certificates=certificates)


def _case(alpha: str, eta_m: str, d: str | None) -> Case:
    return single(alpha, "0", eta_m) if d is None else pair(alpha, "0", eta_m, d)


def _certified(eta_m: str, d: str | None) -> Certificate | None:
    return certificate(_case(_CERTIFIED, eta_m, d))


Range = tuple[Fraction, Fraction]


def _is_stable(eta_m: str, d: str | None, alpha: Fraction) -> bool:
    """Whether it is certified that no root is unstable there."""
    try:
        return spectrum(_case(str(alpha), eta_m, d)).unstable == 0
    except PrecisionError:
        return False


def not_followed(eta_m: str, d: str | None, low: Fraction, high: Fraction) -> list[Range]:
    """The parts of [low, high], halved so often, over which no unstable root is followed."""
    pending, broken = [(low, high, 0)], []
    while pending:
        start, end, depth = pending.pop()
        if _followed(eta_m, d, start, end):
            continue
        if depth == _HALVINGS:
            broken.append((start, end))
            continue
        middle = (start + end) / 2
        pending += [(start, middle, depth + 1), (middle, end, depth + 1)]
    return sorted(broken)


def _followed(eta_m: str, d: str | None, start: Fraction, end: Fraction) -> bool:
    """Whether a certified unstable root at `start` is proved to go on below the real axis up to `end`."""
    case = _case(str(start), eta_m, d)
    try:
        found = spectrum(case)
    except PrecisionError:
        return False
    roots = [r.q for r in found.roots if r.q.imag < 0 and not r.q.real < 0 and r.multiplicity == 1]
    return any(stays_below(as_problem(case), {"v": (start, end)}, q) for q in roots)


def four_signs(claim: Claim) -> Finding:
    """Conclusion (iii): both symmetries, and whether a root is on an axis, where only two signs are left."""
    known, numbers, wrong, count = symmetries(), [], [], 0
    certificates: list[tuple[str, Certificate | None]] = []
    for alpha in claim.values("alpha"):
        for eta_m in claim.values("eta_m"):
            for d in claim.values("d"):
                case = pair(alpha, "0", eta_m, d)
                lone = [root.q.imag for root in spectrum(case).roots if root.symmetry.value == "imaginary"]
                count += 1
                if lone:
                    wrong.append(f"α = {alpha}, η_M = {eta_m}, d = {d}")
                    numbers += [(f"{wrong[-1]}: q (real part exactly 0)", f"{shown(y, 12)}i") for y in lone]
                    certificates.append((f"{claim.id}_alpha{alpha}_eta{eta_m}_d{d}", certificate(case)))
    numbers.append(("certified cases", str(count)))
    if wrong:
        sentence = (
            f"At {'; '.join(wrong)} there are purely imaginary frequencies: with q only −q, two signs, not four. "
            "(Off the axes it holds: D(−p, −q̄) = conj D(p, q), and without damping D(p, q̄) = conj D(p, q).)"
        )
        return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)
    if not all(known.values()):
        return Finding(Verdict.UNDECIDABLE, "A symmetry of D was not confirmed.")
    sentence = (
        "D(−p, −q̄) = conj D(p, q) and, without damping, D(p, q̄) = conj D(p, q): with q, also −q̄, q̄ and −q are "
        "roots, four provided that q is not on an axis. Real it cannot be, since the cut covers the real axis; that "
        f"none is imaginary is certified at {count} cases."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers)
