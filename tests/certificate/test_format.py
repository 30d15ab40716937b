"""Certificates as files: stable text that holds exact numbers, written whole or not at all."""

from __future__ import annotations

import json
import stat
from fractions import Fraction
from functools import cache
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from mpsolve import Case
from mpsolve.certificate.format import Certificate, digest, dyadic
from mpsolve.certificate.sheet import SheetSpectrum as Spectrum
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.certificate.verify import precision, read, root

CASE = Case(alpha="0.9", eta_b="0.05", eta_m="root4(24010000)")


@cache
def spectrum() -> Spectrum:
    return certify(CASE)


def certificate() -> Certificate:
    result = spectrum().certificate
    assert result is not None
    return result


def test_the_text_is_the_same_every_time() -> None:
    again = certify(Case(alpha="0.90", eta_b=0.05, eta_m=70)).certificate
    assert again is not None
    assert again.text == certificate().text


def test_the_text_gives_the_content_back() -> None:
    assert json.loads(certificate().text) == certificate().content
    assert certificate().text.isascii()
    assert certificate().text.endswith("}\n")
    assert max(map(len, certificate().text.splitlines())) < 300


def test_the_digest_is_of_the_content_and_not_of_its_layout() -> None:
    content = dict(certificate().content)
    given_digest = content.pop("sha256")
    assert digest(dict(reversed(content.items()))) == given_digest
    assert read(json.dumps(certificate().content, indent=7).encode()) == content


def test_the_case_comes_back_exactly() -> None:
    assert Case.from_dict(certificate().content["case"]) == CASE


def test_the_verifier_reads_the_very_balls_that_were_reported() -> None:
    with precision(256):
        boxes = [root(value).box for value in certificate().content["roots"]]
        for box, ball in zip(boxes, spectrum().roots, strict=True):
            assert box.contains(ball.q)
            assert box.mid() == ball.q.mid()


@given(st.floats(min_value=2.0**-900, max_value=2.0**900) | st.just(0.0))
def test_a_float_is_written_exactly(x: float) -> None:
    mantissa, exponent = dyadic(x)
    assert Fraction(int(mantissa, 16)) * Fraction(2) ** exponent == Fraction(x)


def test_saving_gives_the_path_and_a_file_that_others_can_read(tmp_path: Path) -> None:
    file = certificate().save(tmp_path / "case.json")
    assert file == tmp_path / "case.json"
    assert file.read_text() == certificate().text
    assert stat.S_IMODE(file.stat().st_mode) == 0o644
    assert certificate().save(str(file)) == file
    assert list(tmp_path.iterdir()) == [file]
