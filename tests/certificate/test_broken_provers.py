"""A prover with one formula broken must not get a false claim past the checker: it ends open, or its file is refused.

Each mutation changes one place in the source of one function of the prover, everywhere it is imported. The checker
shares none of that code. All mutations listed do harm on the problem they are tried on, so none may be believed.
(Some others do none: an inertia's slope that is lost, say, only makes the prover's own pieces wrong, and the checker
proves the pieces again.)
"""

from __future__ import annotations
import __future__

import importlib
import inspect
import random
import sys
import textwrap
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any

import pytest
from prover_mutations import MUTATIONS, PROBLEMS, Mutation

from mpsolve.certificate import verify2
from mpsolve.certificate.solve import certify_problem
from mpsolve.errors import InputError, MpsolveError
from mpsolve.proof.effort import Effort

SAMPLE = random.Random(18).sample(range(len(MUTATIONS)), 4)


def clear() -> None:
    """Forget what whole, or broken, functions have kept."""
    for module in ours():
        for name, value in list(vars(module).items()):
            if hasattr(value, "cache_clear"):
                value.cache_clear()
            if name.startswith("forget"):
                value()


def ours() -> list[Any]:
    """The modules of the package but the checker."""
    return [m for name, m in list(sys.modules.items()) if name.startswith("mpsolve") and m is not verify2]


@contextmanager
def broken(mutation: Mutation) -> Iterator[None]:
    """The package with the formula changed; afterwards as it was."""
    module = importlib.import_module(f"mpsolve.{mutation.module}")
    *owner, name = mutation.name.split(".")
    home = getattr(module, owner[0]) if owner else module
    before = vars(home)[name]
    plain = inspect.unwrap(getattr(home, name))
    source = textwrap.dedent(inspect.getsource(plain))
    assert source.count(mutation.old) >= 1, f"{mutation.name} no longer holds {mutation.old!r}: mend this test"
    code = compile(
        source.replace(mutation.old, mutation.new), "<broken>", "exec", __future__.annotations.compiler_flag
    )
    space: dict[str, Any] = {}
    exec(code, vars(module) | {}, space)
    after = type(before)(space[name].__func__) if isinstance(before, (classmethod, staticmethod)) else space[name]
    places = [(home, name)] if owner else [(m, k) for m in ours() for k, v in list(vars(m).items()) if v is before]
    clear()
    try:
        for place, key in places:
            setattr(place, key, after)
        yield
    finally:
        for place, key in places:
            setattr(place, key, before)
        clear()


@cache
def truth(on: str) -> tuple[int, int]:
    problem, region = PROBLEMS[on]
    found = certify_problem(problem, region=region, digits=15)
    assert found.proved, found.reason
    return found.count, found.unstable


def outcome(on: str) -> str:
    """What comes of the prover: "open: …", "refused: …", or "valid: …"."""
    problem, region = PROBLEMS[on]
    try:
        found = certify_problem(problem, region=region, digits=15, effort=Effort(evaluations=30_000), check=False)
    except (MpsolveError, InputError, ValueError, ArithmeticError) as error:
        return f"open: {type(error).__name__}: {error}"
    if found.certificate is None:
        return f"open: {found.reason}"
    verdict = verify2.verify_bytes(found.certificate.text.encode("ascii"))
    return f"valid: {found.count, found.unstable}" if verdict.valid else f"refused: {verdict.reason}"


def check(mutation: Mutation) -> None:
    true = truth(mutation.on)
    with broken(mutation):
        found = outcome(mutation.on)
    assert not found.startswith("valid"), f"{mutation.words}: {found}, and the truth is {true}"


@pytest.mark.parametrize("on", PROBLEMS)
def test_the_prover_that_is_whole_is_believed(on: str) -> None:
    assert outcome(on) == f"valid: {truth(on)}"


@pytest.mark.parametrize("number", SAMPLE)
def test_a_sample_of_broken_provers_is_caught(number: int) -> None:
    check(MUTATIONS[number])


@pytest.mark.slow
@pytest.mark.parametrize("mutation", MUTATIONS, ids=lambda m: m.words.replace(" ", "_"))
def test_every_broken_prover_is_caught(mutation: Mutation) -> None:
    check(mutation)


def test_nothing_stays_broken() -> None:
    for mutation in MUTATIONS:
        with broken(mutation):
            pass
    assert outcome("wire") == f"valid: {truth('wire')}"
