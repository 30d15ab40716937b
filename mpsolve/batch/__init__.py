"""Counts and roots of very many problems at once, in float64: any track, any vehicles, any number of contacts."""
