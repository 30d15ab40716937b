"""The verifier of version 2: counts against a float count, kernels against their integrals, forgeries refused."""

from __future__ import annotations

import copy
import itertools
import json
import subprocess
import sys
import time
from fractions import Fraction
from functools import cache
from math import pi
from pathlib import Path
from types import SimpleNamespace

import flint
import numpy as np
import planner as p
import pytest
from flint import acb, acb_mat, arb, arb_mat, fmpq, fmpq_mat, fmpq_poly
from forging import as_file

from mpsolve.certificate import verify2 as v2

LAYERS = p.two_layer(6380430, "60.2", 3 * 10**8, 3 * 10**4, 250, 10**8, 8 * 10**4)
PAPER = p.beam("1/4", 1, 1, "1/10")
UNDAMPED = p.beam("1/4", 1, 1, 0)
RAIL = p.beam("6.4e6", 60, 10**6, 770, 0, 0, "1e-4")
WIRE = p.string(27000, "1.07", 500, 2)
J, S = Fraction(7860) * Fraction("3.037e-5"), Fraction("0.393") * Fraction("80.769e9") * Fraction("76.70e-4")
TIMOSHENKO = p.timoshenko(6377700, "60.2", J, S, 10**6, 770)
BOGIE = (2615, 1476, 1813, "2.4e6", "3e4")
UNSTABLE = {"kind": "unstable"}


def row(n, gap="3/2"):
    return [i * Fraction(gap) for i in range(n)]


# name: track, velocity, vehicle, region, choices of the planner, known count
CASES = {
    "two-layer 600": (LAYERS, 600, p.masses([900, 900], [0, "5/2"]), UNSTABLE, {}, 0),
    "two-layer 680": (LAYERS, 680, p.masses([900, 900], [0, "5/2"]), UNSTABLE, {}, 2),
    "paper 1": (PAPER, "1/2", p.masses([40], [0]), UNSTABLE, {}, 0),
    "paper 2": (PAPER, "1/2", p.masses([40] * 2, row(2)), UNSTABLE, {}, 0),
    "paper 4": (PAPER, "1/2", p.masses([40] * 4, row(4)), UNSTABLE, {}, 0),
    "joined masses": (PAPER, "13/10", p.joined(2, 3, 1), UNSTABLE, {"rho": 3}, 1),  # one root has passed q = 0
    "joined masses, damped": (p.beam("1/4", 1, 1, 1), "13/10", p.joined(10, 10, "3/2"), UNSTABLE, {}, 1),
    "bogie, contact springs": (LAYERS, 600, p.bogie(*BOGIE, "1.5e9", "2.5"), UNSTABLE, {}, 0),
    "bogie, contact springs, 800": (LAYERS, 800, p.bogie(*BOGIE, "1.5e9", "2.5"), UNSTABLE, {}, 2),
    "bogie, tight": (LAYERS, 600, p.bogie(*BOGIE, None, "2.5"), UNSTABLE, {}, 0),
    "wire": (WIRE, 100, p.masses(["8.5"], [0]), {"kind": "disc", "radius": "40"}, {}, 0),
    "wire, faster than its waves": (WIRE, 200, p.masses(["8.5"], [0]), {"kind": "disc", "radius": "40"}, {}, 0),
    "Timoshenko 180": (TIMOSHENKO, 180, p.masses([10000] * 2, [0, "3.4"]), UNSTABLE, {}, 0),
    "Timoshenko 200": (TIMOSHENKO, 200, p.masses([10000] * 2, [0, "3.4"]), UNSTABLE, {}, 2),
    "Kelvin–Voigt 150": (RAIL, 150, p.masses([10000] * 2, [0, "3.4"]), UNSTABLE, {}, 0),  # onset 197.878
    "Kelvin–Voigt 220": (RAIL, 220, p.masses([10000] * 2, [0, "3.4"]), UNSTABLE, {}, 2),
    "below": (PAPER, "13/10", p.masses([40] * 2, row(2)), {"kind": "below", "height": "1/50", "reach": "3/2"}, {}, 2),
    "below, two-layer": (
        LAYERS,
        680,
        p.masses([900] * 2, [0, "5/2"]),
        {"kind": "below", "height": "20", "reach": "900"},
        {},
        2,
    ),
    "below disc": (
        PAPER,
        "13/10",
        p.masses([40] * 2, row(2)),
        {"kind": "below disc", "height": "1/50", "radius": "1"},
        {},
        2,
    ),
    "below, at rest": (
        PAPER,
        0,
        p.masses([40] * 2, row(2)),
        {"kind": "below", "height": "1/50", "reach": "3/2"},
        {},
        4,
    ),
    "rectangle": (
        PAPER,
        "13/10",
        p.masses([40] * 2, row(2)),
        {"kind": "rectangle", "re": ["-1/10", "3/5"], "im": ["-1/3", "1/50"]},
        {},
        1,
    ),
    "at rest": (LAYERS, 0, p.masses([900, 900], [0, "5/2"]), UNSTABLE, {}, 0),
}


@cache
def made(name):
    track, velocity, car, region, choices, _ = CASES[name]
    return json.dumps(p.plan(p.equations(track, velocity, car), region, **choices))


def content(name):
    return json.loads(made(name))


def verdict(value):
    return v2.verify_bytes(as_file(value))


@pytest.mark.parametrize("name", CASES)
def test_the_count_is_that_of_an_independent_float_contour(name):
    value, known = content(name), CASES[name][-1]
    said = verdict(value)
    assert said.valid, said.reason
    assert value["claim"]["count"] == known
    region, floats = v2.read_region(value["claim"]["region"]), p.Floats(value)
    if region.re:
        (a, b), (c, d) = ([float(arb(x)) for x in side] for side in (region.re, region.im))
        corners = [a + 1j * c, b + 1j * c, b + 1j * d, a + 1j * d, a + 1j * c]
        number = floats.turn([z for x, y in itertools.pairwise(corners) for z in np.linspace(x, y, 40)]) / (2 * pi)
    else:
        rho = float(arb(region.reach)) if region.reach is not None else 1.3 * last_real(value)
        number = floats.full_count(rho, float(arb(region.height)))
    assert abs(number - known) < 0.02


def last_real(value):
    return max(
        (abs(complex(v2.at_q(v2.point(z)))) for path in value["paths"] for z in path["points"]), default=1000.0
    )


def test_known_roots_and_words():
    said = verdict(content("two-layer 680")).claim
    assert "exactly 2 induced frequencies q with Im q < 0" in said
    assert "6380430 P^4" in said
    assert "velocity 680" in said
    odd = content("joined masses, damped")["roots"]
    assert len(odd) == 1
    assert not odd[0]["pair"]
    assert int(odd[0]["im"], 16) * 2.0 ** odd[0]["exponent"] == pytest.approx(-0.0852, abs=5e-5)


# --- forgeries ------------------------------------------------------------------------------------------------


def moved_digit(c):
    c["roots"][0]["re"] = hex(int(c["roots"][0]["re"], 16) + 2**24)


def dropped_root(c):
    c["roots"].pop()


def twice(c):
    c["roots"].append(c["roots"][0])


def wrong_count(c):
    c["claim"]["count"] += 2


def no_count(c):
    c["claim"]["count"], c["claim"]["unstable"], c["roots"] = 0, 0, []


def wrong_unstable(c):
    c["claim"]["unstable"] -= 2


def other_stiffness(c):
    c["equations"]["track"]["matrix"][1][1][0][2] = "200000000"


def other_velocity(c):
    c["equations"]["velocity"] = "600"


