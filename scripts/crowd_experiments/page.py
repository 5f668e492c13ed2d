"""Writes the page with all figures and tables, and the tables as Markdown files."""
import base64
import html
import itertools
import pathlib
import textwrap

from .chapter import Figure, Table

LONGEST_CELL = 80  # [characters] of a printed table
STYLE = '''
body { font-family: sans-serif; max-width: 75em; margin: 2em auto; padding: 0 1em; line-height: 1.4; color: #222; }
table { border-collapse: collapse; margin: 1em 0; font-size: 0.9em; }
caption { text-align: left; font-weight: bold; padding: 0.4em 0; }
th, td { border-bottom: 1px solid #ccc; padding: 0.25em 0.7em; text-align: right; vertical-align: top; }
th:first-child, td:first-child { text-align: left; }
figure { margin: 1.5em 0; } img { max-width: 100%; } figcaption { color: #444; }
code, pre { background: #f4f4f4; } pre { padding: 0.7em; overflow-x: auto; }
'''


def write_page(file, title, program, chapters, intro):
    """Writes a self-contained HTML file with embedded figures. `program` is the name of the program that makes a
    chapter when it is called with the chapter's name; None: there is none, and the page names no commands."""
    contents = ''.join(f'<li><a href="#{chapter.name}">{html.escape(chapter.title)}</a></li>\n' for chapter in chapters)
    body = ''.join(chapter_html(chapter, program) for chapter in chapters)
    file.write_text(
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>\n'
        f'<style>{STYLE}</style></head><body>\n<h1>{html.escape(title)}</h1>\n<p>{html.escape(intro)}</p>\n'
        f'<ul>\n{contents}</ul>\n{body}</body></html>\n', encoding='utf-8')


def chapter_html(chapter, program):
    heading = f'<h2 id="{chapter.name}">{html.escape(chapter.title)}</h2>\n'
    if program is None:
        return heading + ''.join(part_html(part) for part in chapter.parts)
    command = f'research/{program} {chapter.name}'
    parts = ''.join(part_html(part, command) for part in chapter.parts)
    commands = html.escape('\n'.join(chapter.commands))
    return (f'{heading}<p>Command for this chapter: <code>{command}</code></p>\n{parts}'
            f'<details><summary>The commands of one of its runs</summary><pre>{commands}</pre></details>\n')


def part_html(part, command=None):
    if isinstance(part, Table):
        return table_html(part)
    if isinstance(part, Figure):
        picture = base64.b64encode(part.file.read_bytes()).decode()
        origin = f'<br><code>{command}</code>: figures/{part.file.name}' if command else ''
        return (f'<figure><img src="data:image/png;base64,{picture}" alt="{html.escape(part.caption)}">\n'
                f'<figcaption>{html.escape(part.caption)}{origin}</figcaption></figure>\n')
    return f'<p>{html.escape(part)}</p>\n'


def table_html(table):
    def row_html(cells, tag):
        return '<tr>' + ''.join(f'<{tag}>{html.escape(cell)}</{tag}>' for cell in cells) + '</tr>\n'
    rows = ''.join(row_html(row, 'td') for row in table.rows)
    return f'<table><caption>{html.escape(table.title)}</caption>\n{row_html(table.header, "th")}{rows}</table>\n'


def write_tables(folder, chapter):
    """Writes the chapter's texts and tables as Markdown, for use in documents."""
    folder.mkdir(parents=True, exist_ok=True)
    lines = [f'# {chapter.title}', '']
    for part in chapter.parts:
        if isinstance(part, Table):
            lines += [f'{part.title}:', '', *markdown_lines(part), '']
        elif isinstance(part, str):
            lines += [part, '']
    pathlib.Path(folder / f'{chapter.name}.md').write_text('\n'.join(lines), encoding='utf-8')


def markdown_lines(table):
    """Returns the lines of a table in Markdown, without its title."""
    return [markdown_row(table.header), '|---' * len(table.header) + '|', *map(markdown_row, table.rows)]


def markdown_row(cells):
    return '| ' + ' | '.join(cells) + ' |'


def print_table(table):
    """Prints a table; long texts are wrapped."""
    rows = [[textwrap.wrap(cell, LONGEST_CELL) for cell in row] for row in (table.header, *table.rows)]
    widths = [max(len(line) for row in rows for line in row[i] or ['']) for i in range(len(table.header))]
    print(f'\n{table.title}')
    for row in rows:
        for line in itertools.zip_longest(*row, fillvalue=''):
            print('  '.join(f'{cell:<{width}}' if i == 0 else f'{cell:>{width}}'
                            for i, (cell, width) in enumerate(zip(line, widths))).rstrip())
