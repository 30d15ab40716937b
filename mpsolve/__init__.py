"""Certified stability analysis of moving inertial loads: every induced frequency of a case, with proof."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mpsolve import tracks, vehicles
    from mpsolve.batch.frequencies import frequencies
    from mpsolve.batch.result import Frequencies
    from mpsolve.batch.seeds import Seeds, seeds
    from mpsolve.certificate.certify import certify
    from mpsolve.certificate.check import verify
    from mpsolve.certificate.real_roots import real_roots
    from mpsolve.certificate.roots import roots
    from mpsolve.certificate.verify2 import Verdict
    from mpsolve.characteristic.forced import receptance
    from mpsolve.cuts.answer import CutPoint, CutPoints
    from mpsolve.cuts.points import cut_points
    from mpsolve.endless.amplification import Amplification, amplification
    from mpsolve.endless.infinite_train import InfiniteTrain, infinite_train
    from mpsolve.endless.velocities import TrainVelocities, train_velocities
    from mpsolve.errors import CertificateError, InputError, MpsolveError, StudyError
    from mpsolve.finite.beam.beam import BeamResponse, finite_beam
    from mpsolve.finite.finite_track import FiniteTrackMotion, finite_track
    from mpsolve.loci.answer import FrequencyLine, FrequencyLines, LineEnd
    from mpsolve.loci.lines import frequency_lines
    from mpsolve.numbers.exact import Exact
    from mpsolve.outcome import Reason, Status
    from mpsolve.passivity.answer import PassivityVelocity
    from mpsolve.passivity.band import PassivityBand, passivity_band
    from mpsolve.passivity.velocity import passivity_velocity
    from mpsolve.problem.case import Case
    from mpsolve.problem.casefile import read_case
    from mpsolve.problem.inputfile import read_problem
    from mpsolve.problem.physical import Mass, PhysicalCase
    from mpsolve.problem.problem import Problem
    from mpsolve.proof.effort import Effort
    from mpsolve.ranges.chart import Chart, stability_chart
    from mpsolve.ranges.crossed import Crossing, Crossings
    from mpsolve.ranges.crossings import crossings
    from mpsolve.ranges.onset import Onset, Unstable, UnstableRanges, onset, unstable_ranges
    from mpsolve.ranges.robust import Robust
    from mpsolve.ranges.sensitivity import Sensitivity, sensitivity
    from mpsolve.ranges.table import Table, stability_table
    from mpsolve.ranges.worst import Worst, worst
    from mpsolve.spectrum.spectrum import Root, Spectrum
    from mpsolve.studies.robust import prove_stable
    from mpsolve.studies.run import Study, open_study, study
    from mpsolve.vehicles.load import Load
    from mpsolve.vibration.balls.enclosure import ProvedVibration, response_balls
    from mpsolve.vibration.case_motion import Response
    from mpsolve.vibration.case_studies import deflection_shape
    from mpsolve.vibration.forcing import Irregularity
    from mpsolve.vibration.liftoff import Event
    from mpsolve.vibration.motion import Vibration
    from mpsolve.vibration.precise import response_mp
    from mpsolve.vibration.precise_motion import PreciseVibration
    from mpsolve.vibration.response import response
    from mpsolve.vibration.roughness import out_of_round, rail_roughness
    from mpsolve.vibration.studies import envelope, merged, superposition, transient_importance
    from mpsolve.waves.critical import critical_velocities
    from mpsolve.waves.dispersion import dispersion
    from mpsolve.waves.velocity import CriticalVelocities, CriticalVelocity
    from mpsolve.zeros.answer import Zero, Zeros
    from mpsolve.zeros.regions import Cut, Disc, HalfPlane, Polygon, Rectangle

__version__ = "0.1.0"

__all__ = [
    "Problem",
    "tracks",
    "vehicles",
    "read_problem",
    "Case",
    "PhysicalCase",
    "Mass",
    "Exact",
    "read_case",
    "receptance",
    "dispersion",
    "critical_velocities",
    "CriticalVelocities",
    "CriticalVelocity",
    "passivity_velocity",
    "PassivityVelocity",
    "passivity_band",
    "PassivityBand",
    "certify",
    "Rectangle",
    "Spectrum",
    "Status",
    "Reason",
    "Root",
    "Effort",
    "frequencies",
    "Frequencies",
    "seeds",
    "Seeds",
    "infinite_train",
    "InfiniteTrain",
    "train_velocities",
    "TrainVelocities",
    "amplification",
    "Amplification",
    "onset",
    "unstable_ranges",
    "worst",
    "Worst",
    "crossings",
    "prove_stable",
    "sensitivity",
    "cut_points",
    "CutPoints",
    "CutPoint",
    "frequency_lines",
    "FrequencyLines",
    "FrequencyLine",
    "LineEnd",
    "stability_chart",
    "Onset",
    "Unstable",
    "UnstableRanges",
    "Crossings",
    "Crossing",
    "Robust",
    "Sensitivity",
    "Chart",
    "stability_table",
    "Table",
    "Load",
    "response",
    "Response",
    "Vibration",
    "response_mp",
    "PreciseVibration",
    "response_balls",
    "ProvedVibration",
    "Irregularity",
    "rail_roughness",
    "out_of_round",
    "Event",
    "envelope",
    "superposition",
    "merged",
    "transient_importance",
    "deflection_shape",
    "finite_beam",
    "BeamResponse",
    "finite_track",
    "FiniteTrackMotion",
    "study",
    "open_study",
    "Study",
    "roots",
    "real_roots",
    "Zeros",
    "Zero",
    "Disc",
    "Polygon",
    "HalfPlane",
    "Cut",
    "verify",
    "Verdict",
    "MpsolveError",
    "InputError",
    "CertificateError",
    "StudyError",
]

_HOME = {
    "Problem": "problem.problem",
    "tracks": "tracks",
    "vehicles": "vehicles",
    "read_problem": "problem.inputfile",
    "Case": "problem.case",
    "PhysicalCase": "problem.physical",
    "Mass": "problem.physical",
    "Exact": "numbers.exact",
    "read_case": "problem.casefile",
    "receptance": "characteristic.forced",
    "dispersion": "waves.dispersion",
    "critical_velocities": "waves.critical",
    "CriticalVelocities": "waves.velocity",
    "CriticalVelocity": "waves.velocity",
    "passivity_velocity": "passivity.velocity",
    "PassivityVelocity": "passivity.answer",
    "passivity_band": "passivity.band",
    "PassivityBand": "passivity.band",
    "certify": "certificate.certify",
    "Rectangle": "zeros.regions",
    "Spectrum": "spectrum.spectrum",
    "Status": "outcome",
    "Reason": "outcome",
    "Root": "spectrum.spectrum",
    "Effort": "proof.effort",
    "frequencies": "batch.frequencies",
    "Frequencies": "batch.result",
    "seeds": "batch.seeds",
    "Seeds": "batch.seeds",
    "infinite_train": "endless.infinite_train",
    "InfiniteTrain": "endless.infinite_train",
    "train_velocities": "endless.velocities",
    "TrainVelocities": "endless.velocities",
    "amplification": "endless.amplification",
    "Amplification": "endless.amplification",
    "onset": "ranges.onset",
    "unstable_ranges": "ranges.onset",
    "crossings": "ranges.crossings",
    "prove_stable": "studies.robust",
    "sensitivity": "ranges.sensitivity",
    "cut_points": "cuts.points",
    "CutPoint": "cuts.answer",
    "CutPoints": "cuts.answer",
    "frequency_lines": "loci.lines",
    "FrequencyLines": "loci.answer",
    "FrequencyLine": "loci.answer",
    "LineEnd": "loci.answer",
    "stability_chart": "ranges.chart",
    "Onset": "ranges.onset",
    "Unstable": "ranges.onset",
    "UnstableRanges": "ranges.onset",
    "Crossings": "ranges.crossed",
    "Crossing": "ranges.crossed",
    "Robust": "ranges.robust",
    "Sensitivity": "ranges.sensitivity",
    "Chart": "ranges.chart",
    "stability_table": "ranges.table",
    "worst": "ranges.worst",
    "Worst": "ranges.worst",
    "Table": "ranges.table",
    "Load": "vehicles.load",
    "response": "vibration.response",
    "Vibration": "vibration.motion",
    "response_mp": "vibration.precise",
    "PreciseVibration": "vibration.precise_motion",
    "response_balls": "vibration.balls.enclosure",
    "ProvedVibration": "vibration.balls.enclosure",
    "Irregularity": "vibration.forcing",
    "rail_roughness": "vibration.roughness",
    "out_of_round": "vibration.roughness",
    "Event": "vibration.liftoff",
    "Response": "vibration.case_motion",
    "envelope": "vibration.studies",
    "superposition": "vibration.studies",
    "merged": "vibration.studies",
    "transient_importance": "vibration.studies",
    "deflection_shape": "vibration.case_studies",
    "finite_beam": "finite.beam.beam",
    "BeamResponse": "finite.beam.beam",
    "finite_track": "finite.finite_track",
    "FiniteTrackMotion": "finite.finite_track",
    "study": "studies.run",
    "open_study": "studies.run",
    "Study": "studies.run",
    "roots": "certificate.roots",
    "real_roots": "certificate.real_roots",
    "Zeros": "zeros.answer",
    "Zero": "zeros.answer",
    "Disc": "zeros.regions",
    "Polygon": "zeros.regions",
    "HalfPlane": "zeros.regions",
    "Cut": "zeros.regions",
    "verify": "certificate.check",
    "Verdict": "certificate.verify2",
    "MpsolveError": "errors",
    "InputError": "errors",
    "CertificateError": "errors",
    "StudyError": "errors",
}


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
