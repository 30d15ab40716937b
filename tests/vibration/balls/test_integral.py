from mpsolve import Problem, tracks, vehicles
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.integral import panels, rule
from mpsolve.vibration.path import Path

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def test_rules_integrate_polynomials():
    with precision(100):
        for n in (4, 12):
            assert sum((w * x ** (2 * n - 2) for x, w in rule(n, 100)), arb(0)).overlaps(arb(2) / (2 * n - 1))


def test_two_covers_of_a_leg_agree_within_what_they_tell(balls):
    image = balls(Problem(BEAM, vehicles.Mass(20), v="0.5"))
    path, times = Path(-0.028, 2.0, 0.5), [arb(2)]
    totals = []
    with precision(image.bits):
        for goal in (1e-4, 1e-12):
            for straight, leg in zip((True, False), path.legs(3.0), strict=True):
                total, missed = acb(0), arb(0)
                for panel in panels(image, leg, straight, times, [arb(goal)] * 3, Effort()):
                    total += sum((values[0] * (sigma * times[0]).exp() for sigma, values in panel.nodes), acb(0))
                    missed += panel.missed[0][0]
                totals.append((total, missed))
    for rough, fine in zip(totals[:2], totals[2:], strict=True):
        assert abs(rough[0] - fine[0]) <= rough[1] + fine[1]
        assert fine[1] < 1e-10
