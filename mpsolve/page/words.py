"""What a page says first: the verdict, and a card for each question that is asked next."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import arb

from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.numbers.spoken import rounded, spoken
from mpsolve.page.budget import Part
from mpsolve.page.parts import Parts
from mpsolve.problem.case import Case
from mpsolve.problem.problem import Problem
from mpsolve.ranges.onset import Kind
from mpsolve.report.remedies import on_command_line
from mpsolve.spectrum.spectrum import Root
from mpsolve.vehicles.load import GRAVITY
from mpsolve.vehicles.loads import rigid_bounce
from mpsolve.waves.speeds import SLOW_WAVES, slow_waves
from mpsolve.waves.velocity import Kind as Kinds

if TYPE_CHECKING:
    from mpsolve.vibration.motion import Vibration


@dataclass(frozen=True)
class Card:
    """A question, its answer in large, a sentence, and how sure it is: "proved", "computed" or "open"."""

    question: str
    figure: str
    sentence: str
    status: str


@dataclass(frozen=True)
class Speech:
    """How quantities are said: in SI, or in the paper's ratios."""

    si: bool

    def velocity(self, x: Any, figures: int = 4) -> str:
        return spoken(x, "m/s", figures) if self.si else f"α = {rounded(x, figures)}"

    def frequency(self, x: arb) -> str:
        return f"{rounded(x)} {'Hz' if self.si else '1/τ'}"

    def rate(self, x: Fraction) -> str:
        return f"{rounded(x)} {'1/s' if self.si else '1/τ'}"

    def time(self, x: Any) -> str:
        return spoken(x, "s") if self.si else f"τ = {rounded(x)}"

    def span(self, x: arb) -> str:
        """A time after "every" or "in"."""
        return self.time(x) if self.si else f"{rounded(x)} τ"

    def length(self, x: Any) -> str:
        return spoken(x, "m") if self.si else rounded(x)


def speech(parts: Parts) -> Speech:
    return Speech(not isinstance(parts.given, Case))


def cards(parts: Parts) -> list[Card]:
    """Velocity, growth, contact, waves."""
    said = [velocity_card(parts), growth_card(parts), contact_card(parts), wave_card(parts)]
    return [replace(one, sentence=on_command_line(one.sentence)) for one in said if one is not None]


def velocity_card(parts: Parts) -> Card:
    """How far the velocity is from the one at which stability changes."""
    question, speak = "When does it change with the velocity?", speech(parts)
    part, v = parts.reach, parts.problem.v
    found = part.value
    if found is None:
        return missing(question, part)
    here = f"It runs at {speak.velocity(v)}."
    if found.kind is Kind.STABLE:
        start, end = least(found.low, found.high, speak.velocity), speak.velocity(found.high)
        said = f"Stable all the way from {start} to {end}. {here}"
        if found.reason is None:
            return Card(question, "no change", said, "proved")
        return Card(question, f"not up to {speak.velocity(found.high)}", f"{said} Beyond that it is open.", "proved")
    if found.kind is Kind.UNSTABLE_FROM_START:
        return Card(
            question, "unstable from the start", f"A vibration grows at the least velocities too. {here}", "proved"
        )
    if found.kind is not Kind.CROSSES:
        return Card(question, "undecided", f"{capital(str(found.reason))}. {here}", "open")
    with precision(128):
        value = found.value
        shift = value - rational_ball(v)
        where = speak.velocity(value)
        if shift > 0:
            part_of = rounded(100 * rational_ball(v) / value, 3)
            said = f"{here} That leaves {speak.velocity(shift)}: it runs at {part_of} % of the limit."
        else:
            higher = "it is stable again there" if parts.spectrum.stable else "stable windows may lie higher up"
            said = f"{here} That is {speak.velocity(-shift)} above it; {higher}."
        if found.low:
            said = f"{said} Every velocity from {least(found.low, value, speak.velocity)} on was looked at."
        return Card(question, f"stable below {where}", said, "proved")


def least(low: Any, high: Any, say: Callable[[Any], str]) -> str:
    """The lower end of a range, in words where it is next to nothing."""
    return "practically zero" if low and 500 * float(low) < float(high) else say(low)


def growth_card(parts: Parts) -> Card | None:
    """How fast the fastest vibration grows, or how slowly the slowest decays."""
    speak, spectrum = speech(parts), parts.spectrum
    ordered = sorted(spectrum.roots, key=lambda root: float(root.growth.mid()), reverse=True)
    ordered = [root for root in ordered if not root.q.real < 0]
    if not ordered:
        return None
    status = "proved" if spectrum.proved else "open"
    with precision(128):
        root = ordered[0]
        if root.growth > 0:
            said = f"The vibration at {speak.frequency(root.frequency)} doubles in this time, and doubles again."
            return Card("How fast does it grow?", f"doubles in {speak.span(root.doubling_time)}", said, status)
        if root.growth < 0:
            where = speak.frequency(root.frequency)
            said = f"Of the vibrations in the table the one at {where} lasts longest: it halves in this time."
            return Card("How fast does it calm down?", f"halves in {speak.span(root.doubling_time)}", said, status)
    return None


