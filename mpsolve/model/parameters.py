"""The cases that are solved, held exactly: `Case` (dimensionless) and `PhysicalCase` (SI units)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from itertools import pairwise
from typing import Any

from mpsolve.errors import InputError
from mpsolve.numbers.exact import Exact, Number

_BUCKLED = "so the beam buckles without any load: lower the compression"


@dataclass(frozen=True, init=False)
class Case:
    """A dimensionless case (10)–(12) that is admissible: every bound below has been decided exactly.

    alpha ≥ 0: velocity ratio; eta_b ≥ 0: damping ratio; eta_m > 0: mass ratios; positions: ξ of the masses,
    ascending, equal for masses that move as one; eta_n: axial force ratio, compression positive; eta_s ≥ 0:
    Pasternak modulus ratio; eta_n − eta_s < 1. InputError names the argument that breaks a bound.

    >>> Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5")).positions
    (Exact('0'), Exact('3/2'))
    """

    alpha: Exact
    eta_b: Exact
    eta_m: tuple[Exact, ...]
    positions: tuple[Exact, ...]
    eta_n: Exact
    eta_s: Exact

    def __init__(
        self,
        *,
        alpha: Number,
        eta_b: Number,
        eta_m: Number | Iterable[Number],
        positions: Number | Iterable[Number] | None = None,
        eta_n: Number = 0,
        eta_s: Number = 0,
    ) -> None:
        """Parse and check every value; one mass may be given bare, and sits at 0 if no position is given."""
        ratios = _parsed(eta_m, "eta_m")
        if positions is None and len(ratios) == 1:
            positions = 0
        vars(self).update(
            alpha=_at_least_zero(alpha, "alpha", "velocity ratio"),
            eta_b=_at_least_zero(eta_b, "eta_b", "damping ratio"),
            eta_m=tuple(_above_zero(ratio, f"eta_m[{j}]", "mass ratio") for j, ratio in enumerate(ratios, 1)),
            positions=() if positions is None else _parsed(positions, "positions"),
            eta_n=Exact.parse(eta_n, "eta_n"),
            eta_s=_at_least_zero(eta_s, "eta_s", "Pasternak modulus"),
        )
        if not ratios:
            raise InputError("eta_m", "is empty: give at least one mass ratio")
        if len(self.positions) != len(ratios):
            stated = f"has {len(self.positions)} values for {len(ratios)} masses"
            raise InputError("positions", f"{stated}: give one for each mass")
        _check_ascending(self.positions, "positions[{j}]")
        if self.axial >= 1:
            stated = f"eta_n − eta_s is {self.axial.beside(1)}, not below 1"
            raise InputError("eta_n", f"{stated}, {_BUCKLED} eta_n or raise eta_s")

    @property
    def count(self) -> int:
        """The number of masses, equal positions counted apart."""
        return len(self.eta_m)

    @property
    def axial(self) -> Exact:
        """N = η_N − η_S of (18), exactly; InputError where no single fourth root expresses it."""
        try:
            return self.eta_n - self.eta_s
        except ValueError:
            message = "has no rational ratio to eta_s, so eta_n − eta_s is not exact: give one as 0"
            raise InputError("eta_n", message) from None

    @property
    def merged(self) -> Case:
        """The same case with every group of masses at one position summed into a single mass.

        InputError under eta_m where such masses have no rational ratio.
        """
        total: dict[Exact, Exact] = {}
        for ratio, place in zip(self.eta_m, self.positions, strict=True):
            try:
                total[place] = total.get(place, Exact(0)) + ratio
            except ValueError:
                message = f"has no rational ratio between the masses at {place.short()}: give their sum"
                raise InputError("eta_m", message) from None
        return replace(self, eta_m=tuple(total.values()), positions=tuple(total))

    @property
    def overdamped(self) -> bool:
        """True if and only if η_b ≥ 1, decided exactly."""
        return self.eta_b >= 1

    @property
    def cuts_on_line(self) -> bool:
        """True if and only if η_b < 1 and N < β = √(1 − η_b²): the cuts lie on Im q = η_b. Decided exactly.

        For N > 0 this is √x + √y < 1 with x = N⁴ and y = η_b⁴, both rational.
        """
        if self.overdamped or self.axial.sign <= 0:
            return not self.overdamped
        x, y = self.axial.fourth_power, self.eta_b.fourth_power
        rest = 1 - x - y
        return rest > 0 and 4 * x * y < rest**2

    def as_dict(self) -> dict[str, str | list[str]]:
        """Return the case in canonical text, from which `from_dict` gives it back."""
        return {k: list(map(str, v)) if isinstance(v, tuple) else str(v) for k, v in vars(self).items()}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Case:
        """Return the case with these values; InputError names a key that is unknown, missing or wrong."""
        known = [field.name for field in fields(cls)]
        for name in values:
            if name not in known:
                raise InputError(str(name), f"is unknown: the keys are {', '.join(known)}")
        for name in known[:4]:
            if name not in values:
                raise InputError(name, "is missing: give its value")
        return cls(**values)


@dataclass(frozen=True, init=False)
class Mass:
    """A moving mass M > 0 in kg at s = position in m, and the force P + P_A sin(ω_f t + φ_f) on it of (2).

    P and P_A in N, omega_f in rad/s, phi_f in rad. InputError names the argument that cannot be used.
    """

    M: Exact
    position: Exact
    P: Exact
    P_A: Exact
    omega_f: Exact
    phi_f: Exact

    def __init__(
        self, M: Number, position: Number, P: Number = 0, P_A: Number = 0, omega_f: Number = 0, phi_f: Number = 0
    ) -> None:
        vars(self).update(
            M=_above_zero(M, "M", "mass in kg"),
            position=Exact.parse(position, "position"),
            P=Exact.parse(P, "P"),
            P_A=Exact.parse(P_A, "P_A"),
            omega_f=Exact.parse(omega_f, "omega_f"),
            phi_f=Exact.parse(phi_f, "phi_f"),
        )
        _check_rational(self)


@dataclass(frozen=True, init=False)
class PhysicalCase:
    """An admissible beam, foundation and load in SI units, as in (1) and (2), every value rational.

    EI > 0 in N m², m > 0 in kg/m, k > 0 in N/m², v ≥ 0 in m/s, c ≥ 0 in N s/m² (damping c_b), kp ≥ 0 in N
    (Pasternak modulus), N in N (compression is positive), masses in ascending order of position; a pair
    (M, position) stands for a Mass without force. InputError names the argument that breaks a bound.
    """

    EI: Exact
    m: Exact
    k: Exact
    v: Exact
    masses: tuple[Mass, ...]
    c: Exact
    kp: Exact
    N: Exact

    def __init__(
        self,
        *,
        EI: Number,
        m: Number,
        k: Number,
        v: Number,
        masses: Iterable[Mass | tuple[Number, Number]],
        c: Number = 0,
        kp: Number = 0,
        N: Number = 0,
    ) -> None:
        vars(self).update(
            EI=_above_zero(EI, "EI", "bending stiffness in N m²"),
            m=_above_zero(m, "m", "mass of the beam in kg/m"),
            k=_above_zero(k, "k", "stiffness of the foundation in N/m²"),
            v=_at_least_zero(v, "v", "velocity in m/s"),
            masses=tuple(_as_mass(mass, j) for j, mass in enumerate(masses, 1)),
            c=_at_least_zero(c, "c", "damping of the foundation in N s/m²"),
            kp=_at_least_zero(kp, "kp", "Pasternak modulus in N"),
            N=Exact.parse(N, "N"),
        )
        _check_rational(self)
        if not self.masses:
            raise InputError("mass", "is empty: give at least one mass with M and position")
        _check_ascending((mass.position for mass in self.masses), "mass[{j}].position")
        axial, limit = self.N - self.kp, self.buckling_force
        if axial >= limit:
            stated = f"N − kp is {axial.short()} N, not below 2√(k EI) = {limit.short()} N"
            raise InputError("N", f"{stated}, {_BUCKLED} N or raise kp")

    @property
    def chi(self) -> Exact:
        """χ = (k/(4EI))^(1/4) in 1/m, exactly."""
        return Exact.root4(self.k.as_fraction() / (4 * self.EI.as_fraction()))

    @property
    def time_scale(self) -> Exact:
        """χ v_cr = √(k/m) in rad/s, exactly: τ = time_scale · t by (10)."""
        return Exact.sqrt(self.k.as_fraction() / self.m.as_fraction())

    @property
    def v_cr(self) -> Exact:
        """The critical velocity √(k/m)/χ on the Winkler foundation alone, in m/s, exactly."""
        return self.time_scale / self.chi

    @property
    def buckling_force(self) -> Exact:
        """N_cr = 2√(k EI) of (11) in N, exactly."""
        return Exact.sqrt(4 * self.k.as_fraction() * self.EI.as_fraction())

    @property
    def dimensionless(self) -> Case:
        """The dimensionless case by (10)–(12), exactly."""
        chi = self.chi
        return Case(
            alpha=self.v / self.v_cr,
            eta_b=self.c / (2 * self.m * self.time_scale),
            eta_m=[mass.M * chi / self.m for mass in self.masses],
            positions=[mass.position * chi for mass in self.masses],
            eta_n=self.N / self.buckling_force,
            eta_s=self.kp / self.buckling_force,
        )


@contextmanager
def errors_under(prefix: str) -> Iterator[None]:
    """Put `prefix` before the key of every InputError that is raised inside."""
    try:
        yield
    except InputError as error:
        raise InputError(prefix + error.key, str(error).removeprefix(f"{error.key}: ")) from None


def _check_rational(physical: Mass | PhysicalCase) -> None:
    for name, value in vars(physical).items():
        if isinstance(value, Exact) and not value.is_rational:
            raise InputError(name, "is irrational, unlike a measured value: give a decimal or a ratio p/q")


def _above_zero(value: object, key: str, meaning: str) -> Exact:
    exact = Exact.parse(value, key)
    if exact.sign <= 0:
        raise InputError(key, f"is {exact.short()}, but must be above 0: give the {meaning}")
    return exact


def _at_least_zero(value: object, key: str, meaning: str) -> Exact:
    exact = Exact.parse(value, key)
    if exact.sign < 0:
        raise InputError(key, f"is {exact.short()}, but must not be below 0: give the {meaning}")
    return exact


def _parsed(values: object, key: str) -> tuple[Exact, ...]:
    """Return the numbers of a sequence, or one bare number as a sequence of one."""
    if isinstance(values, Iterable) and not isinstance(values, (str, bytes, Mapping, Set)):
        return tuple(Exact.parse(value, f"{key}[{j}]") for j, value in enumerate(values, 1))
    return (Exact.parse(values, key),)


def _as_mass(mass: object, j: int) -> Mass:
    """Return a Mass as it is, and a pair (M, position) as a Mass without force."""
    if isinstance(mass, Mass):
        return mass
    if not isinstance(mass, (tuple, list)) or len(mass) != 2:
        raise InputError(f"mass[{j}]", "is neither a Mass nor a pair (M, position): give one of these")
    with errors_under(f"mass[{j}]."):
        return Mass(mass[0], mass[1])


def _check_ascending(places: Iterable[Exact], key: str) -> None:
    """Refuse a place below the one before it; `key` names the place with number {j}."""
    for j, (before, place) in enumerate(pairwise(places), 2):
        if place < before:
            stated = f"is {place.short()}, below the {before.short()} before it"
            raise InputError(key.format(j=j), f"{stated}: list the masses by ascending position")
