"""Every zero of an analytic function in a region, with proof: no word of tracks or vehicles."""
