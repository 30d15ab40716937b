"""The papers of examples/papers: every check comes to its end, with these verdicts and numbers, and can fail."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from mpsolve import Problem, certify, tracks, vehicles, verify
from mpsolve.claims import Paper, Verdict
from mpsolve.claims.load import audit, checked, load
from mpsolve.claims.report import Report

FOLDER = Path(__file__).parents[3] / "examples" / "papers"


def paper(name: str) -> Paper:
    return load(FOLDER / name)


@cache
def report(name: str) -> Report:
    return audit(paper(name), workers=1)


def verdicts(name: str) -> dict[str, Verdict]:
    return {claim.id: finding.verdict for claim, finding in report(name).entries}


def numbers(name: str, claim: str) -> list[str]:
    (finding,) = (finding for one, finding in report(name).entries if one.id == claim)
    return [value for _, value in finding.numbers]


def changed(name: str, claim: str, **at: tuple[str, ...]) -> Verdict:
    """The verdict where other cases are looked at."""
    one = paper(name).claim(claim)
    return checked(replace(one, at={**one.at, **at})).verdict


@pytest.mark.parametrize("name", ["dimitrovova_layers", "metrikine_1997", "verichev_2001"])
def test_certificates_are_valid(name: str, tmp_path: Path) -> None:
    found = report(name)
    assert found.complete
    paths = found.save_certificates(tmp_path)
    assert paths
    assert all(verify(path).valid for path in paths)


def test_one_mass_on_a_compressed_beam() -> None:
    assert verdicts("metrikine_1997") == {
        "onset": Verdict.CONDITIONAL,
        "growth": Verdict.PROVED,
        "compression": Verdict.CONDITIONAL,
        "compression-all": Verdict.CONDITIONAL,
        "overcritical": Verdict.PROVED,
        "overcritical-amplification": Verdict.AGREES,
    }
    # as onset_velocity("0.1", 10), found in another way, has it
    assert numbers("metrikine_1997", "onset") == ["1.2585393862629"]
    assert numbers("metrikine_1997", "compression")[0] == "1.2585393862629"


def test_its_verdicts_can_be_others() -> None:
    assert changed("metrikine_1997", "compression", N=("0.5", "0.25")) is Verdict.REFUTED
    assert changed("metrikine_1997", "growth", v=("1",)) is Verdict.UNDECIDABLE
    assert changed("metrikine_1997", "overcritical-amplification", c=("0.2",), v=("0:0.5:1",)) is Verdict.DISAGREES


def test_an_oscillator_and_a_bogie() -> None:
    assert verdicts("verichev_2001") == {
        "2001-growth": Verdict.PROVED,
        "2001-domains": Verdict.PROVED,
        "2002-growth": Verdict.PROVED,
        "2002-below": Verdict.REFUTED,
    }
    assert changed("verichev_2001", "2001-growth", v=("200",)) is Verdict.UNDECIDABLE
    assert changed("verichev_2001", "2002-below", v=("200",)) is Verdict.UNDECIDABLE


def test_layered_tracks() -> None:
    assert verdicts("dimitrovova_layers") == {
        "missing": Verdict.PROVED,
        "finite": Verdict.CONDITIONAL,
        "two-layer-force": Verdict.PROVED,
        "two-layer-mass": Verdict.PROVED,
        "two-layer-masses": Verdict.PROVED,
    }
    assert (
        changed("dimitrovova_layers", "missing", shear=("0",), k_ballast=("1e8",) * 4, k_ground=("5e7",) * 4)
        is Verdict.UNDECIDABLE
    )
    assert changed("dimitrovova_layers", "two-layer-mass", M=("500",)) is Verdict.UNDECIDABLE
    assert changed("dimitrovova_layers", "two-layer-masses", v=("500",)) is Verdict.UNDECIDABLE


def test_an_oscillator_on_a_string() -> None:
    assert verdicts("kruse_1998") == {"one-or-two": Verdict.PROVED, "not-unique": Verdict.PROVED}
    assert changed("kruse_1998", "one-or-two", wheel=("1",), k=("1",)) is Verdict.UNDECIDABLE
    # the string's own formula is that of the engine: the least damped root lies below the cuts, whatever they are
    oscillator = vehicles.Oscillator(wheel=1, body=1, k=1)
    found = certify(Problem(tracks.String(T=1, m=1, k=1, c="0.56"), oscillator, v="0.6"), digits=15)
    assert "0.645136 + 0.096489i" in numbers("kruse_1998", "not-unique")[0]
    assert f"{float(found.roots[-1].q.real):.6f} + {float(found.roots[-1].q.imag):.6f}i" == "0.645136 + 0.096489i"
