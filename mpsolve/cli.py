"""The command `mpsolve`: verify, derive, models; the other commands are in the modules cli_*.py.

Exit status: 0 if what was asked for is proved (an unstable case too) or valid; 1 if it is undecided or
invalid, or if the certificate could not be written; 2 for input that cannot be used. Standard output carries
the report only; progress and errors go to standard error, progress only if that is a terminal.
"""

from __future__ import annotations

import errno
import gc
import io
import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import Any

import click

from mpsolve.cli_tools import PATH, Commands
from mpsolve.cli_voice import as_told


def _show_version(context: click.Context, _option: click.Parameter, asked: bool) -> None:
    if asked and not context.resilient_parsing:
        from mpsolve import __version__

        click.echo(f"mpsolve {__version__}")
        context.exit()


COMMANDS = {
    "new": ("inputs", 'mpsolve new ballasted --vehicle shinkansen --v "300 km/h" -o mine.toml'),
    "work-out": ("inputs", 'mpsolve work-out per-metre --k "180 kN/mm" --spacing "0.6 m"'),
    "certify": ("certify", "mpsolve certify mine.toml --region unstable"),
    "report": ("page", "mpsolve report rail.toml -o rail.html"),
    "explore": ("page", "mpsolve explore mine.toml"),
    "onset": ("ranges", "mpsolve onset rail.toml --over v=0..400km/h"),
    "crossings": ("ranges", "mpsolve crossings rail.toml --over scale.mass=0.1..3"),
    "lines": ("ranges", "mpsolve lines rail.toml --over v=0..400km/h -o lines.svg"),
    "worst": ("ranges", "mpsolve worst pair.toml --over gap[0]=1m..5m"),
    "robust": ("ranges", "mpsolve robust rail.toml --over v=0..150km/h --over track.k=0.8e6..1.2e6"),
    "chart": ("ranges", "mpsolve chart rail.toml --over v=100..300 --over scale.mass=0.5..2 -o chart.svg"),
    "table": ("study", "mpsolve table onsets.toml -o onsets.csv"),
    "train": ("track", "mpsolve train mine.toml --spacing 25"),
    "response": ("response", "mpsolve response pair.toml -o motion.csv --to 50"),
    "compare": ("response", "mpsolve compare pair.toml -o compare.svg --to 50"),
    "critical": ("track", "mpsolve critical mine.toml -o critical.svg"),
    "receptance": ("track", "mpsolve receptance mine.toml --omega 1,600,100 --xi=-1.5,0,1.5 -o receptance.csv"),
    "study": ("study", "mpsolve study study.toml -o study.sqlite"),
    "status": ("study", "mpsolve status study.sqlite"),
    "export": ("study", "mpsolve export study.sqlite --to csv"),
    "roots": ("roots", 'mpsolve roots "sin(z) - z/2" --rectangle -10 10 -5 5'),
    "schema": ("inputs", "mpsolve schema input > mpsolve.schema.json"),
    "audit": ("audit", "mpsolve audit examples/paper --only xii"),
    "verify": ("", "mpsolve verify mine.certificate.json"),
    "derive": ("", "mpsolve derive mine.toml"),
    "models": ("", "mpsolve models two-layer"),
}
"""Of each command the module cli_… that holds it, loaded when it is asked for ("": this one), and an example."""
EXAMPLES = {name: example for name, (_, example) in COMMANDS.items()}


class _Commands(Commands):
    """The commands of the table."""

    def make_context(self, *args: Any, **kwargs: Any) -> click.Context:
        with as_told(None, EXAMPLES, []):
            return super().make_context(*args, **kwargs)

    def invoke(self, ctx: click.Context) -> Any:
        with as_told(ctx, EXAMPLES, self.list_commands(ctx)):
            return super().invoke(ctx)

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [*(name for name, (module, _) in COMMANDS.items() if module), *super().list_commands(ctx)]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        module, example = COMMANDS.get(cmd_name, ("", ""))
        command = super().get_command(ctx, cmd_name)
        if module:
            command = getattr(import_module(f"mpsolve.cli_{module}"), cmd_name.replace("-", "_"))
        if command is not None:
            command.epilog = f"\b\nExample:\n  {example}"
        return command


