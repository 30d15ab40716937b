"""What `certificate/test_broken_provers.py` breaks: problems, and formulas of the prover in a false form."""

from __future__ import annotations

from typing import NamedTuple

from mpsolve import Problem
from mpsolve.tracks import EulerBernoulli, String, TwoLayer
from mpsolve.vehicles import Mass, Vehicle

BEAM = EulerBernoulli(EI="1/4", m=1, k=1, c="1/10")
ZERO = [[0, 0], [0, 0]]
PROBLEMS = {
    "pair": (Problem(BEAM, [Mass(40).at(0), Mass(40).at("3/2")], v="13/10"), "unstable"),
    "wire": (Problem(String(T=27_000, m="1.07", k=500, c=2), [Mass("8.5")], v=100), ("below", "0.9")),
    "joined": (
        Problem(
            EulerBernoulli(EI="1/4", m=1, k=1, c=1),
            [Vehicle(M=[[10, 0], [0, 10]], C=ZERO, K=[[10, -10], [-10, 10]], B=[[1, 0], [0, 1]], places=[0, "3/2"])],
            v="13/10",
        ),
        "unstable",
    ),
    "sprung": (
        Problem(
            BEAM,
            [
                Vehicle(
                    M=[[40, 0], [0, 20]],
                    C=[[1, -1], [-1, 1]],
                    K=[[10, -10], [-10, 10]],
                    B=[[1], [0]],
                    places=[0],
                    k_contact=2,
                )
            ],
            v="13/10",
        ),
        "unstable",
    ),
    "layers": (
        Problem(
            TwoLayer(
                EI=6380430,
                m="60.2",
                k_pad=3 * 10**8,
                c_pad=3 * 10**4,
                m_sleeper=250,
                k_ballast=10**8,
                c_ballast=8 * 10**4,
            ),
            [Mass(900)],
            v=680,
        ),
        "unstable",
    ),
}


class Mutation(NamedTuple):
    """`old` becomes `new` in the source of `name` (or Class.method) of `module`; tried on the problem `on`."""

    words: str
    module: str
    name: str
    old: str
    new: str
    on: str = "pair"


CHARACTERISTIC = [
    Mutation(
        "inertia has the other sign",
        "characteristic.disc_matrix",
        "_polynomials",
        "Jet(c0 + c1 * z + c2 * z * z",
        "Jet(c0 + c1 * z - c2 * z * z",
    ),
    Mutation(
        "contact forces push the other way",
        "characteristic.bordering",
        "_rows",
        "_alone(-x if x else x) for x in loads",
        "_alone(x) for x in loads",
    ),
    Mutation(
        "a direct contact moves against the rail",
        "characteristic.bordering",
        "_rows",
        "_alone(*(-x / one.b if x",
        "_alone(*(x / one.b if x",
    ),
    Mutation(
        "contact springs are left out",
        "characteristic.bordering",
        "_rows",
        "_alone(given.h[i])",
        "_alone(0 * given.h[i])",
        "sprung",
    ),
    Mutation(
        "waves behind a load have the other sign", "characteristic.residues", "summed", "back = -at", "back = at"
    ),
    Mutation(
        "D_P: the factors of powers are off by one",
        "characteristic.residues",
        "_slopes",
        "np.arange(1, c.shape[2])",
        "np.arange(2, c.shape[2] + 1)",
        "joined",
    ),
    Mutation(
        "the last pivot's argument is dropped",
        "proof.turning",
        "pivot_arguments",
        "np.diagonal(lu, axis1=1, axis2=2)).sum(1)",
        "np.diagonal(lu, axis1=1, axis2=2))[:, :-1].sum(1)",
    ),
    Mutation(
        "one root too many in U", "characteristic.start", "_tell_apart", "if root.real < 0)", "if root.real < 0) + 1"
    ),
    Mutation(
        "pieces are tested on half of their disc", "characteristic.path", "discs", "* _WIDER * UP", "* 0.5 * UP"
    ),
    Mutation(
        "the cofactors of det A lose their signs",
        "tracks.waveguide",
        "determinant",
        "Fraction(-1) ** j",
        "Fraction(1)",
        "layers",
    ),
    Mutation("mass scales like a damper", "problem.reduced", "reduce_problem", "rate**k", "rate**min(k, 1)", "wire"),
    Mutation(
        "mass and damping are exchanged",
        "problem.reduced",
        "reduce_problem",
        "(parts.K, parts.C, parts.M)",
        "(parts.K, parts.M, parts.C)",
        "joined",
    ),
]
PASSIVITY = [
    Mutation("the envelope is ten times too low", "passivity.far", "far_numbers", "C * _MORE", "C / 10"),
    Mutation(
        "V is G without the factor σ", "characteristic.paths", "Paths._evaluate", "positive(sigma * G", "positive(G"
    ),
    Mutation("the Hermitian part is the difference", "proof.definite", "_hermitian", "+ np", "- np"),
    Mutation(
        "the blocks are three times as long", "passivity.far", "far_numbers", "(a, b, min(", "(3 * a, 3 * b, min("
    ),
    Mutation("each block absorbs tenfold", "passivity.far", "far_numbers", "kappa * _LESS", "10 * kappa * _LESS"),
]
SPECTRUM = [
    Mutation(
        "the closing angle of the rigid motions is dropped",
        "spectrum.count",
        "_half_plane",
        "closing + order * arb.pi() / 2",
        "closing",
        "sprung",
    ),
    Mutation(
        "contacts are added to bodies",
        "spectrum.count",
        "_half_plane",
        "reduced.bodies - reduced.contacts",
        "reduced.bodies + reduced.contacts",
    ),
    Mutation(
        "the turn has the other sign", "spectrum.count", "_half_plane", "- whole_turn(proved)", "+ whole_turn(proved)"
    ),
    Mutation(
        "pivots of the closing turn the other way",
        "spectrum.closing",
        "_pivot_arguments",
        "total += pivot.arg()",
        "total -= pivot.arg()",
    ),
    Mutation(
        "S is not divided by σ in the closing", "spectrum.closing", "_accretive", "entry / sigma if", "entry if"
    ),
    Mutation(
        "a turn round a rectangle is halved",
        "spectrum.sides",
        "whole_turn",
        "arb(value, error)",
        "arb(value, error) / 2",
        "wire",
    ),
    Mutation("roots are mirrored in the real axis", "spectrum.enclose", "in_units", "-sigma.real", "sigma.real"),
    Mutation("radii are a thousandth", "certificate.entries", "_entry", "side * Fraction(3, 2)", "side / 1000"),
    Mutation(
        "every root is counted as growing", "spectrum.solve", "unstable_number", "_sign(ball)", "(True)", "wire"
    ),
    Mutation(
        "the slope of a product misses a part",
        "characteristic.bordering",
        "Bordering.slope",
        " + _taken(f_slope, factors) * _taken(g, waves)",
        "",
        "joined",
    ),
]
MUTATIONS = CHARACTERISTIC + PASSIVITY + SPECTRUM
