"""Pieces of paths, and waves over a place: where a bound does not hold nothing goes on from it."""

from __future__ import annotations

from types import SimpleNamespace

import planner as p
import pytest
from flint import acb, acb_mat, arb, arb_mat, fmpq

from mpsolve.certificate import verify2 as v2

DAMPED, UNDAMPED = p.beam("1/4", 1, 1, "1/10"), p.beam("1/4", 1, 1, 0)


def walker(track=DAMPED, velocity="1/2"):
    eq = p.equations(track, velocity, p.masses([40], [0]))
    car = v2.read_vehicle(eq["vehicle"], None)
    waves = v2.Waves(v2.read_track(eq["track"], eq["velocity"]), car.places)
    return v2.Walker(waves, v2.Bordered(car, waves))


def form(*k, rest=0):
    return v2.Form([[acb(x)] for x in k], [arb(rest)], len(k) - 1)


@pytest.mark.parametrize(
    "f", [form(arb(0, 1)), form(arb(0, 1), 0), form(1, "0.96"), form(1, "0.5", rest="0.5"), form(0)]
)
def test_what_may_be_0_has_no_inverse(f):
    with v2.precision(64), pytest.raises(v2.Refused, match="may be infinite"):
        f.inverse()


def test_a_pair_needs_a_highest_coefficient():
    """(σ − 1)P² − 1 round σ = 2: at σ = 1 the p-roots are at infinity; at the middle alone they are not."""
    d = {(2, 1): fmpq(1), (2, 0): fmpq(-1), (0, 0): fmpq(-1)}
    waves = v2.Waves(SimpleNamespace(d=d, n={(0, 0): fmpq(1)}, degree=2), [{}])
    with v2.precision(64):
        for m, r, fine in ((2, "0.1", True), (2, "1.1", False), (2, "30", False), (1, "0", False)):
            nodes = v2.Nodes([acb(-1), acb(1)], 1, waves.near(v2.Place.disc(acb(m), arb(r))))
            if fine:
                assert nodes.split()
            else:
                with pytest.raises(v2.Refused, match="highest coefficient"):
                    nodes.split(thin=r == "0")


@pytest.mark.parametrize(("w", "fine"), [("0.1", True), ("0.2", True), ("0.25", False), ("1.5", False)])
def test_discs_of_two_p_roots_that_come_near(w, fine):
    """w/e + w/(1 − e) < 1 for some e where w < 1/4."""
    bounds, gaps = [arb(w)] * 2, [arb(0), arb(1)]
    if fine:
        e = v2.isolated(0, bounds, gaps)
        assert arb(w) / e + arb(w) / (1 - e) < 1
    else:
        with pytest.raises(v2.Refused, match="not told apart"):
            v2.isolated(0, bounds, gaps)


@pytest.mark.parametrize("slope", ["0", "-1", "-0.01"])
def test_without_a_slope_no_root_is_alone(slope):
    """A slope less what it varies by may be below 0."""
    with pytest.raises(v2.Refused, match="meet"):
        v2.alone([arb("0.01"), arb(0), arb(1)], arb(slope))


def test_a_disc_that_others_fill_is_none():
    with pytest.raises(v2.Refused, match="not told apart"):
        v2.isolated(0, [arb("0.1"), arb(2)], [arb(0), arb(1)])


@pytest.mark.parametrize("track", [DAMPED, p.two_layer("1/4", 1, 1, "1/10", 1, 1, "1/10")])
def test_a_passive_piece_lies_where_the_receptance_is_passive(track):
    """Short pieces just below the real axis, against eigenvalues in floats."""
    eq, seen = p.equations(track, "13/10", p.masses([40, 40], [0, "3/2"])), []
    floats, car = p.Floats({"equations": eq, "basis": None}), v2.read_vehicle(eq["vehicle"], None)
    with v2.precision(64):
        one = v2.Walker(waves := v2.Waves(floats.track, car.places), v2.Bordered(car, waves))
        for k in range(1, 25):
            q, end = (fmpq(k, 8), fmpq(-1, 1000)), (fmpq(k, 8) + fmpq(1, 2**20), fmpq(-1, 1000))
            one.marks[q] = v2.Mark(q, v2.Apart.of(here := one.near(v2.at_q(q)), *v2.sorted_roots(here)))
            try:
                one.path(v2.Path("passive", [q, end]))
                seen.append("")
            except v2.Refused as error:
                seen.append(str(error))
            assert (not seen[-1]) == floats.passive(k / 8 - 0.001j)
    assert "" in seen
    assert any("not proved passive" in why for why in seen)


