"""The command `schema`: JSON Schemas of what the program reads and prints."""

from __future__ import annotations

import click

from mpsolve.cli_tools import command, echo_json


@command()
@click.argument("name", required=False)
def schema(name: str | None) -> None:
    """Print the JSON Schema (draft 2020-12) with NAME; without NAME list them: of files, answers, certificates.

    Exit status 0: printed. 2: there is no such schema. Editors that know TOML check a file against it after the line
    "#:schema ./mpsolve.schema.json".
    """
    from mpsolve.schemas.catalogue import listing, schema_of

    if name is None:
        click.echo(listing(), nl=False)
    else:
        echo_json(schema_of(name))
