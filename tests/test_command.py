"""Does the command line do what it says, and answer every mistake with a sentence and status 2?"""

import json
import subprocess
import sys
import time

import pytest

import drawbar
from drawbar.__main__ import main


@pytest.fixture
def run(monkeypatch, capsys, tmp_path):
    """Run the command line in an empty folder; gives (status, output, error)."""
    monkeypatch.chdir(tmp_path)

    def command(*words):
        monkeypatch.setattr(sys, "argv", ["drawbar", *map(str, words)])
        with pytest.raises(SystemExit) as stopped:
            main()
        told = capsys.readouterr()
        return stopped.value.code, told.out, told.err

    return command


def test_help_comes_at_once():
    start = time.perf_counter()
    told = subprocess.run([sys.executable, "-m", "drawbar", "--help"], capture_output=True, text=True, check=True)
    assert time.perf_counter() - start < 5.0  # the target is half a second; the benchmark measures
    for verb in ("reproduce", "rig", "simulate", "identify", "compare", "laws"):
        assert verb in told.stdout
    heavy = "import sys, drawbar, drawbar.__main__; print([m for m in ('scipy', 'matplotlib', 'numba', 'xarray', 'pint') if m in sys.modules])"
    assert (
        subprocess.run([sys.executable, "-c", heavy], capture_output=True, text=True, check=True).stdout.strip() == "[]"
    )


def test_laws_lists_everything_with_units_bounds_and_sources(run):
    status, out, _ = run("laws")
    assert status == 0
    for word in (
        "Winkler",
        "FilonenkoBorodich",
        "CouetteCoulomb",
        "foam-2004",
        "bovine-liver-2004",
        "robot-2004",
        "Pa/m",
        "Source:",
        "force_noise",
    ):
        assert word in out


def test_rig_prints_a_table_and_writes_the_run(run, tmp_path):
    status, out, _ = run(
        "rig", "--load", "0.137,0.275 N", "--speed-ratio", "0.5:1.5:3", "--repeats", "3", "--noise", "force_noise=5 mN"
    )
    assert status == 0
    assert "18 rows" in out
    assert {p.name for p in (tmp_path / "out/rig").iterdir()} == {"rig.nc", "rig.csv", "rig.png", "rig.svg"}
    rows, table = drawbar.load(tmp_path / "out/rig/rig.csv"), drawbar.load(tmp_path / "out/rig/rig.nc")
    assert rows.drawbar_force.values == pytest.approx(table.drawbar_force.values, rel=1e-15)
    known = drawbar.steady(
        *(drawbar.find(k, n) for k, n in (("wheel", "robot-2004"), ("tissue", "foam-2004"), ("film", "film-assumed"))),
        normal_load=0.137,
        speed=0.0254,
        speed_ratio=0.5,
    )
    assert float(rows.drawbar_force[0]) == pytest.approx(float(known.drawbar_force), abs=0.005)
    status, _, err = run("rig")
    assert (status, "exist. Give --force" in err) == (2, True)
    status, _, err = run("rig", "--out", "out/rig/rig.csv")
    assert (status, "is a file" in err) == (2, True)
    assert run("rig", "--force")[0] == 0


def test_locked_free_and_reverse_runs_by_option(run):
    status, out, _ = run("rig", "--wheel-speed", "0", "--speed", "-20,20 mm/s", "--out", "locked")
    assert status == 0
    assert "2 rows" in out
    assert run("rig", "--wheel-torque", "0", "--history", "--damper", "0.5 N s/m", "--out", "free")[0] == 0


def test_simulate_closes_its_ledger(run, tmp_path):
    status, out, _ = run(
        "simulate", "--drawbar", "0.02 N", "--wheel-torque", "0.4 mN m", "--duration", "1 s", "--damper", "0.5 N s/m"
    )
    assert status == 0
    assert "ledger error" in out
    assert (tmp_path / "out/simulate/simulation.svg").exists()


def test_from_logs_to_laws_to_a_prediction(run, tmp_path):
    assert run("logs", "--out", "logs")[0] == 0
    kinds = {p.name for p in (tmp_path / "logs").iterdir()}
    plates = next(n for n in kinds if "plates" in n)
    drags = next(n for n in kinds if "drags" in n)
    status, out, _ = run("identify", "stiffness", f"logs/{plates}", "--out", "fit")
    assert status == 0
    assert "stiffness" in out
    status, out, _ = run("identify", "film", f"logs/{drags}", "--out", "fit")
    assert status == 0
    assert "viscous_coefficient" in out.replace(" ", "_")
    status, out, _ = run("rig", "--tissue", "fit/stiffness.toml", "--film", "fit/film.toml")
    assert status == 0
    for log in kinds:
        assert "virtual rig" in (tmp_path / "logs" / log).read_text(encoding="utf-8")


