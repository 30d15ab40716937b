"""No `assert` guards anything in the package: what is proved, and what is refused, is the same under `python -O`."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import mpsolve

PACKAGE = Path(mpsolve.__file__).parent

SAMPLE = """
import json, math, sys
from fractions import Fraction
import flint
import mpsolve
from mpsolve import Case, certify
from mpsolve.certificate import verify2
from mpsolve.certificate.format import digest
from mpsolve.errors import ContradictionError, InputError
from mpsolve.numbers.exact import Exact

def holds(condition, name):
    if not condition:
        sys.exit(f"under -O: {name}")

holds(not __debug__, "asserts are still on")
case = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
found = certify(case, digits=15)
holds(found.proved and (found.count, found.unstable) == (4, 2), "the count")
def verdict(change):
    content = json.loads(found.certificate.text)
    change(content)
    content["sha256"] = digest({k: v for k, v in content.items() if k != "sha256"})
    return verify2.verify_bytes(json.dumps(content).encode()).valid

def six(content):
    content["claim"]["count"] = 6

def no_number(content):
    content["equations"]["velocity"] = "0.67)"

holds(verdict(lambda content: None), "the certificate itself was refused")
holds(not verdict(six), "a wrong count was accepted")
holds(not verdict(no_number), "a number that is none was accepted")
try:
    Case(alpha=-1, eta_b="0.1", eta_m=1)
except InputError:
    pass
else:
    holds(False, "a negative velocity ratio")
"""


def test_the_package_has_no_assert() -> None:
    for file in PACKAGE.rglob("*.py"):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        lines = [node.lineno for node in ast.walk(tree) if isinstance(node, ast.Assert)]
        assert not lines, f"{file}: {lines}"


def test_proofs_and_refusals_are_the_same_without_asserts() -> None:
    command = [sys.executable, "-O", "-c", SAMPLE]
    result = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    assert (result.returncode, result.stderr) == (0, "")
