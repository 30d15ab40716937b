"""Certificates as files: stable text that holds exact numbers, written whole or not at all."""

from __future__ import annotations

import json
import stat
from functools import cache
from pathlib import Path

from mpsolve import Case, Spectrum, certify
from mpsolve.certificate.format import Certificate, digest, own_name
from mpsolve.certificate.verify2 import verify_bytes

CASE = Case(alpha="0.9", eta_b="0.05", eta_m="70")


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


def test_the_digest_is_of_the_content_and_not_of_its_layout() -> None:
    content = dict(certificate().content)
    given_digest = content.pop("sha256")
    assert digest(dict(reversed(content.items()))) == given_digest
    assert verify_bytes(json.dumps(certificate().content, indent=7).encode()).valid


def test_saving_gives_the_path_and_a_file_that_others_can_read(tmp_path: Path) -> None:
    file = certificate().save(tmp_path / "case.json")
    assert file == tmp_path / "case.json"
    assert file.read_text() == certificate().text
    assert stat.S_IMODE(file.stat().st_mode) == 0o644
    assert certificate().save(str(file)) == file
    assert list(tmp_path.iterdir()) == [file]


ONE = Certificate({"kind": "spectrum", "equations": {"velocity": "1"}, "claim": 1})
AGAIN = Certificate({"kind": "spectrum", "equations": {"velocity": "1"}, "claim": 2})
OTHER = Certificate({"kind": "spectrum", "equations": {"velocity": "2"}, "claim": 1})


def test_only_its_own_case_is_overwritten(tmp_path: Path) -> None:
    path = tmp_path / "case.certificate.json"
    assert own_name(path, ONE.content) == path
    ONE.save(path)
    assert own_name(path, AGAIN.content) == path
    away = own_name(path, OTHER.content)
    assert away != path
    assert away.parent == tmp_path
    assert away.name.startswith("case-")
    assert away.name.endswith(".certificate.json")
    assert own_name(path, OTHER.content) == away


def test_what_is_no_certificate_stays(tmp_path: Path) -> None:
    path = tmp_path / "case.certificate.json"
    for text in ("", "[]", "{", "\udcff"):
        path.write_text(text, "utf-8", errors="surrogatepass")
        assert own_name(path, ONE.content) != path
