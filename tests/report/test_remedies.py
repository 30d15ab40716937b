"""Remedies name options that the commands have, not arguments of the library."""

from __future__ import annotations

import re

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
