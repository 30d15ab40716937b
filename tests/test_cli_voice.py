"""One voice: each input that cannot be used is answered by one sentence with its name, what was given, what to do."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve.cli import cli

EXAMPLES = Path(__file__).parents[1] / "examples"
SAMPLES = {"bogie": "two_layer_bogie", "rail": "rail_60e1", "ratios": "dimensionless"}

FILES = [  # file, what stands there, what is written instead, the key with its line, what the sentence quotes
    ("bogie", "v = 100 ", 'v = "360 kmh" ', "v", "'360 kmh'", 3),
    ("bogie", "v = 100 ", 'v = "fast" ', "v", "'fast'", 3),
    ("bogie", "v = 100 ", "v = -5 ", "v", "-5", 3),
    ("bogie", "v = 100 ", 'v = "12 kg" ', "v", "'12 kg'", 3),
    ("bogie", "v = 100 ", "v = nan ", "v", "nan", 3),
    ("bogie", "v = 100 ", "w = 100 ", "w", "unknown", 3),
    ("bogie", '"two-layer"', '"two-layers"', "track.model", "'two-layers'", 8),
    ("bogie", "EI = ", "EJ = ", "track.EJ", "unknown", 9),
    ("bogie", "EI = 6.38043e6", "EI = -1", "track.EI", "-1", 9),
    ("bogie", "EI = 6.38043e6", 'EI = "6.4 kN/m"', "track.EI", "'6.4 kN/m'", 9),
    ("bogie", "k_pad = 300e6", 'k_pad = "180 kN/mm"', "track.k_pad", "'180 kN/mm'", 11),
    ("bogie", "c_pad = 3e4 ", "c_pad = -3e4 ", "track.c_pad", "-30000", 12),
    ("bogie", "m_sleeper = 250", "sleeper_spacing = 0.6", "track.sleeper_spacing", "unknown", 13),
    ("bogie", "[[vehicle]]", "[vehicle]", "vehicle", "table", 20),
    ("bogie", '"bogie"', '"boggie"', "vehicle[1].model", "'boggie'", 21),
    ("bogie", "wheelbase = 2.56", "wheelbase = 0", "vehicle[1].wheelbase", "is 0", 26),
    ("bogie", "position = 0", 'position = "2 s"', "vehicle[1].position", "'2 s'", 22),
    ("bogie", "position = 0", "count = 2", "vehicle[1].spacing", "missing", 20),
    ("bogie", "position = 0", "count = 2.5\nspacing = 3", "vehicle[1].count", "2.5", 22),
    ("bogie", "c_pad = 3e4 ", 'N = "1e9 N"\nc_pad = 3e4 ', "track", "buckles", 7),
    ("bogie", "[[vehicle]]", "[[load]]\nQ = 1\n[[vehicle]]", "load[1].Q", "unknown", 21),
    ("rail", "M = 10000", "M = 0", "mass[1].M", "is 0", 13),
    ("rail", "position = 3.4", "position = -3.4", "mass[2].position", "-3.4", 24),
    ("rail", "k = 1e6", "k = 0", "physical.k", "is 0", 6),
    ("ratios", "alpha = 0.67", "alpha = -1", "dimensionless.alpha", "-1", 4),
    ("ratios", "eta_m = [70, 70]", "eta_m = 70", "dimensionless.eta_m", "a number", 6),
    ("ratios", "positions = [0, 1.5]", "positions = [1.5, 0]", "dimensionless.positions[2]", "is 0", 7),
    ("ratios", "eta_n = 0 ", "eta_n = 1.5 ", "dimensionless.eta_n", "1.5", 8),
]
BROKEN = [  # what is no TOML at all: the line itself, and how it is written
    ("v = 100 ", "v = ", "line 3, v =: give a value"),
    ("v = 100 ", "v = 360 km/h ", 'put a value with a unit, or a word, in quotes, as v = "360 km/h"'),
    ("m = 60.2", "m = 60,2", "write the number with a point, as m = 60.2"),
    ("[track]", "[track]\n[track]", "line 8, [track]"),
    ("m = 60.2", "m = 60.2\nm = 60", "it stands there for the second time, keep one"),
]
WORDS = [  # the command, the name in front, what the sentence quotes
    ("certify none.toml", "none.toml", "does not exist"),
    ("certify .", ".", "directory"),
    ("certify table.toml", "table.toml", "use mpsolve table table.toml"),
    ("certify study.toml", "study.toml", "use mpsolve study study.toml"),
    ("certify -", "track", "missing"),
    ("certify", "FILE", "missing"),
    ("certifi bogie.toml", "certifi", "did you mean certify?"),
    ("certify bogie.toml --digits 5", "--digits", "is 5"),
    ("certify bogie.toml --digits abc", "--digits", "'abc'"),
    ("certify bogie.toml --digits", "--digits", "no value"),
    ("certify bogie.toml --efort 1", "--efort", "did you mean --effort?"),
    ("certify bogie.toml --effort '3 kg'", "--effort", "'3 kg'"),
    ("certify bogie.toml --effort -1", "--effort", "-1"),
    ("certify bogie.toml --region circle", "--region", "'circle'"),
    ("certify bogie.toml --region below=-3", "--region", "-3"),
    ("certify bogie.toml rail.toml", "rail.toml", "more than mpsolve certify takes"),
    ("certify bogie.toml -o no/x.json", "--output", "no is no directory"),
    ("certify bogie.toml -o bogie.toml", "--output", "bogie.toml is the input file"),
    ("report bogie.toml -o x.docx", "--output", "x.docx"),
    ("report bogie.toml --pdf x.html", "--pdf", "x.html"),
    ("report bogie.toml --effort 0", "--effort", "is 0"),
    ("onset bogie.toml --over v=3", "--over", "'v=3'"),
    ("onset bogie.toml --over v=5..1", "--over", "'v=5..1'"),
    ("onset bogie.toml --over track.kpad=1..2", "--over", "'track.kpad'"),
    ("onset bogie.toml --over v=-5..10", "--over", "'-5'"),
    ("onset bogie.toml --over v=1..2 --worst v=0..1", "--worst", "names v"),
    ("onset bogie.toml --certificate c.txt", "--certificate", "c.txt"),
    ("crossings bogie.toml --over v=0..3kg", "--over", "kg"),
    ("lines bogie.toml --points 1", "--points", "is 1"),
    ("worst bogie.toml --over a=1..2", "--over", "'a'"),
    ("robust bogie.toml", "--over", "missing"),
    ("chart bogie.toml --depth 99", "--depth", "99"),
    ("chart bogie.toml --over v=1..2", "--over", "is given once"),
    ("table bogie.toml", "bogie.toml", "use mpsolve certify bogie.toml"),
    ("table table.toml --workers 0", "--workers", "is 0"),
    ("train bogie.toml", "--spacing", "missing"),
    ("train bogie.toml --spacing '1 kg'", "--spacing", "'1 kg'"),
    ("response bogie.toml -o x.csv --to '3 kg'", "--to", "'3 kg'"),
    ("response bogie.toml -o x.csv --initial fast", "--initial", "'fast'"),
    ("response bogie.toml -o x.csv --animate f.gif", "--animate", "f.gif"),
    ("compare bogie.toml -o x.tiff", "--output", "x.tiff"),
    ("critical bogie.toml --from 5 --to 1", "--to", "is 1"),
    ("critical bogie.toml -o x.doc", "--output", "x.doc"),
    ("receptance bogie.toml", "--omega", "missing"),
    ("receptance bogie.toml --omega 1,2", "--omega", "'1,2'"),
    ("receptance bogie.toml --omega 1,2,3 -o x.pdf", "--output", "x.pdf"),
    ("study bogie.toml -o s.sqlite", "bogie.toml", "use mpsolve certify bogie.toml"),
    ("study study.toml -o s.sqlite --workers -3", "--workers", "-3"),
    ("status none.sqlite", "STORE", "none.sqlite"),
    ("export none.sqlite --to xls", "--to", "'xls'"),
    ("roots 'sin(z' --rectangle -1 1 -1 1", "FUNCTION", "'sin(z'"),
    ("roots 'sin(z)'", "FUNCTION", "is given without a region"),
    ("roots 'sin(z)' --disc 0 0", "--disc", "3 values"),
    ("schema nothing", "NAME", "'nothing'"),
    ("models two-layers", "NAME", "'two-layers'"),
    ("derive --masses 0", "--masses", "is 0"),
    ("audit none", "PAPER", "none"),
    ("explore bogie.toml --port 99999999", "--port", "99999999"),
    ("new two-layer", "TRACK", "'two-layer'"),
    ("new ballasted --vehicle manchster", "--vehicle", "'manchster'"),
    ("new ballasted --v 3kg", "--v", "'3kg'"),
    ("new ballasted --spacing -5", "--spacing", "-5"),
    ("work-out per-metre", "--spacing", "missing"),
    ("work-out per-metre --k '3 kg' --spacing 0.6", "--k", "'3 kg'"),
    ("work-out per-meter", "per-meter", "did you mean per-metre?"),
]  # fmt: skip
_PYTHON = re.compile(r"Traceback|[A-Z]\w+(?:Error|Exception)\b|<class|NoneType|\bUsage:")


@pytest.fixture(autouse=True)
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, source in SAMPLES.items():
        Path(f"{name}.toml").write_text((EXAMPLES / f"{source}.toml").read_text("utf-8"), "utf-8")
    Path("table.toml").write_text((EXAMPLES / "rail_table.toml").read_text("utf-8").replace("rail_60e1", "rail"))
    study = (EXAMPLES / "study_float64.toml").read_text("utf-8").replace("two_layer_bogie", "bogie")
    Path("study.toml").write_text(study, "utf-8")


def refused(words: str, given: str | None = None) -> str:
    """What is said behind "mpsolve: ", which is one line with a remedy, and nothing of Python's."""
    before = {one.name for one in Path().iterdir()}
    done = CliRunner().invoke(cli, shlex.split(words), input=given)
    assert (done.exit_code, done.stdout, done.stderr.count("\n")) == (2, "", 1), done.output
    assert {one.name for one in Path().iterdir()} == before
    said = done.stderr.strip()
    assert said.startswith("mpsolve: ")
    assert not _PYTHON.search(said), said
    return said.removeprefix("mpsolve: ")


