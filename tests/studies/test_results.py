"""Stored results come block by block in their order, from any index on."""

from __future__ import annotations

from mpsolve import Study
from mpsolve.studies.results import stored_results
from mpsolve.studies.store import Store


def test_from_any_index_on(made: Study) -> None:
    with Store.create(made.path, made.spec) as store:
        whole = list(stored_results(store))
        assert [index for index, _, _ in whole] == list(range(made.total))
        assert [values for _, values, _ in whole] == [made.spec.values(k) for k in range(made.total)]
        for start in (1, made.total - 1, made.total):
            assert list(stored_results(store, start)) == whole[start:]
