"""Every induced frequency of a problem in a region: counted, found, enclosed, and the two held against each other."""
