"""The motion in time: steady, unsteady harmonic and truly transient parts, (20)–(36)."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mpsolve.motion.beam import BeamError, BeamResponse, finite_beam
    from mpsolve.motion.newmark import coupled_beam
    from mpsolve.motion.solution import HarmonicPair, HarmonicSolution, Response
    from mpsolve.motion.solve import harmonic_solution, response
    from mpsolve.motion.study import (
        Envelope,
        Importance,
        deflection_shape,
        envelope,
        merged,
        superposition,
        transient_importance,
    )

__all__ = [
    "response",
    "Response",
    "harmonic_solution",
    "HarmonicSolution",
    "HarmonicPair",
    "envelope",
    "Envelope",
    "superposition",
    "merged",
    "transient_importance",
    "Importance",
    "deflection_shape",
    "finite_beam",
    "BeamResponse",
    "BeamError",
    "coupled_beam",
]

_HOME = {
    **dict.fromkeys(("response", "harmonic_solution"), "solve"),
    **dict.fromkeys(("Response", "HarmonicSolution", "HarmonicPair"), "solution"),
    **dict.fromkeys(__all__[5:12], "study"),
    **dict.fromkeys(__all__[12:15], "beam"),
    "coupled_beam": "newmark",
}


def __getattr__(name: str) -> Any:
    """Public names load on first use."""
    if name not in _HOME:
        raise AttributeError(f"module 'mpsolve.motion' has no attribute {name!r}")
    return getattr(import_module(f"mpsolve.motion.{_HOME[name]}"), name)
