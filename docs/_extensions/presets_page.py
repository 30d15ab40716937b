"""The gallery of presets: each track under its usual vehicle, drawn, with its numbers and what `certify` says now."""

from __future__ import annotations

import tempfile
from pathlib import Path

from mpsolve import Effort, certify, read_problem
from mpsolve.numbers.spoken import beside
from mpsolve.page.page import tables_of
from mpsolve.pictures.axes import alone
from mpsolve.pictures.model import model_picture
from mpsolve.presets.written import Preset, input_file, names, preset
from mpsolve.problem.problem import Problem
from mpsolve.report.spectrum_words import verdict

SECONDS = 60.0


def presets_page(folder: Path) -> str:
    """The page in MyST; drawings go into `folder`."""
    lines = [
        "# Presets",
        "",
        "Each track of `mpsolve new`, under the vehicle that it is tried with. Drawings, numbers and verdicts were",
        "made by the library when this site was built; what the sources leave open is assumed, as they say.",
        "",
    ]
    for name in names("track"):
        lines += _section(preset("track", name), folder)
    lines += ["## Vehicles", "", "Each runs on any track of its kind: `mpsolve new TRACK --vehicle NAME`.", ""]
    for name in names("vehicle"):
        one = preset("vehicle", name)
        lines += [f"- `{name}`: {one.title}. {'; '.join(one.sources)}."]
    return "\n".join(lines) + "\n"


def problem_of(name: str) -> Problem:
    """What the file that `mpsolve new NAME` writes holds."""
    with tempfile.TemporaryDirectory() as place:
        file = Path(place) / "new.toml"
        file.write_text(input_file(name), encoding="utf-8")
        return read_problem(file).problem


def _section(one: Preset, folder: Path) -> list[str]:
    problem = problem_of(one.name)
    found = certify(problem, region="unstable", digits=15, effort=Effort(seconds=SECONDS))
    drawing = folder / f"preset-{one.name}.svg"
    folder.mkdir(parents=True, exist_ok=True)
    drawing.write_text(alone(model_picture(problem)), encoding="utf-8")
    rows = [row for _, table in tables_of(problem) for row in table]
    return [
        f"## {one.title}",
        "",
        f"`mpsolve new {one.name}`: {beside(problem.v, 'm/s')}, {preset('vehicle', one.vehicle).title}.",
        "",
        f"```{{image}} {drawing.name}",
        f":alt: {one.title}",
        "```",
        "",
        f"**{verdict(found)}**" + (f" ({found.status.value})" if found.proved else ""),
        "",
        *(f"- {source}." for source in one.sources),
        "",
        ":::{dropdown} Its numbers",
        "| name | value | meaning |",
        "|---|---|---|",
        *(f"| `{name}` | {value} | {meaning} |" for name, value, meaning in rows),
        ":::",
        "",
    ]
