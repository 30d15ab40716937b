"""What an engineer works out before writing an input file, each with its formula and what it assumes.

Arguments are numbers in SI, or texts with units ("180 kN/mm"). Results are exact where the formula is rational.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import pi, sqrt

from mpsolve.errors import InputError
from mpsolve.numbers.model import Quantity, nonnegative, positive, real
from mpsolve.numbers.spoken import beside, decimal, in_spoken, rounded, spoken

SPACING = positive("m", "distance of the sleepers")
STIFFNESS = positive("N/m", "stiffness at one rail seat")
DAMPING = nonnegative("N s/m", "damping at one rail seat")
MASS = nonnegative("kg", "mass at one rail seat")
LOSS = nonnegative("", "loss factor")
FREQUENCY = positive("Hz", "frequency")
EXPANSION = positive("1/K", "thermal expansion")
LAYERS = {
    "pads": ("k_pad", "c_pad", "m_sleeper"),
    "sleepers": ("k_pad", "c_pad", "m_sleeper"),
    "ballast": ("k_ballast", "c_ballast", "m_ballast"),
    "ground": ("k_ground", "c_ground", ""),
}
"""The keys of stiffness, damping and mass of each layer."""
_HALF_SLEEPER = 200  # kg; half a concrete sleeper has some 150
WARMER = real("K", "temperature above the neutral one")


@dataclass(frozen=True)
class Worked:
    """A value in `unit`, how it came about and what it assumes, and the line of an input file that it makes."""

    key: str
    value: Fraction | float
    unit: str
    formula: str
    assumes: str

    @property
    def line(self) -> str:
        """The line for the input file, "" where the value is for none."""
        value, unit = in_spoken(self.value, self.unit)
        shown = decimal(value) if isinstance(self.value, Fraction) else rounded(value, 6)
        beside_it = f"  # {rounded(value)} {unit}" if "/" in shown else ""
        return f'{self.key} = "{shown} {unit}"{beside_it}' if self.key else ""

    @property
    def text(self) -> str:
        """Formula and value, the line for the file, and what is assumed."""
        parts = (f"{self.formula} = {beside(self.value, self.unit)}", self.line, self.assumes)
        return "".join(f"{part}\n" for part in parts if part)


def per_metre(
    stiffness: object, spacing: object, damping: object = 0, mass: object = 0, layer: str = "pads"
) -> tuple[Worked, ...]:
    """Stiffness, damping and mass of rail seats as those of a layer, per metre of track: each over the spacing.

    stiffness: None where only a damping or a mass is asked for. layer: "pads" or "sleepers" (pads on sleepers),
    "ballast" (with the ballast that moves), "ground"; it names the keys.

    >>> per_metre("180 kN/mm", "0.6 m")[0].value
    Fraction(300000000, 1)
    """
    spring, damper, moved = _keys(layer)
    gap = _given(spacing, SPACING, "spacing")
    assumes = (
        "For one rail, if the values are those of one rail seat. A model of both rails takes twice as much. "
        "The layer has no single sleepers: it holds below the pinned-pinned frequency of the rail."
    )
    rows = (
        (spring, stiffness, STIFFNESS, "N/m²", "k"),
        (damper, damping, DAMPING, "N s/m²", "c"),
        (moved, mass, MASS, "kg/m", "m"),
    )
    out = []
    for key, value, quantity, unit, name in rows:
        if value is None:
            continue
        number = _given(value, quantity, name)
        if number and not key:
            raise InputError(name, f"has no place in the layer {layer}: leave it out")
        if number:
            formula = f"{spoken(number, quantity.unit)} / {spoken(gap, 'm')}"
            said = assumes
            if key == "m_sleeper" and number > _HALF_SLEEPER:
                said = f"Is {spoken(number, 'kg')} the whole sleeper? One rail carries half of it. {assumes}"
            out.append(Worked(key, number / gap, unit, formula, said))
    if not out:
        raise InputError("k", "is missing, and so are c and m: give one of them")
    return tuple(out)


def _keys(layer: str) -> tuple[str, str, str]:
    if layer not in LAYERS:
        raise InputError("layer", f"is {layer!r}: give one of {', '.join(LAYERS)}")
    return LAYERS[layer]


def foundation(pad: object, ballast: object, spacing: object) -> Worked:
    """Pads and ballast in series as the one foundation of a beam, per metre of track.

    >>> foundation("180 kN/mm", "60 kN/mm", "0.6 m").value
    Fraction(75000000, 1)
    """
    upper, lower = _given(pad, STIFFNESS, "pad"), _given(ballast, STIFFNESS, "ballast")
    gap = _given(spacing, SPACING, "spacing")
    formula = f"1/(1/({spoken(upper, 'N/m')}) + 1/({spoken(lower, 'N/m')})) / {spoken(gap, 'm')}"
    assumes = (
        "For one rail, if the values are those of one rail seat. The mass of the sleepers is left out: it counts "
        "above some 50 Hz, where a two-layer track is the better model."
    )
    return Worked("k", 1 / (1 / upper + 1 / lower) / gap, "N/m²", formula, assumes)


def viscous(stiffness: object, loss_factor: object, frequency: object, layer: str = "pads") -> Worked:
    """The damper that loses as much as a hysteretic spring k (1 + i·loss) at one frequency: c = loss · k / (2π f)."""
    k = _given(stiffness, positive("N/m²", "stiffness of the layer"), "k")
    loss, f = _given(loss_factor, LOSS, "loss"), _given(frequency, FREQUENCY, "frequency")
    formula = f"{rounded(loss)} · {spoken(k, 'N/m²')} / (2π · {rounded(f)} Hz)"
    return Worked(_keys(layer)[1], float(loss * k) / (2 * pi * float(f)), "N s/m²", formula, _HYSTERETIC)


def rail_damping(loss_factor: object, frequency: object) -> Worked:
    """The Kelvin–Voigt time of a rail with a hysteretic bending stiffness EI (1 + i·loss): eta = loss / (2π f)."""
    loss, f = _given(loss_factor, LOSS, "loss"), _given(frequency, FREQUENCY, "frequency")
    formula = f"{rounded(loss)} / (2π · {rounded(f)} Hz)"
    return Worked("eta", float(loss) / (2 * pi * float(f)), "s", formula, _HYSTERETIC)


def thermal_force(
    area: object, warmer: object, modulus: object = "210 GPa", expansion: object = "1.15e-5 1/K"
) -> Worked:
    """The axial force in a welded rail that is warmer than when it was laid free of stress: N = E A α ΔT.

    >>> thermal_force("76.7 cm²", 30).value
    Fraction(1111383, 2)
    """
    A = _given(area, positive("m²", "cross section of the rail"), "area")
    E = _given(modulus, positive("N/m²", "Young's modulus"), "modulus")
    alpha, rise = _given(expansion, EXPANSION, "expansion"), _given(warmer, WARMER, "warmer")
    formula = f"{rounded(E / 10**9)} GPa · {rounded(A * 10**4)} cm² · {rounded(alpha)} 1/K · {rounded(rise)} K"
    assumes = (
        "Compression is positive, so a rail that is colder has N < 0. For one rail, which cannot become longer. The "
        "neutral temperature is the one at which the rail was laid free of stress, some 20 to 30 °C."
    )
    return Worked("N", E * A * alpha * rise, "N", formula, assumes)


def pinned_pinned(bending: object, mass: object, spacing: object) -> Worked:
    """The frequency at which the rail vibrates between sleepers that stand still: f = π/(2 L²) √(EI/m), in Hz."""
    EI = _given(bending, positive("N m²", "bending stiffness of the rail"), "EI")
    m, gap = _given(mass, positive("kg/m", "mass of the rail"), "m"), _given(spacing, SPACING, "spacing")
    formula = f"π/(2 · ({spoken(gap, 'm')})²) · √({spoken(EI, 'N m²')} / {rounded(m)} kg/m)"
    assumes = (
        "Half a wave between two sleepers. Above some two thirds of it a track of smeared layers means little; shear "
        "of the rail, which is left out, lowers it by a fifth or so."
    )
    return Worked("", pi / (2 * float(gap) ** 2) * sqrt(float(EI / m)), "Hz", formula, assumes)


_HYSTERETIC = (
    "Right at this frequency only: below it the damper loses less than the hysteretic material, above it more. A "
    "hysteretic damping has no motion in time that starts at rest, so the model takes viscous ones."
)


def _given(value: object, quantity: Quantity, key: str) -> Fraction:
    number = quantity.checked(value, key)
    if not isinstance(number, Fraction):
        raise InputError(key, f"is of type {type(value).__name__}: give the {quantity.told}")
    return number
