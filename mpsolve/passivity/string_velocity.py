"""Up to which velocity a string takes up power from one contact: that of its waves (`ranges.on_string`)."""

from __future__ import annotations

from fractions import Fraction

from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.outcome import Reason, Status
from mpsolve.passivity.answer import Kind, PassivityVelocity
from mpsolve.tracks.string import String


def velocity_of_string(track: String, low: Fraction, high: Fraction, bits: int) -> PassivityVelocity:
    """The answer for low ≤ v ≤ high and a damped string, without any boxes; balls of that many bits."""
    with precision(bits):
        speed = (rational_ball(track.T) / rational_ball(track.m)).sqrt()
        end = rational_ball(high)
    square = track.T / track.m
    if low * low >= square:
        stated = "faster than its waves a string carries none ahead, and G(0, q) = 0: single contacts do not feel it"
        reason = Reason("wave-speed", stated, {}, "give a range that begins below the speed of its waves")
        return PassivityVelocity(Kind.UNDECIDED, None, low, high, None, (), Status.UNDECIDED, reason)
    if high * high < square:
        return PassivityVelocity(Kind.WHOLE, None, low, high, end, (), Status.UNVERIFIED)
    return PassivityVelocity(Kind.LOST, speed, low, high, speed, (speed,), Status.UNVERIFIED)
