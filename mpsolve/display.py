"""What results show of themselves: a result asks here for its card, and does not know how it is drawn.

This is the only module that imports what stands above it. It loads mpsolve/notebook.py when it is asked.
"""

from __future__ import annotations


def card(result: object) -> str:
    """The result in HTML, for a notebook."""
    from mpsolve import notebook

    return notebook.card(result)
