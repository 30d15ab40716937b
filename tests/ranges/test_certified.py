from __future__ import annotations

import signal
from fractions import Fraction

import numpy as np
import pytest
from flint import arb
from free_cases import BEAM, PAIR

from mpsolve import Effort, Problem, Status, crossings
from mpsolve.certificate.format import Certificate
from mpsolve.certificate.verify_ranges import verify_bytes
from mpsolve.errors import CertificateError
from mpsolve.numbers.balls import precision
from mpsolve.proof.sheared import SLOPED
from mpsolve.proof.subdivide import OPEN, Tree
from mpsolve.ranges.certified import ball_entry, chart_certificate, tree_text, verified, with_room
from mpsolve.ranges.enclosed import Crossing
from mpsolve.ranges.judge import KNOWN, NONZERO, PASSIVE
from mpsolve.ranges.scope import checked_over, scope_of


def test_trees_are_written_halves_after_their_wholes() -> None:
    kind = np.array([OPEN, NONZERO, OPEN, PASSIVE, KNOWN])
    axis, child = np.array([1, -1, 0, -1, -1]), np.array([1, -1, 3, -1, -1])
    assert tree_text(Tree(np.zeros((2, 5)), np.ones((2, 5)), kind, axis, child)) == "1n0pz"
    low = np.zeros((3, 5))
    low[2, 1:] = -0.75
    axis[0] = SLOPED
    assert tree_text(Tree(low, low, kind, axis, child), Fraction(4)) == "s-3e0;n0pz"


def test_charts_that_are_too_large_have_no_certificate() -> None:
    """Of cells, or of boxes."""
    problem = Problem(BEAM, PAIR, v="0.9")
    scope = scope_of(problem, checked_over(problem, {"v": ("0.5", 1), "scale.mass": (1, 2)}))
    leaf = np.zeros(1, int)
    tree = Tree(np.zeros((3, 1)), np.ones((3, 1)), leaf + 1, leaf - 1, leaf)
    many = Tree(tree.low, tree.high, np.ones(20_001, int), leaf - 1, leaf)
    for one, cells, why in ((tree, np.zeros((1024, 4), int), "512"), (many, np.zeros((4, 4), int), "20001 boxes")):
        with pytest.raises(CertificateError, match=why):
            chart_certificate(scope, one, (), cells)


def test_balls_in_the_file_are_those_that_are_said() -> None:
    with precision(128):
        zero = Crossing(arb(0), arb("1.5", "1e-30"), 1)
        roomy = with_room(zero)
        assert roomy.q == 0
        assert roomy.x.contains(zero.x)
        entry = ball_entry(roomy.x, 8)
        middle = arb(int(entry["middle"], 16)) * arb(2) ** entry["exponent"]
        assert middle == 12
        m, e = entry["radius"]
        assert arb(m) * arb(2) ** e == roomy.x.rad() * 8


def test_an_answer_hands_on_its_certificate() -> None:
    found = crossings(Problem(BEAM, PAIR, v="0.9"), over={"track.c": ("0.1", "0.3")})
    assert verify_bytes(found.certificate.text.encode("ascii")).valid
    claim = found.certificate.content["claim"]
    assert claim == {"counts": list(found.counts), "directions": [one.direction for one in found.crossings]}
    (zero,) = found.certificate.content["zeros"]
    middle = int(zero["x"]["middle"], 16) * 2.0 ** zero["x"]["exponent"]
    assert found.crossings[0].lower <= middle <= found.crossings[0].upper


def test_what_is_not_asked_for_is_not_made() -> None:
    def never() -> Certificate:
        raise AssertionError

    made = verified(never, 10, None)
    assert (made.status, made.certificate) == (Status.UNVERIFIED, None)
    assert "not asked" in made.note


def test_a_certificate_that_cannot_be_made_says_why() -> None:
    def fails() -> Certificate:
        raise CertificateError("no power of two")

    made = verified(fails, 10, Effort())
    assert (made.status, made.certificate, made.note) == (Status.UNVERIFIED, None, "no power of two")


def test_a_certificate_that_is_refused_is_none() -> None:
    made = verified(lambda: Certificate({"kind": "stable"}), 10, Effort())
    assert (made.status, made.certificate) == (Status.UNVERIFIED, None)
    assert made.note.startswith("the verifier does not pass one")


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no such timer here")
def test_what_takes_longer_than_the_effort_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    def slow(*_: object) -> None:
        while True:
            pass

    monkeypatch.setattr("mpsolve.certificate.verify_ranges.verify_bytes", slow)
    made = verified(lambda: Certificate({"kind": "stable"}), 10, Effort(seconds=0.2))
    assert (made.status, made.certificate) == (Status.UNVERIFIED, None)
    assert "the effort of 0.2 s" in made.note
    assert 0.1 < made.seconds < 1
