"""What needs sympy: derivations from first principles, and the reading of anybody's own track."""
