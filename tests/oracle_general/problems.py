"""Random problems: every track and vehicle, plausible and nasty, from a seed or from hypothesis alike.

All numbers are short decimal strings, so that the engine reads the same problem exactly.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
from hypothesis import strategies as st

from oracle_general.tracks import track


class Dice:
    """Choices that a random generator makes."""

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)

    def pick(self, options: list[Any]) -> Any:
        return options[int(self.rng.integers(len(options)))]

    def log(self, low: float, high: float) -> str:
        """A number between low and high, evenly in its logarithm, with three figures."""
        return figures(float(np.exp(self.rng.uniform(np.log(low), np.log(high)))))


class Drawn(Dice):
    """The same choices made by hypothesis, which makes them simpler where a test fails."""

    def __init__(self, draw: Any) -> None:
        self.draw = draw

    def pick(self, options: list[Any]) -> Any:
        return self.draw(st.sampled_from(options))

    def log(self, low: float, high: float) -> str:
        steps = self.draw(st.integers(0, 60))
        return figures(low * (high / low) ** (steps / 60))


def figures(x: float) -> str:
    return f"{x:.2e}" if x else "0"


@st.composite
def problems(draw: Any, model: str | None = None) -> dict[str, Any]:
    """Hypothesis' strategy of problems."""
    return random_problem(Drawn(draw), model)


def random_problem(dice: Dice, model: str | None = None) -> dict[str, Any]:
    model = model or dice.pick(list(MAKERS))
    guide, speed, length, time, weight = MAKERS[model](dice)
    vehicles = _vehicles(dice, weight, length, time)
    return {"track": {"model": model, **guide}, "vehicles": vehicles, "v": _velocity(dice, speed)}


def _velocity(dice: Dice, speed: float) -> str:
    kind = dice.pick(["rest", "slow", "any", "any", "any", "near", "fast", "fast"])
    if kind == "rest":
        return "0"
    low, high = {"slow": (0.01, 0.3), "any": (0.5, 2.5), "near": (0.99, 1.01), "fast": (1.0, 4)}[kind]
    return (
        f"{float(dice.log(low, high)) * speed:.4g}" if kind == "near" else figures(float(dice.log(low, high)) * speed)
    )


def _axial(dice: Dice, most: float) -> str:
    """An axial force: most buckles the track."""
    return dice.pick(
        ["0", "0", figures(float(dice.log(0.05, 0.95)) * most), "-" + figures(float(dice.log(0.05, 3)) * most)]
    )


Made = tuple[dict[str, str], float, float, float, float]


def _scales(EI: str, m: str, k: str) -> tuple[float, float, float, float]:
    """Critical speed, length, time, mass of the beam on springs."""
    e, a, b = float(EI), float(m), float(k)
    length, time = (4 * e / b) ** 0.25, (a / b) ** 0.5
    return (4 * b * e / a**2) ** 0.25, length, time, a * length


def _paper(dice: Dice) -> dict[str, str]:
    return {"EI": "0.25", "m": "1", "k": "1", "c": dice.log(0.002, 4)}


def _rail(dice: Dice) -> dict[str, str]:
    return {"EI": dice.log(1e6, 1e7), "m": dice.log(30, 150), "k": dice.log(1e5, 1e8), "c": dice.log(1e2, 1e5)}


def _string(dice: Dice) -> Made:
    a = {
        "T": dice.log(1e4, 3e4),
        "m": dice.log(0.5, 2),
        "k": dice.pick(["0", dice.log(1, 1e4)]),
        "c": dice.log(0.05, 50),
    }
    T, m, k = float(a["T"]), float(a["m"]), float(a["k"]) or 100.0
    return a, (T / m) ** 0.5, (T / k) ** 0.5, (m / k) ** 0.5, m * (T / k) ** 0.5


def _beam(dice: Dice) -> Made:
    a = dice.pick([_paper, _rail])(dice)
    speed, length, time, weight = _scales(a["EI"], a["m"], a["k"])
    a["N"] = _axial(dice, 2 * (float(a["k"]) * float(a["EI"])) ** 0.5)
    a["kp"] = dice.pick(["0", "0", figures(float(dice.log(0.01, 1)) * (float(a["k"]) * float(a["EI"])) ** 0.5)])
    a["eta"] = dice.pick(["0", "0", figures(float(dice.log(1e-4, 1)) * time)])
    if a["eta"] != "0":
        a["c"] = dice.pick([a["c"], "0"])
    return a, speed, length, time, weight


def _rayleigh(dice: Dice) -> Made:
    a, speed, length, time, weight = _beam(dice)
    a["eta"], a["c"] = "0", a["c"] if a["c"] != "0" else figures(0.1 * weight / length / time)
    a["J"] = figures(float(dice.log(1e-4, 0.5)) * float(a["m"]) * length**2)
    return a, dice.pick([speed, (float(a["EI"]) / float(a["J"])) ** 0.5]), length, time, weight


