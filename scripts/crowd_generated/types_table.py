"""The table of state sets, action sets and rewards in docs/state_sets.md, as train prints it."""
import pathlib
import re

from crowd_drawing.errors import InputError
from crowd_experiments.runs import output_of
from crowd_experiments.tools import build_folder, programs_in, run_build

TABLE = re.compile(r'(<!-- types -->\n).*?(?=<!-- end -->)', re.DOTALL)


def written(package, tools):
    """Returns {file: text} of the page. tools: folder of train, or None."""
    page = package / 'docs' / 'state_sets.md'
    if tools is None:
        run_build()
    folder = programs_in(build_folder() / 'devel') if tools is None else pathlib.Path(tools)
    table = output_of([folder / 'train', '--list-types'])
    text, count = TABLE.subn(lambda found: found[1] + table, page.read_text(encoding='utf-8'))
    if count != 1:
        raise InputError(f'{page}: has {count} tables between <!-- types --> and <!-- end -->, expected one')
    return {page: text}
