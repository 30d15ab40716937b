"""Work in several processes, and linear algebra in one thread."""
