"""Files as text: numbers as they are written, keys with the nearest one, and what is no file of this kind."""

from __future__ import annotations

import datetime
from pathlib import Path

import pytest

from mpsolve.errors import InputError
from mpsolve.problem.inputfile import read_problem
from mpsolve.problem.toml import (
    MAX_BYTES,
    Written,
    check_keys,
    kind,
    name_of,
    parsed,
    refuse_other_kind,
    sources_of,
    text_of,
)


def test_numbers_stay_as_they_are_written() -> None:
    table = parsed('a = 0.10\nb = 1\nc = "0.10"\n', "x.toml")
    assert table == {"a": "0.10", "b": 1, "c": "0.10"}
    assert isinstance(table["a"], Written)
    assert not isinstance(table["c"], Written)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('{"format": 1}', "is JSON, not TOML"),
        ("a = ", "is not valid TOML"),
        ("a = 1" + "0" * 5000, "too many digits"),
        ("a = " + "[" * 100_000, "nested too deeply"),
    ],
)
def test_what_is_no_toml(text: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        parsed(text, "x.toml")


def test_texts_that_cannot_be_read(tmp_path: Path) -> None:
    whole, bad, large = (tmp_path / name for name in ("whole", "bad", "large"))
    whole.write_bytes(b"\xef\xbb\xbfa = 1")
    bad.write_bytes(b"a\xff")
    large.write_bytes(b"#" * (MAX_BYTES + 1))
    assert text_of(whole) == "a = 1"
    for path, words in (
        (bad, "has a character in line 1 that is not in UTF-8"),
        (large, "longer than"),
        (tmp_path, "is a directory"),
    ):
        with pytest.raises(InputError, match=words):
            text_of(path)
    with pytest.raises(InputError, match="does not exist"):
        text_of(tmp_path / "none")
    assert (name_of(Path("-")), name_of(Path("a.toml"))) == ("standard input", "a.toml")


def test_an_unknown_key_leads_to_the_nearest() -> None:
    check_keys({"EI": 1}, {"EI": "", "m": ""}, "track.")
    with pytest.raises(InputError, match=r"track\.ei: is unknown: did you mean EI\?"):
        check_keys({"ei": 1}, {"EI": "", "m": ""}, "track.")
    with pytest.raises(InputError, match="the keys here are EI, m"):
        check_keys({"zzz": 1}, {"EI": "", "m": ""}, "")


def test_another_kind_of_file_is_sent_to_its_command() -> None:
    refuse_other_kind({"track": {}}, {"track": ""}, Path("a.toml"))
    with pytest.raises(InputError, match=r"is a table, as its \[rows\] shows: use mpsolve table a\.toml"):
        refuse_other_kind({"rows": {}}, {"track": ""}, Path("a.toml"))


def test_kinds_are_named_as_toml_names_them() -> None:
    values = [True, 1, Written("1.0"), "1.0", [], {}, datetime.date(2020, 1, 1)]
    names = ["a boolean", "a number", "a number", "a text", "a list", "a table", "a date or time"]
    assert [kind(value) for value in values] == names


def test_a_distance_of_the_sleepers_leads_to_values_per_metre() -> None:
    with pytest.raises(InputError, match=r"track\.sleeper_spacing: is unknown: values are per metre of track, so"):
        check_keys({"sleeper_spacing": "0.6"}, {"m_sleeper": "mass"}, "track.")
    with pytest.raises(InputError, match=r"did you mean spacing\?"):
        check_keys({"spacings": "20"}, {"spacing": "distance"}, "vehicle[1].")


RAIL = Path("examples/rail_60e1.toml")


def test_file_track_and_vehicles_each_once() -> None:
    vehicle = {"source": ["a paper", "measured\n  by us."]}
    content = {"source": "a book", "track": {"source": "a plan"}, "vehicle": [vehicle, {}, vehicle]}
    assert sources_of(content) == ("a book", "Track: a plan", "Vehicle: a paper", "Vehicle: measured by us")
    assert sources_of({"track": 3, "vehicle": {}}) == ()


@pytest.mark.parametrize("given", [3, [""], ["a", 1], {}])
def test_what_is_no_text(given: object) -> None:
    with pytest.raises(InputError, match=r"^vehicle\[2\]\.source: is .*: write source"):
        sources_of({"vehicle": [{}, {"source": given}]})


def test_a_file_of_the_papers_beam_has_one_too(tmp_path: Path) -> None:
    file = tmp_path / "rail.toml"
    file.write_text('source = "a catalogue of rails"\n' + RAIL.read_text("utf-8"), "utf-8")
    assert read_problem(file).sources == ("a catalogue of rails",)
    assert read_problem(RAIL).sources == ()
