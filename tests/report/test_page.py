"""The page: its margins against single cases, its numbers, its structure, and what it says where a part is open."""

from __future__ import annotations

import base64
import json
import re
from dataclasses import replace
from fractions import Fraction
from html.parser import HTMLParser
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from mpsolve import Case, PhysicalCase, verify
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.cli import cli
from mpsolve.fields import ball_arithmetic
from mpsolve.model.load import Load
from mpsolve.model.parameters import Mass
from mpsolve.numbers.exact import Exact
from mpsolve.report import page_parts
from mpsolve.report.answer import Source
from mpsolve.report.data import as_data
from mpsolve.report.html_environment import with_subscripts
from mpsolve.report.page import report_page
from mpsolve.report.page_loads import load_rows
from mpsolve.report.page_margins import Margin, _free, distance_margin, mass_margin, velocity_margin
from mpsolve.report.page_parts import Part, Parts, gather, loads_for, times
from mpsolve.report.page_words import card, margin_data
from mpsolve.report.remedies import ADVICE, for_reader
from mpsolve.stability.chart import case_chart

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
# one mass, much damping: quick to decide
PHYSICAL = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=300, c=9000, masses=[(1000, 0)])
VOID_TAGS = {"meta", "link", "br", "img", "hr", "input"}


class Page(HTMLParser):
    """The elements of a page in order, and the text of each."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str]]] = []
        self.open: list[tuple[str, int]] = []
        self.texts: dict[int, str] = {}
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID_TAGS:
            self.open.append((tag, len(self.elements) - 1))

    def handle_startendtag(self, tag: str, attrs: Any) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop()[0] == tag

    def handle_data(self, data: str) -> None:
        for _, k in self.open:
            self.texts[k] = self.texts.get(k, "") + data

    def all(self, tag: str) -> list[tuple[dict[str, str], str]]:
        return [(attrs, self.texts.get(k, "")) for k, (name, attrs) in enumerate(self.elements) if name == tag]

    def under(self, name: str) -> str:
        """The text of the element with this id."""
        (k,) = [k for k, (_, attrs) in enumerate(self.elements) if attrs.get("id") == name]
        return " ".join(self.texts[k].split())


@pytest.fixture(scope="module")
def parts() -> Parts:
    source = Source(PHYSICAL.dimensionless, PHYSICAL, "One mass <fast> & heavy")
    return gather(source, 20, None, None, 4, (Fraction(1, 2), Fraction(1)))


@pytest.fixture(scope="module")
def text(parts: Parts) -> str:
    return report_page(parts, "one mass")


@pytest.fixture(scope="module")
def page(text: str) -> Page:
    return Page(text)


def unstable(case: Case, **changes: Any) -> bool:
    """Whether a root has Im q < 0, by a count of its own."""
    values = {name: getattr(case, name) for name in ("alpha", "eta_b", "eta_m", "positions", "eta_n", "eta_s")}
    spectrum = certify(Case(**(values | changes)), region="unstable")
    assert spectrum.stable is not None
    return not spectrum.stable


def near(ball: Any, share: str) -> Exact:
    """A decimal that differs from the ball by this share of it."""
    return Exact.parse(Fraction(float(ball)).limit_denominator(10**9) * (1 + Fraction(share)))


def test_the_velocity_margin_is_where_single_cases_change() -> None:
    found = velocity_margin(CASE)
    assert found.proved
    assert found.below is not None
    assert unstable(CASE)
    assert found.above is None
    assert (unstable(CASE, alpha=near(found.below, "-1e-6")), unstable(CASE, alpha=near(found.below, "1e-6"))) == (
        False,
        True,
    )
    assert abs(float(found.below) - 0.67) < 0.005  # Section 4.2 of the paper


def test_the_mass_margin_is_where_single_cases_change() -> None:
    found = mass_margin(CASE)
    assert found.proved
    assert found.below is not None
    assert found.above is None
    for share, expected in (("-1e-6", False), ("1e-6", True)):
        factor = near(found.below, share)
        assert unstable(CASE, eta_m=[ratio * factor for ratio in CASE.eta_m]) is expected


def test_the_distance_margin_is_where_single_cases_change() -> None:
    found = distance_margin(CASE)
    assert found.proved
    for end, inward in ((found.below, 1), (found.above, -1)):
        for sign in (1, -1):
            d = near(end, f"{sign * inward}/1000000")
            assert unstable(CASE, positions=(0, d)) is (sign > 0)
    assert found.nearest is found.below  # 1.493 is nearer to 1.5 than 1.941


def test_margins_that_do_not_apply() -> None:
    lone = distance_margin(Case(alpha="0.5", eta_b="0.05", eta_m=10))
    uneven = distance_margin(Case(alpha="0.5", eta_b="0.05", eta_m=(1, 1, 1), positions=(0, 1, 3)))
    for found, said in ((lone, "there is one mass"), (uneven, "not equally spaced")):
        assert not found.applies
        shown = card(found, Source(CASE, None, ""), True)
        assert (shown.status, said in shown.sentence) == ("none", True)


def test_without_damping_and_below_the_critical_velocity_energy_decides() -> None:
    case = Case(alpha="0.5", eta_b=0, eta_m=(40, 40), positions=(0, 1))
    for found in (mass_margin(case), distance_margin(case)):
        assert (found.proved, found.nearest, found.high) == (True, None, None)
    fast = replace(case, alpha=Exact.parse("1.1"))
    for found in (mass_margin(fast), distance_margin(fast)):
        assert (found.proved, found.applies) == (False, True)
        assert "damping" in card(found, Source(fast, None, ""), None).sentence


@pytest.mark.parametrize(("alpha", "grows"), [("0.5", False), ("1.3", True)])
def test_a_margin_that_is_open_says_how_far_stability_is_proved_all_the_same(alpha: str, grows: bool) -> None:
    """Without damping, what happens just above α_C = 1 is open for this mass; single cases agree on both sides."""
    case = Case(alpha=alpha, eta_b=0, eta_m=10)
    found = velocity_margin(case)
    assert not found.proved
    assert found.free is not None
    assert found.at_least is not None
    low, high = map(float, found.free)
    assert (low, found.high) == (0, Exact.parse("1.4")) if not grows else high == float(found.high or 0)
    assert float(found.at_least) == pytest.approx(float(alpha) - low if grows else 1 - float(alpha))
    for place in (low + 0.01, high - 0.01):
        assert unstable(case, alpha=Exact.parse(f"{place:.3f}")) is grows
    shown = card(found, Source(case, None, ""), not grows)
    assert (shown.status, shown.figure[:9]) == ("undecided", "at least ")
    assert f"stays {'unstable' if grows else 'stable'} from α" in shown.sentence
    with ball_arithmetic(160):
        said = margin_data(found, Source(case, None, ""))["at_least"]
    assert said is not None
    assert float(said["parameter"]["value"]) == pytest.approx(float(found.at_least))


def test_a_margin_may_prove_stability_where_the_roots_are_undecided() -> None:
    """Below α_C and without damping the energy decides, however near α_C is; above it, only what is proved counts."""
    for alpha, expected in (("0.99999", True), ("1", None)):
        case = Case(alpha=alpha, eta_b=0, eta_m=70)
        spectrum = certify(case)
        margins = (velocity_margin(case), mass_margin(case), distance_margin(case))
        none: Part[Any] = Part(None, "left out")
        found = Parts(Source(case, None, ""), spectrum, margins, none, none, none, (), "")
        assert not spectrum.proved
        assert (margins[0].stable, margins[1].stable, found.stable) == (expected,) * 3
        assert found.verdict.startswith("STABLE: " if expected else "UNDECIDED: ")
        page = Page(report_page(found, "x"))
        assert ("The verdict: No root has Im q < 0" in page.under("proof")) is (expected is True)
        assert json.loads(page.under("data"))["stable"] is expected
        assert ("The case stays stable for every size" in page.under("verdict")) is (expected is True)
        assert not found.proved


@pytest.mark.parametrize(("alpha", "grows"), [("0.66", False), ("0.67", True)])
def test_what_the_margins_say_of_the_case_is_what_a_count_says(alpha: str, grows: bool) -> None:
    case = replace(CASE, alpha=Exact.parse(alpha))
    assert unstable(case) is grows
    assert {margin(case).stable for margin in (velocity_margin, mass_margin, distance_margin)} == {not grows}


def test_what_helps_can_be_done_on_the_command_line() -> None:
    """No remedy for library users is left, and every command and option that is named exists."""
    for part, said in ADVICE.items():
        assert for_reader("why: prove it in parts, over shorter ranges", part) == f"why: {said}"
        assert for_reader("two masses: lower the velocity", part) == "two masses: lower the velocity"
        for words in re.findall(r"mpsolve ([a-z-]+)((?: FILE)?(?: --[a-z]+(?:[ =][A-Z0-9][A-Z0-9_,]*)?)*)", said):
            known = {name for one in cli.commands[words[0]].params for name in one.opts}
            assert set(re.findall(r"--[a-z]+", words[1])) <= known


def test_what_is_open_at_the_case_itself_is_proved_nowhere() -> None:
    here = Exact.parse("1.1").ball()
    ends = [Exact.parse(x).ball() for x in (0, "1.3", 2)]
    assert _free(here, ends, ((1.0, 1.2),)) is None
    found = _free(here, ends, ((0.5, 0.6), (1.8, 1.9)))
    assert found is not None
    assert tuple(map(float, found)) == pytest.approx((0.6, 1.3))


def test_symbols_are_printed_with_lowered_letters() -> None:
    assert with_subscripts("iη_b < q_lm, η_M1") == "iη<sub>b</sub> &lt; q<sub>lm</sub>, η<sub>M1</sub>"
    assert with_subscripts("alpha_C seq_lm η_bx") == "alpha_C seq_lm η_bx"


def test_margins_in_units() -> None:
    """km/h, kg and m are those of (10)–(12), computed here by hand."""
    physical = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=200, c=775, masses=[(10000, 0), (10000, "3.4")])
    source = Source(physical.dimensionless, physical, "")
    chi = (1e6 / (4 * 6.4e6)) ** 0.25
    v_cr = (1e6 / 60) ** 0.5 / chi
    for name, factor, here, unit in (
        ("velocity", v_cr * 3.6, 720.0, "km/h"),
        ("mass", 10000.0, 10000.0, "kg"),
        ("distance", 1 / chi, 3.4, "m"),
    ):
        with ball_arithmetic(128):
            now = {"velocity": source.case.alpha, "mass": Exact(1), "distance": source.case.positions[1]}[name].ball()
            below, above = now * Exact.parse("0.9").ball(), now * Exact.parse("1.25").ball()
        found = Margin(name, now, below, above, Exact(0), Exact(3), True)
        data = margin_data(found, source)
        assert data["unit"] == unit
        for key, share in (("here", 1), ("below", 0.9), ("above", 1.25), ("margin", -0.1)):
            assert abs(float(data[key]["in_unit"]["value"]) / (share * here) - 1) < 1e-12
            assert (
                abs(float(data[key]["in_unit"]["value"]) / float(data[key]["parameter"]["value"]) / factor - 1)
                < 1e-12
            )
        said = card(found, source, True)
        assert said.figure.startswith("−")
        assert abs(float(said.figure[1:].split()[0]) / (0.1 * here) - 1) < 1e-4
        assert "becomes unstable below" in said.sentence
        assert "(10.0 %) less than now" in said.sentence
        only_above = replace(found, below=None)
        assert "becomes stable above" in card(only_above, source, False).sentence
        assert card(only_above, source, False).figure.startswith("+")


def test_the_page_has_one_head_and_every_section_in_order(page: Page) -> None:
    names = ["verdict", "case", "roots", "plane", "lines", "chart", "response", "contact", "proof", "certificate"]
    assert [attrs["id"] for attrs, _ in page.all("section")] == names
    assert [attrs["href"] for attrs, _ in page.all("a")][: len(names) + 1] == ["#verdict", *(f"#{n}" for n in names)]
    levels = [int(tag[1]) for tag, _ in page.elements if tag in ("h1", "h2", "h3")]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))
    assert dict(page.elements)["html"] == {"lang": "en"}
    assert {tag for tag, _ in page.elements} >= {"header", "main", "nav", "footer", "figure", "figcaption", "title"}


def test_the_page_can_be_read_without_seeing(page: Page) -> None:
    assert page.all("table")
    assert len(page.all("caption")) == len(page.all("table"))
    assert all("scope" in attrs for attrs, _ in page.all("th"))
    pictures = page.all("svg")
    assert len(pictures) == len(page.all("figure")) == len(page.all("figcaption")) >= 7
    ids = [attrs["id"] for _, attrs in page.elements if "id" in attrs]
    assert len(ids) == len(set(ids))
    for attrs, _ in pictures:
        assert attrs["role"] == "img"
        for key in ("aria-labelledby", "aria-describedby"):
            assert page.under(attrs[key])
    for _, attrs in page.elements:
        assert attrs.get("aria-labelledby", ids[0]) in ids


def test_the_page_needs_no_network_and_runs_nothing(page: Page) -> None:
    for tag, attrs in page.elements:
        assert tag not in ("iframe", "object", "embed", "base", "form")
        assert not [key for key in attrs if key.startswith("on")]
        for key in ("src", "href", "xlink:href", "action", "srcset"):
            assert attrs.get(key, "#").startswith(("#", "data:"))
    assert [attrs["type"] for attrs, _ in page.all("script")] == ["application/json"]
    (style,) = [text for _, text in page.all("style")]
    assert "url(" not in style
    assert "@import" not in style


def test_what_the_input_says_is_text(page: Page) -> None:
    assert page.all("h1") == [({}, "One mass <fast> & heavy")]
    assert "fast" not in {tag for tag, _ in page.elements}


def test_the_verdict_comes_first(page: Page, parts: Parts) -> None:
    said = page.under("verdict")
    assert said.startswith("Verdict UNSTABLE" if parts.spectrum.unstable else "Verdict STABLE")
    assert "Now 1080 km/h" in said
    assert "Now 1000 kg" in said


def test_the_data_of_the_page(page: Page, parts: Parts) -> None:
    data = json.loads(page.under("data"))
    certificate = data["certificates"][0]["file"]
    expected = as_data(parts.spectrum, PHYSICAL, "One mass <fast> & heavy", certificate)
    assert data["report"] == expected
    for k, root in enumerate([one for one in data["report"]["roots"] if not one["re"]["value"].startswith("-")], 1):
        assert page.under(f"q{k}-re") == "±" + root["re"]["value"]
        assert page.under(f"q{k}-im").replace("−", "-") == root["im"]["value"]
    assert len(data["response"]["t"]) == len(data["response"]["w"][0])
    assert len(data["chart"]["columns"]) == 2
    assert [float(Fraction(alpha)) for alpha in data["lines"]["alpha"]] == sorted(
        float(Fraction(alpha)) for alpha in data["lines"]["alpha"]
    )


def test_every_certificate_can_be_taken_out_and_is_valid(page: Page, tmp_path: Path) -> None:
    data = json.loads(page.under("data"))
    links = [attrs for attrs, _ in page.all("a") if "download" in attrs]
    assert [link["download"] for link in links] == [one["file"] for one in data["certificates"]]
    assert len(links) >= 2
    commands = [text for _, text in page.all("code")]
    for link, one in zip(links, data["certificates"], strict=True):
        kind, _, content = link["href"].partition(",")
        assert kind == "data:application/json;base64"
        file = tmp_path / link["download"]
        file.write_bytes(base64.b64decode(content))
        assert json.loads(file.read_text("ascii"))["sha256"] == one["sha256"]
        verdict = verify(file)
        assert verdict.valid, verdict.reason
        assert f"mpsolve verify '{link['download']}'" in commands


def test_parts_that_are_undecided_say_why(parts: Parts) -> None:
    reason = "the reason & its remedy"
    open_parts = replace(
        parts,
        lines=Part(None, reason),
        chart=Part(None, reason),
        response=Part(None, reason),
        margins=tuple(replace(one, proved=False, reason=reason, above=None, below=None) for one in parts.margins[:2])
        + parts.margins[2:],
    )
    page = Page(report_page(open_parts, "x"))
    for name in ("lines", "chart", "response"):
        assert f"{reason}." in page.under(name)
    assert page.under("verdict").count("The reason & its remedy.") == 2
    assert page.under("proof").count(reason.removeprefix("the")) == 5
    assert json.loads(page.under("data"))["response"] == {"undecided": reason}
    assert not open_parts.proved


def test_an_overdamped_case_has_a_page_too() -> None:
    """Its cuts leave the line: no frequency lines and no response, but roots with Im q < 0 are decided.

    Nothing is claimed of the others, which were not looked for.
    """
    source = Source(Case(alpha="0.5", eta_b="1.2", eta_m=10), None, "")
    found = gather(source, 15, None, None, 3, (Fraction(1),))
    page = Page(report_page(found, "over"))
    assert page.under("verdict").startswith("Verdict STABLE")
    for name in ("lines", "response"):
        assert "from 1 on the branch cuts leave the line Im q = " in page.under(name)
    assert "None with Im q < 0; those with Im q ≥ 0 are not looked for." in page.under("roots")
    assert "Proves that no induced frequency has Im q < 0" in page.under("certificate")
    everything = page.under("data") + " ".join(
        page.under(name) for name in ("roots", "plane", "proof", "certificate")
    )
    assert not [
        said for said in ("There is none", "no root.", "all induced frequencies", "region=") if said in everything
    ]
    with ball_arithmetic(64):
        assert found.spectrum.region == "unstable"


def test_more_masses_have_fewer_velocities_and_columns() -> None:
    """So that a page takes no more than some minutes; the case's own masses are always among the columns."""
    cases = [Case(alpha="0.5", eta_b="0.05", eta_m=[10] * n, positions=range(n)) for n in (1, 2, 3, 4, 5)]
    points = [page_parts.points_of(case) for case in cases]
    columns = [page_parts.factors_of(case) for case in cases]
    assert points == sorted(points, reverse=True)
    assert points[0] == points[1] > points[2] > points[3] == points[4] > 1
    assert all(1 in one for one in columns)
    assert [len(one) for one in columns] == [15, 15, 3, 1, 1]
    together = replace(cases[2], positions=(Exact(0), Exact(1), Exact(1)))
    assert page_parts.points_of(together) == points[1]  # two masses at one place are one


