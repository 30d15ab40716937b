"""Makes certificates of version 2 for tests: bisects pieces by the verifier's own tests, finds roots in floats.

Slow and simple; it shares the verifier's piece tests on purpose (files to verify, before and beside the real prover).
Numbers come in and go out in the problem's own units.
"""

from __future__ import annotations

import itertools
import json
from fractions import Fraction
from math import pi

import numpy as np
from flint import acb, arb, fmpq
from forging import sealed

from mpsolve.certificate import verify2 as v2


class NotPlanned(Exception):  # noqa: N818
    pass


# --- equations -----------------------------------------------------------------------------------------------


def poly(*terms):
    """An entry of a track's matrix from (i, j, c): c P^i s^j."""
    return [[i, j, str(Fraction(c))] for i, j, c in terms if Fraction(c)]


def F(x):
    return Fraction(str(x))


def beam(EI, m, k, c, kp=0, N=0, eta=0):
    EI, eta = F(EI), F(eta)
    return {
        "matrix": [
            [poly((4, 0, EI), (4, 1, EI * eta), (2, 0, F(N) - F(kp)), (0, 2, F(m)), (0, 1, F(c)), (0, 0, F(k)))]
        ],
        "loaded": 0,
    }


def string(T, m, k, c):
    return {"matrix": [[poly((2, 0, -F(T)), (0, 2, F(m)), (0, 1, F(c)), (0, 0, F(k)))]], "loaded": 0}


def timoshenko(EI, m, J, S, k, c):
    a = poly((2, 0, -F(S)), (0, 2, F(m)), (0, 1, F(c)), (0, 0, F(k)))
    return {
        "matrix": [[a, poly((1, 0, F(S)))], [poly((1, 0, -F(S))), poly((2, 0, -F(EI)), (0, 2, F(J)), (0, 0, F(S)))]],
        "loaded": 0,
    }


def two_layer(EI, m, kpad, cpad, ms, kb, cb):
    pad = poly((0, 0, -F(kpad)), (0, 1, -F(cpad)))
    rail = poly((4, 0, F(EI)), (0, 2, F(m)), (0, 0, F(kpad)), (0, 1, F(cpad)))
    below = poly((0, 2, F(ms)), (0, 0, F(kpad) + F(kb)), (0, 1, F(cpad) + F(cb)))
    return {"matrix": [[rail, pad], [pad, below]], "loaded": 0}


def exact(a):
    return [[str(F(x)) for x in row] for row in a]


def vehicle(M, C, K, B, places, h):
    return {
        "M": exact(M),
        "C": exact(C),
        "K": exact(K),
        "B": exact(B),
        "places": [str(F(x)) for x in places],
        "compliances": [str(Fraction(x)) for x in h],
    }


def masses(values, places):
    n = len(values)
    zero = [[0] * n for _ in range(n)]
    one = [[int(i == j) for j in range(n)] for i in range(n)]
    return vehicle(
        [[values[i] if i == j else 0 for j in range(n)] for i in range(n)], zero, zero, one, places, [0] * n
    )


def joined(mass, spring, distance):
    zero = [[0, 0], [0, 0]]
    return vehicle(
        [[mass, 0], [0, mass]],
        zero,
        [[spring, -F(spring)], [-F(spring), spring]],
        [[1, 0], [0, 1]],
        [0, distance],
        [0, 0],
    )


def bogie(frame, pitch, wheelset, k1, c1, kH, base):
    arm, n = F(base) / 2, 4
    M = [
        [F(x) if i == j else Fraction(0) for j in range(n)] for i, x in enumerate((frame, pitch, wheelset, wheelset))
    ]
    C, K = ([[Fraction(0)] * n for _ in range(n)] for _ in range(2))
    for side, w in ((-arm, 2), (arm, 3)):
        g = [Fraction(1), side, Fraction(0), Fraction(0)]
        g[w] = Fraction(-1)
        for i in range(n):
            for j in range(n):
                K[i][j] += F(k1) * g[i] * g[j]
                C[i][j] += F(c1) * g[i] * g[j]
    B = [[0, 0], [0, 0], [1, 0], [0, 1]]
    h = [0, 0] if kH is None else [1 / F(kH)] * 2
    return vehicle(M, C, K, B, [0, base], h)