def test_a_matrix_of_no_numbers_has_no_inverse():
    for n in (1, 2):
        with pytest.raises(v2.Refused, match="singular"):
            v2.near_inverse(acb_mat(n, n, [*[acb(arb("nan"))], *[1] * (n * n - 1)]))
    with pytest.raises(v2.Refused, match="singular"):
        v2.near_inverse(acb_mat([[1, acb(arb("nan"))], [1, 1]]))


@pytest.mark.parametrize("bad", ["nan", "inf"])
def test_numbers_that_are_none_prove_nothing(bad):
    """Not that a matrix contracts, nor that it is definite, nor that a determinant does not vanish."""
    none, one = arb(bad), v2.identity(2)
    for at in range(4):
        entries = [none if k == at else arb(k in (0, 3)) / 9 for k in range(4)]
        assert not v2.contracting(arb_mat(2, 2, entries))
        assert not v2.definite([one], arb_mat(2, 2, entries))
        with pytest.raises(v2.Refused):
            v2.Turn.over(([one, one * 0], arb_mat(2, 2, entries)), v2.Place.disc(acb(0), arb(1)))
        with pytest.raises(v2.Refused):
            v2.Turn.over(([acb_mat(2, 2, [acb(x) for x in entries]), one], one.real), v2.Place.disc(acb(0), arb(1)))
        with pytest.raises(v2.Refused):
            v2.check_zeros(([acb_mat(2, 2, [acb(x) for x in entries]), one], one.real * 0), 1)


def test_kernels_without_a_bound_are_refused():
    waves, place = walker().waves, v2.Place.disc(acb(1), arb("0.1"))
    for rest, fine in (("0.1", True), ("inf", False), ("nan", False)):
        weight = form(1, 0, rest=rest)
        if fine:
            assert v2.summed(waves, [place], form(-1, 0), weight, [[0], []])
        else:
            with pytest.raises(v2.Refused, match="not bounded"):
                v2.summed(waves, [place], form(-1, 0), weight, [[0], []])


def test_the_pair_is_told_where_no_p_root_is_real():
    """At q = 0 those of an undamped beam are, if the load is faster than its slowest wave."""
    with v2.precision(64):
        walker(UNDAMPED, "1/2").begin(fmpq(0))
        with pytest.raises(v2.Refused, match="may be real"):
            walker(UNDAMPED, "6/5").begin(fmpq(0))


def test_a_piece_has_a_length():
    with v2.precision(64):
        one = walker()
        one.begin(fmpq(1))
        at = (fmpq(0), fmpq(-1))
        with pytest.raises(v2.Refused, match="are the same"):
            one.path(v2.Path("link", [at, at]))


# --- waves that meet at q = 0 ----------------------------------------------------------------------------------


def origin(d, n=(0, 1)):
    return v2.Origin(v2.Waves(SimpleNamespace(d={e: fmpq(c) for e, c in d.items()}, n={n: fmpq(1)}, degree=4), [{}]))


MEET = {(2, 0): 1, (0, 2): -1, (4, 0): -1}
NOT_KNOWN = {
    "slower than any multiple of σ": ({(1, 1): 1, (0, 2): -1, (4, 0): -1}, (0, 1), "not bounded"),
    "a receptance without a bound": (MEET, (0, 0), "not bounded"),
    "a p-root that comes from infinity": ({(2, 0): 1, (0, 2): -1, (4, 1): -1}, (0, 1), "at infinity"),
}


@pytest.mark.parametrize("name", NOT_KNOWN)
def test_waves_next_to_zero_that_are_not_known_are_refused(name):
    d, n, why = NOT_KNOWN[name]
    with v2.precision(64):
        assert len(origin(MEET).roots(arb("0.1"))) == 2
        with pytest.raises(v2.Refused, match=why):
            origin(d, n).roots(arb("0.01"))
