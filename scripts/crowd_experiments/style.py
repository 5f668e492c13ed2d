"""Style of the figures, with the same colours in all of them."""
import pathlib

import matplotlib

matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402

SET_COLOURS = {'nearest': '#009e73', 'occupancy': '#8e5ea2'}
SET_NAMES = {'nearest': 'set 1, nearest obstacle', 'occupancy': 'set 2, occupancy'}
REFERENCE = '0.25'  # colour of reference lines

SETTINGS = pathlib.Path(__file__).with_name('figures.mplstyle')


def short_set_name(states):
    return SET_NAMES[states].split(',')[0]


def new_figure(rows, columns, width, height, **options):
    """Returns a figure with rows x columns panels, and the panels; size in inches."""
    with matplotlib.rc_context(fname=SETTINGS):
        return pyplot.subplots(rows, columns, figsize=(width, height), squeeze=False, layout='constrained', **options)


def save(figure, file):
    """Writes a figure to a file and closes it. Returns the file."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context(fname=SETTINGS):
        figure.savefig(file)
    pyplot.close(figure)
    return file