def other_mass(c):
    c["equations"]["vehicle"]["M"][0][0] = "700"


def other_place(c):
    c["equations"]["vehicle"]["places"][1] = "3"


def undamped(c):
    for line in c["equations"]["track"]["matrix"]:
        for entry in line:
            entry[:] = [t for t in entry if t[1] != 1]


def gap_in_path(c):
    del c["paths"][1]["points"][5:15]


def no_start(c):
    del c["paths"][0]["points"][0]


def jump(c):
    c["paths"][2]["points"] = c["paths"][2]["points"][1:]


def off_the_line(c):
    c["paths"][1]["points"][3] = ["50", "-1/2"]


def too_long(c):
    c["paths"][2]["points"] = [z for z in c["paths"][2]["points"] if v2.point(z)[0] == 0 or v2.point(z)[1] != 0][
        :1
    ] + c["paths"][2]["points"][-1:]


def backwards(c):
    c["paths"][1]["points"][4:6] = reversed(c["paths"][1]["points"][4:6])


def less_x(c):
    c["paths"][3]["points"] = c["paths"][3]["points"][:3]


def special_nodes(c):
    c["paths"][1]["special"] = [{"piece": 5, "nodes": [[1, 0, 0], [2, 0, 0]]}]


def more_absorption(c):
    c["theorem"]["blocks"][0][2][1] += 3


def less_envelope(c):
    c["theorem"]["envelope"][1] -= 3


def wider_block(c):
    c["theorem"]["blocks"][-1][1] = [1, 10]


def larger_alpha(c):
    c["theorem"]["alpha"] += 1


def other_region(c):
    c["claim"]["region"] = {"kind": "disc", "radius": "1000"}


def below_region(c):
    c["claim"]["region"] = {"kind": "below", "height": "1", "reach": "500"}


def alone(c):
    c["roots"][0]["pair"] = False


def double(c):
    c["roots"][0]["multiplicity"] = 2


def negative_damper(c):
    c["equations"]["vehicle"]["C"][0][0] = "-1"


def turned_into_links(c):
    c["paths"][2]["kind"] = "link"


FORGERIES = [
    moved_digit, dropped_root, twice, wrong_count, no_count, wrong_unstable, other_stiffness, other_velocity, other_mass, other_place,  # noqa: E501
    undamped, gap_in_path, no_start, jump, off_the_line, too_long, backwards, less_x, special_nodes, more_absorption,
    less_envelope, wider_block, larger_alpha, other_region, below_region, alone, double, negative_damper, turned_into_links,  # noqa: E501
]  # fmt: skip


@pytest.mark.parametrize("change", FORGERIES, ids=lambda f: f.__name__)
def test_a_forgery_is_refused(change):
    value = content("two-layer 680")
    before = copy.deepcopy(value)
    change(value)
    assert value != before
    said = verdict(value)
    assert not said.valid
    assert said.reason
    assert "Error" not in said.reason
    unsealed = v2.verify_bytes(json.dumps(value).encode())
    assert unsealed.reason == "the digest does not fit the content"


@pytest.mark.parametrize("name", ["below", "rectangle", "below disc"])
def test_a_region_larger_than_proved_is_refused(name):
    value = content(name)
    region = value["claim"]["region"]
    if name == "rectangle":
        region["im"][1] = "1/25"
    else:
        region["height"] = "1/25"
    assert not verdict(value).valid


def test_a_height_above_the_lowest_cut_is_refused():
    value = content("below disc")
    value["claim"]["region"]["height"] = "1/10"  # the cuts lie at Im q = 0.05
    assert "cut" in verdict(value).reason


HOSTILE = {
    "empty": b"",
    "text": b"hello",
    "not ASCII": '{"a": "é"}'.encode(),
    "list": b"[]",
    "deep": b"[" * 100_000,
    "float": b'{"format": 1.5}',
    "infinite": b'{"format": Infinity}',
    "long number": b'{"format": ' + b"9" * 100_000 + b"}",
    "twice": b'{"format": 1, "format": 1}',
    "version 1": b'{"format": "mpsolve certificate", "version": 1}',
    "large": b" " * (v2.MAX_BYTES + 1),
}


@pytest.mark.parametrize("raw", HOSTILE.values(), ids=HOSTILE)
def test_hostile_bytes_are_refused_quickly(raw):
    start = time.process_time()
    said = v2.verify_bytes(raw)
    assert not said.valid
    assert time.process_time() - start < 1


def set_at(path, value):
    def change(c):
        for key in path[:-1]:
            c = c[key]
        c[path[-1]] = value

    return change


PLACES = [
    ("bits",), ("start",), ("paths",), ("roots",), ("theorem",), ("basis",), ("claim",), ("equations",), ("claim", "count"), ("claim", "region"),  # noqa: E501
    ("paths", 0, "points"), ("paths", 1, "points", 2), ("paths", 1, "kind"), ("theorem", "gamma"), ("theorem", "blocks"), ("theorem", "blocks", 0),  # noqa: E501
    ("roots", 0), ("roots", 0, "re"), ("roots", 0, "radius"), ("roots", 0, "exponent"), ("equations", "track"), ("equations", "track", "matrix"),  # noqa: E501
    ("equations", "track", "matrix", 0, 0), ("equations", "track", "loaded"), ("equations", "velocity"), ("equations", "vehicle", "M"),  # noqa: E501
    ("equations", "vehicle", "places"), ("equations", "vehicle", "compliances"), ("equations", "vehicle", "B", 0),
]  # fmt: skip
VALUES = [
    None, True, 0, -1, 10**400, "", "1/0", "0x1", "9" * 400, [], [[]], {}, [0] * 30_000, [["1", 0]], {"kind": []}, [1, 10**6], [0, 0, 10**9],  # noqa: E501
    [2**300, 0], "nan",
]  # fmt: skip


@pytest.mark.parametrize("place", PLACES, ids=lambda x: ".".join(map(str, x)))
def test_odd_values_never_raise_and_are_refused_quickly(place):
    for new in VALUES:
        value = content("joined masses, damped")
        set_at(place, new)(value)
        if value == content("joined masses, damped"):
            continue
        start = time.process_time()
        said = verdict(value)
        assert not said.valid or place == ("basis",), new
        assert time.process_time() - start < 1


# --- parts -----------------------------------------------------------------------------------------------------


def test_the_precision_is_put_back():
    before = flint.ctx.prec
    flint.ctx.prec = 77
    try:
        assert verdict(content("paper 1")).valid
        assert not v2.verify_bytes(b"{}").valid
        assert flint.ctx.prec == 77
    finally:
        flint.ctx.prec = before


def test_signs_on_the_half_line():
    x = fmpq_poly([0, 1])
    assert v2.nonnegative((x - 1) ** 2, False)
    assert not v2.nonnegative((x - 1) ** 2, True)
    assert not v2.nonnegative((x - 1) * (x - 2), False)
    assert v2.nonnegative(x**2 - x + 1, True)
    assert not v2.nonnegative(fmpq_poly([]), False)
    assert not v2.nonnegative(-x, False)
    assert v2.nonnegative(x * (x - 3) ** 4 * (x**2 + 1), False)
    assert not v2.nonnegative(x * (x - 3) ** 3 * (x**2 + 1), False)