def equations(track, velocity, car):
    return {"track": track, "velocity": str(F(velocity)), "vehicle": car}


# --- numbers ---------------------------------------------------------------------------------------------------


def q_(x):
    """An exact rational from a float, rounded to 30 bits."""
    m, e = np.frexp(float(x))
    return fmpq(round(m * 2**30)) * v2.power_of_2(int(e) - 30)


def as_dyadic(x):
    p, q = int(x.p), int(x.q)
    if q & (q - 1):
        raise NotPlanned("not dyadic")
    return [p, 1 - q.bit_length()]


def as_point(z):
    if any(int(x.q) & (int(x.q) - 1) for x in z):
        return [f"{x.p}/{x.q}" for x in z]
    e = min(as_dyadic(x)[1] for x in z)
    return [*(int(x * v2.power_of_2(-e)) for x in z), e]


# --- floats: an independent receptance and count ------------------------------------------------------------------


class Floats:
    """G and Δ in floats by residues over the roots of largest imaginary part."""

    def __init__(self, content):
        eq = content["equations"]
        self.track = v2.read_track(eq["track"], eq["velocity"])
        self.car = v2.read_vehicle(eq["vehicle"], content["basis"])
        self.v = float(arb(self.track.v))
        D, N = ({k: float(arb(c)) for k, c in t.items()} for t in (self.track.d, self.track.n))
        self.tables = []
        for t in (D, N):
            a = np.zeros([1 + max(k[i] for k in t) for i in (0, 1)])
            for (i, j), c in t.items():
                a[i, j] = c
            self.tables.append(a)
        self.M, self.C, self.K, self.B = (
            np.array([[float(arb(x)) for x in r] for r in a.tolist()]) for a in (*self.car.numbers, self.car.B)
        )
        self.h = np.diag([float(arb(v2.at(x, ()))) for x in self.car.h])
        self.x = np.array([float(arb(v2.at(x, ()))) for x in self.car.places])
        self.sites = np.array([float(arb(x)) for x in self.car.sites])
        self.upper = self.up(-1j * (1 + abs(self.v)))

    def roots(self, q):
        c = [a @ ((1j * q) ** np.arange(a.shape[1])) for a in self.tables]
        return np.roots(c[0][::-1]), c

    def up(self, q):
        return int(np.sum(self.roots(q)[0].real < 0))

    def G(self, q, x):
        P, (d, n) = self.roots(q)
        P = P[np.argsort(P.real)]
        w = np.polyval(n[::-1], P) / np.polyval(np.polyder(d[::-1]), P)
        gap = np.subtract.outer(x, x)
        ahead, behind = P[: self.upper], P[self.upper :]
        plus = (w[: self.upper] * np.exp(np.maximum(gap, 0)[..., None] * ahead)).sum(-1)
        minus = -(w[self.upper :] * np.exp(np.minimum(gap, 0)[..., None] * behind)).sum(-1)
        return np.where(gap >= 0, plus, minus)

    def matrix(self, q):
        S = self.K + 1j * q * self.C - q * q * self.M
        for k in range(self.car.neutral):
            i = len(S) - 1 - k
            S[i] = (self.C + 1j * q * self.M)[i]
        return np.block([[S, -self.B], [self.B.T, self.G(q, self.x) + self.h]])

    def det(self, q):
        A = self.matrix(q)
        return np.linalg.det(A / np.abs(self.scale)) if hasattr(self, "scale") else np.linalg.det(A)

    def turn(self, points, step=0.3):
        """Change of arg Δ along a polygon, by steps below `step`."""
        total = 0.0
        for a, b in itertools.pairwise(points):
            t, h, f = 0.0, 1 / 64, self.det(a)
            while t < 1:
                h = min(h, 1 - t)
                g, half = self.det(a + (t + h) * (b - a)), self.det(a + (t + h / 2) * (b - a))
                turns = np.angle(half / f), np.angle(g / half)
                if max(map(abs, turns)) > step and h > 1e-12:
                    h /= 2
                    continue
                total, t, f, h = total + sum(turns), t + h, g, h * 1.6
        return total

    def passive(self, q):
        V = 1j * q * self.G(q, self.sites)
        return np.linalg.eigvalsh((V + V.conj().T) / 2)[0] > 0

    def full_count(self, radius, height=0.0):
        """Roots in the half disc Im q < 0 and the strip below `height`, by the argument principle: Δ along the boundary."""  # noqa: E501
        arc = [radius * np.exp(-1j * t) for t in np.linspace(0, pi / 2, 40)]
        side = np.linspace(height, 0, 10)[:-1] if height else []
        return (
            -self.turn([*(radius * np.geomspace(1e-6, 1, 60) + 1j * height), *(radius + 1j * np.array(side)), *arc])
            / pi
        )


