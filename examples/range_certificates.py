"""The certificates under certs/ranges/: answers over ranges of parameters, made anew by this script.

Two masses of 10 t on a rail: where a vibration begins to grow as they run faster, and that none does while the
damping is uncertain.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from mpsolve import Problem, crossings, prove_stable, tracks, vehicles

FOLDER = Path(__file__).resolve().parent.parent / "certs" / "ranges"
RAIL = tracks.EulerBernoulli(EI="6.4e6", m="60", k="1e6", c="770")
PAIR = Problem(RAIL, [vehicles.Mass("10e3").at(0), vehicles.Mass("10e3").at("3.4")], v="150")
NAMES = ("crossing_over_velocity", "stable_over_damping")


def prove(name: str) -> Any:
    """The answer that a file certifies."""
    if name == NAMES[0]:
        return crossings(PAIR, over={"v": (170, 210)})
    return prove_stable(PAIR, over={"track.c": (600, 900), "v": (0, 100)})


if __name__ == "__main__":
    for one in NAMES:
        print(prove(one).certificate.save(FOLDER / f"{one}.json"))
