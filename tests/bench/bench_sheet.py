"""The whole sheet of masses on the paper's beam, 30 digits: the proof, and its verification beside it."""

from __future__ import annotations

from measure import median, seconds

from mpsolve import Case, certify
from mpsolve.certificate import verify2

MOST = {2: 0.15, 3: 0.4, 4: 0.8}
"""Seconds of a proof for so many masses, on one machine."""


def row(masses: int) -> Case:
    return Case(alpha="0.67", eta_b="0.05", eta_m=["70"] * masses, positions=[str(1.5 * j) for j in range(masses)])


def compare(masses: int, repeats: int = 5) -> float:
    """Seconds of the proof."""
    case = row(masses)
    found = certify(case, region="sheet", check=False)
    proof = median(lambda: certify(case, region="sheet", check=False), repeats)
    check = median(lambda: verify2.verify_bytes(found.certificate.text.encode("ascii")), repeats)
    print(
        f"{masses} masses   proof {seconds(proof)}   verification {seconds(check)}   {found.cost.pieces} pieces   "
        f"(goal: {MOST[masses]} s or less, and the verification no longer)"
    )
    return proof


def test_two_and_three_masses() -> None:
    assert compare(2, 3) < 10 * MOST[2]
    assert compare(3, 3) < 10 * MOST[3]


def main() -> None:
    for masses in MOST:
        compare(masses)


if __name__ == "__main__":
    main()
