"""The convective threshold is enclosed by proofs, the limit of long trains computed."""

from __future__ import annotations

import pytest
from endless_rows import masses

from mpsolve import InputError, train_velocities


def test_the_two_velocities_of_the_papers_beam() -> None:
    found = train_velocities(masses("0.3").problem, "1.5", ("0.1", "0.6"))
    assert found.proved
    assert found.calm is not None
    assert found.grows is not None
    assert found.calm.stable is True
    assert found.grows.stable is False
    assert found.convective is not None
    assert float(found.calm.problem.v) < found.convective < float(found.grows.problem.v)
    assert abs(found.convective - 0.190147) < 1e-6
    assert found.limit is not None
    assert abs(found.limit - 0.445073) < 1e-6


def test_ranges() -> None:
    found = train_velocities(masses("0.3").problem, "1.5", (0, "0.1"))
    assert (found.proved, found.convective, found.limit) == (False, None, None)
    assert found.reason is not None
    for wrong in ((1, 0), 3, ("a", "b")):
        with pytest.raises(InputError, match="v"):
            train_velocities(masses("0.3").problem, "1.5", wrong)  # type: ignore[arg-type]
