"""A response as a table: CSV for people and spreadsheets, NPZ for programs; written whole or not at all."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from mpsolve.certificate.format import write_whole
from mpsolve.motion.solve import Response

_PARTS = ("w", "steady", "harmonic", "transient")


def columns(found: Response) -> dict[str, Any]:
    """Name and values of each column, by time: the four displacements at each ξ, the contact force of each mass."""
    table: dict[str, Any] = {"tau": found.tau}
    for k, place in enumerate(found.xi):
        table |= {f"{part}[xi={place:.10g}]": getattr(found, part)[k] for part in _PARTS}
    return table | {f"contact_force[{j}]": row for j, row in enumerate(found.contact_forces, 1)}


def save_columns(table: Mapping[str, Any], path: Path) -> Path:
    """CSV, each number with all its digits; CertificateError if it cannot be written."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(table)
    writer.writerows([repr(float(x)) for x in row] for row in zip(*table.values(), strict=True))
    return write_whole(path, stream.getvalue())


def save_arrays(found: Response, path: Path) -> Path:
    """NPZ with the arrays of the response under their names."""
    names = (
        "xi",
        "tau",
        "w",
        "steady",
        "steady_harmonic",
        "harmonic",
        "transient",
        "velocity",
        "acceleration",
        "contact_forces",
    )
    stream = io.BytesIO()
    arrays: dict[str, Any] = {name: getattr(found, name) for name in names}
    np.savez(stream, q=np.array([pair.q for pair in found.harmonic_pairs], complex), **arrays)
    return write_whole(path, stream.getvalue())
