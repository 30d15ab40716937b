"""Pictures as SVG text for pages: they need no library, and take the colours of the page."""
