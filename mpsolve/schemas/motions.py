"""What goes to solvers: the motion, receptances, critical velocities, endless trains, zeros, numbers of a page."""

from __future__ import annotations

from mpsolve.schemas import parts as p
from mpsolve.schemas.certify import spectrum_parts


def response_schema() -> p.Schema:
    """Of `mpsolve response -o FILE.json`."""
    column = {"name": p.TEXT, "unit": p.TEXT, "values": p.rows(p.REAL)}
    keys: p.Schema = {"title": p.TEXT, "columns": p.rows(p.table(column)), "said": p.rows(p.TEXT)}
    return p.document("response", "Motion of mpsolve response", "mpsolve response", 1, keys)


def receptance_schema() -> p.Schema:
    """Of `mpsolve receptance --json`."""
    table = p.rows(p.rows(p.REAL))
    keys: p.Schema = {
        "title": p.TEXT,
        "meaning": p.TEXT,
        "track": p.by_name(p.TEXT),
        "v": p.TEXT,
        "xi": p.rows(p.REAL),
        "omega": p.rows(p.REAL),
        "G_re": table,
        "G_im": table,
    }
    matrices = p.rows(table)
    contacts = {"places": p.rows(p.REAL), **dict.fromkeys(("G_re", "G_im", "K_re", "K_im"), matrices)}
    optional = {"contacts": p.table(contacts)}
    return p.document("receptance", "Table of mpsolve receptance", "mpsolve receptance", 2, keys, optional)


def critical_schema() -> p.Schema:
    """Of `mpsolve critical --json`."""
    one = {"v": p.TEXT, "exact": p.maybe(p.TEXT), "wavenumber": p.maybe(p.TEXT), "kind": p.TEXT, "name": p.TEXT}
    keys: p.Schema = {
        "omega": p.TEXT,
        "range": p.rows(p.TEXT),
        "status": p.STATUS,
        "sentence": p.TEXT,
        "always": p.rows(p.TEXT),
        "undecided": p.rows(p.TEXT),
        "velocities": p.rows(p.table(one)),
    }
    return p.document("critical", "Answer of mpsolve critical", "mpsolve critical velocities", 1, keys)


def train_schema() -> p.Schema:
    """Of `mpsolve train --json`."""
    gain = p.table({"factor": p.REAL, "frequency": p.REAL})
    peak = p.maybe(p.table({"low": p.REAL, "high": p.REAL, "frequency": p.REAL}))
    train = {
        "count": p.COUNT,
        "status": p.STATUS,
        "stable": p.maybe(p.YES),
        "band": p.rows(p.TEXT),
        "ahead": peak,
        "back": peak,
        "reason": p.maybe(p.REASON),
    }
    computed = {"ahead": gain, "back": gain, "separation": p.maybe(p.REAL), "long_trains_grow": p.maybe(p.YES)}
    keys: p.Schema = {
        "title": p.TEXT,
        "velocity": p.TEXT,
        "spacing": p.TEXT,
        "status": p.STATUS,
        "stable": p.maybe(p.YES),
        "words": p.TEXT,
        "motion": p.maybe(p.table({"q": p.TEXT, "kappa_d": p.REAL})),
        "computed": p.table(computed),
        "reason": p.maybe(p.REASON),
    }
    return p.document("train", "Answer of mpsolve train", "mpsolve train", 1, keys, {"train": p.table(train)})


def roots_schema() -> p.Schema:
    """Of `mpsolve roots --json`."""
    keys: p.Schema = {
        "function": p.TEXT,
        "region": p.TEXT,
        "status": p.STATUS,
        "count": p.maybe(p.COUNT),
        "zeros": p.rows(p.table({"z": p.TEXT, "multiplicity": p.COUNT, "real": p.YES})),
        "reason": p.maybe(p.REASON),
        "note": p.TEXT,
        "assumed": p.rows(p.TEXT),
        "digits": p.DIGITS,
    }
    return p.document("roots", "Answer of mpsolve roots", "mpsolve roots", 1, keys)


def page_schema() -> p.Schema:
    """Of the element `data` of a page."""
    definitions, spectrum = spectrum_parts()
    status = {"enum": ["proved", "computed", "open"]}
    card = {"question": p.TEXT, "figure": p.TEXT, "sentence": p.TEXT, "status": status}
    limit = {"name": p.TEXT, "own": p.TEXT, "limit": p.TEXT, "spare": p.TEXT, "status": status}
    keys: p.Schema = {
        "spectrum": spectrum,
        "cards": p.rows(p.table(card)),
        "limits": p.rows(p.table(limit)),
        "late": p.rows(p.TEXT),
    }
    return p.document("page", "Numbers in a page of mpsolve report", "mpsolve page", 1, keys) | {"$defs": definitions}


def audit_schema() -> p.Schema:
    """Of `mpsolve audit --json`."""
    texts = p.by_name(p.rows(p.TEXT))
    claim = {
        "id": p.TEXT,
        "place": p.TEXT,
        "claim": p.TEXT,
        "tried": p.TEXT,
        "printed": texts,
        "looked at": texts,
        "verdict": p.TEXT,
        "sentence": p.TEXT,
        "numbers": p.rows(p.table({"what": p.TEXT, "value": p.TEXT})),
        "proof": p.rows(p.TEXT),
        "search": p.rows(p.TEXT),
        "certificates": p.rows(p.TEXT),
        "no certificate": p.TEXT,
    }
    keys: p.Schema = {
        "title": p.TEXT,
        "paper": p.TEXT,
        "notation": p.TEXT,
        "summary": p.by_name(p.COUNT),
        "complete": p.YES,
        "claims": p.rows(p.table(claim)),
    }
    return p.document("audit", "Verdicts of mpsolve audit", "mpsolve audit", 1, keys)
