"""The motion in proved balls: image → strip → far → panels → circles → enclosure."""
