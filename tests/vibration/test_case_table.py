import numpy as np

from mpsolve import Case, Load, response
from mpsolve.vibration.case_table import columns, named, time_columns
from mpsolve.vibration.case_units import Scale


def test_every_part_has_its_column():
    found = response(Case(alpha="0.5", eta_b="0.05", eta_m=20), [Load(1)], [0, "1.5"], [0, 2])
    table = columns(found, Scale())
    assert list(table)[:3] == ["tau", "w[xi=0]", "steady[xi=0]"]
    assert np.array_equal(table["w[xi=1.5]"], found.w[1])
    assert named("w", "mm", Scale()) == "w"
    assert list(time_columns(found.tau, Scale())) == ["tau"]
