"""The motion of any vehicle on any track in time: image → path → steady → residues → integral → engine → vibrate.

The image is the transformed motion; the path says what of it comes as a residue and where the rest is integrated.
forcing.py has what acts and what it keeps up, residues.py the induced frequencies, integral.py what is left along
the path beside the cuts, in float64; precise.py has the same in mpmath, and the subpackage balls proves it, in the
same order.
"""
