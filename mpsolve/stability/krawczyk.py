"""Newton's step and Krawczyk's test: for a complex function of two real unknowns, and for n real equations."""

from __future__ import annotations

from typing import Any

import flint
import numpy as np

from mpsolve.discs import Discs

acb, arb, arb_mat = flint.acb, flint.arb, flint.arb_mat


def newton_step(f: Any, fx: Any, ft: Any) -> tuple[Any, Any] | None:
    """(u, v) with fx u + ft v = f at midpoints; None where the slopes are parallel. Heuristic."""
    f, fx, ft = f.mid(), fx.mid(), ft.mid()
    det = (fx.conjugate() * ft).imag
    if det.contains(0) or not f.is_finite():
        return None
    return _solve(f, fx, ft, det)


def _solve(f: Any, fx: Any, ft: Any, det: Any) -> tuple[Any, Any]:
    """(u, v) real with fx u + ft v = f: Cramer's rule on real and imaginary parts."""
    return (f.real * ft.imag - f.imag * ft.real) / det, (fx.real * f.imag - fx.imag * f.real) / det


def contracted(f: Any, fx: Any, ft: Any, x: Any, t: Any, dx: Any, dt: Any) -> tuple[Any, Any] | None:
    """The image of the box x ± dx, t ± dt, if it is proved to hold exactly one zero, or None. All four are exact.

    f at (x, t), fx and ft over the box: (x, t) − Y f + (I − Y J)(X − (x, t)), Y the inverse of the slopes'
    midpoint, lies in the interior of the box.
    """
    mx, mt = fx.mid(), ft.mid()
    det = (mx.conjugate() * mt).imag
    if det.contains(0) or not (fx.is_finite() and ft.is_finite()):
        return None
    u, v = _solve(f, mx, mt, det)
    xx, tx = _solve(mx - fx, mx, mt, det)
    xt, tt = _solve(mt - ft, mx, mt, det)
    spread_x, spread_t = arb(0, dx), arb(0, dt)
    move_x = -u + xx * spread_x + xt * spread_t
    move_t = -v + tx * spread_x + tt * spread_t
    if _within(move_x, dx) and _within(move_t, dt):
        return x + move_x, t + move_t
    return None


def contracted_all(values: Any, jacobian: Any, centre: Any, reaches: Any) -> list[Any] | None:
    """As `contracted`, for n real equations in n real unknowns: the image of the box centre ± reaches, or None.

    values: at the centre, arb of length n; jacobian: over the box, rows of arb, shape (n, n).
    """
    n = len(centre)
    slopes = arb_mat(n, n, [entry for row in jacobian for entry in row])
    middle = arb_mat(n, n, [entry.mid() for row in jacobian for entry in row])
    try:
        inverse = middle.inv()
    except ZeroDivisionError:
        return None
    inverse = arb_mat(n, n, [entry.mid() for entry in inverse.entries()])  # any matrix will do, an exact one is sharp
    one = arb_mat(n, n, [int(j == k) for j in range(n) for k in range(n)])
    spread = arb_mat(n, 1, [arb(0, reach) for reach in reaches])
    move = (one - inverse * slopes) * spread - inverse * arb_mat(n, 1, list(values))
    if all(_within(move[k, 0], reaches[k]) for k in range(n)):
        return [centre[k] + move[k, 0] for k in range(n)]
    return None


def _within(move: Any, reach: Any) -> bool:
    """Whether the ball lies in the interior of 0 ± reach. The ball arb(0, reach) may be wider by a rounding."""
    return bool(abs(move) < arb(reach))


def ball_of(z: Discs, k: int) -> Any:
    """The disc number k as a ball."""
    m, r = complex(z.m[k]), float(np.broadcast_to(z.r, z.m.shape)[k])
    return acb(arb(m.real, r), arb(m.imag, r))
