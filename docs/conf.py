"""The site: `sphinx-build -W -b html docs docs/_build`, with the extra `docs` installed."""

import os
import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_extensions"))
# notebooks run in processes of their own: the numbers are the library's, of this moment
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from jupyter_cache import get_cache  # noqa: E402

import mpsolve  # noqa: E402

project = "mpsolve"
author = "the mpsolve developers"
copyright = author  # noqa: A001 — Sphinx asks for this name
version = release = mpsolve.__version__

extensions = ["myst_nb", "sphinx_copybutton", "sphinx_design", "mathml", "generated"]
exclude_patterns = ["_build", "_extensions", "jupyter_execute"]
nitpicky = False
suppress_warnings = ["mystnb.unknown_mime_type"]

myst_enable_extensions = ["dollarmath", "deflist", "colon_fence", "fieldlist"]
myst_heading_anchors = 3
nb_execution_mode = "cache"
nb_execution_cache_path = str(HERE / "_build" / ".jupyter_cache")
get_cache(nb_execution_cache_path).get_cache_limit()  # its tables are made before pages run side by side
nb_execution_timeout = 240
nb_execution_raise_on_error = True
nb_execution_show_tb = True
nb_merge_streams = True

html_theme = "pydata_sphinx_theme"
html_title = "mpsolve"
html_context = {"default_mode": "auto"}
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_show_sourcelink = False
html_copy_source = False
# pages without others below them have no side bar
html_sidebars: dict[str, list[str]] = {page: [] for page in ("index", "gallery/**", "genindex", "search")}
html_theme_options = {
    "navbar_end": ["theme-switcher"],
    "secondary_sidebar_items": ["page-toc"],
    "show_prev_next": True,
    "footer_start": ["copyright"],
    "footer_end": [],
}
