"""What a count presupposes of track, velocity and contacts, decided exactly (SPEC, premises).

Every count needs a receptance that is one analytic function of q in the region: no cut enters it. (That N/D falls as
1/p², and that the velocity is no wave speed, the reduced problem has made sure of.) Passivity in the half-plane
needs a track that gives no energy at rest, with a receptance that falls with the frequency.
"""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq, fmpq_mat

from mpsolve.errors import InputError
from mpsolve.numbers.model import shown
from mpsolve.problem.line import Line
from mpsolve.problem.reduced import Reduced
from mpsolve.spectrum.regions import Below, Rectangle, Region
from mpsolve.tracks.at_rest import Status, at_rest, lowest_cut
from mpsolve.tracks.passive import passivity
from mpsolve.tracks.structure import passive_by_equations
from mpsolve.tracks.undamped import damping_wanted


def require_premises(reduced: Reduced, region: Region) -> None:
    """InputError where no count in this region has a meaning."""
    _require_track(reduced)
    _require_no_cut(reduced, region)
    _require_forces(reduced)


def _require_track(reduced: Reduced) -> None:
    rest = at_rest(reduced.problem.track)
    if rest.status is Status.UNSTABLE:
        raise InputError("track", f"cannot be used: {rest.sentence}: lower the axial force N, or stiffen the track")
    if rest.status is Status.UNDAMPED:
        advice = damping_wanted(reduced.problem.track)
        raise InputError("track", f"has vibrations without damping, which is not decided here: {advice}")


def _require_no_cut(reduced: Reduced, region: Region) -> None:
    """A region above the real axis ends below the lowest cut."""
    height = (
        region.im_max
        if isinstance(region, Rectangle)
        else region.height
        if isinstance(region, Below)
        else Fraction(0)
    )
    if height <= 0:
        return
    low, _ = lowest_cut(reduced.problem.track)
    if height <= low:
        return
    name = "region.im_max" if isinstance(region, Rectangle) else "region"
    if not low:
        stated = f"reaches up to {shown(height)}, but cuts of this track come down to the real axis"
        raise InputError(name, f"{stated}: give an upper side of at most 0")
    stated = f"reaches up to {shown(height)}, but must end below the lowest cut, at {float(low):.6g}"
    raise InputError(name, f"{stated}: give a smaller height")


def require_off_cuts(line: Line, box: Rectangle) -> None:
    """A rectangle lies below the line of the cuts, above it, or crosses it in the gap."""
    unit = line.lower.frequency_unit
    height = line.height * unit
    beside = box.im_max < height or box.im_min > height
    if not beside and not all(line.in_gap(x / unit) for x in (box.re_min, box.re_max)):
        stated = f"and im_min hold the cut line Im q = {shown(height)} between them, beyond the gap of the cuts"
        raise InputError("region.im_max", f"{stated}: take one rectangle below the line and one above it")
    _require_forces(line.lower)


def _require_forces(reduced: Reduced) -> None:
    """No set of contact forces is felt by nobody: B f = 0, h f = 0 and no resultant at any place only for f = 0."""
    contacts = range(reduced.contacts)
    if len(set(reduced.index)) == reduced.contacts:  # each has a place of its own
        return
    rows = [list(row) for row in reduced.B]
    rows += [[Fraction(int(reduced.index[j] == k)) for j in contacts] for k in range(len(reduced.places))]
    rows += [[reduced.h[i] if i == j else Fraction(0) for j in contacts] for i in contacts]
    if fmpq_mat([[fmpq(x.numerator, x.denominator) for x in row] for row in rows]).rank() < reduced.contacts:
        stated = "has two tight contacts of one rigid body at one place, which share a force that nothing determines"
        raise InputError("vehicles", f"{stated}: leave one of them out, or give them a contact stiffness")


def open_on_sheet(line: Line) -> str:
    """Why the theorems of the whole sheet do not hold for the vehicle; "" where they do.

    Above the line of the cuts it must be passive: S(−τ − η) with matrices that are positive semidefinite. On a damped
    track it must be made of tight masses, each alone under its contact, for the theorem far out.
    """
    reduced = line.upper
    if reduced.neutral:
        return "a coordinate of the vehicle has neither spring nor contact"
    if line.height:
        return "" if tight_masses(line) else "the vehicles are more than masses on the beam"
    return "the vehicle has dampers" if any(map(any, reduced.S[1])) else ""


def tight_masses(line: Line) -> bool:
    """Whether each body is a mass with a tight contact of its own, and nothing else is there."""
    reduced, h = line.upper, line.height
    rows = (*reduced.B, *zip(*reduced.B, strict=True))
    single = reduced.bodies == reduced.contacts and all(sum(map(bool, row)) == 1 for row in rows)
    pairs = [(i, j) for i in range(reduced.bodies) for j in range(reduced.bodies)]
    K, C, M = reduced.S
    bare = all(
        K[i][j] == h * h * M[i][j] and C[i][j] == 2 * h * M[i][j] and (i == j or not M[i][j]) for i, j in pairs
    )
    return single and bare and not any(reduced.h)


def open_at_rest(reduced: Reduced, certified: bool = True) -> str:
    """Why the track at rest is not known to be passive; "" where σG is proved positive real at v = 0.

    certified: whether a certificate has to show it.
    """
    guide = reduced.guide
    found = passivity(reduced.problem.track)
    if not found.passive:
        p, omega = found.witness or (0.0, 0.0)
        return f"the track at rest gives energy to a harmonic force, at p = {p:.4g}, Omega = {omega:.4g}"
    if certified and not passive_by_equations(reduced.problem.track.waveguide):
        return "the track takes energy, but not each field by itself, as a certificate would have to show"
    if max(j for _, j in guide.N_rest) >= max(j for _, j in guide.D_rest):
        return (
            "the track's receptance does not fall with the frequency: the loaded field has neither mass nor damping"
        )
    return ""