def test_bernstein_coefficients_hold_the_values():
    """In three variables, exact and in balls: the values lie between them, and ends of the box are met."""
    rng = np.random.default_rng(4)
    f = {tuple(map(int, e)): fmpq(int(c), 7) for *e, c in rng.integers(-4, 5, (9, 4)) % [4, 2, 3, 9]}
    box = tuple((fmpq(int(a), 3), fmpq(int(a + b), 3)) for a, b in zip((-2, 0, 1), (1, 4, 2), strict=True))
    exact, balls = (v2.bernstein(f, box, kind) for kind in (fmpq_mat, arb_mat))
    assert all(b.contains(a) for a, b in zip(exact, balls, strict=True))
    assert exact[0] == v2.at(f, [a for a, _ in box])
    assert exact[-1] == v2.at(f, [b for _, b in box])
    for _ in range(200):
        inside = v2.at(
            f, [a + (b - a) * fmpq(int(t), 16) for (a, b), t in zip(box, rng.integers(0, 17, 3), strict=True)]
        )
        assert min(exact) <= inside <= max(exact)


@pytest.mark.parametrize(
    ("f", "below", "holds"),
    [
        ({(2, 0): 1, (0, 2): 1, (1, 1): -1, (0, 0): fmpq(1, 1000)}, None, True),
        ({(2, 0): 1, (0, 2): 1, (1, 1): -1, (1, 0): -1, (0, 0): fmpq(1, 3)}, None, False),  # < 0 near (2/3, 1/3) only
        ({(2, 0): 1, (0, 2): 1, (1, 1): -2, (0, 0): fmpq(1, 3)}, None, True),
        ({(2, 0): 1, (1, 0): -1, (0, 0): fmpq(1, 4)}, None, False),  # 0 at x = 1/2
        ({(0, 0): fmpq(1, 2), (1, 1): -1}, None, False),
        ({(0, 0): fmpq(1, 2), (1, 1): -1}, fmpq(1, 4), True),
        ({(0, 0): fmpq(1, 2), (1, 1): -1}, fmpq(1, 2), False),
    ],
)
def test_positive_on_a_box(f, below, holds):
    f = {e: fmpq(c) for e, c in f.items()}
    unit = ((fmpq(0), fmpq(1)),) * 2
    if holds:
        v2.check_positive(f, unit, below, "f")
    else:
        with pytest.raises(v2.Refused, match="large q"):
            v2.check_positive(f, unit, below, "f")


def test_hurwitz_agrees_with_roots():
    rng = np.random.default_rng(5)
    seen = set()
    for _ in range(300):
        c = [int(k) for k in rng.integers(-2, 9, rng.integers(2, 6))]
        c[-1] = abs(c[-1]) + 1
        stable = bool(np.all(np.roots(c[::-1]).real < -1e-9))
        near = np.any(np.abs(np.roots(c[::-1]).real) < 1e-6)
        if not near:
            assert v2.damped(sum((k * v2.S_**j for j, k in enumerate(c)), v2.RING.constant(0)), True) == stable
            seen.add(stable)
    assert seen == {True, False}


def test_semidefinite_agrees_with_eigenvalues():
    rng = np.random.default_rng(6)
    for _ in range(60):
        a = rng.integers(-3, 4, (4, rng.integers(2, 6)))
        square = a @ a.T - int(rng.integers(0, 2)) * np.diag(rng.integers(0, 2, 4))
        least = np.linalg.eigvalsh(square)[0]
        assert v2.semidefinite(fmpq_mat([[int(x) for x in r] for r in square])) == (least > -1e-9)


@pytest.mark.parametrize(
    ("track", "velocity", "q"),
    [(LAYERS, 600, 300 - 40j), (PAPER, "1/2", 0.7 - 0.2j), (TIMOSHENKO, 180, 200 - 50j), (RAIL, 150, 90 - 9j)],
)
def test_kernels_hold_the_integral(track, velocity, q):
    """At a point, and at points of a disc, against sums over real wavenumbers in floats."""
    t = v2.read_track(track, str(velocity))
    unit = abs(np.sqrt(abs(q) / float(arb(t.v))) if t.v else 1.0)
    gaps, r = [fmpq(0), fmpq(3, 2)], abs(q) * 2e-3
    with v2.precision(64):
        waves = v2.Waves(t, [{(): x} for x in gaps])
        order = [float(gap.get((), 0)) for gap in waves.gaps]
        assert sorted(order) == [-1.5, 0.0, 1.5]

        def kernels(sigma, radius):
            local = waves.near(v2.Place.disc(acb(sigma), arb(radius)))
            return v2.kernels(waves, [v2.Apart.of(local, *v2.sorted_roots(local))])[0][0]

        thin = kernels(1j * q, 0).k[0]
        over = kernels(1j * q, r)
        for u in (0, 1, -1, 1j, 0.6 - 0.8j):
            for a, b, rest, exact in zip(*over.k, over.e, kernels(1j * q + u * r, 0).k[0], strict=True):
                assert abs(a + b * acb(complex(u)) - exact).lower() <= rest.upper() * (1 + 1e-12)
                assert exact.rad() < 1e-9 * abs(complex(exact))
                assert rest < 0.05 * abs(complex(a))
    D, N = t.d, t.n
    for xi, ball in zip(order, thin, strict=True):
        P = np.linspace(-4000, 4000, 400_001) * unit / 40
        values = sum(float(arb(c)) * (1j * P) ** i * (1j * q) ** j for (i, j), c in N.items()) / sum(
            float(arb(c)) * (1j * P) ** i * (1j * q) ** j for (i, j), c in D.items()
        )
        truth = np.trapezoid(values * np.exp(1j * P * xi), P) / (2 * pi)
        assert abs(truth - complex(ball)) < 2e-3 * max(abs(complex(b)) for b in thin)


@pytest.mark.parametrize(("track", "velocity", "q"), [(LAYERS, 600, 300 - 40j), (PAPER, "1/2", 0.7 - 0.2j)])
def test_neighbouring_discs_are_linked_by_the_pair_at_their_common_point(track, velocity, q):
    """a_k = U(z_k)/U₀'(z_k) of float p-roots lies in its ball; a pair with two p-roots exchanged is not linked."""
    t, r, linked = v2.read_track(track, str(velocity)), abs(q) * 4e-2, 0
    columns = [
        sum(float(arb(c)) * (1j * q + 1j * r) ** j for (i, j), c in t.d.items() if i == n)
        for n in range(t.degree + 1)
    ]
    roots = np.roots(columns[::-1])
    with v2.precision(64):
        waves = v2.Waves(t, [{}])

        def over(m):
            return waves.near(v2.Place.disc(acb(m), arb(r * (1 + 2**-12))))

        one, common = v2.nodes_near(over(1j * q)).split(), acb(1j * q + 1j * r)
        two = v2.split_near(over(1j * q + 2j * r), one.near(common))
        for split in (one, two):
            z, up = np.array([complex(x) for x in split.nodes.z]), split.nodes.up
            for k, (a, tight) in enumerate(zip(split.pair(common), split.tight, strict=True)):
                side, own = (roots.real < 0, z[:up]) if k < up else (roots.real > 0, z[up:])
                true = np.prod(z[k] - roots[side]) / np.prod([z[k] - x for x in own if x != z[k]])
                assert abs(true - complex(a)) <= 2 * float(a.rad()) + 1e-9 * abs(z[k])
                assert a.rad() < 0.3 * tight
        assert two.links(one, common)
        z, up = list(two.nodes.z), two.nodes.up
        for i, k in itertools.product(range(up), range(up, len(z))):
            other = [*z]
            other[i], other[k] = z[k], z[i]
            try:
                wrong = v2.Nodes(other, up, two.nodes.local).split()
            except v2.Refused:
                continue
            assert not wrong.links(one, common)
            linked += 1
    assert linked > 1


