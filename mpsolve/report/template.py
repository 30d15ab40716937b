"""The templates, with every text escaped."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup


def rendered(name: str, **values: Any) -> str:
    """The template of this name in templates/ with these values."""
    return _environment().get_template(name).render(values)


_SYMBOL = re.compile(r"(?<!\w)(i?[ηαqvPωφ]\u0302?)_(lm|cr|[MCAf]\d*|[bNS])(?!\w)")


def with_subscripts(text: str) -> Markup:
    """The text, escaped, with the field's symbols as they are printed: η_b with a lowered b, and so on."""
    from markupsafe import Markup, escape

    return Markup(_SYMBOL.sub(r"\1<sub>\2</sub>", str(escape(text))))


@lru_cache(maxsize=1)
def _environment() -> Environment:
    from jinja2 import Environment, PackageLoader, StrictUndefined

    loader = PackageLoader("mpsolve.report")
    environment = Environment(
        loader=loader, autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters["symbols"] = with_subscripts
    return environment
