"""Does a log say the same as the rig, whatever wrote it, and does a bad one get a sentence that helps?"""

import codecs
import math
import tempfile
import time
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings
from hypothesis import strategies as st

from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.motion.steady import grid, steady
from drawbar.rig.drawbar_test import drawbar_test
from drawbar.rig.load import load
from drawbar.rig.plate_test import plate_test
from drawbar.rig.sensors import Sensors
from drawbar.rig.write import write_csv, write_netcdf
from drawbar.tissue.winkler import Winkler
from drawbar.variables import OBSERVATION, VARIABLES, declare, tidy
from drawbar.wheel.base import Wheel

WHEEL, TISSUE = Wheel(radius=0.0075, width=0.020), Winkler(stiffness=225e3)
FILM = CouetteCoulomb(viscous_coefficient=1e4, yield_stress=40.0)
SENSORS = Sensors(force_noise=0.01, torque_noise=1e-5, angle_noise=1e-3)

# What a foreign laboratory may hand over: names and signs of its own, no units, angles to leave out.
FOREIGN = """Vry,beta,trial_num,slip,avg_Vx,avg_Vry,avg_Fy,avg_Fz,avg_Z
0,0,1,-1,10.0,0,38.2,-20.1,-50.1
3,30,1,-0.699,9.99,3.00,25.6,-20.3,-38.7
20,0.0,1,0.5,9.99,20.0,-0.77,-26.1,-23.0
20,0,2,0.5,10.01,20.1,-0.81,-25.2,x
"""
FOREIGN_MAP = {
    "avg_Vx": "slide_speed [mm/s]", "avg_Vry": "rim_speed [mm/s]", "-avg_Fy": "drawbar_force [N]",
    "-avg_Fz": "normal_load [N]", "trial_num": "trial",
}  # fmt: skip
FOREIGN_SET = {"wheel_radius": "58 mm", "wheel": "smooth"}

names = st.text(st.characters(exclude_categories=("Cc", "Cs"))).map(str.strip).filter(bool)


def log(folder, content, name="log.csv"):
    path = Path(folder) / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def assert_same(found, expected):
    assert set(found.variables) == set(expected.variables)
    assert set(found.coords) == set(expected.coords)
    for name, column in expected.variables.items():
        assert found[name].dims == (OBSERVATION,)
        found_attrs, attrs = ({k: np.asarray(v).tolist() for k, v in x.attrs.items()} for x in (found[name], column))
        assert found_attrs == attrs
        if column.dtype.kind == "f":
            assert found[name].values.tobytes() == column.values.tobytes(), name
        else:
            assert found[name].values.tolist() == column.values.tolist()


# The virtual rig and the laboratory are one format ------------------------------------------------


@settings(max_examples=20)
@given(st.integers(0, 99), st.sampled_from([0.0, 1.5, 6.7]), st.sampled_from([0.0254, -0.01]), names, names)
def test_rig_written_and_loaded_is_the_same_bit_for_bit(seed, wheel_speed, speed, wheel, tissue):
    runs = drawbar_test(WHEEL, TISSUE, FILM, normal_load=[0.1, 0.27], speed=speed, wheel_speed=wheel_speed, repeats=2,
                        sensors=SENSORS, seed=seed, labels={"wheel": wheel, "tissue": tissue})  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        found = load(write_csv(runs, Path(folder) / "runs.csv"))
    assert_same(found, runs)
    assert found.attrs == {**runs.attrs, "file": "runs.csv"}


@settings(max_examples=50)
@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=1))
def test_every_finite_number_survives_text(numbers):
    rows = declare({"side_force": (OBSERVATION, np.array(numbers))})
    with tempfile.TemporaryDirectory() as folder:
        assert_same(load(write_csv(rows, Path(folder) / "rows.csv")), rows)


def test_plate_test_survives_text(tmp_path):
    rows = plate_test(TISSUE, applied_mass=[0.01, 0.02], plate_area=1e-4, sets=2, spread=0.1)
    found = load(write_csv(rows, tmp_path / "plate.csv", comments=["three plates: broken\nby now"]))
    assert_same(found, rows)
    assert found.attrs["three_plates"] == "broken by now"


