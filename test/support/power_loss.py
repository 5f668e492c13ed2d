"""What can be on a disk after a loss of power, from the calls of a program (calls.py)."""
import itertools


class Disk:
    """Files of one folder. What was not flushed may be lost: of a file, all that was written, its end, or all but the
    size; of the folder, the last changes of names."""

    def __init__(self, files):
        self.names = {}  # on the disk: numbers of files by name
        self.contents = {}  # on the disk, by number
        self.pending_names = []  # functions that change a dictionary of names
        self.pending = {}  # contents by number, after all writes
        self.seen = {}  # numbers by name, as programs see them
        for number, (name, content) in enumerate(sorted(files.items())):
            self.names[name] = self.seen[name] = number
            self.contents[number] = content
        self.numbers = itertools.count(len(files))

    def change_names(self, change):
        """Changes names; on the disk later, or never."""
        change(self.seen)
        self.pending_names.append(change)

    def call(self, call):
        """Does a call."""
        path = call.path
        if call.kind in ('create', 'truncate') and path not in self.seen:
            number = next(self.numbers)
            self.contents[number] = b''
            self.change_names(lambda names: names.update({path: number}))
        number = self.seen.get(path)
        if call.kind == 'rename':
            self.change_names(lambda names: names.update({call.other: names.pop(path)}))
        elif call.kind == 'unlink' and number is not None:
            self.change_names(lambda names: names.pop(path))
        elif call.kind == 'fsync' and path == '':
            for change in self.pending_names:
                change(self.names)
            self.pending_names = []
        elif number is not None:
            self.change_content(call, number)

    def change_content(self, call, number):
        """Writes, cuts or flushes a file."""
        content = self.pending.get(number, self.contents[number])
        if call.kind == 'write':
            self.pending[number] = content + call.data
        elif call.kind == 'truncate':
            self.pending[number] = b''
        elif call.kind == 'ftruncate':
            self.pending[number] = content[:int.from_bytes(call.data, 'little')]
        elif call.kind == 'fsync':
            self.contents[number] = self.pending.pop(number, content)

    def states(self):
        """Yields the contents of the files by name that there can be."""
        for count in range(len(self.pending_names) + 1):
            names = dict(self.names)
            for change in self.pending_names[:count]:
                change(names)
            unsure = [name for name, number in names.items() if number in self.pending]
            for parts in itertools.product(*(self.parts(names[name]) for name in unsure)):
                yield {**{name: self.contents[number] for name, number in names.items()}, **dict(zip(unsure, parts))}

    def parts(self, number):
        """Returns what can be in a file that was not flushed."""
        before, after = self.contents[number], self.pending[number]
        middle = (len(before) + len(after)) // 2
        return {before, after, after[:middle], before[:len(after)] + bytes(max(0, len(after) - len(before)))}


def states_after(files, calls):
    """Yields the states of a disk after a loss of power before each call and at the end, each one once. `files`:
    contents by name at the beginning."""
    disk, known = Disk(files), set()
    for call in [None, *calls]:
        if call is not None:
            disk.call(call)
        for state in disk.states():
            key = frozenset(state.items())
            if key not in known:
                known.add(key)
                yield state
