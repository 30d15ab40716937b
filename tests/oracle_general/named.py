"""Problems with a name: onsets from both sides, divergence, indeterminate contacts, roots without number."""

from __future__ import annotations

from typing import Any

from oracle_general.problems import own, twice

TIMOSHENKO = {
    "model": "timoshenko", "EI": "6377700", "m": "60.2", "S": "243462804.39", "J": "0.2387082",
    "k": "1e6", "c": "770",
}  # fmt: skip
TWO_LAYER = {
    "model": "two-layer", "EI": "6380430", "m": "60.2", "k_pad": "300e6", "c_pad": "3e4",
    "m_sleeper": "250", "k_ballast": "100e6", "c_ballast": "8e4",
}  # fmt: skip
RAIL = {"model": "euler-bernoulli", "EI": "6.4e6", "m": "60", "k": "1e6", "c": "770"}
PAPER = {"model": "euler-bernoulli", "EI": "0.25", "m": "1", "k": "1", "c": "1"}
BOGIE = {
    "model": "bogie", "wheel": "1500", "frame": "3000", "inertia": "155", "wheelbase": "2.5",
    "k": "4.8e6", "c": "250", "body": "12500", "k2": "2.708e6", "c2": "64e3",
}  # fmt: skip
STIFF = {**BOGIE, "c": "0", "c2": "0", "k_contact": "1e9"}
WIRE = {"model": "string", "T": "27000", "m": "1.07", "k": "500", "c": "2"}
FAST = {"model": "timoshenko", "EI": "1", "m": "1", "S": "4", "J": "0.05", "k": "1", "c": "0.1"}
GROUND = {
    "model": "three-layer", "EI": "6380430", "m": "60.2", "k_pad": "300e6", "c_pad": "0", "m_sleeper": "250",
    "k_ballast": "200e6", "c_ballast": "0", "m_ballast": "1000", "shear": "20e6",
    "k_ground": "100e6", "c_ground": "8e4",
}  # fmt: skip
ICE = {
    "model": "floating-ice", "B": "6e8", "h": "1", "rho_ice": "917", "rho_water": "1026", "depth": "7", "g": "9.81",
    "c": "0", "eta": "0.5",
}  # fmt: skip
ZERO = [["0", "0"], ["0", "0"]]
FRAME = own([["3000", "0"], ["0", "6000"]], ZERO, ZERO, [["1"] * 3, ["-2", "0.3", "2"]], ["-2", "0.3", "2"], {})


def masses(M: str, *places: str) -> list[dict[str, Any]]:
    return [{"model": "mass", "M": M, "at": place} for place in places]


def joined(M: str, k: str, d: str) -> list[dict[str, Any]]:
    """Two masses joined by a spring."""
    return [own([[M, "0"], ["0", M]], ZERO, twice(k), [["1", "0"], ["0", "1"]], ["0", d], {})]


def at(*vehicles: dict[str, Any], gap: float = 12) -> list[dict[str, Any]]:
    return [{**vehicle, "at": f"{gap * j:g}"} for j, vehicle in enumerate(vehicles)]


def problem(track: dict[str, str], vehicles: list[dict[str, Any]], v: str, **more: str) -> dict[str, Any]:
    return {"track": track, "vehicles": vehicles, "v": v, **more}


NAMED: dict[str, dict[str, Any]] = {
    "timoshenko onset, below": problem(TIMOSHENKO, masses("10000", "0"), "309.44"),
    "timoshenko onset, above": problem(TIMOSHENKO, masses("10000", "0"), "309.45"),
    "two-layer onset, below": problem(TWO_LAYER, masses("900", "0"), "1413.81"),
    "two-layer onset, above": problem(TWO_LAYER, masses("900", "0"), "1413.83"),
    "kelvin-voigt onset, below": problem({**RAIL, "eta": "1e-4"}, masses("10000", "0", "3.4"), "197.87"),
    "kelvin-voigt onset, above": problem({**RAIL, "eta": "1e-4"}, masses("10000", "0", "3.4"), "197.89"),
    "bogie onset, below": problem(RAIL, at(BOGIE), "334.58"),
    "bogie onset, above": problem(RAIL, at(BOGIE), "334.6"),
    "stable window, before": problem(TWO_LAYER, masses("900", "0", "2.5"), "400"),
    "stable window, unstable": problem(TWO_LAYER, masses("900", "0", "2.5"), "680"),
    "stable window, inside": problem(TWO_LAYER, masses("900", "0", "2.5"), "1200"),
    "divergence, strong damping": problem(PAPER, joined("10", "10", "1.5"), "1.3"),
    "divergence, weak damping": problem({**PAPER, "c": "0.1"}, joined("2", "3", "1"), "1.3"),
    "contact wire": problem(WIRE, masses("8.5", "0"), "100"),
    "contact wire, two": problem(WIRE, masses("8.5", "0", "20"), "150"),
    "string too fast, one mass": problem(WIRE, masses("8.5", "0"), "170"),
    "lossless bogie on stiff contacts": problem(TWO_LAYER, at(STIFF), "700"),
    "two bogies on stiff contacts": problem(
        RAIL, at({**BOGIE, "k_contact": "1.2e9"}, {**BOGIE, "k_contact": "1.2e9"}), "420"
    ),
    "three tight wheels on one frame": problem(TWO_LAYER, at(FRAME), "800"),
    "three tight wheels on one frame, slow": problem(RAIL, at(FRAME), "150"),
    "ground alone damped, pair": problem(GROUND, masses("900", "0", "2.5"), "680"),
    "ice, below the wave speed": problem(ICE, masses("5000", "0", "20"), "7"),
    "ice, above the wave speed": problem(ICE, masses("5000", "0", "20"), "14"),
    "shear waves overtaken, one mass": problem(FAST, masses("10", "0"), "2.2"),
    "shear waves overtaken, within 20": problem(FAST, masses("10", "0", "3"), "2.2", within="20"),
    "shear waves overtaken, within 40": problem(FAST, masses("10", "0", "3"), "2.2", within="40"),
    "shear waves overtaken, within 80": problem(FAST, masses("10", "0", "3"), "2.2", within="80"),
}
