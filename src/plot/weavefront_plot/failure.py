"""What stops weavefront-plot, with the exit status of each."""


class Failure(Exception):
    """Ends the program with one line on standard error."""

    status = 1


class InputError(Failure):
    """The command line or the content of a file is wrong."""

    status = 2


class FileError(Failure):
    """A file is missing or cannot be read or written."""

    status = 3
