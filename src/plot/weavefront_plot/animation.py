"""deformed.gif or deformed.mp4: the plies in space as a moving picture."""
import subprocess

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FFMpegWriter, PillowWriter

from .deformed import Deformed
from .failure import FileError
from .picture_file import write

DPI = 110
SECONDS = 8.0  # of the whole, within the limits of frames a second
RATES = (4, 20)  # frames a second


def draw_animation(run, fabric, frames, look, path):
    """One moving picture of the frames, in the same scale and colours."""
    pictures = Deformed(run, fabric, frames, look, DPI)
    rate = int(np.clip(len(frames) / SECONDS, *RATES))
    figure, shown, caption = pictures.figure(frames[0])
    try:
        write(
            path,
            lambda temporary: save(
                run, frames, pictures, (figure, shown, caption), writer_for(path, rate), temporary
            ),
        )
    except subprocess.CalledProcessError as error:
        raise FileError(f"{path}: ffmpeg ended with status {error.returncode}") from None
    finally:
        plt.close(figure)


def writer_for(path, rate):
    """The writer of matplotlib for this kind of file."""
    if path.suffix == ".gif":
        return PillowWriter(fps=rate)
    even = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-pix_fmt", "yuv420p"]  # what players take
    return FFMpegWriter(fps=rate, codec="h264", extra_args=even)


def save(run, frames, pictures, artists, writer, path):
    """Draws frame after frame into the file."""
    figure, shown, caption = artists
    with writer.saving(figure, str(path), DPI):
        for step in frames:
            shown.set_data(pictures.image(step))
            caption.set_text(run.caption(step))
            writer.grab_frame()
