"""Studies of any size: certified or float64 results over grids, lists and random designs, kept in one file."""
