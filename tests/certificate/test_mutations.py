"""Certificates that were tampered with are refused at once, with a reason: by the digest, and by the mathematics.

Each change is tried as it stands, which the digest catches, and with the digest made anew, which leaves the
proof itself to refuse it.
"""

from __future__ import annotations

import copy
import json
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from mpsolve import Case, Rectangle
from mpsolve.certificate.format import digest
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.certificate.verify import Verdict, verify

Content = dict[str, Any]
Change = Callable[[Content], None]
DIGEST = "the digest does not fit the content"
SECONDS = 3  # of processor time


@cache
def original(kind: str) -> str:
    """Text of a valid certificate: two masses."""
    pair = {"eta_m": (70, 70), "positions": (0, "1.5")}
    rectangle = Rectangle("0.1", "0.2", "-0.01", "0.01")
    spectrum = {
        "sheet": lambda: certify(Case(alpha="0.67", eta_b="0.05", **pair)),
        "joined": lambda: certify(Case(alpha="1.2", eta_b="0.05", **pair)),
        "rectangle": lambda: certify(Case(alpha="0.67", eta_b="0.05", **pair), region=rectangle),
        "line": lambda: certify(Case(alpha="1.1", eta_b="1.7", **pair), digits=15, region="unstable"),
        "undamped": lambda: certify(Case(alpha="0.5", eta_b=0, **pair)),
        "rest": lambda: certify(Case(alpha=0, eta_b="0.1", **pair)),
    }[kind]()
    assert spectrum.certificate is not None
    return spectrum.certificate.text


def verdict(text: str | bytes, folder: Path) -> Verdict:
    """The verdict on a file with this content, which comes within seconds."""
    file = folder / "mutated.json"
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    started = time.process_time()
    result = verify(file)
    assert time.process_time() - started < SECONDS
    return result


def changed(kind: str, change: Change, renew_digest: bool) -> str:
    content = json.loads(original(kind))
    sha256 = content.pop("sha256")
    before = copy.deepcopy(content)
    change(content)
    assert json.dumps(content) != json.dumps(before)
    return json.dumps(content | {"sha256": digest(content) if renew_digest else sha256})


def setting(*path: Any, to: Any) -> Change:
    """Replace what stands at `path`."""

    def change(content: Content) -> None:
        for key in path[:-1]:
            content = content[key]
        content[path[-1]] = to

    return change


def moving(index: int, key: str, by: int) -> Change:
    """Add `by` units of the last binary digit to a root's coordinate."""

    def change(content: Content) -> None:
        content["roots"][index][key] = hex(int(content["roots"][index][key], 16) + by)

    return change


def moving_a_pair(content: Content) -> None:
    for index in (0, 3):
        moving(index, "im", 1)(content)


def dropping_roots(*indices: int, also_in_claim: bool) -> Change:
    def change(content: Content) -> None:
        content["roots"] = [root for k, root in enumerate(content["roots"]) if k not in indices]
        content["identity"] = [1] * len(content["roots"])
        if also_in_claim:
            content["claim"] = {"count": len(content["roots"])}

    return change


def adding(root: Content) -> Change:
    def change(content: Content) -> None:
        content["roots"].append(root)
        content["identity"].append(root["multiplicity"])
        content["claim"] = {"count": sum(content["identity"])}

    return change


def duplicating(content: Content) -> None:
    adding(dict(content["roots"][0]))(content)


