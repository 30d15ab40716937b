"""The motion of the paper's beam in proved balls, by its own formulas: any number of masses, any place."""
