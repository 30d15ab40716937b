"""The motion in time: closed-form parts and complete solution, against numerical inversion of the Laplace image."""

from __future__ import annotations

import mpmath
import numpy as np
from measure import median, seconds

from mpsolve import Case, certify
from mpsolve.fields import Float64
from mpsolve.model.branch import pairing
from mpsolve.motion.field import images_at
from mpsolve.motion.forcing import image
from mpsolve.motion.solve import Problem, prepare
from mpsolve.motion.transform import contact_image

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
FAR = Case(alpha="0.9", eta_b="0", eta_m=("40", "40"), positions=("0", "4.5"))  # Figure A.2, the widest span
POSITIONS = np.array([0.0, 0.5, 1.0, 1.5, 2.0])


def inverted(problem: Problem, tau: float) -> float:
    """w at the rear mass by mpmath.invertlaplace (de Hoog), with the image in float64 arrays of one point."""

    def value(s: complex) -> complex:
        q = np.array([complex(s) / 1j])
        pair = pairing(problem.model, q)
        S = contact_image(problem.model, pair, q, image(problem.tones, Float64(), q))
        return complex(images_at(problem.model, pair, S, np.zeros(1))[0, 0])

    return float(mpmath.invertlaplace(value, tau, method="dehoog", degree=20).real)


def compare() -> None:
    spectrum = certify(CASE)
    problem = prepare(CASE, None, spectrum)
    many, some = np.linspace(0, 1000, 10_000), np.linspace(0, 100, 1000)
    harmonic = median(lambda: prepare(CASE, None, spectrum).harmonic(POSITIONS, many), 9)
    complete = median(lambda: problem.response(np.zeros(1), some), 5)
    far = prepare(FAR)
    wide = median(lambda: far.response(np.zeros(1), some), 5)
    one = median(lambda: inverted(problem, 25.0), 3)
    print(f"steady and harmonic, 10,000 times × 5 positions {seconds(harmonic)} with the residues (goal: 20 ms)")
    print(f"complete, 1,000 times {seconds(complete)}, at d = 4.5 {seconds(wide)} (goal: 1 s)")
    print(f"inversion of one time {seconds(one)}   inversion/complete, a time = {one / (complete / len(some)):.0f}")
    found = problem.response(np.zeros(1), np.array([25.0])).w[0, 0]
    assert abs(found - inverted(problem, 25.0)) < 1e-4


def test_the_parts_and_the_inversion_agree() -> None:
    compare()


def main() -> None:
    compare()


if __name__ == "__main__":
    main()
