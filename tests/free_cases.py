"""Families for tests: tracks and vehicles of several kinds with parameters left free."""

from fractions import Fraction

import numpy as np

from mpsolve import Problem, tracks, vehicles
from mpsolve.characteristic.boxes import Boxes
from mpsolve.problem.family import Family, family_of

BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
RAIL = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
LAYERS = tracks.TwoLayer(
    EI=Fraction("210e9") * Fraction("3038.30e-8"), m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper=250,
    k_ballast="100e6", c_ballast="8e4",
)  # fmt: skip
PAIR = [vehicles.Mass(40).at(0), vehicles.Mass(40).at("1.5")]
BOGIE = vehicles.Bogie(
    wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e6", c=250, body=12500, k2="2.708e6", c2="64e3"
)
SPRUNG = vehicles.Bogie(wheel=1500, frame=3000, inertia=155, wheelbase="2.5", k="4.8e6", c=250, k_contact="1e9")


def pair_over_velocity(low: object = 0, high: object = 1) -> Family:
    return family_of(Problem(BEAM, PAIR, v=0), {"v": (Fraction(low), Fraction(high))})  # type: ignore[arg-type]


def of_many() -> Family:
    problem = Problem(LAYERS, [SPRUNG.at(0), vehicles.Mass(900).at(9)], v=600)
    million = Fraction(10**6)
    over = {
        "v": (Fraction(100), Fraction(1000)),
        "track.k_ballast": (50 * million, 150 * million),
        "gap[0]": (Fraction(8), Fraction(10)),
        "vehicles[0].k_contact": (100 * million, 10000 * million),
        "vehicles[0].wheelbase": (Fraction(2), Fraction(3)),
    }
    return family_of(problem, over)


def random_boxes(family: Family, count: int, share: float, reach: float = 2.0, seed: int = 5) -> Boxes:
    """Boxes of a share of the whole, at random places."""
    rng = np.random.default_rng(seed)
    low = np.array([0.0, *(float(a) for a, _ in family.box)])
    high = np.array([reach, *(float(b) for _, b in family.box)])
    r = share * (high - low)[:, None] * np.ones((1, count))
    return Boxes(low[:, None] + r + rng.uniform(size=r.shape) * ((high - low)[:, None] - 2 * r), r)


def inside(boxes: Boxes, n: int, seed: int = 2) -> tuple[np.ndarray, float, tuple[Fraction, ...]]:
    """(u, q̂, x̂): a random point of box n."""
    u = np.random.default_rng(seed + n).uniform(-1, 1, boxes.m.shape[0])
    point = boxes.m[:, n] + boxes.r[:, n] * u
    return u, float(point[0]), tuple(Fraction(float(x)) for x in point[1:])
