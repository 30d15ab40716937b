"""The tracks: each file holds one, as exact equations of motion; Waveguide is for anybody's own."""

from mpsolve.tracks.euler_bernoulli import EulerBernoulli
from mpsolve.tracks.floating_ice import FloatingIce
from mpsolve.tracks.own import Waveguide
from mpsolve.tracks.rayleigh import Rayleigh
from mpsolve.tracks.slab import Slab
from mpsolve.tracks.string import String
from mpsolve.tracks.three_layer import ThreeLayer
from mpsolve.tracks.timoshenko import Timoshenko
from mpsolve.tracks.two_layer import TwoLayer
from mpsolve.tracks.waveguide import Track

CATALOGUE: tuple[type[Track], ...] = (
    String,
    EulerBernoulli,
    Rayleigh,
    Timoshenko,
    TwoLayer,
    ThreeLayer,
    Slab,
    FloatingIce,
)
"""Every track with a name of its own, from the plainest to the richest."""

__all__ = [
    "String",
    "EulerBernoulli",
    "Rayleigh",
    "Timoshenko",
    "TwoLayer",
    "ThreeLayer",
    "Slab",
    "FloatingIce",
    "Waveguide",
    "Track",
    "CATALOGUE",
]