def test_loads() -> None:
    """Those of the input; the weight where a physical case has none; one unit each for a dimensionless case."""
    given = (Load(constant=3),)
    assert loads_for(Source(CASE, None, ""), given)[0] == given
    assert loads_for(Source(CASE, None, ""), None)[0] == (Load(),) * CASE.count
    weight, said = loads_for(Source(PHYSICAL.dimensionless, PHYSICAL, ""), None)
    assert float(weight[0].constant) == 9806.65
    assert "its own weight" in said


def test_the_page_holds_the_loads_from_which_its_response_can_be_had_again(parts: Parts) -> None:
    mass = Mass(1000, 0, P="9806.65", P_A=500, omega_f="125.5", phi_f="0.5")
    physical = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=300, c=9000, masses=[mass])
    source = Source(physical.dimensionless, physical, "")
    given, said = loads_for(source, None)
    page = Page(report_page(replace(parts, source=source, loads=given, loads_said=said), "x"))
    shown = page.under("case")
    for row in ("P19806.65 N", "PA1500 N", "ωf1125.5 rad/s", "φf10.5 rad"):
        assert row in shown
    data = json.loads(page.under("data"))
    assert tuple(Load(**one) for one in data["loads"]) == given
    assert Mass(**data["report"]["physical"]["mass"][0]) == mass


