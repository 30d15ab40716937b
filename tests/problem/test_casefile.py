"""An input file gives its numbers exactly as written, or one sentence that names the key at fault."""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mpsolve.errors import InputError
from mpsolve.problem.case import Case
from mpsolve.problem.casefile import read_case, read_input
from mpsolve.problem.physical import Mass, PhysicalCase
from mpsolve.problem.toml import MAX_BYTES
from mpsolve.vehicles.load import Load

EXAMPLES = Path(__file__).parents[2] / "examples"

BEAM = """
[physical]
EI = 6.4e6
m = 60
k = 1e6
v = 100
"""
MASS = """
[[mass]]
M = 10000
position = 0
"""
FRONT = """
[[mass]]
M = 5000
position = 3.4
"""
PLAIN = """
[dimensionless]
alpha = 0.67
eta_b = 0.05
eta_m = [70, 70]
positions = [0, 1.5]
"""


@pytest.fixture
def written(tmp_path: Path) -> Path:
    return tmp_path / "case.toml"


def test_the_physical_example() -> None:
    example = read_input(EXAMPLES / "rail_60e1.toml")
    assert isinstance(example.case, PhysicalCase)
    assert "60E1" in example.title
    assert example.path == EXAMPLES / "rail_60e1.toml"
    case = example.case.dimensionless
    assert [mass.M for mass in example.case.masses] == [10000, 10000]
    assert [case.alpha.short(3), case.eta_b.short(2), case.positions[1].short(3)] == ["0.344", "0.05", "1.51"]


def test_the_dimensionless_example() -> None:
    expected = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
    assert read_case(EXAMPLES / "dimensionless.toml") == expected
    assert read_case(str(EXAMPLES / "dimensionless.toml")) == expected


def test_all_physical_keys(written: Path) -> None:
    force = 'P = "1e5"\nP_A = 200.5\nomega_f = 12\nphi_f = -0.5\n'
    written.write_text(BEAM + "c = 770\nkp = 2e3\nN = -1_000.5\n" + MASS + force + FRONT, encoding="utf-8")
    masses = (Mass(10000, 0, P="1e5", P_A="200.5", omega_f=12, phi_f="-0.5"), Mass(5000, "3.4"))
    assert read_case(written) == PhysicalCase(
        EI="6.4e6", m=60, k="1e6", v=100, c=770, kp=2000, N="-1000.5", masses=masses
    )
    assert read_input(written).title == ""


def test_all_dimensionless_keys(written: Path) -> None:
    text = 'title = "τ"\n' + PLAIN.replace("70, 70", '"root4(2)", "1/3"') + "eta_n = 0.3\neta_s = 0.1\n"
    written.write_text(text, encoding="utf-8-sig")
    assert read_input(written).title == "τ"
    assert read_case(written) == Case(
        alpha="0.67", eta_b="0.05", eta_m=("root4(2)", "1/3"), positions=(0, "1.5"), eta_n="0.3", eta_s="0.1"
    )


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.1", Fraction(1, 10)),
        ("0.1000000000000000055511151231257827", Fraction("0.1000000000000000055511151231257827")),
        ("1e-300", Fraction(1, 10**300)),
        ("0x10", 16),
        ("+1_0.5E-1", Fraction(105, 100)),
        ('"1/3"', Fraction(1, 3)),
        ("99999999999999999999", 99999999999999999999),
    ],
)
def test_a_number_is_exactly_as_written(written: Path, text: str, value: Fraction) -> None:
    written.write_text(PLAIN.replace("0.67", text), encoding="utf-8")
    assert read_case(written) == Case(alpha=value, eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))


@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.decimals(0, 10**6, allow_nan=False, allow_infinity=False))
def test_no_digit_is_lost(written: Path, value: Decimal) -> None:
    written.write_text(PLAIN.replace("0.67", f"{value:f}"), encoding="utf-8")
    case = read_case(written)
    assert isinstance(case, Case)
    assert case.alpha == Fraction(value)


def physical(old: str, new: str) -> str:
    assert old in BEAM + MASS + FRONT
    return (BEAM + MASS + FRONT).replace(old, new)


def plain(old: str, new: str) -> str:
    assert old in PLAIN
    return PLAIN.replace(old, new)


