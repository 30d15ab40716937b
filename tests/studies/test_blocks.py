"""The results of a block: those of the library, packed without loss, sealed against damage."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from mpsolve import certify, frequencies, verify
from mpsolve.errors import StudyError
from mpsolve.numbers.balls import precision
from mpsolve.numbers.exact import Exact
from mpsolve.studies.blocks import Block, Result, Root, checked, key, pack, work
from mpsolve.studies.spec import read_spec

PAIR: dict[str, Any] = {"alpha": "0.67", "eta_b": "0.05", "eta_m": [70, 70], "positions": [0, "1.5"]}
TRACK = {
    "model": "two-layer", "EI": "6.38e6", "m": "60.2", "k_pad": "300e6", "c_pad": "3e4", "m_sleeper": 250,
    "k_ballast": "100e6", "c_ballast": "8e4",
}  # fmt: skip
MASSES = [{"model": "mass", "M": 900}, {"model": "mass", "M": 900, "position": "2.5"}]
SI: dict[str, Any] = {"v": 1400, "track": TRACK, "vehicle": MASSES}


def spec_of(kind: str, parameters: dict[str, Any], problem: dict[str, Any] | None = None, **study: Any) -> Any:
    problem = problem or {"dimensionless": PAIR}
    return read_spec({"study": {"kind": kind, **study}, **problem, "parameters": parameters})


def results(*arguments: Any, **study: Any) -> list[Result]:
    spec = spec_of(*arguments, **study)
    return [result for number in range(spec.blocks) for result in work(spec.text, number).results]


def around(value: str, radius: str) -> Any:
    """The ball of a decimal and a radius."""
    ball = lambda text: arb(fmpq(*Exact.parse(text).as_fraction().as_integer_ratio()))  # noqa: E731
    return ball(value) + arb(0, 1) * ball(radius)


def test_certified_results_are_those_of_certify(tmp_path: Path) -> None:
    (found,) = results("certified", {"v": 1420}, SI, digits=20, certificates=True)
    problem = spec_of("certified", {"v": 1420}, SI).problem(0)
    direct = certify(problem, region="unstable", digits=20)
    assert (found.status, found.count, found.unstable) == ("proved", direct.count, direct.unstable)
    assert found.count
    for root, ball in zip(found.roots, direct.roots, strict=True):
        with precision(200):
            assert root.re_radius is not None
            assert root.im_radius is not None
            assert around(str(root.re), root.re_radius).contains(ball.q.real)
            assert around(str(root.im), root.im_radius).contains(ball.q.imag)
            assert float(root.re_radius) < 1e-19 * abs(float(root.re))
    assert found.certificate is not None
    assert direct.certificate is not None
    assert found.certificate.text == direct.certificate.text
    assert verify(found.certificate.save(tmp_path / "case.json")).valid


def test_float64_results_are_those_of_frequencies_and_near_the_certified() -> None:
    parameters = {"v": [1000, 1420, 1500], "vehicles.M": [800, 1000]}
    found = results("float64", parameters, SI)
    problem = spec_of("float64", {"v": 1}, SI).base
    v, M = np.repeat([1000.0, 1420, 1500], 2), np.tile([800.0, 1000], 3)
    direct = frequencies(problem, {"v": v, "vehicles.M": M})
    assert [result.count for result in found] == direct.count.tolist()
    assert max(direct.count) > 0
    for result, q, proved in zip(found, direct.roots, results("certified", parameters, SI), strict=True):
        roots = np.array([complex(root.re, root.im) for root in result.roots])  # type: ignore[arg-type]
        assert np.array_equal(roots, q[np.isfinite(q)])
        assert (result.count, result.unstable) == (proved.count, proved.unstable)
        exact = np.array([complex(float(root.re), float(root.im)) for root in proved.roots])
        assert np.allclose(roots, exact, rtol=1e-9)


def test_counts_alone_and_other_regions() -> None:
    counts = results("float64", {"v": ["0.66", "0.67"]}, roots=False)
    assert [(r.count, r.unstable, r.roots) for r in counts] == [(0, 0, ()), (2, 2, ())]
    below = results("float64", {"v": ["0.66", "0.67"]}, region={"below": "0.04"})
    assert [r.unstable for r in below] == [0, 2]
    assert all((r.count or 0) > (r.unstable or 0) for r in below)
    sheet = results("float64", {"v": ["0.66", "0.67"]}, region="sheet")
    assert [(r.count, r.unstable) for r in sheet] == [(4, 0), (4, 2)]


def test_what_cannot_be_is_refused_with_its_reason() -> None:
    for kind in ("certified", "float64"):
        fine, buckled = results(kind, {"track.N": [0, 1]})
        assert fine.status != "refused"
        assert fine.reason == ""
        assert buckled.status == "refused"
        assert "buckles" in buckled.reason
        assert (buckled.count, buckled.unstable, buckled.roots) == (None, None, ())


decimals = st.from_regex(r"-?0\.[0-9]{15}[1-9]", fullmatch=True)
roots = st.builds(Root, decimals, decimals, st.just("1e-17"), st.just("1e-17"), st.integers(1, 3), st.just("none"))
floats = st.floats(-1e3, 1e3)
quick = st.builds(Root, floats, floats)
counts = st.none() | st.integers(0, 9)
reasons = st.text(max_size=20)

listed = st.builds(Result, st.just("proved"), reasons, counts, counts, st.lists(roots | quick, max_size=4).map(tuple))


@given(st.lists(listed, max_size=3))
@settings(max_examples=25)
def test_packing_loses_nothing(given_results: list[Result]) -> None:
    assert list(Block(0, "", pack(given_results), 0, "").results) == given_results


def test_the_key_tells_entries_and_questions_apart() -> None:
    def of(parameters: dict[str, Any], problem: dict[str, Any] | None = None, **study: Any) -> str:
        spec = spec_of("certified", parameters, problem, **study)
        return key(spec, [spec.values(0)])

    first = of({"v": "0.67"})
    others = [
        of({"v": "0.6700000001"}),
        of({"v": "0.67", "track.kp": "0.1"}),
        of({"v": "0.67"}, digits=16),
        of({"v": "0.67"}, region="sheet"),
        of({"v": "0.67"}, {"dimensionless": PAIR | {"eta_b": "0.06"}}),
    ]
    assert len({first, *others}) == 6
    assert of({"v": ["67/100", "0.7"]}) == first  # the entry, not the study


def test_damage_is_noticed(certified: dict[str, Any]) -> None:
    spec = read_spec(certified)
    block = work(spec.text, 1)
    assert len(checked(spec, block, "here")[1]) == 1
    spoilt = bytes([block.data[0] ^ 1]) + block.data[1:]
    damaged: list[Block] = [
        replace(block, data=spoilt),
        replace(block, number=2),
        replace(block, tally="{}"),
        replace(block, width=7),
        replace(block, key="0"),
        replace(block, number=2).sealed,  # whole, but of other entries
    ]
    for one in damaged:
        with pytest.raises(
            StudyError, match=r"here holds damaged results of the entries . to .: run the study again"
        ):
            checked(spec, one, "here")


def test_work_is_the_same_in_threads(certified: dict[str, Any]) -> None:
    from concurrent.futures import ThreadPoolExecutor

    text = read_spec(certified).text
    with ThreadPoolExecutor(4) as threads:
        blocks = list(threads.map(work, [text] * 8, [0, 1, 2, 3] * 2))
    assert blocks[:4] == blocks[4:] == [work(text, number) for number in range(4)]


def test_a_certified_entry_goes_to_its_worker_alone() -> None:
    """What is handed over does not grow with the study, and its block is the same."""
    parameters = {"v": ["1/3", "0.67"], "vehicles.M": [60, 70], "gap[0]": ["1", "1.5"]}
    spec = spec_of("certified", parameters)
    for number in (0, 5, spec.blocks - 1):
        assert work(*spec.job(number)) == work(spec.text, number)
    longer = spec_of("certified", parameters | {"v": [f"0.{k}1" for k in range(500)]})
    assert len(longer.job(7)[0]) < 500
    assert longer.text is longer.text
    quick_ = spec_of("float64", parameters)
    assert quick_.job(3) == (quick_.text, 3, 3)
