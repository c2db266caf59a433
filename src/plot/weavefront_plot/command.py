"""The command line of weavefront-plot. Nothing is read or loaded before all options have been checked."""
import argparse
import os
import shutil
import sys
from pathlib import Path

from . import option_values
from .failure import Failure, FileError, InputError
from .option_values import ANIMATIONS, FORMATS, PICTURES, VIEWS

# Options of a run, and the pictures that look at them.
USED_BY = {
    "times": {"deformed", "section"},
    "measured": {"history"},
    "field": {"deformed"},
    "window": {"deformed", "section", "contour"},
    "view": {"deformed"},
    "plies": {"deformed", "section", "contour"},
    "debris": {"deformed"},
    "animate": {"deformed"},
}

LONGEST = 600  # letters of a message


class Parser(argparse.ArgumentParser):
    """Reports usage errors as all others: one line, status 2."""

    def error(self, message):
        raise InputError(message)


def parser():
    """The options."""
    options = Parser(
        prog="weavefront-plot",
        allow_abbrev=False,
        description="Draws pictures from the folder of a run, a study or a v50, or yarn curves.",
        epilog="Exit status: 0 done, 2 bad input or usage, 3 a file cannot be read or written.",
    )
    options.add_argument(
        "run",
        nargs="?",
        metavar="RUN",
        help="folder with results.vtkhdf and history.csv; the run may still be going on",
    )
    options.add_argument(
        "--output",
        metavar="PATH",
        help="folder for the pictures (default: plots in RUN or in the folder of --v50); with --yarn or --study the picture's file",
    )
    options.add_argument(
        "--only", metavar="LIST", help=f"which pictures, from {','.join(PICTURES)} (default: all)"
    )
    options.add_argument(
        "--times",
        metavar="LIST",
        help="times of deformed and section, such as 30us,60us; the nearest frames are "
        "drawn (default: four over the run with the moment of rebound)",
    )
    options.add_argument(
        "--measured",
        metavar="CSV",
        help="points to lay over history: columns time and displacement or velocity (vz) "
        "or both, in s, m and m/s",
    )
    options.add_argument(
        "--field",
        metavar="NAME",
        help="cell array that colours deformed, or height (default: stress, the greater of fill and warp)",
    )
    options.add_argument(
        "--window",
        metavar="L",
        help="show what lies within L of the impact along x and along y, such as 40mm (default: "
        "the deflected area)",
    )
    options.add_argument(
        "--plies",
        metavar="LIST",
        help="plies that deformed and section show, such as 1,3-5; contour shows the last of "
        "them (default: all)",
    )
    options.add_argument(
        "--view",
        metavar="VIEW",
        help=f"camera of deformed: {', '.join(VIEWS)}, or its azimuth and elevation in degrees, "
        f"such as 30,45 (default: back-face, which is {VIEWS['back-face'][0]:g},{VIEWS['back-face'][1]:g})",
    )
    options.add_argument(
        "--animate",
        metavar="FORMAT",
        choices=ANIMATIONS,
        help="draw deformed as one moving picture of all frames, or of "
        "those nearest to --times: gif, or mp4 where ffmpeg is installed",
    )
    options.add_argument(
        "--no-debris",
        dest="debris",
        action="store_false",
        default=None,
        help="leave fabric that is no longer joined to a support out of deformed (default: drawn lighter)",
    )
    options.add_argument("--format", choices=FORMATS, help="of the pictures (default: png)")
    options.add_argument(
        "--yarn",
        metavar="CSV",
        help="draw stress over strain from the output of 'weavefront yarn' instead of a run",
    )
    options.add_argument(
        "--study",
        metavar="DIR",
        help="draw error against cost from the folder of 'weavefront study' instead of a run, into DIR/study.png",
    )
    options.add_argument(
        "--v50",
        metavar="DIR",
        help="draw S-curve, residual velocity and absorbed energy from the folder of 'weavefront v50' "
        "instead of a run, into DIR/plots",
    )
    return options