def test_a_double_p_root_is_refused_soon_however_many_digits_are_asked_for():
    with v2.precision(30_000):
        D = acb_mat([[x] for x in fmpq_poly([1, -2, 1]) ** 4 * fmpq_poly([3, 1])])
        start = time.process_time()
        with pytest.raises(v2.Refused, match="p-roots meet"):
            v2.p_roots(SimpleNamespace(D=D, degree=9))
        assert time.process_time() - start < 1
        D = acb_mat([[x] for x in fmpq_poly([1, fmpq(-2) - fmpq(1, 2**90), 1])])  # as close as 2^−45
        p = v2.p_roots(SimpleNamespace(D=D, degree=2))
        assert all(abs(x * x - D[1, 0].abs_upper() * x + 1) < arb(2) ** -14_000 for x in p)


def test_p_roots_of_one_side_that_meet_are_refused():
    """On the imaginary axis two p-roots of one side of a string meet: no residue is known over a disc there."""
    t = v2.read_track(WIRE, "200")
    with v2.precision(64):
        waves = v2.Waves(t, [{}, {(): fmpq(1)}])
        local = waves.near(v2.Place.disc(acb(15.5863), arb(0.5)))
        assert v2.Nodes([acb(0.1), acb(0.35)], 0, local).split()
        with pytest.raises(v2.Refused, match="not told apart"):
            v2.Apart.of(local, [acb(0.1), acb(0.35)], 0)


@pytest.mark.parametrize("seed", range(12))
def test_p_roots_over_a_disc_lie_in_their_discs_and_hold_together_with_the_pair(seed):
    """Against roots in floats at points of the disc; a root taken for one of the other side is seen."""
    rng = np.random.default_rng(seed)
    track, velocity, q = [(LAYERS, 600, 300 - 40j), (PAPER, "1/2", 0.7 - 0.2j), (RAIL, 150, 90 - 9j)][seed % 3]
    t, r = v2.read_track(track, str(velocity)), abs(q) * 10.0 ** rng.uniform(-4, -0.8)
    with v2.precision(64):
        waves = v2.Waves(t, [{}])
        local = waves.near(v2.Place.disc(acb(1j * q), arb(r)))
        z, up = v2.sorted_roots(local)
        split = v2.Nodes(z, up, local).split()
        try:
            found = v2.Apart.of(local, z, up)
        except v2.Refused:
            assert r > abs(q) * 0.02
            return
        for u in [0, *np.exp(2j * pi * rng.uniform(size=6))]:
            sigma = 1j * q + r * u
            c = [sum(float(arb(x)) * sigma**j for (i, j), x in t.d.items() if i == k) for k in range(t.degree + 1)]
            for root in np.roots(c[::-1]):
                inside = [k for k, (x, e) in enumerate(zip(found.z, found.e, strict=True))
                          if abs(root - complex(x)) <= float(e) + 1e-9 * abs(root)]  # fmt: skip
                assert len(inside) == 1
        thin = v2.apart_near(waves.near(v2.Place.disc(acb(sigma), arb(0))), found.near(acb(sigma)))
        assert split.holds(thin)
        assert found.holds(thin)
        order = [up, *range(1, up), 0, *range(up + 1, len(z))]
        swapped = v2.Apart(
            thin.local, *([x[k] for k in order] if isinstance(x, list) else x for x in (thin.z, up, thin.e)), [], []
        )
        assert not found.holds(swapped)
        assert not split.holds(swapped)
        assert not found.holds(v2.Apart(thin.local, thin.z, up - 1, thin.e, [], []))


def exchanged(found):
    """The same p-roots, one of each side taken for one of the other."""
    order = [found.up, *range(1, found.up), 0, *range(found.up + 1, len(found.z))]
    z, e = ([x[k] for k in order] for x in (found.z, found.e))
    return v2.Apart(found.local, z, found.up, e, *found.local.about(z, found.local.D))


def begun(track=PAPER):
    """A walker for one mass, its p-roots at a point with Im q < 0, and the mark there."""
    eq, at = p.equations(track, "1/2", p.masses([40], [0])), (fmpq(1), fmpq(-1, 10))
    car, track = v2.read_vehicle(eq["vehicle"], None), v2.read_track(eq["track"], eq["velocity"])
    walker = v2.Walker(waves := v2.Waves(track, car.places), v2.Bordered(car, waves))
    local = walker.near(v2.at_q(at))
    walker.marks[at] = mark = v2.Mark(at, v2.Apart.of(local, *v2.sorted_roots(local)))
    return walker, mark


@pytest.mark.parametrize("kind", ["link", "turn", "passive"])
def test_a_piece_that_goes_on_from_another_pair_is_refused(kind):
    """One root of each side exchanged at the mark where a piece begins, in a disc of p-roots or of a pair."""
    with v2.precision(64):
        walker, mark = begun()
        z, up = mark.known.z, mark.known.up
        over = walker.waves.near(v2.Place.disc(mark.sigma, arb("0.02")))
        found = (v2.split_near if kind == "link" else v2.apart_near)(over, (z, up))
        right = v2.Apart.of(over, z, up)
        for one, fine in ((right, True), (exchanged(right), False)):
            for known in (one, v2.Nodes(one.z, up, over).split()):
                assert walker.joins(v2.Mark(mark.q, known), found) is fine
        right = mark.known.near
        mark.known = mark.thin = exchanged(mark.known)
        mark.known.near = right  # else the piece goes on with the roots exchanged
        with pytest.raises(v2.Refused, match="join on"):
            walker.chain(kind, [mark.q, (fmpq(1), fmpq(-1, 11))])
        mark.thin = None
        with pytest.raises(v2.Refused, match="join on"):
            walker.thin(mark)


