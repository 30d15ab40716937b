"""A problem: one track, vehicles at their places, one velocity; and its form for computation."""
