"""The whole sheet of masses at rest: close together, heavy or light, and forgeries of the way past branch points."""

from __future__ import annotations

import copy
from collections.abc import Callable
from functools import cache
from typing import Any

import pytest
from forging import as_file

from mpsolve import Case, certify
from mpsolve.certificate import verify2
from mpsolve.spectrum.spectrum import Spectrum


@cache
def answer(
    eta_b: str = "0.2477", eta_n: str = "0", eta_m: Any = ("1.987", "19.36"), gap: Any = "0.05051"
) -> Spectrum:
    """gap: between neighbours, or all places."""
    places = [str(float(gap) * j) for j in range(len(eta_m))] if isinstance(gap, str) else gap
    return certify(Case(alpha=0, eta_b=eta_b, eta_n=eta_n, eta_m=eta_m, positions=places), region="sheet", digits=20)


def judged(content: dict[str, Any]) -> verify2.Verdict:
    return verify2.verify_bytes(as_file(content))


@pytest.mark.parametrize(
    ("eta_b", "eta_n", "eta_m", "gap", "count"),
    [
        ("0.2477", "0", ("1.987", "19.36"), "0.05051", 4),
        ("0", "0", ("36.45", "0.5324"), "0.12395", 4),
        ("0.5", "0.0916", ("0.2511", "7.954", "0.9939", "1.145"), "0.01", 4),
        ("0.3", "0.2", ("0.0001", "0.00002", "0.001"), "0.05", 4),
        ("0.1", "-0.05", ("30", "40"), "0.003", 2),
        # a root 10⁻¹⁶ beside the branch point; one that floats must not take the branch point for
        (
            "0.3083",
            "0",
            ("0.00002758", "0.00002106", "0.00395", "0.00009178"),
            ("0", "0.06316", "0.16701", "1.26127"),
            4,
        ),
        ("0.5565", "0", ("0.0001643", "0.1242", "0.2119"), ("0", "5.60537", "5.65505"), 2),
    ],
)
def test_it_is_proved(eta_b: str, eta_n: str, eta_m: Any, gap: Any, count: int) -> None:
    found = answer(eta_b, eta_n, eta_m, gap)
    assert (found.proved, found.count, found.unstable) == (True, count, 0), found
    assert found.certificate.content["theorem"]["rest"]


def test_a_pair_that_moves_as_one_has_the_roots_of_their_sum() -> None:
    """d → 0: the low root of the pair tends to that of one mass; the other runs into the branch point."""
    pair, one = answer("0.1", "-0.05", ("30", "40"), "0.003"), answer("0.1", "-0.05", ("70",))
    low = [min((complex(root.q.mid()) for root in found.roots if root.q.real > 0), key=abs) for found in (pair, one)]
    assert low[0] == pytest.approx(low[1], rel=1e-4)


def _points(change: Callable[[list[Any]], list[Any]]) -> Callable[[dict[str, Any]], None]:
    def changed(content: dict[str, Any]) -> None:
        content["theorem"]["rest"] = change(content["theorem"]["rest"])

    return changed


def _earlier(content: dict[str, Any]) -> None:
    """From so far before the branch point that a real root lies between."""
    content["theorem"]["begin"] = content["theorem"]["rest"][0] = [1, -1]


def _beyond(content: dict[str, Any]) -> None:
    content["theorem"]["begin"] = content["theorem"]["rest"][0] = [5, -2]


def _moving(content: dict[str, Any]) -> None:
    content["equations"]["velocity"] = "1/1000000"


def _less(content: dict[str, Any]) -> None:
    content["claim"]["count"] -= 2
    content["roots"].pop()


def _heavier(content: dict[str, Any]) -> None:
    content["equations"]["vehicle"]["M"][0][0] = "2"


def _without(content: dict[str, Any]) -> None:
    del content["theorem"]["rest"]


FORGERIES: dict[str, tuple[str, Callable[[dict[str, Any]], None], str]] = {
    "one piece for all": ("0.2477", _points(lambda z: [z[0], z[-1]]), "may vanish"),
    "no first point": ("0.2477", _points(lambda z: z[1:]), "begins or ends elsewhere"),
    "another end": ("0.2477", _points(lambda z: z[:-1]), "begins or ends elsewhere"),
    "the other way": ("0.2477", _points(lambda z: z[::-1]), "begins or ends elsewhere"),
    "back and forth": ("0.2477", _points(lambda z: [*z[:-1], z[-2], z[-1]]), "another one"),
    "past a root": ("0", _earlier, ""),
    "a begin on the cut": ("0.2477", _beyond, "elsewhere"),
    "a load that moves": ("0.2477", _moving, "gap"),
    "a root too few": ("0.2477", _less, "roots"),
    "another mass": ("0.2477", _heavier, ""),
    "no way past": ("0.2477", _without, ""),
}


@pytest.mark.parametrize("name", FORGERIES)
def test_a_forgery_is_refused(name: str) -> None:
    eta_b, change, why = FORGERIES[name]
    content = copy.deepcopy(answer(eta_b).certificate.content)
    assert judged(content).valid
    change(content)
    found = judged(content)
    assert not found.valid
    assert why in found.reason
    assert not found.reason.startswith("malformed")


def test_too_many_points_are_refused() -> None:
    content = copy.deepcopy(answer().certificate.content)
    content["theorem"]["rest"] *= 100
    assert not judged(content).valid
