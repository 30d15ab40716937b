"""The characteristic function of a problem: p-roots and their splitting, receptances, the determinant."""
