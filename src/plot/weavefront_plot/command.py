"""The command line of weavefront-plot."""
import argparse
import sys
from pathlib import Path

from . import style
from .contour import draw_contour
from .deformed import draw_deformed
from .energies import draw_energies
from .failure import Failure, FileError, InputError
from .history import draw_history, read_measured
from .quantity import parse_times, parse_window
from .run import Run
from .section import draw_section
from .study import draw_study
from .yarn import draw_yarn

PICTURES = ("history", "energies", "deformed", "section", "contour")
FORMATS = ("png", "svg", "pdf")


class Parser(argparse.ArgumentParser):
    """Reports usage errors as all others: one line, status 2."""

    def error(self, message):
        raise InputError(message)


def parser():
    """The options."""
    options = Parser(prog="weavefront-plot", description="Draws pictures from the folder of a run or a study, or yarn curves.", allow_abbrev=False,
                     epilog="Exit status: 0 done, 2 bad input, 3 a file is missing or unreadable.")
    options.add_argument("run", nargs="?", type=Path, metavar="RUN",
                         help="folder with results.vtkhdf and history.csv; the run may still be going on")
    options.add_argument("--output", type=Path, metavar="PATH",
                         help="folder for the pictures (default: RUN/plots); with --yarn or --study the picture's file")
    options.add_argument("--only", metavar="LIST", help=f"which pictures, from {','.join(PICTURES)} (default: all)")
    options.add_argument("--times", metavar="LIST", help="times of deformed and section, such as 30us,60us; the nearest frames are "
                         "drawn (default: four over the run with the moment of rebound)")
    options.add_argument("--measured", type=Path, metavar="CSV", help="points to lay over history: columns time and "
                         "displacement or velocity or both, in s, m and m/s")
    options.add_argument("--field", metavar="NAME",
                         help="cell array that colours deformed, or height (default: stress, the greater of fill and warp)")
    options.add_argument("--window", metavar="L", help="show |x| and |y| up to L, such as 40mm (default: the deflected area)")
    options.add_argument("--format", default="png", choices=FORMATS, help="of the pictures (default: png)")
    options.add_argument("--yarn", type=Path, metavar="CSV",
                         help="draw stress over strain from the output of 'weavefront yarn' instead of a run")
    options.add_argument("--study", type=Path, metavar="DIR",
                         help="draw error against cost from the folder of 'weavefront study' instead of a run, into DIR/study.png")
    return options


def chosen_pictures(text):
    """The names in --only."""
    names = [name.strip() for name in text.split(",") if name.strip()] if text is not None else PICTURES
    for name in names:
        if name not in PICTURES:
            raise InputError(f"--only: '{name}' is none of {', '.join(PICTURES)}")
    if not names:
        raise InputError(f"--only: empty, choose from {', '.join(PICTURES)}")
    return names


def make_folder(folder):
    """Creates the folder where it is missing."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{folder}: {error.strerror}") from None


def plot_yarn(options):
    """--yarn: one picture."""
    if options.run is not None:
        raise InputError("give either RUN or --yarn, not both")
    path = options.output or options.yarn.with_suffix("." + options.format)
    if path.suffix[1:] not in FORMATS:
        raise InputError(f"--output: '{path}' must end in one of .{', .'.join(FORMATS)}")
    make_folder(path.parent)
    draw_yarn(options.yarn, path)


def plot_study(options):
    """--study: one picture."""
    if options.run is not None or options.yarn is not None:
        raise InputError("give one of RUN, --yarn and --study")
    path = options.output or options.study / f"study.{options.format}"
    if path.suffix[1:] not in FORMATS:
        raise InputError(f"--output: '{path}' must end in one of .{', .'.join(FORMATS)}")
    make_folder(path.parent)
    draw_study(options.study, path)


def plot_run(options):
    """The pictures of a run."""
    if options.run is None:
        raise InputError("give the folder of a run, --yarn CSV or --study DIR; see weavefront-plot --help")
    names = chosen_pictures(options.only)
    times = parse_times(options.times) if options.times is not None else None
    window = parse_window(options.window) if options.window is not None else None
    measured = read_measured(options.measured) if options.measured else None
    run = Run(options.run)
    if options.field is not None:
        run.results.field(options.field, 0)
    folder = options.output or options.run / "plots"
    make_folder(folder)

    def path(name):
        return folder / f"{name}.{options.format}"

    if "history" in names:
        draw_history(run, path("history"), measured)
    if "energies" in names:
        draw_energies(run, path("energies"))
    frames = run.frames(times) if {"deformed", "section"} & set(names) else []
    if "deformed" in names:
        draw_deformed(run, [path(f"deformed_{run.label(step)}") for step in frames], frames, window, options.field)
    if "section" in names:
        draw_section(run, path("section"), frames, window)
    if "contour" in names:
        draw_contour(run, path(f"contour_{run.label(run.turning_frame)}"), run.turning_frame, window)


def main():
    """Runs the program and returns its exit status."""
    try:
        options = parser().parse_args()
        style.apply()
        if options.study is not None:
            plot_study(options)
        elif options.yarn is not None:
            plot_yarn(options)
        else:
            plot_run(options)
    except Failure as failure:
        print(f"weavefront-plot: {failure}", file=sys.stderr)
        return failure.status
    except OSError as error:  # h5py, on a file that is cut short or being rewritten
        print(f"weavefront-plot: cannot read or write: {error}", file=sys.stderr)
        return FileError.status
    return 0
