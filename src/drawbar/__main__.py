"""The command line: each verb parses, calls one function of the package, and shows what it returns."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    import xarray as xr

app = typer.Typer(
    name="drawbar",
    help="Wheeled mobility on living tissue: how hard a wheel pulls on a soft, wet organ.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)
identify = typer.Typer(help="Find a tissue's or film's parameters from a rig's logs.", no_args_is_help=True)
app.add_typer(identify, name="identify")

WHEEL = typer.Option(help="A preset, a .toml file, or a law: 'Wheel(radius=7.5 mm, width=20 mm)'.")
TISSUE = typer.Option(help="A preset, a .toml file, or a law: 'Winkler(stiffness=225 kPa/m)'.")
FILM = typer.Option(help="A preset, a .toml file, or a law: 'Couette(viscous_coefficient=1e4 Pa s/m)'.")
OUT = typer.Option(help="Folder for the results.")
FORCE = typer.Option("--force", help="Overwrite results that exist.")
MAP = typer.Option(help="A foreign column under our name: 'Fx=drawbar_force [N]', '-Fy=...' flips the sign.")
SET = typer.Option(help="A constant column: 'wheel_radius=58 mm'.")
WHERE = typer.Option(help="Keep only rows with this cell: 'beta=0'.")

Wheel = Annotated[str, WHEEL]
Tissue = Annotated[str, TISSUE]
Film = Annotated[str, FILM]
Out = Annotated[Path, OUT]
Force = Annotated[bool, FORCE]
Maps = Annotated[list[str] | None, MAP]
Sets = Annotated[list[str] | None, SET]
Wheres = Annotated[list[str] | None, WHERE]
Logs = Annotated[list[Path], typer.Argument(help="CSV or netCDF files.")]


def _version(asked: bool) -> None:
    if asked:
        from drawbar import __version__

        typer.echo(f"drawbar {__version__}")
        raise typer.Exit


@app.callback()
def _top(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and stop.")
    ] = False,
) -> None:
    pass


@app.command()
def reproduce(out: Out = Path("out/reproduce"), force: Force = False) -> None:
    """Do the 2004 paper again: every simulation, identification, comparison and figure, in one report."""
    from drawbar.files import whole_folder
    from drawbar.view import terminal

    with whole_folder(out, force=force) as folder:
        with terminal.progress() as step:
            from drawbar.study.paper.reproduce import reproduce
            from drawbar.view.report import write_report

            result = reproduce(step)
            write_report(result, folder, step)
        terminal.outcomes(result.verdicts)
    terminal.say(f"report: {out / 'report.html'}; verdicts: {out / 'outcomes.json'}; figures and data beside them")


@app.command()
def rig(
    wheel: Wheel = "robot-2004",
    tissue: Tissue = "foam-2004",
    film: Film = "film-assumed",
    load: Annotated[
        str, typer.Option(help="Normal loads on the wheel: '0.14,0.27 N', '0.1:0.4:7 N', '28 gf'.")
    ] = "0.27468 N",
    speed: Annotated[str, typer.Option(help="Speeds of the carriage; negative drags in reverse.")] = "25.4 mm/s",
    speed_ratio: Annotated[str | None, typer.Option(help="Speed ratios v/(rω).")] = None,
    wheel_speed: Annotated[str | None, typer.Option(help="Wheel speeds; 0 locks the wheel.")] = None,
    wheel_torque: Annotated[str | None, typer.Option(help="Motor torques; 0 rolls freely.")] = None,
    at: Annotated[Path | None, typer.Option(help="Run at the settings of this log, row by row, instead.")] = None,
    repeats: Annotated[int, typer.Option(help="Runs of each setting.")] = 1,
    noise: Annotated[
        str | None, typer.Option(help="Sensors: 'force_noise=5 mN, angle_noise=0.1 deg'; 'drawbar laws' lists them.")
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the noise.")] = 0,
    history: Annotated[bool, typer.Option("--history", help="Time histories from touch-down, 20 cm long.")] = False,
    damper: Annotated[str, typer.Option(help="Lever damper that ends the bounce in a history.")] = "0 N s/m",
    map: Maps = None,
    set: Sets = None,
    where: Wheres = None,
    out: Out = Path("out/rig"),
    force: Force = False,
) -> None:
    """Run the virtual drawbar rig over every combination of loads, speeds and speed ratios."""
    from drawbar.catalogue import find, sensors
    from drawbar.files import refuse_existing
    from drawbar.rig.drawbar_test import drawbar_test, drawbar_test_at
    from drawbar.rig.write import write_csv, write_netcdf
    from drawbar.units import series, si
    from drawbar.variables import VARIABLES
    from drawbar.view import terminal

    laws: tuple[Any, Any, Any] = (find("wheel", wheel), find("tissue", tissue), find("film", film))
    files = [out / f"rig.{suffix}" for suffix in ("nc", "csv", "png", "svg")]
    refuse_existing(*files, force=force)
    labels = {"wheel": wheel, "tissue": tissue, "film": film}
    given = {"speed_ratio": speed_ratio, "wheel_speed": wheel_speed, "wheel_torque": wheel_torque}
    if at is not None:
        if any(v is not None for v in given.values()):
            raise ValueError("--at takes speeds from the log. Leave out --speed-ratio, --wheel-speed, --wheel-torque.")
        result = drawbar_test_at(_load(at, map, set, where), *laws)
    else:
        if not any(v is not None for v in given.values()):
            given["speed_ratio"] = "0.5,1,1.5"
        drives: dict[str, Any] = {n: series(v, VARIABLES[n].unit) for n, v in given.items() if v is not None}
        result = drawbar_test(
            *laws,
            normal_load=series(load, "N"),
            speed=series(speed, "m/s"),
            **drives,
            repeats=repeats,
            sensors=sensors(noise),
            seed=seed,
            history=history,
            damper=si(damper, "N s/m"),
            labels=labels,
        )
    terminal.dataset(result, title="virtual rig")
    write_netcdf(result, files[0], force=force)
    write_csv(result, files[1], force=force)
    from drawbar.view import figure

    drawn = figure.history(result) if history else figure.drawbar_curves(result)
    figure.save(drawn, out / "rig", force=force)
    terminal.say(f"written: {', '.join(map_to_text(files))}")


@app.command()
def simulate(
    wheel: Wheel = "robot-2004",
    tissue: Tissue = "foam-2004",
    film: Film = "film-assumed",
    load: Annotated[str, typer.Option(help="Normal load on the wheel.")] = "0.27468 N",
    speed: Annotated[
        str | None, typer.Option(help="Speed imposed by the carriage (or the first speed, with --drawbar).")
    ] = None,
    drawbar: Annotated[
        str | None, typer.Option(help="Force that the wheel pulls, in place of an imposed speed.")
    ] = None,
    speed_ratio: Annotated[float | None, typer.Option(help="Speed ratio v/(rω), for an imposed speed.")] = None,
    wheel_speed: Annotated[str | None, typer.Option(help="Wheel speed imposed by the motor.")] = None,
    wheel_torque: Annotated[str | None, typer.Option(help="Torque of the motor.")] = None,
    duration: Annotated[str, typer.Option(help="Length of the run.")] = "8 s",
    interval: Annotated[str, typer.Option(help="Spacing of the results.")] = "10 ms",
    start: Annotated[str, typer.Option(help="touch-down or equilibrium.")] = "touch-down",
    damper: Annotated[
        str, typer.Option(help="Lever damper; not in the paper, whose wheel bounces for ever.")
    ] = "0 N s/m",
    tolerance: Annotated[float, typer.Option(help="Relative tolerance of the solver.")] = 1e-8,
    columns: Annotated[
        int | None, typer.Option(help="Columns of tissue under the wheel; 400 for a tissue with memory.")
    ] = None,
    check: Annotated[
        bool, typer.Option("--check", help="With columns: run twice as fine too, for error bars.")
    ] = False,
    out: Out = Path("out/simulate"),
    force: Force = False,
) -> None:
    """Integrate a driven wheel's equations of motion from touch-down, with its energy ledger."""
    from drawbar.catalogue import find
    from drawbar.files import refuse_existing
    from drawbar.rig.write import write_csv, write_netcdf
    from drawbar.units import si
    from drawbar.view import terminal

    laws: tuple[Any, Any, Any] = (find("wheel", wheel), find("tissue", tissue), find("film", film))
    files = [out / f"simulation.{suffix}" for suffix in ("nc", "csv", "png", "svg")]
    refuse_existing(*files, force=force)
    quantities = {"speed": (speed, "m/s"), "drawbar_force": (drawbar, "N"), "wheel_speed": (wheel_speed, "rad/s"),
                  "wheel_torque": (wheel_torque, "N m")}  # fmt: skip
    given = {name: si(v, unit) for name, (v, unit) in quantities.items() if v is not None}
    if not given:  # the paper's run
        given, speed_ratio = {"speed": 0.0254}, speed_ratio or 0.5
    from drawbar.motion.planar import simulate

    with terminal.waiting("compiling and integrating"):
        result = simulate(
            *laws,
            normal_load=si(load, "N"),
            **given,
            speed_ratio=speed_ratio,
            duration=si(duration, "s"),
            interval=si(interval, "s"),
            start=start,
            damper=si(damper, "N s/m"),
            tolerance=tolerance,
            columns=columns,
            check=check,
        )
    terminal.ledger(result)
    write_netcdf(result, files[0], force=force)
    write_csv(result, files[1], force=force)
    from drawbar.view import figure

    figure.save(figure.simulation(result), out / "simulation", force=force)
    terminal.say(f"written: {', '.join(map_to_text(files))}")


