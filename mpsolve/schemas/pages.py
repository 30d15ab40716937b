"""The numbers in a page of `report`, and the verdicts of `audit`."""

from __future__ import annotations

from mpsolve.report.schema import certify_schema
from mpsolve.schemas import parts as p


def page_schema() -> p.Schema:
    """Of the element `data` of a page."""
    certify = certify_schema()
    definitions = certify.pop("$defs")
    spectrum = {key: value for key, value in certify.items() if not key.startswith("$")}
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
