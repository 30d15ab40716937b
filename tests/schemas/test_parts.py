"""The pieces of the schemas take what they say, and nothing else."""

from __future__ import annotations

import pytest
from schema_check import errors

from mpsolve.schemas import parts as p


@pytest.mark.parametrize(
    ("schema", "right", "wrong"),
    [
        (p.DECIMAL, "-1.5e-7", "1/3"),
        (p.RATIONAL, "-1/3", "0.5"),
        (p.COUNT, 0, -1),
        (p.YES, True, 1),
        (p.DIGITS, 1, 0),
        (p.STATUS, "proved", "sure"),
        (p.maybe(p.TEXT), None, 1),
        (p.rows(p.REAL), [1, 2.5], ["1"]),
        (p.by_name(p.TEXT), {"any": "text"}, {"any": 1}),
        (p.one_of(p.TEXT, p.WHOLE), 3, 3.5),
        (p.table({"a": p.REAL}, {"b": p.REAL}), {"a": 1, "b": 2}, {"b": 2}),
        (p.table({"a": p.REAL}), {"a": 1}, {"a": 1, "c": 1}),
        (p.DYADIC, [3, "-5"], [0.5]),
        (p.EXACT, {"exact": "1/3", "decimal": 0.3}, {"exact": "1/3"}),
    ],
)
def test_a_piece(schema: p.Schema, right: object, wrong: object) -> None:
    assert errors(right, schema) == []
    assert errors(wrong, schema)


def test_a_document_names_its_format_and_version() -> None:
    schema = p.document("poem", "Poem", "mpsolve poem", 2, {"lines": p.COUNT})
    right = {"format": "mpsolve poem", "version": 2, "lines": 4}
    assert errors(right, schema) == []
    assert errors(right | {"version": 1}, schema)
    assert errors(right | {"format": "poem"}, schema)
