"""Equations (40) to (55): the finite beam by vibration modes, derived from (8) and by elimination of λ.

Two modes stand for any number: each entry has one pair of indices. u_k, u1_k, u2_k are w_k, w_k,x, w_k,xx at the rear
mass, v_k, v1_k, v2_k the same at the front mass.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.parsing.sympy_parser import parse_expr

from mpsolve.claims import Claim, Finding, Verdict

from .equations import vanishes

_ORDER = (1, 2)
_FORCE = "P_C P_A omega_f phi_f"
_NAMES = {name: sp.Symbol(name) for name in ["M_1", "M_2", "v", "c_b", "m", "q", "w", "L"]}
_NAMES |= {f"{name}{n}": sp.Symbol(f"{name}{n}", real=True) for n in (1, 2) for name in _FORCE.split()}
_NAMES["t"] = sp.Symbol("t", real=True)
_NAMES |= {f"{shape}_{k}": sp.Symbol(f"{shape}_{k}") for shape in ("u", "u1", "u2", "v", "v1", "v2") for k in _ORDER}
_NAMES |= {f"omega_{k}": sp.Symbol(f"omega_{k}") for k in _ORDER}
_Q = [[sp.Symbol(f"q{order}_{k}") for k in _ORDER] for order in range(3)]  # q, q_,t, q_,tt
_LAMBDA = sp.symbols("L_1 L_2")  # λ_,tt


def entry(text: str, j: int, k: int) -> Any:
    """An entry with the indices j, k, delta(j, k) included."""
    filled = text.replace("_j", f"_{j}").replace("_k", f"_{k}").replace("delta", str(int(j == k)))
    return parse_expr(filled, local_dict=_NAMES)


def _acceleration(shape: str) -> Any:
    """(4), (6) with w = Σ q_k w_k, at the mass whose mode shapes are `shape`."""
    v, total = _NAMES["v"], sp.S(0)
    for k in _ORDER:
        here, slope, curve = (_NAMES[f"{shape}{order}_{k}"] for order in ("", "1", "2"))
        total += here * _Q[2][k - 1] + 2 * v * slope * _Q[1][k - 1] + v**2 * curve * _Q[0][k - 1]
    return total


def force(n: int) -> Any:
    """The real part of the force of (2) on mass n: the finite beam is real."""
    constant, size, frequency, phase = (_NAMES[f"{name}{n}"] for name in _FORCE.split())
    turned = frequency * _NAMES["t"] + phase + 3 * sp.pi / 2
    return constant + size * sp.re(sp.exp(sp.I * turned)).rewrite(sp.cos).doit()


def _projected(j: int) -> Any:
    """(8) times w_j, integrated over the beam: modes orthonormal in m, ω_j with axial force and Pasternak modulus."""
    beam = _Q[2][j - 1] + _NAMES["c_b"] / _NAMES["m"] * _Q[1][j - 1] + _NAMES[f"omega_{j}"] ** 2 * _Q[0][j - 1]
    loads = sum(
        _NAMES[f"{shape}_{j}"] * (force(n) - _NAMES[f"M_{n}"] * _acceleration(shape))
        for n, shape in ((1, "u"), (2, "v"))
    )
    return beam - loads


def expansion(claim: Claim) -> Finding:
    """(40): the term of one mode, for the modes of a simply supported beam, the sines."""
    x, length, m = sp.Symbol("x", positive=True), sp.Symbol("L", positive=True), sp.Symbol("m", positive=True)
    shapes = [sp.sqrt(2 / (m * length)) * sp.sin(k * sp.pi * x / length) for k in _ORDER]
    coordinates = _Q[0]
    terms = [
        entry(claim.number("form"), k, k).subs({_NAMES["q"]: coordinates[k - 1], _NAMES["w"]: shapes[k - 1]})
        for k in _ORDER
    ]
    total = sum(terms)
    back = [sp.integrate(m * sp.expand(total * shape), (x, 0, length)) for shape in shapes]
    ends = [total.diff(x, n).subs(x, at) for n in (0, 2) for at in (0, length)]
    if all(sp.simplify(y - q) == 0 for y, q in zip(back, coordinates, strict=True)) and not any(
        map(sp.simplify, ends)
    ):
        sentence = (
            "w_j = √(2/(mL)) sin(jπx/L) are orthonormal in m, and vanish with their curvature at both ends: the "
            "sum has the coordinates q_j and meets the boundary conditions (identities); it is the Fourier sine "
            "series, which is complete."
        )
        return Finding(Verdict.PROVED, sentence)
    return Finding(
        Verdict.REFUTED, "The coordinates of this sum are not q_j, or it does not meet the boundary conditions."
    )


def entries(claim: Claim) -> Finding:
    """(42)-(45): coefficient by coefficient against the projection of (8)."""
    wrong = []
    for name, texts in claim.printed.items():
        order = {"M": 2, "C": 1, "K": 0}.get(name)
        for j in _ORDER:
            projected = sp.expand(_projected(j))
            if order is None:
                forces = -projected.subs({q: 0 for row in _Q for q in row})
                good = vanishes(forces - entry(texts[0], j, j))
            else:
                good = all(vanishes(projected.coeff(_Q[order][k - 1]) - entry(texts[0], j, k)) for k in _ORDER)
            if not good:
                wrong.append(f"{name}, row {j}")
    if wrong:
        return Finding(Verdict.REFUTED, f"Not what the projection of (8) gives: {', '.join(wrong)}.")
    return Finding(Verdict.PROVED, "Projection of (8) on w_j with (4), (6): each coefficient is the printed one.")


def rearranged(claim: Claim) -> Finding:
    """(46)-(53): eliminating λ_,tt from the enlarged system gives (41) back."""
    blocks = claim.printed
    rows = [_enlarged_row(blocks, j) for j in _ORDER]
    solved = {}
    for n in (1, 2):
        bottom = sum(entry(blocks[f"{part}{n}"][0], 1, k) * _Q[order][k - 1]
                     for part, order in (("M", 2), ("C", 1), ("K", 0)) for k in _ORDER)  # fmt: skip
        solved[_LAMBDA[n - 1]] = entry(blocks[f"force{n}"][0], 1, 1) - bottom
    if all(vanishes(row.subs(solved) - _projected(j)) for row, j in zip(rows, _ORDER, strict=True)):
        return Finding(Verdict.PROVED, "Eliminating λ_1,tt and λ_2,tt gives (41) with (42)-(45): exact identity.")
    return Finding(Verdict.REFUTED, "Eliminating λ_,tt does not give (41).")


def _enlarged_row(blocks: Any, j: int) -> Any:
    total = sum(entry(blocks[f"diagonal_{part}"][0], j, k) * _Q[order][k - 1]
                for part, order in (("M", 2), ("C", 1), ("K", 0)) for k in _ORDER)  # fmt: skip
    total -= entry(blocks["force"][0], j, j)
    return total + sum(entry(blocks[f"column{n}"][0], j, j) * _LAMBDA[n - 1] for n in (1, 2))


def contact_force(claim: Claim) -> Finding:
    """(54), (55): λ_,tt is the contact force P − M w_0,tt."""
    n = int(claim.number("mass"))
    expected = force(n) - _NAMES[f"M_{n}"] * _acceleration("uv"[n - 1])

    def right(text: str) -> bool:
        total = entry(claim.number("load"), 1, 1)
        for k in _ORDER:
            names = {f"q{order}": _Q[order][k - 1] for order in range(3)}
            filled = text.replace("_k", f"_{k}")
            total = total - parse_expr(
                filled, local_dict=_NAMES | {f"{s}3_{k}": sp.Symbol(f"{s}3_{k}") for s in "uv"} | names
            )
        return vanishes(total - expected)

    if right(claim.number("form")):
        return Finding(Verdict.PROVED, "The contact force by (4), (6) and (40): exact identity.")
    if "corrected" in claim.at and right(claim.number("corrected")):
        sentence = "The derivatives are one order too high: w_k,xx, w_k,xxx stand for w_k,x, w_k,xx, as in (54)."
        return Finding(Verdict.SLIP, sentence, (("corrected", claim.number("corrected")),))
    return Finding(Verdict.REFUTED, "Not the contact force by (4), (6) and (40).")


_LOAD = "P_C{n} + P_A{n}*sin(omega_f{n}*t + phi_f{n})"
_CONTACT = "M_{n}*{s}_k*q2 + 2*M_{n}*v*{s}{a}_k*q1 + M_{n}*v**2*{s}{b}_k*q0"
_SECTION = "Section 4.1"
MATRICES = {
    "M": ("delta + M_1*u_j*u_k + M_2*v_j*v_k",),
    "C": ("delta*c_b/m + 2*M_1*v*u_j*u1_k + 2*M_2*v*v_j*v1_k",),
    "K": ("delta*omega_j**2 + M_1*v**2*u_j*u2_k + M_2*v**2*v_j*v2_k",),
}  # (42)-(44) as printed

CLAIMS = (
    Claim("eq-40", _SECTION, "Eq. (40): w is the sum over j of {form}.", expansion, {"form": ("q*w",)}),
    Claim("eq-42-45", _SECTION, "Eqs. (41)-(45): M_jk = {M}, C_jk = {C}, K_jk = {K}, p_j = {p}", entries, {
        **MATRICES, "p": (f"({_LOAD.format(n=1)})*u_j + ({_LOAD.format(n=2)})*v_j",),
    }),
    Claim("eq-46-53", _SECTION, "Eqs. (46)-(53): diagonal blocks {diagonal_M}, {diagonal_C}, {diagonal_K}, columns "
    "{column1}, {column2}, rows {M1}, {C1}, {K1} and {M2}, {C2}, {K2}, right side {force}; {force1}; {force2}",
    rearranged, {
        "diagonal_M": ("delta",), "diagonal_C": ("delta*c_b/m",), "diagonal_K": ("delta*omega_j**2",),
        "column1": ("-u_j",), "column2": ("-v_j",),
        "M1": ("M_1*u_k",), "C1": ("2*M_1*v*u1_k",), "K1": ("M_1*v**2*u2_k",),
        "M2": ("M_2*v_k",), "C2": ("2*M_2*v*v1_k",), "K2": ("M_2*v**2*v2_k",),
        "force": ("0",), "force1": (_LOAD.format(n=1),), "force2": (_LOAD.format(n=2),),
    }),
    Claim("eq-54", _SECTION, "Eq. (54): λ_1,tt = {load} − Σ_k ({form})", contact_force,
          {"form": (_CONTACT.format(n=1, s="u", a="1", b="2"),), "load": (_LOAD.format(n=1),)}, {"mass": ("1",)}),
    Claim("eq-55", _SECTION, "Eq. (55): λ_2,tt = {load} − Σ_k ({form})", contact_force,
          {"form": (_CONTACT.format(n=2, s="v", a="2", b="3"),), "load": (_LOAD.format(n=2),)},
          {"mass": ("2",), "corrected": (_CONTACT.format(n=2, s="v", a="1", b="2"),)}),
)  # fmt: skip
