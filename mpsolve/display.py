"""What results show of themselves: a result asks here for its card or its picture, and does not know how it is drawn.

This is the only module that imports what stands above it. It loads mpsolve/notebook.py when it is asked.
"""

from __future__ import annotations

from pathlib import Path


def card(result: object) -> str:
    """The result in HTML, for a notebook."""
    from mpsolve import notebook

    return notebook.card(result)


def save_picture(result: object, path: Path) -> Path:
    """Writes the picture of the result as .png, .svg or .pdf.

    Raises InputError if matplotlib is missing, CertificateError if the file cannot be written.
    """
    from mpsolve import notebook

    return notebook.save_picture(result, path)
