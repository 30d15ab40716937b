"""A paper from its folder or module, the same in every process; and its audit: every claim checked."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from zlib import crc32

from mpsolve.claims.claim import Claim, Finding, Paper, Verdict
from mpsolve.claims.report import Report, collected
from mpsolve.errors import InputError, MpsolveError
from mpsolve.parallel.pool import run
from mpsolve.progress import Progress

_FILES = ("__init__.py", "paper.py")
_EXAMPLE = "for example examples/paper of the sources of mpsolve"


def load(where: str | Path) -> Paper:
    """The PAPER of a folder with __init__.py or paper.py, of such a file, or of a module by its dotted name.

    Files of the folder import each other by `from .name import …`. What is loaded runs: it is a program. InputError
    if it is not there, cannot be imported, or exports no PAPER.
    """
    path = Path(where)
    return _loaded(str(path.resolve()) if path.exists() else str(where))


@cache
def _loaded(where: str) -> Paper:
    module = _by_path(Path(where)) if Path(where).is_absolute() else _by_name(where)
    paper = getattr(module, "PAPER", None)
    if not isinstance(paper, Paper):
        raise InputError("paper", f"{where} exports no paper: let it say PAPER = Paper(title, citation, claims)")
    return replace(paper, where=where)


def _by_name(name: str) -> ModuleType:
    nothing = InputError("paper", f"{name} is neither a folder nor a module: give the folder of a paper, {_EXAMPLE}")
    if not all(part.isidentifier() for part in name.split(".")):
        raise nothing
    with _told(name):
        try:
            return import_module(name)
        except ModuleNotFoundError as error:
            if error.name is not None and f"{name}.".startswith(f"{error.name}."):
                raise nothing from None
            raise  # the module is there, one that it imports is not


def _by_path(path: Path) -> ModuleType:
    """The file as a package of its own name, made from its path; its folder is where its parts are found."""
    file = path if path.is_file() else next((path / name for name in _FILES if (path / name).is_file()), None)
    if file is None:
        what = f"holds neither {' nor '.join(_FILES)}" if path.is_dir() else "is not there"
        raise InputError("paper", f"{path} {what}: give the folder of a paper, {_EXAMPLE}")
    name = f"{re.sub(r'[^0-9A-Za-z]', '_', file.parent.name)}_{crc32(str(file).encode()):08x}"
    spec = spec_from_file_location(name, file, submodule_search_locations=[str(file.parent)])
    if spec is None or spec.loader is None:
        raise InputError("paper", f"{file} is no Python file: give the folder of a paper, {_EXAMPLE}")
    module = sys.modules[name] = module_from_spec(spec)
    try:
        with _told(str(file)):
            spec.loader.exec_module(module)
    except BaseException:
        for part in [one for one in sys.modules if one == name or one.startswith(f"{name}.")]:
            del sys.modules[part]
        raise
    return module


@contextmanager
def _told(what: str) -> Iterator[None]:
    """What goes wrong in somebody's own file, as one sentence."""
    try:
        yield
    except MpsolveError:
        raise
    except Exception as error:
        raise InputError("paper", f"{what} cannot be imported ({type(error).__name__}: {error}): mend it") from error


def audit(paper: Paper, only: Sequence[str] = (), workers: int | None = None, tell: Progress | None = None) -> Report:
    """The findings of the claims that `only` names (all by default), the same for any number of workers.

    A paper that was loaded from its folder is loaded anew in each process; the checks of another must be functions of
    a module. InputError, MpsolveError as `pool.run`.
    """
    claims = paper.chosen(only)
    order = sorted(claims, key=lambda claim: _rank(paper, claim))
    if paper.where:
        jobs = [(paper.where, claim.id) for claim in order]
        findings = run(_checked_there, jobs, workers, tell, "checking")
    else:
        findings = run(checked, order, workers, tell, "checking")
    found = {claim.id: finding for claim, finding in zip(order, findings, strict=True)}
    return collected(paper, [(claim, found[claim.id]) for claim in claims])


def _rank(paper: Paper, claim: Claim) -> int:
    return paper.slow.index(claim.id) if claim.id in paper.slow else len(paper.slow)


def _checked_there(job: tuple[str, str]) -> Finding:
    """The finding of a claim by the place of its paper and its name, which travel between processes."""
    where, name = job
    return checked(load(where).claim(name))


def checked(claim: Claim) -> Finding:
    """The finding; a check that comes to no end is a finding too, with its reason."""
    try:
        return claim.check(claim)
    except MpsolveError as error:
        return Finding(Verdict.UNDECIDABLE, f"The check came to no end: {error}", stopped=True)
