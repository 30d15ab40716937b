"""Chains of tubes: they end where roots are, go both ways to the same place, and stop where they are told."""

from fractions import Fraction

import pytest
from free_cases import BEAM, PAIR, pair_over_velocity

from mpsolve import Problem, certify
from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.errors import EffortError
from mpsolve.loci.chain import Chain, Room, follow
from mpsolve.proof.effort import Effort

FAMILY = pair_over_velocity("0.5", "0.9")
MATRIX = FreeMatrix(FAMILY)
ROOM = Room(0.5, 0.875, 0.046)


def _roots(x: float) -> list[complex]:
    problem = Problem(BEAM, PAIR, v=Fraction(x) * FAMILY.units[0])
    spectrum = certify(problem, region=("below", "0.046"), check=False)
    return [complex(root.q) / float(FAMILY.frequency_unit) for root in spectrum.roots if root.q.real > 0]


def _grown(x: float, way: int) -> list[Chain]:
    chains = [Chain(x, q, 1e-13, way) for q in _roots(x)]
    follow(MATRIX, chains, ROOM, Effort(), lambda _: None, lambda _: None)
    return chains


@pytest.mark.parametrize(("x", "way", "end"), [(0.5, 1, 0.875), (0.875, -1, 0.5)])
def test_chains_end_at_roots(x: float, way: int, end: float) -> None:
    chains = _grown(x, way)
    truth = _roots(end)
    for chain in chains:
        assert chain.end == "range"
        assert chain.x == end
        assert min(abs(chain.q - root) for root in truth) <= chain.radius
        assert all(tube.middle.imag <= ROOM.top for tube in chain.tubes)
    assert len({min(range(2), key=lambda k: abs(chain.q - truth[k])) for chain in chains}) == 2


def test_neighbouring_tubes_share_a_root() -> None:
    (chain, _) = _grown(0.5, 1)
    for one, other in zip(chain.tubes, chain.tubes[1:], strict=False):
        assert one.high == other.low
        x = one.high
        assert abs(one.centre(x) - other.centre(x)) < one.inner + other.inner


def test_a_chain_from_no_root_is_stuck() -> None:
    chain = Chain(0.5, 0.3 + 0.01j, 1e-13, 1)
    follow(MATRIX, [chain], ROOM, Effort(), lambda _: None, lambda _: None)
    assert chain.end == "stuck"
    assert not chain.tubes


def test_a_chain_stops_where_it_is_told_and_when_the_effort_is_spent() -> None:
    (q, _) = _roots(0.5)
    chain = Chain(0.5, q, 1e-13, 1)
    follow(MATRIX, [chain], ROOM, Effort(), lambda one: "here" if one.x > 0.6 else None, lambda _: None)
    assert chain.end == "here"
    assert 0.6 < chain.x < 0.875
    with pytest.raises(EffortError):
        follow(MATRIX, [Chain(0.5, q, 1e-13, 1)], ROOM, Effort(evaluations=40), lambda _: None, lambda _: None)
