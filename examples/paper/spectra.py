"""Conclusions (iv), (v), (vi) and Section 3: the induced frequencies of two equal masses with damping."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from mpsolve.certificate.format import Certificate
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import below, decimal, grid, last_on_grid, shown
from mpsolve.numbers.balls import precision

from .cases import DISTANCES, MASSES, ahead, ball, certificate, cuts, listed, pair, single, spectrum
from .derivation import dispersion
from .limits import critical_velocity_ratio, limiting_frequency
from .theory import symmetries

_DIGITS = 20


def cut_at_damping(claim: Claim) -> Finding:
    """Conclusion (iv): the cut lies on Im q = η_b."""
    if claim.number("level") != "η_b":
        return Finding(Verdict.REFUTED, "The cut lies on Im q = η_b.")
    p, q, alpha, eta_b, eta_N, eta_S = dispersion().arguments
    real = sp.symbols("p a b x y", real=True)
    D = (
        dispersion()
        .expression.subs({eta_N: eta_S})
        .subs(dict(zip((p, alpha, eta_b), real[:3], strict=True)) | {q: real[3] + sp.I * (real[4] + real[2])})
    )
    offset = sp.expand(sp.im(sp.expand(D))) - sp.expand(-8 * real[4] * (real[3] - real[0] * real[1]))
    square = sp.expand(sp.re(sp.expand(D)).subs(real[3], real[0] * real[1]))
    positive = sp.expand(square - (real[0] ** 4 + 4 * real[4] ** 2 + 4 - 4 * real[2] ** 2))
    gap = sp.expand(sp.re(sp.expand(D)).subs(real[4], 0) - (real[0] ** 4 + 4 - 4 * real[2] ** 2))
    gap = sp.expand(gap + 4 * (real[3] - real[0] * real[1]) ** 2)
    eta_b, eta_m, d = claim.numbers("eta_b", "eta_m", "d")
    numbers = []
    certificates: list[tuple[str, Certificate | None]] = []
    found = cuts(pair("0.95", eta_b, eta_m, d), "0.9", "0.99")
    for point in found.points:
        last = last_on_grid(point.value, Fraction(1, 100))
        certificates += [
            (f"{claim.id}_alpha{decimal(alpha)}", certificate(pair(decimal(alpha), eta_b, eta_m, d)))
            for alpha in (last, last + Fraction(1, 100))
        ]
        numbers.append(("cut point: α", shown(point.value, 12)))
        numbers.append(("there Re q", shown(point.q.real, 12)))
    steps = (
        "With q = x + i(η_b + y): Im D(p, q) = −8y(x − αp) and, at p = x/α, Re D = p⁴ + 4y² + 4 − 4η_b² "
        "[identities].",
        "In the gap Im q = η_b, |Re q| < q_lm there is no root: at y = 0 D = S² − 4(x − αp)² > 0 for all real p, "
        "with S² = p⁴ + 4 − 4η_b² [identity]; a root would have ∫D|ŵ|² dp/2π = 4(x + iη_b)² Σ η_M,j|w(x_j)|², whose "
        "imaginary part asks for x = 0, where the right side is negative. So a line at Im q = η_b is at the cut.",
        "For η_b < 1 and y ≠ 0 D has no real p-root, so K and Δ are analytic off the line Im q = η_b; on it they are "
        "where |Re q| < q_lm. A root can leave the sheet only at Im q = η_b, |Re q| ≥ q_lm.",
    )
    holds = sp.simplify(offset) == 0 and positive == 0 and gap == 0 and len(found.points) > 0
    if not holds:
        return Finding(Verdict.UNDECIDABLE, "Not confirmed.", numbers, steps)
    sentence = (
        "A line that reaches Im q = η_b is at the cut, |Re q| ≥ q_lm, and it can end nowhere else (theorem, any "
        "masses). The example's cut points are proved; certified are the spectra beside them. For η_b ≥ 1 the cut "
        "leaves that line."
    )
    return Finding(Verdict.PROVED, sentence, numbers, steps, certificates=certificates)


def order_with_damping(claim: Claim) -> Finding:
    """Conclusions (v), (vi) say 'always': the first damped case of the list that breaks the order of the lines."""
    for text in claim.values("cases"):
        eta_b, alpha, eta_m, d = text.split()
        case = pair(alpha, eta_b, eta_m, d)
        lines = ahead(case)
        (one,), (both,) = ahead(single(alpha, eta_b, eta_m)), ahead(single(alpha, eta_b, str(2 * int(eta_m))))
        lower, low, high = lines[0], *sorted((one, both), key=lambda z: float(z.real))
        out = lower.real < low.real or lower.real > high.real
        inside = len(lines) > 1 and lines[1].real > low.real and lines[1].real < high.real
        if (out and claim.number("which") == "lower") or (inside and claim.number("which") == "higher"):
            numbers = tuple(
                (f"q {name}", _complex(z))
                for name, z in (
                    ("doubled", both),
                    ("single", one),
                    *((f"pair {k}", z) for k, z in enumerate(lines, 1)),
                )
            )
            here = "below α_C" if case.alpha.ball() < critical_velocity_ratio(case) else "above α_C"
            what = (
                "lower line is not between those of the single and doubled mass" if out else "higher line is between"
            )
            sentence = f"With η_b = {eta_b}, α = {alpha} ({here}), η_M = {eta_m}, d = {d} the {what}."
            names = ((claim.id, case), (f"{claim.id}_single", single(alpha, eta_b, eta_m)),
                     (f"{claim.id}_doubled", single(alpha, eta_b, str(2 * int(eta_m)))))  # fmt: skip
            certificates = [(name, certificate(c)) for name, c in names]
            return Finding(Verdict.REFUTED, sentence, numbers, certificates=certificates)
    return Finding(Verdict.UNDECIDABLE, "No case of the list breaks the order, and there is no proof.")


def _complex(z: Any) -> str:
    sign = "−" if z.imag < 0 else "+"
    return f"{shown(z.real, 10)} {sign} {shown(abs(z.imag), 10)}i"


def pairs_with_damping(claim: Claim) -> Finding:
    """Conclusion (v) does not leave damping out: a subcritical case with another number of pairs."""
    numbers, certificates, wrong = [], [], []
    for where, name, case in listed(claim):
        if not case.alpha.ball() < critical_velocity_ratio(case):
            continue
        pairs = len(ahead(case))
        numbers.append((f"{where}: pairs", str(pairs)))
        if str(pairs) not in (claim.number("low"), claim.number("high")):
            at = where.replace(", η_M", f" < α_C = {shown(critical_velocity_ratio(case), 6)}, η_M")
            wrong.append(f"{pairs} pairs at {at}")
            certificates.append((name, certificate(case)))
    if wrong:
        return Finding(Verdict.REFUTED, "; ".join(wrong), numbers, certificates=certificates)
    return Finding(Verdict.UNDECIDABLE, "No case of the list has another number, and there is no proof.", numbers)


def most_pairs(claim: Claim) -> Finding:
    """Section 3: the largest number of pairs in the box."""
    limit, numbers, certificates, wrong = int(claim.number("pairs")), [], [], []
    for where, name, case in listed(claim):
        pairs = len(ahead(case))
        lone = len(spectrum(case).roots) - 2 * pairs
        above = sum(bool(q.imag > case.eta_b.ball()) for q in ahead(case))
        what = f"{where}: pairs (of these above the cut), imaginary roots"
        numbers.append((what, f"{pairs} ({above}), {lone}"))
        if pairs > limit:
            wrong.append(f"{pairs} pairs at {where}")
            certificates.append((name, certificate(case)))
    if wrong:
        sentence = f"{'; '.join(wrong)}: counted on the whole sheet, below and above the cut, as without damping."
        search = tuple(_most(claim, eta_b, limit) for eta_b in claim.values("searched"))
        return Finding(Verdict.REFUTED, sentence, numbers, search=search, certificates=certificates)
    return Finding(Verdict.UNDECIDABLE, f"No case of the list has more than {limit}.", numbers)


def _most(claim: Claim, eta_b: str, limit: int) -> str:
    """Whether the printed number comes out at this damping ratio: all (η_M, d) of the paper, certified."""
    alpha = claim.number("top")
    counts = {(m, d): len(ahead(pair(alpha, eta_b, m, d))) for m in MASSES for d in DISTANCES}
    most = max(counts.values())
    where = next(f"η_M = {m}, d = {d}" for (m, d), count in counts.items() if count == most)
    fits = "as printed" if most == limit else f"not {limit}"
    return f"η_b = {eta_b}, α = {alpha}: at most {most} pairs over the {len(counts)} (η_M, d) ({where}), {fits}"


def always_in_pairs(claim: Claim) -> Finding:
    """Section 3: a root that is its own partner −q̄."""
    eta_b, alpha, eta_m, d = claim.numbers("eta_b", "alpha", "eta_m", "d")
    case = pair(alpha, eta_b, eta_m, d)
    lone = [root.q for root in spectrum(case).roots if root.symmetry.value == "imaginary"]
    numbers = tuple((f"q_{k} (real part exactly 0)", f"{shown(q.imag, 12)}i") for k, q in enumerate(lone, 1))
    if not symmetries()["pair"]:
        return Finding(Verdict.UNDECIDABLE, "The symmetry of D was not confirmed.", numbers)
    if not lone:
        return Finding(Verdict.UNDECIDABLE, "With q, −q̄ is a root; no imaginary root in this case.", numbers)
    sentence = (
        "With q, −q̄ is a root [D(−p, −q̄) = conj D(p, q), identity]; but the two are one where Re q = 0, as for "
        f"{len(lone)} certified roots of this case: the condition is Re q ≠ 0."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=[(claim.id, certificate(case))])


def crosses_the_limit(claim: Claim) -> Finding:
    """Section 4.3: with damping the real part may cross q_lm: a case on either side."""
    eta_b, eta_m, d = claim.numbers("eta_b", "eta_m", "d")
    numbers, sides = [], []
    for alpha in claim.values("alpha"):
        case = pair(alpha, eta_b, eta_m, d)
        limit = limiting_frequency(case)
        line = ahead(case)[-1]
        numbers += [(f"α = {alpha}: Re q", shown(line.real, 12)), (f"α = {alpha}: q_lm", shown(limit, 12))]
        sides.append(True if line.real > limit else False if line.real < limit else None)
    certificates = [(f"{claim.id}_alpha{a}", certificate(pair(a, eta_b, eta_m, d))) for a in claim.values("alpha")]
    good = sides == [False, True]
    sentence = "Re q of the higher line is below q_lm at the first α and above it at the second, both certified."
    return Finding(Verdict.PROVED if good else Verdict.UNDECIDABLE, sentence, numbers, certificates=certificates)


def subcritical_velocity(claim: Claim) -> Finding:
    """Section 4.3 calls α = 0.99 subcritical for all η_b."""
    with precision(128):
        alpha = ball(claim.number("alpha"))
        limit = (1 - alpha**4).sqrt() if alpha < 1 else None
    if limit is None:
        return Finding(Verdict.REFUTED, "It is not below α_cr,ex = 1.")
    beyond = [b for b in grid(claim.number("eta_b")) if not below(ball(b), limit)]
    numbers = (
        ("α = α_C at η_b", shown(limit, 12)),
        ("values of η_b at which α > α_C", f"{len(beyond)} of {len(grid(claim.number('eta_b')))}"),
    )
    if not beyond:
        return Finding(Verdict.PROVED, "α < α_C = (1 − η_b²)^(1/4) for all of them.", numbers)
    sentence = (
        "Below α_cr,ex = 1 it is, for every η_b. But with damping the cuts join at α_C = (1 − η_b²)^(1/4), the limit "
        f"α_c of Section 3, and from η_b = {beyond[0]} on that lies below α."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers)


def finite_number(claim: Claim) -> Finding:
    """Section 3: the number of roots is finite: beyond an explicit radius there is none."""
    numbers: list[tuple[str, str]] = []
    certificates: list[tuple[str, Certificate | None]] = []
    for where, _, case in listed(claim):
        found = spectrum(case)
        numbers.append((f"{where}: roots", str(found.count)))
        numbers.append(("  none is left out by", found.closing))
        certificates.append((f"{claim.id}_{len(certificates)}", found.certificate))
    sentence = (
        "Beyond an explicit radius, part of each certificate, Δ has no root, since its highest power of η_M q²K "
        "dominates; on what is left of the sheet, closed by both sides of the cut, an analytic function has "
        f"finitely many: all are counted at these {len(certificates)} cases. For other parameters the radius is to "
        "be proved anew."
    )
    return Finding(Verdict.CONDITIONAL, sentence, numbers, certificates=certificates)
