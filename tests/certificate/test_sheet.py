"""The whole proof on the paper's cases: count, roots, stability, each root against (26), (37) by mpmath."""

from __future__ import annotations

import itertools
import random
from typing import Any

import pytest
from oracle import Truth, holds

from mpsolve import Case, InputError, Rectangle, Status
from mpsolve.certificate import verify
from mpsolve.certificate.sheet import SheetSpectrum as Spectrum
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.model.edge import edge_value
from mpsolve.numbers.rootball import Symmetry


def pair(alpha: Any, d: Any, eta_m: Any = 70, eta_b: Any = "0.05", **rest: Any) -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, d), **rest)


def single(alpha: Any, eta_m: Any = 70, eta_b: Any = "0.05") -> Case:
    return Case(alpha=alpha, eta_b=eta_b, eta_m=eta_m)


def checked(case: Case, **options: Any) -> Spectrum:
    """Certified; every root cross-checked, and the answers of the Spectrum held against each other."""
    found = certify(case, **options)
    assert found.proved, found.reason
    truth = Truth(case, 2 * found.digits + 10)
    for k, root in enumerate(found.roots):
        assert (root.q - root.q.mid()).abs_upper() <= 10.0**-found.digits * root.q.abs_upper()
        assert not any(root.q.overlaps(other.q) for other in found.roots[:k])
        if root.multiplicity == 1:
            exact = truth.root(truth.middle(root.q), 1e-12)
            assert holds(root.q, exact.real if root.symmetry is Symmetry.REAL else exact)
    assert found.count == sum(root.multiplicity for root in found.roots)
    assert found.unstable == sum(root.multiplicity for root in found.roots if root.q.imag < 0)
    keys = [(complex(r.q.mid()).real, complex(r.q.mid()).imag) for r in found.roots]
    assert keys == sorted(keys)
    return found


def positive(found: Spectrum) -> list[complex]:
    return [complex(root.q.mid()) for root in found.roots if root.q.real > 0]


# --- the paper's damped cases ------------------------------------------------------------------------------


@pytest.mark.parametrize(("d", "below", "above"), [("1", "0.96", "0.97"), ("1.5", "0.66", "0.67")])
def test_onset_of_instability_of_damped_pairs(d: str, below: str, above: str) -> None:
    """Section 4.3, η_M = 70, η_b = 0.05: proximate masses lose stability below the critical velocity."""
    assert checked(pair(below, d)).stable is True
    unstable = checked(pair(above, d))
    assert unstable.stable is False
    assert unstable.unstable == 2
    assert checked(pair(above, d), region="unstable").count == 2
    assert checked(pair(below, d), region="unstable").count == 0


@pytest.mark.parametrize("alpha", ["0.1", "0.5", "0.9"])
def test_the_single_mass_is_stable_below_the_critical_velocity(alpha: str) -> None:
    """Section 3: with damping a single mass is unstable in the supercritical range only."""
    assert checked(single(alpha)).stable is True


@pytest.mark.parametrize("eta_b", ["0", "0.05"])
def test_distance_zero_is_the_doubled_mass(eta_b: str) -> None:
    """(26): for d = 0 exactly; for a small d closely, and in number."""
    doubled = checked(single("0.5", 140, eta_b))
    merged = checked(pair("0.5", 0, eta_b=eta_b))
    near = checked(pair("0.5", "0.001", eta_b=eta_b), digits=15)
    assert [root.q.str(20) for root in merged.roots] == [root.q.str(20) for root in doubled.roots]
    assert merged.count == near.count == doubled.count == 2
    assert abs(positive(near)[0] - positive(doubled)[0]) < 1e-4


def test_a_large_distance_is_the_single_mass_twice() -> None:
    far, alone = checked(pair("0.5", 30)), checked(single("0.5"))
    (root,) = positive(alone)
    assert far.count == 2 * alone.count == 4
    assert all(abs(q - root) < 1e-6 for q in positive(far))


@pytest.mark.parametrize("d", [20, 40, 60, 100])
def test_the_count_is_explained_by_clusters(d: int) -> None:
    """At d = 100 a further pair has come down the cut, and 15 digits do not tell the close roots apart."""
    found = checked(pair("0.5", d), digits=15)
    assert found.count == (6 if d == 100 else 4)
    assert found.stable is True


@pytest.mark.parametrize(
    ("alpha", "eta_m", "axial"), [("0.9284", ("1.844",), "0.16"), ("1.0079", ("0.922", "5.147"), 0)]
)
def test_roots_on_both_sides_next_to_the_cut(alpha: str, eta_m: tuple[str, ...], axial: Any) -> None:
    """Just above α_C without damping q and q̄ differ by 1e-10 of their size, with the cut between them."""
    case = Case(alpha=alpha, eta_b=0, eta_m=eta_m, positions=(0, "0.142")[: len(eta_m)], eta_n=axial)
    found = checked(case)
    assert (found.count, found.unstable) == (4, 2)
    assert all(0 < abs(float(root.q.imag.mid())) < 1e-8 * float(abs(root.q).mid()) for root in found.roots)


