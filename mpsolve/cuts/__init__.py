"""Where roots reach the cuts of a beam's whole sheet as a parameter varies."""