def test_the_loads_in_words_and_numbers() -> None:
    weights = loads_for(Source(PHYSICAL.dimensionless, PHYSICAL, ""), None)[0]
    (row,) = load_rows(Source(PHYSICAL.dimensionless, PHYSICAL, ""), weights)
    assert row == ("P1", "9806.65 N", "weight of mass 1, for no force is given")
    rows = list(load_rows(Source(CASE, None, ""), (Load(), Load("0.5", "0.1", "0.3"))))
    assert [name for name, _, _ in rows] == ["η_C1", "η_C2", "η_A2", "ω̂_f2", "φ2"]
    assert [value for _, value, _ in rows] == ["1", "0.5", "0.1", "0.3 per unit of τ", "0 rad"]


def test_the_times_follow_the_roots() -> None:
    growing = certify(replace(CASE, alpha=Exact.parse("0.9")))
    fastest = max(-float(root.q.imag) for root in growing.roots)
    slowest = min(abs(float(root.q.real)) for root in growing.roots)
    found = times(growing)
    assert found[0] == 0
    assert found[-1] * fastest < 6.001 or found[-1] * slowest < 12.001 * 6.2832
    assert (found[1:] > found[:-1]).all()


def test_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, parts: Parts) -> None:
    from mpsolve.report import page_parts

    asked = []
    monkeypatch.setattr(page_parts, "gather", lambda *given: asked.append(given) or parts)
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "one.toml"
    file.write_text("[dimensionless]\nalpha = 1.1\neta_b = 0.1\neta_m = [20]\npositions = [0]\n", "utf-8")
    done = CliRunner().invoke(cli, ["report", "one.toml", "--digits", "20"])
    assert done.exit_code == (0 if parts.proved else 1), done.output
    assert done.output.splitlines()[1] == "one.html"
    assert Page((tmp_path / "one.html").read_text("utf-8")).under("verdict")
    assert (asked[0][0].case.alpha, asked[0][1]) == (Exact.parse("1.1"), 20)
    for words, status, said in (
        (["none.toml"], 2, "does not exist"),
        (["one.toml", "-o", "none/x.html"], 2, "no directory"),
        (["one.toml", "-o", "one.toml"], 2, "input file"),
    ):
        done = CliRunner().invoke(cli, ["report", *words])
        assert (done.exit_code, said in done.output) == (status, True), done.output


