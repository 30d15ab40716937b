"""The derivation of a whole problem, step by step, to print: its track, its vehicles, and what couples them."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from mpsolve import tracks, vehicles
from mpsolve.derivation.step import Step
from mpsolve.derivation.tracks import Derived, Omega, derived, load, p, symbols_of, t, x
from mpsolve.derivation.vehicles import Energies, energies
from mpsolve.errors import InputError
from mpsolve.problem.problem import Problem
from mpsolve.tracks.waveguide import Track
from mpsolve.vehicles.vehicle import AnyVehicle

_MOST = 24
"""The most coordinates of vehicles whose matrices are printed as one system."""


def derivation_of_masses(count: int) -> tuple[Step, ...]:
    """The same of so many masses in a row on a beam; InputError for less than one."""
    if count < 1:
        raise InputError("masses", f"is {count}: give one mass or more")
    beam = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="1/10")
    return derivation_of(Problem(beam, vehicles.train(vehicles.Mass(1), count, 1), v="1/2"))


def derivation_of(problem: Problem) -> tuple[Step, ...]:
    """Every step from the mechanics of the problem's track and vehicles to its characteristic function.

    InputError for a track that has no equations of motion of its own, one that was given by its matrix.
    """
    track = problem.track
    if not isinstance(track, Track):
        raise InputError("track", "is given by its matrix, so there is nothing to derive: print its matrix")
    kinds: dict[tuple[type[AnyVehicle], bool], AnyVehicle] = {}
    for placed in problem.vehicles:
        kinds.setdefault((type(placed.vehicle), getattr(placed.vehicle, "body", None) is not None), placed.vehicle)
    steps = [*_track(track)]
    for number, vehicle in enumerate(kinds.values(), 1):
        steps += _vehicle(vehicle, f"V{number}")
    return (*steps, *_coupling(problem))


def _track(track: Track) -> list[Step]:
    found = derived(type(track))
    U = sp.symbols(f"U:{len(found.fields)}")
    right = [load, *[sp.Integer(0)] * (len(found.fields) - 1)]
    motion = tuple(sp.Eq(left, side) for left, side in zip(found.equations, right, strict=True))
    wave = tuple(sp.Eq(field, U[k] * sp.exp(sp.I * (p * x + Omega * t))) for k, field in enumerate(found.fields))
    A, D, N = sp.symbols("A D N")
    return [
        Step("(T1)", f"Equations of motion: {track.name}", motion, "Balance of momentum and rotation at rest; f is "
             "the force of the contacts on the rail, per length."),
        Step("(T2)", "One wave", wave, "Every field varies so, at rest."),
        Step("(T3)", "The matrix of the track", _is(A, found.matrix), "(T2) put into (T1): A U = (load, 0, ...)."),
        Step("(T4)", "Dispersion function and numerator", (_is(D, _by_entries(found)), _is(N, _by_entries(found, 1))),
             "D = det A; N is its cofactor of the loaded field: the receptance in wavenumber is N/D."),
        Step("(T5)", "Numbers", _numbers(track), "The parameters of this track, exactly as given."),
    ]  # fmt: skip


def _is(left: Any, right: Any) -> Any:
    """An equation that sympy leaves as it stands."""
    return sp.Eq(left, right, evaluate=False)


def _by_entries(found: Derived, first: int = 0) -> Any:
    """The determinant of A without its first rows and columns, in the entries A_ij that are not 0."""
    size = range(first, len(found.fields))
    named = [[sp.Symbol(f"A_{i + 1}{j + 1}") if found.matrix[i, j] != 0 else 0 for j in size] for i in size]
    return sp.Matrix(named).det() if named else sp.Integer(1)


def _vehicle(vehicle: AnyVehicle, head: str) -> list[Step]:
    if vehicle.name == "matrices":
        pencil = vehicle.pencil
        given = tuple(_is(sp.Symbol(key), sp.Matrix(_plain(getattr(pencil, key)))) for key in "MCKB")
        return [Step(f"({head}.1)", "A vehicle by its matrices", given, "M y'' + C y' + K y = B lambda, as given.")]
    found = energies(type(vehicle), body=getattr(vehicle, "body", None) is not None)
    T, V, R = sp.symbols("T V R")
    work = tuple(sp.Eq(left, right) for left, right in zip(found.equations, _forces(found), strict=True))
    matrices = tuple(_is(sp.Symbol(key), matrix) for key, matrix in zip("MCKB", found.matrices, strict=True))
    places = tuple(_is(sp.Symbol(f"x_{j}"), place) for j, (place, _) in enumerate(found.contacts, 1))
    return [
        Step(f"({head}.1)", f"Energies: {vehicle.name}", (sp.Eq(T, found.T), sp.Eq(V, found.V), sp.Eq(R, found.R)),
             "Kinetic energy, energy of the springs, half the power that the dampers take."),
        Step(f"({head}.2)", "Lagrange's equations", work, "The derivatives of T, R and V by rates and "
             "coordinates balance the contact forces lambda."),
        Step(f"({head}.3)", "Matrices", matrices, "M y'' + C y' + K y = B lambda."),
        Step(f"({head}.4)", "Places of the contacts", places, "Ahead of the middle of the vehicle."),
        Step(f"({head}.5)", "Numbers", _numbers(vehicle), "The parameters of the first such vehicle, as given."),
    ]  # fmt: skip


def _forces(found: Energies) -> list[Any]:
    forces = sp.Matrix(sp.symbols(f"lambda1:{len(found.contacts) + 1}"))
    return list(found.matrices[3] * forces)


def _numbers(model: Any) -> tuple[Any, ...]:
    """The parameters by their symbols; those of a part, as a coach's bogie, behind them with its name."""
    out, symbols = [], vars(symbols_of(type(model)))
    for name, value in model.parameters.items():
        if isinstance(value, Fraction):
            out.append(_is(symbols[name], sp.Rational(value.numerator, value.denominator)))
        elif hasattr(value, "parameters"):
            inner = {f"{key}_{name}": number for key, number in value.parameters.items()}
            out += [_is(sp.Symbol(key), sp.Rational(number)) for key, number in inner.items()]
    return tuple(out)


