"""What examples/handover hands over is read by others as it stands, and leads them to the certified roots."""

from __future__ import annotations

import csv
import importlib.util
import json
import re
import shlex
import shutil
import subprocess
from fractions import Fraction
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from click.testing import CliRunner
from schema_check import errors

from mpsolve import Case, PhysicalCase, certify, read_problem, receptance
from mpsolve.cli import cli
from mpsolve.problem.cases import as_problem
from mpsolve.report.receptances import receptances
from mpsolve.schemas.catalogue import schema_of

FOLDER = Path(__file__).parents[1] / "examples" / "handover"
SHELL = (FOLDER / "shell.sh").read_text("utf-8")


@pytest.fixture(scope="module")
def solver() -> ModuleType:
    spec = importlib.util.spec_from_file_location("other_solver", FOLDER / "other_solver.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def folder(solver: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("handover")
    assert [path.name for path in solver.write(place)] == ["seeds.csv", "seeds.json", "seeds.npz", "receptance.csv"]
    return place


def test_newton_from_the_seeds_finds_the_certified_roots(solver: ModuleType, folder: Path) -> None:
    found = solver.newton(folder / "seeds.csv")
    roots = []
    for alpha in solver.GRID["alpha"]:
        case = Case(alpha=alpha, eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
        roots += [complex(root.q.mid()) for root in certify(case).roots]
    assert len(found) == len(roots)
    for (seed, root, radius), truth in zip(found, roots, strict=True):
        assert abs(seed - truth) < 1e-14
        assert abs(root - truth) < 1e-9
        assert radius > 1e-3


def test_all_forms_hold_the_same_seeds(folder: Path) -> None:
    with (folder / "seeds.csv").open() as stream:
        rows = list(csv.DictReader(stream))
    content = json.loads((folder / "seeds.json").read_text())
    with np.load(folder / "seeds.npz") as arrays:
        q = arrays["q"]
    assert [complex(float(row["q_re"]), float(row["q_im"])) for row in rows] == q.tolist()
    assert [complex(*seed["q"]) for seed in content["seeds"]] == q.tolist()


@pytest.fixture(scope="module")
def shell(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder with what the commands of shell.sh write."""
    place = tmp_path_factory.mktemp("shell")
    (place / "examples").symlink_to(FOLDER.parent)
    (value,) = re.findall(r"^case=(\S+)$", SHELL, flags=re.MULTILINE)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(place)
        for line in re.findall(r"^mpsolve .*$", SHELL, flags=re.MULTILINE):
            command, _, target = line.replace("$case", value).partition(" > ")
            done = CliRunner().invoke(cli, shlex.split(command)[1:])
            assert done.exit_code == 0, f"{line}: {done.output}"
            if target:
                Path(target).write_text(done.stdout, "utf-8")
    return place


def test_the_shell_hands_over_the_same_in_json(solver: ModuleType, folder: Path, shell: Path) -> None:
    roots = json.loads((shell / "induced.json").read_text("utf-8"))["roots"]
    truth = [complex(root.q.mid()) for root in certify(solver.CASE).roots]
    assert [complex(float(root["re"]["value"]), float(root["im"]["value"])) for root in roots] == truth
    onset = json.loads((shell / "onset.json").read_text("utf-8"))["answer"]["value"]
    assert abs(float(onset["decimal"]) - float(solver.first_unstable())) < 1e-12
    table = json.loads((shell / "receptance.json").read_text("utf-8"))
    G = receptance(solver.TRACK, solver.XI, solver.OMEGA, v=solver.CASE.alpha)
    assert np.array_equal(np.array(table["G_re"]) + 1j * np.array(table["G_im"]), G)
    assert table["track"]["model"] == "euler-bernoulli"
    assert Fraction(table["track"]["EI"]) == solver.TRACK.EI
    assert (tuple(table["xi"]), table["omega"]) == (solver.XI, solver.OMEGA.tolist())
    assert (shell / "receptance.csv").read_text() == (folder / "receptance.csv").read_text()


def test_shapes_stiffness_and_the_stable_box(solver: ModuleType, shell: Path) -> None:
    """Roots come with shapes; at a root the dynamic stiffness balances the masses; the box is that of the library."""
    roots = json.loads((shell / "induced.json").read_text("utf-8"))["roots"]
    for root, truth in zip(roots, certify(solver.CASE).roots, strict=True):
        for name, ball in truth.shape.bodies.items():
            shown = root["shape"]["bodies"][name]
            assert (
                abs(complex(float(shown["re"]["value"]), float(shown["im"]["value"])) - complex(ball.mid())) < 1e-12
            )
        assert len(root["shape"]["rail"]) == 2
    table = json.loads((shell / "contacts.json").read_text("utf-8"))
    assert errors(table, schema_of("receptance")) == []
    G, K = (np.array(table["contacts"][f"{x}_re"]) + 1j * np.array(table["contacts"][f"{x}_im"]) for x in "GK")
    places = as_problem(solver.CASE).pencil.places
    for k, omega in enumerate(table["omega"]):
        near = receptance(solver.TRACK, [float(a - b) for a in places for b in places], omega, v=solver.CASE.alpha)
        assert np.allclose(G[k].ravel(), near[:, 0], rtol=1e-13)
        assert np.allclose(K[k] @ G[k], np.eye(2), atol=1e-12)
    box = json.loads((shell / "box.json").read_text("utf-8"))["answer"]
    assert box["stable"] is True
    assert [end["exact"] for end in box["over"]["v"]] == ["0", "3/5"]


def test_the_receptance_in_si_units() -> None:
    """At rest, under a static force, Winkler's deflection F χ/(2k)."""
    case = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=0, masses=[(1, 0)])
    content = json.loads(receptances(as_problem(case), "", (0.0,), (0.0,)).to_json())
    chi = (1e6 / (4 * 6.4e6)) ** 0.25
    assert content["G_re"][0][0] == pytest.approx(chi / 2e6, rel=1e-12)
    assert (Fraction(content["track"]["EI"]), Fraction(content["v"])) == (6400000, 0)


def test_the_command_takes_any_track() -> None:
    done = CliRunner().invoke(cli, ["receptance", str(FOLDER.parent / "two_layer_bogie.toml"), "--omega", "10,900,3"])
    assert done.exit_code == 0, done.output
    rows = list(csv.reader(done.stdout.splitlines()))
    track = read_problem(FOLDER.parent / "two_layer_bogie.toml").problem
    G = receptance(track.track, 0, [10, 455, 900], v=track.v)[0]
    assert rows[0] == ["omega [rad/s]", "re_G(0) [m/N]", "im_G(0) [m/N]"]
    assert [complex(float(a), float(b)) for _, a, b in rows[1:]] == G.tolist()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--omega", "0.1"], "--omega: is '0.1': give FIRST,LAST,COUNT"),
        (["--omega", "0.1,0.2,0"], "a whole COUNT from 1"),
        (["--omega", "0.1,x,3"], "--omega: "),
        (["--omega", "0.1,0.2,3", "--xi", "a"], "--xi: "),
        (["--omega", "0.1,0.2,3", "--contacts"], "which CSV does not hold: add --json"),
        (["--omega", "0.1,0.2,3", "-o", "none/a.csv"], "none is no directory"),
    ],
)
def test_receptances_that_cannot_be(words: list[str], said: str) -> None:
    done = CliRunner().invoke(cli, ["receptance", str(FOLDER.parent / "dimensionless.toml"), *words])
    assert (done.exit_code, len(done.output.splitlines())) == (2, 1)
    assert said in done.output


