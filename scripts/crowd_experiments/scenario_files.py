"""The files that scenarios, and configurations of trainings, depend on."""
import functools

from crowd_drawing.errors import read_documents

from .tools import find_config


def kinds_file():
    """Returns the file of the package's kinds of people."""
    return find_config() / 'kinds.yaml'


def files_named_in(document):
    """Yields (container, key) for each place of a scenario document that names a file."""
    if 'map' in document:
        yield document, 'map'
    for entry in document.get('recorded') or []:
        yield entry, 'file'
    if isinstance(document.get('kinds'), str):
        yield document, 'kinds'


def has_kinds(document):
    """Returns whether people of a scenario document have kinds, which may be those of the package."""
    return any('kind' in entry for key in ('agents', 'sources') for entry in document.get(key) or [])


def files_behind(file):
    """Returns the files that a YAML file depends on, directly or not: scenarios of a training; maps, their images,
    recordings, and kinds of people of a scenario. It need not be one of these. Raises InputError, OSError."""
    state = file.stat()
    files = []
    for named in named_in(file, state.st_size, state.st_mtime_ns):
        files += [named, *(files_behind(named) if named.suffix == '.yaml' else [])]
    return files


@functools.lru_cache(maxsize=None)
def named_in(file, _size, _time):
    """Returns the files that a YAML file names; it is read once while its size and time are the same."""
    return [named for document in read_documents(file) for named in named_in_document(file.parent, document)]


def named_in_document(folder, document):
    try:
        if 'training' in document:
            return [folder / name for name in document['training'].get('scenarios', [])]
        if 'image' in document:  # a map
            return [folder / document['image']]
        return [*(folder / entry[key] for entry, key in files_named_in(document)),
                *([kinds_file()] if has_kinds(document) else [])]
    except (AttributeError, KeyError, TypeError):  # the program that reads it names the mistake
        return []
