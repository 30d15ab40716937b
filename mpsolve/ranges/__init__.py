"""Stability over ranges of parameters: crossings of the real axis, onsets, unstable ranges, robustness."""
