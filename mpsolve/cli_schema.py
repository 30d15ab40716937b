"""The command `schema`: JSON Schemas of what the program reads and prints."""

from __future__ import annotations

import click

from mpsolve.cli_tools import one_sentence


@click.command()
@click.argument("what", type=click.Choice(["input", "certify"]))
def schema(what: str) -> None:
    """Print a JSON Schema (draft 2020-12): of input files, or of what certify --json prints.

    Exit status 0: printed. Editors that know TOML check a file against it after the line
    "#:schema ./mpsolve.schema.json".
    """
    with one_sentence():
        import json

        from mpsolve.problem.schema import input_schema
        from mpsolve.report.schema import certify_schema

        made = input_schema() if what == "input" else certify_schema()
        click.echo(json.dumps(made, indent=1, ensure_ascii=False))


COMMANDS = (schema,)
