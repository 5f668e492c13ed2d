"""Style of the figures, with the same colours in all of them."""
import matplotlib

matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402

SET_COLOURS = {'nearest': '#009e73', 'occupancy': '#8e5ea2'}
SET_NAMES = {'nearest': 'set 1, nearest obstacle', 'occupancy': 'set 2, occupancy'}
REFERENCE = '0.25'  # colour of reference lines

SETTINGS = {
    'figure.dpi': 110,
    'savefig.dpi': 110,
    'font.size': 10,
    'axes.titlesize': 11,
    'axes.grid': True,
    'axes.axisbelow': True,
    'grid.color': '0.9',
    'axes.spines.top': False,
    'axes.spines.right': False,
    'legend.frameon': False,
    'legend.fontsize': 9,
}


def short_set_name(states):
    """Returns 'set 1' or 'set 2'."""
    return SET_NAMES[states].split(',')[0]


def new_figure(rows, columns, width, height, **options):
    """Returns a figure with rows x columns panels, and the panels; size in inches."""
    with matplotlib.rc_context(SETTINGS):
        return pyplot.subplots(rows, columns, figsize=(width, height), squeeze=False, layout='constrained', **options)


def save(figure, file):
    """Writes a figure to a file and closes it. Returns the file."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context(SETTINGS):
        figure.savefig(file)
    pyplot.close(figure)
    return file
