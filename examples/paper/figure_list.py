"""Figures 3 to 12 and A.1 to A.5: the values of the captions against those of the text, for `captions`."""

from __future__ import annotations

from mpsolve.claims import Claim

from .captions import same_list

_VELOCITIES = ("0.5", "0.8", "0.9")


def _same(name: str, place: str, words: str, text: str | tuple[str, ...], caption: str | tuple[str, ...]) -> Claim:
    one, other = ((values,) if isinstance(values, str) else values for values in (text, caption))
    return Claim(name, place, words, same_list, {"text": one, "caption": other})


CLAIMS = (
    _same("fig-3-list", "Figure 3, caption and Section 4.2", "α = {text} (text), {caption} (caption).",
          _VELOCITIES, _VELOCITIES),
    *(_same(f"fig-{figure}-list", f"Figure {figure}, caption and Section 4.2",
            f"η_M = 40, α = {alpha}: d̂ = {{text}} (text), {{caption}} (caption).", "2:0.5:4.5", "2:0.5:4.5")
      for figure, alpha in zip((4, 5, 6), _VELOCITIES, strict=True)),
    _same("fig-7-list", "Figure 7, caption and Section 4.2", "η_M = 40: d̂ = {text} (text), {caption} (caption).",
          "0.5:0.5:4.5", "0.5:0.5:4.5"),
    _same("fig-8-list", "Figure 8, caption and Section 4.2", "η_M = 10: α = {text} (text), {caption} (caption).",
          "0.5", "0.5"),
    _same("fig-9a", "Figure 9, caption and Section 4.3", "η_M = 70, η_b = 0.05: d̂ = {text} (text), {caption} "
          "(caption of a).", "0.5:0.5:1.5", "0.5:0.5:1.5"),
    _same("fig-9b", "Figure 9, caption and Section 4.3", "η_M = 10: d̂ = {text} (text), {caption} (caption of b).",
          "1.5:1.5:4.5", "1.5:1.5:4.5"),
    _same("fig-10a", "Sections 4.3 and 5 (xi)", "η_b = {text} (Section 4.3, for Figure 10a), {caption} (Section 5 "
          "(xi)).", "0.04:0.01:0.99", "0.04:0.01:0.99"),
    _same("fig-11", "Figure 11, caption and Section 4.3", "η_M = 70: d̂ = {text} (text), {caption} (caption).",
          "0.5:0.5:1.5", "0.5:0.5:1.5"),
    _same("fig-12", "Figure 12, caption and Section 4.4", "One and two moving masses: d̂ = {text} (text), {caption} "
          "(caption).", "1:0.25:2", "0.5:0.5:1.5"),
    *(_same(f"fig-A.{figure}-list", f"Figure A.{figure}, caption and Appendix",
            f"η_M = 40, α = {alpha}: d̂ = {{text}} (text), {{caption}} (caption).", "0.5:0.5:4.5", "0.5:0.5:4.5")
      for figure, alpha in ((1, "0.5"), (2, "0.9"))),
    _same("fig-A.3-5-list", "Figures A.3 to A.5 and 11, captions", "η_M = 70, η_b = 0.05, d̂ = 0.5:0.5:1.5: α = "
          "{text} (Figure 11 a, b, c), {caption} (Figures A.3, A.4, A.5).", _VELOCITIES, _VELOCITIES),
    _same("fig-A-doubled", "Figures A.1 to A.5, captions and Appendix", "The doubled mass is shown for d̂ below "
          "{text} (text), left out from {caption} on (captions).", "1.5", "1.5"),
    _same("4.1-velocity", "Sections 4.1, 4.2 and 5", "The one velocity ratio of the earlier work is α = {text} "
          "(Sections 4.1 and 5), {caption} (Section 4.2).", "0.344", "0.34"),
)  # fmt: skip
