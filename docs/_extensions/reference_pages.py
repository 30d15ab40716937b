"""Pages of the reference, as the library tells them: models, commands, names, schemas."""

from __future__ import annotations

import inspect
import json
from pathlib import Path
from typing import Any

import click

ROOT = Path(__file__).resolve().parents[2]


def models() -> str:
    """Every track and vehicle: drawing, parameters, units, meaning."""
    from mpsolve import tracks, vehicles
    from mpsolve.numbers.model import defaults, quantities

    lines = ["# Models", "", "What `mpsolve models` prints, from the same description that checks every input.", ""]
    for title, catalogue in (("Tracks", tracks.CATALOGUE), ("Vehicles", vehicles.CATALOGUE)):
        lines += [f"## {title}", ""]
        for model in catalogue:
            lines += [f"### {model.__name__}", "", f'In files: `model = "{model.name}"`. {first_line(model)}', ""]
            lines += ["```text", model.drawing.rstrip("\n"), "```", ""] if model.drawing else []
            lines += ["| parameter | unit | meaning | bound | if left out |", "|---|---|---|---|---|"]
            left_out = defaults(model)
            for name, quantity in quantities(model).items():
                default = left_out.get(name, "must be given")
                cells = (
                    f"`{name}`",
                    quantity.unit,
                    quantity.meaning,
                    quantity.bound,
                    "none" if default is None else default,
                )
                lines.append("| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |")
            lines.append("")
    return "\n".join(lines)


def commands() -> str:
    """The help texts of all commands, as a terminal shows them."""
    from mpsolve import cli

    lines = ["# Commands", "", "What `mpsolve COMMAND --help` prints.", ""]
    group = cli.cli
    context = click.Context(group, info_name="mpsolve", max_content_width=90)
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        if command is None or command.hidden:
            continue
        inner = click.Context(command, info_name=f"mpsolve {name}", max_content_width=90)
        lines += [f"## {name}", "", "```text", command.get_help(inner), "```", ""]
    return "\n".join(lines)


def names() -> str:
    """The public names with their signatures and docstrings."""
    import mpsolve

    lines = ["# The library", "", "Everything that `mpsolve` exports.", ""]
    for name in mpsolve.__all__:
        value = getattr(mpsolve, name)
        lines += [f"## {name}", "", *source(value)]
        if inspect.ismodule(value):
            lines += [f"{first_line(value)} See [](models.md).", ""]
        else:
            lines += described(name, value)
    return "\n".join(lines)


def described(name: str, value: Any) -> list[str]:
    """Signature, docstring, and for a class its public properties and methods."""
    lines = signature(name, value) + prose(inspect.getdoc(value) or "")
    if not inspect.isclass(value) or issubclass(value, Exception):
        return lines
    for key, member in vars(value).items():
        documented = (
            inspect.getdoc(member) if isinstance(member, (property, classmethod)) or callable(member) else None
        )
        if key.startswith("_") or not documented or inspect.isclass(member):
            continue
        inner = member.__func__ if isinstance(member, classmethod) else member
        head = f"**{key}**" if isinstance(member, property) else f"**{key}**`{shape(inner)}`"
        lines += [f"- {head}: {escaped(' '.join(documented.split()))}"]
    return [*lines, ""]


def source(value: Any) -> list[str]:
    """The file in which it stands."""
    try:
        place = Path(inspect.getsourcefile(value) or "").resolve()
    except TypeError:
        return []
    return [f"In `{place.relative_to(ROOT)}`.", ""] if place.is_relative_to(ROOT) else []


def shape(value: Any) -> str:
    """The names of the arguments, without their types."""
    try:
        parameters = inspect.signature(value).parameters.values()
    except (TypeError, ValueError):
        return "(…)"
    bare = [p.replace(annotation=inspect.Parameter.empty) for p in parameters if p.name not in ("self", "cls")]
    return str(inspect.Signature(bare))


def signature(name: str, value: Any) -> list[str]:
    return ["```text", f"{name}{shape(value)}", "```", ""] if callable(value) else []


def prose(text: str) -> list[str]:
    """A docstring as paragraphs; examples and indented parts stay as they are typed."""
    lines: list[str] = []
    for paragraph in text.split("\n\n"):
        rows = paragraph.split("\n")
        if any(row.startswith((">>>", " ")) for row in rows):
            lines += ["```text", *rows, "```", ""]
        else:
            lines += [*map(escaped, rows), ""]
    return lines


def escaped(text: str) -> str:
    """Formulas in plain text are no markup, but code in backquotes is."""
    parts = text.split("`")
    for k in range(0, len(parts), 2):
        for mark in "\\*_[]<>|$":
            parts[k] = parts[k].replace(mark, "\\" + mark)
    return "`".join(parts)


def first_line(value: Any) -> str:
    return (inspect.getdoc(value) or "").split("\n")[0]


def schemas(folder: Path) -> str:
    """Every schema with its version and its keys at the top; the schemas themselves go into `folder`."""
    from mpsolve.schemas.catalogue import CATALOGUE

    folder.mkdir(parents=True, exist_ok=True)
    lines = ["# Schemas", "", "JSON Schemas (draft 2020-12), as `mpsolve schema NAME` prints them:", ""]
    lines += ["| NAME | of | version | keys |", "|---|---|---|---|"]
    for name, (told, make) in CATALOGUE.items():
        made = make()
        keys = ", ".join(f"`{key}`" for key in made.get("properties", {})) or "one of several forms"
        (folder / f"{name}.json").write_text(json.dumps(made, indent=1, ensure_ascii=False), encoding="utf-8")
        link, version = f"{{download}}`{name} <{folder.name}/{name}.json>`", made["$id"].rsplit("/", 1)[1]
        lines.append(f"| {link} | {told} | {version} | {keys} |")
    return "\n".join([*lines, "", "A later version of a kind adds keys, and changes the meaning of none.", ""])
