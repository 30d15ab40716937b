"""R·Δ from the p-roots, for any number of masses, in any arithmetic: what stays finite where p-roots meet.

With the upper roots a, b and the lower roots c, e, R = (a − c)(a − e)(b − c)(b − e), and

    R det[ unit·I − κ K M ]

the poles of K at a collision of an upper with a lower root cancel against R by algebra, not by division, so that
an enclosure may hold the collision itself. κ = 2q²/π and unit = 1 give R·Δ; other values the same determinant in
homogeneous form. Numbers may be balls, discs, or dual numbers over them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from mpsolve.model.branch import Track


@dataclass(frozen=True)
class SplitRoots:
    """The p-roots: a, b above the real axis and c, e below it."""

    a: Any
    b: Any
    c: Any
    e: Any

    @property
    def R(self) -> Any:
        return (self.a - self.c) * (self.a - self.e) * (self.b - self.c) * (self.b - self.e)


def scaled_characteristic(track: Track, roots: SplitRoots, kappas: Sequence[Any], unit: Any = 1) -> list[Any]:
    """R det[unit·I − κ K M] for each κ; `track.field` gives π, i and `one_minus_exp`."""
    expand = {1: _expand_one, 2: _expand_two}.get(len(track.eta_m), _expand_many)
    return expand(track, roots, kappas, unit)


def _expand_one(track: Track, z: SplitRoots, kappas: Sequence[Any], unit: Any) -> list[Any]:
    """R (1 − κ η K(0)) with R K(0) = −4πi s."""
    contact = 4 * track.field.pi * track.field.i * (z.a + z.b)
    return [unit * z.R + kappa * track.eta_m[0] * contact for kappa in kappas]


def _expand_two(track: Track, z: SplitRoots, kappas: Sequence[Any], unit: Any) -> list[Any]:
    """R [1 − κ (η₁ + η₂) K(0) + κ² η₁ η₂ (K(0)² − K(d) K(−d))], the last by a double divided difference.

    R (K(0)² − K(d)K(−d)) = 4π² Σ R c_j c_l (1 − e^{i(p_j − p_l)d}) over upper j and lower l, where
    R c_a c_c = (b − e)/((a − b)(a − c)(c − e)) and (1 − e^{izd})/z is entire in z.
    """
    pi, (eta1, eta2) = track.field.pi, track.eta_m
    distance = track.positions[1] - track.positions[0]

    def phi(z: Any) -> Any:
        return track.field.one_minus_exp(z, distance)

    ac, ae, bc, be = z.a - z.c, z.a - z.e, z.b - z.c, z.b - z.e
    numerator = be * phi(ac) - bc * phi(ae)
    numerator += ac * phi(be) - ae * phi(bc)
    pairs = 4 * pi * pi * numerator / ((z.a - z.b) * (z.c - z.e)) * (eta1 * eta2)
    contact = 4 * pi * track.field.i * (z.a + z.b) * (eta1 + eta2)
    R = ac * ae * (bc * be)
    return [unit * (unit * R) + kappa * (unit * contact + kappa * pairs) for kappa in kappas]


def _expand_many(track: Track, z: SplitRoots, kappas: Sequence[Any], unit: Any) -> list[Any]:
    """R det[I − κ K M]: as it stands where all p-roots are apart, else bordered."""
    z = track.field.nearest_pair_first(z)
    return list(
        track.field.choose(
            z, lambda: _expand_apart(track, z, kappas, unit), lambda: _expand_bordered(track, z, kappas, unit)
        )
    )


def _expand_apart(track: Track, z: SplitRoots, kappas: Sequence[Any], unit: Any) -> list[Any]:
    """K from its residues, K/(2πi) = Σ e^{ipξ}/D_p over the upper roots (ξ ≥ 0), −Σ over the lower ones."""
    a, b, c, e, i = z.a, z.b, z.c, z.e, track.field.i
    ahead = ((a, 1 / ((a - b) * (a - c) * (a - e))), (b, 1 / ((b - a) * (b - c) * (b - e))))
    behind = ((c, -1 / ((c - a) * (c - b) * (c - e))), (e, -1 / ((e - a) * (e - b) * (e - c))))
    x, order = track.positions, range(len(track.eta_m))
    contact = ahead[0][1] + ahead[1][1]
    waves = [
        [_wave_sum(i, ahead if j > k else behind, x[j] - x[k]) if j != k else contact for k in order] for j in order
    ]
    values = []
    for kappa in kappas:
        scale = 2 * track.field.pi * i * kappa
        rows = [[(unit if j == k else 0) - scale * waves[j][k] * track.eta_m[k] for k in order] for j in order]
        values.append(z.R * track.field.det(rows))
    return values


def _wave_sum(i: Any, terms: Sequence[tuple[Any, Any]], xi: Any) -> Any:
    (p, u), (o, v) = terms
    return (i * p * xi).exp() * u + (i * o * xi).exp() * v


def _expand_bordered(track: Track, z: SplitRoots, kappas: Sequence[Any], unit: Any) -> list[Any]:
    """R det[I − κ K M] as a bordered determinant: the colliding pair's pole of K has rank one.

    With the pair (a, c): K/(2πi) = c_a u vᵀ + F, u_j = e^{ia x_j}, v_k = e^{−ia x_k}, and F finite. Then
    R det(A + κ' c_a u vᵀ) = det [[A, −κ' (R c_a) u], [vᵀ, R]], where R c_a = (b − c)(b − e)/(a − b).
    """
    i, x, order = track.field.i, track.positions, range(len(track.eta_m))
    two_pi_i = 2 * track.field.pi * i
    residue = (z.b - z.c) * (z.b - z.e) / (z.a - z.b)
    wave = [(i * z.a * place).exp() for place in x]
    finite = [[_finite_part(track, z, j, k) for k in order] for j in order]
    values = []
    for kappa in kappas:
        rows = []
        for j in order:
            row = [(unit if j == k else 0) - kappa * two_pi_i * finite[j][k] * track.eta_m[k] for k in order]
            rows.append([*row, kappa * two_pi_i * residue * wave[j]])
        rows.append([*(eta / w for eta, w in zip(track.eta_m, wave, strict=True)), z.R])
        values.append(track.field.det(rows))
    return values


def _finite_part(track: Track, z: SplitRoots, j: int, k: int) -> Any:
    """K/(2πi) less the rank-one pole: c_b e^{ibξ} ahead; −c_e e^{ieξ} − (c_c e^{icξ} + c_a e^{iaξ}) behind."""
    i, xi = track.field.i, track.positions[j] - track.positions[k]
    if j >= k:
        return (i * z.b * xi).exp() / ((z.b - z.a) * (z.b - z.c) * (z.b - z.e))
    far = (i * z.e * xi).exp() / ((z.e - z.a) * (z.e - z.b) * (z.e - z.c))
    at_a, at_c = (z.a - z.b) * (z.a - z.e), (z.c - z.b) * (z.c - z.e)
    # (e^{iaξ}/g(a) − e^{icξ}/g(c))/(a − c) with g(p) = (p − b)(p − e), by divided differences
    gap = -track.field.one_minus_exp(z.a - z.c, xi) / at_a - (z.a + z.c - z.b - z.e) / (at_a * at_c)
    return -far - (i * z.c * xi).exp() * gap
