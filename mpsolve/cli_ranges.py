"""The commands about stability over ranges of any parameters: onset, crossings, lines, worst, robust, chart."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click

from mpsolve.cli_answered import answered
from mpsolve.cli_tools import (
    DASK,
    EFFORT,
    FILE,
    JSON,
    PATH,
    WORKERS,
    Option,
    command,
    digits_option,
    effort_of,
    in_parts,
    output,
)
from mpsolve.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable

    from mpsolve.progress import Progress
    from mpsolve.proof.effort import Effort
    from mpsolve.report.ranges_asked import Asked
    from mpsolve.report.ranges_words import Said

_ASKED = (digits_option(15), EFFORT, JSON)
_CERTIFICATE = click.option(
    "--certificate",
    type=PATH,
    help="Write the certificate as FILE.json, for `mpsolve verify`; FILE-2.json, … for further ranges.",
)
_TABLE = "Write the answer as FILE.json, or its rows as FILE.csv."
_DRAWN = (".svg", ".json", ".csv")
_ENDLESS = "A factor of all masses may be without end, scale.mass=0.. .  "
_VELOCITIES = "[default: v from 0, so far that it holds the file's own velocity and the waves of the track]"


def _over(several: bool, default: str) -> Option:
    many = "; again for each parameter" if several else ""
    text = (
        f"PATH=LOW..HIGH: a parameter (v, track.k, vehicles.wheel, vehicles[0].M, gap[0], scale.mass) and its range, "
        f"such as v=0..400km/h{many}.  {default}"
    )
    return click.option("--over", "overs", multiple=True, metavar="RANGE", help=text)


def _asking(prove: Any, said_of: Any, effort: Effort | None, **more: Any) -> Callable[[Asked, Progress | None], Said]:
    """Asks with what is left of the effort of the command, which may ask several ranges, and says what is found."""

    def answer(question: Asked, tell: Progress | None) -> Said:
        options = {"effort": effort and effort.rest(), "progress": tell, **more}
        return cast("Said", said_of(prove(question.given, over=question.over, **options), question))

    return answer


@command(
    FILE,
    _over(False, _ENDLESS + _VELOCITIES),
    click.option(
        "--all", "everything", is_flag=True, help="Every unstable part of the range, not the first onset alone."
    ),
    click.option(
        "--worst",
        "worsts",
        multiple=True,
        metavar="RANGE",
        help="A second parameter and its range, such as gap[0]=1m..2m: the onset at its worst value.",
    ),
    *_ASKED,
    output(_TABLE),
    _CERTIFICATE,
)
def onset(everything: bool, worsts: tuple[str, ...], digits: int, effort: str | None, **asked: Any) -> None:
    """Prove from which value of a parameter on the problem in FILE (TOML) is unstable: from which velocity, say.

    The file's own value of that parameter plays no part, but the report says how far it is from the onset.

    Exit status 0: proved, whatever the answer. 1: undecided, with the reason. 2: the input cannot be used.
    """
    from mpsolve.ranges.onset import onset as prove
    from mpsolve.ranges.unstable import unstable_ranges
    from mpsolve.report.ranges_words import said_of_onset, said_of_ranges
    from mpsolve.report.worst_words import said_of_onset_at_worst

    whole = effort_of(effort)

    def at_worst(question: Asked, tell: Progress | None) -> Said:
        second = question.second(worsts)
        said = partial(said_of_onset_at_worst, second=second)
        return _asking(prove, said, whole, digits=digits, worst=second.over)(question, tell)

    if everything:
        answer = _asking(unstable_ranges, said_of_ranges, whole, digits=digits)
    else:
        answer = at_worst if worsts else _asking(prove, said_of_onset, whole, digits=digits)
    if len(worsts) > 1:
        raise InputError("--worst", "is given more than once: name one parameter")
    if worsts and everything:
        raise InputError("--worst", "asks for one onset, --all for every unstable part: give one of the two")
    answered(answer, "near" if everything or worsts else "first", endless=not worsts, **asked)


@command(FILE, _over(False, _ENDLESS + _VELOCITIES), *_ASKED, output(_TABLE), _CERTIFICATE)
def crossings(digits: int, effort: str | None, **asked: Any) -> None:
    """Prove all values of a parameter at which the problem in FILE (TOML) becomes unstable or stable.

    A root q is real there. Exit status as for onset.
    """
    from mpsolve.ranges.crossings import crossings as prove
    from mpsolve.report.ranges_words import said_of_crossings

    answered(_asking(prove, said_of_crossings, effort_of(effort), digits=digits), endless=True, **asked)


@command(
    FILE,
    _over(False, _VELOCITIES),
    click.option("--points", type=int, default=33, show_default=True, help="How many values, evenly spaced."),
    click.option("--region", type=click.Choice(["sheet", "unstable"]), help="In place of what lies below the cuts."),
    *_ASKED,
    output("Draw FILE.svg, or write FILE.csv or .json, with points."),
)
def lines(points: int, region: str | None, digits: int, effort: str | None, **asked: Any) -> None:
    """Follow every root below the branch cuts of the problem in FILE (TOML) along a parameter, with proof.

    Of a case in the paper's ratios, and of masses on any such beam with --region sheet, every root of the whole
    sheet, above the cuts too, to where it meets a cut.

    Exit status 0: every root is followed and none is missing. 1: some are open. 2: the input cannot be used.
    """
    from mpsolve.loci.lines import frequency_lines
    from mpsolve.report.lines_words import said_of_lines

    answer = _asking(frequency_lines, said_of_lines, effort_of(effort), digits=digits, points=points, region=region)
    answered(answer, suffixes=_DRAWN, **asked)


@command(
    FILE,
    _over(False, "[default: gap[0] from half to twice its own value; v as for onset where there is one vehicle]"),
    *_ASKED,
    output(_TABLE),
)
def worst(digits: int, effort: str | None, **asked: Any) -> None:
    """Prove at which value of a parameter the problem in FILE (TOML) is least stable: at which distance, say.

    That is where the vibration that grows fastest grows fastest, or, where none grows, the least damped one decays
    most slowly: the global minimum of Im q over the range, its ends included. Exit status as for onset.
    """
    from mpsolve.ranges.worst import worst as prove
    from mpsolve.report.worst_words import said_of_worst

    answered(_asking(prove, said_of_worst, effort_of(effort), digits=digits), "gap", **asked)


@command(
    FILE,
    _over(True, "At least one must be given."),
    EFFORT,
    JSON,
    output("Draw FILE.svg, what stays open and the counterexample, or write FILE.csv or .json."),
    _CERTIFICATE,
    click.option(
        "--store",
        type=PATH,
        help="Prove it part by part, each kept in this file, such as box.sqlite, when it is proved.",
    ),
    click.option(
        "--boxes", type=int, help="With --store: boxes that the proof of a part may take.  [default: 100000]"
    ),
    WORKERS,
    DASK,
)
def robust(
    overs: tuple[str, ...],
    effort: str | None,
    store: Path | None,
    boxes: int | None,
    workers: int | None,
    dask: str | None,
    **asked: Any,
) -> None:
    """Prove that the problem in FILE (TOML) is stable for all values of several parameters in their ranges at once.

    Or find a certified counterexample, or list the parts of the ranges that stay open. With --store the same command
    goes on where an earlier one was killed, and tries open parts again with more --boxes; `mpsolve status` and
    `mpsolve export` read that file. Exit status 0: proved stable, or proved unstable at the point that is shown.
    1: undecided. 2: the input cannot be used.
    """

    def answer(question: Asked, tell: Progress | None) -> Said:
        from mpsolve.report.robust_words import said_of_robust
        from mpsolve.studies.robust import prove_stable

        with in_parts(effort, store, boxes, workers, dask) as options:
            found = prove_stable(question.given, over=question.over, progress=tell, **options)
            return said_of_robust(found, question)

    if not overs:
        stated = "is missing: give the range of each uncertain parameter, as in --over v=0..80m/s"
        raise InputError("--over", stated)
    answered(answer, suffixes=_DRAWN, overs=overs, **asked)


@command(
    FILE,
    _over(True, "[default: velocities as for onset, and scale.mass=0.2..3, a factor on all masses]"),
    click.option(
        "--depth", type=int, default=6, show_default=True, help="2^DEPTH cells along each parameter, DEPTH 2 to 10."
    ),
    EFFORT,
    JSON,
    output("Draw FILE.svg, or write FILE.csv or .json, with each cell."),
    _CERTIFICATE,
)
def chart(depth: int, effort: str | None, **asked: Any) -> None:
    """Prove how many roots grow over two parameters of the problem in FILE (TOML): as regions, and strips between.

    Exit status 0: every region is proved. 1: some are open. 2: the input cannot be used.
    """
    from mpsolve.ranges.chart import stability_chart
    from mpsolve.report.robust_words import said_of_chart

    answer = _asking(stability_chart, said_of_chart, effort_of(effort), depth=depth)
    answered(answer, "chart", suffixes=_DRAWN, **asked)
