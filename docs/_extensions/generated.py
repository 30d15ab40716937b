"""Pages that the library writes about itself before the site is built: models, commands, names, figures."""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import os
import sys
from pathlib import Path
from typing import Any

import click
from presets_page import presets_page

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"


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
        lines += [f"## {name}", ""]
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


def schemas() -> str:
    """Every schema with its version and its keys at the top."""
    from mpsolve.schemas.catalogue import CATALOGUE

    lines = ["# Schemas", "", "`mpsolve schema NAME` prints a JSON Schema (draft 2020-12) of:", ""]
    lines += ["| NAME | of | version | keys |", "|---|---|---|---|"]
    for name, (told, make) in CATALOGUE.items():
        made = make()
        keys = ", ".join(f"`{key}`" for key in made.get("properties", {})) or "one of several forms"
        lines.append(f"| `{name}` | {told} | {made['$id'].rsplit('/', 1)[1]} | {keys} |")
    return "\n".join([*lines, "", "A later version of a kind adds keys, and changes the meaning of none.", ""])


def specifications() -> None:
    """The format of certificates, as it stands beside them."""
    for source in sorted((ROOT / "certs").glob("SPEC*.md")):
        write(DOCS / "reference" / "_generated" / source.name.lower(), source.read_text(encoding="utf-8"))


def gallery() -> str:
    """Every figure of the paper and of the findings, drawn now, with its code."""
    lines = [
        "# Gallery",
        "",
        "Each figure is drawn when this site is built; its numbers are asserted by its own `check()`.",
        "",
    ]
    for folder, title in (
        (ROOT / "examples" / "figures", "Figures of the paper"),
        (ROOT / "examples" / "findings", "Findings"),
    ):
        if not folder.is_dir():
            continue
        lines += [f"## {title}", ""]
        sys.path.insert(0, str(folder))
        try:
            for source in sorted(folder.glob("*.py")):
                lines += figure(source)
        finally:
            sys.path.remove(str(folder))
    return "\n".join(lines)


def figure(source: Path) -> list[str]:
    text = source.read_text(encoding="utf-8")
    if "def visualize(" not in text or "def check(" not in text:
        return []
    picture = DOCS / "gallery" / "_generated" / f"{source.stem}.svg"
    picture.parent.mkdir(parents=True, exist_ok=True)
    specification = importlib.util.spec_from_file_location(f"gallery_{source.stem}", source)
    if specification is None or specification.loader is None:
        return []
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    if not newer(picture, source):
        module.visualize(picture)
    about = first_line(module)
    heading, _, rest = about.partition(": ")
    return [
        f"### {heading}",
        "",
        rest,
        "",
        f"```{{figure}} {picture.name}",
        f":alt: {about}",
        "```",
        "",
        ":::{dropdown} Code",
        f"```{{literalinclude}} {os.path.relpath(source, picture.parent)}",
        ":language: python",
        "```",
        ":::",
        "",
    ]


def newer(picture: Path, source: Path) -> bool:
    """A picture of this build or of a build after the last change of its source and of the library."""
    if not picture.exists():
        return False
    library = max(path.stat().st_mtime for path in (ROOT / "mpsolve").rglob("*.py"))
    return picture.stat().st_mtime > max(source.stat().st_mtime, library)


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def generate(_app: Any) -> None:
    reference = DOCS / "reference" / "_generated"
    write(reference / "models.md", models())
    write(reference / "commands.md", commands())
    write(reference / "library.md", names())
    specifications()
    write(reference / "schemas.md", schemas())
    write(DOCS / "gallery" / "_generated" / "index.md", gallery())
    write(DOCS / "gallery" / "_generated" / "presets.md", presets_page(DOCS / "gallery" / "_generated"))


def setup(app: Any) -> dict[str, bool]:
    app.connect("builder-inited", generate)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
