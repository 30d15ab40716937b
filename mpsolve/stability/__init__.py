"""From which velocity, mass or distance on a case is unstable: crossings of the real axis, isolated and counted."""
