"""Certificates: certs/SPEC2.md and certs/SPEC-ROOTS.md say what each key means.

A file that fits is well formed, no more: only a verifier tells whether it proves anything.
"""

from __future__ import annotations

from mpsolve.schemas import parts as p

_FORM = "mpsolve certificate"
_HASH: p.Schema = {"type": "string", "pattern": "^[0-9a-f]{64}$"}
_HEX: p.Schema = {"type": "string", "pattern": "^-?0x[0-9a-f]+$"}
_MATRIX = p.rows(p.rows(p.RATIONAL))
_POINT: p.Schema = {"type": "array", "items": p.one_of(p.WHOLE, p.RATIONAL)}


def certificate_schema() -> p.Schema:
    """Version 2, of any track and vehicles."""
    term: p.Schema = {"type": "array", "items": p.one_of(p.COUNT, p.RATIONAL)}
    track = p.table({"matrix": p.rows(p.rows(p.rows(term))), "loaded": p.COUNT})
    vehicle = p.table(
        {**dict.fromkeys("MCKB", _MATRIX), "places": p.rows(p.RATIONAL), "compliances": p.rows(p.RATIONAL)}
    )
    path = p.table({"kind": {"enum": ["link", "turn", "passive"]}, "points": p.rows(_POINT)})
    root = {
        "re": _HEX,
        "im": _HEX,
        "exponent": p.WHOLE,
        "radius": p.DYADIC,
        "multiplicity": p.POSITIVE,
        "pair": p.YES,
    }
    region = p.table(
        {"kind": {"enum": ["unstable", "below", "disc", "below disc", "rectangle", "sheet"]}},
        {
            "height": p.RATIONAL,
            "reach": p.RATIONAL,
            "radius": p.RATIONAL,
            "re": p.rows(p.RATIONAL),
            "im": p.rows(p.RATIONAL),
        },
    )
    keys: p.Schema = {
        "kind": {"const": "spectrum"},
        "equations": p.table({"track": track, "velocity": p.RATIONAL, "vehicle": vehicle}),
        "basis": p.maybe(p.table({"matrix": _MATRIX, "neutral": p.COUNT, "unfelt": p.COUNT})),
        "bits": {"type": "integer", "minimum": 53},
        "start": p.DYADIC,
        "paths": p.rows(path),
        "theorem": p.maybe({"type": "object"}),
        "claim": p.table({"region": region, "count": p.COUNT, "unstable": p.COUNT}),
        "roots": p.rows(p.table(root)),
        "sha256": _HASH,
    }
    return p.document("certificate", "Certificate of the frequencies of any problem", _FORM, 2, keys)


def ranges_certificate_schema() -> p.Schema:
    """Version 2, over ranges of parameters of any problem: crossings of one, stability over several, charts."""
    ball = p.table({"middle": _HEX, "exponent": p.WHOLE, "radius": p.DYADIC})
    zero = p.table({"room": p.rows(p.rows(p.DYADIC)), "q": ball, "x": ball})
    claim = p.one_of(
        p.table({"counts": p.rows(p.COUNT), "directions": p.rows(p.WHOLE)}),
        p.table({"unstable": p.COUNT}),
        p.table({"cells": p.rows(p.TEXT)}),
    )
    base = p.table({"at": p.rows(p.RATIONAL), "spectrum": {"type": "object"}})
    keys: p.Schema = {
        "kind": {"enum": ["crossings", "stable", "chart"]},
        "equations": {"type": "object"},
        "basis": p.maybe(p.table({"matrix": _MATRIX, "neutral": p.COUNT, "unfelt": p.COUNT})),
        "range": p.rows(p.rows(p.RATIONAL)),
        "base": p.one_of(base, p.rows(base)),
        "tail": {"type": "object"},
        "X": p.DYADIC,
        "beyond": p.rows(p.DYADIC),
        "tree": p.TEXT,
        "zeros": p.rows(zero),
        "claim": claim,
        "sha256": _HASH,
    }
    return p.document("ranges-certificate", "Certificate over ranges of parameters", _FORM, 2, keys)


def zeros_certificate_schema() -> p.Schema:
    """Of the zeros of a function in a region, or on an interval."""
    step: p.Schema = {"type": "array", "items": p.one_of(p.TEXT, p.WHOLE), "minItems": 1}
    places = {"type": "array", "items": p.COUNT, "minItems": 2}
    root = {"re": _HEX, "im": _HEX, "exponent": p.WHOLE, "radius": p.DYADIC, "multiplicity": p.COUNT}
    head: p.Schema = {
        "format": {"const": "mpsolve zeros"},
        "version": {"const": 1},
        "function": p.table({"steps": p.rows(step), "numerator": p.COUNT, "denominator": p.maybe(p.COUNT)}),
        "claim": {"type": "object"},
        "sha256": _HASH,
    }
    cut = p.table({"origin": p.rows(p.RATIONAL), "direction": p.rows(p.RATIONAL), "length": p.maybe(p.RATIONAL)})
    region: p.Schema = {
        "kind": {"const": "region"},
        "region": {"type": "object"},
        "counted": p.rows(p.rows(p.RATIONAL)),
        "cuts": p.rows(cut),
        "bits": {"type": "integer", "minimum": 53},
        "breaks": p.rows(p.table({"exponent": p.COUNT, "places": places})),
        "trees": p.rows(p.TEXT),
        "roots": p.rows(p.table(root)),
    }
    interval: p.Schema = {"kind": {"const": "interval"}, "interval": p.rows(p.RATIONAL), "tiles": p.rows({})}
    kinds = {"oneOf": [p.table(head | region), p.table(head | interval)]}
    return p.head("zeros-certificate", "Certificate of the zeros of a function") | kinds
