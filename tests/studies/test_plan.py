"""The section [study]: what is left out has its usual value, and a key of another kind is refused by name."""

from __future__ import annotations

from typing import Any

import pytest

from mpsolve.errors import InputError
from mpsolve.spectrum.regions import Below, Rectangle
from mpsolve.studies.plan import BOXES, read_plan, region_text

BOX = {"re_min": 0, "re_max": 1, "im_min": -1, "im_max": "1/7"}


def test_what_is_left_out() -> None:
    certified, floats, stable = (read_plan({"kind": kind}) for kind in ("certified", "float64", "stable"))
    assert (certified.digits, certified.region, certified.certificates, certified.design) == (
        15,
        "unstable",
        False,
        "grid",
    )
    assert (floats.roots, floats.count, floats.seed) == (True, 0, 0)
    assert (stable.certificates, stable.boxes) == (True, BOXES)


@pytest.mark.parametrize(("given", "kind"), [({"below": "0.1"}, Below), (BOX, Rectangle), ("sheet", str)])
def test_a_region_comes_back_from_its_text(given: Any, kind: type[Any]) -> None:
    region = read_plan({"kind": "certified", "region": given}).region
    assert isinstance(region, kind)
    assert read_plan({"kind": "certified", "region": region_text(region)}).region == region


@pytest.mark.parametrize(
    ("given", "key", "said"),
    [
        ({"kind": "certified", "boxes": 7}, "study.boxes", '"stable" only'),
        ({"kind": "float64", "certificates": True}, "study.certificates", '"certified" or "stable" only'),
        ({"kind": "stable", "roots": True}, "study.roots", '"float64" only'),
        ({"kind": "stabel"}, "study.kind", "did you mean"),
        ({"kind": "stable", "region": "sheet"}, "study.region", "unstable"),
        ({"kind": "stable", "design": {"kind": "random", "count": 3}}, "study.design", "by its parts"),
    ],
)
def test_what_cannot_be(given: dict[str, Any], key: str, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        read_plan(given)
    assert caught.value.key == key
