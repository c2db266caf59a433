"""Files written whole or not at all."""
import os
import secrets
import stat
import sys

from .failure import FileError


def check_place(path):
    """FileError where something stands that is not replaced: only files that pictures are kept in are."""
    try:
        mode = os.lstat(path).st_mode
    except FileNotFoundError:
        return
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    if not stat.S_ISREG(mode):
        kind = "a link" if stat.S_ISLNK(mode) else "a folder" if stat.S_ISDIR(mode) else "a device or a pipe"
        raise FileError(f"{path}: is {kind}, which is not replaced; remove it or choose another --output")


def write(path, save):
    """Calls save(temporary path) and renames its result to `path`, so that no half-written file is ever
    seen."""
    check_place(path)
    temporary = path.with_name(f".{path.stem[:100]}.{secrets.token_hex(6)}{path.suffix}")
    try:
        os.close(os.open(temporary, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
        try:
            save(temporary)
            os.replace(temporary, path)
        finally:
            temporary.unlink(missing_ok=True)
    except OSError as error:
        raise FileError(f"{path}: {error.strerror or error}") from None
    announce(path)


def announce(line):
    """Prints a line at once. Where nobody reads any more, as after `| head`, drawing goes on without."""
    try:
        print(line, flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise FileError(f"standard output: {error.strerror}") from None
