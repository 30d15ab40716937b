"""The characteristic function of a problem: p-roots split in two factors, receptances, the bordered determinant."""