def contact_card(parts: Parts) -> Card:
    """Whether a wheel lifts off after the vehicle is put on the track."""
    question, part, speak = "Does a wheel lift off?", parts.response, speech(parts)
    motion = part.value
    if motion is None:
        return missing(question, part)
    event = motion.lift_off
    loads = "the weight of the vehicle" if parts.loads is None else "the load of the file"
    start = f"{loads} is put at once on a smooth rail and round wheels"
    if event is None and motion.unjudged:
        said = "No constant force presses some contact, so whether it is kept cannot be judged."
        return Card(question, "not judged", said, "open")
    if event is None:
        said = f"Not within {speak.time(float(motion.times[-1]))}{_why_so_long(parts)} after {start}."
        return Card(
            question, "no, if all is smooth", f"{said}{_most(motion, speak)}{_weight(parts, speak)}", "computed"
        )
    name = contact_names(parts.problem)[event.contact - 1]
    own = "" if name.startswith("contact") else f" ({name})"
    said = f"{capital(start)}; then contact {event.contact}, counted from the rear{own}, lifts off first."
    if parts.spectrum.stable and parts.loads is None:
        said += " It is the swing of this sudden start, not growth."
    when = f"after {speak.time(event.time)}"
    return Card(question, when, f"{said} The model says nothing of what follows.", "computed")


def _why_so_long(parts: Parts) -> str:
    """Why the motion is looked at for this time."""
    roots = parts.spectrum.roots
    swings = any(float(root.frequency.mid()) > 0 for root in roots)
    grows = any(float(root.growth.mid()) > 0 for root in roots)
    return " (eight periods of the lowest frequency)" if swings and not grows else ""


def _most(motion: Vibration, speak: Speech) -> str:
    """The largest deflection and contact force of the motion, in SI."""
    if not speak.si:
        return ""
    sinks, presses = float(np.nanmax(motion.rail)), float(np.nanmax(motion.contact_force))
    said = f" Meanwhile the rail sinks by at most {spoken(1000 * sinks, '', 3)} mm"
    return f"{said}, and one contact presses with at most {spoken(presses, 'N', 3)}."


def _weight(parts: Parts, speak: Speech) -> str:
    """What the vehicles weigh, in SI, so that a mass that was meant for both rails, or a forgotten body, is seen."""
    pencil = parts.problem.pencil
    bounce = rigid_bounce(pencil)
    if not speak.si or bounce is None or parts.loads is not None:
        return ""
    mass = sum(a * m * b for a, row in zip(bounce, pencil.M, strict=True) for m, b in zip(row, bounce, strict=True))
    each = float(mass) * float(GRAVITY) / pencil.contacts
    return (
        f" All masses of the file together are {spoken(mass, 'kg', 3)}, as a rule those over one rail: "
        f"at rest {spoken(each, 'N', 3)} a contact, on average."
    )


def contact_names(problem: Problem) -> list[str]:
    """The body that is alone over each contact, from rear to front; "contact 3" where there is no such one."""
    pencil, out = problem.pencil, []
    for j in range(pencil.contacts):
        on = [i for i in range(pencil.size) if pencil.B[i][j]]
        alone = len(on) == 1 and sum(map(bool, pencil.B[on[0]])) == 1
        out.append(pencil.names[on[0]] if alone else f"contact {j + 1}")
    return out


def wave_card(parts: Parts) -> Card | None:
    """The least velocity at which two waves merge under a constant force."""
    part, speak = parts.critical, speech(parts)
    if part.value is None or not len(part.value):
        return None
    first = part.value.velocities[0]
    merge = first.kind in (Kinds.MINIMUM, Kinds.MAXIMUM, Kinds.STATIONARY)
    said = f"There: {first.kind.value}."
    if merge:
        said = "Two waves merge there, where phase and group velocity are equal. "
        said += (
            "Without damping the deflection under a constant force grows without bound; with damping it is greatest "
        )
        said += "at another velocity, often a lower one, which the command “mpsolve critical” draws."
    v = parts.problem.v
    if v:
        with precision(128):
            said = f"{said} This case runs at {rounded(100 * rational_ball(v) / first.value, 3)} % of it."
    if slow_waves(parts.problem.track):
        said = f"{said} {SLOW_WAVES}"
    status = "proved" if part.value.status.holds else "open"
    return Card("What is the critical velocity of a force?", speak.velocity(first.value), said, status)


def missing(question: str, part: Part[Any]) -> Card:
    return Card(question, "not in time" if part.late else "not available", f"{capital(part.reason)}.", "open")


def capital(said: str) -> str:
    """As a sentence begins."""
    return said[:1].upper() + said[1:]


def doing(root: Root, speak: Speech) -> str:
    """What a vibration does, in words."""
    with precision(max(64, root.q.bits() + 32)):
        if root.growth > 0:
            return f"doubles every {speak.span(root.doubling_time)}"
        return f"halves every {speak.span(root.doubling_time)}" if root.growth < 0 else "neither grows nor decays"
