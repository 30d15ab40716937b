"""Bad input of every command: one sentence that names the user's own key or file, exit status 2, nothing printed."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from mpsolve import read_problem
from mpsolve.cli import cli

ROOT = Path(__file__).parents[1]
GOOD = (ROOT / "examples/two_layer_bogie.toml").read_text("utf-8")
FILES: dict[str, str | bytes] = {
    "good.toml": GOOD,
    "a.csv": "v,EI\n100,6e6\n",
    "a.xlsx": b"PK\x03\x04\x14\x00\x06\x00\x08\x00\xff\xfe",
    "a.json": '{"v": 100}',
    "answer.json": '{"format": "mpsolve onset", "version": 1}',
    "cert.json": (ROOT / "certs/single_mass.json").read_text("utf-8"),
    "page.html": "<html>",
    "note.toml": "a note to me",
    "empty.toml": "",
    "comment.toml": "# nothing yet, but = and [\n",
    "latin.toml": GOOD.replace("bogie", "b\xf6gie", 1).encode("latin-1"),
    "utf16.toml": GOOD.encode("utf-16"),
    "cr.toml": GOOD.replace("\n", "\r"),
    "table.toml": (ROOT / "examples/onset_table.toml").read_text("utf-8"),
    "study.toml": (ROOT / "examples/study_certified.toml").read_text("utf-8"),
}
VELOCITIES = {
    "-100": "v: is -100, but must not be below 0",
    "nan": "v: 'nan' is not finite",
    "true": "v: is of type bool, not a number: write a decimal such as 0.67 or a ratio such as 67/100, with a unit",
    "[100]": "v: is of type list",
    "2024-01-01": "v: is of type date",
    '"100 kmh"': "did you mean km/h?",
    '"27,7"': "v: is '27,7', with a comma",
    "27,7": "line 3, v = 27,7: write the number with a point",
    "100 km/h": "put a value with a unit, or a word, in quotes",
    '"12 t"': "v: is '12 t', whose unit is kg, but the velocity is in m/s",
    "1e400": "v: needs more than 400 digits",
    "100\nv = 1": "it stands there for the second time, keep one",
}
CHANGES = {
    "EI =|Ei =": "track.Ei: is unknown: did you mean EI? (line",
    "[track]|[trak]": "trak: is unknown: did you mean track? (line",
    "[[vehicle]]|[vehicle]": "vehicle: is a table: write [[vehicle]]",
    "[[vehicle]]|[[vehicles]]": "vehicles: is unknown: did you mean vehicle? (line",
    '"two-layer"|"twolayer"': "track.model: is 'twolayer', which is unknown: did you mean two-layer?",
    "EI = 6.38043e6|EI = 0": "track.EI: is 0, but must be above 0",
    'k_pad = 300e6|k_pad = "180 kN/mm"': "as 180 kN/mm/(0.6 m)",
    "[[vehicle]]|[[vehicle]]\ncount = 3": "vehicle[1].spacing: is missing",
    "[[vehicle]]|[[vehicle]]\nspacing = 30\ncount = 0": "vehicle[1].count: is 0: give a whole number",
    "[[vehicle]]|[[load]]\nconstant = 1\n[[vehicle]]": "load: is given for 1, not 2 contacts",
    "v = 100|# v": "v: is missing: give the velocity",
}
WORDS = {
    "certify a.csv": "a.csv: is a table of values, not TOML",
    "report a.xlsx": "a.xlsx: is no text: give a TOML file, a plain text; no spreadsheet",
    "critical a.json": "a.json: is JSON, not TOML: mpsolve new ballasted",
    "onset answer.json": "answer.json: is an answer (mpsolve onset), not an input file",
    "derive cert.json": "cert.json: is a certificate, not an input file: check it with mpsolve verify cert.json",
    "explore page.html --no-browser": "page.html: is a web page or a picture",
    "crossings note.toml": "note.toml: is a text, not TOML, which has lines like v = 10",
    "table empty.toml": "problem: is missing",
    "lines empty.toml": "empty.toml: holds no problem",
    "worst comment.toml": "comment.toml: holds no problem",
    "train latin.toml": "latin.toml: has a character in line 1 that is not in UTF-8: save the file as UTF-8",
    "robust utf16.toml --over v=1..2": "utf16.toml: is a text in UTF-16: save it as UTF-8",
    "chart cr.toml": "cr.toml: has lines that end in a carriage return alone",
    "response . -o x.csv": ".: is a directory",
    "compare gone.toml -o x.svg": "gone.toml: does not exist",
    "certify table.toml": "table.toml: is a table, as its [rows] shows: use mpsolve table",
    "certify study.toml": "study.toml: is a study, as its [study] shows: use mpsolve study",
    "study good.toml -o s.sqlite": "is a problem, as its [track] shows: use mpsolve certify good.toml",
    "certify good.toml --digits 5": "--digits: is 5",
    "certify good.toml --region foo": "--region: is 'foo'",
    "certify good.toml --region 2,1,3,4": "--region: re_max is 1, not above re_min = 2",
    "certify good.toml --effort fast": "--effort: 'fast' is not a number: write a decimal",
    "certify good.toml -o no/x.json": "--output: no is no directory",
    "certify good.toml -o good.toml": "--output: good.toml is the input file",
    "certify good.toml --dijits 20": "--dijits: is no option of mpsolve certify: did you mean --digits?",
    "report good.toml -o x.docx": "--output: x.docx does not end in .html",
    "onset good.toml --over v": "--over: is 'v', which names no parameter",
    "onset good.toml --over v=5..1": "--over: is 'v=5..1', whose ends do not ascend",
    "onset good.toml --over v=a..b": "--over: 'a' is not a number: write a decimal such as 0.67",
    "onset good.toml --over track.kk=1..2": "--over: names 'track.kk', which is unknown",
    "onset good.toml --over v=1..2 --over track.EI=1..2": "--over: names 2 parameters, but this question",
    "onset good.toml --over track.EI=-1..2": "--over: starts or ends at '-1'",
    "crossings good.toml --over v=0..1kg": "--over: is '0 kg', whose unit is kg",
    "lines good.toml --over v=1..2 --points 1": "--points: is 1",
    "worst good.toml --over gap[0]=1..2": "--over: names 'gap[0]', which is unknown",
    "robust good.toml": "--over: is missing",
    "robust good.toml --over v=1..2 --over v=2..3": "--over: names v twice",
    "chart good.toml --over v=1..2": "--over: is given once, but a chart is over two parameters",
    "train good.toml --spacing -5": "--spacing: is -5, but must be above the vehicle's own length",
    "response good.toml -o x.csv --to 5kg": "--to: is '5kg', whose unit is kg, but the time is in s",
    "receptance good.toml --omega 1,2": "--omega: is '1,2': give FIRST,LAST,COUNT",
    "receptance good.toml --omega 1,2,3 --xi q": "--xi: 'q' is not a number",
    "status gone.sqlite": "STORE: gone.sqlite does not exist",
    "export a.csv --to pdf": "--to: is 'pdf': give one of csv, json, npz, parquet",
    'roots "sin(" --rectangle -1 1 -1 1': "FUNCTION: is 'sin(', which cannot be read",
    'roots "sin(z)" --rectangle 1 -1 -1 1': "--rectangle: re_max is -1, not above re_min = 1",
    'roots "sin(z)" --disc 0 0 -1': "--disc: radius",
    'roots "sin(z)"': "FUNCTION: is given without a region",
    "schema nosuch": "NAME: is 'nosuch', which is unknown",
    "models nosuch": "NAME: is 'nosuch', which is unknown",
    "new nosuch": "TRACK: is 'nosuch', which is unknown",
    "new ballasted --v fast": "--v: 'fast' is not a number",
    "new ballasted -o good.toml": "--output: good.toml exists",
    "work-out per-metre --k 5 --spacing 0": "--spacing: is 0, but must be above 0",
    "audit nosuch": "PAPER: nosuch is neither a folder nor a module",
    "certfy good.toml": "certfy: is no command of mpsolve: did you mean certify?",
}


@pytest.fixture(autouse=True)
def _inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, content in FILES.items():
        Path(name).write_bytes(content if isinstance(content, bytes) else content.encode())


def refused(words: str, said: str) -> None:
    done = CliRunner().invoke(cli, shlex.split(words))
    assert (done.exit_code, done.stdout) == (2, ""), words
    assert re.fullmatch(r"mpsolve: [^\n]+\n", done.stderr), done.stderr
    assert said in done.stderr, words


@pytest.mark.parametrize("words", WORDS)
def test_words(words: str) -> None:
    refused(words, WORDS[words])


def test_every_command_is_among_them() -> None:
    tried = {words.split()[0] for words in WORDS}
    assert tried >= set(cli.list_commands(None)) - {"verify"}  # type: ignore[arg-type]


@pytest.mark.parametrize("v", VELOCITIES)
def test_velocities(v: str) -> None:
    Path("mine.toml").write_text(GOOD.replace("v = 100", f"v = {v}", 1), "utf-8")
    refused("certify mine.toml", VELOCITIES[v])


@pytest.mark.parametrize("change", CHANGES)
def test_changes(change: str) -> None:
    assert change.split("|")[0] in GOOD
    Path("mine.toml").write_text(GOOD.replace(*change.split("|"), 1), "utf-8")
    refused("certify mine.toml", CHANGES[change])


@pytest.mark.parametrize("as_it_comes", [GOOD.replace("\n", "\r\n").encode(), b"\xef\xbb\xbf" + GOOD.encode()])
def test_windows_may_have_written_it(as_it_comes: bytes) -> None:
    Path("mine.toml").write_bytes(as_it_comes)
    assert read_problem("mine.toml").problem == read_problem("good.toml").problem
