"""Sections 4.3 and 4.4, conclusions (xi), (xii) as printed, for `onset`."""

from __future__ import annotations

from dataclasses import replace

from mpsolve.claims import Claim

from .onset import (
    critical_ends,
    critical_falls,
    curves_cross,
    limit_at,
    limit_at_critical,
    one_mass_first,
    one_window,
    onset_method,
)

_RANGE = {"alpha": ("0.99",), "eta_m": ("70",)}
_NAMED = ("0.04", "0.05", "0.1", "0.2", "0.5")  # damping ratios that Sections 4.3 and 5 name
_LIMIT = "At α = {alpha} with η_b = {eta_b} and d̂ = {d}, instability occurs for η_M ≥ {eta_m}."
_CURVES = "All presented curves cross the limit of α = 1 (η_b = {eta_b}, d̂ = {d})."
_BELOW = {"alpha": ("0.3", "0.5", "0.6", "0.7", "0.8", "0.9", "0.99")}
_XII_A = Claim(
    "xii-a", "Section 5 (xii)", _LIMIT, limit_at,
    {"alpha": ("0.99",), "eta_b": ("0.05",), "d": ("1.25",), "eta_m": ("21.9",)},
    {"other_eta_b": ("0.1",), "other_eta_m": ("36.4",), "dampings": _NAMED},
)  # fmt: skip

CLAIMS = (
    Claim(
        "xi", "Section 5 (xi), Section 4.3",
        "The critical distance (α = {alpha}, η_M = {eta_m}) is {distance} at the first and the last of η_b = "
        "{eta_b}.",
        critical_ends, {**_RANGE, "distance": ("1.25", "1.05"), "eta_b": ("0.04:0.01:0.99",)},
        {"steps": ("0.05", "0.1", "0.25")},
    ),
    *(
        Claim(
            f"xi-smooth-{part}", "Section 5 (xi), Section 4.3",
            "The critical distance is practically constant and only smoothly dependent on the damping: it "
            "falls smoothly.",
            critical_falls, {}, {**_RANGE, "eta_b": (values,)},
        )
        for part, values in (("low", "0.04:0.01:0.52"), ("high", "0.52:0.01:0.99"))
    ),
    Claim(
        "xi-window", "Section 4.3, Section 5 (xi)",
        "The critical distance is the distance for which the imaginary part of one of the induced frequencies is the "
        "lowest (and so the one to avoid).",
        one_window, {}, {**_RANGE, "eta_b": ("0.9", "0.95", "0.99"), "d": ("1.05", "2.1", "2.55")},
    ),
    _XII_A,
    replace(
        _XII_A, id="xii-b",
        printed={"alpha": ("0.99",), "eta_b": ("0.1",), "d": ("1.2",), "eta_m": ("36.4",)},
        at={"other_eta_b": ("0.05",), "other_eta_m": ("21.9",), "dampings": _NAMED},
    ),
    Claim(
        "4.3-limit", "Section 4.3, after Figure 10",
        "If the moving masses are at the critical distance, instability occurs in the subcritical velocity range "
        "even for a relatively low η_M and typical η_b; e.g., η_M = {eta_m} and η_b = {eta_b} (α = {alpha}).",
        limit_at_critical, {"alpha": ("0.99",), "eta_m": ("21.9",), "eta_b": ("0.1",)}, {"dampings": _NAMED},
    ),
    Claim(
        "fig-12-text", "Section 4.4, text before Figure 12", _CURVES, curves_cross,
        {"eta_b": ("0.05",), "d": ("1:0.25:2",)}, _BELOW,
    ),
    Claim(
        "fig-12-caption", "Section 4.4, Figure 12, by its caption", _CURVES, curves_cross,
        {"eta_b": ("0.05",), "d": ("0.5:0.5:1.5",)}, _BELOW,
    ),
    Claim(
        "fig-12-order", "Section 4.4, Figure 12",
        "Two masses have their onset of instability at a lower velocity than one (η_b = {eta_b}).",
        one_mass_first, {"eta_b": ("0.05",)}, {"eta_m": ("10", "40", "70", "100"), "d": ("0.5:0.5:2",)},
    ),
    Claim(
        "4.4-method", "Section 4.4",
        "It suffices to assume an induced frequency with a very low but negative imaginary part, and to repeat the "
        "analysis for the same but positive value, to confirm that the crossing of the {axis} axis has been "
        "detected.",
        onset_method, {"axis": ("imaginary",)},
        {"eta_b": ("0.05",), "eta_m": ("70",), "d": ("1.5",), "alpha": ("0.6669", "0.66692")},
    ),
)  # fmt: skip
