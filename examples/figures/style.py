"""The paper's way of drawing, greys from light to black as the distance grows; how a figure is checked and run."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from mpsolve.errors import InputError
from mpsolve.files import write_whole

LIMIT: dict[str, Any] = {"color": "black", "linestyle": ":", "linewidth": 0.9}
SINGLE: dict[str, Any] = {"color": "black", "linestyle": "--", "linewidth": 0.9}
DOUBLED: dict[str, Any] = {"color": "black", "linestyle": "-.", "linewidth": 0.9}

_SUFFIXES = {"svg": {"Date": None, "Creator": None}, "pdf": {"CreationDate": None}, "png": {"Software": None}}
_RC: Any = {
    "svg.hashsalt": "mpsolve",
    "svg.fonttype": "path",
    "font.size": 8,
    "axes.linewidth": 0.6,
    "axes.titlesize": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "legend.fontsize": 7,
    "lines.linewidth": 1.1,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
}


def greys(count: int) -> list[str]:
    """Grey levels of matplotlib, from light to black."""
    return [f"{0.8 * (1 - k / max(count - 1, 1)):.3f}" for k in range(count)]


@contextmanager
def page(
    path: Path | str, rows: int, columns: int, panel: tuple[float, float] = (2.6, 1.9), **shared: Any
) -> Iterator[Any]:
    """Axes, shape (rows, columns), of panels so many inches wide and high; written to path at the end, whole or not
    at all, with the same bytes each time. InputError for a suffix other than .svg, .pdf, .png."""
    path = Path(path)
    kind = path.suffix.lower()[1:]
    if kind not in _SUFFIXES:
        raise InputError("path", f"{path} ends in {path.suffix or 'nothing'!r}: give .svg, .pdf or .png")
    import matplotlib as mpl
    from matplotlib.figure import Figure

    with mpl.rc_context(_RC):
        figure = Figure(figsize=(panel[0] * columns, panel[1] * rows), layout="constrained")
        yield figure.subplots(rows, columns, squeeze=False, **shared)
        stream = io.BytesIO()
        metadata: Any = _SUFFIXES[kind]
        figure.savefig(stream, format=kind, dpi=200, metadata=metadata, facecolor="white")
        write_whole(path, stream.getvalue())


def agree(found: Any, truth: Any, error: Any) -> None:
    """AssertionError, with the numbers, unless found is truth within error; arrays of one shape, or one truth."""
    found, truth = np.asarray(found), np.asarray(truth)
    assert found.shape == truth.shape or not truth.ndim, f"{found} and {truth} are not of one shape"
    assert np.all(np.abs(found - truth) <= error), f"{found} is not {truth} within {error}"


def run(check: Callable[[], None], visualize: Callable[[Path | str], Path], name: str) -> None:
    """Checks, then draws to the path given on the command line, by default to name.svg in the folder of the call."""
    check()
    print(visualize(sys.argv[1] if len(sys.argv) > 1 else f"{name}.svg"))
