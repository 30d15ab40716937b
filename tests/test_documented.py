"""Every public name says what it is, every example in a docstring runs, every command says what it does."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
from typing import Any

import click
import pytest

import mpsolve
from mpsolve.cli import cli

MODULES = sorted(
    one.name for one in pkgutil.walk_packages(mpsolve.__path__, "mpsolve.") if "__main__" not in one.name
)
WITH_EXAMPLES = [name for name in MODULES if ">>> " in (inspect.getsource(importlib.import_module(name)))]


def members(public: Any) -> list[tuple[str, Any]]:
    """The methods and properties that a class has of its own."""
    if not inspect.isclass(public):
        return []
    kinds = (property, classmethod, staticmethod)
    named = [(name, one) for name, one in vars(public).items() if not name.startswith("_")]
    return [(name, one) for name, one in named if inspect.isfunction(one) or isinstance(one, kinds)]


@pytest.mark.parametrize("name", mpsolve.__all__)
def test_a_public_name_is_documented(name: str) -> None:
    public = getattr(mpsolve, name)
    own = vars(public).get("__doc__") if inspect.isclass(public) else public.__doc__
    assert own is not None
    assert not own.startswith(f"{name}(")  # what a dataclass writes where nobody does
    assert own.strip().splitlines()[0].endswith((".", ":", ",")) or "\n" in own.strip()
    for inner, member in members(public):
        documented = member.__func__ if isinstance(member, classmethod | staticmethod) else member
        assert documented.__doc__, f"{name}.{inner}"


@pytest.mark.parametrize("name", WITH_EXAMPLES)
def test_the_examples_in_docstrings_run(name: str) -> None:
    failed, tried = doctest.testmod(importlib.import_module(name))
    assert (failed, tried > 0) == (0, True)


@pytest.mark.parametrize("name", cli.list_commands(click.Context(cli)))
def test_a_command_and_its_options_are_explained(name: str) -> None:
    command = cli.get_command(click.Context(cli), name)
    assert command is not None
    assert command.help
    assert "Exit status" in command.help or name == "derive"
    for option in command.params:
        assert not isinstance(option, click.Option) or option.help, option.name


def test_every_module_says_what_it_is() -> None:
    empty = [name for name in MODULES if not importlib.import_module(name).__doc__]
    packages = [name for name in empty if not hasattr(importlib.import_module(name), "__path__")]
    assert packages == []
