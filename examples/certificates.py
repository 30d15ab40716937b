"""The certificates under certs/: typical cases, each proved anew by `python examples/certificates.py`.

Sections and figures are the paper's. The test suite proves a few of them again and verifies every file.
"""

from __future__ import annotations

from pathlib import Path

from mpsolve import (
    Case,
    PhysicalCase,
    Problem,
    Rectangle,
    Spectrum,
    certify,
    read_case,
    read_problem,
    tracks,
    vehicles,
)
from mpsolve.files import write_whole
from mpsolve.pictures.axes import alone
from mpsolve.pictures.plane import spectrum_picture

HERE = Path(__file__).resolve().parent
FOLDER = HERE.parent / "certs"


def pair(alpha: str, eta_b: str, eta_m: str, d: str) -> Case:
    """Two equal masses at the distance d, the paper's cases."""
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=("0", d))


MASS = vehicles.Mass("10e3")
TIMOSHENKO = tracks.Timoshenko(EI="6377700", m="60.2", S="243.46e6", J="0.23871", k="1e6", c="770")
ICE = tracks.FloatingIce(B="5e7", h="0.6", rho_ice=917, rho_water=1025, depth="6.8", c=10, eta="0.01")
JOINED = vehicles.Vehicle(
    M=[[10, 0], [0, 10]], C=[[0, 0], [0, 0]], K=[[10, -10], [-10, 10]], B=[[1, 0], [0, 1]], places=[0, "1.5"]
)
CASES: dict[str, Case | PhysicalCase | Problem] = {
    "rail_60e1": read_case(HERE / "rail_60e1.toml"),
    "stable_d1.0_alpha0.96": pair("0.96", "0.05", "70", "1"),  # Section 4.3: unstable from 0.97 on
    "unstable_d1.0_alpha0.97": pair("0.97", "0.05", "70", "1"),
    "stable_d1.5_alpha0.66": pair("0.66", "0.05", "70", "1.5"),  # Section 4.3: unstable from 0.67 on
    "unstable_d1.5_alpha0.67": pair("0.67", "0.05", "70", "1.5"),
    "undamped_subcritical": pair("0.5", "0", "40", "1"),  # Figure 2b
    "undamped_supercritical": pair("1.2", "0", "40", "1"),  # Figure 2b
    "damped_supercritical_d4.5": pair("1.2", "0.05", "40", "4.5"),
    "single_mass": Case(alpha="0.9", eta_b="0.05", eta_m="70"),
    "doubled_mass": pair("0.9", "0.05", "70", "0"),
    "at_rest": pair("0", "0.05", "10", "2"),
    "axial_force": Case(alpha="0.3", eta_b="0.1", eta_m=("10", "25"), positions=("0", "2"), eta_n="0.5"),
    "three_masses": Case(alpha="0.3", eta_b="0.05", eta_m=("10", "20", "30"), positions=("0", "2", "3")),
    "overdamped_line": pair("1", "1.2", "10", "1"),
    "rectangle": pair("0.67", "0.05", "70", "1.5"),
    "cluster_d100": pair("0.5", "0.05", "70", "100"),
    "thousand_digits": pair("0.67", "0.05", "70", "1.5"),
    # certificates of version 2: any track and vehicles
    "two_layer_bogie": read_problem(HERE / "two_layer_bogie.toml").problem,
    "contact_wire": Problem(tracks.String(T="27e3", m="1.07", k=500, c=2), [vehicles.Mass("8.5")], v=100),
    "timoshenko_stable": Problem(TIMOSHENKO, [MASS], v=300),
    "timoshenko_unstable": Problem(TIMOSHENKO, [MASS], v=320),
    "kelvin_voigt_pair": Problem(
        tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770, eta="1e-4"), [MASS.at(0), MASS.at("3.4")], v=198
    ),
    "joined_masses": Problem(tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=1), [JOINED], v="1.3"),  # an odd count
    "floating_ice": Problem(ICE, vehicles.Oscillator(wheel=1000, body=50_000, k="1e5", c=1000), v=20),
}
REGIONS: dict[str, object] = {
    "overdamped_line": "unstable",
    "rectangle": Rectangle("0.1", "0.2", "-0.1", "0.04"),
    "timoshenko_stable": "unstable",
    "timoshenko_unstable": "unstable",
    "joined_masses": "unstable",
    "floating_ice": "unstable",
}
DIGITS = {"thousand_digits": 1000}


def prove(name: str) -> Spectrum:
    """The certified spectrum of one of the cases."""
    return certify(CASES[name], digits=DIGITS.get(name, 30), region=REGIONS.get(name))


def visualize(path: Path | str = "certificate.svg", name: str = "unstable_d1.5_alpha0.67") -> Path:
    """Writes the q-plane of one of the cases, proved anew, with its certified roots, as SVG; returns the path."""
    return write_whole(Path(path), alone(spectrum_picture(prove(name))[0]))


def main() -> None:
    """Writes every certificate."""
    for name in CASES:
        spectrum = prove(name)
        if not (spectrum.proved and spectrum.certificate):
            raise SystemExit(f"{name}: {spectrum.reason}")
        spectrum.certificate.save(FOLDER / f"{name}.json")
        print(f"{name}: {spectrum.count} induced frequencies, {spectrum.unstable} unstable")


if __name__ == "__main__":
    main()
