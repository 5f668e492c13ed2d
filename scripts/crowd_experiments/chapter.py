"""The results of an experiment: texts, tables and figures, in order."""
import dataclasses
import pathlib


@dataclasses.dataclass(frozen=True)
class Table:
    """Rows of texts under a header; the first column names the row."""
    title: str
    header: list
    rows: list
    name: str = ''  # by which a document refers to it


@dataclasses.dataclass(frozen=True)
class Figure:
    """A picture with its caption."""
    file: pathlib.Path
    caption: str


@dataclasses.dataclass
class Chapter:
    """The results of one experiment."""
    name: str  # of the experiment on the command line
    title: str
    parts: list = dataclasses.field(default_factory=list)  # texts, Tables and Figures
    commands: list = dataclasses.field(default_factory=list)  # command lines of one run, as an example

    def add_text(self, text):
        self.parts.append(text)

    def add_table(self, title, header, rows, name=''):
        self.parts.append(Table(title, header, rows, name))

    def add_figure(self, file, caption):
        self.parts.append(Figure(file, caption))

    def tables(self):
        return [part for part in self.parts if isinstance(part, Table)]
