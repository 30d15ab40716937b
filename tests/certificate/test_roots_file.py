"""Certificates of zeros are exact JSON: they read back to the same numbers, and hold no floats."""

from __future__ import annotations

import json
from fractions import Fraction

from mpsolve import Cut, Rectangle, roots


def test_everything_in_the_file_is_exact() -> None:
    answer = roots("sqrt(z) - 1/3", Rectangle("-1/3", 2, -1, 1), cuts=[Cut.ray(0, -1)], digits=40)

    def no_float(text: str) -> None:
        raise AssertionError(text)

    content = json.loads(answer.certificate.text, parse_float=no_float)
    assert content["counted"][0] == ["-1/3", "-1"]
    (root,) = content["roots"]
    value = Fraction(int(root["re"], 16)) * Fraction(2) ** root["exponent"]
    m, e = root["radius"]
    assert abs(value - Fraction(1, 9)) < Fraction(m) * Fraction(2) ** e < Fraction(1, 10**39)
    for row in content["breaks"]:
        assert row["places"][0] == 0
        assert row["places"][-1] == 2 ** row["exponent"]
