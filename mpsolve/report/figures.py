"""What all figures share: the look on screen and in print, and how they are written.

Every figure is drawn by a function that takes matplotlib axes and returns them.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from mpsolve.errors import InputError
from mpsolve.files import write_whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


SUFFIXES = (".svg", ".pdf", ".png")
SIZE = (5.2, 3.3)  # inches; 10 pt of text can still be read where a phone shrinks it
_STYLE: Any = {
    "svg.hashsalt": "mpsolve",
    "svg.fonttype": "path",
    "font.size": 10,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.useoffset": False,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "lines.linewidth": 1.4,
    "axes.unicode_minus": True,
}
_UNDATED: dict[str, Any] = {
    "svg": {"Date": None, "Creator": None},
    "pdf": {"CreationDate": None},
    "png": {"Software": None},
}
_DASHES = ("-", (0, (6, 2)), (0, (2, 1.5)), (0, (6, 2, 1.5, 2)))


@dataclass(frozen=True)
class Look:
    """Colours, and line styles that keep lines apart where there is no colour."""

    ink: str
    stable: str
    unstable: str
    cut: str
    faint: str
    shade: str
    series: tuple[str, ...]
    counts: tuple[str, ...]  # fills for 0, 2, 4, 6, 8 or more unstable roots
    dashes: tuple[Any, ...]

    def line(self, k: int) -> dict[str, Any]:
        """Colour and style of the k-th of several lines."""
        return {"color": self.series[k % len(self.series)], "linestyle": self.dashes[k % len(self.dashes)]}

    def root(self, grows: bool) -> dict[str, str]:
        """A root is a disc, and a diamond if it grows."""
        colour = self.unstable if grows else self.stable
        return {"marker": "D" if grows else "o", "color": colour, "markeredgecolor": "white", "linestyle": ""}


# Okabe and Ito's palette, which the colour-blind tell apart
COLOUR = Look(
    "black",
    "#0072B2",
    "#D55E00",
    "#444444",
    "#777777",
    "#F9E5D9",
    ("#0072B2", "#D55E00", "#009E73", "#CC79A7"),
    ("#FFFFFF", "#F5C28A", "#E07B39", "#A23B1A", "#5C1A0B"),
    _DASHES,
)


def require_matplotlib() -> None:
    """InputError if matplotlib is missing."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise InputError("matplotlib", "is needed for a picture, and missing: pip install matplotlib") from None


@contextmanager
def styled() -> Iterator[None]:
    """The style of all figures; what is drawn inside looks the same whatever the user's settings are."""
    require_matplotlib()
    import matplotlib as mpl

    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(_STYLE)
        yield


def figure_of(draw: Callable[[Axes], Axes], size: tuple[float, float] = SIZE) -> Figure:
    """A figure with one axes, drawn by `draw`, in the style of all figures; size in inches."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=size, layout="constrained")
        ax = figure.add_subplot(gid="axes")
        draw(ax)
        return figure


def save_figure(draw: Callable[[Axes], Axes], path: str | Path, size: tuple[float, float] = SIZE) -> Path:
    """Writes .svg (for pages), .pdf (for papers) or .png, the same bytes each time for one version of matplotlib.

    Raises InputError for another name or where matplotlib is missing, CertificateError if the file cannot be written.
    """
    file = Path(path)
    if file.suffix.lower() not in SUFFIXES:
        raise InputError("output", f"{file} does not end in {', '.join(SUFFIXES)}: give a name that does")
    return write_whole(file, rendered(figure_of(draw, size), file.suffix.lower()[1:]))


def save_panels(
    panels: Sequence[Callable[[Axes], Any]], path: Path, title: str, height: float, before: float = 0.0
) -> Path:
    """Panels under each other, each of this height in inches, as .png, .svg or .pdf, whole or not at all."""
    require_matplotlib()
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.0, height * len(panels) + before), layout="constrained")
    for k, panel in enumerate(panels, 1):
        panel(figure.add_subplot(len(panels), 1, k))
    if title:
        figure.suptitle(title, fontsize=11)
    return write_whole(path, rendered(figure, path.suffix.lower()[1:]))


def rendered(figure: Figure, kind: str) -> bytes:
    """The figure as "svg", "pdf" or "png", without any date."""
    stream = io.BytesIO()
    with styled():
        figure.savefig(stream, format=kind, dpi=160, metadata=_UNDATED[kind], facecolor="white")
    return stream.getvalue()