def with_a_remedy(said: str, name: str) -> None:
    """The name, what is wrong, and behind a colon what to do."""
    assert said.startswith(f"{name}: "), said
    problem, colon, remedy = said.removeprefix(f"{name}: ").partition(": ")
    assert problem, said
    assert colon, said
    assert len(remedy) > 5, said


@pytest.mark.parametrize(("file", "was", "written", "key", "quoted", "line"), FILES)
def test_a_value_of_the_file(file: str, was: str, written: str, key: str, quoted: str, line: int) -> None:
    path = Path(f"{file}.toml")
    text = path.read_text("utf-8")
    assert was in text
    path.write_text(text.replace(was, written, 1), "utf-8")
    said = refused(f"certify {path}")
    with_a_remedy(said, key)
    assert quoted in said
    assert said.endswith(f" (line {line} of {path})")


@pytest.mark.parametrize(("was", "written", "quoted"), BROKEN)
def test_what_is_no_toml(was: str, written: str, quoted: str) -> None:
    path = Path("bogie.toml")
    path.write_text(path.read_text("utf-8").replace(was, written, 1), "utf-8")
    said = refused(f"certify {path}")
    with_a_remedy(said, str(path))
    assert quoted in said


@pytest.mark.parametrize(("words", "name", "quoted"), WORDS)
def test_the_words_of_a_command(words: str, name: str, quoted: str) -> None:
    said = refused(words, "v = 3\n" if words.endswith(" -") else None)
    with_a_remedy(said, name)
    assert quoted in said


def test_all_commands_are_asked() -> None:
    asked = {words.split()[0] for words, _, _ in WORDS}
    assert asked >= {*cli.list_commands(None)} - {"verify"}  # type: ignore[arg-type]  # which says so on its output
