"""The whole sheet of masses on the paper's beam, 30 digits: the proof by the general engine against the older one.

Both in one process; the older one covers the edge of the cut with balls one by one. Verification stands beside.
"""

from __future__ import annotations

from measure import median, seconds

from mpsolve import Case, certify
from mpsolve.certificate import verify2
from mpsolve.certificate.sheet import certify_sheet

GOALS = {2: 1, 3: 10, 4: 50}


def row(masses: int) -> Case:
    return Case(alpha="0.67", eta_b="0.05", eta_m=["70"] * masses, positions=[str(1.5 * j) for j in range(masses)])


def compare(masses: int, repeats: int = 5) -> float:
    """How many times the older proof takes."""
    case = row(masses)
    found = certify(case, region="sheet", check=False)
    proof = median(lambda: certify(case, region="sheet", check=False), repeats)
    check = median(lambda: verify2.verify_bytes(found.certificate.text.encode("ascii")), repeats)
    older = median(lambda: certify_sheet(case, check=False), repeats if masses < 3 else 1)
    print(
        f"{masses} masses   proof {seconds(proof)}   verification {seconds(check)}   {found.cost.pieces} pieces   "
        f"older proof {seconds(older)}   ratio {older / proof:.1f} (goal: {GOALS[masses]})"
    )
    return older / proof


def test_two_and_three_masses() -> None:
    assert compare(2, 3) > 0.5 * GOALS[2]
    assert compare(3, 3) > GOALS[3]


def main() -> None:
    for masses in GOALS:
        compare(masses)


if __name__ == "__main__":
    main()
