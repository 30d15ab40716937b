"""Expressions as a user gives them, a text or sympy's, as exact steps: decimals are read as they are written."""

from __future__ import annotations

import ast
from fractions import Fraction
from typing import Any

from mpsolve.errors import InputError
from mpsolve.zeros.program import NAMES, Program

_BINARY = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div", ast.Pow: "power"}
_SYNONYMS = {"ln": "log", "besselj": "bessel_j", "airyai": "airy_ai", "airybi": "airy_bi", "Abs": "abs"}
_MOST = 100_000
_LONGEST, _EXPONENT = 300, 2
REMEDY = f"the functions are {', '.join(NAMES)}"


def parse(program: Program, text: str) -> int:
    """The step of a text like "sin(z) - z/2": z, numbers, pi, e, i, + − * / ** ^ and the functions of NAMES."""
    if len(text) > _MOST:
        raise InputError("f", f"has {len(text)} characters: an expression has up to {_MOST}")
    source = text.strip().replace("^", "**")
    try:
        return _read(program, ast.parse(source, mode="eval").body, source)
    except (SyntaxError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError("f", f"is {text[:60]!r}, which cannot be read: write it like sin(z) - z/2") from None
    except (RecursionError, MemoryError):
        raise InputError("f", "is nested too deeply: give a shorter expression") from None


def _read(program: Program, node: ast.expr, source: str) -> int:
    if isinstance(node, ast.Constant) and type(node.value) in (int, float, complex):
        written = str(ast.get_source_segment(source, node)).replace("_", "")
        return _number(program, written)
    if isinstance(node, ast.Name):
        return _named(program, node.id)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
        inner = _read(program, node.operand, source)
        return program.neg(inner) if isinstance(node.op, ast.USub) else inner
    if isinstance(node, ast.BinOp) and type(node.op) in _BINARY:
        left, right = _read(program, node.left, source), _read(program, node.right, source)
        return int(getattr(program, _BINARY[type(node.op)])(left, right))
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        return _call(program, node.func.id, node.args, source)
    raise InputError("f", f"has {ast.unparse(node)[:60]!r}, which is no expression in z: {REMEDY}")


def _number(program: Program, written: str) -> int:
    imaginary = written[-1:] in "jJ"
    _, _, exponent = written.rstrip("jJ").lower().partition("e")
    if len(written) > _LONGEST or len(exponent.lstrip("+-0")) > _EXPONENT:
        raise InputError(
            "f", f"has the number {written[:40]}: numbers have up to {_LONGEST} digits, exponents {_EXPONENT}"
        )
    x = program.number(Fraction(written.rstrip("jJ")))
    return program.mul(x, program.i) if imaginary else x


def _named(program: Program, name: str) -> int:
    if name in ("z", "pi"):
        return program.step(name)
    if name in ("i", "I", "j"):
        return program.i
    if name in ("e", "E"):
        return program.call("exp", program.number(1))
    raise InputError("f", f"has the name {name[:60]!r}: the variable is z, the constants are pi, e and i")


def _call(program: Program, name: str, arguments: list[ast.expr], source: str) -> int:
    name = _SYNONYMS.get(name, name)
    if name == "bessel_j" and len(arguments) == 2:
        order = program.rational(_read(program, arguments[0], source))
        whole = int(order) if order is not None and order.denominator == 1 else None
        return program.call(name, _read(program, arguments[1], source), whole)
    if len(arguments) != 1:
        raise InputError("f", f"has {name}() with {len(arguments)} arguments: {REMEDY}")
    return program.call(name, _read(program, arguments[0], source))


def from_sympy(program: Program, expression: Any) -> int:
    """The step of sympy's expression in one symbol."""
    import sympy

    try:
        return _from_sympy(program, sympy, expression)
    except (AttributeError, TypeError):
        raise InputError("f", f"has a part that is no analytic function: {REMEDY}") from None


def _from_sympy(program: Program, sympy: Any, expression: Any) -> int:
    free = sorted(expression.free_symbols, key=str)
    if len(free) > 1:
        raise InputError("f", f"has the symbols {', '.join(map(str, free))}: give numbers for all but one")
    found: dict[Any, int] = {}
    for node in sympy.postorder_traversal(expression):
        if node not in found:
            found[node] = _of_sympy(program, sympy, node, [found[one] for one in node.args])
    return found[expression]


def _of_sympy(program: Program, sympy: Any, node: Any, parts: list[int]) -> int:
    constants = {sympy.I: program.i, sympy.pi: program.step("pi")}
    if node in constants:
        return constants[node]
    if node == sympy.E:
        return program.call("exp", program.number(1))
    if node.is_Symbol:
        return program.z
    if node.is_Rational:
        return program.number(Fraction(int(node.p), int(node.q)))
    if node.is_Float:
        return program.number(Fraction(*map(int, sympy.Rational(node).as_numer_denom())))
    if node.is_Add or node.is_Mul:
        out = parts[0]
        for part in parts[1:]:
            out = program.add(out, part) if node.is_Add else program.mul(out, part)
        return out
    if node.is_Pow:
        return program.power(*parts)
    name = _SYNONYMS.get(type(node).__name__, type(node).__name__)
    if name == "bessel_j":
        order = program.rational(parts[0])
        return program.call(name, parts[1], None if order is None or order.denominator != 1 else int(order))
    if len(parts) != 1:
        raise InputError("f", f"has {str(node)[:60]}, which is not known: {REMEDY}")
    return program.call(name, parts[0])
