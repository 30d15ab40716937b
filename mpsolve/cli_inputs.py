"""The commands for what goes into an input file: new, work-out, schema."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from mpsolve.cli_tools import Commands, command, echo_json, output
from mpsolve.errors import InputError

if TYPE_CHECKING:
    from mpsolve.engineering import Worked


@command()
@click.argument("track", required=False)
@click.option("--vehicle", metavar="NAME", help="Another vehicle than the one that the track is tried with.")
@click.option("--v", "velocity", metavar="VELOCITY", help='Another velocity, such as "300 km/h".')
@click.option("--count", type=int, help="How many of the vehicles run in a row.")
@click.option("--spacing", metavar="DISTANCE", help='From one vehicle to the next, such as "25 m".')
@output("Write this new file, not the terminal.")
def new(
    track: str | None,
    vehicle: str | None,
    velocity: str | None,
    count: int | None,
    spacing: str | None,
    output: Path | None,
) -> None:
    """Write an input file with comments from presets: TRACK and a vehicle. Without TRACK: list the presets.

    Each preset says where its numbers come from.

    Exit status 0: written. 1: the file could not be written. 2: there is no such preset, or the file exists.
    """
    from mpsolve.files import write_whole
    from mpsolve.presets.written import input_file, listing

    if track is None:
        click.echo(listing(), nl=False)
        return
    text = input_file(track, vehicle, velocity, count, spacing)
    if output is None:
        click.echo(text, nl=False)
        return
    if output.exists():
        raise InputError("output", f"{output} exists: give the path of a new file")
    click.echo(str(write_whole(output, text)))


@click.group("work-out", cls=Commands)
def work_out() -> None:
    """Work out values for an input file: per metre, damping, axial force, with the formula and what it assumes.

    Exit status 0: shown. 2: a value cannot be used.
    """


def _show(*found: Worked, layer: str | None = "") -> None:
    """Each value, and what they assume once. layer: None where a layer may be named, and is not."""
    for one in found:
        click.echo(one.text.removesuffix(f"{one.assumes}\n"), nl=False)
    click.echo(f"{_OTHERS} {found[-1].assumes}" if layer is None else found[-1].assumes)


_LAYER = click.option(
    "--layer",
    type=click.Choice(["pads", "sleepers", "ballast", "ground"]),
    help="Which layer it is; it names the keys.  [default: pads]",
)
_OTHERS = "The key is that of pads: say --layer ballast, ground or sleepers for that of another layer."


@work_out.command("per-metre")
@click.option("--k", help='Stiffness at one rail seat, such as "180 kN/mm".')
@click.option("--spacing", required=True, help='Distance of the sleepers, such as "0.6 m".')
@click.option("--c", default="0", help='Damping at one rail seat, such as "18 kN s/m".')
@click.option("--m", default="0", help="Mass on a rail seat: half a sleeper, such as 150 kg.")
@_LAYER
def per_metre(k: str | None, spacing: str, c: str, m: str, layer: str | None) -> None:
    """A layer per metre of track, from its rail seats.

    Example: mpsolve work-out per-metre --k "180 kN/mm" --spacing "0.6 m" --m "150 kg"
    """
    from mpsolve.engineering import per_metre as found

    _show(*found(k, spacing, c, m, layer or "pads"), layer=layer)


@work_out.command()
@click.option("--pad", required=True, help='Stiffness of a pad, such as "180 kN/mm".')
@click.option("--ballast", required=True, help='Stiffness of the ballast under one rail seat, such as "60 kN/mm".')
@click.option("--spacing", required=True, help='Distance of the sleepers, such as "0.6 m".')
def foundation(pad: str, ballast: str, spacing: str) -> None:
    """Pads and ballast as one foundation under a beam.

    Example: mpsolve work-out foundation --pad "180 kN/mm" --ballast "60 kN/mm" --spacing "0.6 m"
    """
    from mpsolve.engineering import foundation as found

    _show(found(pad, ballast, spacing))


@work_out.command()
@click.option("--loss", required=True, help="Loss factor of the material, such as 0.2.")
@click.option("--frequency", required=True, help='Where the damping counts most, such as "100 Hz".')
@click.option("--k", help='Stiffness of the layer, such as "300 MN/m²"; without it, for the bending of the rail.')
@_LAYER
def damping(loss: str, frequency: str, k: str | None, layer: str | None) -> None:
    """Viscous damping from a hysteretic loss factor, at one frequency.

    Example: mpsolve work-out damping --loss 0.2 --k "300 MN/m²" --frequency "100 Hz"
    """
    from mpsolve.engineering import rail_damping, viscous

    if k is None:
        _show(rail_damping(loss, frequency))
    else:
        _show(viscous(k, loss, frequency, layer or "pads"), layer=layer)


@work_out.command("axial-force")
@click.option("--area", required=True, help='Cross section of one rail, such as "76.7 cm²" of 60E1.')
@click.option(
    "--warmer", required=True, help='Degrees above the neutral temperature, such as "30 K"; below 0: colder.'
)
@click.option("--modulus", default="210 GPa", show_default=True, help="Young's modulus.")
@click.option("--expansion", default="1.15e-5 1/K", show_default=True, help="Thermal expansion.")
def axial_force(area: str, warmer: str, modulus: str, expansion: str) -> None:
    """The axial force in a welded rail, from its temperature.

    Example: mpsolve work-out axial-force --area "76.7 cm²" --warmer "30 K"
    """
    from mpsolve.engineering import thermal_force

    _show(thermal_force(area, warmer, modulus, expansion))


@work_out.command("pinned-pinned")
@click.option("--bending", required=True, help='Bending stiffness of the rail, such as "6.4 MN m²".')
@click.option("--mass", required=True, help='Mass of the rail, such as "60 kg/m".')
@click.option("--spacing", required=True, help='Distance of the sleepers, such as "0.6 m".')
def pinned_pinned(bending: str, mass: str, spacing: str) -> None:
    """The frequency up to which smeared sleepers mean something.

    Example: mpsolve work-out pinned-pinned --bending "6.4 MN m²" --mass "60 kg/m" --spacing "0.6 m"
    """
    from mpsolve.engineering import pinned_pinned as found

    _show(found(bending, mass, spacing))


@command()
@click.argument("name", required=False)
def schema(name: str | None) -> None:
    """Print the JSON Schema (draft 2020-12) with NAME; without NAME list them: of files, answers, certificates.

    Exit status 0: printed. 2: there is no such schema. Editors that know TOML check a file against it after the line
    "#:schema ./mpsolve.schema.json".
    """
    from mpsolve.schemas.catalogue import listing, schema_of

    if name is None:
        click.echo(listing(), nl=False)
    else:
        echo_json(schema_of(name))
