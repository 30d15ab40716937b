"""The second way to the motion: any vehicle on a finite, simply supported track, expanded in sines."""