def newton(f, q, steps=40):
    for _ in range(steps):
        h = 1e-6 * (abs(q) + 1e-3)
        slope = (f(q + h) - f(q - h)) / (2 * h)
        step = f(q) / slope
        q = q - step
        if abs(step) < 1e-13 * abs(q):
            break
    return q


# --- the theorem at large q ----------------------------------------------------------------------------------------


def value(t, x, y):
    a = np.zeros([1 + max(k[i] for k in t) for i in (0, 1)])
    for (i, j), c in t.items():
        a[i, j] = float(arb(c))
    return np.polynomial.polynomial.polygrid2d(x, y, a)


def plan_tail(track, sites, X):
    """Numbers of the theorem for q ≥ X, or None: sampled, with a margin."""
    w, d = (v2.terms(x) for x in v2.absorption(v2.RING, track.D, track.N))
    v = float(arb(track.v))
    between = 2 * pi / float(min(b - a for a, b in itertools.pairwise(sites))) if len(sites) > 1 else 0.0
    iw, nw, id_, nd = max(i for i, _ in w), max(map(sum, w)), max(i for i, _ in d), max(map(sum, d))
    alpha = min(id_ - iw, nd - nw)
    if alpha < 2:
        return None
    near, far = ({}, {}), ({}, {})
    for which, (source, less) in enumerate(((d, 0), (w, alpha))):
        for (i, j), c in source.items():
            near[which][(id_ - less - i, j)] = c * (-1) ** j
            at = (id_ - less - i, nd - less - i - j)
            far[which][at] = far[which].get(at, fmpq(0)) + c * (-1) ** j
    omega = float(q_(X / 2))
    u, o = np.linspace(0, v / X, 40), np.linspace(0, omega, 300)
    r, z = np.linspace(0, v, 150), np.linspace(0, 1 / omega, 150)
    inside = np.outer(r, z) <= v / X
    with np.errstate(all="ignore"):
        C1 = np.max(-value(near[1], u, o) / value(near[0], u, o))
        ratio = -value(far[1], r, z) / value(far[0], r, z)
        C2 = np.max(np.where(inside, ratio, 0))
        smallest = min(np.min(value(near[0], u, o)), np.min(np.where(inside, value(far[0], r, z), np.inf)))
    if not smallest > 0:
        return None
    C = q_(1.15 * max(C1, C2) + 1e-300)
    for k, m in ((0, 1), (1, 4), (1, 2), (1, 1), (1, 3)):
        bw, tw = v2.in_block(w, {(): track.v}, k, m)
        bd, td = v2.in_block(d, {(): track.v}, k, m)
        if (alpha - 1) * m < td - tw - k:
            continue
        growth, most = X ** (k / m), 0.95 * X ** (1 - k / m) / v
        tau = np.linspace(0, X ** (-1 / m), 12)
        for cells in ([-3.0, -1.0, 0.0, 0.2, 0.5, 0.95], resonances(bd, most)):
            edges = np.array(
                sorted({float(arb(q_(x))) for x in (np.array(cells) * (most / 0.95) if len(cells) == 6 else cells)})
            )
            kept = []
            for z1, z2 in itertools.pairwise(edges):
                with np.errstate(all="ignore"):
                    z = np.linspace(z1, z2, 60)
                    kappa = 0.8 * np.min(value(bw, z, tau) / value(bd, z, tau))
                if (
                    kappa > 0
                    and np.isfinite(kappa)
                    and (z2 - z1) * growth > 1.01 * between
                    and absorbs(bw, bd, z1, z2, kappa, tau[-1])
                ):
                    kept.append((z1, z2, kappa))
            takes = sum(((b - a) * growth - between) * kappa for a, b, kappa in kept) * X ** ((tw - td) / m)
            Cf = float(arb(C))
            gives = Cf * ((v / X) ** (alpha - 1) / (alpha - 1) + between * (v / X) ** alpha)
            if takes > 1.02 * gives:
                return {
                    "gamma": [k, m],
                    "blocks": [[as_dyadic(q_(x)) for x in one] for one in kept],
                    "alpha": int(alpha),
                    "omega": as_dyadic(q_(omega)),
                    "envelope": as_dyadic(C),
                }
    return None