def test_netcdf_keeps_maps_and_loads_as_rows(tmp_path):
    result = steady(WHEEL, TISSUE, FILM, **grid(normal_load=[0.1, 0.2], wheel_speed=[0.0, 3.0]), speed=0.0254)
    result.attrs |= {"made": True, "folder": tmp_path, "none": None, "numbers": np.array([1.0, 2.0]), "empty": ""}
    path = write_netcdf(result, tmp_path / "map.nc")
    assert xr.load_dataset(path, engine="h5netcdf").sizes == {"normal_load": 2, "wheel_speed": 2}
    found = load(path)
    assert_same(found, tidy(result))
    assert found.attrs["made"] == "True"
    assert np.isnan(found.speed_ratio.values[found.wheel_speed.values == 0.0]).all()


def test_labels_survive_netcdf(tmp_path):
    runs = drawbar_test(
        WHEEL, TISSUE, FILM, normal_load=0.1, speed=0.02, wheel_speed=[0, 3], labels={"wheel": "rund µ"}
    )
    assert_same(load(write_netcdf(runs, tmp_path / "runs.nc")), runs)


def test_comments_become_attributes(tmp_path):
    found = load(log(tmp_path, "# origin: virtual rig\n# by hand\n#date: 2024-05-01 10:00\n# gain: 2.5\ntime [s]\n1\n"))
    assert found.attrs == {
        "origin": "virtual rig", "comment": "by hand", "date": "2024-05-01 10:00", "gain": 2.5, "file": "log.csv",
    }  # fmt: skip


def test_a_label_stays_text_in_a_spreadsheet(tmp_path):
    labels = ["=1+1", "+a", "-b", "@c", "'=d", "'e", "#f", 'g "h", i']
    rows = declare({"wheel": (OBSERVATION, labels), "time": (OBSERVATION, np.arange(8.0))}, coords=["wheel"])
    path = write_csv(rows, tmp_path / "rows.csv")
    assert not any(cell.lstrip('"')[:1] in "=+@-" for cell in path.read_text().replace("\n", ",").split(",") if cell)
    assert load(path).wheel.values.tolist() == labels


# What laboratories write --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("header", "cell", "si"),
    [
        ("slide_speed [mm/s]", "25.4", 0.0254),
        ("normal_load [gf]", "28", 0.2745862),
        ("drawbar_force [mN]", "-53", -0.053),
        ("deflection [µm]", "120", 120e-6),
        ("plate_area [mm^2]", "400", 4e-4),
        ("applied_mass [g]", "50", 0.05),
        ("wheel_radius [in]", "0.25", 0.00635),
        ("wheel_speed [rpm]", "30", math.pi),
        ("wheel_torque [mN m]", "0.3", 3e-4),
        ("contact_half_angle [deg]", "45", math.pi / 4),
        ("lever_angle [°]", "90", math.pi / 2),
        ("time[ms]", "5", 0.005),
        ("speed_ratio [1]", "0.5", 0.5),
        ("slip [%]", "50", 0.5),
        ("peak_pressure [kPa]", "3", 3000.0),
    ],
)
def test_units_become_si(tmp_path, header, cell, si):
    name = header.partition("[")[0].strip()
    found = load(log(tmp_path, f"{header}\n{cell}\n"))[name]
    assert found.values == pytest.approx([si], rel=1e-12)
    assert found.attrs["units"] == VARIABLES[name].unit


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-32", "latin-1"])
def test_encodings(tmp_path, encoding):
    found = load(log(tmp_path, "deflection [µm],tissue\n2,Kälberleber\n".encode(encoding)))
    assert found.deflection.values == pytest.approx([2e-6])
    assert found.tissue.values.tolist() == ["Kälberleber"]


