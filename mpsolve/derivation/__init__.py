"""Equations of motion from first principles, in sympy."""
