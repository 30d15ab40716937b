"""The results that a store holds, one block in memory at a time."""

from __future__ import annotations

from collections.abc import Iterator

from mpsolve.studies.blocks import Result, checked
from mpsolve.studies.design import Value
from mpsolve.studies.store import Store


def stored_results(store: Store, start: int = 0) -> Iterator[tuple[int, dict[str, Value], Result]]:
    """(index, exact parameters, result) of each finished entry from the index `start` on.

    Raises StudyError if the file is damaged.
    """
    spec = store.spec
    for block in store.blocks(start // spec.block):
        for index, (values, result) in zip(
            spec.indices(block.number), zip(*checked(spec, block, store.path), strict=True), strict=True
        ):
            if index >= start:
                yield index, values, result