@pytest.mark.parametrize(
    "content",
    [
        "time [s],wheel_torque [mN m],wheel\n1.5,2,a\n3.0,4,b\n",
        "time [s];wheel_torque [mN m];wheel\r\n1,5;2;a\r\n3,0;4;b\r\n",
        "time [s]\twheel_torque [mN m]\twheel\n1,5\t2\ta\n3,0\t4\tb",
        "time [s]|wheel_torque [mN m]|wheel\n1.5|2|a\n3.0|4|b\n",
        "  time [s]  wheel_torque [mN m]   wheel\n 1.5   2 a\n 3.0\t4 b \n",
        "sep=;\ntime [s];wheel_torque [mN m];wheel\n1.5;2;a\n3.0;4;b\n",
        '"time [s]", "wheel_torque [mN m]", "wheel"\n1.5, 2, "a"\n3.0, 4, "b"\n',
        "# x, y\n\ntime [s],wheel_torque [mN m],wheel,,\n\n1.5,2,a,,\n,,,,\n# z\n3.0,4,b,,\n\n\n",
    ],
)
def test_separators_decimal_signs_and_clutter(tmp_path, content):
    found = load(log(tmp_path, content))
    assert found.time.values.tolist() == [1.5, 3.0]
    assert found.wheel_torque.values.tolist() == [0.002, 0.004]
    assert found.wheel.values.tolist() == ["a", "b"]


def test_a_single_column_with_decimal_commas(tmp_path):
    assert load(log(tmp_path, "wheel_torque [N m]\n1,5\n2\n")).wheel_torque.values.tolist() == [1.5, 2.0]


def test_a_foreign_table_is_taken_as_it_is(tmp_path):
    found = load(log(tmp_path, FOREIGN), map=FOREIGN_MAP, set=FOREIGN_SET, where={"beta": "0"})
    assert found.drawbar_force.values.tolist() == [-38.2, 0.77, 0.81]
    assert found.normal_load.values.tolist() == [20.1, 26.1, 25.2]
    assert found.wheel_speed.values == pytest.approx([0.0, 0.020 / 0.058, 0.0201 / 0.058])
    assert found.speed_ratio.values == pytest.approx([np.nan, 9.99 / 20.0, 10.01 / 20.1], nan_ok=True)
    assert found.trial.values.tolist() == [1, 1, 2]
    assert found.wheel.values.tolist() == ["smooth"] * 3
    # The laboratory's slip is of another definition and has no unit: it is not taken for ours.
    assert found.attrs["set_aside"] == "Vry, beta, slip, avg_Z"
    assert found.attrs["left_out"] == "1 of 4 rows: beta is not 0"


def test_what_follows_from_the_columns_is_added(tmp_path):
    content = "lever_angle [deg],wheel_speed [rad/s],slide_speed [mm/s]\n1,0,10\n2,5,10\n"
    found = load(log(tmp_path, content), set={"lever_length": "150 mm", "wheel_radius": 0.0075})
    assert found.sinkage.values == pytest.approx(0.15 * np.sin(np.radians([1, 2])))
    assert found.speed_ratio.values == pytest.approx([np.nan, 0.010 / (5 * 0.0075)], nan_ok=True)


def test_a_locked_wheel_needs_no_speed_ratio(tmp_path):
    found = load(log(tmp_path, "speed_ratio [1],drawbar_force [N]\n,-0.1\nNaN,-0.2\n0.5,0.1\n"))
    assert np.isnan(found.speed_ratio.values).tolist() == [True, True, False]


def test_a_long_log_loads_in_about_a_second(tmp_path):
    wanted = [n for n in VARIABLES if VARIABLES[n].unit in ("N", "N m", "J", "W")][:11]
    header = ",".join(f"{n} [{VARIABLES[n].unit}]" for n in wanted)
    path = log(tmp_path, f"{header},wheel\n" + ("0.123456789012345," * 11 + "smooth\n") * 72_000)
    start = time.process_time()
    assert load(path).sizes[OBSERVATION] == 72_000
    assert time.process_time() - start < 4.0  # 0.7 s on a desktop; the rest is for a slow, shared machine


# What bad input gets ------------------------------------------------------------------------------

