"""Values flow one way: no import of the package points downstream or lies on a circle, wherever it stands in a file.

The order of the rooms stands in pyproject.toml, where `lint-imports` reads it too.
"""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
CONTRACT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["importlinter"]["contracts"][0]
RANK = {room: rank for rank, line in enumerate(reversed(CONTRACT["layers"])) for room in re.findall(r"\w+", line)}
SIDE_BY_SIDE = [set(re.findall(r"\w+", line)) for line in CONTRACT["layers"] if "|" in line]
PACKAGE = "mpsolve"
VERIFIER = "mpsolve.certificate.verify2"
OTHERS = ("mpsolve.certificate.verify_ranges", "mpsolve.certificate.verify_roots")
UPWARD = ("mpsolve.display", "mpsolve.notebook")
FRONT_DOORS = {"mpsolve"}
DOORS_OF_COMMANDS = {"mpsolve.cli", "mpsolve.page.paper"}  # a command by its name; a printer that may be missing
PRECISION = {"mpsolve.numbers.balls", VERIFIER}

Graph = Mapping[str, Iterable[str]]
Import = tuple[str, str | None]
"""A module, and a name of it that is no module."""


def source_files() -> dict[str, ast.Module]:
    """The modules of the package by their names."""
    trees = {}
    for file in sorted((ROOT / PACKAGE).rglob("*.py")):
        parts = file.relative_to(ROOT).with_suffix("").parts
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        trees[name] = ast.parse(file.read_text("utf-8"))
    return trees


def at_run_time(node: ast.AST) -> Iterator[ast.AST]:
    """The node and what stands in it, without what only a type checker reads."""
    yield node
    only_types = isinstance(node, ast.If) and ast.unparse(node.test).split(".")[-1] == "TYPE_CHECKING"
    for child in node.orelse if only_types else ast.iter_child_nodes(node):
        yield from at_run_time(child)


def imports(name: str, tree: ast.Module, modules: Iterable[str]) -> Iterator[Import]:
    """What the module imports of the package, in functions too."""
    known = set(modules)
    for node in at_run_time(tree):
        if isinstance(node, ast.Import):
            yield from ((one.name, None) for one in node.names if one.name.split(".")[0] == PACKAGE)
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, f"{name} imports relatively: write the whole name"
            if node.module and node.module.split(".")[0] == PACKAGE:
                for one in node.names:
                    whole = f"{node.module}.{one.name}"
                    yield (whole, None) if whole in known else (node.module, one.name)


def circle(graph: Graph) -> list[str]:
    """The modules of one circle, empty if there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def room(module: str) -> str:
    return module.split(".")[1]


def downstream(module: str, other: str) -> bool:
    """Whether the room of the other module stands above that of the first, or beside it where rooms are apart."""
    here, there = room(module), room(other)
    if here == there:
        return False
    return RANK[there] > RANK[here] or any({here, there} <= rooms for rooms in SIDE_BY_SIDE)


def private(name: str | None) -> bool:
    return name is not None and name.startswith("_") and not name.endswith("__")


def shared(node: ast.AST) -> bool:
    """Whether this is flint's context or mpmath's global one; an arithmetic may have an mpmath context of its own."""
    owner, _, last = ast.unparse(node).rpartition(".")
    return last in ("ctx", "mp") and owner != "self"


def touches_precision(tree: ast.AST) -> bool:
    """Whether the precision of a shared context is set, or one of its methods is asked to do so."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and shared(node.value):
            if node.attr in ("workprec", "workdps", "extraprec", "extradps"):
                return True
            if node.attr in ("prec", "dps") and isinstance(node.ctx, ast.Store):
                return True
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "setattr" and shared(node.args[0]):
            return True
    return False


TREES = source_files()
IMPORTS = {name: sorted(set(imports(name, tree, TREES)), key=str) for name, tree in TREES.items()}
GRAPH = {name: {other for other, _ in found if other != name} for name, found in IMPORTS.items()}


def test_every_room_has_a_place_in_the_order() -> None:
    assert {room(name) for name in TREES if name != PACKAGE} <= set(RANK)


