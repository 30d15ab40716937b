"""The motion in proved balls: image → path → far → panels → circles → enclosure."""
