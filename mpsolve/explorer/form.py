"""The column of the page with a field and a slider for every parameter: what was typed and moved waits here."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from nicegui import ui

from mpsolve.explorer.knobs import ENDS, Knob, field_text, knobs
from mpsolve.explorer.session import Session

PARTS = {"v": "Velocity", "track": "Track", "vehicles": "Vehicle", "gap": "Gap"}


def heading(text: str) -> None:
    ui.label(text).classes("text-sm font-bold mt-3").props("role=heading aria-level=2")


class Form:
    """Fields and sliders; `pending` holds the changes that have not been taken yet, the last one of each path."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.pending: dict[str, object] = {}
        self.place = ui.column().classes("w-full gap-1")
        self.knobs: dict[str, Knob] = {}
        self.fields: dict[str, Any] = {}
        self.slid: set[str] = set()
        self.edited: set[str] = set()
        self.setting = ""

    def draw(self) -> None:
        """Anew, round the present values."""
        self.pending.clear()
        self.edited.clear()
        self.place.clear()
        self.fields.clear()
        values = self.session.fields()
        self.knobs = knobs(self.session.problem, values)
        part = ""
        with self.place:
            for path, value in values.items():
                if path.split(".")[0] != part:
                    part = path.split(".")[0]
                    heading(_told(part))
                quantity = self.session.problem.quantity(path)
                said = f"{quantity.meaning[:1].upper()}{quantity.meaning[1:]}" + (
                    f", {quantity.unit}" if quantity.unit else ""
                )
                without = f"left out: {quantity.without or 'none'}" if quantity.optional else ""
                self.fields[path] = (self._entry(path, said, _shown(value), without), self._slider(path, said))

    def _entry(self, path: str, said: str, value: str, without: str) -> Any:
        entry = ui.input(label=f"{said} ({path})", value=value, placeholder=without or None).classes("w-full")
        entry.props(f"dense for=field-{key(path)}" + (" stack-label" if without else ""))
        entry.on_value_change(lambda _: self.editing(path))
        entry.on("change", lambda _: self.typed(path, entry.value))
        entry.on("blur", lambda _: self.edited.discard(path))
        return entry

    def _slider(self, path: str, said: str) -> Any:
        slider = ui.slider(min=self.knobs[path].least, max=ENDS, value=0).classes("w-full")
        slider.props(f'id=slider-{key(path)} aria-label="{said}"')
        slider.on_value_change(lambda event: self.moved(path, event.value))
        return slider

    def taken(self) -> dict[str, object]:
        """What waited."""
        changes, self.pending = self.pending, {}
        return changes

    def editing(self, path: str) -> None:
        """A field is being typed in, which must not be overwritten."""
        if path != self.setting:
            self.edited.add(path)

    def typed(self, path: str, text: str) -> None:
        """A value from a field, with or without a unit."""
        self.edited.discard(path)
        self.pending[path] = text.replace(",", ".")
        self.slid.discard(path)

    def moved(self, path: str, position: float | None) -> None:
        """A value from a slider, which the page itself has not set."""
        if position is not None and path != self.setting:
            self.pending[path] = self.knobs[path].value(float(position))
            self.slid.add(path)

    def follow(self, path: str) -> None:
        """The field shows what the slider gave, unless it is typed in, and the slider stands where the field says."""
        entry, slider = self.fields.get(path, (None, None))
        value = self.session.problem.parameters.get(path)
        if entry is None:
            return
        self.setting = path
        if path not in self.edited and path not in self.pending:
            entry.set_value(_shown(value))
        if value is not None and path not in self.slid:
            slider.set_value(self.knobs[path].position(value))
        self.setting = ""


def _shown(value: Fraction | None) -> str:
    """Empty for what is left out."""
    return "" if value is None else field_text(value)


def key(path: str) -> str:
    """A path as part of an id."""
    return path.replace("[", "-").replace("]", "").replace(".", "-")


def _told(part: str) -> str:
    """What a group of fields is called."""
    name, _, rest = part.partition("[")
    return f"{PARTS.get(name, name)} {rest.rstrip(']')}".strip()