def test_no_import_points_downstream() -> None:
    pairs = [(name, other) for name, others in GRAPH.items() for other in others if PACKAGE not in (name, other)]
    assert len(pairs) > 500
    wrong = [pair for pair in pairs if downstream(*pair)]
    assert wrong == [UPWARD]


def test_no_modules_import_each_other_in_a_circle() -> None:
    graph = {name: others - {UPWARD[1]} if name == UPWARD[0] else others for name, others in GRAPH.items()}
    assert circle(graph) == []


def test_the_verifiers_stand_on_that_of_spectra_alone() -> None:
    assert not IMPORTS[VERIFIER]
    assert all({name for name, _ in IMPORTS[other]} <= {VERIFIER, "mpsolve.certificate"} for other in OTHERS)


def test_only_the_front_door_loads_modules_by_name() -> None:
    """No reader and no tool sees what a text imports; only claims load what stands outside, a paper's folder.

    The doors themselves import nothing when they are loaded.
    """
    loading = {name for name, tree in TREES.items() if "import_module" in ast.unparse(tree)}
    assert {name for name in loading if not name.startswith(f"{PACKAGE}.claims.")} == FRONT_DOORS | DOORS_OF_COMMANDS
    assert all(IMPORTS[name] == [] for name in FRONT_DOORS)


def test_names_are_imported_from_where_they_are_and_only_public_ones() -> None:
    """From a door that loads modules by name nothing comes inside but the version."""
    named = [(name, *one) for name, found in IMPORTS.items() for one in found]
    assert [one for one in named if one[1] in FRONT_DOORS and one[2] not in (None, "__version__")] == []
    assert [one for one in named if private(one[2]) or private(one[1].split(".")[-1])] == []


def test_one_module_touches_the_precision_that_the_process_shares() -> None:
    """Threads would change it for each other: balls.py has the lock. The verifiers stand alone."""
    assert {name for name, tree in TREES.items() if touches_precision(tree)} == PRECISION


@pytest.mark.parametrize(
    "text",
    [
        "import mpsolve.report.models",
        "from mpsolve.report import models",
        "from mpsolve.report.models import document",
        "def f():\n    from mpsolve.report.models import document",
        "if x:\n    pass\nelse:\n    import mpsolve.report.models as t",
        "if TYPE_CHECKING:\n    pass\nelse:\n    import mpsolve.report.models",
    ],
)
def test_an_import_is_seen_wherever_it_stands(text: str) -> None:
    ((module, _),) = imports("mpsolve.waves.dispersion", ast.parse(text), TREES)
    assert module == "mpsolve.report.models"
    assert downstream("mpsolve.waves.dispersion", module)
    assert not downstream("mpsolve.notebook", module)
    assert downstream("mpsolve.tracks.string", "mpsolve.vehicles.mass")  # side by side


@pytest.mark.parametrize("guard", ["TYPE_CHECKING", "typing.TYPE_CHECKING"])
def test_an_import_for_types_only_is_none(guard: str) -> None:
    assert list(imports("mpsolve.files", ast.parse(f"if {guard}:\n    import mpsolve.report.models"), TREES)) == []


def test_circles_of_any_length_are_seen() -> None:
    assert circle({"a": {"b"}, "b": {"c"}, "c": ()}) == []
    assert set(circle({"a": {"b"}, "b": {"a"}})) == {"a", "b"}
    assert set(circle({"x": {"a"}, "a": {"b"}, "b": {"c"}, "c": {"a"}})) == {"a", "b", "c"}


@pytest.mark.parametrize(
    "text",
    ["flint.ctx.prec = 9", "ctx.dps += 9", "with mpmath.mp.workprec(9): pass", 'setattr(flint.ctx, "prec", 9)'],
)
def test_a_touched_precision_is_seen(text: str) -> None:
    assert touches_precision(ast.parse(text))


@pytest.mark.parametrize("text", ["tiny = 2.0 ** -flint.ctx.prec", "self.context.prec = 9", "self.mp.dps = 9"])
def test_a_precision_that_is_read_or_own_is_left_alone(text: str) -> None:
    assert not touches_precision(ast.parse(text))