def parse(arguments):
    """The checked options; InputError where one is wrong or has nothing to work on."""
    options = parser().parse_args(joined_view(arguments))
    for name, text in vars(options).items():
        if text == "":
            raise InputError(f"{'RUN' if name == 'run' else '--' + name}: empty")
    check_mode(options)
    for name, reader in (
        ("only", option_values.pictures),
        ("times", option_values.times),
        ("window", option_values.window),
        ("plies", option_values.plies),
        ("view", option_values.view),
    ):
        if getattr(options, name) is not None:
            setattr(options, name, reader(getattr(options, name)))
    for name in ("run", "output", "measured", "yarn", "study", "v50"):
        if getattr(options, name) is not None:
            setattr(options, name, Path(getattr(options, name)))
    if options.v50 is not None:
        options.format = options.format or FORMATS[0]
    elif options.run is None:
        check_file_name(options)
    else:
        check_use(options)
    return options


def joined_view(arguments):
    """The arguments with "--view -52,24" as one word, which argparse would take for two options."""
    words = []
    for word in arguments:
        if words and words[-1] == "--view":
            words[-1] += "=" + word
        else:
            words.append(word)
    return words


def check_mode(options):
    """One of a run, yarn curves, a study and a v50, with options of its own only."""
    modes = [name for name in ("run", "yarn", "study", "v50") if getattr(options, name) is not None]
    if not modes:
        raise InputError(
            "give the folder of a run, --yarn CSV, --study DIR or --v50 DIR; see weavefront-plot --help"
        )
    if modes == ["run", "yarn"]:
        raise InputError("give either RUN or --yarn, not both")
    if len(modes) > 1:
        raise InputError("give one of RUN, --yarn, --study and --v50")
    if modes != ["run"]:
        given = [name for name in ("only", *USED_BY) if getattr(options, name) is not None]
        if given:
            raise InputError(f"{spelled(given[0])} does not go with --{modes[0]}")


def spelled(name):
    """The option as it is given."""
    return "--no-debris" if name == "debris" else f"--{name}"


def check_use(options):
    """Each option has a picture that it works on."""
    options.only = options.only or list(PICTURES)
    for name, pictures in USED_BY.items():
        if getattr(options, name) is not None and not pictures & set(options.only):
            raise InputError(
                f"{spelled(name)}: --only leaves out {' and '.join(p for p in PICTURES if p in pictures)}"
            )
    if options.animate == "mp4" and shutil.which("ffmpeg") is None:
        raise FileError("--animate: mp4 needs the program ffmpeg, which is not installed; gif does not")
    options.view = options.view or VIEWS["back-face"]
    options.debris = options.debris is None
    options.format = options.format or FORMATS[0]


def check_file_name(options):
    """The file of --yarn or --study: its name says the format."""
    if options.output is None:
        source = options.yarn or options.study / "study"
        options.output = source.with_suffix("." + (options.format or FORMATS[0])) if source.name else None
        if options.output is None:
            raise InputError(f"--yarn: '{options.yarn}' is no file")
    ending = options.output.suffix[1:]
    if ending not in FORMATS:
        raise InputError(f"--output: '{options.output}' must end in one of .{', .'.join(FORMATS)}")
    if options.format not in (None, ending):
        raise InputError(
            f"--output: '{options.output}' does not end in .{options.format}, which --format asks for"
        )


def main():
    """Runs the program and returns its exit status."""
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")  # names of files are bytes of any kind
    options = None
    try:
        options = parse(sys.argv[1:])
        from .pictures import draw

        draw(options)
    except Failure as failure:
        return report(failure, failure.status)
    except ImportError as error:
        return report(
            f"cannot load what drawing needs: {error}; see 'Dependencies' in the README", FileError.status
        )
    except MemoryError:
        return report(f"{subject(options)}: not enough memory to draw it", FileError.status)
    except KeyboardInterrupt:
        return report("interrupted", 130)
    except OSError as error:
        return report(f"{subject(options)}: {error.strerror or error}", FileError.status)
    except Exception as error:  # a fault of ours: what a file holds is checked where it is read
        return report(
            f"{subject(options)}: cannot be drawn: {type(error).__name__}: {error}", InputError.status
        )
    return 0


def subject(options):
    """What is drawn."""
    return options and (options.run or options.yarn or options.study or options.v50)


def report(what, status):
    """One line on standard error; returns the status."""
    try:
        line = " ".join(str(what).split())
        print(
            "weavefront-plot: error:", line if len(line) <= LONGEST else line[:LONGEST] + "…", file=sys.stderr
        )
    except OSError:  # nobody reads it
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    return status
