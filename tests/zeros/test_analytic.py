"""Boxes prove that f is analytic in all of a region, or name the place; trees are those that a checker follows."""

from __future__ import annotations

from fractions import Fraction

import pytest
from functions import function

from mpsolve.numbers.balls import precision
from mpsolve.proof.effort import Effort
from mpsolve.zeros.analytic import NotAnalyticError, cells, cover_region, halves, hull, is_outside
from mpsolve.zeros.geometry import Vertices
from mpsolve.zeros.regions import Cut, Polygon, Rectangle

F = Fraction
BOX = Rectangle(-1, 1, -1, 1).polygon


def cover(text: str, vertices: Vertices, *cuts: Cut) -> tuple[str, ...]:
    with precision(64):
        return cover_region(function(text), vertices, cuts, Effort(evaluations=20_000))


def test_an_entire_function_needs_no_boxes() -> None:
    assert cover("sin(z)*rgamma(z) + cos_sqrt(z)*bessel_j(2, z)", BOX) == ()


@pytest.mark.parametrize(
    "text", ["sqrt(z + 2)", "log(z - 3*i)", "sin(1/(z + 1.5))", "atan(z/2)", "sqrt(1 + log(z + 2)/9)"]
)
def test_what_is_analytic_is_covered(text: str) -> None:
    (tree,) = cover(text, BOX)
    assert set(tree) <= {"|", "."}
    assert tree.count("|") + 1 == tree.count(".")


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("sqrt(z)", 0j),
        ("sqrt(z - 0.123456)", 0.123456),
        ("sin(1/(z - 0.25 - 0.3*i))", 0.25 + 0.3j),
        ("log(z**2 + 4)*sqrt(z**2)", 0j),
        ("exp(atan(3*z))", 0j),
        ("sqrt(z)*sqrt(z)", 0j),
    ],
)
def test_a_hidden_pole_or_cut_is_named(text: str, place: complex) -> None:
    with pytest.raises(NotAnalyticError) as found:
        cover(text, BOX)
    assert abs(found.value.place.real) <= 1.0
    assert place is not None


@pytest.mark.parametrize("sliver", [F(-1, 10**15), F(-1, 10**16), F(1, 10**16)])
def test_a_cut_a_hair_beside_the_edges_of_boxes_ends_too(sliver: Fraction) -> None:
    """Boxes beside it pass, but only ones as thin as the gap: a thousand million of them."""
    vertices = ((F(-1), F(-1)), (F(1), F(-1)), (F(1), 1 + sliver), (F(-1), 1 + sliver))
    with pytest.raises(NotAnalyticError, match="may meet its branch cut"):
        cover("sqrt(z)", vertices)


def test_boxes_outside_the_polygon_are_left_out() -> None:
    ell = Polygon([0, 4, 4 + 1j, 1 + 1j, 1 + 4j, 4j]).polygon
    (tree,) = cover("sin(1/(z - 3 - 3*i))", ell)  # the pole is in the notch
    assert "o" in tree
    assert is_outside(ell, (F(2), F(4), F(2), F(4)))
    assert not is_outside(ell, (F(0), F(4), F(0), F(4)))


def test_cells_are_cut_at_lines_and_tips() -> None:
    assert len(cells(BOX, [Cut.ray(0, -1)])) == 4
    assert halves((F(0), F(2), F(0), F(2))) == ((F(0), F(1), F(0), F(2)), (F(1), F(2), F(0), F(2)))


def test_a_hull_holds_its_corners_and_keeps_what_is_exact() -> None:
    ball = hull((F(0), F(1, 3)), (F(0), F(2, 3)))
    assert ball.real == 0
    assert ball.imag.contains(hull((F(0), F(1, 3))).imag)
