"""K and K_q of (21), (37)–(39): the residue sums in every arithmetic, and the kernel's invariants."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth, cases, frequencies, grid, holds, point, sharp

from mpsolve import Case
from mpsolve.fields import MP, Float64, ball_arithmetic
from mpsolve.model.branch import pairing, pairing_rate, track
from mpsolve.model.kernel import AHEAD, BEHIND, kernel, kernel_at_contact, kernel_at_contact_rate, kernel_rates

few = settings(max_examples=25)
places = st.one_of(st.just(0.0), grid(-6, 6))


def kernel_at(model: Any, q: Any, xi: float, number: Callable[[float], Any] = float) -> Any:
    side = AHEAD if xi >= 0 else BEHIND
    return kernel(model, pairing(model, q), side, number(abs(xi)))


def rates_at(model: Any, q: Any, xi: float, number: Callable[[float], Any] = float) -> tuple[Any, Any]:
    pair = pairing(model, q)
    side = AHEAD if xi >= 0 else BEHIND
    value, (rate,) = kernel_rates(model, pair, [(pairing_rate(model, q, pair), 0)], side, number(abs(xi)))
    return value, rate


@few
@given(st.data(), cases(), places, st.sampled_from([64, 128, 500, 2000]))
def test_balls_hold_37_and_39(data: st.DataObject, case: Case, xi: float, bits: int) -> None:
    q = data.draw(frequencies(case))
    truth = Truth(case, 2 * bits * 3 // 10)
    exact, exact_rate = truth.kernel(xi, q), truth.kernel_rate(xi, q)
    with ball_arithmetic(bits) as field:
        value, rate = rates_at(track(case, field), point(q), xi, flint.arb)
        assert holds(value, exact)
        assert holds(kernel_at(track(case, field), point(q), xi, flint.arb), exact)
        assert holds(rate, exact_rate)
        scale = flint.arb(2) ** (48 - bits)
        assert (value - value.mid()).abs_upper() < scale * (1 + abs(flint.acb(exact)))
        assert (rate - rate.mid()).abs_upper() < scale * (1 + abs(flint.acb(exact_rate)))


@few
@given(st.data(), cases(), places)
def test_mpmath_agrees_with_37_and_39(data: st.DataObject, case: Case, xi: float) -> None:
    q = data.draw(frequencies(case))
    truth = Truth(case, 90)
    mp, model = truth.mp, track(case, MP(200))
    value, rate = rates_at(model, q, xi)
    assert abs(value - truth.kernel(xi, q)) < mp.mpf(2) ** -150 * (1 + abs(value))
    assert abs(rate - truth.kernel_rate(xi, q)) < mp.mpf(2) ** -120 * (1 + abs(rate))
    difference = mp.diff(lambda z: truth.kernel(xi, z), q, h=mp.mpf(10) ** -40)
    assert abs(rate - difference) < mp.mpf(10) ** -30 * (1 + abs(rate))


@few
@given(st.data(), cases(), places)
def test_float64_agrees_with_37_and_39(data: st.DataObject, case: Case, xi: float) -> None:
    """Arrays of q, as far as R, by which the kernel is divided, is away from 0."""
    qs = np.array([data.draw(frequencies(case, 0.125)) for _ in range(4)])
    truth, model = Truth(case, 30), track(case, Float64())
    values, rates = rates_at(model, qs, xi)
    assert values.shape == rates.shape == qs.shape
    for q, value, rate in zip(qs, values, rates, strict=True):
        q, loss = complex(q), 1 + 1 / abs(complex(truth.resultant(complex(q))))
        assert abs(value - complex(truth.kernel(xi, q))) < 1e-11 * loss**2
        assert abs(rate - complex(truth.kernel_rate(xi, q))) < 1e-11 * loss**3


@few
@given(st.data(), cases())
def test_at_contact(data: st.DataObject, case: Case) -> None:
    q = data.draw(frequencies(case))
    model = track(case, MP(200))
    pair = pairing(model, q)
    value, rate = rates_at(model, q, 0.0)
    contact, contact_rate = kernel_at_contact_rate(model, pair, pairing_rate(model, q, pair))
    tolerance = 1e-45 * (1 + abs(rate))
    assert abs(kernel_at_contact(model, pair) - value) < tolerance
    assert abs(contact - value) < tolerance
    assert abs(contact_rate - rate) < tolerance


@pytest.mark.parametrize(
    ("alpha", "eta_b", "xi", "q"),
    [("0.5", "0.3", 1.0, 0.7 - 0.2j), ("1.2", "0.1", -2.0, -0.4 - 0.5j), ("0.8", "0", 0, 1j)],
)
def test_the_kernel_is_the_integral_21(alpha: str, eta_b: str, xi: float, q: complex) -> None:
    truth = Truth(Case(alpha=alpha, eta_b=eta_b, eta_m=1), 15)
    mp, D = truth.mp, truth.quartic(q)
    integral = mp.quad(lambda p: mp.expj(p * xi) / mp.polyval(D, p), np.linspace(-150, 150, 201).tolist())
    value = complex(kernel_at(track(Case(alpha=alpha, eta_b=eta_b, eta_m=1), Float64()), q, xi))
    assert abs(complex(integral) - value) < 3e-7  # the two tails are below (2/3)/150³


# --- invariants --------------------------------------------------------------------------------------------


@few
@given(st.data(), cases(), places)
def test_symmetry_in_the_imaginary_axis(data: st.DataObject, case: Case, xi: float) -> None:
    """K(ξ, −q̄) = conj K(ξ, q); the roots come in such pairs, as after (36)."""
    q = data.draw(frequencies(case))
    model = track(case, MP(120))
    assert abs(kernel_at(model, -q.conjugate(), xi) - kernel_at(model, q, xi).conjugate()) < 1e-25


@few
@given(st.data(), cases(most_damping=0), places)
def test_symmetry_of_the_undamped_kernel(data: st.DataObject, case: Case, xi: float) -> None:
    """η_b = 0: K(ξ, q̄) = conj K(−ξ, q), and the same of K(ξ) K(−ξ) without the sign."""
    q = data.draw(frequencies(case))
    model = track(case, MP(120))
    assert abs(kernel_at(model, q.conjugate(), xi) - kernel_at(model, q, -xi).conjugate()) < 1e-25


@few
@given(st.data(), cases(), places)
def test_damping_is_a_rescaling(data: st.DataObject, case: Case, xi: float) -> None:
    """K(ξ; q, α, N, η_b) = β^{−3/2} K₀(ξ√β; r/β, α/√β, N/β), by mpmath's residue sums on the right."""
    q = data.draw(frequencies(case))
    rescaled = Truth(case, 60)
    mp = rescaled.mp
    beta = mp.sqrt(1 - rescaled.eta_b**2)
    r = q - mp.j * rescaled.eta_b
    rescaled.alpha, rescaled.axial, rescaled.eta_b = (rescaled.alpha / mp.sqrt(beta), rescaled.axial / beta, mp.zero)
    expected = beta**-1.5 * rescaled.kernel(xi * mp.sqrt(beta), r / beta)
    assert abs(kernel_at(track(case, MP(200)), q, xi) - expected) < 1e-35 * (1 + abs(expected))