def _timoshenko(dice: Dice) -> Made:
    a = dice.pick([_paper, _rail])(dice)
    speed, length, time, weight = _scales(a["EI"], a["m"], a["k"])
    a["S"] = figures(float(dice.log(1, 1e3)) * float(a["EI"]) / length**2)
    a["J"] = figures(float(dice.log(1e-4, 0.3)) * float(a["m"]) * length**2)
    waves = [(float(a["S"]) / float(a["m"])) ** 0.5, (float(a["EI"]) / float(a["J"])) ** 0.5]
    return a, dice.pick([speed, speed, *waves]), length, time, weight


def _damping(dice: Dice, k: str, time: float) -> str:
    return figures(float(k) * time * float(dice.log(1e-3, 1)))


def _two_layer(dice: Dice) -> Made:
    a = {"EI": dice.log(1e6, 1e7), "m": dice.log(40, 80), "k_pad": dice.log(1e7, 1e9), "m_sleeper": dice.log(20, 600),
         "k_ballast": dice.log(1e6, 3e8)}  # fmt: skip
    speed, length, time, weight = _scales(a["EI"], a["m"], a["k_ballast"])
    a["c_pad"], a["c_ballast"] = _damping(dice, a["k_pad"], time), _damping(dice, a["k_ballast"], time)
    lost = dice.pick(["", "", "", "c_pad", "c_ballast"])
    a.update({lost: "0"} if lost else {})
    a["N"] = _axial(dice, (float(a["k_ballast"]) * float(a["EI"])) ** 0.5)
    a["eta"] = dice.pick(["0", "0", figures(float(dice.log(1e-4, 0.1)) * time)])
    return a, speed, length, time, weight


def _three_layer(dice: Dice) -> Made:
    a, speed, length, time, weight = _two_layer(dice)
    a["m_ballast"], a["k_ground"] = dice.log(200, 3000), dice.log(1e7, 3e8)
    a["shear"] = dice.log(1e5, 1e8)
    a["c_ground"] = _damping(dice, a["k_ground"], time)
    a["N"] = dice.pick(["0", a["N"] if a["N"].startswith("-") else "0"])
    wave = (float(a["shear"]) / float(a["m_ballast"])) ** 0.5
    return a, dice.pick([speed, speed, wave]), length, time, weight


def _slab(dice: Dice) -> Made:
    a = {"EI": dice.log(1e6, 1e7), "m": dice.log(40, 80), "k_pad": dice.log(1e7, 1e8), "EI_slab": dice.log(1e7, 3e8),
         "m_slab": dice.log(500, 4000), "k": dice.log(1e7, 3e8)}  # fmt: skip
    speed, length, time, weight = _scales(a["EI"], a["m"], a["k_pad"])
    a["c_pad"], a["c"] = _damping(dice, a["k_pad"], time), _damping(dice, a["k"], time)
    lost = dice.pick(["", "", "c_pad", "c"])
    a.update({lost: "0"} if lost else {})
    return a, speed, length, time, weight


def _ice(dice: Dice) -> Made:
    h = dice.log(0.1, 2)
    a = {"B": figures(float(dice.log(3e8, 8e8)) * float(h) ** 3), "h": h, "rho_ice": "917", "rho_water": "1026",
         "depth": dice.log(0.5, 20), "g": "9.81", "c": dice.pick(["0", dice.log(1, 1e3)])}  # fmt: skip
    time = (float(a["B"]) / 1026 / 9.81**5) ** 0.125
    length = (float(a["B"]) / 1026 / 9.81) ** 0.25
    a["eta"] = figures(float(dice.log(1e-3, 1)) * time)
    return a, (9.81 * float(a["depth"])) ** 0.5, length, time, 1026 * length * float(a["depth"])


MAKERS = {"string": _string, "euler-bernoulli": _beam, "rayleigh": _rayleigh, "timoshenko": _timoshenko,
          "two-layer": _two_layer, "three-layer": _three_layer, "slab": _slab, "floating-ice": _ice}  # fmt: skip


FORMATIONS = [
    *(["mass"] * n for n in (1, 2, 2, 3, 5)),
    *(["oscillator"] * n for n in (1, 2)),
    *(["bogie"] * n for n in (1, 1, 2)),
    *(["bogie", "mass"], ["joined"], ["frame"], ["twins"], ["hanging"], ["coach"]),
]


def _vehicles(dice: Dice, weight: float, length: float, time: float) -> list[dict[str, Any]]:
    unit = _Units(dice, weight, length, time)
    kinds = dice.pick(FORMATIONS)
    place, out = 0.0, []
    for kind in kinds:
        vehicle, reach = getattr(unit, kind)()
        place += reach / 2
        out.append({**vehicle, "at": f"{place:.4g}"})
        place += reach / 2 + float(unit.gap())
    return out


