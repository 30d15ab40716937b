"""What examples/handover hands over is read by others as it stands, and leads them to the certified roots."""

from __future__ import annotations

import csv
import importlib.util
import json
import re
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from mpsolve import Case, certify

FOLDER = Path(__file__).parents[1] / "examples" / "handover"


@pytest.fixture(scope="module")
def solver() -> ModuleType:
    spec = importlib.util.spec_from_file_location("other_solver", FOLDER / "other_solver.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def folder(solver: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("handover")
    assert [path.name for path in solver.write(place)] == ["seeds.csv", "seeds.json", "seeds.npz", "receptance.csv"]
    return place


def test_newton_from_the_seeds_finds_the_certified_roots(solver: ModuleType, folder: Path) -> None:
    found = solver.newton(folder / "seeds.csv")
    roots = []
    for alpha in solver.GRID["alpha"]:
        case = Case(alpha=alpha, eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
        roots += [complex(root.q.mid()) for root in certify(case).roots]
    assert len(found) == len(roots)
    for (seed, root, radius), truth in zip(found, roots, strict=True):
        assert abs(seed - truth) < 1e-14
        assert abs(root - truth) < 1e-9
        assert radius > 1e-3


def test_all_forms_hold_the_same_seeds(folder: Path) -> None:
    with (folder / "seeds.csv").open() as stream:
        rows = list(csv.DictReader(stream))
    content = json.loads((folder / "seeds.json").read_text())
    with np.load(folder / "seeds.npz") as arrays:
        q = arrays["q"]
    assert [complex(float(row["q_re"]), float(row["q_im"])) for row in rows] == q.tolist()
    assert [complex(*seed["q"]) for seed in content["seeds"]] == q.tolist()


def test_the_matlab_and_maple_readers_name_the_columns_that_are_there(folder: Path) -> None:
    """Neither program is at hand in the tests: what can be held is that the names and their forms agree."""
    header = (folder / "seeds.csv").read_text().splitlines()[0].split(",")
    used = set(re.findall(r"table\.(\w+)\(", (FOLDER / "read_seeds.m").read_text()))
    used |= set(re.findall(r'column\("(\w+)"\)', (FOLDER / "read_seeds.mpl").read_text()))
    assert {"alpha", "eta_b", "eta_m", "d", "q_re", "q_im"} <= used <= set(header)


def test_the_receptance_table_and_the_onset(solver: ModuleType, folder: Path) -> None:
    with (folder / "receptance.csv").open() as stream:
        rows = list(csv.reader(stream))
    assert rows[0][:3] == ["omega", "re_K(-1.5)", "im_K(-1.5)"]
    assert len(rows) == 1 + len(solver.OMEGA)
    assert solver.onset() == "0.666918957285"
