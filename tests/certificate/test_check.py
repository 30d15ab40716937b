"""Each certificate goes to the verifier of its version; whatever else a file holds is refused in words."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

import mpsolve
from mpsolve import Problem, certify, verify
from mpsolve.certificate import verify2
from mpsolve.certificate.check import verify_bytes
from mpsolve.tracks import String
from mpsolve.vehicles import Mass

CERTS = Path(__file__).parents[2] / "certs"
AT_REST = Problem(String(T=1, m=1, k=1, c="0.1"), [Mass(1)], v=0)


def second() -> bytes:
    found = certify(AT_REST, region="unstable", digits=15, check=False)
    return found.certificate.text.encode("ascii")


def test_a_file_of_version_1_is_told_how_to_be_made_anew(tmp_path: Path) -> None:
    (tmp_path / "old.json").write_text('{"format": "mpsolve certificate", "version": 1, "kind": "crossings"}')
    found = verify(tmp_path / "old.json")
    assert not found.valid
    assert "version 1" in found.reason
    assert "mpsolve certify" in found.reason
    assert "mpsolve crossings" in found.reason


def test_a_committed_file() -> None:
    found = verify(CERTS / "single_mass.json")
    assert found.valid, found.reason
    assert "exactly 2 induced frequencies" in found.claim


def test_version_2(tmp_path: Path) -> None:
    raw = second()
    (tmp_path / "two.json").write_bytes(raw)
    wanted, found = verify2.verify_bytes(raw), verify(tmp_path / "two.json")
    assert (found.valid, found.reason, found.claim) == (wanted.valid, wanted.reason, wanted.claim)
    assert type(found) is mpsolve.Verdict


def test_a_forged_version_2_is_refused() -> None:
    content = json.loads(second())
    content["claim"]["count"] = 1
    assert "digest" in verify_bytes(json.dumps(content).encode("ascii")).reason


@pytest.mark.parametrize(
    "raw",
    [b"", b"{", b"[]", b'{"version": 2}', b'{"version": 3}', b"\xff", b"[" * 100_000, b'{"a": "\\"version\\": 2"}'],
)
def test_what_is_no_certificate(raw: bytes) -> None:
    found = verify_bytes(raw)
    assert not found.valid
    assert found.reason


def test_a_missing_file(tmp_path: Path) -> None:
    assert "cannot be read" in verify(tmp_path / "none.json").reason
    assert "cannot be read" in verify("a\0b").reason


def test_verifying_needs_no_numpy(tmp_path: Path) -> None:
    (tmp_path / "two.json").write_bytes(second())
    code = "import sys; from mpsolve import verify; [verify(x) for x in sys.argv[1:]]; print('numpy' in sys.modules)"
    command = [sys.executable, "-c", code, str(tmp_path / "two.json"), str(CERTS / "single_mass.json")]
    environment = {"PYTHONPATH": str(Path(mpsolve.__file__).parents[1])}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"
