"""A figure of the page."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Picture:
    """A figure with its caption; name: of its element on the page."""

    name: str
    svg: str
    caption: str
