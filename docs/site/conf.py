"""Configuration of Sphinx for the site, which scripts/site builds from the pages of the repository."""
import os
import pathlib
import re
import xml.etree.ElementTree as ElementTree

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ElementTree.parse(REPOSITORY / 'package.xml')
LINK = re.compile(r'\]\(([\w./]+)\.md\)')
PICTURE = re.compile(r'!\[([^]]+)\]\(([\w./]+)\)')
ARGUMENT = re.compile(r'[a-z_][\w, ]*: ')

project = PACKAGE.findtext('name')
version = release = PACKAGE.findtext('version')
extensions = ['breathe', 'myst_parser', 'sphinx.ext.autodoc', 'sphinx_copybutton']
root_doc = 'README'
include_patterns = ['*.md', 'CHANGELOG.rst', 'docs/*.md', 'docs/site/*', 'research/README.md', 'research/docs/**']
exclude_patterns = ['.*', 'build*', 'devel', 'install']
html_theme = 'furo'
html_title = f'{project} {version}'
html_show_copyright = False
html_copy_source = False
html_static_path = ['site.css']
html_css_files = ['site.css']
highlight_language = 'none'  # of blocks without a language
myst_heading_anchors = 4
autoclass_content = 'both'
autodoc_default_options = {'inherited-members': 'BaseException,OSError,Env,VecEnv,VectorEnv'}  # not those of Gymnasium
autodoc_member_order = 'bysource'
breathe_default_project = project
breathe_projects = {project: os.environ['DOXYGEN_XML']}
breathe_default_members = ('members', 'undoc-members')


def read(path):
    """Returns the text of a page."""
    return path.read_text(encoding='utf-8')


def linked(page):
    """Returns the pages that the sections of a page link, by the titles of the sections."""
    found = {}
    for section in re.split(r'^## ', read(REPOSITORY / page), flags=re.MULTILINE)[1:]:
        targets = [(REPOSITORY / page).parent / link for link in LINK.findall(section)]
        names = [os.path.relpath(target.resolve(), REPOSITORY) for target in targets]
        found[section.partition('\n')[0]] = [name for name in dict.fromkeys(names) if not name.endswith('README')]
    return found


def toctree(title, pages):
    """Returns a part of the table of contents."""
    names = '\n'.join('/' + page for page in pages)
    return f'\n```{{toctree}}\n:hidden:\n:caption: "{title}"\n\n{names}\n```\n'


def pages_in(folder):
    """Returns the pages of a folder."""
    return sorted(os.path.relpath(page, REPOSITORY)[:-len('.md')] for page in REPOSITORY.glob(folder + '/*.md'))


def contents():
    """Returns the table of contents: the pages in the order of docs/README.md."""
    parts = {'Start': ['docs/site/gallery', 'docs/README'], **linked('docs/README.md'),
             'API': ['docs/site/cpp', 'docs/site/python'], 'Research': ['research/README', *pages_in('research/docs')],
             'Project': ['CONTRIBUTING', 'SECURITY', 'CHANGELOG']}
    return ''.join(toctree(title, pages) for title, pages in parts.items())


def experiments():
    """Returns the pages of the experiments of the thesis."""
    return toctree('Experiments', pages_in('research/docs/thesis'))


def try_it():
    """Returns a link to the page without a server, if it is part of the site."""
    if not os.environ.get('BROWSER_PAGE'):
        return ''
    return '\n<a href="../../browser/index.html?source=wasm">Try it: walk a crowd in this browser</a>\n'


def gallery():
    """Returns the link to try it, and the pictures of the README and of docs/ but charts, each with its longest
    description and its page."""
    found = {}
    for page in [REPOSITORY / 'README.md', *sorted(REPOSITORY.glob('docs/*.md'))]:
        for text, picture in PICTURE.findall(read(page)):
            path = os.path.relpath((page.parent / picture).resolve(), REPOSITORY)
            if page.name != 'performance.md' and len(text) > len(found.get(path, ('', ''))[0]):
                found[path] = text, os.path.relpath(page, REPOSITORY)
    figures = (f'```{{figure}} /{path}\n[{text}](/{page})\n```\n' for path, (text, page) in found.items())
    return f'{try_it()}\n````{{container}} gallery\n{"".join(figures)}````\n'


def headers():
    """Returns a section for each public header, with what it declares."""
    parts = {}
    trees = [ElementTree.parse(file) for file in pathlib.Path(os.environ['DOXYGEN_XML']).glob('*crowd*.xml')]
    for compound in (compound for tree in trees for compound in tree.iter('compounddef')):
        scope = compound.findtext('compoundname')
        members = compound.iter('memberdef') if compound.get('kind') == 'namespace' else ()
        declared = [(member, f'{scope}::{member.findtext("name")}') for member in members]
        if compound.get('kind') in ('class', 'struct'):
            declared.append((compound, scope))
        for element, name in declared:
            place = element.find('location')
            line = f'.. doxygen{element.get("kind")}:: {name}\n'
            parts.setdefault(os.path.basename(place.get('file')), []).append((int(place.get('line')), line))
    return ''.join(f'\n{header}\n{"-" * len(header)}\n\n{"".join(line for _, line in sorted(lines))}'
                   for header, lines in sorted(parts.items()))


ADDED = {'README': contents, 'docs/site/cpp': headers, 'docs/site/gallery': gallery,
         'research/docs/thesis': experiments}


def add_text(_app, page, source):
    """Completes the pages that list others."""
    if page in ADDED:
        source[0] += ADDED[page]()


def as_restructured_text(_app, _what, _name, _object, _options, lines):
    """Docstrings are plain text: lines of arguments become items of a list, and words in backticks code."""
    made, in_list = [], False
    for line in (re.sub(r'(?<!`)`([^`]+)`(?!`)', r'``\1``', line) for line in lines):
        is_item = ARGUMENT.match(line) is not None
        if is_item and not in_list:
            made.append('')
        in_list = bool(line) and (is_item or in_list)
        made.append('* ' + line if is_item else '  ' + line.lstrip() if in_list else line)
    lines[:] = made


def setup(app):
    """Called by Sphinx."""
    app.connect('source-read', add_text)
    app.connect('autodoc-process-docstring', as_restructured_text)
