"""The commands about stability over ranges of any parameters of any problem: onset, crossings, robust, chart."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve.cli_tools import UNDECIDED, checked_output, effort_of, one_sentence, progress

if TYPE_CHECKING:
    from mpsolve.progress import Progress
    from mpsolve.report.ranges_asked import Asked
    from mpsolve.report.ranges_words import Said

_FILE = click.argument("file", type=click.Path(path_type=Path))
_DIGITS = click.option("--digits", type=int, default=15, show_default=True, help="Certified digits, 15 to 10000.")
_EFFORT = click.option("--effort", type=float, metavar="SECONDS", help="Processor time that the proof may take.")
_JSON = click.option("--json", "as_json", is_flag=True, help="Report for machines, in JSON.")
_OUTPUT = click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="Write the answer as FILE.json, or its rows as FILE.csv."
)
_SUFFIXES = (".json", ".csv")
_CHART = (".svg", *_SUFFIXES)
_TABLES = (".csv", ".json", ".tex")


def _over(several: bool, default: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    many = "; again for each parameter" if several else ""
    text = (
        f"PATH=LOW..HIGH: a parameter (v, track.k, vehicles.wheel, vehicles[0].M, gap[0], scale.mass) and its range, "
        f"such as v=0..400km/h{many}.  {default}"
    )
    return click.option("--over", "overs", multiple=True, metavar="RANGE", help=text)


_VELOCITIES = "[default: v from 0, so far that it holds the file's own velocity and the waves of the track]"


@click.command()
@_FILE
@_over(False, _VELOCITIES)
@click.option(
    "--all", "everything", is_flag=True, help="Every unstable part of the range, not the first onset alone."
)
@_DIGITS
@_EFFORT
@_JSON
@_OUTPUT
def onset(
    file: Path,
    overs: tuple[str, ...],
    everything: bool,
    digits: int,
    effort: float | None,
    as_json: bool,
    output: Path | None,
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
        if everything:
            return words.said_of_ranges(unstable_ranges(question.given, over=question.over, **options), question)
        return words.said_of_onset(prove(question.given, over=question.over, **options), question)

    _answer(file, overs, answer, as_json, output, "near" if everything else "first")


@click.command()
@_FILE
@_over(False, _VELOCITIES)
@_DIGITS
@_EFFORT
@_JSON
@_OUTPUT
def crossings(
    file: Path, overs: tuple[str, ...], digits: int, effort: float | None, as_json: bool, output: Path | None
) -> None:
    """Prove all values of a parameter at which the problem in FILE (TOML) becomes unstable or stable.

    A root q is real there. Exit status as for onset.
    """

    def answer(question: Asked, tell: Progress | None) -> Said:
        from mpsolve.ranges.crossings import crossings as prove
        from mpsolve.report import ranges_words as words

        found = prove(question.given, over=question.over, digits=digits, effort=effort_of(effort), progress=tell)
        return words.said_of_crossings(found, question)

    _answer(file, overs, answer, as_json, output)


@click.command()
@_FILE
@_over(True, "At least one must be given.")
@_EFFORT
@_JSON
@_OUTPUT
def robust(file: Path, overs: tuple[str, ...], effort: float | None, as_json: bool, output: Path | None) -> None:
    """Prove that the problem in FILE (TOML) is stable for all values of several parameters in their ranges at once.

    Or find a certified counterexample, or list the parts of the ranges that stay open. Exit status 0: proved stable,
    or proved unstable at the point that is shown. 1: undecided. 2: the input cannot be used.
    """

    def answer(question: Asked, tell: Progress | None) -> Said:
        from mpsolve.ranges.robust import prove_stable
        from mpsolve.report.robust_words import said_of_robust

        found = prove_stable(question.given, over=question.over, effort=effort_of(effort), progress=tell)
        return said_of_robust(found, question)

    with one_sentence():
        _required(overs)
    _answer(file, overs, answer, as_json, output)


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
    file: Path, overs: tuple[str, ...], depth: int, effort: float | None, as_json: bool, output: Path | None
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

    _answer(file, overs, answer, as_json, output, "chart", _CHART)


@click.command()
@_FILE
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="Write FILE.csv or .json (.tex too in the paper's ratios).",
)
@click.option(
    "--certificates", type=click.Path(path_type=Path), help="Folder for certificates (tables in the paper's ratios)."
)
@click.option("--workers", type=int, help="Processes.  [default: as many as there are processors]")
def table(file: Path, output: Path | None, certificates: Path | None, workers: int | None) -> None:
    """Prove a table of onsets, or of all unstable ranges, over a grid of two parameters, as FILE (TOML) describes it.

    FILE names a problem file, the range and the two grids (examples/rail_table.toml), or gives all of it in the
    paper's ratios (examples/onset_table.toml). Without -o it is printed as CSV. Exit status 0: every entry is proved.
    1: some are undecided, or the file could not be written. 2: the input cannot be used.
    """
    with one_sentence():
        from mpsolve.errors import InputError
        from mpsolve.files import checked_suffix, write_whole
        from mpsolve.report.range_table import is_of_a_problem, read_table, summary, table_csv, table_json

        ours = is_of_a_problem(file)
        if output is not None:
            checked_suffix(checked_output(output, file, "the table"), (".csv", ".json") if ours else _TABLES)
        if certificates is not None and (ours or (certificates.exists() and not certificates.is_dir())):
            stated = f"{certificates} is a file: give the path of a folder"
            raise InputError("certificates", "there are none for this kind of table: leave it out" if ours else stated)
        if ours:
            with progress() as tell:
                made = read_table(file, workers, tell)
            proved = made.proved
            if output is None:
                click.echo(table_csv(made), nl=False)
            else:
                write_whole(output, table_csv(made) if output.suffix.lower() == ".csv" else table_json(made))
                click.echo(f"{summary(made)}\n{output}")
        else:
            proved = _of_ratios(file, output, certificates, workers)
    sys.exit(0 if proved else UNDECIDED)


def _of_ratios(file: Path, output: Path | None, certificates: Path | None, workers: int | None) -> bool:
    """The table of a file in the paper's ratios."""
    from mpsolve.stability.table import onset_table

    with progress() as tell:
        made = onset_table(file, workers, tell)
    if output is None:
        click.echo(made.to_csv(), nl=False)
    else:
        found = [entry.status for row in made.entries for entry in row]
        counts = (
            f"{found.count(one)} {one}" for one in ("proved", "stable", "unstable", "undecided") if one in found
        )
        click.echo(f"{len(found)} entries: {', '.join(counts)}.\n{made.save(output)}")
    if certificates is not None:
        made.save_certificates(certificates)
    return made.proved


