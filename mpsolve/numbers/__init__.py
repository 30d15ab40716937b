"""Numbers: exact ones, and what they are written as."""