@settings(max_examples=12)
@given(st.data(), cases())
def test_the_green_functions_jump(data: st.DataObject, case: Case) -> None:
    """D(−i∂_ξ, q) K = 2πδ(ξ): K, K', K'' are continuous at ξ = 0, K''' jumps by 2π, and K solves D K = 0."""
    q = data.draw(frequencies(case))
    field = MP(400)
    model, mp = track(case, field), field.context
    pair = pairing(model, q)
    ahead = mp.taylor(lambda x: kernel(model, pair, AHEAD, x), 0, 4, h=mp.mpf(10) ** -20)
    behind = mp.taylor(lambda x: kernel(model, pair, BEHIND, -x), 0, 4, h=mp.mpf(10) ** -20)
    jumps = [mp.factorial(k) * (a - b) for k, (a, b) in enumerate(zip(ahead, behind, strict=True))]
    size = 1e-12 * (1 + max(map(abs, ahead)))
    assert max(map(abs, jumps[:3])) < size
    assert abs(jumps[3] - 2 * mp.pi) < size
    D = Truth(case, 60).quartic(q)
    for side in (ahead, behind):
        applied = sum(mp.factorial(k) * side[k] * (-mp.j) ** k * D[4 - k] for k in range(5))
        assert abs(applied) < 100 * size


# --- a collision of p-roots on one side ---------------------------------------------------------------------


def collisions(case: Case, digits: int) -> list[Any]:
    """The q off the cut at which D has a double p-root p₁: r = p₁(2A − p₁²)/(2α) by D_p = 0, into D = 0."""
    truth = Truth(case, digits)
    mp, alpha = truth.mp, truth.alpha
    A, beta2 = truth.axial + alpha**2, 1 - truth.eta_b**2
    # with z = p₁²: (2A − z)² (α² − z) = 4α² [(z − A)² − β²]
    square, twice = [1, -4 * A, 4 * A**2], [1, -2 * A, A**2 - beta2]
    left = [-square[0], alpha**2 * square[0] - square[1], alpha**2 * square[1] - square[2], alpha**2 * square[2]]
    cubic = [left[0], *(a - 4 * alpha**2 * b for a, b in zip(left[1:], twice, strict=True))]
    found = []
    for z in mp.polyroots([mp.mpf(c) for c in cubic], maxsteps=500, extraprec=400):
        for p in (mp.sqrt(z), -mp.sqrt(z)):
            r = p * (2 * A - z) / (2 * alpha)
            if abs(mp.im(r)) > 1e-6:
                found.append(r + mp.j * truth.eta_b)
    return found


@pytest.mark.parametrize("eta_b", ["0", "0.05", "0.5"])
@pytest.mark.parametrize("alpha", ["0.3", "0.67", "1.2"])
@pytest.mark.parametrize("offset", ["1e-30", "1e-12"])
def test_nothing_is_lost_at_a_collision(alpha: str, eta_b: str, offset: str) -> None:
    """The paper leaves these cases out, after (39). δ² is about the offset."""
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=1)
    seen = 0
    for centre in collisions(case, 100):
        truth = Truth(case, 150)
        q = truth.mp.mpc(centre) * (1 + truth.mp.mpf(offset))
        for xi in (1.5, -1.5):
            exact = truth.kernel(xi, q), truth.kernel_rate(xi, q)
            with ball_arithmetic(64) as field:
                for ball, value in zip(rates_at(track(case, field), flint.acb(q), xi, flint.arb), exact, strict=True):
                    assert holds(ball, value)
                    assert sharp(ball, 40)
            for number, value in zip(rates_at(track(case, MP(100)), q, xi), exact, strict=True):
                assert abs(number - value) < 1e-20 * abs(value)
            flat = rates_at(track(case, Float64()), np.array([complex(q)]), xi)
            for number, value in zip(flat, exact, strict=True):
                assert abs(complex(number[0]) - complex(value)) < 1e-10 * abs(complex(value))
            pair = pairing(track(case, MP(400)), q)
            seen += abs(pair.discriminant(AHEAD if xi > 0 else BEHIND)) < 10 * float(offset)
    assert seen >= 2, "no pair of p-roots met"
