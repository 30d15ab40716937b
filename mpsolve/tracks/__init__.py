"""The tracks: each file holds one, as exact equations of motion."""

from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.tracks.layered import TwoLayer
from mpsolve.tracks.string import String
from mpsolve.tracks.waveguide import Track

__all__ = ["EulerBernoulli", "String", "Track", "TwoLayer"]
