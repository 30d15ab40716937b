"""The explorer: a local page on which a problem is changed and looked at, live in floats, and proved on request."""
