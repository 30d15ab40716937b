"""Cards show the numbers of the results, and the q-plane where all of it was counted."""

from __future__ import annotations

import re

import pytest

from mpsolve import Case, certify, notebook, response

PAIR = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))


@pytest.mark.parametrize("region", ["sheet", "unstable"])
def test_a_spectrum(region: str) -> None:
    found = certify(PAIR, region=region, digits=15, check=False)
    html = notebook.card(found)
    assert ("<svg" in html) == (region == "sheet")
    root = min(found.roots, key=lambda one: float(one.q.imag.mid())).q
    words = re.sub(r"<[^>]+>", " ", html)
    assert f"±{abs(float(root.real.mid())):.8f}" in words
    assert float(root.imag.mid()) == pytest.approx(-float(re.findall(r"−(0\.0000\d+)", words)[0]), rel=1e-7)


def test_a_response() -> None:
    found = response(PAIR, tau=[0, 1, 2])
    words = re.sub(r"<[^>]+>", " ", notebook.card(found))
    assert "not proved" in words
    assert f"{found.w[0].max():.6g}" in words

    assert notebook.card(found).count("<polyline") == 6  # two contacts, each between its envelopes
