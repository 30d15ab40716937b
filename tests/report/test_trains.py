"""What is said of a train, in words and for machines, agrees with the answers it is said of."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

from endless_rows import masses

from mpsolve import Effort, infinite_train
from mpsolve.endless.amplification import Amplification, Peak
from mpsolve.outcome import Reason, Status
from mpsolve.report.trains import train_data, train_text

ROW = masses("0.195").problem
FOUND = infinite_train(ROW, "1.5")
BAND = (Fraction(0), Fraction(2))
RATIOS = Amplification(ROW, BAND, Status.UNVERIFIED, True, Peak(1.23456789, 1.2345999, 0.5), Peak(2.0, math.inf, 1.5))


def test_bounds_are_rounded_outward_and_an_open_one_is_named() -> None:
    text = train_text("Row", FOUND, RATIOS, 16, si=False)
    assert text.startswith("Row\nendless train, v = 39/200, spacing 3/2: ")
    assert FOUND.words in text
    assert FOUND.words.startswith("a motion grows; as computed, ")  # the rest is not proved
    assert "last force over first, ahead: at most between 1.23456 and 1.2346, near 0.5" in text
    assert "back: 2 or more, near 1.5; no upper bound is known yet" in text
    assert "train of 16: stable; forces compared from 0 to 2\n" in text
    assert FOUND.motion is not None
    assert f"q = {complex(FOUND.motion.q).real:.10g}" in text


def test_in_SI_each_number_has_its_unit() -> None:
    text = train_text("", FOUND, RATIOS, 16, si=True)
    assert text.startswith("endless train, v = 0.702 km/h, spacing 1.5 m: ")
    assert f"near {0.5 / (2 * math.pi):.6g} Hz" in text
    assert " i rad/s, kappa d" in text
    assert f"forces compared from 0 to {math.floor(1e6 / math.pi) / 1e6} Hz\n" in text  # 2 rad/s, rounded inward
    assert text.count(" Hz") == 5


def test_machines_get_the_same() -> None:
    content = train_data("Row", FOUND, RATIOS, 16)
    assert (content["status"], content["stable"]) == (FOUND.status.value, FOUND.stable)
    assert content["computed"]["back"] == {"factor": FOUND.back.factor, "frequency": FOUND.back.q}
    assert content["train"]["ahead"] == {"low": 1.23456789, "high": 1.2345999, "frequency": 0.5}
    assert content["train"]["back"]["high"] is None
    assert "train" not in train_data("", FOUND, None, 1)


def test_a_reason_stands_in_both() -> None:
    why = Reason("effort", "the effort is spent", {}, "allow more")
    open_ = replace(RATIOS, status=Status.UNDECIDED, stable=None, ahead=None, back=None, reason=why)
    early = infinite_train(masses("0.18").problem, "1.5", effort=Effort(evaluations=1000))
    text, content = train_text("", early, open_, 3, si=False), train_data("", early, open_, 3)
    assert "train of 3: not decided" in text
    assert "the effort is spent" in text
    assert content["train"]["reason"]["code"] == content["reason"]["code"] == "effort"