def test_a_loop_once_round_a_branch_point_does_not_come_back():
    """Twice it does: the two p-roots that meet there are exchanged once."""
    content = json.loads((CERTS / "undamped_subcritical.json").read_bytes())
    (value,) = content["theorem"]["lower"][:1]
    (loop,) = v2.read_loops([value])
    track = v2.read_track(content["equations"]["track"], content["equations"]["velocity"])
    vehicle = v2.read_vehicle(content["equations"]["vehicle"], None)
    with v2.precision(64):
        walker = v2.Walker(waves := v2.Waves(track, vehicle.places), v2.Bordered(vehicle, waves))
        walker.begin(v2.dyadic(content["start"], "start"))
        for path in v2.read_paths(content["paths"][:2], "link turn"):
            walker.path(path)
        beside = acb(0, 1) * arb(loop.centre)
        near = min(
            itertools.combinations(v2.p_roots(walker.near(beside)), 2), key=lambda two: abs(complex(two[0] - two[1]))
        )
        pole = acb(0, (near[0] + near[1]).imag / 2).mid()
        half = v2.Loop(loop.centre, loop.radius, loop.points[: len(loop.points) // 2 + 1])
        assert half.points[0] == half.points[-1]
        with pytest.raises(v2.Refused, match="come back"):
            walker.around(half, pole)
        walker.around(loop, pole)


def test_p_roots_in_discs_that_meet_are_refused():
    for e, fine in (("0.04", True), ("0.06", False)):
        with v2.precision(64):
            if fine:
                assert v2.Apart(None, [acb(0), acb("0.1")], 1, [arb(e)] * 2, [], []).sides == [range(1), range(1, 2)]
            else:
                with pytest.raises(v2.Refused, match="not told apart"):
                    v2.Apart(None, [acb(0), acb("0.1")], 1, [arb(e)] * 2, [], [])


def test_a_disc_on_which_the_highest_coefficient_vanishes_is_refused():
    """(σ − 1)P² − 1: at σ = 1 its roots are at infinity."""
    d = {(2, 1): fmpq(1), (2, 0): fmpq(-1), (0, 0): fmpq(-1)}
    waves = v2.Waves(SimpleNamespace(d=d, n={(0, 0): fmpq(1)}, degree=2), [{}])
    for r, fine in (("0.3", True), ("1.1", False), ("30", False)):
        with v2.precision(64):
            local = waves.near(v2.Place.disc(acb(2), arb(r)))
            if fine:
                assert v2.Apart.of(local, [acb(-1), acb(1)], 1).sided
            else:
                with pytest.raises(v2.Refused, match="highest coefficient"):
                    v2.Apart.of(local, [acb(-1), acb(1)], 1)


def test_no_root_is_proved_where_a_p_root_may_be_real():
    """On the edge of the cut of an undamped beam."""
    with v2.precision(64):
        walker, _ = begun(track=UNDAMPED)
        for q, stated in (((fmpq(3), fmpq(0)), "real"), ((fmpq(3), fmpq(-1, 10)), "as many roots")):
            with pytest.raises(v2.Refused, match=stated):
                v2.check_root(
                    walker.waves.track, walker.bordered.vehicle, v2.Root(q, fmpq(1, 10**9), 1, False, 60), walker
                )


def test_many_digits():
    value = p.refine(content("two-layer 680"), 1000)
    said = verdict(value)
    assert said.valid, said.reason
    value["roots"][0]["im"] = hex(int(value["roots"][0]["im"], 16) + 256)
    assert not verdict(value).valid


def test_two_roots_in_one_ball():
    """Two masses far apart at rest have two nearly equal frequencies: one ball of multiplicity two holds both."""
    car = p.masses([40, 40], [0, 12])
    value = p.plan(p.equations(PAPER, 0, car), {"kind": "below", "height": "1/50", "reach": "3/2"})
    roots = value["roots"]
    assert [r["pair"] for r in roots] == [True, True]
    a, b = (complex(int(r["re"], 16), int(r["im"], 16)) * 2.0 ** r["exponent"] for r in roots)
    middle = p.as_root((a + b) / 2, True, 2.0**-30)
    radius = abs(a - b)
    e = int(np.ceil(np.log2(radius)))
    for multiplicity, valid in ((2, True), (1, False), (3, False)):
        value["roots"] = [middle | {"radius": [1, e], "multiplicity": multiplicity}]
        value["claim"]["count"] = 4
        assert verdict(value).valid == valid


def test_neutral_and_unfelt_coordinates_are_named():
    """A body that hangs on a damper is neutral; two equal oscillators in opposite motion are not felt by their wheel."""  # noqa: E501
    damped = p.vehicle(
        [[10, 0], [0, 5]], [[0, 0], [0, 1]], [[0, 0], [0, 0]], [[1], [0]], [0], [0]
    )  # the second: m ÿ + ẏ = 0
    basis = {"matrix": [["1", "0"], ["0", "1"]], "neutral": 1, "unfelt": 0}
    value = p.plan(p.equations(PAPER, "1/2", damped), UNSTABLE, basis=basis)
    said = verdict(value)
    assert said.valid, said.reason
    assert "1 neutral at q = 0" in said.claim
    value["basis"]["neutral"] = 0  # then the determinant is 0 at q = 0, where the contour begins
    assert not verdict(value).valid
    three = p.vehicle(
        [[10, 0, 0], [0, 5, 0], [0, 0, 5]],
        [[0] * 3] * 3,
        [[6, -3, -3], [-3, 3, 0], [-3, 0, 3]],
        [[1], [0], [0]],
        [0],
        [0],
    )
    basis = {"matrix": [["1", "0", "0"], ["0", "1", "1"], ["0", "1", "-1"]], "neutral": 0, "unfelt": 1}
    value = p.plan(p.equations(PAPER, "1/2", three), UNSTABLE, basis=basis)
    said = verdict(value)
    assert said.valid, said.reason
    assert "no contact feels" in said.claim
    value["basis"]["matrix"][2][2] = "-2"
    assert "coupled" in verdict(value).reason


def test_the_command(tmp_path, capsys):
    good, bad = tmp_path / "good.json", tmp_path / "bad.json"
    good.write_text(made("paper 1"))
    bad.write_text("{}")
    assert v2.main([str(good)]) == 0
    assert v2.main([str(good), str(bad), str(tmp_path / "none")]) == 1
    assert v2.main([]) == 1
    out = capsys.readouterr().out
    assert "valid: exactly 0 induced frequencies" in out
    assert "INVALID" in out


def _ball_matrix(rng, n, radius=0.0):
    def entry(i, j):
        x, y = rng.uniform(-1, 1, 2) * 0.6 / n + (i == j)
        return acb(arb(x, radius), arb(y, radius))

    return acb_mat(n, n, [entry(i, j) for i in range(n) for j in range(n)])


def _quadratic(rng, n):
    """Three matrices of A + Bσ + Cσ²: A is any, its determinant has any argument."""
    A, B, C = rng.normal(size=(3, n, n)) + 1j * rng.normal(size=(3, n, n))
    return A, A @ B / n, A @ C / n


def _turn(parts, m, r):
    A, B, C = parts
    taylor = [acb_mat((A + B * m + C * m * m).tolist()), acb_mat((B + 2 * C * m).tolist())]
    matrix = [taylor[0], taylor[1] * acb(r)], arb_mat((abs(C) * r * r).tolist())
    return v2.Turn.over(matrix, v2.Place.disc(acb(m), arb(r)))


def _pieces(parts):
    """Points of q from −1 to 1 and the turns between them, as long as they pass; what joins them, taking note."""
    points, turns, h, asked = [-1.0], [], 0.5, []
    while points[-1] < 1:
        m = 1j * (points[-1] + h / 2)
        try:
            turns.append(_turn(parts, m, h / 2))
        except v2.Refused:
            h /= 2
            continue
        points.append(points[-1] + h)
        h = min(1.5 * h, 1 - points[-1])

    def matrix(mark):
        asked.append(mark)
        A, B, C = parts
        s = 1j * float(mark.q[0])
        return acb_mat((A + B * s + C * s * s).tolist())

    marks = [v2.Mark((fmpq(*float(x).as_integer_ratio()), fmpq(0)), None) for x in points]
    return marks, turns, SimpleNamespace(matrix=matrix, asked=asked)


def test_the_argument_goes_on_from_piece_to_piece():
    rng, points, asked, far = np.random.default_rng(3), 0, 0, 0.0
    for k in range(40):
        n, alike = int(rng.integers(1, 12)), k % 3 == 0
        A, B, C = _quadratic(rng, n)
        A = A if k % 2 else A + 2 * n * np.diag(np.exp(6j * rng.uniform(size=n)))
        parts = (A, 3j * A if alike else A @ B, C / 9)  # alike: all eigenvalues turn together
        marks, turns, walker = _pieces(parts)
        ends = [float(mark.q[0]) for mark in marks]
        s = 1j * np.concatenate([np.linspace(x, y, 60) for x, y in itertools.pairwise(ends)])[:, None, None]
        exact = np.unwrap(np.angle(np.linalg.det(parts[0] + parts[1] * s + parts[2] * s * s)))
        assert np.abs(np.diff(exact)).max() < 0.5
        for turn, mark in zip(turns, marks, strict=False):
            off = turn.sharp(walker.matrix(mark)) - turn.near(v2.at_q(mark.q))
            assert not abs(off) > turn.lost, k
        walker.asked.clear()
        found = v2.turned_one(marks, turns, walker.matrix)
        assert abs(float(found) - (exact[-1] - exact[0])) < 1e-3, k
        points, asked, far = points + len(turns) - 1, asked + len(walker.asked) - 2, max(far, abs(float(found)))
    assert far > 2 * pi
    assert 0 < asked < points / 3  # most points need no matrix


def test_a_determinant_whose_leading_block_is_singular():
    back = acb_mat(10, 10, [int(i + j == 9) for i in range(10) for j in range(10)])
    turn = v2.Turn.over(([back, back * acb(0.1j)], arb_mat(10, 10)), v2.Place.disc(acb(0), arb(1)))
    assert abs(complex(turn.det) + 1) < 1e-12  # five exchanges


def test_a_determinant_whose_leading_block_is_nearly_singular():
    rng = np.random.default_rng(3)
    R = rng.normal(size=(10, 10)) + 1j * rng.normal(size=(10, 10))
    R[0, :5] = R[1, :5] + 1e-6 * rng.normal(size=5)
    turn = v2.Turn(v2.Place.disc(acb(0), arb(1)), acb_mat(R.tolist()), acb(0), arb(0))
    with v2.precision(64):
        det = turn.det
    assert abs(complex(det) / np.linalg.det(R) - 1) < 1e-9
    assert det.rel_accuracy_bits() > 30  # by halves 4


def test_a_bound_of_the_argument_is_nearly_met():
    """det A = 1 + t, |t| = 0.9: arg(1 + t) differs from Im t by a part of what −log(1 − 0.9) − 0.9 allows."""
    turn = v2.Turn.over(([acb_mat([[1]]), acb_mat([["0.9"]])], arb_mat([[0]])), v2.Place.disc(acb(0), arb("0.9")))
    t = 0.9 * np.exp(2.69j)
    off = abs(np.angle(1 + t) - t.imag)
    assert 0.3 < off / float(turn.lost) <= 1


@pytest.mark.parametrize("n", [1, 7, 9, 20, 33])
def test_pivots_by_blocks_are_those_of_plain_elimination(n):
    a = _ball_matrix(np.random.default_rng(n), n, 1e-15)
    b, total = np.array([[complex(x) for x in row] for row in a.tolist()]), 0.0
    for k in range(n):
        total += np.angle(b[k, k])
        b[k + 1 :, k + 1 :] -= np.outer(b[k + 1 :, k], b[k, k + 1 :]) / b[k, k]
    found = v2.turn_of(a)
    assert abs(float(found.mid()) - total) < 1e-12
    assert found.rad() < 1e-10


@pytest.mark.parametrize("radius", ["1", "3/10", "1.0849", "1e-9", "9.96e-300", "1e-1002", "7/3"])
def test_a_radius_is_printed_with_two_digits_and_not_as_less(radius):
    said = Fraction(v2.two_digits(v2.fmpq(*Fraction(radius).as_integer_ratio())))
    assert Fraction(radius) <= said <= Fraction(radius) * Fraction(112, 100)


@pytest.mark.parametrize("n", [1, 2, 5, 12])
def test_hermitian_matrices_over_a_box_against_eigenvalues(n):
    """Where it is proved no eigenvalue is < 0 anywhere in the box, or with a rest; it is where there is a margin."""
    rng, seen = np.random.default_rng(n), []

    def hermitian():
        a = rng.normal(size=(n, n)) + 1j * rng.normal(size=(n, n))
        return (a + a.conj().T) / 2

    for k in range(60):
        H, E = [hermitian() for _ in range(3)], abs(hermitian()) * 0.1
        corners = [H[0] + x * H[1] + y * H[2] for x, y in itertools.product((-1, 1), repeat=2)]
        least = min(np.linalg.eigvalsh(a)[0] for a in corners)
        shift = rng.uniform(-0.5, 1.5) * E.sum(1).max() - least
        H[0] = H[0] + shift * np.eye(n)
        proved = v2.definite([acb_mat(a.tolist()) for a in H], arb_mat(E.tolist()))
        worst = min(  # a rest that pulls along the weakest direction
            np.linalg.eigvalsh(a - E * np.outer(u, u.conj()))[0]
            for a in [c + shift * np.eye(n) for c in corners]
            for u in [np.exp(1j * np.angle(np.linalg.eigh(a)[1][:, 0]))]
        )
        assert not (proved and worst <= 0), k
        assert proved or least + shift < E.sum(1).max(), k
        seen.append(proved)
    assert set(seen) == {True, False}


def test_close_contacts_lose_what_is_open_between_them_only():
    """H_0 is small along (1, −1, 0, …) alone: a rest of one size everywhere takes 2 e there, in whatever phases."""
    rng, n, e = np.random.default_rng(8), 6, 1e-4
    for times, fine in ((2.5, True), (1.9, False)):
        u = np.array([1, -1, 0, 0, 0, 0]) / np.sqrt(2)
        H = np.eye(n) + (times * e - 1) * np.outer(u, u)
        assert v2.definite([acb_mat(H.tolist())], arb_mat(n, n, [e] * n * n)) == fine
        phases = np.exp(2j * np.pi * rng.random((200, n)))
        phases[0, :2] = 1, -1
        least = min(np.linalg.eigvalsh(H - e * np.outer(x, x.conj()))[0] for x in phases)
        assert (least > 0) == fine


MIXED = {  # a mass on its own; a wheel with a frame above; a body on two contacts, one of them soft
    "M": [["2", "0", "0", "0"], ["0", "3", "0", "0"], ["0", "0", "5", "0"], ["0", "0", "0", "7"]],
    "C": [["0", "0", "0", "0"], ["0", "1", "-1", "0"], ["0", "-1", "1", "0"], ["0", "0", "0", "0"]],
    "K": [["0", "0", "0", "0"], ["0", "4", "-4", "0"], ["0", "-4", "4", "0"], ["0", "0", "0", "0"]],
    "B": [["1", "0", "0", "0"], ["0", "2", "0", "0"], ["0", "0", "0", "0"], ["0", "0", "1", "1"]],
    "places": ["0", "1", "3", "4"],
    "compliances": ["0", "0", "1/3", "0"],
}


def test_elimination_of_direct_contacts_leaves_the_determinant_but_for_a_constant():
    """Of the whole bordered matrix in floats, with the kernels as random numbers, and of each Taylor coefficient."""
    vehicle = v2.read_vehicle(MIXED, None)
    assert v2.direct_contacts(vehicle) == {0: 0, 1: 1}
    track = v2.read_track(p.beam("1/4", 1, 1, "1/10"), "1/2")
    waves = v2.Waves(track, vehicle.places)
    bordered = v2.Bordered(vehicle, waves)
    assert bordered.size == 6
    rng = np.random.default_rng(1)
    G = [[acb(*map(float, rng.normal(size=2))) for _ in waves.gaps] for _ in range(3)]
    M, C, K, B = (np.array([[float(Fraction(x)) for x in row] for row in MIXED[name]]) for name in "MCKB")
    g = [[[complex(row[k]) for k in line] for line in waves.index] for row in G]
    sigma, r, none = 0.3 + 0.8j, 0.05, [arb(0)] * len(waves.gaps)
    place = v2.Place.disc(acb(sigma.real, sigma.imag), arb(r))
    (first, second), rest = bordered(place, v2.Form([G[0], [x * r for x in G[1]]], none, 1))

    def whole(t):
        s = sigma + t
        corner = sum(np.array(g[order]) * t**order for order in range(2)) + np.diag([0, 0, 1 / 3, 0])
        return np.linalg.det(np.block([[K + C * s + M * s * s, -B], [B.T, corner]]))

    def ours(t):
        both = (np.array([[complex(x) for x in row] for row in a.tolist()]) for a in (first, second))
        return np.linalg.det(next(both) + next(both) * t / r)

    ratios = [whole(t) / ours(t) for t in (0, 1e-4, 1e-4j)]
    assert abs(abs(ratios[0]) - 2) < 1e-12  # b = 1 and b = 2
    assert max(abs(r - ratios[0]) for r in ratios) < 1e-6  # the quadratic part is not in the linear one
    # with kernels that leave a rest: at each point the matrix is first + second·u to within the bound
    bent = v2.Form([G[0], [x * r for x in G[1]]], [abs(x) * r * r for x in G[2]], 1)
    (first, second), rest = bordered(place, bent)
    for u in (1, 1j, -1, 0.4):
        at = acb(complex(u)) * r
        there = v2.Form([[x + y * at + z * at * at for x, y, z in zip(*G, strict=True)]], none, 0)
        (exact,), nothing = bordered(v2.Place.disc(place.middle[0] + at, arb(0)), there)
        assert all(x == 0 for x in nothing.entries())
        for x, y in zip((exact - first - second * acb(complex(u))).entries(), rest.entries(), strict=True):
            assert float(abs(x)) <= float(y) * (1 + 1e-9) + 1e-12


@pytest.mark.parametrize("m", [1, 2])
def test_the_small_block_has_the_roots_of_the_determinant(m):
    """A(t) = A₀ + A₁ t with m roots of det at t = 0 by construction: det F = det A/det B, and no m − 1 hold it."""
    rng, n, r = np.random.default_rng(3), 12, 1e-6
    a = [_ball_matrix(rng, n), _ball_matrix(rng, n)]
    rows = a[0].tolist()
    for k in range(m):
        rows[4 + k] = [2 * x - y for x, y in zip(rows[1], rows[7 + k], strict=True)]
    A, lost = [acb_mat(rows), a[1] * r], arb_mat(n, n, [1e-12] * (n * n))
    (first, second), rest = v2.block((A, lost), m)
    assert max(abs(complex(x)) for x in first.entries()) < 1e-12

    def both(t):
        small = np.array((first + second * acb(t / r)).tolist(), complex)
        wide = np.array([[complex(x) for x in row] for row in (A[0] + A[1] * acb(t / r)).tolist()])
        return np.linalg.det(small), np.linalg.det(wide)

    one, two = (both(t) for t in (r, -r / 2))
    assert abs(one[0] / two[0] / (one[1] / two[1]) - 1) < 0.2  # det B changes little, and F is linear to first order
    assert max(float(x) for x in rest.entries()) < 0.5 * max(abs(complex(x)) for x in second.entries())
    with pytest.raises(v2.Refused, match=r"kernel|singular"):
        v2.block(([acb_mat(n, n, [1] * (n * n)), A[1]], lost), m)


def test_a_closing_that_one_precision_leaves_open_is_taken_with_more(monkeypatch):
    """Light contacts so close that the receptance matrix is nearly singular: the sum is sharp all the same."""
    eq = p.equations(PAPER, "1/2", p.masses([40] * 12, row(12, "1/50")))
    car, track = v2.read_vehicle(eq["vehicle"], None), v2.read_track(eq["track"], eq["velocity"])
    with v2.precision(64):
        waves = v2.Waves(track, car.places)
        walker = v2.Walker(waves, v2.Bordered(car, waves))
        walker.begin(fmpq(1))
        (corner,) = walker.marks.values()
        for k in range(1, 31):
            at = (fmpq(k, 15), fmpq(0)) if k > 15 else (fmpq(k, 15), fmpq(k - 15, 15))
            found = v2.apart_near(walker.near(v2.at_q(at)), corner.known.near(v2.at_q(at)))
            corner = v2.Mark(at, found, found)
        sharp = v2.closing(walker, corner)
    with v2.precision(10):
        a = v2.accretive(walker.bordered, acb(0, 2), v2.kernels(waves, [corner.thin])[0][0].k[0])
        try:
            once = v2.turn_of(acb_mat(a)).rad()
        except v2.Refused:
            once = arb("inf")
        found = v2.closing(walker, corner)
    assert not once < 0.1
    assert found.rad() < 0.1
    assert found.overlaps(sharp)
    near = v2.apart_near
    monkeypatch.setattr(v2, "apart_near", lambda local, known: exchanged(near(local, known)))
    with v2.precision(10), pytest.raises(v2.Refused, match="where the path comes to its corner"):
        v2.closing(walker, corner)  # sharper p-roots, but of other sides


def test_it_runs_as_a_plain_script_without_numpy_and_without_the_package(tmp_path):
    """Isolated: nothing but the standard library and python-flint is imported."""
    path = tmp_path / "case.json"
    p.save(content("two-layer 680"), path)
    command = [sys.executable, "-I", "-X", "importtime", v2.__file__, str(path)]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout
    assert ": valid: exactly" in ran.stdout
    loaded = {line.split("|")[-1].strip() for line in ran.stderr.splitlines() if line.startswith("import time:")}
    assert "flint" in loaded
    assert not [name for name in loaded if name.split(".")[0] in ("numpy", "mpsolve", "sympy", "mpmath")]


# --- waves that meet at q = 0 (SPEC2, 4.8) ----------------------------------------------------------------


CERTS = Path(__file__).parents[2] / "certs"


def meeting(k, low, seed):
    """(Waves of polynomials D, N without terms below the orders k and low, what is known next to q = 0)."""
    rng, n = np.random.default_rng([k, low, seed]), max(k, low) + 2

    def polynomial(degree, order):
        c = {(i, j): fmpq(int(rng.integers(-128, 129)), 64) for i in range(degree + 1) for j in range(4)}
        return {at: x for at, x in c.items() if sum(at) >= order and x != 0}

    d, below = polynomial(n, k) | {(k, 0): fmpq(1), (n, 0): fmpq(3, 2)}, polynomial(n - 2, low) | {(low, 0): fmpq(1)}
    waves = v2.Waves(SimpleNamespace(d=d, n=below, degree=n), [{}, {(): fmpq(3, 2)}])
    return waves, v2.Origin(waves)


def ice_like(k, low):
    """A few of them that are told apart on |σ| ≤ r, with the roots' discs there."""
    found, r = [], arb("0.01")
    for seed in range(200):
        try:
            waves, origin = meeting(k, low, seed)
            found.append((waves, origin, r, origin.roots(r)))
        except (v2.Refused, ValueError):
            continue
        if len(found) == 4:
            return found
    raise AssertionError("no example")


def sided(waves, sigma, discs):
    """The p-roots at σ in floats, N/D_P there, and the sides of the discs that hold them."""
    columns = [
        np.array([sum(float(arb(c)) * sigma**j for (i, j), c in t.items() if i == n) for n in range(size)])
        for t, size in ((waves.track.d, waves.d.matrix.nrows()), (waves.track.n, waves.n.matrix.nrows()))
    ]
    D, N = (np.polynomial.Polynomial(c) for c in columns)
    P, out = D.roots(), []
    for one in P:
        inside = [
            int(k >= discs[kind].up)
            for kind, z in enumerate((one / sigma, one))
            for k, (other, e) in enumerate(zip(discs[kind].z, discs[kind].e, strict=True))
            if abs(z - complex(other)) <= float(e) + 1e-9
        ]
        assert len(inside) == 1
        out.append(inside[0])
    return P, N(P) / D.deriv()(P), np.array(out)


@pytest.mark.parametrize(("k", "low"), [(2, 1), (2, 2), (2, 3), (3, 2)])
def test_kernels_next_to_zero_are_sums_of_residues(k, low):
    for waves, origin, r, discs in ice_like(k, low):
        real = sided(waves, 0.005, discs)  # at σ > 0 the sides are those of Re P
        assert ((real[0].real > 0) == (real[2] == 1)).all()
        G = origin.kernels(r)
        for angle in np.linspace(0, 2 * pi, 7):
            sigma = 0.0099 * np.exp(1j * angle)
            P, weight, side = sided(waves, sigma, discs)
            for gap, a, b, rest in zip(waves.gaps, *G.k, G.e, strict=True):
                xi = float(gap.get((), 0))
                true = (weight * np.exp(P * xi))[side == (xi < 0)].sum() * (-1 if xi < 0 else 1)
                assert abs(true - complex(a) - complex(b) * sigma / 0.01) <= float(rest) + 1e-9 * (1 + abs(true))
                assert float(rest) < 0.2 * (1 + abs(complex(a)))


@pytest.mark.parametrize("b", [0.01, 0.1, 0.3, 0.7])
def test_discs_next_to_zero_hold_the_roots_of_all_that_a_ball_holds(b):
    t = {(2, 0): fmpq(1), (0, 2): fmpq(-1), (4, 0): fmpq(-1, 100)}
    origin = v2.Origin(v2.Waves(SimpleNamespace(d=t, n={(0, 1): fmpq(1)}, degree=4), [{}]))
    origin.kinds[0][0][0].matrix[1, 0] = acb(arb(0, b))  # ζ² + (0 ± b)ζ − 1 for σ = 0
    try:
        slow, _ = origin.roots(arb(2.0**-60))
        discs = [(complex(z), float(e)) for z, e in zip(slow.z, slow.e, strict=True)]
    except v2.Refused:
        assert b > 0.5
        return
    for c in (-b, 0, b):
        for root in np.roots([1, c, -1]):
            assert any(abs(root - z) <= e for z, e in discs)


def test_a_pair_with_two_roots_exchanged_does_not_join_on_to_zero():
    tried = 0
    for waves, origin, r, discs in ice_like(2, 2):
        sigma = 0.008 * np.exp(0.3j)
        P, _, side = sided(waves, sigma, discs)
        P, up = P[np.argsort(side, kind="stable")], int((side == 0).sum())
        local = waves.near(v2.Place.disc(acb(sigma.real, sigma.imag), arb(0)))

        def thin(z, up=up, local=local):
            return v2.Apart.of(local, [acb(x) for x in z], up)

        there = origin.at(local.place.middle[0], r)
        assert there.holds(thin(P))
        if 0 < up < len(P):
            P[[0, up]] = P[[up, 0]]
            assert not there.holds(thin(P))
            tried += 1
    assert tried > 1


def test_a_point_at_zero_on_the_side_of_a_rectangle_and_no_passive_piece_there():
    content = json.loads((CERTS / "floating_ice.json").read_bytes())
    track = v2.read_track(content["equations"]["track"], content["equations"]["velocity"])
    vehicle = v2.read_vehicle(content["equations"]["vehicle"], None)
    with v2.precision(64):
        walker = v2.Walker(waves := v2.Waves(track, vehicle.places), v2.Bordered(vehicle, waves))
        walker.begin(fmpq(1))
        link, turn = v2.read_paths(content["paths"][:2], "link turn")
        walker.path(link)
        near = turn.points[1]
        walker.path(v2.Path("turn", [(fmpq(0), fmpq(0)), near]))
        back = walker.path(v2.Path("turn", [near, (fmpq(0), fmpq(0)), (-near[0], fmpq(0))]))
        there = walker.path(v2.Path("turn", [(-near[0], fmpq(0)), (fmpq(0), fmpq(0)), near]))
        assert abs(back + there) < 1e-9
        with pytest.raises(v2.Refused, match="passive piece"):
            walker.path(v2.Path("passive", [near, (fmpq(0), fmpq(0))]))
        mark = walker.marks[near]
        mark.thin = exchanged(walker.thin(mark))
        with pytest.raises(v2.Refused, match="does not join on to q = 0"):
            walker.path(v2.Path("turn", [near, (fmpq(0), fmpq(0))]))


@pytest.mark.parametrize(
    ("sign", "r", "stated"),
    [(-1, "0.2", None), (1, "0.2", "a p-root may be real next to q = 0"), (-1, "0.45", "not told apart")],
)
def test_waves_next_to_zero_that_are_not_told_apart_are_refused(sign, r, stated):
    """P² ± σ² − P⁴: P near ±σ, or ±iσ, and near ±1."""
    t = {(2, 0): fmpq(1), (0, 2): fmpq(sign), (4, 0): fmpq(-1)}
    with v2.precision(64):
        origin = v2.Origin(v2.Waves(SimpleNamespace(d=t, n={(0, 1): fmpq(1)}, degree=4), [{}]))
        if stated is None:
            assert [one.up for one in origin.roots(arb(r))] == [1, 1]
        else:
            with pytest.raises(v2.Refused, match=stated):
                origin.roots(arb(r))


def zeros_proved(A, r, m):
    try:
        with v2.precision(64):
            v2.check_zeros(([acb_mat(A[0]), acb_mat(A[1]) * r], arb_mat(A[2])), m)
    except v2.Refused:
        return False
    return True


def test_zeros_in_a_disc_are_counted_with_all_that_is_not_linear():
    linear = [[0]], [[1]]
    assert zeros_proved((*linear, [[0.5]]), 1, 1)
    assert not zeros_proved((*linear, [[1.5]]), 1, 1)  # t + 3/2 has none
    nothing = [[0, 0], [0, 0]]
    assert zeros_proved(([[1, 0], [0, 0]], [[0, 0.1], [0.1, 0.5]], nothing), 1, 1)  # t/2 − t²/100
    assert not zeros_proved(([[1, 0], [0, 0]], [[0, 0.5], [0.5, 0.1]], nothing), 1, 1)  # t/10 − t²/4: 0 and 0.4
    assert zeros_proved((nothing, [[1, 0], [0, 1]], nothing), 1, 2)
    assert not zeros_proved((nothing, [[1, 0], [0, 1]], nothing), 1, 1)


def test_long_polynomials_in_many_parameters_are_not_halved_for_ever(monkeypatch):
    box, looked = tuple((fmpq(0), fmpq(1)) for _ in range(6)), []
    monkeypatch.setattr(v2, "positive", lambda *_: looked.append(0))
    with pytest.raises(v2.Refused, match="why"):
        v2.everywhere([{(4,) * 6: fmpq(1)}], box, "why")  # 5^6 coefficients a part
    assert len(looked) * 5**6 < 2.1e7
    looked.clear()

    def small(_, here, __):
        looked.append(0)
        return all(16 * (y - x) <= 1 for x, y in here[:3])

    monkeypatch.setattr(v2, "positive", small)
    v2.everywhere([{(1,) * 3: fmpq(1)}], box[:3], "why")  # short ones are
    assert len(looked) == 2**13 - 1


def test_bounds_whose_balls_reach_below_zero_do_not_make_a_matrix_contract():
    """The moduli may be [[0.28, 1.63], [1.4, 0.12]], with an eigenvalue above 1; weights below 0 would hide it."""
    E = arb_mat([[0.28, 1.63], [arb(-0.01, 1.41), arb(-0.06, 0.18)]])
    assert not v2.contracting(E)
    assert not v2.contracting(arb_mat([[0.28, 1.63], [arb(-0.7, 2.1), arb(-0.06, 0.18)]]))
    assert v2.contracting(arb_mat([[0.28, 0.3], [arb(-0.01, 0.1), arb(-0.06, 0.18)]]))