@identify.command("stiffness")
def identify_stiffness(
    logs: Logs,
    map: Maps = None,
    set: Sets = None,
    where: Wheres = None,
    out: Out = Path("out/identify"),
    force: Force = False,
) -> None:
    """Fit a tissue's stiffness to plate tests: mass or force, plate area, deflection."""
    from drawbar.study.identify.stiffness import identify_stiffness

    _identify("stiffness", identify_stiffness, logs, (map, set, where), out, force, {})


@identify.command("film")
def identify_film(
    logs: Logs,
    coulomb: Annotated[
        str, typer.Option(help="Coulomb term: auto, yield_stress, friction_coefficient, both or none.")
    ] = "auto",
    map: Maps = None,
    set: Sets = None,
    where: Wheres = None,
    out: Out = Path("out/identify"),
    force: Force = False,
) -> None:
    """Fit a film's Coulomb and viscous friction to drags of a locked wheel."""
    from drawbar.study.identify.film import identify_film

    _identify("film", identify_film, logs, (map, set, where), out, force, {"coulomb": coulomb})


def _identify(what: str, fit_to: Any, logs: list[Path], reading: Any, out: Path, force: bool, options: Any) -> None:
    from drawbar.files import refuse_existing
    from drawbar.view import figure, terminal

    files = [out / f"{what}.{suffix}" for suffix in ("toml", "png", "svg")]
    refuse_existing(*files, force=force)
    fit = fit_to([_load(log, *reading) for log in logs], **options)
    terminal.say(fit.report())
    fit.save(files[0], force=force)
    drawn = figure.stiffness_fit(fit) if what == "stiffness" else figure.film_fit(fit)
    figure.save(drawn, out / what, force=force)
    terminal.say(f"written: {', '.join(map_to_text(files))}; use it with --{fit.kind} {files[0]}")


