"""Exports: one content in four formats, of any number of cases in a bounded memory."""

from __future__ import annotations

import csv
import json
import tracemalloc
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mpsolve import InputError, Study, StudyError, open_study, study
from mpsolve.errors import CertificateError
from mpsolve.studies.arrays import write_npz, write_parquet
from mpsolve.studies.blocks import Block, Result, Root, key, pack
from mpsolve.studies.columns import parameter_titles, root_titles
from mpsolve.studies.export import KINDS, value_text, write_csv, write_json
from mpsolve.studies.spec import read_spec
from mpsolve.studies.store import Store

MASS: dict[str, Any] = {"alpha": "0.5", "eta_b": "0.05", "eta_m": [40], "positions": [0]}


def test_csv(made: Study) -> None:
    with made.save(made.path.with_suffix(".csv")).open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == made.total
    for row, (index, values, result) in zip(rows, made.results(), strict=True):
        assert int(row["index"]) == index
        for title, value in zip(parameter_titles(made.spec), values.values(), strict=True):
            exact = value_text(value)
            assert row[title] == (repr(float(value)) if "/" in exact else exact)
            assert float(row[title]) == float(value)
            assert "/" in exact or Fraction(row[title]) == value
        assert (row["status"], row["reason"]) == (result.status, result.reason)
        assert row["count"] == ("" if result.count is None else str(result.count))
        for k, root in enumerate(result.roots, 1):
            re, im = root_titles(made.spec, k)
            assert (row[re], row[im]) == (str(root.re), str(root.im))
        assert row.get(root_titles(made.spec, result.width + 1)[0], "") == ""


def test_json(made: Study) -> None:
    text = made.save(made.path.with_suffix(".json")).read_text("utf-8")
    content = json.loads(text)
    assert read_spec(content["spec"]).canonical == made.spec.canonical
    assert (content["total"], content["tally"]) == (made.total, dict(made.tally))
    for line, case, (index, values, result) in zip(
        text.splitlines()[-made.total - 1 : -1], content["entries"], made.results(), strict=True
    ):
        assert json.loads(line.removesuffix(",")) == case
        assert case["index"] == index
        assert case["parameters"] == {name: value_text(value) for name, value in values.items()}
        assert case["values"] == {name: float(value) for name, value in values.items()}
        assert (case["status"], case["count"], case["unstable"]) == (result.status, result.count, result.unstable)
        for entry, root in zip(case["roots"], result.roots, strict=True):
            if made.spec.kind == "float64":
                assert entry == [root.re, root.im]
            else:
                assert entry["re"] == {"value": root.re, "radius": root.re_radius}
                assert float(entry["im"]["radius"]) < 1e-24


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (Fraction(67, 100), "0.67"),
        (Fraction(100), "100"),
        (Fraction(1, 3), "1/3"),
        (Fraction(1, 10**9), "0.000000001"),
        (Fraction(1, 10**30), f"1/{10**30}"),
        (Fraction(1234567890123456, 10), "617283945061728/5"),
    ],
)
def test_values_are_written_exactly(value: Any, text: str) -> None:
    assert value_text(value) == text


def test_a_multiple_root_stands_as_often_as_it_counts(tmp_path: Path, certified: dict[str, Any]) -> None:
    path, spec = tmp_path / "study.sqlite", read_spec(certified)
    double = Result("proved", "", 3, 0, (Root("0.1", "0.2", "1e-9", "1e-9", 2, "none"), Root("3", "4", "0", "0")))
    with Store.create(path, spec) as store:
        store.put(Block(0, key(spec, [spec.values(0)]), pack([double]), 3, '{"proved": 1}').sealed)
    lines = open_study(path).save(tmp_path / "a.csv").read_text("utf-8").splitlines()
    assert lines[0].endswith("re_1,im_1,re_2,im_2,re_3,im_3")
    assert lines[1].endswith("0.1,0.2,0.1,0.2,3,4")
    with np.load(open_study(path).save(tmp_path / "a.npz")) as held:
        q = held["q"]
    assert q.tolist() == [[0.1 + 0.2j, 0.1 + 0.2j, 3 + 4j]]


def test_a_file_is_written_whole_or_not_at_all(tmp_path: Path, certified: dict[str, Any]) -> None:
    made = study(certified, store=tmp_path / "study.sqlite", workers=1)
    with Store.create(made.path, made.spec) as store:
        last = list(store.blocks())[-1]
        store.put(
            Block(
                last.number,
                last.key,
                pack([Result("proved", "damaged", 9, 9, ())]),
                last.width,
                last.tally,
                last.seal,
            )
        )
    for kind in KINDS:
        file = tmp_path / f"a.{kind}"
        file.write_text("before")
        with pytest.raises(StudyError, match="damaged results of the entries 3 to 3"):
            made.save(file)
        assert file.read_text() == "before"
    with pytest.raises(InputError, match=r"does not end in \.csv, \.json, \.npz, \.parquet"):
        made.save(tmp_path / "a.txt")
    with pytest.raises(CertificateError, match="cannot be written"):
        made.save(tmp_path / "none" / "a.csv")
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        ["study.sqlite", *(f"a.{kind}" for kind in KINDS)]
    )


def test_nothing_to_export(tmp_path: Path, certified: dict[str, Any]) -> None:
    Store.create(tmp_path / "study.sqlite", read_spec(certified)).__exit__(None, None, None)
    with pytest.raises(StudyError, match="holds no results"):
        open_study(tmp_path / "study.sqlite").save(tmp_path / "a.csv")


@pytest.mark.parametrize("writer", [write_csv, write_json, write_npz, write_parquet], ids=lambda f: f.__name__)
def test_memory_does_not_grow_with_the_study(tmp_path: Path, writer: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Four times as many cases take less than twice the memory, far below 500 MB."""
    if writer is write_parquet:
        pytest.importorskip("pyarrow", reason="Parquet needs the extra `parquet`")
    monkeypatch.setattr("mpsolve.studies.spec._BLOCK", (400, 400))  # less work than real blocks
    monkeypatch.setattr("mpsolve.studies.arrays._ROWS", 300)  # so that blocks and rows take turns
    parameters = {"v": {"start": 0, "stop": 1, "step": "1e-4"}}
    spec = read_spec({"study": {"kind": "float64"}, "dimensionless": MASS, "parameters": parameters})
    result = Result("ok", "", 2, 0, (Root(-0.5, 0.25), Root(0.5, 0.25)))
    peaks = []
    for blocks in (2, 8):
        path = tmp_path / f"{blocks}.sqlite"
        with Store.create(path, spec) as store:
            for number in range(blocks):
                indices = spec.indices(number)
                name = key(spec, [spec.values(index) for index in indices])
                data = pack([result] * len(indices))
                store.put(Block(number, name, data, 2, json.dumps({"ok": len(indices)})).sealed)
        with Store.read(path) as store, path.with_suffix(".out").open("wb") as target:
            tracemalloc.start()
            writer(store, target)
            peaks.append(tracemalloc.get_traced_memory()[1])
            tracemalloc.stop()
    assert peaks[1] < 2 * peaks[0] < 100e6
