"""Where what stands in the source: each room with its own first sentence, in the order of imports."""

from __future__ import annotations

import ast
import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HEAD = """# Finding one's way in the source

Imports point upstream only: a room knows those below it in this list. `lint-imports` and `tests/test_imports.py` hold
that, in the order that `pyproject.toml` gives. Tests stand in the same tree under `tests/`;
`tests/bench` prints the speed as ratios.

"""


def layout_page() -> str:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    layers = next(one["layers"] for one in settings["tool"]["importlinter"]["contracts"] if one["id"] == "layers")
    rows = [name for layer in layers for name in re.findall(r"\w+", layer) if not name.startswith(("__", "cli_"))]
    return HEAD + "\n".join(f"- `{name}`: {first_sentence(name)}" for name in rows) + "\n"


def first_sentence(name: str) -> str:
    """What a room or a module says of itself first."""
    room = ROOT / "mpsolve" / name
    source = room / "__init__.py" if room.is_dir() else room.with_suffix(".py")
    told = ast.get_docstring(ast.parse(source.read_text(encoding="utf-8"))) or ""
    return told.split("\n")[0]