GOOD = "normal_load [N],drawbar_force [N]\n"


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("normal_load,time [s]\n1,2\n", ["log.csv", "normal_load", "no unit", "normal_load [N]"]),
        ("speed_ratio,time [s]\n1,2\n", ["speed_ratio [1]"]),
        ("normal_load [g],time [s]\n1,2\n", ["normal_load [g]", "mass", "gf"]),
        ("normal_load [m],time [s]\n1,2\n", ["normal_load [m]", "'m'", "N"]),
        ("normal_load [zork],time [s]\n1,2\n", ["zork", "not known"]),
        ("trial [1],time [s]\n1,2\n", ["trial", "label", "no unit"]),
        ("normal_lod [N],time [s]\n1,2\n", ["normal_lod", "Did you mean 'normal_load'?", "--map"]),
        ("Normal load (N),time [s]\n1,2\n", ["Did you mean 'normal_load'?", "[N]"]),
        ("wheel_diameter [mm],time [s]\n15,2\n", ["radius, half the diameter", "wheel_radius [mm]"]),
        ("wheel_radius [m],time [s]\n0.1,2\n7.5,2\n", ["line 3", "wheel_radius", "<= 0.5 m", "7.5", "mm?"]),
        (GOOD + "1,2\n-3,4\n", ["line 3", "normal_load [N]", ">= 0 N", "-3", "--map", "-normal_load"]),
        ("# a\n\n" + GOOD + "1,2\n3,x\n", ["line 5", "drawbar_force [N]", "'x'", "not a finite number"]),
        (GOOD + "1,nan\n", ["line 2", "drawbar_force [N]", "'nan'"]),
        (GOOD + "1,2\n1,-inf\n", ["line 3", "'-inf'"]),
        (GOOD + "1,1_000\n", ["line 2", "'1_000'"]),
        (GOOD + '1,"1,5"\n', ["line 2", "'1,5'", "decimal comma"]),
        (GOOD + "1,2\n,3\n", ["line 3", "normal_load [N]", "empty"]),
        ("speed_ratio [1],time [s]\ninf,1\n", ["line 2", "'inf'", "empty for a locked wheel"]),
        ("speed_ratio [1],slide_speed [m/s],wheel_radius [m]\n1,1,0.1\n0,1,0.1\n", ["line 3", "wheel_speed [rad/s]"]),
        ("wheel,time [s]\n,1\n", ["line 2", "'wheel'", "empty"]),
        (GOOD + "1,2\n3\n", ["line 3", "2 columns", "this row 1"]),
        (GOOD + "1,5,2\n", ["line 2", "this row 3", "decimal comma"]),
        ("time [s];normal_load [N]\n1,5;1.000\n", ["line 2", "'1,5'", "'1.000'", "one decimal sign"]),
        ('time [s],wheel\n1,"a\n2,b\n', ["line 2", "quotation mark"]),
        ("time [s],time [s]\n1,2\n", ["line 1", "'time [s]'", "twice"]),
        ("time [s],time [ms]\n1,2\n", ["time [s]", "time [ms]", "both"]),
        ("1,2\n3,4\n", ["line 1", "header"]),
        (",time [s]\n1,2\n", ["unnamed 1", "Rename or remove"]),
        ("", ["log.csv is empty"]),
        ("# only: this\n\n", ["is empty"]),
        (GOOD, ["no rows of data"]),
        (GOOD + ",\n,\n", ["no rows of data"]),
        (b"PK\x03\x04\x14\x00", ["not a CSV file", "Excel", "Save the sheet as CSV"]),
        (b"%PDF-1.7\n", ["not a CSV file", "PDF"]),
        (b"\x89HDF\r\n\x1a\n", ["not a CSV file", "netCDF", ".nc"]),
        (b"time [s]\n\x00\x01\x02\n", ["not a CSV file", "binary"]),
        ("time [s]\n1\n".encode("utf-16-le"), ["not a CSV file", "UTF-8"]),
        (codecs.BOM_UTF16_LE + b"abc", ["not a CSV file", "utf-16"]),
        ('{"time": [1, 2]}\n{}', ["not a CSV file", "JSON"]),
        ('[tissue]\nlaw = "Winkler"\n', ["log.csv", "not a name of the glossary"]),
    ],
)
def test_a_bad_log_gets_a_sentence(tmp_path, content, words):
    with pytest.raises(ValueError) as caught:
        load(log(tmp_path, content))
    for word in words:
        assert word in str(caught.value)
    assert str(caught.value).endswith((".", "?"))


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ({"map": {"avg_Fq": "drawbar_force [N]"}}, ["no column 'avg_Fq'", "Did you mean 'avg_F"]),
        ({"map": {"avg_Fy": "drawbar_force"}}, ["avg_Fy", "drawbar_force [N]"]),
        ({"map": {"avg_Fy": "drawbar_farce [N]"}}, ["Did you mean 'drawbar_force'?"]),
        ({"map": {"avg_Fy": "drawbar_force [mm]"}}, ["avg_Fy", "'mm'", "N"]),
        ({"map": {"avg_Fy": "wheel_diameter [mm]"}}, ["half the diameter"]),
        ({"map": {"avg_Fy": "side_force [N]", "avg_Fz": "side_force [N]"}}, ["avg_Fy", "avg_Fz", "both"]),
        ({"map": {"-trial_num": "trial"}}, ["label", "sign"]),
        ({"map": {"avg_Fz": "normal_load [N]"}}, ["line 2", "avg_Fz", "-20.1", "-avg_Fz"]),
        ({"map": {"avg_Z": "sinkage [mm]"}}, ["line 5", "avg_Z", "'x'"]),
        ({"map": FOREIGN_MAP, "set": {"normal_load": "1 N"}}, ["normal_load", "already"]),
        ({"map": FOREIGN_MAP, "set": {"wheel_radius": "58"}}, ["wheel_radius", "<= 0.5 m", "'58 mm'"]),
        ({"map": FOREIGN_MAP, "set": {"wheel_radius": "58 N"}}, ["wheel_radius=58 N", "m"]),
        ({"map": FOREIGN_MAP, "set": {"wheel_radius": "wide"}}, ["'wide'", "number with a unit"]),
        ({"map": FOREIGN_MAP, "set": {"wheel_radus": "58 mm"}}, ["Did you mean 'wheel_radius'?"]),
        ({"map": FOREIGN_MAP, "set": {"wheel_diameter": "58 mm"}}, ["half the diameter"]),
        ({"map": FOREIGN_MAP, "where": {"beta": "15"}}, ["'15'", "beta", "0, 30"]),
        ({"map": FOREIGN_MAP, "where": {"betta": "0"}}, ["no column 'betta'", "Did you mean 'beta'?"]),
    ],
)
def test_a_bad_reading_of_a_good_table_gets_a_sentence(tmp_path, asked, words):
    with pytest.raises(ValueError) as caught:
        load(log(tmp_path, FOREIGN), **asked)
    for word in words:
        assert word in str(caught.value)