def _coupling(problem: Problem) -> tuple[Step, ...]:
    q, v, xi = sp.symbols("q v xi")
    S, B, G, h, M, C, K = (sp.Symbol(name, commutative=False) for name in ("S", "B", "G", "h", "M", "C", "K"))
    D, N = sp.Function("D")(p, q - v * p), sp.Function("N")(p, q - v * p)
    kernel = sp.Integral(sp.exp(sp.I * p * xi) * N / D, (p, -sp.oo, sp.oo)) / (2 * sp.pi)
    Delta, det = sp.Function("Delta")(q), sp.Function("det")
    steps = [
        Step("(C1)", "The moving frame", sp.Eq(Omega, q - v * p), "x is counted ahead from the origin that moves "
             f"along at v = {problem.v}; everything varies as e^(i(px + qt)) there."),
        Step("(C2)", "Receptance of the rail", sp.Eq(sp.Function("G")(xi, q), kernel),
             "Of a contact at distance xi ahead of the force; the rail moves by -G lambda under the contacts."),
        Step("(C3)", "The vehicles", sp.Eq(S, K + sp.I * q * C - q**2 * M), "All vehicles together, contacts from "
             f"rear to front: {problem.pencil.size} coordinates, {problem.pencil.contacts} contacts."),
        Step("(C4)", "Characteristic function", sp.Eq(Delta, det(sp.Matrix([[S, -B], [sp.Symbol("B^T"), G + h]]))),
             "Its zeros are the induced frequencies; h is the diagonal of the compliances of the contacts."),
    ]  # fmt: skip
    pencil = problem.pencil
    if pencil.size <= _MOST:
        places = tuple(_is(sp.Symbol(f"xi_{j}"), sp.Rational(place))
                       for j, place in enumerate(pencil.places, 1))  # fmt: skip
        steps.append(Step("(C5)", "Places", places, "Of all contacts in the moving frame."))
    return tuple(steps)


def _plain(rows: Any) -> list[list[Any]]:
    return [[sp.Rational(value) for value in row] for row in rows]
