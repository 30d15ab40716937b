"""A certificate under a default name overwrites one of its own case, and nothing else."""

from __future__ import annotations

from pathlib import Path

from mpsolve.certificate.format import Certificate
from mpsolve.certificate.own_name import own_name

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
