"""The motion of any vehicle on any track in time: forced part, residues at roots, an integral below the cuts."""
