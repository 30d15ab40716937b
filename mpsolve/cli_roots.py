"""The command `roots`: every zero of a function of z in a region or on an interval, with a certificate."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import click

from mpsolve.cli_tools import (
    EFFORT,
    JSON,
    UNDECIDED,
    certificate_path,
    command,
    digits_option,
    echo_json,
    effort_of,
    output,
    progress,
    say,
)
from mpsolve.errors import InputError

_REGIONS = ("--rectangle", "--disc", "--half-plane", "--real")


@command()
@click.argument("function", metavar="FUNCTION")
@click.option("--rectangle", nargs=4, metavar="RE_MIN RE_MAX IM_MIN IM_MAX", help="In a rectangle.")
@click.option("--disc", nargs=3, metavar="RE IM RADIUS", help="In a disc round RE + i IM.")
@click.option(
    "--half-plane",
    nargs=2,
    metavar="SIDE BOUND",
    help="In the upper, lower, right or left half-plane; BOUND is your word that none lies at |z| ≥ BOUND.",
)
@click.option("--real", nargs=2, metavar="A B", help="The real zeros on an interval.")
@click.option(
    "--cut",
    "cuts",
    nargs=4,
    multiple=True,
    metavar="RE IM DRE DIM",
    help="A branch cut from RE + i IM on, in the direction DRE + i DIM. May be given more than once.",
)
@digits_option(15)
@EFFORT
@JSON
@output("Path of the certificate.  [default: none is written]")
def roots(
    function: str,
    rectangle: tuple[str, ...] | None,
    disc: tuple[str, ...] | None,
    half_plane: tuple[str, ...] | None,
    real: tuple[str, ...] | None,
    cuts: tuple[tuple[str, ...], ...],
    digits: int,
    effort: str | None,
    as_json: bool,
    output: Path | None,
) -> None:
    """Find, count and prove the zeros of FUNCTION, like "sin(z) - z/2", in a region of the z-plane.

    Exit status 0: proved. 1: undecided, with the reason and what helps, or the certificate could not be written.
    2: the input cannot be used.
    """
    path = None if output is None else certificate_path(Path("roots"), output)
    answer = _answer(function, (rectangle, disc, half_plane, real), cuts, digits, effort)
    if as_json:
        echo_json(_data(answer))
    else:
        say(_text(answer))
    if path is not None and answer.proved and answer.certificate is not None:
        answer.certificate.save(path)
    sys.exit(0 if answer.proved else UNDECIDED)


def _answer(function: str, regions: tuple[Any, ...], cuts: Any, digits: int, seconds: str | None) -> Any:
    from mpsolve.certificate.real_roots import real_roots
    from mpsolve.certificate.roots import roots as prove
    from mpsolve.zeros.regions import Cut, Disc, HalfPlane, Rectangle

    given = [k for k, region in enumerate(regions) if region is not None]
    if len(given) != 1:
        stated = f"{len(given)} of {', '.join(_REGIONS)} are given" if given else "is given without a region"
        raise InputError("FUNCTION", f"{stated}: give one of {', '.join(_REGIONS)}")
    effort = effort_of(seconds)
    values = regions[given[0]]
    with progress() as tell:
        common: dict[str, Any] = {"digits": digits, "effort": effort, "progress": tell}
        if given[0] == 3:
            if cuts:
                raise InputError("cut", "has no meaning for an interval: leave it out")
            return real_roots(function, *values, **common)
        try:
            region = (Rectangle, lambda x, y, r: Disc((x, y), r), HalfPlane)[given[0]](*values)
        except InputError as error:
            raise InputError(
                _REGIONS[given[0]], f"{error.key.rpartition('.')[2]} {str(error).split(': ', 1)[1]}"
            ) from None
        rays = [Cut.ray((x, y), (u, v)) for x, y, u, v in cuts]
        return prove(function, region, cuts=rays, **common)


def _text(answer: Any) -> str:
    lines = [f"f(z) = {answer.function}"]
    if answer.note:
        lines.append(f"Note: {answer.note}.")
    lines += [f"Assumed: {one}." for one in answer.assumed]
    if not answer.proved:
        return "\n".join([*lines, f"Undecided: {answer.reason}."])
    number = "no zeros" if not answer.count else "1 zero" if answer.count == 1 else f"{answer.count} zeros"
    lines.append(f"{answer.status.value.capitalize()}: {number} in {answer.where}, counted with multiplicity.")
    for zero in answer.roots:
        times = f"   {zero.multiplicity} times" if zero.multiplicity > 1 else ""
        lines.append(f"  {zero.q.str(answer.digits)}{times}")
    return "\n".join(lines)


def _data(answer: Any) -> dict[str, Any]:
    zeros = [
        {"z": zero.q.str(answer.digits), "multiplicity": zero.multiplicity, "real": zero.real}
        for zero in answer.roots
    ]
    return {
        "format": "mpsolve roots",
        "version": 1,
        "function": answer.function,
        "region": answer.where,
        "status": answer.status.value,
        "count": answer.count,
        "zeros": zeros,
        "reason": None if answer.reason is None else answer.reason.data(),
        "note": answer.note,
        "assumed": list(answer.assumed),
        "digits": answer.digits,
    }
