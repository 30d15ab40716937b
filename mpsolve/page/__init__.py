"""One page about one problem: for who decides, for the engineer, and for who wants the proof."""