def absorbs(bw, bd, z1, z2, kappa, tau):
    """Whether the verifier's test of the block holds."""
    f = {at: bw.get(at, fmpq(0)) - q_(kappa) * bd.get(at, fmpq(0)) for at in {*bw, *bd}}
    try:
        with v2.precision(128):
            v2.check_positive(f, ((q_(z1), q_(z2)), (fmpq(0), q_(tau))), None, "")
    except v2.Refused:
        return False
    return True


def resonances(bd, most):
    """Edges of cells, geometrically spaced round the least values of |D|² at infinite q."""
    z = np.concatenate([-np.geomspace(1e-3, 20, 3000)[::-1], np.geomspace(1e-3, 1, 3000)]) * most
    d = value(bd, z, np.zeros(1))[:, 0]
    least = [z[i] for i in range(1, len(z) - 1) if d[i] < d[i - 1] and d[i] < d[i + 1]]
    return [
        x
        for x in [r + s * abs(r) * g for r in least for s in (-1, 1) for g in np.geomspace(2e-3, 0.5, 12)]
        if x < most
    ]


# --- paths -----------------------------------------------------------------------------------------------------------  # noqa: E501


def moved(walker, kind, mark, where):
    """The mark there, and the change of arg Δ̂ from the matrices at both ends."""
    walker.marks[mark.q] = mark
    (_, end), turns = walker.chain(kind, [mark.q, where])
    return end, walker.turned([mark, end], turns) if turns else arb(0)


def walk(walker, kind, corners):
    """Points along the polygon; each piece passes the verifier's tests."""
    at = corners[0]
    mark, points, total = walker.marks[at], [at], arb(0)
    for b in corners[1:]:
        length = float(arb(sum(abs(x - y) for x, y in zip(mark.q, b, strict=False))))
        h, t, a = 1 / 16, 0.0, mark.q
        while mark.q != b:
            to = min(1.0, t + h)
            to = to if to < 1 else 1.0
            where = b if to == 1.0 else tuple(x + q_(to) * (y - x) for x, y in zip(a, b, strict=False))
            try:
                end, turned = moved(walker, kind, mark, where)
            except v2.Refused as no:
                h /= 2
                if h < 1e-7:
                    raise NotPlanned(
                        f"{kind} at {float(arb(mark.q[0]))}, {float(arb(mark.q[1]))} of {length}: {no}"
                    ) from None
                continue
            mark, t, total, h = end, to, total + turned, h * 1.3
            points.append(mark.q)
    walker.marks[corners[-1]] = mark
    return points, total


def arc(walker, radius):
    """Points of the quarter arc from radius to −i radius."""
    mark, points, total, t, h = walker.marks[radius, fmpq(0)], [(radius, fmpq(0))], arb(0), 0.0, 0.05
    R = float(arb(radius))
    while t < 1:
        to = min(1.0, t + h)
        where = (
            (fmpq(0), -radius)
            if to == 1.0
            else tuple(q_(x) for x in (R * np.cos(to * pi / 2), -R * np.sin(to * pi / 2)))
        )
        try:
            end, turned = moved(walker, "turn", mark, where)
        except v2.Refused as no:
            h /= 2
            if h < 1e-7:
                raise NotPlanned(f"arc at {t}: {no}") from None
            continue
        mark, t, total, h = end, to, total + turned, h * 1.3
        points.append(mark.q)
    walker.marks[points[-1]] = mark
    return points, total


def plan_rho(floats, X):
    """About the least frequency from which on the receptance is passive, by floats."""
    qs = np.geomspace(X / 3000, X, 600)
    bad = [q for q in qs if not floats.passive(q)]
    return float(max([*bad, X / 30])) * 1.05


