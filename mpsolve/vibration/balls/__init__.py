"""The motion in proved balls: image → strip and far, which admit the path → residues → integral → enclosure."""
