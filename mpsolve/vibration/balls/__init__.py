"""The motion in proved balls: image → far, which admits the path → residues → integral → work → enclosure."""
