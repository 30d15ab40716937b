"""How the commands about ranges ask, report and write: ranges by default, JSON, files, exit statuses."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve.cli_tools import UNDECIDED, checked_file, echo_json, json_text, progress, say
from mpsolve.errors import CertificateError

if TYPE_CHECKING:
    from mpsolve.progress import Progress
    from mpsolve.report.ranges_asked import Asked
    from mpsolve.report.ranges_words import Said


def answered(
    answer: Callable[[Asked, Progress | None], Said],
    defaults: str = "near",
    *,
    file: Path,
    overs: tuple[str, ...],
    as_json: bool,
    output: Path | None,
    suffixes: tuple[str, ...] = (".json", ".csv"),
    certificate: Path | None = None,
    endless: bool = False,
) -> None:
    """Reads, answers, reports, writes and exits.

    defaults: the ranges where none is given. endless: whether a range may have no upper end.
    """
    from mpsolve.problem.inputfile import read_source
    from mpsolve.proof.stopping import listening
    from mpsolve.report.ranges_asked import asked
    from mpsolve.report.ranges_words import report_of

    source = read_source(file)
    checked_file(output, file, "the answer", suffixes)
    checked_file(certificate, file, "the certificate", (".json",), "certificate")
    question = asked(source.given, source.title, overs, endless=endless)
    with progress() as tell, listening():
        said = [answer(question, tell)] if overs else _by_default(question, answer, tell, defaults)
    if as_json:
        echo_json(_data(said))
    else:
        say(report_of(said))
    if certificate is not None:
        _certify(certificate, said, as_json)
    if output is not None:
        _write(output, said)
        click.echo(str(output), err=as_json)
    sys.exit(0 if all(one.answer.proved for one in said) else UNDECIDED)


def _by_default(
    question: Asked, answer: Callable[[Asked, Progress | None], Said], tell: Progress | None, defaults: str
) -> list[Said]:
    """The answers over the default ranges in ascending order.

    defaults: "near"; "first", step by step up to the first range in which something grows, or that is undecided;
    "chart", masses too, and the range that holds the file's own velocity; "gap", the first distance of vehicles.
    """
    from mpsolve.ranges.default import MASS_FACTORS, gap_range, velocity_ranges

    if defaults == "gap" and (gaps := gap_range(question.problem)) is not None:
        return [answer(question.by_itself({"gap[0]": gaps}), tell)]

    ranges = velocity_ranges(question.problem)
    if defaults == "chart":
        v = question.problem.v
        one = next((ends for ends in ranges.near if ends[0] <= v <= ends[1]), ranges.near[0])
        return [answer(question.by_itself({"v": one, "scale.mass": MASS_FACTORS}), tell)]
    out: list[Said] = []
    reached = Fraction(0)
    for ends in ranges.steps if defaults == "first" else ranges.near:
        skipped = (reached, ends[0]) if reached < ends[0] else None
        out.append(answer(replace(question.by_itself({"v": ends}), skipped=skipped), tell))
        reached = ends[1]
        if defaults == "first" and (out[-1].grows or not out[-1].answer.proved):
            break
    if len(out) > 1 and not out[-1].answer.proved and out[-1].asked.overs[0].low >= ranges.near[-1][1]:
        out.pop()  # beyond all ranges that hold the velocity and the least critical one: nothing is said of it
    return out


def _data(said: list[Said]) -> dict[str, Any]:
    from mpsolve.report.ranges_data import parts_data, ranges_data

    each = [ranges_data(one.name, one.verdict, one.answer, one.asked) for one in said]
    return each[0] if len(each) == 1 else parts_data(each)


def _certify(path: Path, said: list[Said], quiet: bool) -> None:
    """Writes the certificate of each answer: FILE, then FILE-2, … where an answer falls into several ranges."""
    for number, one in enumerate(said, 1):
        found: Any = one.answer
        if found.certificate is None:
            why = found.note or "it is not proved"
            raise CertificateError(f"no certificate is written: {why}")
        to = path if number == 1 else path.with_name(f"{path.stem}-{number}{path.suffix}")
        found.certificate.save(to)
        click.echo(str(to), err=quiet)


def _write(output: Path, said: list[Said]) -> None:
    from mpsolve.files import write_whole
    from mpsolve.report.lines_words import lines_csv
    from mpsolve.report.ranges_data import cells_csv, rows_csv

    suffix, name = output.suffix.lower(), said[0].name
    drawn: Any = said[0].answer
    if suffix == ".svg":
        write_whole(output, _picture(name)(drawn, said[0].asked))
    elif suffix == ".csv":
        tables: dict[str, Any] = {"chart": cells_csv, "lines": lines_csv}
        write_whole(output, tables[name](drawn, said[0].asked) if name in tables else rows_csv(said))
    else:
        write_whole(output, json_text(_data(said)) + "\n")


def _picture(name: str) -> Callable[[Any, Asked], str]:
    from mpsolve.pictures.over_ranges import loci_picture, open_boxes
    from mpsolve.pictures.proved_chart import proved_chart

    pictures: dict[str, Callable[[Any, Asked], str]] = {"lines": loci_picture, "robust": open_boxes}
    return pictures.get(name, proved_chart)
