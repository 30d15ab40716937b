"""Steps of proofs, each of which knows no model."""
