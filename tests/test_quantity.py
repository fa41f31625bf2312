"""Are quantities checked once, in a sentence, and read back from text and files as they were?"""

import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import drawbar
from drawbar.catalogue import find, laws, presets, save, sensors, to_toml
from drawbar.quantity import quantities, quantity, value
from drawbar.units import series, si
from drawbar.variables import VARIABLES, declare, tidy
from laws import FILMS, TISSUES, WHEEL


@pytest.mark.parametrize(
    ("build", "sentence"),
    [
        (lambda: drawbar.Winkler(stiffness=-415000), r"stiffness must be > 0 Pa/m, got -415000\. It is .*pressure per indentation.*sign of the load column"),
        (lambda: drawbar.Winkler(stiffness=np.array([1e5, np.nan])), r"stiffness must be > 0 Pa/m, got nan"),
        (lambda: drawbar.Winkler(stiffness=np.inf), r"got inf"),
        (lambda: drawbar.Winkler(stiffness="225 kPa/m"), r"got '225 kPa/m'.*Give a number in Pa/m"),
        (lambda: drawbar.Winkler(stiffness=True), r"got True"),
        (lambda: drawbar.Winkler(stiffness=None), r"got None"),
        (lambda: drawbar.Wheel(radius=7.5, width=0.02), r"radius must be .*<= 0.5 m, got 7.5.*diameter, or in millimetres\?"),
        (lambda: drawbar.Wheel(radius=0.0075, width=0.0), r"width must be > 0 m"),
        (lambda: drawbar.CouetteCoulomb(viscous_coefficient=1.0, yield_stress=-1.0), r"yield_stress must be >= 0 Pa"),
    ],
)  # fmt: skip
def test_a_wrong_number_is_refused_in_a_sentence(build, sentence):
    with pytest.raises((ValueError, TypeError), match=sentence):
        build()


def test_values_are_frozen_and_equal_by_their_numbers():
    wheel = drawbar.Wheel(radius=0.0075, width=0.02)
    with pytest.raises(dataclasses.FrozenInstanceError):
        wheel.radius = 1.0  # type: ignore[misc]
    assert wheel == drawbar.Wheel(radius=0.0075, width=0.02)
    assert wheel.inertia == pytest.approx(0.5 * 0.028 * 0.0075**2)
    assert drawbar.Wheel(radius=0.0075, width=0.02, inertia=1e-6).inertia == 1e-6


def test_a_value_may_fill_a_field_from_others():
    @value
    class Plate:
        side: float = quantity("m", above=0)
        area: float | None = quantity("m^2", above=0, default=None)

        def __post_init__(self):
            if self.area is None:
                object.__setattr__(self, "area", self.side**2)

    assert Plate(side=2).area == 4.0
    assert list(quantities(Plate)) == ["side", "area"]


@pytest.mark.parametrize("law", [*TISSUES, *FILMS, WHEEL], ids=repr)
def test_every_law_is_found_again_from_its_file_and_from_its_own_spelling(law, tmp_path):
    kind = next(
        k
        for k, base in (("tissue", drawbar.Tissue), ("film", drawbar.Film), ("wheel", drawbar.Wheel))
        if isinstance(law, base)
    )
    path = save(kind, law, tmp_path / "law.toml", comments=("a note",))
    assert find(kind, path) == law
    assert find(kind, repr(law)) == law
    with pytest.raises(FileExistsError, match=r"exists. Give --force"):
        save(kind, law, path)
    save(kind, law, path, force=True)


def test_every_law_declares_a_unit_that_is_known_and_a_meaning():
    for kind in ("tissue", "film", "wheel"):
        for law in laws(kind).values():
            for name, declared in quantities(law).items():
                assert declared.meaning, (law, name)
                assert si(f"1 {declared.unit}", declared.unit) == 1.0
                assert "Source" in (law.__doc__ or "") or law is drawbar.Frictionless
    assert all(si(f"1 {q.unit}", q.unit) == 1.0 and q.meaning for q in VARIABLES.values())


def test_presets_say_what_is_printed_and_what_is_assumed():
    assert presets("tissue")["foam-2004"].law.stiffness == 225_000
    assert presets("tissue")["bovine-liver-2004"].law.stiffness == 415_000
    assert "not printed" in presets("wheel")["robot-2004"].note
    assert "NOT from the paper" in presets("film")["film-assumed"].note