def test_notebooks_show_spectra_responses_and_tables(parts: Parts) -> None:
    from mpsolve.model.specs import Grid
    from mpsolve.stability.table import Entry, OnsetTable

    table = OnsetTable(
        "A <title>", "onset mass", 3, {"eta_b": "0.05"}, None, Grid("alpha", (Exact(1),)), Grid("d", (Exact(1),)),
        ((Entry("undecided", None, "too & close"),),),
    )  # fmt: skip
    assert parts.response.value is not None
    shown = [Page(one._repr_html_()) for one in (parts.spectrum, parts.response.value, table)]
    assert [len(one.all("table")) for one in shown] == [1, 1, 1]
    assert [len(one.all("svg")) for one in shown] == [1, 1, 0]
    assert shown[0].all("strong")[0][1].startswith(("STABLE", "UNSTABLE"))
    assert len(shown[0].all("tr")) == 1 + len([r for r in parts.spectrum.roots if not r.q.real < 0])
    assert re.search(r"(halves|doubles) in [\d.]+ τ", shown[0].all("table")[0][1])
    assert "not proved" in shown[1].all("div")[0][1]
    assert shown[2].all("strong")[0][1] == "A <title>"
    assert "too & close" in shown[2].all("div")[0][1]


def test_the_chart_and_the_lines_reach_beyond_the_case() -> None:
    fast = replace(CASE, alpha=Exact.parse("1.7"))
    assert page_parts._top(fast, Fraction(7, 5)) > fast.alpha
    assert page_parts._top(CASE, Fraction(7, 5)) == Exact.parse("1.4")


def test_the_columns_of_the_chart_are_those_of_scaled_masses() -> None:
    factors = (Fraction(4, 5), Fraction(1))
    chart = case_chart(CASE, factors, (Exact.parse("0.6"), Exact.parse("0.75")), workers=1)
    assert (chart.proved, chart.x.values) == (True, tuple(map(Exact.parse, factors)))
    changes = 0
    for factor, column in zip(factors, chart.columns, strict=True):
        changes += len(column.points)
        for band in column.bands:
            middle = Exact.parse(Fraction((band.start + band.end) / 2).limit_denominator(1000))
            masses = [ratio * factor for ratio in CASE.eta_m]
            assert unstable(CASE, alpha=middle, eta_m=masses) is (band.unstable != 0)
    assert changes >= 2
