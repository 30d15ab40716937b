"""Root loci: every induced frequency of a problem followed along one of its parameters, with proof."""