def duplicating_a_little_wider(content: Content) -> None:
    """The same root again in the box that is twice as coarse."""
    twin = dict(content["roots"][0])
    twin["re"], twin["im"] = (hex(int(twin[key], 16) // 2) for key in ("re", "im"))
    adding(twin | {"exponent": twin["exponent"] + 1})(content)


def breaks(change: Callable[[list[Any]], list[Any]]) -> Change:
    """Change the breakpoints of the contour, the radius with them."""

    def apply(content: Content) -> None:
        content["contour"]["breaks"] = change(content["contour"]["breaks"])
        content["contour"]["radius"] = content["contour"]["breaks"][-1]

    return apply


def side(number: int, change: Callable[[list[Any]], list[Any]]) -> Change:
    def apply(content: Content) -> None:
        content["contour"]["sides"][number] = change(content["contour"]["sides"][number])

    return apply


def value(dyadic: list[Any]) -> float:
    return float(int(dyadic[0], 16)) * 2.0 ** int(dyadic[1])


ROOTS: dict[str, tuple[str, Change, str]] = {
    "a digit of a root": ("sheet", moving(3, "re", 1), "root 3: interval Newton"),
    "a digit of a mirrored root": ("sheet", moving(0, "im", -1), "root 0: interval Newton"),
    "a leading digit": ("sheet", moving(1, "im", 1 << 90), "root 1: interval Newton"),
    "both of a pair moved": ("sheet", moving_a_pair, "root 0: interval"),
    "another exponent": ("sheet", setting("roots", 2, "exponent", to=-90), "root 2"),
    "a root across the cut": ("sheet", setting("roots", 0, "im", to="0x" + "f" * 27), "root 0"),
    "a real root off its axis": ("undamped", moving(0, "im", 1), "root is off its axis"),
    "a real root moved": ("undamped", moving(3, "re", 1), "root 3: interval Newton"),
    "a real root with damping": (
        "sheet",
        lambda c: c["roots"][0].update(im="0x0", axis="real"),
        "root 0: a real root needs an undamped track",
    ),
    "wrong axis": ("sheet", setting("roots", 0, "axis", to="imaginary"), "root is off its axis"),
    "unknown axis": ("sheet", setting("roots", 0, "axis", to="negative"), "axis is unknown"),
    "wrong multiplicity": ("sheet", setting("roots", 0, "multiplicity", to=2), "Pellet's test"),
    "huge multiplicity": ("sheet", setting("roots", 0, "multiplicity", to=400), "multiplicity is not"),
    "no multiplicity": ("sheet", setting("roots", 0, "multiplicity", to=0), "multiplicity is not"),
    "a dropped root": ("sheet", dropping_roots(0, also_in_claim=False), "3 roots are enclosed"),
    "a pair dropped everywhere": ("sheet", dropping_roots(0, 3, also_in_claim=True), "winding number is 4, but 2"),
    "all roots dropped": ("joined", dropping_roots(*range(9), also_in_claim=True), "winding number is 4, but 0"),
    "a root on the line dropped": ("line", dropping_roots(0, also_in_claim=True), "winding number is 2, but 1"),
    "a root at rest dropped": ("rest", dropping_roots(0, also_in_claim=True), "winding number is 4, but 3"),
    "a root listed twice": ("sheet", duplicating, "root 4 overlaps another"),
    "a root listed twice, coarser": ("sheet", duplicating_a_little_wider, "root 4"),
    "an invented root": (
        "sheet",
        adding({"re": "0x12345", "im": "0x1", "exponent": -20, "multiplicity": 1, "axis": "none"}),
        "root 4: interval Newton",
    ),
    "another count": ("sheet", setting("claim", "count", to=6), "4 roots are enclosed"),
    "count as a truth value": ("sheet", setting("claim", "count", to=True), "4 roots are enclosed"),
    "another unstable number": ("sheet", setting("claim", "unstable", to=0), "2 roots have Im q < 0"),
    "another identity": ("sheet", setting("identity", to=[1, 1, 2]), "identity"),
    "a root outside of the rectangle": ("rectangle", setting("contour", "bounds", "re_max", to="3/20"), "root"),
}

PARAMETERS: dict[str, tuple[str, Change, str]] = {
    "another alpha": ("sheet", setting("case", "alpha", to="6700001/10000000"), "root 0: interval Newton"),
    "another eta_b": ("sheet", setting("case", "eta_b", to="500001/10000000"), "root 0: interval Newton"),
    "another mass": ("sheet", setting("case", "eta_m", 0, to="7000001/100000"), "root 0: interval Newton"),
    "another place": ("sheet", setting("case", "positions", 1, to="15000001/10000000"), "root 0: interval Newton"),
    "an axial force": ("sheet", setting("case", "eta_n", to="1/1000000"), "root 0: interval Newton"),
    "another root4": ("sheet", setting("case", "alpha", to="root4(1/5)"), "root 0"),
    "a mass less": ("sheet", lambda c: c["case"].update(eta_m=["70"], positions=["0"]), "root 0"),
    "a buckled beam": ("sheet", setting("case", "eta_n", to="1"), "root 0|buckles"),
    "places out of order": ("sheet", setting("case", "positions", to=["3/2", "0"]), "positions are not in order"),
    "no mass": ("sheet", lambda c: c["case"].update(eta_m=[], positions=[]), "no list of masses"),
    "a negative mass": ("sheet", setting("case", "eta_m", 0, to="-70"), "a mass is not positive"),
    "a negative alpha": ("sheet", setting("case", "alpha", to="-67/100"), "negative"),
    "a key missing": ("sheet", lambda c: c["case"].pop("eta_s"), "keys missing"),
    "a later version": ("sheet", setting("version", to=2), "version 2 is not known"),
    "an earlier version": ("sheet", setting("version", to=0), "version 0 is not known"),
    "another kind": ("sheet", setting("kind", to="stability chart"), "kind"),
}

CONTOURS: dict[str, tuple[str, Change, str]] = {
    "another radius": ("sheet", setting("contour", "radius", to=["0x101", 0]), "does not end at the radius"),
    "a smaller radius": ("sheet", breaks(lambda b: [x for x in b if value(x) < 3]), "far field"),
    "a smaller radius, joined": ("joined", breaks(lambda b: [x for x in b if value(x) < 3]), "far field"),
    "a smaller radius on the line": ("line", breaks(lambda b: [x for x in b if value(x) < 3]), "far field"),
    "the last piece missing": ("sheet", lambda c: c["contour"]["breaks"].pop(), "does not end at the radius"),
    "one single piece": ("sheet", breaks(lambda b: [b[0], b[-1]]), "piece 0"),
    "one single piece on the line": ("line", breaks(lambda b: [b[0], b[-1]]), "piece 0"),
    "many pieces merged": ("sheet", breaks(lambda b: [*b[:-1:40], b[-1]]), "piece"),
    "many pieces merged, joined": ("joined", breaks(lambda b: [*b[:-1:40], b[-1]]), "piece"),
    "a break beyond its neighbour": ("sheet", breaks(lambda b: [*b[:9], b[10], b[9], *b[11:]]), "not in order"),
    "a break twice": ("sheet", breaks(lambda b: [*b[:9], b[8], *b[9:]]), "not in order"),
    "a start on the cut": ("sheet", breaks(lambda b: [x for x in b if value(x) > 1]), "starts on the cut"),
    "a start on joined cuts": ("joined", breaks(lambda b: b[20:]), "starts on the cut"),
    "a start at 0 with cuts apart": ("sheet", breaks(lambda b: [["0x0", 0], *b]), "piece 0|not joined"),
    "a start above the branch point at rest": ("rest", breaks(lambda b: [x for x in b if value(x) > 1.2]), "branch"),
    "a start in the gap at rest": ("rest", breaks(lambda b: [["0x1", -1], *b]), "piece 0|branch point"),
    "a line that starts late": ("line", breaks(lambda b: b[9:]), "does not start at 0"),
    "a line for a sheet": ("line", setting("contour", "kind", to="edge"), "cuts are not on the line"),
    "a sheet for a line": ("sheet", setting("contour", "kind", to="line"), "not in Im q < 0"),
    "too few bits": ("sheet", setting("contour", "bits", to=20), "bits is not"),
    "no bits": ("sheet", lambda c: c["contour"].pop("bits"), "keys missing"),
    "a contour of another case": (
        "sheet",
        lambda c: c["contour"].update(json.loads(original("joined"))["contour"]),
        "piece|not joined",
    ),
    "two sides swapped": (
        "rectangle",
        lambda c: c["contour"].update(sides=[c["contour"]["sides"][k] for k in (1, 0, 3, 2)]),
        "",
    ),
    "a side missing": ("rectangle", lambda c: c["contour"]["sides"].pop(), "not four sides"),
    "a side in one piece": ("rectangle", side(1, lambda b: [b[0], b[-1]]), "side 1, piece 0"),
    "a side cut short": ("rectangle", side(2, lambda b: b[:-1]), "side 2 does not run from 0 to 1"),
    "a side that starts late": ("rectangle", side(3, lambda b: b[1:]), "side 3 does not run from 0 to 1"),
    "a rectangle across the cut": (
        "rectangle",
        lambda c: c["contour"]["bounds"].update(re_max="3", im_max="1"),
        "meet the cuts",
    ),
    "an empty rectangle": ("rectangle", setting("contour", "bounds", "re_min", to="1/5"), "root|not in order"),
}


@pytest.mark.parametrize("name", [*ROOTS, *PARAMETERS, *CONTOURS])
def test_a_change_is_refused_by_the_digest_and_by_the_mathematics(name: str, tmp_path: Path) -> None:
    kind, change, reason = (ROOTS | PARAMETERS | CONTOURS)[name]
    plain = verdict(changed(kind, change, renew_digest=False), tmp_path)
    assert not plain.valid
    assert plain.reason == DIGEST or plain.reason.startswith(("version", "the kind", "keys"))
    renewed = verdict(changed(kind, change, renew_digest=True), tmp_path)
    if reason or not renewed.valid:
        assert not renewed.valid
        assert renewed.reason != DIGEST
        assert any(part in renewed.reason for part in reason.split("|")), renewed.reason
    else:  # the change leaves a proof: then of the very same claim
        assert renewed.claim == verdict(original(kind), tmp_path).claim


def test_a_zero_of_the_continuation_across_the_cut_is_refused(tmp_path: Path) -> None:
    """A wide box below the cut that holds a zero next to it which lies above, hence not on the physical sheet.

    The true roots ±0.4404 + 0.0741i are left out for it, so that all numbers agree.
    """
    case = Case(alpha="0.6", eta_b="0.117578125", eta_m=(3, 3), positions=(0, "1.5"))
    certificate = certify(case, digits=15).certificate
    assert certificate is not None
    content = json.loads(certificate.text)
    assert content.pop("sha256")
    assert content["claim"]["count"] == 2
    zero = {"im": hex(60), "exponent": -9, "multiplicity": 1, "axis": "none"}  # 0.660543 + 0.117694i
    content |= {"roots": [{"re": hex(x), **zero} for x in (-338, 338)], "claim": {"count": 2}}
    result = verdict(json.dumps(content | {"sha256": digest(content)}), tmp_path)
    assert not result.valid
    assert "may meet a cut" in result.reason


@pytest.mark.parametrize("kind", ["sheet", "joined", "rectangle", "line", "undamped", "rest"])
def test_the_originals_are_valid(kind: str, tmp_path: Path) -> None:
    file = tmp_path / "original.json"
    file.write_text(original(kind))
    assert verify(file) == Verdict(True, "", verify(file).claim)


@pytest.mark.parametrize("index", [3, 40, -2])
def test_without_one_break_the_same_is_proved_or_nothing(index: int, tmp_path: Path) -> None:
    def change(content: Content) -> None:
        del content["contour"]["breaks"][index]

    result = verdict(changed("sheet", change, renew_digest=True), tmp_path)
    assert not result.valid or result.claim == verdict(original("sheet"), tmp_path).claim


def hostile(old: str, new: str) -> Callable[[], str]:
    def text() -> str:
        before = original("sheet")
        assert old in before
        return before.replace(old, new, 1)

    return text


HOSTILE: dict[str, Callable[[], str | bytes]] = {
    "empty": lambda: "",
    "no object": lambda: "[]",
    "a number": lambda: "7",
    "null": lambda: "null",
    "binary": lambda: bytes(range(256)) * 64,
    "UTF-16": lambda: original("sheet").encode("utf-16"),
    "not ASCII": hostile('"67/100"', '"６７/100"'),
    "truncated": lambda: original("sheet")[:-200],
    "cut in the middle": lambda: original("sheet")[: len(original("sheet")) // 2],
    "more after the end": lambda: original("sheet") + "{}",
    "deep nesting": lambda: "[" * 100_000 + "]" * 100_000,
    "deep nesting of objects": lambda: '{"case":' * 100_000,
    "deep nesting in its place": hostile('"67/100"', "[" * 50_000 + "]" * 50_000),
    "a key twice": hostile('"version": 1', '"version": 1, "version": 1'),
    "NaN": hostile('"count": 4', '"count": NaN'),
    "Infinity": hostile('"count": 4', '"count": -Infinity'),
    "a float": hostile('"count": 4', '"count": 4.0'),
    "a float with a huge exponent": hostile('"count": 4', '"count": 4e999999999'),
    "an integer of a million digits": hostile('"count": 4', '"count": ' + "4" * 1_000_000),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_text_is_refused(name: str, tmp_path: Path) -> None:
    result = verdict(HOSTILE[name](), tmp_path)
    assert not result.valid
    assert result.reason


BAD_NUMBERS = [
    "", "nan", "inf", "1/0", "-1/0", "0/0", "1/-2", "--1", "+1", "1e5", "0.5", " 1", "1\n", "٣", "0x10",
    "root4(-1)", "root4(1", "root4()", "1)", "root4(root4(2))", "1/3/5", "9" * 4400, "root4(" + "9" * 4301 + ")",
    "1/" + "9" * 100_000, 1, 0.5, None, True, [], {}, ["1"],
]  # fmt: skip


@pytest.mark.parametrize("bad", BAD_NUMBERS, ids=lambda x: repr(x)[:20])
def test_a_number_that_is_none_is_refused_wherever_it_stands(bad: Any, tmp_path: Path) -> None:
    for path in (("case", "alpha"), ("case", "eta_n"), ("case", "eta_m", 1), ("case", "positions", 0)):
        text = changed("sheet", setting(*path, to=bad), renew_digest=not isinstance(bad, float))
        result = verdict(text, tmp_path)
        assert not result.valid
        assert result.reason


WRONG_VALUES: dict[str, Change] = {
    "an immense mass": setting("case", "eta_m", 0, to="9" * 4000),
    "a mass next to nothing": setting("case", "eta_m", 0, to="1/" + "9" * 4000),
    "a root4 of an immense number": setting("case", "alpha", to="root4(" + "9" * 4000 + ")"),
    "an immense distance": setting("case", "positions", 1, to="9" * 4000),
    "a distance next to nothing": setting("case", "positions", 1, to="1/" + "9" * 4000),
    "more masses than allowed": lambda c: c["case"].update(eta_m=["1"] * 61, positions=["0"] * 61),
    "an immense mantissa": setting("roots", 0, "re", to="0x" + "f" * 40_000),
    "a mantissa beyond the limit": setting("roots", 0, "re", to="0x" + "f" * 1_000_000),
    "a mantissa in decimal": setting("roots", 0, "re", to="123"),
    "a mantissa as a number": setting("roots", 0, "re", to=123),
    "a mantissa in capitals": setting("roots", 0, "re", to="0xABC"),
    "an immense exponent": setting("roots", 0, "exponent", to=10**9),
    "an exponent of minus a billion": setting("roots", 0, "exponent", to=-(10**9)),
    "an exponent of 4000 digits": setting("roots", 0, "exponent", to=10**4000),
    "an exponent as text": setting("roots", 0, "exponent", to="-104"),
    "an exponent as a truth value": setting("roots", 0, "exponent", to=True),
    "a root at 0": setting(
        "roots", 0, to={"re": "0x0", "im": "0x0", "exponent": 0, "multiplicity": 1, "axis": "none"}
    ),
    "a root of any size": lambda c: c["roots"][0].update(re="-0x1", im="0x0", exponent=60),
    "a cluster at 0": lambda c: c["roots"][0].update(re="0x0", im="0x0", multiplicity=2),
    "roots as an object": setting("roots", to={}),
    "a root as a list": setting("roots", 0, to=[]),
    "a root with an unknown key": setting("roots", 0, "note", to="x"),
    "too many roots": lambda c: c.update(roots=c["roots"] * 200),
    "a break with an immense exponent": setting("contour", "breaks", -1, to=["0x1", 10**6]),
    "a break with an exponent at the limit": breaks(lambda b: [*b, ["0x1", 3000]]),
    "a break with an immense mantissa": setting("contour", "breaks", -1, to=["0x" + "f" * 30_000, 0]),
    "a negative break": breaks(lambda b: [["-0x1", 12], *b]),
    "a break as a number": setting("contour", "breaks", 3, to=1),
    "a break of three": setting("contour", "breaks", 3, to=["0x1", 0, 0]),
    "no breaks": setting("contour", "breaks", to=[]),
    "breaks without end": setting("contour", "breaks", to=[["0x1", 0]] * 500_001),
    "a contour as text": setting("contour", to="edge"),
    "a contour of an unknown kind": setting("contour", "kind", to="circle"),
    "an unknown key": setting("note", to="hello"),
    "an unknown key in the claim": setting("claim", "stable", to=True),
    "a claim of nothing": setting("claim", to={}),
    "a claim as a list": setting("claim", to=[4]),
    "a count as text": setting("claim", "count", to="4"),
    "an unstable number as null": setting("claim", "unstable", to=None),
    "an identity of texts": setting("identity", to=["1"] * 4),
    "a version as text": setting("version", to="1"),
    "a version as a truth value": setting("version", to=True),
}


@pytest.mark.parametrize("name", WRONG_VALUES)
def test_wrong_values_are_refused_with_a_digest_that_fits(name: str, tmp_path: Path) -> None:
    result = verdict(changed("sheet", WRONG_VALUES[name], renew_digest=True), tmp_path)
    assert not result.valid
    assert result.reason != DIGEST
    assert result.reason
    assert len(result.reason) < 500
