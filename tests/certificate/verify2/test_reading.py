"""How files are read: numbers, lists and objects that are not what they should be, each for its own reason."""

from __future__ import annotations

import json

import pytest
from flint import fmpq
from forging import as_file, raw, stored

from mpsolve.certificate import verify2 as v2

RAW = raw("contact_wire")


def reason(**changed):
    return v2.verify_bytes(as_file(stored("contact_wire") | changed)).reason


HEADS = {
    "another format": ({"format": "mpsolve zeros"}, "format is not"),
    "another version": ({"version": 3}, "version 3 is not known"),
    "a version in text": ({"version": "2"}, "version 2 is not known"),
    "a key more": ({"more": 1}, "unknown: ['more']"),
    "bits that are too few": ({"bits": 52}, "bits is not an integer from 53 to 256"),
    "bits that are true": ({"bits": True}, "bits is not an integer"),
    "no list of roots": ({"roots": {}}, "roots: no list"),
    "too many roots": ({"roots": [0] * (v2.MAX_ROOTS + 1)}, "more than 1000 entries"),
    "no claim": ({"claim": []}, "an object is missing"),
}


@pytest.mark.parametrize("name", HEADS)
def test_a_file_is_refused(name):
    changed, why = HEADS[name]
    assert why in reason(**changed)


def test_a_version_that_is_true_is_none():
    head = {"format": "f", "version": True, "kind": "k"}
    with pytest.raises(v2.Refused, match="version True"):
        v2.opened(as_file(head), {"k": ""}, "f", 1)
    assert v2.opened(as_file(head | {"version": 1}), {"k": ""}, "f", 1)["version"] == 1


def test_another_content_than_the_digest_is_of_is_refused():
    content = stored("contact_wire")
    content["claim"]["count"] += 2
    assert v2.verify_bytes(json.dumps(content).encode()).reason == "the digest does not fit the content"
    del content["sha256"]
    assert "keys missing: ['sha256']" in v2.verify_bytes(json.dumps(content).encode()).reason


def test_a_key_that_stands_twice_is_refused():
    assert "twice" in v2.verify_bytes(RAW.replace(b'"count"', b'"count": 0, "count"', 1)).reason


def test_a_file_is_read_up_to_a_size(tmp_path):
    file = tmp_path / "long"
    file.write_bytes(b"12345")
    for most, valid in ((5, True), (4, False)):
        verdict = v2.of_file(file, lambda raw, most=most: v2.judged(raw, lambda: "all", most), most)
        assert verdict.valid is valid
    assert "larger than 4 bytes" in verdict.reason


NUMBERS = {
    "a float": (lambda: v2.integer(1.0, 0, 2, "n"), "n is not an integer"),
    "true": (lambda: v2.integer(True, 0, 2, "n"), "n is not an integer"),
    "too small": (lambda: v2.integer(-1, 0, 2, "n"), "n is not an integer"),
    "too large": (lambda: v2.integer(3, 0, 2, "n"), "n is not an integer"),
    "no text": (lambda: v2.rational(1, "x"), "x is not a rational"),
    "over nothing": (lambda: v2.rational("1/0", "x"), "x is not a rational"),
    "a newline": (lambda: v2.rational("1\n", "x"), "x is not a rational"),
    "other digits": (lambda: v2.rational("٣", "x"), "x is not a rational"),
    "too many digits": (lambda: v2.rational("1" * 121, "x"), "x is not a rational"),
    "three of two": (lambda: v2.dyadic([1, 2, 3], "d"), "d: no list, or more than 2"),
    "one of two": (lambda: v2.dyadic([1], "d"), "d: 1 entries in place of 2"),
    "a long mantissa": (lambda: v2.dyadic([2**201, 0], "d"), "d is not an integer"),
    "a large exponent": (lambda: v2.dyadic([1, 1101], "d"), "d is not an integer"),
    "text for a list": (lambda: v2.items("ab", 2, "l"), "l: no list"),
    "one number": (lambda: v2.point([1]), "two or three"),
    "four numbers": (lambda: v2.point([1, 1, 1, 1]), "more than 3"),
    "a decimal mantissa": (lambda: v2.read_ball({"m": "12"}, "m", "b"), "not hexadecimal"),
    "capital letters": (lambda: v2.read_ball({"m": "0xA"}, "m", "b"), "not hexadecimal"),
    "a number for a mantissa": (lambda: v2.read_ball({"m": 12}, "m", "b"), "not hexadecimal"),
    "a radius of 0": (lambda: v2.read_ball({"m": "0x1", "exponent": 0, "radius": [0, 0]}, "m", "b"), "from 1 to"),
    "a matrix too high": (lambda: v2.matrix([["1"], ["1"]], 1, 1, "M"), "more than 1 entries"),
    "a matrix too narrow": (lambda: v2.matrix([[]], 1, 1, "M"), "0 entries in place of 1"),
}


@pytest.mark.parametrize("name", NUMBERS)
def test_a_number_is_refused(name):
    read, why = NUMBERS[name]
    with pytest.raises(v2.Refused, match=why):
        read()


def test_numbers_that_are_fine():
    assert v2.integer(2, 0, 2, "n") == 2
    assert v2.rational("-" + "1" * 120 + "/3", "x") == -fmpq(int("1" * 120), 3)
    assert v2.dyadic([-3, -1], "d") == fmpq(-3, 2)
    assert v2.point([3, -1, 1]) == (6, -2) == v2.point(["6", "-4/2"])
    ball = {"m": "-0xa", "exponent": 1, "radius": [3, -1]}
    assert v2.read_ball(ball, "m", "b") == ([fmpq(-20)], fmpq(3, 2), 6)