class _Units:
    """Vehicles of a size that the track feels."""

    def __init__(self, dice: Dice, weight: float, length: float, time: float) -> None:
        self.dice, self.weight, self.length, self.time = dice, weight, length, time

    def heavy(self, low: float = 0.03, high: float = 100) -> str:
        return figures(float(self.dice.log(low, high)) * self.weight)

    def gap(self) -> str:
        return figures(
            float(self.dice.pick([self.dice.log(0.3, 5), self.dice.log(0.02, 0.3), self.dice.log(5, 30)]))
            * self.length
        )

    def spring(self, M: str) -> str:
        return figures(float(M) / self.time**2 * float(self.dice.log(0.01, 100)))

    def damper(self, M: str) -> str:
        return self.dice.pick(["0", figures(float(M) / self.time * float(self.dice.log(1e-3, 3)))])

    def contact(self, M: str) -> dict[str, str]:
        return self.dice.pick([{}, {"k_contact": figures(float(M) / self.time**2 * float(self.dice.log(0.1, 1e4)))}])

    def mass(self) -> tuple[dict[str, Any], float]:
        return {"model": "mass", "M": self.heavy()}, 0.0

    def oscillator(self) -> tuple[dict[str, Any], float]:
        M = self.heavy()
        return {"model": "oscillator", "wheel": self.heavy(), "body": M, "k": self.spring(M), "c": self.damper(M),
                **self.contact(M)}, 0.0  # fmt: skip

    def bogie(self) -> tuple[dict[str, Any], float]:
        base, frame, wheel = self.gap(), self.heavy(), self.heavy()
        out = {"model": "bogie", "wheel": wheel, "frame": frame, "wheelbase": base, "k": self.spring(frame),
               "inertia": figures(float(frame) * float(base) ** 2 * float(self.dice.log(0.01, 0.3))),
               "c": self.damper(frame), **self.contact(wheel)}  # fmt: skip
        if self.dice.pick([True, False]):
            body = self.heavy(1, 100)
            out.update(body=body, k2=self.spring(body), c2=self.damper(body))
        return out, float(base)

    def coach(self) -> tuple[dict[str, Any], float]:
        inner, base = self.bogie()
        inner = {key: value for key, value in inner.items() if key not in ("body", "k2", "c2")}
        pivots, body = figures(2 * base + float(self.gap())), self.heavy(1, 100)
        out = {"model": "coach", "bogie": inner, "body": body, "pivots": pivots, "k2": self.spring(body),
               "inertia": figures(float(body) * float(pivots) ** 2 * 0.1), "c2": self.damper(body)}  # fmt: skip
        return out, float(pivots) + base

    def joined(self) -> tuple[dict[str, Any], float]:
        """Two masses joined by a spring: G(0)Y(0) may be below −1."""
        a, b, gap = self.heavy(), self.heavy(), self.gap()
        k, c = self.spring(a), self.damper(a)
        return own(
            [[a, "0"], ["0", b]], twice(c), twice(k), [["1", "0"], ["0", "1"]], ["0", gap], self.contact(a)
        ), 2 * float(gap)

    def frame(self) -> tuple[dict[str, Any], float]:
        """Three wheels on one rigid frame."""
        M, base = self.heavy(), float(self.gap())
        inertia = figures(float(M) * base**2 * 0.3)
        places = [figures(-base), figures(0.1 * base), figures(base)]
        zero = [["0", "0"], ["0", "0"]]
        return own([[M, "0"], ["0", inertia]], zero, zero, [["1"] * 3, places], places, self.contact(M)), 2 * base

    def twins(self) -> tuple[dict[str, Any], float]:
        """A wheel with two equal oscillators: their difference is not felt."""
        wheel, body = self.heavy(), self.heavy()
        k, c = self.spring(body), self.damper(body)
        star = lambda x: [[double(x), neg(x), neg(x)], [neg(x), x, "0"], [neg(x), "0", x]]  # noqa: E731
        M = [[wheel, "0", "0"], ["0", body, "0"], ["0", "0", body]]
        return own(M, star(c), star(k), [["1"], ["0"], ["0"]], ["0"], {}), 0.0

    def hanging(self) -> tuple[dict[str, Any], float]:
        """A wheel with a body on a damper alone: neutral at rest."""
        wheel, body = self.heavy(), self.heavy()
        c = figures(float(body) / self.time * float(self.dice.log(1e-2, 3)))
        zero = [["0", "0"], ["0", "0"]]
        return own([[wheel, "0"], ["0", body]], twice(c), zero, [["1"], ["0"]], ["0"], self.contact(wheel)), 0.0


def double(x: str) -> str:
    return str(2 * Fraction(x))


def neg(x: str) -> str:
    return x if x == "0" else "-" + x


def twice(x: str) -> list[list[str]]:
    return [[x, neg(x)], [neg(x), x]]


def own(M: Any, C: Any, K: Any, B: Any, places: list[str], contact: dict[str, str]) -> dict[str, Any]:
    return {"model": "matrices", "M": M, "C": C, "K": K, "B": B, "places": places, **contact}


def stands(problem: dict[str, Any]) -> bool:
    """Whether the track holds at rest: D(p, Ω = 0) has no real p but 0, and the velocity is not at a wave speed."""
    D, _ = track(problem["track"])
    top = max(i for i, j in D if j == 0)
    static = np.array([float(D.get((i, 0), Fraction(0))) for i in range(0, top + 1, 2)])
    y = np.roots(static[::-1])
    return not any(abs(z.imag) < 1e-9 * abs(z) and z.real > 0 for z in y) and static[-1] > 0
