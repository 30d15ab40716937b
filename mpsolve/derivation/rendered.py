"""Steps of a derivation as text, or as a LaTeX document."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Sequence

import sympy as sp

from mpsolve.derivation.step import Expr, Step
from mpsolve.errors import InputError


def _statements(step: Step) -> tuple[Expr, ...]:
    return step.statement if isinstance(step.statement, tuple) else (step.statement,)


def _pieces(expression: Expr, write: Callable[[Expr], str], size: Callable[[str], int], limit: int) -> list[str]:
    """A sum written in pieces of consecutive terms, each piece within `limit` where a single term is."""
    pieces: list[list[Expr]] = []
    terms = expression.as_ordered_terms() if isinstance(expression, sp.Add) else [expression]
    for term in terms:
        if pieces and size(write(sp.Add(*pieces[-1], term))) <= limit:
            pieces[-1].append(term)
        else:
            pieces.append([term])
    return [write(sp.Add(*piece)) if len(piece) > 1 else write(piece[0]) for piece in pieces]


def _width(block: str) -> int:
    return max(map(len, block.splitlines()))


def _pretty(equation: Expr, width: int = 110) -> str:
    """The equation; if wider than `width`, in several blocks."""

    def write(expression: Expr) -> str:
        return str(sp.pretty(expression, use_unicode=True, wrap_line=False))

    if _width(write(equation)) <= width:
        return write(equation)
    left, right = (_pieces(side, write, _width, width) for side in equation.args)
    sides = ("\n\n  +\n".join(textwrap.indent(block, "  ") for block in side) for side in (left, right))
    return "\n\n  =\n".join(sides)


def _text(step: Step) -> str:
    body = "\n\n".join(_pretty(equation) for equation in _statements(step))
    head = f"{step.number} {step.title}"
    return f"{head}\n{'-' * len(head)}\n{textwrap.fill(step.note, 100)}\n\n{body}\n"


def _latex_lines(equation: Expr, limit: int = 400) -> str:
    """The rows of an align environment, each at most about `limit` characters of source where a term is."""
    left, right = (_pieces(side, sp.latex, len, limit) for side in equation.args)
    rows = [f"&{left[0]}", *(f"&\\quad + {piece}" for piece in left[1:])]
    if len(left) == 1:
        rows = [f"{left[0]} &= {right[0]}"]
    else:
        rows.append(f"&= {right[0]}")
    return " \\\\\n".join(rows + [f"&\\quad + {piece}" for piece in right[1:]])


def _latex(step: Step) -> str:
    escaped = step.note
    for old, new in (("_", r"\_"), ("^", r"\^{}"), ("{", r"\{"), ("}", r"\}")):
        escaped = escaped.replace(old, new)
    rows = " \\\\\n".join(_latex_lines(equation) for equation in _statements(step))
    body = f"\\begin{{align*}}\n\\tag*{{{step.number}}}\n{rows}\n\\end{{align*}}\n"
    return f"\\paragraph{{{step.title}.}} {escaped}\n{body}"


def render(steps: Sequence[Step], style: str = "text") -> str:
    """The steps as text, or as a complete LaTeX document (style "latex")."""
    if style == "text":
        return "\n".join(_text(step) for step in steps)
    if style == "latex":
        packages = ("[T1]{fontenc}", "[landscape,a3paper,margin=15mm]{geometry}", "{amsmath}")
        preamble = "".join(f"\\usepackage{package}\n" for package in packages)
        head = f"\\documentclass{{article}}\n{preamble}\\allowdisplaybreaks\n\\begin{{document}}\n"
        return head + "\n".join(_latex(step) for step in steps) + "\\end{document}\n"
    raise InputError("style", f'{style!r} given; use "text" or "latex"')
