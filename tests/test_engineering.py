"""What an engineer works out, against the same by hand, and the file takes the line."""

from __future__ import annotations

from fractions import Fraction
from math import pi

import pytest

from mpsolve import tracks
from mpsolve.engineering import Worked, foundation, per_metre, pinned_pinned, rail_damping, thermal_force, viscous
from mpsolve.errors import InputError
from mpsolve.numbers.units import in_unit


def test_rail_seats_per_metre() -> None:
    pads, damping, sleepers = per_metre("180 kN/mm", "60 cm", "18 kN s/m", "150 kg")
    assert [one.value for one in (pads, damping, sleepers)] == [300 * 10**6, 30_000, 250]
    assert pads.line == 'k_pad = "300 MN/m²"'
    assert "180 kN/mm / 0.6 m = 3e8 N/m² (300 MN/m²)" in pads.text
    assert len(per_metre(1, 1)) == 1


def test_a_layer_names_its_keys_and_a_whole_sleeper_is_asked_about() -> None:
    assert [one.key for one in per_metre("60 kN/mm", 1, 100, 300, layer="ballast")] == [
        "k_ballast", "c_ballast", "m_ballast",
    ]  # fmt: skip
    (half,) = per_metre(None, "0.6 m", mass="145 kg", layer="sleepers")
    assert half.line == 'm_sleeper = "725/3 kg/m"  # 241.7 kg/m'
    assert "whole sleeper" not in half.assumes
    (whole,) = per_metre(None, "0.6 m", mass="290 kg")
    assert whole.assumes.startswith("Is 290 kg the whole sleeper? One rail carries half of it.")
    with pytest.raises(InputError, match="k: is missing, and so are c and m"):
        per_metre(None, 1)
    with pytest.raises(InputError, match="m: has no place in the layer ground"):
        per_metre(1, 1, 0, 5, layer="ground")
    with pytest.raises(InputError, match="layer: is 'rail': give one of pads"):
        per_metre(1, 1, layer="rail")


def test_series() -> None:
    assert foundation("180 kN/mm", "60 kN/mm", "0.6 m").value == Fraction(45 * 10**6 * 10, 6)


def test_the_damper_loses_as_much_at_its_frequency() -> None:
    k, loss, f = 3e8, 0.2, 100
    c = float(viscous("300 MN/m²", loss, "100 Hz").value)
    assert (k + 1j * 2 * pi * f * c).imag == pytest.approx(loss * k)
    eta = float(rail_damping("0.02", 500).value)
    assert (1 + 1j * 2 * pi * 500 * eta).imag == pytest.approx(0.02)


def test_a_warm_rail_is_compressed() -> None:
    found = thermal_force("76.7 cm²", "30 K")
    assert found.value == Fraction("210e9") * Fraction("76.7e-4") * Fraction("1.15e-5") * 30
    assert found.line == 'N = "555.6915 kN"'
    assert thermal_force("76.7 cm²", -30).value == -found.value


def test_pinned_pinned_is_a_half_wave_of_the_beam() -> None:
    """The dispersion of a free beam at p = π/L: Ω² = EI p⁴/m, from the track's own equations."""
    beam = tracks.EulerBernoulli(EI="6.4e6", m=60)
    p = pi / 0.6
    f = float(pinned_pinned("6.4 MN m²", 60, "0.6 m").value)
    s = 2j * pi * f
    D = sum(float(c) * (1j * p) ** i * s**j for (i, j), c in beam.waveguide.dispersion.items())
    assert abs(D) < 1e-9 * 6.4e6 * p**4


@pytest.mark.parametrize("found", [*per_metre(7, "1/3"), viscous(1e8, 0.1, 30), rail_damping(0.01, 1000)])
def test_the_line_says_the_value(found: Worked) -> None:
    text = found.line.split(" = ")[1].split("  #")[0].strip('"')
    assert float(in_unit(text, found.unit, found.key)) == pytest.approx(float(found.value), rel=1e-5)


def test_mistakes() -> None:
    with pytest.raises(InputError, match=r"spacing: is '0.6 kg', whose unit is kg"):
        per_metre("180 kN/mm", "0.6 kg")
    with pytest.raises(InputError, match="k: is 0, but must be above 0"):
        per_metre(0, 1)
