import pytest

from mpsolve import PhysicalCase
from mpsolve.vibration.scale import Scale


def test_units_of_a_physical_case():
    scale = Scale.of(PhysicalCase(EI="6.4e6", m=60, k="1e6", c=0, kp=0, N=0, v=50, masses=[(1000, 0)]))
    assert scale.physical
    assert scale.time == pytest.approx((60 / 1e6) ** 0.5)
    assert scale.force == 1e-3
    assert not Scale().physical
    assert "w_st" in Scale().said
