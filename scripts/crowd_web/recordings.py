"""Recordings that a page may open: the files of one folder."""
import asyncio
import pathlib

from crowd_drawing.errors import InputError, problem_of
from crowd_drawing.files import DEFAULT_TICK
from crowd_recordings.formats import WRITTEN, read_recording

ENDINGS = ('.csv', '.txt', '.jsonl')
GREATEST_FILE = 64 * 2**20  # [bytes]


class Recordings:
    """A folder with recordings, or none."""

    def __init__(self, folder):
        self.folder = None if folder is None else pathlib.Path(folder)

    def names(self):
        """Returns the names of the files."""
        if self.folder is None:
            return []
        return sorted(file.name for file in self.folder.iterdir() if file.suffix in ENDINGS and file.is_file())

    async def read(self, name):
        """Returns the first instance of a recording as CSV, and the time between two frames. Raises InputError."""
        try:
            if name not in self.names():
                raise InputError(f"there is no recording '{name}'")
            return await asyncio.get_running_loop().run_in_executor(None, self.convert, self.folder / name)
        except OSError as error:
            raise InputError(problem_of(error)) from None

    @staticmethod
    def convert(file):
        """Reads a file and writes it as CSV. Raises InputError, OSError."""
        if file.stat().st_size > GREATEST_FILE:
            raise InputError(f'{file.name}: has more than {GREATEST_FILE // 2**20} MB')
        recording = read_recording(file)
        head, line = WRITTEN['.csv']
        lines = [line.format(frame=frame, person=person, x=x, y=y)
                 for person, walk in recording.walks.items() for frame, x, y in walk]
        return {'csv': head + ''.join(lines), 'tick_duration': recording.frame_duration or DEFAULT_TICK}
