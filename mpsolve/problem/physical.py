"""The paper's beam, foundation and masses in SI units, held exactly: `PhysicalCase`."""

from __future__ import annotations

from collections.abc import Iterable

from mpsolve.errors import InputError
from mpsolve.frozen import frozen
from mpsolve.numbers.exact import Exact, Number
from mpsolve.problem.case import Case
from mpsolve.problem.checked import BUCKLED, above_zero, at_least_zero, check_ascending, errors_under


@frozen
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
            M=above_zero(M, "M", "mass in kg"),
            position=Exact.parse(position, "position"),
            P=Exact.parse(P, "P"),
            P_A=Exact.parse(P_A, "P_A"),
            omega_f=Exact.parse(omega_f, "omega_f"),
            phi_f=Exact.parse(phi_f, "phi_f"),
        )
        _check_rational(self)


@frozen
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
            EI=above_zero(EI, "EI", "bending stiffness in N m²"),
            m=above_zero(m, "m", "mass of the beam in kg/m"),
            k=above_zero(k, "k", "stiffness of the foundation in N/m²"),
            v=at_least_zero(v, "v", "velocity in m/s"),
            masses=tuple(_as_mass(mass, j) for j, mass in enumerate(masses, 1)),
            c=at_least_zero(c, "c", "damping of the foundation in N s/m²"),
            kp=at_least_zero(kp, "kp", "Pasternak modulus in N"),
            N=Exact.parse(N, "N"),
        )
        _check_rational(self)
        if not self.masses:
            raise InputError("mass", "is empty: give at least one mass with M and position")
        check_ascending((mass.position for mass in self.masses), "mass[{j}].position")
        axial, limit = self.N - self.kp, self.buckling_force
        if axial >= limit:
            stated = f"N − kp is {axial.short()} N, not below 2√(k EI) = {limit.short()} N"
            raise InputError("N", f"{stated}, {BUCKLED} N or raise kp")

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


def _check_rational(physical: Mass | PhysicalCase) -> None:
    for name, value in vars(physical).items():
        if isinstance(value, Exact) and not value.is_rational:
            raise InputError(name, "is irrational, unlike a measured value: give a decimal or a ratio p/q")


def _as_mass(mass: object, j: int) -> Mass:
    """Return a Mass as it is, and a pair (M, position) as a Mass without force."""
    if isinstance(mass, Mass):
        return mass
    if not isinstance(mass, (tuple, list)) or len(mass) != 2:
        raise InputError(f"mass[{j}]", "is neither a Mass nor a pair (M, position): give one of these")
    with errors_under(f"mass[{j}]."):
        return Mass(mass[0], mass[1])
