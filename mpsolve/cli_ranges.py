"""The commands about stability over ranges of any parameters: onset, crossings, lines, worst, robust, chart."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve.cli_answered import answered
from mpsolve.cli_tools import DASK, WORKERS, cluster, effort_of, one_sentence

if TYPE_CHECKING:
    from mpsolve.progress import Progress
    from mpsolve.report.ranges_asked import Asked
    from mpsolve.report.ranges_words import Said

_FILE = click.argument("file", type=click.Path(path_type=Path))
_DIGITS = click.option("--digits", type=int, default=15, show_default=True, help="Certified digits, 15 to 10000.")
_EFFORT = click.option("--effort", metavar="SECONDS", help="Processor time that the proof may take.")
_JSON = click.option("--json", "as_json", is_flag=True, help="Report for machines, in JSON.")
_OUTPUT = click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="Write the answer as FILE.json, or its rows as FILE.csv."
)
_CERTIFICATE = click.option(
    "--certificate",
    type=click.Path(path_type=Path),
    help="Write the certificate as FILE.json, for `mpsolve verify`; FILE-2.json, … for further ranges.",
)


def _over(several: bool, default: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    many = "; again for each parameter" if several else ""
    text = (
        f"PATH=LOW..HIGH: a parameter (v, track.k, vehicles.wheel, vehicles[0].M, gap[0], scale.mass) and its range, "
        f"such as v=0..400km/h{many}.  {default}"
    )
    return click.option("--over", "overs", multiple=True, metavar="RANGE", help=text)


_ENDLESS = "A factor of all masses may be without end, scale.mass=0.. .  "
_VELOCITIES = "[default: v from 0, so far that it holds the file's own velocity and the waves of the track]"


@click.command()
@_FILE
@_over(False, _ENDLESS + _VELOCITIES)
@click.option(
    "--all", "everything", is_flag=True, help="Every unstable part of the range, not the first onset alone."
)
@click.option(
    "--worst",
    "worsts",
    multiple=True,
    metavar="RANGE",
    help="A second parameter and its range, such as gap[0]=1m..2m: the onset at its worst value.",
)
@_DIGITS
@_EFFORT
@_JSON
@_OUTPUT
@_CERTIFICATE
def onset(
    file: Path,
    overs: tuple[str, ...],
    everything: bool,
    worsts: tuple[str, ...],
    digits: int,
    effort: str | None,
    as_json: bool,
    output: Path | None,
    certificate: Path | None,
) -> None:
    """Prove from which value of a parameter on the problem in FILE (TOML) is unstable: from which velocity, say.

    The file's own value of that parameter plays no part, but the report says how far it is from the onset.

    Exit status 0: proved, whatever the answer. 1: undecided, with the reason. 2: the input cannot be used.
    """

    def answer(question: Asked, tell: Progress | None) -> Said:
        from mpsolve.ranges.onset import onset as prove
        from mpsolve.ranges.onset import unstable_ranges
        from mpsolve.report import ranges_words as words

        options: dict[str, Any] = {"digits": digits, "effort": effort_of(effort), "progress": tell}
        if worsts:
            from mpsolve.report.worst_words import said_of_onset_at_worst

            second = question.second(worsts)
            found = prove(question.given, over=question.over, worst=second.over, **options)
            return said_of_onset_at_worst(found, question, second)
        if everything:
            return words.said_of_ranges(unstable_ranges(question.given, over=question.over, **options), question)
        return words.said_of_onset(prove(question.given, over=question.over, **options), question)

    with one_sentence():
        _only_one(worsts, everything)
    default = "near" if everything or worsts else "first"
    answered(file, overs, answer, as_json, output, default, certificate=certificate, endless=not worsts)


@click.command()
@_FILE
@_over(False, _ENDLESS + _VELOCITIES)
@_DIGITS
@_EFFORT
@_JSON
@_OUTPUT
@_CERTIFICATE
def crossings(
    file: Path,
    overs: tuple[str, ...],
    digits: int,
    effort: str | None,
    as_json: bool,
    output: Path | None,
    certificate: Path | None,
) -> None:
    """Prove all values of a parameter at which the problem in FILE (TOML) becomes unstable or stable.

    A root q is real there. Exit status as for onset.
    """

    def answer(question: Asked, tell: Progress | None) -> Said:
        from mpsolve.ranges.crossings import crossings as prove
        from mpsolve.report import ranges_words as words

        found = prove(question.given, over=question.over, digits=digits, effort=effort_of(effort), progress=tell)
        return words.said_of_crossings(found, question)

    answered(file, overs, answer, as_json, output, certificate=certificate, endless=True)


@click.command()
@_FILE
@_over(False, _VELOCITIES)
@click.option("--points", type=int, default=33, show_default=True, help="How many values, evenly spaced.")
@click.option("--region", type=click.Choice(["sheet", "unstable"]), help="In place of what lies below the cuts.")
@_DIGITS
@_EFFORT
@_JSON
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="Draw FILE.svg, or write FILE.csv or .json, with points."
)
def lines(
    file: Path,
    overs: tuple[str, ...],
    points: int,
    region: str | None,
    digits: int,
    effort: str | None,
    as_json: bool,
    output: Path | None,
) -> None:
    """Follow every root below the branch cuts of the problem in FILE (TOML) along a parameter, with proof.

    Of a case in the paper's ratios, and of masses on any such beam with --region sheet, every root of the whole
    sheet, above the cuts too, to where it meets a cut.

    Exit status 0: every root is followed and none is missing. 1: some are open. 2: the input cannot be used.
    """

    def answer(question: Asked, tell: Progress | None) -> Said:
        from mpsolve.loci.lines import frequency_lines
        from mpsolve.report.lines_words import said_of_lines

        options: dict[str, Any] = {"digits": digits, "effort": effort_of(effort), "progress": tell, "region": region}
        return said_of_lines(frequency_lines(question.given, over=question.over, points=points, **options), question)

    answered(file, overs, answer, as_json, output, suffixes=(".svg", ".json", ".csv"))


@click.command()
@_FILE
@_over(False, "[default: gap[0] from half to twice its own value; v as for onset where there is one vehicle]")
@_DIGITS
@_EFFORT
@_JSON
@_OUTPUT
def worst(
    file: Path, overs: tuple[str, ...], digits: int, effort: str | None, as_json: bool, output: Path | None
) -> None:
    """Prove at which value of a parameter the problem in FILE (TOML) is least stable: at which distance, say.

    That is where the vibration that grows fastest grows fastest, or, where none grows, the least damped one decays
    most slowly: the global minimum of Im q over the range, its ends included. Exit status as for onset.
    """

    def answer(question: Asked, tell: Progress | None) -> Said:
        from mpsolve.ranges.worst import worst as prove
        from mpsolve.report.worst_words import said_of_worst

        found = prove(question.given, over=question.over, digits=digits, effort=effort_of(effort), progress=tell)
        return said_of_worst(found, question)

    answered(file, overs, answer, as_json, output, "gap")


@click.command()
@_FILE
@_over(True, "At least one must be given.")
@_EFFORT
@_JSON
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="Draw FILE.svg, what stays open and the counterexample, or write FILE.csv or .json.",
)
@_CERTIFICATE
@click.option(
    "--store",
    type=click.Path(path_type=Path),
    help="Prove it part by part, each kept in this file, such as box.sqlite, when it is proved.",
)
@click.option("--boxes", type=int, help="With --store: boxes that the proof of a part may take.  [default: 100000]")
@WORKERS
@DASK
def robust(
    file: Path,
    overs: tuple[str, ...],
    effort: str | None,
    as_json: bool,
    output: Path | None,
    certificate: Path | None,
    **shared: Any,
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

        with _in_parts(effort, **shared) as options:
            return said_of_robust(
                prove_stable(question.given, over=question.over, progress=tell, **options), question
            )

    with one_sentence():
        _required(overs)
    answered(file, overs, answer, as_json, output, "near", (".svg", ".json", ".csv"), certificate)


@contextmanager
def _in_parts(
    effort: str | None, store: Path | None, boxes: int | None, workers: int | None, dask: str | None
) -> Iterator[dict[str, Any]]:
    """The options of a proof: at once, or part by part in a store."""
    from mpsolve.errors import InputError
    from mpsolve.proof.effort import Effort

    if store is None:
        for name, given in (("--boxes", boxes), ("--dask", dask)):
            if given is not None:
                raise InputError(name, "is given without --store: give the file that keeps what is proved")
        yield {"effort": effort_of(effort), "workers": workers or 1}
        return
    if effort is not None:
        raise InputError("--effort", "is given beside --store: give --boxes, the work of each part, in its place")
    with cluster(dask, workers) as (executor, _):
        yield {
            "store": store,
            "executor": executor,
            "workers": workers,
            "effort": None if boxes is None else Effort(evaluations=boxes),
        }


def _only_one(worsts: tuple[str, ...], everything: bool) -> None:
    from mpsolve.errors import InputError

    if len(worsts) > 1:
        raise InputError("--worst", "is given more than once: name one parameter")
    if worsts and everything:
        raise InputError("--worst", "asks for one onset, --all for every unstable part: give one of the two")


def _required(overs: tuple[str, ...]) -> None:
    from mpsolve.errors import InputError

    if not overs:
        raise InputError("--over", "is missing: give the range of each uncertain parameter, as in --over v=0..80m/s")


@click.command()
@_FILE
@_over(True, "[default: velocities as for onset, and scale.mass=0.2..3, a factor on all masses]")
@click.option(
    "--depth", type=int, default=6, show_default=True, help="2^DEPTH cells along each parameter, DEPTH 2 to 10."
)
@_EFFORT
@_JSON
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="Draw FILE.svg, or write FILE.csv or .json, with each cell.",
)
def chart(
    file: Path, overs: tuple[str, ...], depth: int, effort: str | None, as_json: bool, output: Path | None
) -> None:
    """Prove how many roots grow over two parameters of the problem in FILE (TOML): as regions, and strips between.

    Exit status 0: every region is proved. 1: some are open. 2: the input cannot be used.
    """

    def answer(question: Asked, tell: Progress | None) -> Said:
        from mpsolve.ranges.chart import stability_chart
        from mpsolve.report.robust_words import said_of_chart

        found = stability_chart(
            question.given, over=question.over, depth=depth, effort=effort_of(effort), progress=tell
        )
        return said_of_chart(found, question)

    answered(file, overs, answer, as_json, output, "chart", (".svg", ".json", ".csv"))


COMMANDS = (onset, crossings, lines, worst, robust, chart)
