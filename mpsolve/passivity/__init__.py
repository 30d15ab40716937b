"""Beyond which frequency a moving track is passive at its contacts: a theorem about the track alone."""
