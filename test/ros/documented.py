"""Topics, services and parameters of nodes as the pages in docs/ have them, and parameters as the nodes log them."""
import math
import re
from collections import namedtuple

import support

Parameter = namedtuple('Parameter', 'meaning range default')
Range = namedtuple('Range', 'unit low high above below')
# A number such as 1e6, 10^9 or -1.
NUMBER = r'-?\d+(?:\.\d+)?(?:e[+-]?\d+|\^\d+)?'
LIMITS = re.compile(rf'^(?:(?P<unit>[a-zA-Z][^,]*?)(?: of the wall clock)?, )?(?P<above>above )?(?P<low>{NUMBER})'
                    rf'(?: \([^)]*\))?(?: to (?P<below>below )?(?P<high>{NUMBER})| or above)$')
UNLIMITED = 2147483647.0  # the highest whole number stands for no limit


def section(page, title):
    """Returns the text of a section of a page."""
    found = re.search(rf'^## {title}\n(.*?)(?=^## |\Z)', support.read_text(support.in_package('docs', page)),
                      re.DOTALL | re.MULTILINE)
    assert found, f'{page} has no section {title}'
    return found[1]


def rows(text, title):
    """Returns the rows of the tables whose first column has this title, as lists of cells."""
    found = []
    for table in re.findall(r'(?:^\|.*\|\n)+', text, re.MULTILINE):
        lines = [[cell.strip() for cell in re.split(r'(?<!\\)\|', line[1:-1])] for line in table.splitlines()]
        if lines[0][0] == title:
            found += lines[2:]
    return found


def names_in(cell):
    """Returns the names in a cell."""
    return re.findall(r'`([^`]+)`', cell)


def typed(text, title):
    """Returns {name: type} of a table of topics or services. Types without a package are of this one, or of the package
    of the type before."""
    kinds = {}
    for cells in rows(text, title):
        types, package = [], 'social_crowd'
        for kind in re.sub(r'\s*\([^)]*\)|, latched', '', cells[1]).split(', '):
            package = kind.split('/')[0] if '/' in kind else package
            types.append(kind if '/' in kind else f'{package}/{kind}')
        names = names_in(cells[0])
        kinds.update(zip(names, types if len(types) == len(names) else types * len(names)))
    return kinds


def parameters(text):
    """Returns {name: Parameter} of the tables of parameters."""
    found = {}
    for cells in rows(text, 'parameter'):
        names = [name.lstrip('~') for name in names_in(cells[0])]
        limits = cells[2] if len(cells) > 3 else ''
        defaults = cells[-1].split(', ') if len(names) > 1 else [cells[-1]]
        found.update({name: Parameter(cells[1], limits, default) for name, default in zip(names, defaults)})
    return found


def number(text):
    """Returns the number of a text such as 10^6."""
    base, _, power = text.partition('^')
    return float(base) ** int(power) if power else float(text)


def documented_range(text):
    """Returns the Range of a cell such as "s, 0.001 to 3600" or "0 or above"; None for another text."""
    found = LIMITS.match(text)
    if not found:
        return None
    high = number(found['high']) if found['high'] else math.inf
    return Range(found['unit'] or '', number(found['low']), high, bool(found['above']), bool(found['below']))


def stated_range(text):
    """Returns the Range of a node's text such as "a number from 0.001 to 3600 s"; None for another text."""
    found = re.search(rf'number (?:(above )|from )({NUMBER})(?:, at most | to )(below )?({NUMBER})(?: (\S+))?$', text)
    if not found:
        return None
    high = number(found[4])
    return Range(found[5] or '', number(found[2]), math.inf if high == UNLIMITED else high, bool(found[1]),
                 bool(found[3]))


def stated_parameters(output):
    """Returns {name: (expected, default)} of the output of a node that logs its parameters."""
    lines = re.findall(r'parameter ~(\w+): (.*)', output)
    return {name: tuple((text.split('; default ') + [''])[:2]) for name, text in lines}
