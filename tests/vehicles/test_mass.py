"""A rigid mass: one coordinate, one tight contact."""

from __future__ import annotations

from mpsolve.vehicles import Mass


def test_its_only_matrix_is_its_mass() -> None:
    pencil = Mass("900").pencil
    assert (pencil.M, pencil.C, pencil.K, pencil.B) == (((900,),), ((0,),), ((0,),), ((1,),))
    assert (pencil.places, pencil.h, pencil.names) == ((0,), (0,), ("wheel",))