@app.command()
def compare(
    model: Annotated[Path, typer.Argument(help="CSV or netCDF of the model, such as 'drawbar rig' writes.")],
    data: Annotated[Path, typer.Argument(help="CSV or netCDF of the measurement.")],
    quantity: Annotated[str, typer.Option(help="Which column to compare.")] = "drawbar_force",
    tolerance: Annotated[
        list[str] | None,
        typer.Option(help="How far settings may scatter and still be one condition: 0.02, or 'normal_load=0.2'."),
    ] = None,
    map: Maps = None,
    set: Sets = None,
    where: Wheres = None,
    out: Out = Path("out/compare"),
    force: Force = False,
) -> None:
    """Put a model beside a measurement (--map, --set and --where read the measurement)."""
    from drawbar.files import refuse_existing, write_whole
    from drawbar.study.compare.compare import compare
    from drawbar.view import figure, terminal

    files = [out / f"compare.{suffix}" for suffix in ("txt", "png", "svg")]
    refuse_existing(*files, force=force)
    result = compare(
        _load(model, None, None, None), _load(data, map, set, where), quantity=quantity, tolerance=_tolerance(tolerance)
    )
    terminal.say(result.report())
    write_whole(files[0], result.report() + "\n", force=force)
    figure.save(figure.comparison(result), out / "compare", force=force)
    terminal.say(f"written: {', '.join(map_to_text(files))}")


