"""What the commands share: errors as one sentence with an exit status, progress, reports, paths."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from mpsolve.cli_voice import told
from mpsolve.errors import InputError, MpsolveError, StudyError

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from mpsolve.progress import Progress
    from mpsolve.proof.effort import Effort
    from mpsolve.report.blocks import Document

_NARROW = 40  # columns; a narrower terminal breaks lines itself
UNDECIDED = 1
BAD_INPUT = 2
Option = Callable[[Callable[..., None]], Callable[..., None]]
PATH = click.Path(path_type=Path)
FILE: Option = click.argument("file", type=PATH)
JSON: Option = click.option("--json", "as_json", is_flag=True, help="Report for machines, in JSON.")
EFFORT: Option = click.option(
    "--effort", metavar="SECONDS", help="Processor time that the proof and its verification may take."
)
WORKERS: Option = click.option("--workers", type=int, help="Processes.  [default: as many as there are processors]")
DASK: Option = click.option(
    "--dask", metavar="ADDRESS", help="A Dask scheduler, such as host:8786, instead of processes."
)
INTERRUPTED = 130  # as a shell says of a program that ended by Ctrl-C


def digits_option(default: int, of: str = "") -> Option:
    """The option --digits."""
    said = f"Certified digits{of}, 15 to 10000."
    return click.option("--digits", type=int, default=default, show_default=True, help=said)


def output(text: str) -> Option:
    """The option -o."""
    return click.option("-o", "--output", type=PATH, help=text)


def say(text: str, error: bool = False) -> None:
    """A text, with the names of options in its remedies."""
    from mpsolve.report.remedies import on_command_line

    click.echo(on_command_line(text.removesuffix("\n")), err=error)


def echo_json(data: Any) -> None:
    """Plain values as JSON, for machines."""
    click.echo(json_text(data))


def json_text(data: Any) -> str:
    """The same as a text; texts in it have the names of options in their remedies."""
    import json

    from mpsolve.report.remedies import on_command_line

    return json.dumps(on_command_line(data), ensure_ascii=False, indent=1)


class Command(click.Command):
    """A command that turns an error that mpsolve raises on purpose into a sentence on stderr and an exit status."""

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except InputError as error:
            status, message = BAD_INPUT, told(error)
        except MpsolveError as error:
            status, message = UNDECIDED, str(error)
        except KeyboardInterrupt:
            status, message = INTERRUPTED, "interrupted"
        say(f"mpsolve: {message}", error=True)
        sys.exit(status)


def command(*options: Option) -> Callable[[Callable[..., None]], Command]:
    """A command with these arguments and options."""

    def made(function: Callable[..., None]) -> Command:
        for option in reversed(options):
            function = option(function)
        return click.command(cls=Command)(function)

    return made


_SENTENCE = 200  # letters of the first sentence of a command's help: it is not cut


class Commands(click.Group):
    """Commands of this kind."""

    command_class = Command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        rows = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        with formatter.section("Commands"):
            formatter.write_dl([(name, one.get_short_help_str(_SENTENCE)) for name, one in rows if one is not None])


def certificate_path(source: Path, output: Path | None, kind: str = "") -> Path:
    """Where the certificate goes, NAME.kind.certificate.json by default.

    Raises InputError, before any work is done, if it cannot be a file there.
    """
    stem = "stdin" if str(source) == "-" else source.stem
    path = output or Path(f"{stem}{kind and f'.{kind}'}.certificate.json")
    return checked_output(path, source, "the certificate")


def checked_output(path: Path, source: Path, what: str, key: str = "output") -> Path:
    """The path itself; InputError under `key` if `what` cannot be a file there, or if that is the input file."""
    try:
        if not path.parent.is_dir():
            raise InputError(key, f"{path.parent} is no directory: make it, or give another path for {what}")
        if path.is_dir():
            raise InputError(key, f"{path} is a directory: give the path of a file for {what}")
        if path.exists() and source.exists() and path.samefile(source):
            raise InputError(key, f"{path} is the input file: give another path for {what}")
    except OSError as error:  # a name that is too long, a folder that may not be looked into
        raise InputError(key, f"{path} cannot be used ({error.strerror}): give another path for {what}") from None
    return path


def checked_file(path: Path | None, source: Path, what: str, suffixes: Iterable[str], key: str = "output") -> str:
    """The ending of a path that can be written, "" where none is given; InputError as `checked_output`."""
    from mpsolve.files import checked_suffix

    return "" if path is None else checked_suffix(checked_output(path, source, what, key), tuple(suffixes), key)


@contextmanager
def cluster(address: str | None, workers: int | None) -> Iterator[tuple[Executor | None, int]]:
    """The executor of a Dask cluster and the number of its threads; None, 0 without an address."""
    if address is None:
        yield None, 0
        return
    if workers is not None:
        raise InputError("--workers", "is given, but --dask leaves that to the cluster: give one of the two")
    try:
        from distributed import Client
        from distributed.comm import get_address_host_port
    except ImportError:
        raise InputError("--dask", "needs the package distributed: pip install 'mpsolve[dask]'") from None
    given, address = address, address if "://" in address else f"tcp://{address}"
    try:
        get_address_host_port(address, strict=True)
    except ValueError as error:
        raise InputError("--dask", f"is {given!r}: {error}; give HOST:PORT, or what the scheduler says") from None
    try:
        client = Client(address, timeout=10, set_as_default=False)
    except (OSError, ValueError) as error:
        raise StudyError(f"no Dask scheduler answers at {address} ({error}): start one, or correct it") from None
    with client:
        yield client.get_executor(), sum(client.nthreads().values())


def effort_of(given: str | None) -> Effort | None:
    """The effort of an option, in seconds or with a unit; None where it was not given."""
    from mpsolve.proof.effort import Effort

    return None if given is None else Effort(seconds=seconds_of(given, "effort"))


@contextmanager
def in_parts(
    effort: str | None, store: Path | None, boxes: int | None, workers: int | None, dask: str | None
) -> Iterator[dict[str, Any]]:
    """The options of a proof: at once, or part by part in a store."""
    from mpsolve.proof.effort import Effort

    if store is None:
        for name, given in (("--boxes", boxes), ("--dask", dask)):
            if given is not None:
                raise InputError(name, "is given without --store: give the file that keeps what is proved")
        yield {"effort": effort_of(effort), "workers": 1 if workers is None else workers}
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


def seconds_of(given: str, key: str) -> float:
    """A time above 0 such as 5, "5 s" or "2 min", in seconds; InputError under `key`."""
    from mpsolve.numbers.units import in_unit

    seconds = in_unit(given, "s", key, "time")
    if not seconds > 0:
        raise InputError(key, f"is {given}: give a time above 0")
    return float(seconds)


def show(report: Document) -> None:
    """To a terminal in its width and with colour, unless NO_COLOR is set; else as plain text."""
    from mpsolve.report.blocks import WIDTH

    terminal, width = sys.stdout.isatty(), WIDTH
    if terminal:
        from shutil import get_terminal_size

        width = max(get_terminal_size().columns, _NARROW)
    colour = terminal and not os.environ.get("NO_COLOR")
    click.echo(report.text(width, colour), nl=False, color=colour)


@contextmanager
def progress() -> Iterator[Progress | None]:
    """A bar on stderr for the stage that is told; None where stderr is not a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bar

    columns = (TextColumn("{task.description:<10}"), BarColumn(), TimeElapsedColumn())
    with Bar(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=1.0)
        yield lambda stage, fraction: bar.update(task, description=stage, completed=fraction)
