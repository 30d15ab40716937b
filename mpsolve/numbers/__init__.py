"""Numbers and their bounds: exact rationals, jets of discs in float64, balls."""
