"""Tracks and vehicles with their sources, as data files; and the input file that they make together."""
