"""All schemas by name."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from mpsolve.errors import InputError
from mpsolve.schemas import certificates, motions, studies
from mpsolve.schemas.certify import certify_schema
from mpsolve.schemas.input import input_schema
from mpsolve.schemas.parts import Schema
from mpsolve.schemas.ranges import (
    OF_LIBRARY,
    QUESTIONS,
    library_schema,
    ranges_schema,
    table_file_schema,
    table_schema,
)

CATALOGUE: dict[str, tuple[str, Callable[[], Schema]]] = {
    "input": ("input files of a problem", input_schema),
    "study-file": ("files of mpsolve study", studies.study_file_schema),
    "table-file": ("files of mpsolve table", table_file_schema),
    "certify": ("mpsolve certify --json", certify_schema),
    **{
        name: (f"the answer about {name.replace('_', ' ')}, --json or -o FILE.json", partial(ranges_schema, name))
        for name in QUESTIONS
    },
    **{name: (f"{name}(…).to_json() of the library", partial(library_schema, name)) for name in OF_LIBRARY},
    "table": ("mpsolve table -o FILE.json", table_schema),
    "train": ("mpsolve train --json", motions.train_schema),
    "critical": ("mpsolve critical --json", motions.critical_schema),
    "receptance": ("mpsolve receptance --json", motions.receptance_schema),
    "response": ("mpsolve response -o FILE.json", motions.response_schema),
    "study": ("mpsolve export --to json", studies.study_schema),
    "status": ("mpsolve status --json", studies.status_schema),
    "seeds": ("seeds(…).save of the library", studies.seeds_schema),
    "page": ("the numbers in a page of mpsolve report", motions.page_schema),
    "roots": ("mpsolve roots --json", motions.roots_schema),
    "audit": ("mpsolve audit --json", motions.audit_schema),
    "certificate": ("certificates of any problem", certificates.certificate_schema),
    "ranges-certificate": ("certificates over ranges of parameters", certificates.ranges_certificate_schema),
    "zeros-certificate": ("certificates of mpsolve roots", certificates.zeros_certificate_schema),
}


def schema_of(name: str) -> Schema:
    """The schema of that name; InputError lists the names."""
    if name not in CATALOGUE:
        raise InputError("name", f"is {name[:40]!r}, which is unknown: there are {', '.join(CATALOGUE)}")
    return CATALOGUE[name][1]()


def listing() -> str:
    """Names and what each is of."""
    wide = max(map(len, CATALOGUE)) + 2
    return "".join(f"{name.ljust(wide)}{told}\n" for name, (told, _) in CATALOGUE.items())
