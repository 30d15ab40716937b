"""Waves of the track alone: dispersion curves, and the velocities at which a moving force runs with a wave."""
