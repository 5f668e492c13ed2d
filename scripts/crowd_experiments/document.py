"""Fills a Markdown document with measured tables and pictures."""
import pathlib
import re
import shutil

from .chapter import Figure
from .page import markdown_lines

MARKS = re.compile(r'(<!-- table ([\w/]+) -->\n).*?(<!-- end -->)', re.DOTALL)
PICTURES = re.compile(r'!\[[^\]]*\]\(images/(\w+\.png)\)')


def fill_document(file, chapters):
    """Replaces the text between the marks `<!-- table CHAPTER/NAME -->` and `<!-- end -->` by the table, and copies the
    figures that the document shows to images/. Returns a message for each table and figure that was not measured."""
    file = pathlib.Path(file)
    tables = {f'{chapter.name}/{table.name}': table for chapter in chapters for table in chapter.tables() if table.name}
    figures = {part.file.name: part.file for chapter in chapters for part in chapter.parts if isinstance(part, Figure)}
    text = file.read_text(encoding='utf-8')
    file.write_text(MARKS.sub(lambda match: filled(match, tables), text), encoding='utf-8')
    shown = PICTURES.findall(text)
    for name in shown:
        if name in figures:
            shutil.copyfile(figures[name], file.parent / 'images' / name)
    missing = [name for _, name, _ in MARKS.findall(text) if name not in tables]
    missing += [name for name in shown if name not in figures]
    return [f'{file}: {name} was not measured and is left unchanged' for name in missing]


def filled(match, tables):
    """Returns the marks with the table between them; the unchanged text if there is no such table."""
    begin, name, end = match.groups()
    if name not in tables:
        return match[0]
    return begin + '\n'.join(markdown_lines(tables[name])) + '\n' + end
