"""Certified stability analysis of moving inertial loads: every induced frequency of a case, with proof."""

from mpsolve.errors import CertificateError, InputError, MpsolveError
from mpsolve.model.exact import Exact
from mpsolve.model.inputfile import read_case
from mpsolve.model.parameters import Case, Mass, PhysicalCase
from mpsolve.spectrum.certify import Spectrum, Status, certify
from mpsolve.spectrum.region import Rectangle

__version__ = "0.1.0"

__all__ = [
    "Case",
    "PhysicalCase",
    "Mass",
    "Exact",
    "read_case",
    "certify",
    "Rectangle",
    "Spectrum",
    "Status",
    "MpsolveError",
    "InputError",
    "CertificateError",
]
