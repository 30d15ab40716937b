"""Roots closer to a branch point than floats of q tell: against mpmath, and against a count of its own in floats."""

from __future__ import annotations

import json
from itertools import pairwise

import mpmath as mp
import pytest
from forging import as_file

from mpsolve import Case, certify
from mpsolve.certificate.verify2 import verify_bytes

LIGHT = {
    "one light mass": Case(alpha="0.5", eta_b="0.01", eta_m=["1e-5"], positions=[0]),
    "faster than the waves": Case(alpha="1.3", eta_b="0.05", eta_m=["6.04e-5"], positions=[0]),
    "undamped, in the gap": Case(alpha="0.5", eta_b=0, eta_m=["1e-6"], positions=[0]),
    "undamped, just faster": Case(alpha="1.0001", eta_b=0, eta_m=[70], positions=[0]),
}
PLACES = {
    "one light mass": ("0.5", "0.01", "1e-5"),
    "faster than the waves": ("1.3", "0.05", "6.04e-5"),
    "undamped, in the gap": ("0.5", "0", "1e-6"),
    "undamped, just faster": ("1.0001", "0", "70"),
}


class Own:
    """One mass on the paper's beam, D = p⁴/4 − (q − αp)² + 2iη(q − αp) + 1, in mpmath."""

    def __init__(self, alpha: str, eta: str, mass: str) -> None:
        self.a, self.eta, self.M = (mp.mpf(x) for x in (alpha, eta, mass))
        k = 1 - self.eta**2

        def edge(p: mp.mpf) -> mp.mpf:  # z(p) = αp + √(p⁴/4 + k) has its least value where p-roots meet
            return self.a + p**3 / (2 * mp.sqrt(p**4 / 4 + k))

        self.p = mp.findroot(edge, -self.a if self.a < 1.2 else -2 * self.a)
        self.z = abs(self.a * self.p + mp.sqrt(self.p**4 / 4 + k))
        self.k = k

    def scaled(self, zeta: mp.mpc, above: bool = False) -> mp.mpc:
        """ζ(1 − M q² G) at z = z_b + ζ² below the line of the cuts; above: of what is mirrored there."""
        z = self.z + zeta**2
        q = z - 1j * self.eta if above else z + 1j * self.eta
        c = [mp.mpf(1) / 4, 0, -(self.a**2), 2 * self.a * z, self.k - z**2]
        roots = sorted(mp.polyroots(c, maxsteps=100, extraprec=60), key=lambda p: -p.imag)[:2]
        G = 1j * sum(1 / (p**3 - 2 * self.a**2 * p + 2 * self.a * z) for p in roots)
        return zeta * (1 - self.M * q**2 * G)

    def number(self, least: mp.mpf, most: mp.mpf, above: bool = False) -> int:
        """Zeros with least < |ζ| < most in the quadrant of the sheet, the argument in steps below 0.5."""
        turn = mp.mpf("0.5") * mp.pi - mp.mpf("1e-9")
        corners = [least, most, most * mp.expj(-turn), least * mp.expj(-turn), least]
        total = mp.mpf(0)
        for a, b in pairwise(corners):
            way = mp.log(b / a)
            at = [a * mp.exp(way * j / 8) for j in range(9)]
            stack = [(x, y, self.scaled(x, above), self.scaled(y, above)) for x, y in pairwise(at)]
            while stack:
                x, y, f, g = stack.pop()
                step = mp.arg(g / f)
                if abs(step) < 0.5:
                    total += step
                    continue
                middle = mp.sqrt(x * y) if mp.re(mp.sqrt(x * y) / x) > 0 else -mp.sqrt(x * y)
                h = self.scaled(middle, above)
                stack += [(x, middle, f, h), (middle, y, h, g)]
        n = -total / (2 * mp.pi)
        assert abs(n - mp.nint(n)) < 1e-6
        return int(mp.nint(n))


@pytest.mark.slow  # p-roots to many digits, some hundred times; the next test is the quick one beside it
@pytest.mark.parametrize("name", ["faster than the waves", "undamped, just faster"])
def test_roots_next_to_branch_points_are_those_of_a_count_of_its_own(name: str) -> None:
    found = certify(LIGHT[name], region="sheet", digits=20)
    assert found.proved, found.reason
    with mp.workdps(24):
        own = Own(*PLACES[name])
        number = 0
        for above in (False, True):
            number += own.number(mp.mpf("1e-9"), mp.mpf("1e-4") * mp.sqrt(own.z), above)
        near = [
            root for root in found.roots if root.q.real > 0 and abs(complex(root.q.mid()).real - own.z) < 1e-6 * own.z
        ]
        assert len(near) == number > 0


@pytest.mark.parametrize("name", LIGHT)
def test_a_root_is_found_to_all_digits_of_its_distance(name: str) -> None:
    found = certify(LIGHT[name], region="sheet", digits=40)
    assert found.proved, found.reason
    with mp.workdps(90):
        own = Own(*PLACES[name])
        for root in found.roots:
            if not root.q.real > 0:
                continue
            text = [x.mid().str(70, radius=False) for x in (root.q.real, root.q.imag)]
            z, y = mp.mpf(text[0]), mp.mpf(text[1]) - own.eta
            if abs(z - own.z) > 1e-6 * own.z:
                continue
            zeta = mp.sqrt(mp.mpc(z - own.z, -abs(y)))
            value = own.scaled(zeta, above=y > 0)
            slope = (own.scaled(zeta * (1 + mp.mpf("1e-12")), y > 0) - value) / (zeta * mp.mpf("1e-12"))
            assert abs(value / slope) < mp.mpf("1e-20") * abs(zeta)


def test_a_certificate_with_a_small_loop_is_held_to_its_count() -> None:
    found = certify(LIGHT["one light mass"], region="sheet", digits=20)
    content = json.loads(found.certificate.text)
    assert content["bits"] > 64
    assert verify_bytes(found.certificate.text.encode()).valid

    def refused(change: dict[str, object]) -> None:
        assert not verify_bytes(as_file(content | change)).valid

    refused({"claim": content["claim"] | {"count": 0}, "roots": []})
    theorem = content["theorem"]
    loop = theorem["lower"][0]
    wider = loop | {"points": [[m, n, e + 6] if n else [m, n, e] for m, n, e in loop["points"]]}
    refused({"theorem": theorem | {"lower": [wider]}})
    refused({"theorem": theorem | {"lower": []}, "paths": content["paths"][:1] + content["paths"][2:]})
