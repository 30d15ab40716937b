"""The report for machines: every key that the docstring promises, exact numbers beside decimals, plain JSON."""

from __future__ import annotations

import json
import re
from fractions import Fraction

from reported import SPRUNG, fast, wire, without_theorem

from mpsolve import Case, PhysicalCase, certify
from mpsolve.report.spectrum_data import number, problem_data, region_data, spectrum_data
from mpsolve.spectrum.regions import HalfPlane, Rectangle, Sheet


def test_the_keys_are_those_that_are_documented() -> None:
    said = spectrum_data.__doc__ or ""
    data = spectrum_data(wire())
    named = {name for line in re.findall(r"^    ([a-z_, ]+?)   ", said, re.MULTILINE) for name in line.split(", ")}
    assert {name for name in data if name not in named} <= {"assumed"}
    inner = {n for line in re.findall(r"^        ([a-z_][a-z_, ]*?)  ", said, re.MULTILINE) for n in line.split(", ")}
    assert data["roots"][0].keys() == inner


def test_numbers() -> None:
    data = json.loads(json.dumps(spectrum_data(wire(), "A wire", "wire.json"), allow_nan=False))
    assert (data["format"], data["version"], data["title"]) == ("mpsolve report", 2, "A wire")
    assert (data["count"], data["unstable"], data["stable"], data["status"]) == (2, 0, True, "proved, not verified")
    assert data["certificate"] == "wire.json"
    one = data["roots"][-1]
    assert one["re"]["value"].startswith("15.641876611743")
    assert float(one["re"]["radius"]) < 1e-18
    assert (one["trend"], one["doubling_time"]) == ("decays", None)
    assert abs(float(one["halving_time"]["value"]) - 0.96809873) < 1e-8
    assert one["growth_rate"]["value"].startswith("-0.71598")
    assert data["problem"]["track"]["parameters"]["m"] == {"exact": "107/100", "decimal": "1.07", "unit": "kg/m"}
    assert data["problem"]["vehicle"][0]["model"] == "mass"
    assert data["units"]["frequency"] == "Hz"
    grows = spectrum_data(fast())["roots"][0]
    assert grows["trend"] == "grows"
    assert float(grows["doubling_time"]["value"]) > 0


def test_regions() -> None:
    assert region_data(Sheet()) == {"kind": "sheet", "words": "the whole physical sheet"}
    assert region_data(HalfPlane())["kind"] == "unstable"
    box = region_data(Rectangle("1/3", 1, 0, 1))
    assert (box["kind"], box["re_min"]["exact"]) == ("rectangle", "1/3")
    assert abs(float(box["re_min"]["decimal"]) - 1 / 3) < 1e-16
    below = region_data(wire().region)
    assert below["kind"] == "below"
    assert {"height", "reach"} <= below.keys()
    assert region_data(without_theorem().region)["radius"]["exact"] == "1000"


def test_what_a_proof_does_not_have_is_null() -> None:
    found = certify(Case(alpha=1, eta_b=0, eta_m=20), region="sheet")
    data = spectrum_data(found)
    assert (data["status"], data["count"], data["stable"]) == ("undecided", None, None)
    assert data["reason"]["code"]
    assert data["problem"]["case"]["eta_m"] == [{"exact": "20", "decimal": "20"}]


def test_problems() -> None:
    rail = PhysicalCase(EI="6.4e6", m=60, k="1e6", v="1/3", masses=[(10, 0), (20, 2)])
    data = problem_data(rail)
    assert data["velocity"]["exact"] == "1/3"
    assert [one["position"]["exact"] for one in data["vehicle"]] == ["0", "2"]
    assert number(Fraction(1, 3)) == {"exact": "1/3", "decimal": "0.33333333333333333"}


def test_parameters_have_their_units() -> None:
    told = problem_data(SPRUNG)
    assert told["velocity"] == {"exact": "60", "decimal": "60", "unit": "m/s"}
    assert told["track"]["parameters"]["EI"]["unit"] == "N m²"
    assert told["vehicle"][0]["position"]["unit"] == "m"