@pytest.mark.parametrize(
    ("text", "key", "reason"),
    [
        # a value that cannot be
        (physical("6.4e6", "-6.4e6"), "physical.EI", "is -6.4e+6, but must be above 0: give the bending stiffness"),
        (physical("m = 60", "m = 0"), "physical.m", "above 0"),
        (physical("k = 1e6", "k = -1e6"), "physical.k", "above 0"),
        (physical("v = 100", "v = -1"), "physical.v", "must not be below 0"),
        (physical("v = 100", "v = 1\nc = -1"), "physical.c", "must not be below 0"),
        (physical("v = 100", "v = 1\nkp = -1"), "physical.kp", "must not be below 0"),
        (physical("v = 100", "v = 1\nN = 5.06e6"), "physical.N", "buckles without any load: lower"),
        (physical("M = 5000", "M = 0"), "mass[2].M", "above 0"),
        (physical("position = 3.4", "position = -0.1"), "mass[2].position", "is -0.1, below the 0 before it"),
        (plain("0.67", "-0.67"), "dimensionless.alpha", "must not be below 0"),
        (plain("0.05", "-0.05"), "dimensionless.eta_b", "must not be below 0"),
        (plain("[70, 70]", "[-1, 70]"), "dimensionless.eta_m[1]", "above 0"),
        (plain("[70, 70]", "[]"), "dimensionless.eta_m", "empty"),
        (plain("[70, 70]", "[70]"), "dimensionless.positions", "2 values for 1 masses"),
        (plain("[0, 1.5]", "[1.5, 0]"), "dimensionless.positions[2]", "below the 1.5 before it"),
        (PLAIN + "eta_n = 1", "dimensionless.eta_n", "buckles without any load: lower"),
        (PLAIN + "eta_s = -0.1", "dimensionless.eta_s", "must not be below 0"),
        # a value that is no number
        (physical("EI = 6.4e6", "EI = true"), "physical.EI", "type bool"),
        (physical("EI = 6.4e6", "EI = nan"), "physical.EI", "not finite"),
        (physical("EI = 6.4e6", "EI = -inf"), "physical.EI", "not finite"),
        (physical("EI = 6.4e6", "EI = 1979-05-27"), "physical.EI", "type date"),
        (physical("EI = 6.4e6", "EI = 07:32:00"), "physical.EI", "type time"),
        (physical("EI = 6.4e6", "EI = {a = 1}"), "physical.EI", "type dict"),
        (physical("EI = 6.4e6", "EI = [1]"), "physical.EI", "type list"),
        (physical("EI = 6.4e6", 'EI = "stiff"'), "physical.EI", "'stiff' is not a number"),
        (physical("EI = 6.4e6", 'EI = ""'), "physical.EI", "'' is not a number"),
        (physical("EI = 6.4e6", 'EI = "root4(2)"'), "physical.EI", "irrational"),
        (physical("EI = 6.4e6", "EI = 1e999999999"), "physical.EI", "exponent"),
        (physical("EI = 6.4e6", "EI = 1." + "1" * 500), "physical.EI", "more than 400 digits"),
        (physical("M = 5000", "M = false"), "mass[2].M", "type bool"),
        (physical("M = 10000", "M = 1\nP = [1]"), "mass[1].P", "type list"),
        (plain("[70, 70]", "[70, true]"), "dimensionless.eta_m[2]", "type bool"),
        (plain("[70, 70]", "70"), "dimensionless.eta_m", "is a number, not a list"),
        (plain("[0, 1.5]", '"0, 1.5"'), "dimensionless.positions", "is a text, not a list"),
        (plain("[0, 1.5]", "1.5"), "dimensionless.positions", "is a number, not a list"),
        (plain("[0, 1.5]", "1979-05-27"), "dimensionless.positions", "is a date or time, not a list"),
        (plain("[0, 1.5]", "[0, [1]]"), "dimensionless.positions[2]", "type list"),
        ("title = 1.5\n" + PLAIN, "title", "is a number, not a text"),
        ("title = true\n" + PLAIN, "title", "is a boolean, not a text"),
        # a key that is missing
        (physical("EI = 6.4e6\n", ""), "physical.EI", "is missing: give the bending stiffness of the beam in N m²"),
        (physical("m = 60\n", ""), "physical.m", "is missing"),
        (physical("k = 1e6\n", ""), "physical.k", "is missing"),
        (physical("v = 100\n", ""), "physical.v", "is missing"),
        (physical("M = 10000\n", ""), "mass[1].M", "is missing: give the mass in kg"),
        (physical("position = 3.4\n", ""), "mass[2].position", "is missing: give the position in m"),
        (plain("alpha = 0.67\n", ""), "dimensionless.alpha", "is missing"),
        (plain("eta_b = 0.05\n", ""), "dimensionless.eta_b", "is missing"),
        (plain("eta_m = [70, 70]\n", ""), "dimensionless.eta_m", "is missing"),
        (plain("positions = [0, 1.5]\n", ""), "dimensionless.positions", "is missing"),
        (BEAM, "mass", "is missing: add [[mass]]"),
        ("mass = []\n" + BEAM, "mass", "is missing: add [[mass]]"),
        (MASS, "physical", "is missing: add [physical]"),
        # a key or section that is unknown or of the wrong kind
        (physical("EI =", "ei ="), "physical.ei", "is unknown: did you mean EI?"),
        (physical("v = 100", "v = 100\nspeed = 3"), "physical.speed", "is unknown: the keys here are EI, m, k"),
        (physical("v = 100", "v = 100\n'a\\nb' = 3"), r"physical.'a\\nb'", "is unknown"),
        (physical("M = 5000", "M = 5000\nomega = 3"), "mass[2].omega", "is unknown: did you mean omega_f?"),
        (PLAIN + "eta_a = 1", "dimensionless.eta_a", "is unknown: did you mean eta_"),
        ("titel = 'x'\n" + PLAIN, "titel", "is unknown: did you mean title?"),
        (physical("[physical]", "[phsical]"), "phsical", "is unknown: did you mean physical?"),
        (PLAIN + "[dimensionless.more]\n", "dimensionless.more", "is unknown"),
        (physical("[physical]", "[[physical]]"), "physical", "is a list, not a section"),
        ("dimensionless = 3", "dimensionless", "is a number, not a section"),
        ("physical = 1979-05-27", "physical", "is a date or time, not a section"),
        ("mass = [1]\n" + BEAM, "mass[1]", "is a number, not a section"),
        (BEAM + MASS.replace("[[mass]]", "[mass]"), "mass", "is a table: write [[mass]] in double brackets"),
        (BEAM + PLAIN, "physical", "beside [dimensionless]"),
        (PLAIN + MASS, "mass", "beside [dimensionless]"),
    ],
)
def test_a_mistake_is_named_by_its_key(written: Path, text: str, key: str, reason: str) -> None:
    written.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=f"^{re.escape(key)}: .*{re.escape(reason)}") as caught:
        read_input(written)
    assert caught.value.key == key
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "holds no case"),
        (b"title = 'x'", "holds no case"),
        (b"# nothing", "holds no case"),
        (b"alpha: 0.67", r"is a text, not TOML, which has lines like v = 10"),
        (b"[physical]\nEI =\n", r"is not valid TOML in line 2"),
        (b"[physical]\nEI = 1\nEI = 2\n", "is not valid TOML"),
        (b"[physical]\nEI = 2000-13-45\n", "is not valid TOML"),
        (b"[physical]\nEI = " + b"9" * 5000, "too many digits"),
        (b"a = " + b"[" * 20000, "nested too deeply"),
        (b"title = '\xff'", "has a character in line 1 that is not in UTF-8"),
        ("title = 'x'".encode("utf-16"), "is a text in UTF-16"),
        (b"#" * (MAX_BYTES + 1), "is longer than"),
        (b"\x7fELF\x00\x01", "is no text"),
    ],
    ids=lambda value: value[:12].hex() if isinstance(value, bytes) else value,
)
def test_a_file_that_is_no_case_is_named_by_its_path(written: Path, content: bytes, reason: str) -> None:
    written.write_bytes(content)
    with pytest.raises(InputError, match=f"^{re.escape(str(written))}: .*{reason}.*: ") as caught:
        read_input(written)
    assert caught.value.key == str(written)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("path", "reason"),
    [
        (".", "is a directory"),
        ("/dev/null", "is not a regular file"),
        ("missing.toml", "does not exist"),
        ("null\0.toml", "does not exist"),
        ("n" * 300, "cannot be read|does not exist"),
        ("case.toml/inside", "does not exist"),
    ],
)
def test_a_path_that_cannot_be_read_is_named(written: Path, path: str, reason: str) -> None:
    written.write_text(PLAIN, encoding="utf-8")
    with pytest.raises(InputError, match=f": ({reason})"):
        read_input(written.parent / path)


