"""Files that programs write."""
import pathlib

from crowd_drawing.errors import InputError


def check_output(file):
    """Raises InputError if a file cannot be written, because there is no folder for it, or it is a folder itself. To be
    called before work that takes long."""
    file = pathlib.Path(file)
    if file.is_dir():
        raise InputError(f'{file}: cannot be written: it is a folder')
    if not file.parent.is_dir():
        raise InputError(f'{file}: cannot be written: there is no folder {file.parent.absolute()}')
