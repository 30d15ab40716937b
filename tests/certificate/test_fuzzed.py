"""Damaged certificates of version 2: the checker says why, soon, and never believes another claim."""

from __future__ import annotations

import importlib.util
import json
import resource
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from forging import as_file
from fuzzing import edited, flipped, fuzzed
from hypothesis import strategies as st

from mpsolve.certificate import verify2

CERTS = Path(__file__).parents[2] / "certs"
NAMES = ["contact_wire", "floating_ice", "joined_masses", "rectangle", "single_mass"]
RAW = {name: (CERTS / f"{name}.json").read_bytes() for name in NAMES}
CONTENT = {name: json.loads(raw) for name, raw in RAW.items()}
LONGEST, GROWTH = 60.0, 400  # processor seconds for one file, MB for all


def filed(content: Any) -> bytes:
    """The content as a file, with its digest made anew where it is an object."""
    whole = isinstance(content, dict) and "sha256" in content
    return as_file(content) if whole else json.dumps(content).encode("ascii")


def judged(raw: bytes) -> verify2.Verdict:
    """The verdict, which comes soon, with a sentence if it is no, and without growth of memory."""
    began, held = time.process_time(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    verdict = verify2.verify_bytes(raw)
    assert time.process_time() - began < LONGEST
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - held < GROWTH * 1024
    assert verdict.valid is (not verdict.reason)
    return verdict


def second_look(raw: bytes) -> str:
    """What the second checker says: "valid", "partly" or "invalid"."""
    folder = CERTS / "second_checker"
    sys.path.insert(0, str(folder))
    try:
        spec = importlib.util.spec_from_file_location("second_check", folder / "check.py")
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        try:
            module.check(raw)
        except module.RefusedError as error:
            return f"invalid: {error}"
        except (module.NotCheckedError, ArithmeticError, ValueError):
            return "partly"
        return "valid"
    finally:
        sys.path.remove(str(folder))


def believed(original: dict[str, Any], raw: bytes) -> None:
    """A changed file that is valid says the same of the same equations; the second checker never contradicts it."""
    now = json.loads(raw)
    if now["equations"] == original["equations"] and now["basis"] == original["basis"]:
        same = now["claim"]["region"] == original["claim"]["region"]
        assert not same or now["claim"] == original["claim"]
    assert not second_look(raw).startswith("invalid")


@fuzzed(150, st.data(), st.sampled_from(NAMES))
def test_edited_certificates(data: st.DataObject, name: str) -> None:
    content = data.draw(edited(CONTENT[name]))
    if content != CONTENT[name] and judged(raw := filed(content)).valid:
        believed(CONTENT[name], raw)


@fuzzed(100, st.data(), st.sampled_from(NAMES))
def test_flipped_bytes(data: st.DataObject, name: str) -> None:
    raw = data.draw(flipped(RAW[name]))
    if judged(raw).valid:
        assert json.loads(raw) == CONTENT[name]


@pytest.mark.parametrize(
    "raw",
    [
        b"[" * 10**6,
        b'{"a":' * 10**5,
        b"9" * 10**6,
        b'{"format":"mpsolve certificate","version":' + b"2" * 10**5 + b"}",
    ],
    ids=["lists", "objects", "digits", "version"],
)
def test_deep_and_long_files(raw: bytes) -> None:
    assert not judged(raw).valid


@pytest.mark.parametrize("number", [10**4000, -(10**4000)], ids=["positive", "negative"])
@pytest.mark.parametrize("key", ["bits", "start", "version", "count", "exponent", "radius", "multiplicity", "loaded"])
def test_huge_integers(key: str, number: int) -> None:
    content = json.loads(RAW["contact_wire"])
    holders = {"count": content["claim"], "loaded": content["equations"]["track"]}
    holder = holders.get(key, content["roots"][0] if key in content["roots"][0] else content)
    holder[key] = [number, number] if isinstance(holder[key], list) else number
    assert not judged(filed(content)).valid


def test_doubled_keys() -> None:
    raw = RAW["contact_wire"].replace(b'"count"', b'"count": 0, "count"', 1)
    assert "twice" in judged(raw).reason