COMMANDS = (onset, crossings, robust, chart, table)


def _answer(
    file: Path,
    overs: tuple[str, ...],
    answer: Callable[[Asked, Progress | None], Said],
    as_json: bool,
    output: Path | None,
    defaults: str = "near",
    suffixes: tuple[str, ...] = _SUFFIXES,
) -> None:
    """Reads, answers, reports, writes and exits. defaults: the ranges where none is given."""
    with one_sentence():
        from mpsolve.files import checked_suffix
        from mpsolve.problem.inputfile import read_source
        from mpsolve.report.ranges_asked import asked

        source = read_source(file)
        if output is not None:
            checked_suffix(checked_output(output, file, "the answer"), suffixes)
        question = asked(source.given, source.title, overs)
        with progress() as tell:
            said = [_told(answer(question, tell))] if overs else _by_default(question, answer, tell, defaults)
        if as_json:
            click.echo(json.dumps(_data(said), ensure_ascii=False, indent=1))
        else:
            click.echo("\n".join(one.text for one in said), nl=False)
        if output is not None:
            _write(output, said)
            click.echo(str(output), err=as_json)
    sys.exit(0 if all(one.answer.proved for one in said) else UNDECIDED)


def _by_default(
    question: Asked, answer: Callable[[Asked, Progress | None], Said], tell: Progress | None, defaults: str
) -> list[Said]:
    """The answers over the default ranges in ascending order.

    defaults: "near"; "first", which ends with the first range in which something grows, and goes on to far ones as
    long as they are decided; "chart", masses too, and the range that holds the file's own velocity.
    """
    from mpsolve.ranges.default import MASS_FACTORS, velocity_ranges

    ranges = velocity_ranges(question.problem)
    if defaults == "chart":
        v = question.problem.v
        one = next((ends for ends in ranges.near if ends[0] <= v <= ends[1]), ranges.near[0])
        return [_told(answer(question.by_itself({"v": one, "scale.mass": MASS_FACTORS}), tell))]
    out = []
    for ends in ranges.near:
        out.append(_told(answer(question.by_itself({"v": ends}), tell)))
        if defaults == "first" and (not out[-1].answer.proved or out[-1].grows):
            return out
    for ends in ranges.far if defaults == "first" else ():
        more = _told(answer(question.by_itself({"v": ends}), tell))
        if not more.answer.proved:
            break
        out.append(more)
        if more.grows:
            break
    return out


def _told(said: Said) -> Said:
    """With the names of options in remedies."""
    from mpsolve.report.remedies import on_command_line

    return replace(said, verdict=on_command_line(said.verdict), text=on_command_line(said.text))


def _data(said: list[Said]) -> dict[str, Any]:
    from mpsolve.report.ranges_data import parts_data, ranges_data

    each = [ranges_data(one.name, one.verdict, one.answer, one.asked) for one in said]
    return each[0] if len(each) == 1 else parts_data(each)


def _write(output: Path, said: list[Said]) -> None:
    from mpsolve.files import write_whole
    from mpsolve.report.ranges_files import cells_csv, rows_csv

    suffix, chart = output.suffix.lower(), said[0].answer
    if suffix == ".svg":
        from mpsolve.pictures.proved_chart import proved_chart

        write_whole(output, proved_chart(chart, said[0].asked))
    elif suffix == ".csv":
        write_whole(output, cells_csv(chart, said[0].asked) if said[0].name == "chart" else rows_csv(said))
    else:
        write_whole(output, json.dumps(_data(said), ensure_ascii=False, indent=1) + "\n")
