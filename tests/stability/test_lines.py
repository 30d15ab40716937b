"""Frequency lines: joined by proof, ended at the proved cut points, with the certified count at each velocity."""

from __future__ import annotations

from fractions import Fraction

import pytest

from mpsolve import Case, Exact, InputError, certify
from mpsolve.stability.lines import frequency_lines
from mpsolve.stability.tube import follow

REST = {"eta_b": "0.05", "eta_m": (70, 70), "positions": (0, "1.5")}


def test_a_root_is_followed_to_itself():
    """Each ball that the chain ends in meets exactly one certified root of the later velocity."""
    early, late = (certify(Case(alpha=a, **REST), digits=15) for a in ("0.6", "0.7"))
    roots = [root.q for root in early.roots if root.q.real > 0]
    ends = follow(early.problem, [Exact("0.6")] * 2, [Exact("0.7")] * 2, roots)
    met = [[k for k, root in enumerate(late.roots) if root.q.overlaps(end)] for end in ends]
    assert [len(m) for m in met] == [1, 1]
    assert met[0] != met[1]
    assert follow(early.problem, [], [], []) == []


def test_ends_are_open_where_cuts_are_not_looked_for():
    (ending, through) = frequency_lines(**REST, alpha=["0.97", "0.99"], cuts=False)
    assert [end.kind for end in ending.ends] == ["range", "open"]
    assert [end.kind for end in through.ends] == ["range", "range"]


def test_a_line_ends_at_the_cut_and_another_begins():
    lines = frequency_lines(**REST, alpha=["0.95", "0.97", "0.99", "1.03", "1.05"])
    assert lines.counts == (4, 4, 2, 2, 4)
    assert not any(lines.reasons)
    ending, through, beginning = lines
    assert [float(a) for a in ending.alpha] == [0.95, 0.97]
    assert (ending.ends[0].kind, ending.ends[1].kind) == ("range", "cut")
    assert abs(ending.ends[1].alpha - 0.97909502330842) < 1e-12
    assert [end.kind for end in through.ends] == ["range", "range"]
    assert len(through.q) == 5
    assert (beginning.ends[0].kind, beginning.ends[1].kind) == ("cut", "range")
    assert abs(beginning.ends[0].alpha - 1.0416516647631) < 1e-12


def test_undamped_lines():
    lines = frequency_lines(0, (40, 40), (0, 1), alpha=["0.5", "0.55"])
    assert lines.counts == (4, 4)
    assert [len(line.q) for line in lines] == [2, 2]


@pytest.mark.slow
def test_an_undamped_line_ends_at_the_gap():
    lines = frequency_lines(0, (40, 40), (0, 1), alpha=["0.8", "0.83", "0.87"])
    assert lines.counts == (4, 4, 2)
    kinds = sorted((len(line.q), line.ends[1].kind) for line in lines)
    assert kinds == [(2, "cut"), (3, "range")]
    assert abs(next(line for line in lines if len(line.q) == 2).ends[1].alpha - 0.8613973457309659) < 1e-12


@pytest.mark.slow
def test_lines_through_both_regimes():
    lines = frequency_lines(**REST, alpha=[Fraction(k, 40) for k in range(16, 50)])
    assert lines.counts == (4,) * 24 + (2, 2) + (4,) * 7 + (6,)
    assert all(end.kind != "open" for line in lines for end in line.ends)
    assert len(lines) == 4


@pytest.mark.parametrize("alpha", [["0.5"], ["0.5", "0.4"], ["0.5", "root4(1/4)"]])
def test_a_bad_grid_is_refused(alpha):
    with pytest.raises(InputError, match="alpha"):
        frequency_lines(**REST, alpha=alpha)
