"""The certificates under certs/roots/: zeros of functions, each proved anew by `python examples/zeros.py`."""

from __future__ import annotations

from pathlib import Path

from mpsolve import Cut, Polygon, Rectangle, real_roots, roots
from mpsolve.zeros.answer import Zeros

FOLDER = Path(__file__).resolve().parents[1] / "certs" / "roots"

COMBUSTION = "z**2 - 0.19435*z + 1000.41*exp(-0.005*z) + 522463"  # 24 zeros, of an annular combustion chamber


def prove(name: str) -> Zeros:
    """The zeros of one of the cases."""
    if name == "tangent":
        return real_roots("tan(z) - z", 1, 20, digits=30)
    if name == "sine":
        return roots("sin(z) - z/2", Rectangle(-10, 10, -5, 5), digits=50)
    if name == "combustion":
        return roots(COMBUSTION, Rectangle(-15000, 5000, -15000, 15000))
    if name == "multiple":
        return roots("(z - 1)**3*(z**2 + 4)*sin(z)", Polygon([-4 - 3j, 4 - 3j, 3 + 3j, -3 + 3j]))
    if name == "slanting_cut":
        return roots("sqrt((4*i - 3)*z) - 1 - z", Rectangle(-3, 3, -2, 2), cuts=[Cut.ray(0, (3, 4))])
    raise KeyError(name)


CASES = ("sine", "combustion", "multiple", "slanting_cut", "tangent")


def main() -> None:
    """Writes every certificate."""
    FOLDER.mkdir(exist_ok=True)
    for name in CASES:
        answer = prove(name)
        if not answer.proved:
            raise SystemExit(f"{name}: {answer.reason}")
        answer.certificate.save(FOLDER / f"{name}.json")
        print(f"{name}: {answer.count} zeros")


if __name__ == "__main__":
    main()