def plan(eq, region, roots=True, start=None, basis=None, bits=64, rho=None, depth=None):  # noqa: C901
    """A sealed certificate of the region, its roots found by Newton's method from the float determinant."""
    content = {
        "format": "mpsolve certificate",
        "version": 2,
        "kind": "spectrum",
        "equations": eq,
        "basis": basis,
        "bits": bits,
    }
    floats = Floats(content)
    track, car = floats.track, floats.car
    reg = v2.read_region(region)
    with v2.precision(bits):
        waves = v2.Waves(track, car.places)
        walker = v2.Walker(waves, v2.Bordered(car, waves))
        passive = reg.kind in ("unstable", "below")
        theorem, X = None, None
        if passive and track.v != 0:
            X = start_x(floats)
            while theorem is None:
                theorem = plan_tail(track, car.sites, X)
                if theorem is not None:
                    with v2.precision(128):
                        try:
                            v2.check_tail(track, theorem, q_(X), car.sites)
                        except v2.Refused:
                            theorem = None
                if theorem is None:
                    X *= 1.25
                    if X > 1e12:
                        raise NotPlanned("no theorem")
        if reg.re:
            rho_ = max(abs(x) for x in reg.re)
        elif reg.reach is not None:
            rho_ = reg.reach
        else:
            rho_ = q_(rho or (plan_rho(floats, X) if X else 1))
        y0 = q_(start or float(arb(rho_)))
        if reg.kind == "unstable" and track.v == 0:
            return sealed(
                content
                | {
                    "start": [1, 0],
                    "paths": [],
                    "theorem": None,
                    "claim": {"region": region, "count": 0, "unstable": 0},
                    "roots": [],
                }
            )
        walker.begin(y0)
        zero = fmpq(0)
        X = max(q_(X), rho_) if X else None
        first = (zero, -y0)
        if reg.re:
            (a, b), (c, d) = reg.re, reg.im
            link = walk(walker, "link", [first, (a, c)])[0]
            turn, T = walk(walker, "turn", [(a, c), (b, c), (b, d), (a, d), (a, c)])
            paths = [("link", link), ("turn", turn)]
            number = T / (2 * arb.pi())
        else:
            via = [(zero, zero)] if reg.height == 0 else [(zero, zero), (zero, reg.height)]
            link = walk(walker, "link", [first, *via])[0]
            up = [via[-1]] + ([(rho_, reg.height)] if reg.height > 0 else []) + [(rho_, zero)]
            turn, T = walk(walker, "turn", up)
            paths = [("link", link), ("turn", turn)]
            if passive and track.v == 0:
                number = (
                    v2.closing(walker, walker.marks[rho_, zero])
                    + (len(floats.K) - len(floats.x) - car.neutral) * arb.pi() / 2
                    - T
                ) / arb.pi()
            elif passive:
                d = q_(depth or float(arb(rho_)))
                walls = walk(walker, "passive", [(rho_, zero), (rho_, -d), (zero, -d)])[0]
                axis = walk(walker, "passive", [(rho_, zero), (X, zero)])[0] if rho_ < X else [(rho_, zero)]
                paths += [("passive", walls), ("passive", axis)]
                number = (
                    v2.closing(walker, walker.marks[rho_, zero])
                    + (len(floats.K) - len(floats.x) - car.neutral) * arb.pi() / 2
                    - T
                ) / arb.pi()
            else:
                more, U = arc(walker, rho_)
                paths[1] = ("turn", turn + more[1:])
                number = -(T + U) / arb.pi()
    n = number.unique_fmpz()
    if n is None:
        raise NotPlanned(f"no integer: {number}")
    content |= {
        "start": as_dyadic(y0),
        "paths": [{"kind": k, "points": [as_point(z) for z in pts]} for k, pts in paths],
        "theorem": theorem,
        "claim": {"region": region, "count": int(n), "unstable": 0},
        "roots": [],
    }
    if roots:
        find_roots(content, floats, reg, float(arb(rho_)))
    return sealed(content)


def start_x(floats):
    """A first guess of X: the greatest frequency found where the receptance is not passive."""
    t = floats.tables[0]
    unit = float((abs(t[0, 0]) / abs(t[0, -1])) ** (1 / (t.shape[1] - 1)))
    qs = unit * np.geomspace(1e-2, 1e3, 400)
    return float(max((q for q in qs if not floats.passive(q)), default=qs[0]))


