"""Colours of the page, in light and in dark."""

from __future__ import annotations

from mpsolve.explorer import player
from mpsolve.pictures import axes as pictures

BLUE = "#1f5f99"
CSS = (
    pictures.STYLE
    + player.STYLE
    + """
:root { --blue: #0072b2; --red: #c44e00; --green: #00805f; --pink: #a8588a; --faint: #6d747b; --soft: #55606b; }
.body--dark { --blue: #64b5f0; --red: #ff9a57; --green: #4fd1a5; --pink: #e39ac6; --faint: #97a0a8; --soft: #a9b2bb; }
.q-btn { text-transform: none; }
#plane svg, #shape svg, #chart svg, #motion svg, #moving svg { max-width: 46rem; }
"""
)
