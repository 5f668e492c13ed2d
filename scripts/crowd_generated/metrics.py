"""Writes what follows from the fields of results and their comments: lists in C++, messages, rows of a page."""
import re
import typing

from crowd_drawing.errors import InputError

HEADERS = {'robot_result.h': ('RobotInput', 'RobotGoalResult', 'RobotResult'), 'results.h': ('AgentResult',)}
MESSAGES = {'RobotResult': ('RobotResult', 'RobotInput'), 'RobotGoalResult': ('RobotGoalResult',),
            'AgentResult': ('AgentResult',)}
OF_MESSAGES = ('agent', 'robot', 'goals')  # fields that messages alone have
UNMEASURED = ('name',)
OF_TWO_RUNS = ('people_compared', 'people_delay', 'people_detour')
TYPES = {'bool': 'bool', 'double': 'float64', 'std::uint64_t': 'uint64', 'std::string': 'string'}
OTHERS = ('std::vector', 'Robot')  # how types of fields begin that are lists or other results
# A field, and its comment, which may go on in the next lines.
FIELD = re.compile(r'^  ([\w:<>]+) (\w+)(?: = [^;]+)?;((?:\s+///<.*)*)$', re.MULTILINE)
ROW = re.compile(r'(\S+) (\w+) *# (.*)')  # of a message
VISITED = re.compile(r'^    visit\((?:MetricName\{)?"(\w+)".*\.\.\.\);$', re.MULTILINE)
LIST = re.compile(r'(?:    visit\(MetricName\{.*\}, (\w+)\..*\.\.\.\);\n)+')


class Field(typing.NamedTuple):
    """A field of a result."""
    kind: str
    name: str
    comment: str  # with the unit

    def unit(self):
        return (re.findall(r'\[(\S+)\]$', self.comment) or [''])[0]

    def meaning(self):
        """Returns the comment without the unit, for a table."""
        return re.sub(r'\s*\[\S+\]$', '', self.comment).replace('|', '\\|')

    def visit(self, results):
        """Returns the call that visits it."""
        unit = f', "{self.unit()}"' if self.unit() else ''
        return f'    visit(MetricName{{"{self.name}"{unit}}}, {results}.{self.name}...);\n'


def struct_of(text, name):
    """Returns the body of a struct."""
    found = re.search(rf'^struct {name} \{{\n(.*?)^\}};', text, re.DOTALL | re.MULTILINE)
    if found is None:
        raise InputError(f'include/social_crowd: {name}: expected this struct in one of {", ".join(HEADERS)}')
    return found[1]


def fields_of(struct):
    """Returns {name: Field} of the body of a struct, without lists and other results."""
    fields = [Field(kind, name, ' '.join(re.split(r'\s+///<\s*', comment)[1:]))
              for kind, name, comment in FIELD.findall(struct) if not kind.startswith(OTHERS)]
    for kind, name, _ in fields:
        if kind not in TYPES:
            raise InputError(f'include/social_crowd: {name}: its type is {kind}, expected one of {", ".join(TYPES)}')
    return {field.name: field for field in fields}


def with_lists(text, structs):
    """Returns the text of a header with lists of all fields that have a MetricName."""
    for name in structs:
        struct = struct_of(text, name)
        listed = [field for field in fields_of(struct).values() if field.name not in UNMEASURED + OF_TWO_RUNS]
        text = text.replace(struct, LIST.sub(lambda found: ''.join(field.visit(found[1]) for field in listed), struct,
                                             count=1))
    return text


def with_missing(lines, fields, names_of, line_of):
    """Returns lines with one for each field that they do not name, behind that of the field before it."""
    place = 0
    for field in fields:
        named = [i for i, line in enumerate(lines) if field.name in names_of(line)]
        if not named:
            lines = [*lines[:place], line_of(field), *lines[place:]]
        place = named[-1] + 1 if named else place + 1
    return lines


def row_of(line):
    """Returns type, name and comment of a field of a message."""
    found = ROW.fullmatch(line)
    if found is None:
        raise InputError(f"msg: '{line}': expected a type, a name and a comment")
    return found.groups()


def message_of(text, structs):
    """Returns the text of a message with the fields that structs visit; those in no struct are its own."""
    known = {name: field for struct in structs for name, field in fields_of(struct).items()}
    head, *lines = text.splitlines()
    rows = [row_of(line) for line in lines]
    rows = [row for row in rows if row[1] in known or row[1] in OF_MESSAGES]
    visited = [known[name] for struct in structs for name in VISITED.findall(struct)]
    rows = with_missing(rows, visited, lambda row: row[1:2], lambda field: field)
    rows = [(TYPES[known[row[1]].kind], *known[row[1]][1:]) if row[1] in known else row for row in rows]
    for _, name, comment in rows:
        if not comment:
            raise InputError(f'include/social_crowd: {name}: expected a comment that says what it is')
    width = max(len(f'{kind} {name}') for kind, name, _ in rows)
    return ''.join(f'{line}\n' for line in [head, *(f'{f"{kind} {name}":{width}} # {comment}'
                                                    for kind, name, comment in rows)])


def page_of(text, fields):
    """Returns the text of a page whose tables `| field | unit |` have all fields, and their units."""
    lines, kept, inside = [], [], False
    for line in text.splitlines():
        inside = line.startswith('|') and (inside or line.startswith('| field | unit |'))
        lines.append((line, re.findall(r'`(\w+)`', line.split('|')[1]) if inside else []))
    lines = with_missing(lines, list(fields.values()), lambda line: line[1],
                         lambda field: (f'| | | | {field.meaning()} |', [field.name]))
    for line, names in lines:
        present = [name for name in names if name in fields]
        if present:
            units = [fields[name].unit() for name in present]
            unit = units[0] if len(set(units)) == 1 else ', '.join(units)
            rest = line.split('|', 3)[3]
            line = f"| {', '.join(f'`{name}`' for name in present)} |{f' {unit} ' if unit else ' '}|{rest}"
        if present or not names:
            kept.append(line)
    return '\n'.join(kept) + '\n'


def written(package):
    """Returns {file: text} of all files that are written."""
    texts, structs = {}, {}
    for name, named in HEADERS.items():
        file = package / 'include' / 'social_crowd' / name
        texts[file] = with_lists(file.read_text(encoding='utf-8'), named)
        structs.update((struct, struct_of(texts[file], struct)) for struct in named)
    for name, named in MESSAGES.items():
        file = package / 'msg' / f'{name}.msg'
        texts[file] = message_of(file.read_text(encoding='utf-8'), [structs[struct] for struct in named])
    fields = {name: field for struct in MESSAGES['RobotResult'] for name, field in fields_of(structs[struct]).items()
              if name not in UNMEASURED}
    file = package / 'docs' / 'metrics.md'
    texts[file] = page_of(file.read_text(encoding='utf-8'), fields)
    return texts
