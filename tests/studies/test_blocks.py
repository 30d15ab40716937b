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

from mpsolve import Case, certify, verify
from mpsolve.errors import StudyError
from mpsolve.fast.frequencies import frequencies
from mpsolve.fields import ball_arithmetic
from mpsolve.numbers.exact import Exact
from mpsolve.studies.blocks import Block, Result, Root, checked, key, pack, unpack, work
from mpsolve.studies.spec import read_spec

PAIR: dict[str, Any] = {"alpha": "0.67", "eta_b": "0.05", "eta_m": 70, "d": "1.5"}


def results(kind: str, parameters: dict[str, Any], **study: Any) -> list[Result]:
    spec = read_spec({"study": {"kind": kind, **study}, "parameters": parameters})
    return [result for number in range(spec.blocks) for result in unpack(work(spec.text, number).data)]


def around(value: str, radius: str) -> Any:
    """The ball of a decimal and a radius."""
    ball = lambda text: arb(fmpq(*Exact.parse(text).as_fraction().as_integer_ratio()))  # noqa: E731
    return ball(value) + arb(0, 1) * ball(radius)


def test_certified_results_are_those_of_certify(tmp_path: Path) -> None:
    (found,) = results("certified", PAIR | {"mass_ratio": "1/2"}, digits=20, certificates=True)
    direct = certify(Case(alpha="0.67", eta_b="0.05", eta_m=(70, 35), positions=(0, "1.5")), digits=20)
    assert (found.status, found.count, found.unstable) == ("proved", direct.count, direct.unstable)
    for root, ball in zip(found.roots, direct.roots, strict=True):
        with ball_arithmetic(200):
            assert root.re_radius is not None
            assert root.im_radius is not None
            assert around(str(root.re), root.re_radius).contains(ball.q.real)
            assert around(str(root.im), root.im_radius).contains(ball.q.imag)
            assert float(root.re_radius) < 1e-19
    assert found.certificate is not None
    assert direct.certificate is not None
    assert found.certificate.text == direct.certificate.text
    assert verify(found.certificate.save(tmp_path / "case.json")).valid


def test_float64_results_are_those_of_frequencies_and_near_the_certified() -> None:
    parameters = PAIR | {"alpha": ["0.5", "0.67", "1.1"], "d": ["one mass", "1.5"]}
    found = results("float64", parameters)
    alpha, ratio = np.repeat([0.5, 0.67, 1.1], 2), np.tile([0.0, 1.0], 3)
    direct = frequencies(alpha, 0.05, 70.0, 1.5, mass_ratio=ratio)
    assert [result.count for result in found] == direct.count.tolist()
    assert [result.unstable for result in found] == direct.unstable.tolist()
    for result, q, proved in zip(found, direct.q, results("certified", parameters), strict=True):
        roots = np.array([complex(root.re, root.im) for root in result.roots])  # type: ignore[arg-type]
        assert np.allclose(roots, q[np.isfinite(q)], rtol=1e-12, atol=0)
        assert (result.count, result.unstable) == (proved.count, proved.unstable)
        exact = np.array([complex(float(root.re), float(root.im)) for root in proved.roots])
        assert np.allclose(roots, exact, rtol=1e-9, atol=1e-12)


def test_what_cannot_be_is_refused_with_its_reason() -> None:
    parameters = {"alpha": "0.5", "eta_b": ["0.05", 1], "eta_m": 40, "eta_n": [0, 1]}
    for kind, buckles, leaves in (("certified", "buckles", "from 1 on"), ("float64", "leaves", "leaves")):
        fine, buckled, overdamped, both = results(kind, parameters, masses=1)
        assert fine.status != "refused"
        assert fine.reason == ""
        assert {result.status for result in (buckled, overdamped, both)} == {"refused"}
        assert buckles in buckled.reason
        assert leaves in overdamped.reason
        assert (buckled.count, buckled.unstable, buckled.roots) == (None, None, ())


def test_all_cases_of_a_float64_block_may_be_refused() -> None:
    assert [r.status for r in results("float64", PAIR | {"eta_b": [2, 3]})] == ["refused", "refused"]


def test_an_overdamped_case_is_certified_where_im_q_is_below_0() -> None:
    (found,) = results("certified", {"alpha": "0.5", "eta_b": 1, "eta_m": 40}, masses=1, region="unstable")
    assert (found.status, found.count, found.unstable) == ("proved", 0, 0)


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
    assert list(unpack(pack(given_results))) == given_results


def test_the_key_tells_cases_and_questions_apart() -> None:
    def of(parameters: dict[str, Any], **study: Any) -> str:
        spec = read_spec({"study": {"kind": "certified", **study}, "parameters": parameters})
        return key(spec, [spec.values(0)])

    first = of(PAIR)
    others = [
        of(PAIR | {"alpha": "0.6700000001"}),
        of(PAIR | {"eta_s": "0.1"}),
        of(PAIR, digits=16),
        of(PAIR, region="unstable"),
        of(PAIR, masses=3),
    ]
    assert len({first, *others}) == 6
    assert of(PAIR | {"alpha": ["67/100", "0.7"]}) == first  # the case, not the study


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
        replace(block, number=2).sealed,  # whole, but of other cases
    ]
    for one in damaged:
        with pytest.raises(StudyError, match=r"here holds damaged results of the cases . to .: run the study again"):
            checked(spec, one, "here")


def test_work_is_the_same_in_threads(certified: dict[str, Any]) -> None:
    from concurrent.futures import ThreadPoolExecutor

    text = read_spec(certified).text
    with ThreadPoolExecutor(4) as threads:
        blocks = list(threads.map(work, [text] * 8, [0, 1, 2, 3] * 2))
    assert blocks[:4] == blocks[4:] == [work(text, number) for number in range(4)]


def test_a_certified_case_goes_to_its_worker_alone() -> None:
    """What is handed over does not grow with the study, and its block is the same."""
    parameters = {
        "alpha": ["1/3", "0.67"],
        "eta_b": ["0.05", "root4(1/100000)"],
        "eta_m": 40,
        "d": ["one mass", "1.5"],
    }
    spec = read_spec({"study": {"kind": "certified"}, "parameters": parameters})
    for number in (0, 5, spec.blocks - 1):
        assert work(*spec.job(number)) == work(spec.text, number)
    longer = read_spec(
        {"study": {"kind": "certified"}, "parameters": parameters | {"alpha": [f"0.{k}1" for k in range(500)]}}
    )
    assert len(longer.job(7)[0]) < 300
    assert longer.text is longer.text
    quick = read_spec({"study": {"kind": "float64"}, "parameters": parameters})
    assert quick.job(3) == (quick.text, 3, 3)
