"""Remedies name options that the commands have, not arguments of the library."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import mpsolve
from mpsolve.cli_certify import certify
from mpsolve.cli_roots import roots
from mpsolve.proof.effort import MORE_EFFORT
from mpsolve.report.remedies import _COMMAND, on_command_line


def test_the_effort_of_the_library_is_an_option_here() -> None:
    said = on_command_line(f"3 s are spent: {MORE_EFFORT}")
    assert said == "3 s are spent: allow more with --effort SECONDS"
    assert on_command_line("no remedy") == "no remedy"


def test_all_options_are_those_of_certify_and_roots() -> None:
    known = {name for one in (*certify.params, *roots.params) for name in one.opts}
    named = {name for _, option in _COMMAND for name in re.findall(r"--[a-z]+", option)}
    assert named <= known


def test_texts_within_data_are_told_likewise() -> None:
    data = {"reason": {"remedy": MORE_EFFORT}, "all": ["ask for a Rectangle round what matters", 3, None]}
    assert on_command_line(data) == {
        "reason": {"remedy": "allow more with --effort SECONDS"},
        "all": ["ask for --region=RE_MIN,RE_MAX,IM_MIN,IM_MAX round what matters", 3, None],
    }


SPEECH = re.compile(
    r"Rectangle|Effort\(|\((\"|')below|(?<![-\w])(effort|region|digits|spectrum|cuts|im_max|re_min)( [<>]|=)"
)
"""How the library is spoken to."""
ROOMS = (
    "certificate",
    "spectrum",
    "characteristic",
    "proof",
    "ranges",
    "loci",
    "endless",
    "cuts",
    "passivity",
    "zeros",
)


def test_no_remedy_on_the_command_line_speaks_of_the_library() -> None:
    """`certify` of eight coaches advised a Rectangle, `train` effort=Effort(seconds=…)."""
    said = 0
    for file in sorted(one for room in ROOMS for one in (Path(mpsolve.__file__).parent / room).rglob("*.py")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        for call in ast.walk(tree):
            if isinstance(call, ast.Call) and ast.unparse(call.func).endswith("Reason"):
                for text in (one.value for one in ast.walk(call) if isinstance(one, ast.Constant)):
                    said += isinstance(text, str)
                    assert not SPEECH.search(on_command_line(str(text))), f"{file.name}:{call.lineno}: {text}"
        for name in ast.walk(tree):
            if isinstance(name, ast.Assign) and isinstance(name.value, ast.Constant) and " " in str(name.value.value):
                text = on_command_line(str(name.value.value))
                assert not SPEECH.search(text), f"{file.name}:{name.lineno}: {text}"
    assert said > 150
