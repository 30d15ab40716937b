"""Certified stability analysis of moving inertial loads: every induced frequency of a case, with proof."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mpsolve import tracks as tracks
    from mpsolve import vehicles as vehicles
    from mpsolve.batch.frequencies import frequencies as frequencies
    from mpsolve.batch.result import Frequencies as Frequencies
    from mpsolve.batch.seeds import Seeds as Seeds
    from mpsolve.batch.seeds import seeds as seeds
    from mpsolve.certificate.certify import certify as certify
    from mpsolve.certificate.check import verify as verify
    from mpsolve.certificate.real_roots import real_roots as real_roots
    from mpsolve.certificate.roots import roots as roots
    from mpsolve.certificate.verify2 import Verdict as Verdict
    from mpsolve.characteristic.forced import receptance as receptance
    from mpsolve.cuts.answer import CutPoint as CutPoint
    from mpsolve.cuts.answer import CutPoints as CutPoints
    from mpsolve.cuts.points import cut_points as cut_points
    from mpsolve.endless.amplification import Amplification as Amplification
    from mpsolve.endless.amplification import amplification as amplification
    from mpsolve.endless.infinite_train import InfiniteTrain as InfiniteTrain
    from mpsolve.endless.infinite_train import infinite_train as infinite_train
    from mpsolve.endless.velocities import TrainVelocities as TrainVelocities
    from mpsolve.endless.velocities import train_velocities as train_velocities
    from mpsolve.errors import CertificateError as CertificateError
    from mpsolve.errors import InputError as InputError
    from mpsolve.errors import MpsolveError as MpsolveError
    from mpsolve.errors import StudyError as StudyError
    from mpsolve.finite.beam import BeamResponse as BeamResponse
    from mpsolve.finite.beam import finite_beam as finite_beam
    from mpsolve.finite.finite_track import FiniteTrackMotion as FiniteTrackMotion
    from mpsolve.finite.finite_track import finite_track as finite_track
    from mpsolve.loci.answer import FrequencyLine as FrequencyLine
    from mpsolve.loci.answer import FrequencyLines as FrequencyLines
    from mpsolve.loci.answer import LineEnd as LineEnd
    from mpsolve.loci.lines import frequency_lines as frequency_lines
    from mpsolve.numbers.exact import Exact as Exact
    from mpsolve.outcome import Reason as Reason
    from mpsolve.outcome import Status as Status
    from mpsolve.passivity.answer import PassivityVelocity as PassivityVelocity
    from mpsolve.passivity.band import PassivityBand as PassivityBand
    from mpsolve.passivity.band import passivity_band as passivity_band
    from mpsolve.passivity.velocity import passivity_velocity as passivity_velocity
    from mpsolve.problem.case import Case as Case
    from mpsolve.problem.casefile import read_case as read_case
    from mpsolve.problem.inputfile import read_problem as read_problem
    from mpsolve.problem.physical import Mass as Mass
    from mpsolve.problem.physical import PhysicalCase as PhysicalCase
    from mpsolve.problem.problem import Problem as Problem
    from mpsolve.proof.effort import Effort as Effort
    from mpsolve.ranges.chart import Chart as Chart
    from mpsolve.ranges.chart import stability_chart as stability_chart
    from mpsolve.ranges.crossed import Crossing as Crossing
    from mpsolve.ranges.crossed import Crossings as Crossings
    from mpsolve.ranges.crossings import crossings as crossings
    from mpsolve.ranges.onset import Onset as Onset
    from mpsolve.ranges.onset import onset as onset
    from mpsolve.ranges.robust_answer import Robust as Robust
    from mpsolve.ranges.sensitivity import Sensitivity as Sensitivity
    from mpsolve.ranges.sensitivity import sensitivity as sensitivity
    from mpsolve.ranges.table import Table as Table
    from mpsolve.ranges.table import stability_table as stability_table
    from mpsolve.ranges.unstable import Unstable as Unstable
    from mpsolve.ranges.unstable import UnstableRanges as UnstableRanges
    from mpsolve.ranges.unstable import unstable_ranges as unstable_ranges
    from mpsolve.ranges.worst import Worst as Worst
    from mpsolve.ranges.worst import worst as worst
    from mpsolve.spectrum.spectrum import Root as Root
    from mpsolve.spectrum.spectrum import Spectrum as Spectrum
    from mpsolve.studies.robust import prove_stable as prove_stable
    from mpsolve.studies.run import Study as Study
    from mpsolve.studies.run import open_study as open_study
    from mpsolve.studies.run import study as study
    from mpsolve.vehicles.load import Load as Load
    from mpsolve.vibration.balls.enclosure import ProvedVibration as ProvedVibration
    from mpsolve.vibration.balls.enclosure import response_balls as response_balls
    from mpsolve.vibration.case_motion import Response as Response
    from mpsolve.vibration.forcing import Irregularity as Irregularity
    from mpsolve.vibration.forcing import out_of_round as out_of_round
    from mpsolve.vibration.forcing import rail_roughness as rail_roughness
    from mpsolve.vibration.liftoff import Event as Event
    from mpsolve.vibration.motion import PreciseVibration as PreciseVibration
    from mpsolve.vibration.motion import Vibration as Vibration
    from mpsolve.vibration.precise import response_mp as response_mp
    from mpsolve.vibration.response import response as response
    from mpsolve.vibration.studies import deflection_shape as deflection_shape
    from mpsolve.vibration.studies import envelope as envelope
    from mpsolve.vibration.studies import merged as merged
    from mpsolve.vibration.studies import superposition as superposition
    from mpsolve.vibration.studies import transient_importance as transient_importance
    from mpsolve.waves.critical import critical_velocities as critical_velocities
    from mpsolve.waves.dispersion import dispersion as dispersion
    from mpsolve.waves.velocity import CriticalVelocities as CriticalVelocities
    from mpsolve.waves.velocity import CriticalVelocity as CriticalVelocity
    from mpsolve.zeros.answer import Zero as Zero
    from mpsolve.zeros.answer import Zeros as Zeros
    from mpsolve.zeros.regions import Cut as Cut
    from mpsolve.zeros.regions import Disc as Disc
    from mpsolve.zeros.regions import HalfPlane as HalfPlane
    from mpsolve.zeros.regions import Polygon as Polygon
    from mpsolve.zeros.regions import Rectangle as Rectangle

__version__ = "0.1.0"

_NAMES = {
    "problem.problem": "Problem",
    "tracks": "tracks",
    "vehicles": "vehicles",
    "problem.inputfile": "read_problem",
    "problem.case": "Case",
    "problem.physical": "PhysicalCase Mass",
    "numbers.exact": "Exact",
    "problem.casefile": "read_case",
    "characteristic.forced": "receptance",
    "waves.dispersion": "dispersion",
    "waves.critical": "critical_velocities",
    "waves.velocity": "CriticalVelocities CriticalVelocity",
    "passivity.velocity": "passivity_velocity",
    "passivity.answer": "PassivityVelocity",
    "passivity.band": "passivity_band PassivityBand",
    "certificate.certify": "certify",
    "zeros.regions": "Rectangle Disc Polygon HalfPlane Cut",
    "spectrum.spectrum": "Spectrum Root",
    "outcome": "Status Reason",
    "proof.effort": "Effort",
    "batch.frequencies": "frequencies",
    "batch.result": "Frequencies",
    "batch.seeds": "seeds Seeds",
    "endless.infinite_train": "infinite_train InfiniteTrain",
    "endless.velocities": "train_velocities TrainVelocities",
    "endless.amplification": "amplification Amplification",
    "ranges.onset": "onset Onset",
    "ranges.unstable": "unstable_ranges Unstable UnstableRanges",
    "ranges.worst": "worst Worst",
    "ranges.crossings": "crossings",
    "ranges.crossed": "Crossings Crossing",
    "studies.robust": "prove_stable",
    "ranges.sensitivity": "sensitivity Sensitivity",
    "cuts.points": "cut_points",
    "cuts.answer": "CutPoints CutPoint",
    "loci.lines": "frequency_lines",
    "loci.answer": "FrequencyLines FrequencyLine LineEnd",
    "ranges.chart": "stability_chart Chart",
    "ranges.robust_answer": "Robust",
    "ranges.table": "stability_table Table",
    "vehicles.load": "Load",
    "vibration.response": "response",
    "vibration.case_motion": "Response",
    "vibration.motion": "Vibration PreciseVibration",
    "vibration.precise": "response_mp",
    "vibration.balls.enclosure": "response_balls ProvedVibration",
    "vibration.forcing": "Irregularity rail_roughness out_of_round",
    "vibration.liftoff": "Event",
    "vibration.studies": "envelope superposition merged transient_importance deflection_shape",
    "finite.beam": "finite_beam BeamResponse",
    "finite.finite_track": "finite_track FiniteTrackMotion",
    "studies.run": "study open_study Study",
    "certificate.roots": "roots",
    "certificate.real_roots": "real_roots",
    "zeros.answer": "Zeros Zero",
    "certificate.check": "verify",
    "certificate.verify2": "Verdict",
    "errors": "MpsolveError InputError CertificateError StudyError",
}
"""The public names by the module of each, in the order of the flow of the data."""
_HOME = {name: home for home, names in _NAMES.items() for name in names.split()}
__all__ = list(_HOME)


def __getattr__(name: str) -> Any:
    """Public names load on first use, so that `import mpsolve` stays quick."""
    if name not in _HOME:
        raise AttributeError(f"module 'mpsolve' has no attribute {name!r}")
    home = import_module(f"mpsolve.{_HOME[name]}")
    value = home if _HOME[name] == name else getattr(home, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOME])
