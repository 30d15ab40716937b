"""Certificates: proofs as files, what makes them, and verifiers that import nothing of the package."""