@pytest.mark.parametrize(
    ("kind", "text", "sentence"),
    [
        ("tissue", "foam", r"no tissue is called 'foam'\. Did you mean 'foam-2004'"),
        ("tissue", "Winkle(stiffness=1)", r"'Winkle' .* is not a tissue law\. Did you mean 'Winkler'"),
        ("tissue", "Winkler(stifness=1)", r"Did you mean 'stiffness'\?"),
        ("tissue", "Winkler()", r"lacks stiffness\. Add stiffness=\.\.\. Pa/m"),
        ("tissue", "Winkler(225)", r"is not name=number"),
        ("tissue", "Winkler(stiffness=225 N)", r"'N' does not convert to Pa/m"),
        ("wheel", "Wheel(diameter=15 mm, width=1 mm)", r"given by radius, half of it"),
        ("wheel", "Wheel(radius=15, width=1 mm)", r"millimetres\?"),
        ("film", "none.toml", r"none.toml does not exist"),
    ],
)
def test_what_is_not_found_is_told_with_the_nearest(kind, text, sentence):
    with pytest.raises(ValueError, match=sentence):
        find(kind, text)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ("[tissue]\nlaw = 'Winkler'\nstifness = 1.0", r"'stifness' in .* Did you mean 'stiffness'"),
        ("[tisue]\nlaw = 'Winkler'", r"'tisue' is not known\. Did you mean 'tissue'"),
        ("[tissue]\nlow = 'Winkler'\nstiffness = 1.0", r"names no law.*did you mean 'law'"),
        ("[film]\nlaw = 'Couette'", r"has no \[tissue\] table, only film"),
        ("[tissue", r"is not a TOML file"),
        ("[tissue]\nlaw = 'Winkler'\nstiffness = -1.0", r"stiffness must be > 0 Pa/m, got -1"),
        ("[tissue]\nlaw = 'Winkler'\nstiffness = true", r"stiffness must be|not a number"),
    ],
)
def test_a_bad_file_is_told_with_its_name(content, sentence, tmp_path):
    path = tmp_path / "law.toml"
    path.write_text(content)
    with pytest.raises(ValueError, match=sentence) as caught:
        find("tissue", path)
    assert "law.toml" in str(caught.value)


def test_units_in_a_file_are_read():
    assert "stiffness = 1.0  # Pa/m" in to_toml("tissue", drawbar.Winkler(stiffness=1.0))


def test_sensors_from_text():
    assert sensors(None) == drawbar.Sensors()
    assert sensors("force_noise=5 mN, angle_noise=1 deg").angle_noise == pytest.approx(np.pi / 180)
    with pytest.raises(ValueError, match=r"--noise .*Did you mean 'force_noise'"):
        sensors("force_nose=1 mN")


@given(st.floats(-1e6, 1e6), st.sampled_from([("mm", 1e-3), ("cm", 1e-2), ("km", 1e3), ("", 1.0)]))
def test_text_with_a_unit_is_a_number_in_si(number, unit):
    assert si(f"{number!r} {unit[0]}", "m") == pytest.approx(number * unit[1], rel=1e-12)


def test_forces_speeds_angles_and_the_grams_that_are_not_forces():
    assert si("28 gf", "N") == pytest.approx(0.27459, abs=1e-5)
    assert si("60 rpm", "rad/s") == pytest.approx(2 * np.pi)
    assert si("180 deg", "rad") == pytest.approx(np.pi)
    assert si("1,5 mm", "m") == pytest.approx(1.5e-3)
    assert si("12 %", "1") == pytest.approx(0.12)
    with pytest.raises(ValueError, match=r"mass is not a force: if the weight of that mass is meant, write gf"):
        si("28 g", "N")
    assert si("1 rev/min", "rad/s") == pytest.approx(2 * np.pi / 60)
    assert si("2 Nm", "N m") == 2.0
    assert si("4 mm2", "m^2") == pytest.approx(4e-6)
    for text, unit in (("1 1/s", "rad/s"), ("1 Hz", "rad/s"), ("3 deg", "1"), ("3 %", "rad")):
        with pytest.raises(ValueError, match=r"for sure: an angle is rad"):
            si(text, unit)
    with pytest.raises(ValueError, match=r"unit 'furlongz' is not known"):
        si("2 furlongz", "m")
    with pytest.raises(ValueError, match=r"is not a number with a unit"):
        si("fast", "m/s")


def test_series_of_numbers():
    assert series("0.5,1,1.5", "1") == [0.5, 1.0, 1.5]
    assert series("0.5:1.5:3", "1") == [0.5, 1.0, 1.5]
    assert series("100 gf, 1 N", "N") == pytest.approx([0.980665, 1.0])
    assert series("-10:10:2 mm/s", "m/s") == pytest.approx([-0.01, 0.01])
    for wrong in ("1:2", "1:2:x", "1,,2", ""):
        with pytest.raises(ValueError, match="Write"):
            series(wrong, "1")


def test_the_glossary_refuses_a_name_that_it_does_not_hold():
    with pytest.raises(KeyError, match=r"'drawbar_forze' is not in the glossary\. Did you mean 'drawbar_force'"):
        declare({"drawbar_forze": ((), 1.0)})


def test_a_map_becomes_rows():
    table = drawbar.steady(
        WHEEL, TISSUES[0], FILMS[1], speed=0.02, **drawbar.grid(normal_load=[0.1, 0.2], speed_ratio=[0.5, 1.0, 1.5])
    )
    rows = tidy(table)
    assert dict(rows.sizes) == {"observation": 6}
    one = rows.isel(observation=4)
    cell = table.sel(normal_load=float(one.normal_load), speed_ratio=float(one.speed_ratio))
    assert float(one.drawbar_force) == float(cell.drawbar_force)
    assert rows.drawbar_force.attrs["units"] == "N"
    assert tidy(rows) is rows