@click.group(cls=_Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--version", is_flag=True, is_eager=True, expose_value=False, callback=_show_version, help="Show the version."
)
def cli() -> None:
    """Certified stability analysis of vehicles that move along rails and other tracks."""


@cli.command()
@click.argument("files", nargs=-1, required=True, metavar="FILE...", type=PATH)
def verify(files: tuple[Path, ...]) -> None:
    """Check certificates, by verifiers that share no code with what proved them: a line for each FILE.

    Where a certificate carries its equations, those that were verified follow, indented.

    Exit status 0: all are valid. 1: one is not, or cannot be read.
    """
    from mpsolve.certificate.check import verify as check
    from mpsolve.certificate.check import verify_bytes

    valid = True
    for file in files:
        result = verify_bytes(sys.stdin.buffer.read()) if str(file) == "-" else check(file)
        valid = valid and result.valid
        verdict = f"valid: {file}: {result.claim}" if result.valid else f"invalid: {file}: {result.reason}"
        click.echo("\n  ".join(verdict.splitlines()))
    sys.exit(0 if valid else 1)


@cli.command()
@click.argument("file", required=False, type=PATH)
@click.option("--latex", is_flag=True, help="A LaTeX document instead of text.")
@click.option("--masses", type=int, default=2, show_default=True, help="Number of moving masses, without a problem.")
def derive(file: Path | None, latex: bool, masses: int) -> None:
    """Derive the model symbolically, from the equations of motion on, and print every step.

    With FILE (TOML): the track and the vehicles in it, from their mechanics to the matrices that are computed with.
    Without: the same of masses on a beam. With the folder of a paper, as examples/paper: its equations by their
    numbers. Exit status 0: printed. 2: the input cannot be used.
    """
    from mpsolve.claims.load import load
    from mpsolve.derivation.problem import derivation_of, derivation_of_masses
    from mpsolve.derivation.rendered import render
    from mpsolve.problem.inputfile import read_problem

    steps: Sequence[Any]
    if file is None:
        steps = derivation_of_masses(masses)
    elif file.is_dir():
        steps = load(file).derived(masses)
    else:
        steps = derivation_of(read_problem(file).problem)
    click.echo(render(steps, "latex" if latex else "text"), nl=False)


@cli.command()
@click.argument("name", required=False)
def models(name: str | None) -> None:
    """Show every track and vehicle, or the one with NAME: drawing, parameters, units, meaning.

    Exit status 0: shown. 2: there is no such model.
    """
    from mpsolve.report.models import listing

    click.echo(listing(name), nl=False)


_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EBADF)  # of a stream that takes no more

_UNCOLLECTED = 100_000  # objects that are made before a look for circles among them: what is loaded has none to free


def main() -> None:
    """Run the command with standard output and error in UTF-8, whatever the locale says."""
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:  # it was closed by who runs this
            setattr(sys, name, Path(os.devnull).open(mode, encoding="utf-8"))  # noqa: SIM115  as long as all runs
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="replace" if os.name == "nt" else "strict")
    gc.set_threshold(_UNCOLLECTED)
    try:
        cli(prog_name="mpsolve")
    except OSError as error:  # a closed pipe is click's affair; a full disk behind it is told here
        if error.filename is not None or error.errno not in _FULL:
            raise
        with suppress(OSError):  # what is buffered still cannot be written: let the interpreter end in silence
            sys.stdout.flush()
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        told = f"standard output cannot be written ({error.strerror}): make room, or send it elsewhere"
        print(f"mpsolve: {told}", file=sys.stderr)
        sys.exit(1)
    finally:
        gc.freeze()  # the interpreter ends without looking through all that was loaded: 5 % of a short command