@app.command()
def load(
    log: Annotated[Path, typer.Argument(help="A CSV file.")],
    map: Maps = None,
    set: Sets = None,
    where: Wheres = None,
    out: Annotated[
        Path | None, typer.Option(help="Write the rows here, as .csv or .nc, in the package's form.")
    ] = None,
    force: Force = False,
) -> None:
    """Read a rig's log, show what it holds in SI, and if asked write it in the package's form."""
    from drawbar.rig.write import write_csv, write_netcdf
    from drawbar.view import terminal

    if out is not None and out.suffix not in (".csv", ".nc"):
        raise ValueError(f"--out {out} must end in .csv or .nc.")
    rows = _load(log, map, set, where)
    terminal.dataset(rows, title=str(log))
    if out is not None:
        (write_csv if out.suffix == ".csv" else write_netcdf)(rows, out, force=force)
        terminal.say(f"written: {out}")


@app.command()
def logs(out: Out = Path("out/logs"), force: Force = False) -> None:
    """Copy the example logs, one of each kind, made by the virtual rig and labelled as such."""
    from drawbar.study.paper.examples import copy_examples
    from drawbar.view import terminal

    terminal.say(f"written: {', '.join(map_to_text(copy_examples(out, force=force)))}")


@app.command()
def laws() -> None:
    """List every tissue, film and wheel there is, with parameters, units, bounds, defaults and sources."""
    from drawbar.view import terminal

    terminal.laws()


def _load(path: Path, map: list[str] | None, set: list[str] | None, where: list[str] | None) -> xr.Dataset:
    from drawbar.rig.load import load

    if path.suffix == ".nc":
        return load(path)
    return load(path, map=_pairs("map", map), set=_pairs("set", set), where=_pairs("where", where))


def _pairs(option: str, given: list[str] | None) -> dict[str, str]:
    pairs = {}
    for text in given or []:
        name, equals, target = text.partition("=")
        if not equals or not name.strip() or not target.strip():
            raise ValueError(
                f"--{option} '{text}' is not name=value. Write for example --{option} '{_EXAMPLES[option]}'."
            )
        pairs[name.strip()] = target.strip()
    return pairs


def _tolerance(given: list[str] | None) -> float | dict[str, float]:
    """One number for all settings, or numbers by setting; nothing is the study's own default."""
    from drawbar.study.compare.compare import TOLERANCE
    from drawbar.units import si

    if given is not None and len(given) == 1 and "=" not in given[0]:
        return si(given[0], "1")
    return {name: si(text, "1") for name, text in _pairs("tolerance", given).items()} or TOLERANCE


_EXAMPLES = {
    "tolerance": "normal_load=0.2",
    "map": "Fx=drawbar_force [N]",
    "set": "wheel_radius=58 mm",
    "where": "beta=0",
}


def map_to_text(paths: list[Path]) -> list[str]:
    return [str(path) for path in paths]


def main() -> None:
    """Run the command line: a sentence and status 2 for what a user got wrong, never a traceback."""
    try:
        app(standalone_mode=True)
    except KeyboardInterrupt:
        typer.echo("drawbar: interrupted; nothing half-written is left.", err=True)
        sys.exit(130)
    except (ValueError, TypeError, KeyError, OSError, RuntimeError, ArithmeticError, MemoryError) as error:
        if os.environ.get("DRAWBAR_DEBUG"):
            raise
        text = error.args[0] if isinstance(error, KeyError) and error.args else error
        typer.echo(f"drawbar: {text}", err=True)
        sys.exit(2)


if __name__ == "__main__":
    main()
