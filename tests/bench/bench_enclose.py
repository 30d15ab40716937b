"""A root of a problem isolated, and sharpened to many digits, against one value at the last precision."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import partial

import pytest
from measure import median, seconds

from mpsolve.characteristic.proved import Proved
from mpsolve.numbers.balls import precision
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.enclose import isolate, refine
from mpsolve.tracks import EulerBernoulli, TwoLayer
from mpsolve.vehicles import Bogie, Mass

GOAL = 6
BEAM = EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
LAYERS = TwoLayer(
    EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper=250, k_ballast="100e6", c_ballast="8e4"
)
BOGIE = Bogie(wheel=1813, frame=2615, inertia=1476, wheelbase="2.5", k="2.4e6", c="3e4", k_contact="1.5e9")
ROW = [Mass(40).at(Fraction(3, 2) * i) for i in range(16)]
PROBLEMS = {
    "pair": (Problem(BEAM, [Mass(70).at(0), Mass(70).at("1.5")], "0.67"), 0.1558609631 - 0.0000272301j),
    "bogie on two layers": (Problem(LAYERS, [BOGIE], 600), 63.9594043879 + 31.5260863352j),
    "sixteen masses": (Problem(BEAM, ROW, "0.5"), 0.2056977713811 + 0.0004725443183j),
}
REPEATS = {30: 25, 1000: 9, 10_000: 3}


@pytest.mark.parametrize("name", PROBLEMS)
def test_a_sharpened_root_costs_few_values(name: str) -> None:
    problem, q = PROBLEMS[name]
    proved = Proved(reduce_problem(problem))
    sigma = 1j * q / float(proved.reduced.frequency_unit)
    box = isolate(proved, sigma)
    print(f"{name}: isolated in {seconds(median(lambda: isolate(proved, sigma), 15))}")
    for digits, repeats in REPEATS.items():
        if digits > 1000 and name != "pair":
            continue
        ball = refine(box, digits)
        sharpening = median(partial(refine, box, digits), repeats)
        with precision(math.ceil(digits * math.log2(10)) + 48):
            middle = box.root.found.image.mid()
            once = median(partial(box.function.value, middle), repeats)
        print(
            f"{digits:6} digits   refine {seconds(sharpening)}   one value {seconds(once)}   "
            f"refine/once = {sharpening / once:.2f}  (goal at 10,000: {GOAL} or less)"
        )
        assert ball.q.rel_accuracy_bits() > 3.3 * digits


if __name__ == "__main__":
    for each in PROBLEMS:
        test_a_sharpened_root_costs_few_values(each)
