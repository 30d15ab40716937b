"""Where the folders that are still to be replaced look for it."""

from mpsolve.problem.casefile import InputFile, input_of, read_case, read_input

__all__ = ["InputFile", "input_of", "read_case", "read_input"]