def test_a_piece_that_the_verifier_takes_only_when_it_is_wider_is_cut() -> None:
    """Piece 163 of the first count: its neighbourhood passes, itself it does not."""
    assert checked(pair("1.4", "2.5", 10, 0), digits=15).count == 8


FAR_APART = [
    ("0.31", "0.4", 3, 30, 18),
    ("0.31", "0.4", 3, 60, 32),
    ("0.1", "0.6", 3, 100, 22),
    ("0.179", 0, "2.42", 50, 4),
]


@pytest.mark.parametrize(("alpha", "eta_b", "eta_m", "d", "roots"), FAR_APART)
def test_damped_masses_far_apart_have_roots_along_the_cut(
    alpha: str, eta_b: Any, eta_m: Any, d: int, roots: int
) -> None:
    """Waves run to and fro between them: a root close to the cut for each half wave, and two that nearly meet."""
    found = checked(pair(alpha, d, eta_m, eta_b), digits=15)
    assert found.count == roots
    singles = checked(Case(alpha=alpha, eta_b=eta_b, eta_m=eta_m)).roots
    for one in singles:
        near = [root for root in found.roots if abs(complex(root.q.mid()) - complex(one.q.mid())) < 1e-4]
        assert sum(root.multiplicity for root in near) == 2


@pytest.mark.parametrize(("alpha", "d"), [*itertools.product(["0.1", "0.5"], ["0.5", "1.5"])])
def test_the_pairs_lower_frequency_is_between_single_and_double(alpha: str, d: str) -> None:
    """Section 4.2, undamped, subcritical."""
    (alone,) = positive(checked(single(alpha, eta_b=0)))
    (double,) = positive(checked(single(alpha, 140, eta_b=0)))
    assert double.real < min(q.real for q in positive(checked(pair(alpha, d, eta_b=0)))) < alone.real


# --- the paper's undamped cases ----------------------------------------------------------------------------

UNDAMPED = list(
    itertools.product(
        ("0.1", "0.5", "0.9", "1.2", "1.4"), ("0.5", "1", "1.5", "2", "2.5", "3", "3.5", "4", "4.5"), (10, 40, 70)
    )
)
SAMPLE = random.Random(4).sample(UNDAMPED, 6)


def check_undamped(alpha: str, d: str, eta_m: int) -> None:
    """Section 4.2: stable exactly below α = 1; real roots, or complex ones in their four."""
    found = checked(pair(alpha, d, eta_m, eta_b=0), digits=15)
    assert found.stable is (float(alpha) < 1)
    assert found.count is not None
    balls = [root.q for root in found.roots]
    for root in found.roots:
        if root.symmetry is Symmetry.REAL:
            assert root.q.imag == 0
            assert float(alpha) < 1
        images = (-root.q, root.q.conjugate(), -root.q.conjugate())
        assert all(sum(image.overlaps(q) for q in balls) == 1 for image in images)
    if float(alpha) < 1:
        assert all(root.symmetry is Symmetry.REAL for root in found.roots)
        assert found.count in (2, 4)  # Section 3: two pairs at low velocities, one at higher ones
    else:
        assert found.count <= 8  # Section 3: at most four pairs until α = 1.4


@pytest.mark.parametrize(("alpha", "d", "eta_m"), SAMPLE)
def test_a_sample_of_the_undamped_cases(alpha: str, d: str, eta_m: int) -> None:
    check_undamped(alpha, d, eta_m)


@pytest.mark.slow
@pytest.mark.parametrize(("alpha", "d", "eta_m"), UNDAMPED)
def test_all_undamped_cases(alpha: str, d: str, eta_m: int) -> None:
    check_undamped(alpha, d, eta_m)


# --- standing loads, heavy damping, more masses ------------------------------------------------------------


@pytest.mark.parametrize("eta_b", ["0", "0.05"])
@pytest.mark.parametrize("axial", ["-0.3", "0", "0.2"])
@pytest.mark.parametrize(("eta_m", "positions"), [((70,), (0,)), ((70, 70), (0, "1.5"))])
def test_standing_loads(eta_b: str, axial: str, eta_m: tuple[int, ...], positions: tuple[Any, ...]) -> None:
    """α = 0: every mass on a beam at rest is stable, and has one pair of frequencies."""
    found = checked(Case(alpha=0, eta_b=eta_b, eta_n=axial, eta_m=eta_m, positions=positions), digits=15)
    assert found.stable is True
    assert found.count == 2 * len(eta_m)


OFF_THE_LINE = [
    {"alpha": "0.5", "eta_b": "1"},
    {"alpha": "1.5", "eta_b": "1.5"},
    {"alpha": "0.5", "eta_b": "1.5"},  # two lower p-roots are equal at q = 0
    {"alpha": "0.9", "eta_b": "0.6", "eta_n": "0.82"},
]


