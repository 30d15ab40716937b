"""Seeds: Newton's method by the oracle's residue sums, from all round the edge of each basin."""

from __future__ import annotations

import cmath
import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from oracle import Truth

from mpsolve import Case, certify
from mpsolve.batch.seeds import PARAMETERS, Seeds, seeds
from mpsolve.errors import InputError


@pytest.fixture(scope="module")
def table() -> Seeds:
    return seeds(["0.4", "1.2"], ["0.05", 0], [40], [2], mass_ratio=[1, 0])


def case_of(row: tuple[str, ...]) -> Case:
    eta, ratio = float(row[2]), float(row[6])
    masses = [eta, ratio * eta] if ratio else [eta]
    return Case(alpha=row[0], eta_b=row[1], eta_m=masses, positions=[0, row[3]][: len(masses)])


def test_every_root_of_every_case_has_a_row(table: Seeds) -> None:
    assert not table.undecided
    assert not table.missing
    assert table.roots.tolist() == [table.cases.count(case) for case in table.cases]
    rows = sorted(set(table.cases))
    assert len(rows) == 8
    for row in rows:
        expected = [complex(root.q.mid()) for root in certify(case_of(row), digits=30).roots]
        assert [q for q, other in zip(table.q.tolist(), table.cases, strict=True) if other == row] == expected


def test_newton_converges_from_the_rim_of_each_basin(table: Seeds) -> None:
    """With Δ from the paper's sums and a difference quotient: the distance halves with each step."""
    for row, seed, radius in zip(table.cases, table.q.tolist(), table.radius.tolist(), strict=True):
        truth = Truth(case_of(row), 30)
        root = truth.root(seed)
        assert radius > 1e-3 * abs(seed)
        for k in range(3):
            q = truth.mp.mpmathify(seed + radius * cmath.exp(1j * (1 + 2 * cmath.pi * k / 3)))
            for _ in range(2):
                step = truth.mp.mpf(10) ** -15 * abs(q)
                slope = (truth.delta(q + step) - truth.delta(q - step)) / (2 * step)
                after = q - truth.delta(q) / slope
                assert abs(after - root) <= abs(q - root) / 2 + 1e-12
                q = after


def test_basins_of_one_case_are_apart(table: Seeds) -> None:
    for row in set(table.cases):
        own = [k for k, other in enumerate(table.cases) if other == row]
        for j in own:
            for k in own:
                assert j == k or abs(table.q[j] - table.q[k]) > max(table.radius[j], table.radius[k])


def test_files_hold_the_same_numbers(table: Seeds, tmp_path: Path) -> None:
    with np.load(table.save(tmp_path / "seeds.npz")) as held:
        arrays = dict(held)
    assert np.array_equal(arrays["q"], table.q)
    assert np.array_equal(arrays["radius"], table.radius)
    assert list(zip(*(arrays[name].tolist() for name in PARAMETERS), strict=True)) == list(table.cases)
    rows = list(csv.DictReader(table.save(tmp_path / "seeds.csv").read_text().splitlines()))
    content = json.loads(table.save(tmp_path / "seeds.json").read_text())
    assert arrays["roots"].tolist() == [int(row["roots"]) for row in rows] == table.roots.tolist()
    assert [entry["roots"] for entry in content["seeds"]] == table.roots.tolist()
    assert content["missing"] == arrays["missing"].tolist() == arrays["missing_q"].tolist() == []
    assert len(rows) == len(content["seeds"]) == len(table.q)
    for row, entry, case, q, radius in zip(rows, content["seeds"], table.cases, table.q, table.radius, strict=True):
        assert tuple(row[name] for name in PARAMETERS) == tuple(entry["case"]) == case
        assert complex(float(row["q_re"]), float(row["q_im"])) == complex(*entry["q"]) == q
        assert float(row["radius"]) == entry["radius"] == radius


def test_bad_arguments(table: Seeds, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="output"):
        table.save(tmp_path / "seeds.txt")
    for values in (np.array(0.5), np.ones((1, 1))):
        with pytest.raises(InputError, match="alpha: is array"):
            seeds(values, [0.1], [10], [1])
    for change, key in (({"alpha": []}, "alpha"), ({"eta_b": [1]}, "eta_b"), ({"mass_ratio": [-1]}, "mass_ratio")):
        values = {"alpha": [0.5], "eta_b": [0.1], "eta_m": [10], "d": [1], **change}
        with pytest.raises(InputError) as caught:
            seeds(**values)
        assert caught.value.key == key


@pytest.mark.parametrize(
    ("given", "number"), [(("0.67", 0, 10, 3, "0.2"), 4), (("0.99", 0, 10, "0.5"), 2), (("0.5", "0.1", 10, 20), 8)]
)
def test_roots_next_to_the_cut_have_small_basins(given: tuple[Any, ...], number: int) -> None:
    """Clear of the cut only within some 1e-6 of their size."""
    found = seeds(*([value] for value in given))
    assert len(found.q) == number
    assert found.roots.tolist() == [number] * number
    assert not found.missing
    assert 0 < found.radius.min() < 1e-4


def test_roots_without_a_basin_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The others have rows, which tell that they are not all."""
    monkeypatch.setattr("mpsolve.batch.seeds._CIRCLES", 10)
    found = seeds(["0.67"], [0], [10], [3], eta_n=["0.2"])
    assert found.roots.tolist() == [4, 4]
    assert [case for case, _ in found.missing] == [found.cases[0]] * 2
    assert sorted(abs(q) for _, q in found.missing)[0] > 0.3 > abs(found.q[0])
    with np.load(found.save(tmp_path / "seeds.npz")) as held:
        arrays = dict(held)
    assert arrays["missing_q"].tolist() == [q for _, q in found.missing]
    assert [tuple(case) for case in arrays["missing"].tolist()] == [case for case, _ in found.missing]
    content = json.loads(found.save(tmp_path / "seeds.json").read_text())
    assert [complex(*entry["q"]) for entry in content["missing"]] == [q for _, q in found.missing]
