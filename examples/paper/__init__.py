"""What one paper prints of two moving proximate masses, claim by claim, for `mpsolve audit examples/paper`.

The numbers of a claim stand in the `*_list` modules and at the end of the others, beside the functions that check
them; its words in `quotes`. `certs/paper` holds the certificates of all verdicts.
"""

from __future__ import annotations

from mpsolve.claims import Paper
from mpsolve.derivation.step import Step

from . import (
    captions,
    damped_list,
    equation_list,
    figure_9,
    figure_list,
    history,
    instability,
    modal,
    motion_list,
    onset_list,
    premises,
    superposition,
    undamped_list,
)
from .quotes import QUOTES

NOTATION = (
    "Equations are written as code: d(f, x, 2) is f with two derivatives by x, delta Dirac's or Kronecker's, x_2 the "
    "dimensionless distance d̂, P the constant P_C1 as a scale, F_1 and F_2 those of (22); u_k, u1_k, u2_k are "
    "w_k, w_k,x, w_k,xx at the rear mass (vt), v_k, v1_k, v2_k (v3_k: w_k,xxx) the same at the front mass (vt + "
    "d), q0, q1, q2 are q_k, q_k,t, q_k,tt; D_pp is D_,pp, and h_pp, h_ppp are derivatives of h = D²."
)
_LISTS = (
    undamped_list, damped_list, figure_9, instability, onset_list, motion_list, superposition, history, captions,
    figure_list, premises, equation_list, modal,
)  # fmt: skip


def _derivation(masses: int) -> tuple[Step, ...]:
    from .derivation import derivation  # sympy is loaded when it is needed

    return derivation(masses)


PAPER = Paper(
    "Two moving proximate masses on a beam on a Pasternak viscoelastic foundation",
    "Dimitrovová, two moving proximate masses on a beam on a Pasternak viscoelastic foundation",
    [claim for one in _LISTS for claim in one.CLAIMS],
    QUOTES,
    NOTATION,
    derivation=_derivation,
    slow=("i", "xi-smooth-high", "xi-smooth-low", "iii", "fig-12-text", "xi"),
)
