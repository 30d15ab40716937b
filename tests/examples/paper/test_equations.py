"""Equations as printed: right ones are proved, slips are told, and a changed coefficient changes the verdict."""

from __future__ import annotations

from dataclasses import replace

import pytest

from mpsolve.claims import Claim, Verdict
from paper import captions, equation_list, figure_list, modal
from paper.equations import read, vanishes

EQUATIONS = {claim.id: claim for claim in (*equation_list.CLAIMS, *modal.CLAIMS)}
SYMBOLIC = {name: claim for name, claim in EQUATIONS.items() if claim.printed and name not in ("eq-31", "eq-36")}
CHANGES = {  # one number, sign or name of the printed form
    "eq-1": ("m*d(", "2*m*d("), "eq-3-5": ("v*d(", "-v*d("),
    "eq-4-6": ("2*v", "v"), "eq-10": ("2*k", "3*k"),
    "eq-12": ("M_2*chi/m", "M_2/m"), "eq-13": ("8*alpha", "4*alpha"), "eq-14": ("-qbar", "-2*qbar"),
    "eq-15": ("- 4*q**2", "+ 4*q**2"), "eq-16-19": ("/(2*pi)", "/pi"), "eq-18": ("8*I", "4*I"),
    "eq-20": ("/pi", "/2"), "eq-21": ("I*p", "-I*p"), "eq-22": ("4*eta_C1", "8*eta_C1"),
    "eq-23-24": ("2*eta", "4*eta"),
    "eq-25": ("-x_2", "x_2"), "eq-26": ("- 4*", "+ 4*"), "eq-26-one-place": ("+", "-"), "eq-27-28": ("+ 2*", "- 2*"),
    "eq-29": ("F_1(q)*pi", "F_2(q)*pi"), "eq-30": ("4*eta_C", "2*eta_C"), "eq-32": ("2*pi", "pi"),
    "eq-33": ("20", "10"),
    "eq-34": ("20", "10"), "eq-38": ("-d(", "d("), "eq-42-45": ("2*M_1", "M_1"), "eq-46-53": ("-u_j", "u_j"),
    "eq-54": ("2*M_1", "M_1"),
    "eq-31-inversion": ("2*pi", "pi"), "eq-40": ("q*w", "q*w/2"),
}  # fmt: skip


def changed(claim: Claim, old: str, new: str) -> Claim:
    """The claim with one printed text altered, the first that has `old`."""
    printed = {name: list(texts) for name, texts in claim.printed.items()}
    for texts in printed.values():
        for k, text in enumerate(texts):
            if old in text:
                texts[k] = text.replace(old, new, 1)
                return replace(claim, printed={name: tuple(kept) for name, kept in printed.items()})
    raise AssertionError(f"{claim.id} has no {old}")


@pytest.mark.parametrize("name", CHANGES)
def test_a_right_equation_is_proved_and_a_changed_one_refuted(name: str) -> None:
    claim = EQUATIONS[name]
    assert claim.check(claim).verdict is Verdict.PROVED
    altered = changed(claim, *CHANGES[name])
    assert altered.check(altered).verdict is Verdict.REFUTED


@pytest.mark.parametrize("name", sorted(SYMBOLIC.keys() - CHANGES.keys()))
def test_a_slip_is_cured_by_its_correction_only(name: str) -> None:
    """As printed: a slip. The correction as printed: proved. A corrected form that is wrong too: refuted."""
    claim = EQUATIONS[name]
    assert claim.check(claim).verdict is Verdict.SLIP
    right = replace(claim, printed={**claim.printed, "form": claim.at["corrected"]})
    assert right.check(right).verdict is Verdict.PROVED
    wrong = replace(claim, at={**claim.at, "corrected": claim.printed["form"]})
    assert wrong.check(wrong).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("eq-42-45", "P_A1*sin", "P_A1*cos"),
        ("eq-46-53", "sin(omega_f2", "sin(omega_f1"),
        ("eq-46-53", "P_C1", "P_C2"),
        ("eq-54", "P_C1 +", "P_C1 -"),
        ("eq-10", "omega_f1/(chi", "omega_f1*(chi"),
        ("eq-31-inversion", "a - I*T", "a + I*T"),
    ],
)
def test_the_forces_are_tried_as_printed(name: str, old: str, new: str) -> None:
    altered = changed(EQUATIONS[name], old, new)
    assert altered.check(altered).verdict is Verdict.REFUTED


def test_singularities_and_the_harmonic_sum() -> None:
    side, whole = EQUATIONS["eq-31"], EQUATIONS["eq-36"]
    assert side.check(side).verdict is Verdict.SLIP
    left = replace(side, printed={"side": ("left",)})
    assert left.check(left).verdict is Verdict.PROVED
    assert whole.check(whole).verdict is Verdict.SLIP
    wrong = changed(whole, "4*eta_C/pi", "2*eta_C/pi")
    wrong = replace(wrong, at={**whole.at, "corrected": wrong.printed["form"]})
    assert wrong.check(wrong).verdict is Verdict.REFUTED


def test_texts_are_read_exactly() -> None:
    assert vanishes(read("K(0,q) = K(0,q)"))
    assert not vanishes(read("K(0,q) = K(x_2,q)"))


CAPTIONS = {claim.id: claim for claim in (*captions.CLAIMS, *figure_list.CLAIMS)}


@pytest.mark.parametrize(
    ("name", "printed", "before", "after"),
    [
        ("fig-12", {"caption": ("1:0.25:2",)}, Verdict.SLIP, Verdict.PROVED),
        ("fig-9b", {"caption": ("1:1:4",)}, Verdict.PROVED, Verdict.SLIP),
        ("fig-3-list", {"caption": ("0.5", "0.8")}, Verdict.PROVED, Verdict.SLIP),
        ("fig-A.1-list", {"text": ("0.5:0.5:4",)}, Verdict.PROVED, Verdict.SLIP),
        ("4.1-velocity", {"caption": ("0.344",)}, Verdict.SLIP, Verdict.PROVED),
        ("fig-10b", {"values": ("0.05", "0.1", "0.2", "0.5")}, Verdict.SLIP, Verdict.PROVED),
        ("fig-2", {"panels": ("a", "b", "c", "d", "e")}, Verdict.SLIP, Verdict.PROVED),
        ("4.1-distances", {"distance": ("0.445", "4.45")}, Verdict.SLIP, Verdict.PROVED),
        ("4.1-reference", {"section": ("4.3",)}, Verdict.SLIP, Verdict.PROVED),
        ("3-static", {"factor": ("1/4",)}, Verdict.PROVED, Verdict.REFUTED),
        ("3-v_cr", {"factor": ("2",)}, Verdict.PROVED, Verdict.REFUTED),
        ("2-sine", {"shift": ("pi/2",)}, Verdict.PROVED, Verdict.REFUTED),
        ("3-alpha_C", {"eta_b": ("0.3",)}, Verdict.PROVED, Verdict.REFUTED),
    ],
)
def test_a_caption_or_a_definition(name: str, printed: dict, before: Verdict, after: Verdict) -> None:
    claim = CAPTIONS[name]
    assert claim.check(claim).verdict is before
    altered = replace(claim, printed={**claim.printed, **printed})
    assert altered.check(altered).verdict is after
