"""The report for people: verdict first, every digit, exactly what is proved, no control codes."""

from __future__ import annotations

from pathlib import Path

import pytest
from flint import acb, arb

from mpsolve import Case, PhysicalCase, Rectangle, Status, read_case
from mpsolve.certificate.sheet import SheetSpectrum as Spectrum
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.numbers.exact import Exact
from mpsolve.numbers.rootball import RootBall
from mpsolve.report.layout import WIDTH
from mpsolve.report.rows import beam_rows, shown
from mpsolve.report.statement import proved, verdict
from mpsolve.report.text import render

EXAMPLES = Path(__file__).parents[2] / "examples"
UNSTABLE = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
UNDAMPED = Case(alpha="0.5", eta_b=0, eta_m=(20, 30), positions=(0, 1))


def test_a_physical_case() -> None:
    case = read_case(EXAMPLES / "rail_60e1.toml")
    assert isinstance(case, PhysicalCase)
    text = render(certify(case), case, "A title", "a b.json")
    lines = text.splitlines()
    assert lines[0] == "A title"
    assert lines[2].startswith("STABLE")
    assert max(map(len, lines)) <= WIDTH
    for part in ("6400000 N m²", "≈ 290.39181 m/s", "≈ 0.34436233", "[Hz]", "[1/s]", "[s]", "2.9392660"):
        assert part in text
    assert "±0.14305214747605116538084978921" in text
    assert "exactly 4 zeros, counted with multiplicity, on the whole physical" in text
    assert "mpsolve verify 'a b.json'" in text
    assert "\x1b" not in text


def test_an_unstable_case() -> None:
    text = render(certify(UNSTABLE))
    assert text.startswith("UNSTABLE: 2 induced frequencies")
    assert "GROWS" in text
    assert "[1/τ]" in text
    assert "Certificate" not in text


def test_the_undamped_stable_case_says_what_that_means() -> None:
    text = render(certify(UNDAMPED))
    assert text.startswith("STABLE: no root with Im q < 0; the undamped vibration neither grows nor decays.")
    assert "proved to be real" in " ".join(text.split())


def test_a_thousand_digits_are_all_there() -> None:
    spectrum = certify(UNSTABLE, digits=1000)
    text = "".join(render(spectrum).split())
    wanted = certify(UNSTABLE, digits=1100).roots[-1].q.real.str(1010, radius=False)
    assert wanted[:1000] in text


def test_unstable_region_without_roots() -> None:
    spectrum = certify(UNDAMPED, region="unstable")
    assert proved(spectrum) == ("Δ(q), eq. (26), has no zero in the unstable half-plane Im q < 0.",)


def test_joined_cuts_are_named() -> None:
    spectrum = certify(Case(alpha="1.5", eta_b="0.1", eta_m=20))
    assert "the joined cuts, the line Im q = η_b" in proved(spectrum)[0]


def test_a_rectangle_decides_nothing_beyond_itself() -> None:
    box = Rectangle("0.01", "0.14", "-0.1", "0.01")
    assert verdict(certify(UNSTABLE, region=box)).startswith("NO GROWTH in this rectangle")
    wider = Rectangle("0.01", "0.2", "-0.1", "0.01")
    assert verdict(certify(UNSTABLE, region=wider)).startswith("UNSTABLE: one induced frequency ")


def test_undecided_comes_with_reason_and_claims_nothing() -> None:
    spectrum = certify(Case(alpha=1, eta_b=0, eta_m=20))
    text = " ".join(render(spectrum).split())
    assert text.startswith("UNDECIDED: alpha equals alpha_C")
    assert "change alpha" in text
    assert "Nothing yet." in text


@pytest.mark.parametrize(("region", "said"), [("sheet", True), ("unstable", False)])
def test_the_count_of_an_undecided_region(region: str, said: bool) -> None:
    spectrum = Spectrum(UNSTABLE, region, 30, Status.UNDECIDED, "why", 4, None, (), 128.0)  # type: ignore[arg-type]
    assert bool(proved(spectrum)) is said


def test_a_cluster_says_how_many_roots_it_holds() -> None:
    cluster = RootBall(acb(arb(0.25, 1e-20), arb(0.5, 1e-20)), -66, 2)
    spectrum = Spectrum(UNSTABLE, "sheet", 15, Status.PROVED, "", 4, 0, (cluster.mirrored, cluster))
    text = render(spectrum)
    assert "decays, halves (2 roots)" in text
    assert "as many zeros as its line says" in " ".join(text.split())


@pytest.mark.parametrize(
    ("value", "text"), [("0.67", "0.67"), ("1/3", "≈ 0.33333333"), ("root4(1/4)", "≈ 0.70710678"), (70, "70")]
)
def test_exact_numbers_are_told_from_rounded_ones(value: str | int, text: str) -> None:
    assert shown(Exact(value)) == text


def test_a_value_is_shown_as_it_is_typed() -> None:
    typed = "0.666918957284545"
    assert shown(Exact.parse(typed)) == typed
    assert shown(Exact.parse("1/3")) == "≈ 0.33333333"
    assert shown(Exact.parse("9806.650")) == "9806.65"


def test_the_critical_velocity_with_axial_force_and_pasternak_layer() -> None:
    beam = {"EI": "6.4e6", "m": 60, "k": "1e6", "v": 100, "masses": [(1000, 0)]}
    plain = {name: value for name, value, _ in beam_rows(PhysicalCase(**beam))}
    assert "v_cr′" not in plain
    rows = {name: value for name, value, _ in beam_rows(PhysicalCase(**beam, N=100000, kp=200000))}
    v_cr = (1e6 / 60) ** 0.5 / (1e6 / 4 / 6.4e6) ** 0.25
    expected = v_cr * (1 + 1e5 / (2 * (1e6 * 6.4e6) ** 0.5)) ** 0.5
    assert float(rows["v_cr′"].split()[1]) == pytest.approx(expected, rel=1e-7)


def test_equation_26_is_named_for_two_masses_only() -> None:
    assert "eq. (26)," in proved(certify(UNDAMPED, region="unstable"))[0]
    assert "(26) for two masses" in proved(certify(Case(alpha="0.5", eta_b="0.1", eta_m=5), region="unstable"))[0]
