"""Makes tests/data/general_counts.json: seeded problems, counts of Im q < 0 and the roots there, to 10 digits.

    python -m oracle_general.table 200          (in the folder tests)

Each count is made twice, with other radii, levels, first points and steps, and a third time by finding the roots.
"""

from __future__ import annotations

import json
import sys
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np

from oracle_general.count import Alarm, Count, count_below, count_inside
from oracle_general.floats import Floats
from oracle_general.named import NAMED
from oracle_general.precise import Precise
from oracle_general.problems import MAKERS, Dice, random_problem, stands
from oracle_general.rectangles import with_rectangle
from oracle_general.roots import growing

TABLE = Path(__file__).parents[1] / "data" / "general_counts.json"


def entry(problem: dict[str, Any], digits: int = 25) -> dict[str, Any]:
    """The problem with its count, or an Alarm. Where the count grows with the radius it is that of one radius."""
    floats = Floats(problem)
    _compare(floats)
    within = float(problem["within"]) if "within" in problem else None
    try:
        first = count_below(floats) if within is None else count_inside(floats, within)
    except Alarm as alarm:
        if "grows" not in str(alarm):
            raise
        within = float(f"{20 * floats.scale:.3g}")
        first = count_inside(floats, within)
    second = _again(floats, within)
    if first.number != second.number:
        raise Alarm(f"{first.number} or {second.number} roots")
    count, roots = growing(floats, digits, within=within)
    if count.number != first.number:
        raise Alarm(f"{first.number} or {count.number} roots")
    if floats.defect > 1e-7:
        raise Alarm(f"residues sum to {floats.defect:.1e} in place of 0")
    out = {**problem, "count": first.number, "roots": [_short(q) for q in roots]}
    return out if within is None else {**out, "within": f"{within:.3g}"}


def _again(floats: Floats, within: float | None) -> Count:
    level = -3e-8 * floats.scale
    if within is None:
        return count_below(floats, level, first=31 * floats.scale, start=173, step=0.2)
    return count_inside(floats, within, level, start=173, step=0.2)


def _compare(floats: Floats) -> None:
    """The floats against 40 digits at three points."""
    precise = Precise(floats.problem, 40)
    for q in (0.37 - 0.21j, 2.9 - 0.013j, 0.011 - 0.004j):
        at = q * floats.scale
        a, b = floats.delta(at), complex(precise.delta(at))
        if abs(a - b) > 1e-6 * abs(b):
            raise Alarm(f"floats are wrong at q = {at}: {a}, {b}")


def _short(q: Any) -> list[str]:
    """Real and imaginary part; a real part of rounding alone is 0."""
    return ["0" if abs(x) < 1e-12 * abs(q) else f"{float(x):.10e}" for x in (q.real, q.imag)]


def row(name: str | int) -> dict[str, Any] | None:
    """The row of a named problem or of a seed; None, told on the screen, where it is not to be trusted."""
    models = list(MAKERS)
    problem = NAMED[name] if isinstance(name, str) else random_problem(Dice(name), models[name % len(models)])
    if not stands(problem):
        return None
    try:
        return with_rectangle({"name" if isinstance(name, str) else "seed": name, **entry(problem)})
    except (ArithmeticError, np.linalg.LinAlgError) as reason:
        kinds = [vehicle["model"] for vehicle in problem["vehicles"]]
        print(name, problem["track"]["model"], problem["v"], kinds, type(reason).__name__, reason, flush=True)
        return None


def table(number: int) -> list[dict[str, Any]]:
    """All named problems, and the first `number` seeds of which the counts can be trusted."""
    with get_context("spawn").Pool(2) as pool:
        rows = [found for found in pool.imap(row, [*NAMED, *range(number + 25)]) if found]
    return rows[: len(NAMED) + number]


if __name__ == "__main__":
    rows = table(int(sys.argv[1]))
    TABLE.parent.mkdir(exist_ok=True)
    TABLE.write_text("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]\n")
    print(len(rows), "problems,", sum(row["count"] > 0 for row in rows), "unstable")
