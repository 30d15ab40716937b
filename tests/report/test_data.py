"""The report for machines: its keys, and numbers that contain the library's balls."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

from flint import arb, fmpq

from mpsolve import Case, PhysicalCase, Rectangle, read_case
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.model.parameters import Mass
from mpsolve.report.data import as_data, physical_data

EXAMPLES = Path(__file__).parents[2] / "examples"
UNSTABLE = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))


def enclosure(number: dict[str, str]) -> arb:
    value, radius = (Fraction(number[key]) for key in ("value", "radius"))
    low, high = (arb(fmpq(x.numerator, x.denominator)) for x in (value - radius, value + radius))
    return low.union(high)


def test_the_keys_are_documented() -> None:
    data = as_data(certify(UNSTABLE))
    described = as_data.__doc__ or ""
    for key in [*data, *data["roots"][0]]:
        assert key in described, key


def test_it_agrees_with_the_spectrum() -> None:
    spectrum = certify(UNSTABLE)
    data = json.loads(json.dumps(as_data(spectrum, title="t", certificate=Path("x.json"))))
    assert (data["status"], data["stable"], data["reason"]) == ("proved", False, "")
    assert (data["count"], data["unstable"], data["radius"]) == (4, 2, "128")
    assert (data["title"], data["certificate"], data["physical"]) == ("t", "x.json", None)
    assert Case.from_dict(data["case"]) == UNSTABLE
    assert [root["trend"] for root in data["roots"]] == ["grows", "decays", "decays", "grows"]
    for written, root in zip(data["roots"], spectrum.roots, strict=True):
        assert enclosure(written["re"]).contains(root.q.real)
        assert enclosure(written["im"]).contains(root.q.imag)
        assert (written["doubling_time"] is None) is (written["trend"] != "grows")
        assert (written["halving_time"] is None) is (written["trend"] != "decays")
    assert len(data["roots"][-1]["re"]["value"]) >= 30


def test_a_physical_case_can_be_rebuilt() -> None:
    case = read_case(EXAMPLES / "rail_60e1.toml")
    assert isinstance(case, PhysicalCase)
    data = as_data(certify(case), case)
    masses = [Mass(**mass) for mass in data["physical"].pop("mass")]
    assert PhysicalCase(**data["physical"], masses=masses) == case
    assert data["units"]["frequency"] == "Hz"


def test_a_rectangle_and_an_undecided_case() -> None:
    data = as_data(certify(UNSTABLE, region=Rectangle("0.1", "0.2", "-0.1", "0.01")))
    assert data["region"] == {"re_min": "1/10", "re_max": "1/5", "im_min": "-1/10", "im_max": "1/100"}
    assert data["stable"] is None
    data = as_data(certify(Case(alpha=1, eta_b=0, eta_m=20)))
    assert (data["status"], data["count"], data["unstable"], data["roots"]) == ("undecided", None, None, [])
    assert "alpha_C" in data["reason"]


def test_the_forces_of_a_physical_case_are_there_exactly() -> None:
    mass = Mass(10, 0, P="0.1", P_A="1/3", omega_f="125.5", phi_f="-0.25")
    (written,) = physical_data(PhysicalCase(EI=1, m=1, k=1, v=1, masses=[mass]))["mass"]
    assert written == {"M": "10", "position": "0", "P": "1/10", "P_A": "1/3", "omega_f": "251/2", "phi_f": "-1/4"}
    assert Mass(**written) == mass