def find_roots(content, floats, reg, rho):
    """Newton from a grid of starts until as many as counted are found; balls of 1e-9 relative, refined at 128 bits."""  # noqa: E501
    n = content["claim"]["count"]
    found = []
    rng = np.random.default_rng(1)
    low = float(arb(reg.im[0])) if reg.im else -rho / 2
    high = float(arb(reg.height))
    tries = 0
    while total(found, reg) < n and tries < 4000:
        tries += 1
        if tries % 3 == 0 and not reg.re:
            guess = 1j * rng.uniform(low, high)
        else:
            guess = rng.uniform(0 if not reg.re else -rho, rho) * (1 if tries % 2 else rng.uniform(0, 0.3)) + 1j * (
                rng.uniform(low, high) if tries % 2 else rng.uniform(0.1 * low, high)
            )
        try:
            with np.errstate(all="ignore"):
                q = newton(floats.det, complex(guess))
        except (np.linalg.LinAlgError, OverflowError, ZeroDivisionError):
            continue
        if not np.isfinite(q):
            continue
        if abs(q.real) < 1e-9 * abs(q):
            q = 1j * q.imag
        if q.real < 0 and not reg.re:
            q = -q.conjugate()
        radius = max(abs(q) * 2.0**-30, 1e-12 * rho)
        z = (fmpq(*float(q.real).as_integer_ratio()), fmpq(*float(q.imag).as_integer_ratio()))
        if not reg.holds(z, q_(radius)) or any(abs(q - p) < 1e3 * radius for p in found):
            continue
        A = floats.matrix(q)
        if np.linalg.svd(A / np.abs(A).max(1)[:, None], compute_uv=False)[-1] > 1e-6:
            continue
        found.append(q)
    if total(found, reg) != n:
        raise NotPlanned(f"{found} found, {n} counted")
    content["roots"] = [as_root(q, bool(q.real), 2.0**-30) for q in sorted(found, key=lambda z: (z.real, z.imag))]
    content["claim"]["unstable"] = sum((2 if q.real and not reg.re else 1) for q in found if q.imag < 0)
    if reg.re:
        for root in content["roots"]:
            root["pair"] = False


def total(found, reg):
    return sum(2 if q.real and not reg.re else 1 for q in found)


def as_root(q, pair, relative):
    e = int(np.floor(np.log2(abs(q)))) - 52
    re, im = (round(x * 2.0**-e) for x in (q.real, q.imag))
    return {
        "re": hex(re),
        "im": hex(im),
        "exponent": e,
        "radius": [1, e + 52 + int(np.log2(relative))],
        "multiplicity": 1,
        "pair": pair,
    }


def save(content, path):
    path.write_text(json.dumps(content, indent=None) + "\n")


def refine(content, digits):
    """The same certificate with every root to so many digits, by Newton's method on the verifier's own function."""
    bits = int(digits * 3.33) + 40
    car = v2.read_vehicle(content["equations"]["vehicle"], content["basis"])
    track = v2.read_track(content["equations"]["track"], content["equations"]["velocity"])
    roots = []
    for value in content["roots"]:
        root = v2.read_root(value)
        with v2.precision(bits + 64):
            waves = v2.Waves(track, car.places)
            bordered = v2.Bordered(car, waves)
            sigma = v2.at_q(root.z)
            for _ in range(bits.bit_length()):
                place = v2.Place.disc(sigma, r := abs(sigma) * arb(2) ** -(bits // 2))
                found = v2.Apart.of(local := waves.near(place), *v2.sorted_roots(local))
                (first, slope), _ = v2.block(bordered(place, v2.kernels(waves, [found])[0][0]), 1)
                sigma = (sigma - first[0, 0] / slope[0, 0] * r).mid()
                if not root.pair and root.z[0] == 0:
                    sigma = acb(sigma.real)
            q = sigma / acb(0, 1)
            e = value["exponent"] + 52 - bits
            re, im = (int((x * arb(2) ** -e).mid().floor().unique_fmpz()) for x in (q.real, q.imag))
        roots.append(value | {"re": hex(re), "im": hex(im), "exponent": e, "radius": [64, e]})
    return sealed(content | {"roots": roots})
