"""What is said of an endless train: proved on either side of the threshold, with words for finite ones."""

from __future__ import annotations

import pytest
from endless_rows import BOGIE, LAYERS, masses

from mpsolve import Effort, InputError, Problem, certify, infinite_train


def test_on_either_side_of_the_threshold() -> None:
    """Floats had α ≈ 0.19."""
    calm, grows, high = (infinite_train(masses(v).problem, "1.5") for v in ("0.185", "0.195", "0.5"))
    assert (calm.proved, calm.stable, calm.growing, calm.long_trains) == (True, True, 0, False)
    assert max(calm.ahead.factor, calm.back.factor) < 1
    assert (grows.proved, grows.stable, grows.long_trains) == (True, False, False)
    assert grows.motion is not None
    assert grows.motion.growth > 0
    assert "grows as it runs back" in grows.words
    assert high.long_trains
    assert "long finite trains grow" in high.words
    with pytest.raises(TypeError):
        bool(calm)


def test_sixteen_masses_are_stable_where_the_endless_row_is_not() -> None:
    assert certify(masses("0.4").train(16), region="unstable", digits=15, check=False).stable
    assert infinite_train(masses("0.4").problem, "1.5").stable is False


def test_bogies_of_single_growth_are_not_called_harmless() -> None:
    """A bogie that grows alone does so in long trains too, even where no moduli meet on the real axis."""
    row = Problem(LAYERS, BOGIE, v=3)
    alone = certify(row, region="unstable", digits=15, check=False)
    found = infinite_train(row, 12)
    assert (alone.stable, found.stable, found.long_trains) == (False, False, True)


def test_what_is_left_open_keeps_what_is_known() -> None:
    found = infinite_train(masses("0.18").problem, "1.5", effort=Effort(evaluations=1000))
    assert (found.proved, found.stable) == (False, None)
    assert found.reason is not None
    assert found.reason.code == "effort"
    assert 0.9 < found.back.factor < 1
    assert found.words.startswith("undecided")
    with pytest.raises(InputError, match="effort"):
        infinite_train(masses("0.18").problem, "1.5", effort=3)  # type: ignore[arg-type]
