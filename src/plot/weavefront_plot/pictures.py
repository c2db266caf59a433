"""Draws what the options ask for."""
from . import style
from .animation import draw_animation
from .contour import draw_contour
from .deformed import draw_deformed
from .energies import draw_energies
from .fabric import Fabric
from .failure import FileError
from .history import draw_history, read_measured
from .picture_file import check_place
from .run import Run
from .section import draw_section
from .study import draw_study
from .v50 import draw_v50
from .yarn import draw_yarn

OF_FRAMES = {"deformed", "section", "contour"}


def draw(options):
    """All pictures of a run, or those of yarn curves, a study or a v50."""
    style.apply()
    if options.run is not None:
        draw_run(options)
        return
    if options.v50 is not None:
        folder = options.output or options.v50 / "plots"
        draw_v50(options.v50, lambda name: folder / f"{name}.{options.format}", lambda: make_folder(folder))
        return
    check_place(options.output)
    make_folder(options.output.parent)
    if options.study is not None:
        draw_study(options.study, options.output)
    else:
        draw_yarn(options.yarn, options.output)


def make_folder(folder):
    """Creates the folder where it is missing."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{folder}: {error.strerror}") from None


def draw_run(options):
    """The pictures of a run."""
    measured = read_measured(options.measured) if options.measured else None
    run = Run(options.run)
    if {"history", "energies"} & set(options.only):
        run.history  # read, and so checked, before anything is drawn
    fabric = Fabric(run.results, options.plies) if OF_FRAMES & set(options.only) else None
    if options.field is not None:
        run.results.field(options.field, 0)
    if options.debris is False:
        run.results.field("joined", 0)
    folder = options.output or options.run / "plots"
    make_folder(folder)

    def path(name):
        return folder / f"{name}.{options.format}"

    if "history" in options.only:
        draw_history(run, path("history"), measured)
    if "energies" in options.only:
        draw_energies(run, path("energies"))
    if fabric:
        draw_frames(run, fabric, options, path)


def draw_frames(run, fabric, options, path):
    """The pictures of the frames."""
    frames = run.frames(options.times) if {"deformed", "section"} & set(options.only) else []
    if "deformed" in options.only and options.animate:
        moments = frames if options.times else range(len(run.results.times))
        draw_animation(run, fabric, moments, options, path("deformed").with_suffix("." + options.animate))
    elif "deformed" in options.only:
        draw_deformed(run, fabric, frames, options, lambda step: path(f"deformed_{run.label(step)}"))
    if "section" in options.only:
        draw_section(run, fabric, path("section"), frames, options.window)
    if "contour" in options.only:
        draw_contour(
            run, fabric, path(f"contour_{run.label(run.turning_frame)}"), run.turning_frame, options.window
        )