DELTA = """function v = delta(q, alpha, eta_b, eta, d)
  p = roots([1, 0, -4*alpha^2, 8*alpha*q - 8i*eta_b*alpha, 4 - 4*q*q + 8i*eta_b*q]);
  w = 2i*pi ./ (4*p.^3 - 8*alpha^2*p + 8*alpha*q - 8i*eta_b*alpha);
  u = imag(p) > 0;
  a = 2*eta*q*q/pi;
  v = (1 - a*sum(w(u)))^2 + a*a*sum(w(u).*exp(1i*p(u)*d))*sum(w(~u).*exp(-1i*p(~u)*d));
end
"""
SCRIPT = """
roots_found = read_seeds('seeds.csv', @delta);
printf('%.17g %.17g\\n', [real(roots_found), imag(roots_found)].');
[omega, xi, G] = read_receptance('receptance.csv');
printf('%.17g %.17g %.17g %.17g\\n', omega(3), xi(1), real(G(3, 1)), imag(G(3, 1)));
[alpha, q] = read_onset('onset.json');
printf('%.17g %.17g\\n', alpha, q);
"""


@pytest.mark.skipif(shutil.which("octave-cli") is None, reason="Octave, which runs MATLAB's text, is not installed")
def test_octave_reads_seeds_receptance_and_onset(
    solver: ModuleType, folder: Path, shell: Path, tmp_path: Path
) -> None:
    for file in [folder / "seeds.csv", *(shell / name for name in ("receptance.csv", "onset.json"))]:
        shutil.copy(file, tmp_path)
    (tmp_path / "delta.m").write_text(DELTA)
    (tmp_path / "script.m").write_text(f"addpath('{FOLDER}');{SCRIPT}")
    command = ["octave-cli", "--norc", "--quiet", "script.m"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120, check=True)
    *roots, table, onset = ([float(word) for word in line.split()] for line in done.stdout.splitlines())
    truth = [root for _, root, _ in solver.newton(folder / "seeds.csv")]
    assert np.allclose([complex(*root) for root in roots], truth, rtol=0, atol=1e-12)
    G = receptance(solver.TRACK, solver.XI, solver.OMEGA, v=solver.CASE.alpha)[0, 2]
    assert table == [solver.OMEGA[2], solver.XI[0], G.real, G.imag]
    assert onset == pytest.approx([0.66691895728454957, 0.15620777798805937], rel=1e-15)


def test_the_maple_readers_name_what_is_there(folder: Path, shell: Path) -> None:
    """Maple is not at hand in the tests: what can be held is that the names and their forms agree."""
    header = (folder / "seeds.csv").read_text().splitlines()[0].split(",")
    used = re.findall(r'column\("(\w+)"\)', (FOLDER / "read_seeds.mpl").read_text())
    assert {"alpha", "eta_b", "eta_m", "d", "q_re", "q_im", "radius"} == set(used) <= set(header)
    names = (shell / "receptance.csv").read_text().splitlines()[0].split(",")
    assert '"re_G("' in (FOLDER / "read_receptance.mpl").read_text()
    assert all(re.fullmatch(r"(re|im)_G\([-\d.]+\)", name) for name in names[1:])
    onset = json.loads((shell / "onset.json").read_text("utf-8"))["answer"]
    paths = re.findall(r'answer\["(\w+)"\]\["(\w+)"\]', (FOLDER / "read_onset.mpl").read_text())
    assert [float(onset[key][part]) > 0 for key, part in paths] == [True, True]


def test_the_receptance_table_and_the_onset(solver: ModuleType, folder: Path) -> None:
    with (folder / "receptance.csv").open() as stream:
        rows = list(csv.reader(stream))
    assert rows[0][:3] == ["omega", "re_G(-1.5)", "im_G(-1.5)"]
    assert len(rows) == 1 + len(solver.OMEGA)
    assert solver.first_unstable() == "0.666918957285"