def test_missing_files_folders_and_false_netcdf_get_a_sentence(tmp_path):
    log(tmp_path, GOOD)
    with pytest.raises(FileNotFoundError, match=r"lug\.csv does not exist\. Did you mean 'log\.csv'\?"):
        load(tmp_path / "lug.csv")
    with pytest.raises(ValueError, match="is a folder"):
        load(tmp_path)
    with pytest.raises(ValueError, match=r"false\.nc is not a netCDF file"):
        load(log(tmp_path, GOOD, "false.nc"))
    xr.Dataset({"pigs": ("x", [1.0])}).to_netcdf(tmp_path / "foreign.nc", engine="h5netcdf")
    with pytest.raises(ValueError, match="no variable of drawbar's glossary"):
        load(tmp_path / "foreign.nc")
    xr.Dataset({"sinkage": ("x", [1.0], {"units": "mm"})}).to_netcdf(tmp_path / "mm.nc", engine="h5netcdf")
    with pytest.raises(ValueError, match=r"'sinkage'.*'mm'"):
        load(tmp_path / "mm.nc")


def test_files_are_written_whole_or_not_at_all(tmp_path):
    rows = declare({"time": (OBSERVATION, np.arange(3.0))})
    for write, name in ((write_csv, "a.csv"), (write_netcdf, "a.nc")):
        write(rows, tmp_path / name)
        before = (tmp_path / name).read_bytes()
        with pytest.raises(FileExistsError, match="--force"):
            write(rows.isel({OBSERVATION: [0]}), tmp_path / name)
        assert (tmp_path / name).read_bytes() == before
        write(rows.isel({OBSERVATION: [0]}), tmp_path / name, force=True)
        assert load(tmp_path / name).sizes == {OBSERVATION: 1}
    with pytest.raises(ValueError, match="'pigs' cannot be written"):
        write_csv(rows.assign(pigs=(OBSERVATION, ["a", "b", "c"])), tmp_path / "b.csv")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.csv", "a.nc"]