def test_a_foreign_log_goes_from_file_to_comparison(run, tmp_path):
    lines = ["rim;v;load;pull;angle"] + [
        f"{rim};10;-{load};{load * (0.1 - rim / 100)};0" for rim in (5, 10, 20) for load in (18, 22)
    ]
    (tmp_path / "foreign.csv").write_text("\n".join(lines) + "\n1;2;3;4;90\n")
    reading = [
        "--map",
        "rim=rim_speed [mm/s]",
        "--map",
        "v=slide_speed [mm/s]",
        "--map",
        "-load=normal_load [N]",
        "--map",
        "-pull=drawbar_force [N]",
        "--set",
        "wheel_radius=58 mm",
        "--where",
        "angle=0",
    ]
    status, out, err = run("load", "foreign.csv", *reading, "--out", "ours.csv")
    assert status == 0, err
    assert "6 rows" in out
    assert "left out" in out
    status, _, err = run(
        "rig",
        "--at",
        "ours.csv",
        "--wheel",
        "Wheel(radius=58 mm, width=50 mm)",
        "--tissue",
        "Winkler(stiffness=1 MPa/m)",
    )
    assert status == 0, err
    status, out, err = run("compare", "out/rig/rig.nc", "ours.csv")
    assert status == 0, err
    assert "scale" in out
    assert "NRMSE" in out


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["rig", "--tissue", "foam"], "Did you mean 'foam-2004'"),
        (["rig", "--load", "28 g"], "mass is not a force"),
        (["rig", "--load", "-1 N"], "normal_load must be >= 0 N"),
        (["rig", "--wheel", "Wheel(radius=15, width=20 mm)"], "diameter, or in millimetres?"),
        (["rig", "--speed-ratio", "1", "--wheel-speed", "0"], "exactly one of speed_ratio, wheel_speed, wheel_torque"),
        (["rig", "--noise", "force_nose=5 mN"], "Did you mean 'force_noise'"),
        (["rig", "--out", "/proc/nowhere"], "drawbar: "),
        (["simulate", "--start", "rest"], "start must be 'touch-down' or 'equilibrium'"),
        (["identify", "stiffness", "none.csv"], "none.csv"),
        (["identify", "stiffness", "."], "folder"),
        (["compare", "a.csv", "b.csv"], "a.csv"),
        (["load", "x.csv", "--map", "Fx"], "is not name=value"),
        (["rig", "--lode", "1"], "No such option"),
        (["frobnicate"], "No such command"),
    ],
)
def test_a_mistake_gets_a_sentence_status_2_and_no_traceback(run, words, sentence, tmp_path):
    status, out, err = run(*words)
    assert status == 2
    assert sentence in " ".join(err.split())
    assert "Traceback" not in out + err
    assert not [p for p in tmp_path.rglob("*") if p.is_file()]


def test_reproduce_writes_one_whole_report(run, tmp_path):
    status, out, err = run("reproduce")
    assert status == 0, err
    folder = tmp_path / "out/reproduce"
    page = (folder / "report.html").read_text(encoding="utf-8")
    for number in (7, 8, 9, 10, 11, 13, 14, 15, 16, 17):
        assert f"Fig. {number}:" in page
        assert (folder / f"figures/figure_{number:02}.svg").exists()
        assert (folder / f"figures/figure_{number:02}.png").exists()
    for mark in ("computed", "virtual data", "printed words only"):
        assert f'<span class="kind">{mark}</span>' in page
    assert "http://" not in page.replace("http://www.w3.org", "")
    assert "https://" not in page
    outcomes = json.loads((folder / "outcomes.json").read_text(encoding="utf-8"))
    assert [o["outcome"] for o in outcomes] == [f"P{i}" for i in range(1, 11)]
    assert all(o["reason"] and o["criterion"] and o["model"] for o in outcomes)
    assert next(o for o in outcomes if o["outcome"] == "P6")["verdict"] == "not reproduced"
    assert "P10" in out
    assert len(list((folder / "data").glob("*.nc"))) >= 10
    status, _, err = run("reproduce")
    assert (status, "exists. Give --force" in err) == (2, True)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/thesis.txt").write_text("years of work")
    status, _, err = run("reproduce", "--out", "mine", "--force")
    assert (status, "holds other files" in err) == (2, True)
    assert (tmp_path / "mine/thesis.txt").exists()
