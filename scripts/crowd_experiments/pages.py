"""Chapters with the results of experiments, and what is made of them: printed tables, Markdown, HTML, documents."""
import base64
import dataclasses
import itertools
import pathlib
import re
import shutil
import textwrap
import typing

from crowd_drawing.errors import RunError

MARKS = re.compile(r'(<!-- table ([\w/]+) -->\n).*?(<!-- end -->)', re.DOTALL)
PHRASES = re.compile(r'(<!-- phrase ([\w/]+) -->).*?(<!-- end -->)', re.DOTALL)
PICTURES = re.compile(r'!\[[^\]]*\]\(images/(\w+\.png)\)')
LONGEST_CELL = 80  # [characters] of a printed table
TEMPLATE = pathlib.Path(__file__).with_name('page.html')


class Table(typing.NamedTuple):
    """Rows of texts under a header; the first column names the row. By its name a document refers to it."""
    title: str
    header: list
    rows: list
    name: str = ''

    def markdown(self):
        lines = [f"| {' | '.join(row)} |" for row in (self.header, *self.rows)]
        return '\n'.join([lines[0], '|---' * len(self.header) + '|', *lines[1:], ''])

    def print(self):
        rows = [[textwrap.wrap(cell, LONGEST_CELL) for cell in row] for row in (self.header, *self.rows)]
        widths = [max(len(line) for row in rows for line in row[i] or ['']) for i in range(len(self.header))]
        print(f'\n{self.title}')
        for row in rows:
            for line in itertools.zip_longest(*row, fillvalue=''):
                print('  '.join(f'{cell:{"<" if i == 0 else ">"}{width}}'
                                for i, (cell, width) in enumerate(zip(line, widths))).rstrip())


class Figure(typing.NamedTuple):
    """A picture, or a film that browsers show as one, with its caption."""
    file: pathlib.Path
    caption: str

    def data(self):
        """Returns the picture as the address of an image in HTML."""
        return f'data:image/{self.file.suffix[1:]};base64,{base64.b64encode(self.file.read_bytes()).decode()}'


@dataclasses.dataclass
class Chapter:
    """The results of one experiment: texts, Tables and Figures, in order."""
    name: str  # of the experiment on the command line
    title: str
    parts: list = dataclasses.field(default_factory=list)
    commands: list = dataclasses.field(default_factory=list)  # command lines of one run, as an example
    phrases: dict = dataclasses.field(default_factory=dict)  # texts for a document, by their names

    def add_text(self, text):
        self.parts.append(text)

    def add_table(self, title, header, rows, name=''):
        self.parts.append(Table(title, header, rows, name))

    def add_figure(self, file, caption):
        """Adds a picture, if there is one."""
        self.parts += [Figure(file, caption)] if file else []

    def tables(self):
        return [part for part in self.parts if isinstance(part, Table)]

    def markdown(self, images=None):
        """Returns the texts and tables, with the figures that the folder `images` contains."""
        texts = [f'# {self.title}']
        for part in self.parts:
            if isinstance(part, Table):
                texts.append(f'{part.title}:\n\n{part.markdown().rstrip()}')
            elif not isinstance(part, Figure):
                texts.append(part)
            elif images and (images / part.file.name).is_file():
                texts.append(f'![]({images.name}/{part.file.name})\n\n{part.caption}')
        return '\n\n'.join(texts) + '\n'


def write_page(file, title, program, chapters, intro):
    """Writes a self-contained HTML file with embedded figures. `program` is the name of the program that makes a
    chapter when it is called with the chapter's name; None: there is none, and the page names no commands."""
    import jinja2  # where a page is written only, as it takes a tenth of a second
    template = jinja2.Template(TEMPLATE.read_text(encoding='utf-8'), autoescape=True, trim_blocks=True)
    file.write_text(template.render(title=title, program=program, chapters=chapters, intro=intro), encoding='utf-8')


def write_chapters(folder, chapters):
    """Writes a Markdown page for each chapter, and the figures that folder/images contains."""
    for chapter in chapters:
        (folder / f'{chapter.name}.md').write_text(chapter.markdown(folder / 'images'), encoding='utf-8')
        for part in chapter.parts:
            if isinstance(part, Figure) and (folder / 'images' / part.file.name).is_file():
                shutil.copyfile(part.file, folder / 'images' / part.file.name)


def require_table(file, name):
    """Checks that a document has the marks of a table CHAPTER/NAME, before anything is measured. Raises RunError."""
    tables = [mark[1] for mark in MARKS.findall(pathlib.Path(file).read_text(encoding='utf-8'))]
    if name not in tables:
        has = f'has the tables {", ".join(tables)}' if tables else 'has no tables'
        raise RunError(f'{file}: {has}; to get this one, add the lines <!-- table {name} --> and <!-- end -->')


def fill_document(file, chapters):
    """Replaces the text between the marks `<!-- table CHAPTER/NAME -->` and `<!-- end -->` by the table, that between
    `<!-- phrase CHAPTER/NAME -->` and `<!-- end -->` by the phrase, and copies the figures that the document shows to
    images/. Returns a message for each table, phrase and figure that was not measured."""
    file = pathlib.Path(file)
    tables = {f'{chapter.name}/{table.name}': table for chapter in chapters for table in chapter.tables() if table.name}
    figures = {part.file.name: part.file for chapter in chapters for part in chapter.parts if isinstance(part, Figure)}
    phrases = {f'{chapter.name}/{name}': text for chapter in chapters for name, text in chapter.phrases.items()}
    text = file.read_text(encoding='utf-8')
    filled = MARKS.sub(lambda match: match[1] + tables[match[2]].markdown() + match[3] if match[2] in tables
                       else match[0], text)
    file.write_text(PHRASES.sub(lambda match: match[1] + phrases[match[2]] + match[3] if match[2] in phrases
                                else match[0], filled), encoding='utf-8')
    shown = PICTURES.findall(text)
    for name in set(shown) & set(figures):
        shutil.copyfile(figures[name], file.parent / 'images' / name)
    missing = [name for _, name, _ in MARKS.findall(text) if name not in tables]
    missing += [name for _, name, _ in PHRASES.findall(text) if name not in phrases]
    missing += [name for name in shown if name not in figures]
    return [f'{file}: {name} was not measured and is left unchanged' for name in missing]
