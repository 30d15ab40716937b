"""Induced frequencies of very many cases at once, in float64: counted along the cut, followed from anchors."""