@pytest.mark.parametrize("values", OFF_THE_LINE)
def test_cuts_off_the_line_leave_the_unstable_region(values: dict[str, str]) -> None:
    """η_b ≥ 1, or η_N − η_S ≥ β."""
    case = Case(**values, eta_m=(70, 70), positions=(0, "1.5"))
    with pytest.raises(InputError, match='region="unstable"'):
        certify(case)
    found = checked(case, region="unstable", digits=15)
    assert found.count == found.unstable == 2
    truth = [q for q in Truth(case, 15).search(50.0) if q.imag < 0]
    assert 2 * len(truth) == found.count


def test_three_unequal_masses() -> None:
    case = Case(alpha="0.3", eta_b="0.2", eta_m=(10, 30, 5), positions=(0, 2, 5))
    assert checked(case, digits=15).count == 2 * len(Truth(case, 15).search(60.0))


def test_a_rectangle() -> None:
    case = pair("0.67", "1.5")
    found = checked(case, region=Rectangle("0.1", "0.2", "-0.1", "0"))
    assert found.count == 1
    assert found.stable is None


@pytest.mark.parametrize("digits", [15, 100])
def test_digits(digits: int) -> None:
    assert checked(pair("0.67", "1.5"), digits=digits).count == 4


# --- undecided, refused ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "values",
    [
        {"alpha": 1, "eta_b": 0},
        {"alpha": "0.5", "eta_b": "0.6", "eta_n": "0.55"},
        {"alpha": "0.8", "eta_b": 0, "eta_n": "0.36"},
    ],
)
def test_alpha_c_is_undecided(values: dict[str, str]) -> None:
    """α² = β − N exactly: the cuts touch in one point."""
    found = certify(Case(**values, eta_m=70))
    assert found.status is Status.UNDECIDED
    assert not found.proved
    assert found.count is found.unstable is found.stable is None
    assert "alpha_C" in found.reason
    assert "change alpha" in found.reason


@pytest.mark.parametrize("region", ["sheet", Rectangle("0.1", "0.2", "-0.1", "0.03")])
def test_the_effort_is_bounded(region: Any) -> None:
    found = certify(pair("0.67", "1.5"), max_pieces=3, region=region)
    assert found.status is Status.UNDECIDED
    assert "more than 3 pieces" in found.reason


@pytest.mark.parametrize(("eta_b", "eta_n"), [("0.9999999999999999", "0"), ("0", "0.9999999999999999")])
def test_effort_that_is_spent_is_not_spent_again(eta_b: str, eta_n: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither more bits nor another start would help: undecided after so many pieces, with what would."""
    pieces = [0]

    def value(track: Any, r: Any) -> Any:
        pieces[0] += 1
        return edge_value(track, r)

    monkeypatch.setattr("mpsolve.sheet.winding.edge_value", value)
    found = certify(Case(alpha="0.5", eta_b=eta_b, eta_n=eta_n, eta_m=(10, 10), positions=(0, 1)), max_pieces=300)
    assert found.status is Status.UNDECIDED
    helps = 'ask for the region "unstable", or raise max_pieces' if found.case.eta_b else "raise max_pieces"
    assert found.reason == f"the contour needs more than 300 pieces: {helps}"
    assert pieces[0] <= 302
    assert "raise" in found.reason
    assert found.roots == ()


def test_a_rectangle_over_the_cut_line_is_refused() -> None:
    """Beyond the gap |Re q| < q_lm only: within it there is no cut."""
    case = pair("0.5", "1.5", eta_b=0)
    with pytest.raises(InputError, match="cut line"):
        certify(case, region=Rectangle("0.1", 2, "-0.1", "0.1"))
    assert checked(case, region=Rectangle("0.1", "0.2", "-0.1", "0.1")).count == 2


@pytest.mark.parametrize("digits", [14, 0, -1, 10_001, 30.0, "30"])
def test_digits_out_of_range_are_refused(digits: Any) -> None:
    with pytest.raises(InputError, match="digits"):
        certify(single("0.5"), digits=digits)


@pytest.mark.parametrize("region", ["everything", None, (0, 1, 0, 1)])
def test_unknown_regions_are_refused(region: Any) -> None:
    with pytest.raises(InputError, match="region"):
        certify(single("0.5"), region=region)


CHECKED = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))


def test_proved_means_that_the_verifier_was_asked() -> None:
    found, quick = certify(CHECKED, digits=15), certify(CHECKED, digits=15, check=False)
    assert (found.status, found.status.value) == (Status.PROVED, "proved")
    assert (quick.status, quick.status.value) == (Status.UNVERIFIED, "proved, not verified")
    assert found.proved
    assert quick.proved
    assert (found.count, found.unstable) == (quick.count, quick.unstable) == (4, 2)
    assert (found.status.value, quick.status.value) == ("proved", "proved, not verified")


def test_what_the_verifier_refuses_is_not_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    """A proof that miscounts makes a certificate that the verifier, which counts by itself, does not take."""
    monkeypatch.setattr(verify, "count_on_edge", lambda *_: 6)
    found = certify(CHECKED, digits=15)
    assert not found.proved
    assert (found.count, found.unstable, found.stable) == (None, None, None)
    assert found.why is not None
    assert found.why.code == "not-verified"
    assert "the winding number is 6, but 4 roots are enclosed" in found.reason