LOADED = """[dimensionless]
alpha = 0.5
eta_b = 0.1
eta_m = [70, 70]
positions = [0, 1]
"""


def test_loads_of_a_dimensionless_case(tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(LOADED, encoding="utf-8")
    assert read_input(path).loads is None
    path.write_text(LOADED + "[[load]]\nconstant = 2\n[[load]]\namplitude = 0.1\nfrequency = 0.3\n", encoding="utf-8")
    assert read_input(path).loads == (Load(2), Load(amplitude="0.1", frequency="0.3"))


@pytest.mark.parametrize(
    ("entries", "key"),
    [
        ("[[load]]\n", "load"),
        ("[load]\nconstant = 1\n", "load"),
        ("[[load]]\nconstant = 1\n[[load]]\nforce = 2\n", r"load\[2\].force"),
        ("[[load]]\nconstant = 1\n[[load]]\nphase = 'x'\n", r"load\[2\].phase"),
    ],
)
def test_loads_that_cannot_be_used(tmp_path: Path, entries: str, key: str) -> None:
    path = tmp_path / "case.toml"
    path.write_text(LOADED + entries, encoding="utf-8")
    with pytest.raises(InputError, match=key):
        read_input(path)


def test_loads_beside_a_physical_case(tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    text = "[physical]\nEI = 1\nm = 1\nk = 1\nv = 1\n[[mass]]\nM = 1\nposition = 0\n[[load]]\nconstant = 1\n"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match="load"):
        read_input(path)
