"""One voice for what cannot be used: the option or the key of the file, what was given, why not, what to do."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from mpsolve.errors import InputError

_NAMES = {"f": "function", "places": "xi", "store": "output", "times": "end", "tau": "end"}
"""Arguments of the library, and the parameter of a command that they come from."""


def told(error: InputError) -> str:
    """Its sentence under the name of the option that was typed, or of the key with its line in the file."""
    context = click.get_current_context(silent=True)
    said = error.said
    if context is None:
        return f"{error.key}: {said}"
    key = error.key.split(".")[0].split("[")[0]
    named = {key, f"--{key.lstrip('-')}", _NAMES.get(key, key)}
    for parameter in context.command.params:
        if named & {parameter.name, *parameter.opts}:
            inner = error.key.partition(".")[2]
            return f"{_name(parameter)}: {f'{inner} ' if inner else ''}{said}"
    if error.key in (text.partition("=")[0].strip() for text in context.params.get("overs", ())):
        return f"--over: {error.key} {said}"
    return f"{error.key}: {said}{_line(context.params.get('file'), error.key)}"


def _line(file: object, key: str) -> str:
    """Where the key stands, " (line 8 of mine.toml)"; "" where it stands nowhere."""
    from mpsolve.problem.lines import line_of
    from mpsolve.problem.toml import name_of, text_of

    if not isinstance(file, Path) or key == name_of(file):
        return ""
    try:
        number = line_of(text_of(file), key)
    except InputError:
        return ""
    return "" if number is None else f" (line {number} of {name_of(file)})"


class Told(click.ClickException):
    """A mistake in the words of a command, said as all others are."""

    exit_code = 2

    def show(self, file: object = None) -> None:  # noqa: ARG002  as click calls it
        """On standard error."""
        click.echo(f"mpsolve: {self.message}", err=True)


@contextmanager
def as_told(context: click.Context | None, examples: dict[str, str], commands: list[str]) -> Iterator[None]:
    """Turns what click says of wrong words into the one voice; help for a command without words stays as it is."""
    try:
        yield
    except click.exceptions.NoArgsIsHelpError:
        raise
    except click.UsageError as error:
        raise Told(_sentence(error, error.ctx or context, examples, commands)) from None


def _sentence(
    error: click.UsageError, context: click.Context | None, examples: dict[str, str], commands: list[str]
) -> str:
    if error.ctx is None and context is not None and isinstance(context.command, click.Group):
        inner = context.command.get_command(context, context.invoked_subcommand or "")
        if inner is not None:  # the words of this command were at fault, before it had a context of its own
            context = click.Context(inner, parent=context, info_name=inner.name)
    command = None if context is None else context.command
    path = "mpsolve" if context is None or context.parent is None else f"mpsolve {_path(context)}"
    example = examples.get(command.name or "") if command is not None else None
    advice = f"write it like {example}" if example else f"see {path} --help"
    words = error.message.rstrip(".")
    if isinstance(error, click.NoSuchOption):
        return _no_such_option(error, command, path)
    if isinstance(error, click.MissingParameter) and error.param is not None:
        return f"{_name(error.param)}: is missing: {advice}"
    if isinstance(error, click.BadParameter) and error.param is not None:
        value = re.match(r"'.*?'|\S+", words)
        return f"{_name(error.param)}: is {value[0] if value else 'not usable'}: {_wanted(error.param.type, words)}"
    if isinstance(error, click.BadOptionUsage):
        many = re.search(r"requires (\d+) arguments", words)
        return f"{error.option_name}: has {f'not all of its {many[1]} values' if many else 'no value'}: {advice}"
    unknown = re.search(r"No such command '(.*?)'", words)
    if unknown:
        from difflib import get_close_matches

        known = list(command.commands) if isinstance(command, click.Group) and path != "mpsolve" else commands
        near = get_close_matches(unknown[1], known, n=1, cutoff=0.5)
        return f"{unknown[1]}: is no command of {path}: {_meant(near, f'see {path} --help')}"
    extra = re.search(r"unexpected extra arguments? \((.*)\)", words)
    return f"{extra[1]}: is more than {path} takes: {advice}" if extra else f"{path}: {words}: {advice}"


def _no_such_option(error: click.NoSuchOption, command: click.Command | None, path: str) -> str:
    from difflib import get_close_matches

    name = error.option_name
    known = [one for parameter in (command.params if command else []) for one in parameter.opts]
    return f"{name}: is no option of {path}: {_meant(get_close_matches(name, known, n=1), f'see {path} --help')}"


def _meant(near: list[str], otherwise: str) -> str:
    return f"did you mean {near[0]}?" if near else otherwise


def _path(context: click.Context) -> str:
    above = context.parent
    inner = context.info_name or ""
    return f"{_path(above)} {inner}" if above is not None and above.parent is not None else inner


def _name(parameter: click.Parameter) -> str:
    """--output of an option, FILE of an argument."""
    if isinstance(parameter, click.Argument):
        return parameter.make_metavar(click.Context(click.Command("x"))).strip("[].")
    return max(parameter.opts, key=len)


def _wanted(kind: Any, words: str) -> str:
    if isinstance(kind, click.Choice):
        return f"give one of {', '.join(map(str, kind.choices))}"
    if isinstance(kind, click.IntRange):
        return f"give a whole number from {kind.min} to {kind.max}" if kind.max else f"give one from {kind.min}"
    return "give a whole number" if kind is click.INT else f"give another ({words})"
