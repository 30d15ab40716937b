"""A motion of an endless row that grows: found in float64, proved in balls."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import acb_mat

from mpsolve.characteristic.proved import Proved
from mpsolve.endless.axis import gains
from mpsolve.endless.bloch import Bloch
from mpsolve.endless.lattice import Lattice
from mpsolve.endless.row import Row
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import Balls, acb, arb, precision, rational_ball
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.reduction import Reduction
from mpsolve.proof.ladder import climb
from mpsolve.proof.newton import isolated, polished
from mpsolve.spectrum.enclose import Scalar

_K = Balls()
_POINTS = 600
_STEPS = 30
_BITS, _MOST = 106, 424


@dataclass(frozen=True)
class Growing(Portable):
    """A proved motion e^{iqt} that changes by e^{iθ} from each vehicle to the next one ahead: q lies in the ball `q`.

    theta: κ times the spacing, exactly this float. q: in the problem's units, Im q < 0.
    """

    theta: float
    q: Any

    @property
    def growth(self) -> float:
        """−Im q, the rate of growth."""
        return -float(self.q.imag.mid())


class RowProved(Proved):
    """Δ̂(z, σ) of a row in balls, at one z (a ball on the unit circle), at the precision that is set."""

    def __init__(self, row: Row, z: acb) -> None:
        super().__init__(row.reduced)
        self.row, self.z = row, z

    def matrices(self, sigma: Any, slope: bool = True, mean: bool = True) -> tuple[acb_mat, acb_mat | None]:  # noqa: ARG002
        """A(σ) and A'(σ) with the receptance of the row in the place of that of the track."""
        sigma = acb(sigma)
        split = self.splitting(sigma)
        if split.roots is None:
            raise PrecisionError("two p-roots of one side meet, where the row's sums are not known")
        lattice = Lattice(self.border.distances, self.row.step)
        G, slopes = lattice.sums(split.terms, self.upper, self.z, rational_ball, lambda x: x.exp())
        if not all(g.is_finite() for g in (*G, *slopes)):
            raise PrecisionError("the receptance of the row may be infinite over the ball")
        A_sigma = self.border.slope_at(_K, sigma, G, slopes) if slope else None
        return self.border.at(_K, sigma, G), A_sigma


def find_growing(row: Row, most: float) -> Growing | None:
    """A growing motion whose frequency at the threshold is below `most` (scaled); None where none is found."""
    best = max(_seeds(row, most), key=lambda seed: seed[1].real, default=None)
    return None if best is None else prove_growing(row, *best)


def prove_growing(row: Row, theta: float, sigma: complex) -> Growing | None:
    """The root σ near the seed for z = e^{iθ}, proved; None where it is not proved to grow."""

    def attempt(bits: int) -> Any:
        z = acb(0, arb(theta)).exp()
        proved = RowProved(row, z)
        A, _ = proved.matrices(acb(sigma), slope=False)
        function = Scalar(proved, Reduction.of(A, near_root=True))
        middle = polished(function, acb(sigma))
        size = abs(middle).upper() * arb(2) ** (-bits // 4)
        return isolated(function, middle, size).image

    try:
        image = climb(attempt, _BITS, _MOST)
    except PrecisionError:
        return None
    with precision(_MOST):
        q = -acb(0, 1) * image * rational_ball(row.reduced.frequency_unit)
        return Growing(theta, q) if q.imag < 0 else None


def _seeds(row: Row, most: float) -> list[tuple[float, complex]]:
    """(θ, σ) of growing motions, by Newton's method from roots z that have crossed the circle on the real axis."""
    bloch = Bloch(row)
    around = [gain.q for gain in gains(bloch, most)]
    q = np.concatenate([np.linspace(most * 1e-3, most, _POINTS), around])
    ahead, back = bloch.middle(1j * q)
    crossed = np.concatenate([ahead[np.abs(ahead) > 1], back[np.abs(back) < 1]])
    sigma = 1j * np.concatenate([q[np.abs(ahead) > 1], q[np.abs(back) < 1]])
    theta = np.angle(crossed)
    with np.errstate(all="ignore"):
        for _ in range(_STEPS if len(sigma) else 0):
            value, slope = bloch.delta(sigma, np.exp(1j * theta))
            step = value / slope
            sigma = np.where(np.isfinite(step), sigma - step, np.nan)
            sigma = np.where(sigma.real > -0.1 * np.abs(sigma), sigma, np.nan)
            kept = np.isfinite(sigma)
            sigma, theta = sigma[kept], theta[kept]
            if not len(sigma):
                break
    return [(float(t), complex(s)) for t, s in zip(theta, sigma, strict=True) if s.real > 0 and s.imag > 0]
