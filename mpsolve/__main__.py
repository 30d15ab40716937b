"""`python -m mpsolve` is the command `mpsolve`."""

from mpsolve.cli import main

if __name__ == "__main__":
    main()
