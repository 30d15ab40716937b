"""Arrays and data frames of a study hold what the study says, entry by entry."""

from __future__ import annotations

import json
from itertools import zip_longest

import numpy as np
import pytest

from mpsolve import InputError, Study
from mpsolve.studies.arrays import stored_results
from mpsolve.studies.blocks import STATUSES
from mpsolve.studies.columns import parameter_titles
from mpsolve.studies.spec import read_spec
from mpsolve.studies.store import Store


def test_npz(made: Study) -> None:
    with np.load(made.save(made.path.with_suffix(".npz"))) as held:
        arrays = dict(held)
    assert arrays["q"].shape[0] == made.total
    assert arrays["status_names"].tolist() == list(STATUSES[made.spec.kind])
    for k, (index, values, result) in enumerate(made.results()):
        assert arrays["index"][k] == index
        for title, value in zip(parameter_titles(made.spec), values.values(), strict=True):
            assert arrays[title][k] == float(value)
        assert arrays["status_names"][arrays["status"][k]] == result.status
        assert arrays["count"][k] == (-1 if result.count is None else result.count)
        assert arrays["unstable"][k] == (-1 if result.unstable is None else result.unstable)
        for q, root in zip_longest(arrays["q"][k], result.roots):
            assert q == complex(float(root.re), float(root.im)) if root else np.isnan(q)


def test_parquet(made: Study) -> None:
    parquet = pytest.importorskip("pyarrow.parquet", reason="Parquet needs the extra `parquet`")
    table = parquet.read_table(made.save(made.path.with_suffix(".parquet")))
    assert read_spec(json.loads(table.schema.metadata[b"mpsolve"])).canonical == made.spec.canonical
    for row, (index, values, result) in zip(table.to_pylist(), made.results(), strict=True):
        assert (row["index"], row["status"], row["reason"]) == (index, result.status, result.reason)
        assert [row[title] for title in parameter_titles(made.spec)] == [float(x) for x in values.values()]
        assert (row["count"], row["unstable"]) == (result.count, result.unstable)
        assert row["re"] == [float(root.re) for root in result.roots]
        assert row["multiplicity"] == [root.multiplicity for root in result.roots]
        if made.spec.kind == "certified":
            assert row["im_text"] == [root.im for root in result.roots]


def test_without_pyarrow(made: Study, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "pyarrow", None)
    with pytest.raises(InputError, match=r"pip install 'mpsolve\[parquet\]'"):
        made.save(made.path.with_name("other.parquet"))
    assert not made.path.with_name("other.parquet").exists()


def test_from_any_index_on(made: Study) -> None:
    with Store.create(made.path, made.spec) as store:
        whole = list(stored_results(store))
        assert [index for index, _, _ in whole] == list(range(made.total))
        assert [values for _, values, _ in whole] == [made.spec.values(k) for k in range(made.total)]
        for start in (1, made.total - 1, made.total):
            assert list(stored_results(store, start)) == whole[start:]
