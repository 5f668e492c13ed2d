"""Finds train and evaluate, and builds them where that is needed."""
import os
import pathlib
import subprocess
import sys

from crowd_drawing.errors import RunError

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ('train', 'evaluate')
SOURCES = ('CMakeLists.txt', 'package.xml', 'include', 'src', 'msg', 'srv')
BUILT = 'sources_built'  # in the build folder: has the time at which the last successful scripts/build began


def find_tools(given):
    """Returns the folder of the programs: given, beside this program, built or sourced; else builds them."""
    folder = given or pathlib.Path(sys.argv[0]).parent
    if has_tools(folder):
        return folder.resolve()
    if given:
        raise RunError(f'{given}: has no train and evaluate')
    build = build_folder()
    built = programs_in(build / 'devel')
    if has_tools(built) and is_current(build):
        return built
    sourced = next((programs_in(prefix) for prefix in workspaces() if prefix != build / 'devel'), None)
    if sourced is None:
        run_build()
    return sourced or built


def find_config():
    """Returns the folder of scenarios, Q-tables and training configurations, in a clone or an installed package."""
    for folder in (REPOSITORY / 'config', REPOSITORY.parent / 'share' / 'social_crowd' / 'config'):
        if (folder / 'scenarios').is_dir():
            return folder
    raise RunError(f'{REPOSITORY}: found no config/scenarios')


def find_table(name_or_file):
    """Returns the given Q-table file, or the package's one of that name if there is no such file."""
    shipped = find_config() / 'q_tables' / f'{name_or_file}.txt'
    return shipped if shipped.is_file() and not os.path.exists(name_or_file) else pathlib.Path(name_or_file)


def find_evaluation(arguments):
    """Returns the program evaluate and the Q-table that the options --tools and --q-table name."""
    q_table = find_table(arguments.q_table or 'anticipation').absolute()
    if not q_table.is_file():
        raise RunError(f'{q_table}: there is no such Q-table')
    return find_tools(arguments.tools) / 'evaluate', q_table


def programs_in(prefix):
    return prefix / 'lib' / 'social_crowd'


def has_tools(folder):
    return all(os.access(folder / tool, os.X_OK) for tool in TOOLS)


def is_current(build):
    """Returns whether no source was changed since the last successful scripts/build began."""
    try:
        began = (build / BUILT).stat().st_mtime
    except OSError:
        return False
    paths = [REPOSITORY / name for name in SOURCES]
    files = [file for path in paths for file in (path, *path.rglob('*'))]
    return max(file.lstat().st_mtime for file in files) <= began  # editors make links to files that do not exist


def workspaces():
    """Yields the devel folders of catkin workspaces in the environment that contain this package and its programs."""
    for prefix in map(pathlib.Path, filter(None, os.environ.get('CMAKE_PREFIX_PATH', '').split(':'))):
        try:
            sources = (prefix / '.catkin').read_text(encoding='utf-8').split(';')
        except OSError:
            continue
        contains = any(pathlib.Path(source) in (REPOSITORY, *REPOSITORY.parents) for source in sources if source)
        if contains and has_tools(programs_in(prefix)):
            yield prefix.resolve()


def build_folder():
    return pathlib.Path(os.environ.get('SOCIAL_CROWD_BUILD', REPOSITORY / '.build')).resolve()


def run_build(*words):
    """Builds the package in the clone. Returns the folder of the programs."""
    print('Building (takes minutes the first time)', flush=True)
    done = subprocess.run([REPOSITORY / 'scripts' / 'build', *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    if done.returncode != 0:
        raise RunError(f'{done.stdout}\nthe package does not build')
    return programs_in(build_folder() / 'devel')
