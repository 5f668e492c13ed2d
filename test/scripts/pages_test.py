"""All pages: their links lead somewhere, they are short, the index has them, the code names existing ones only, and the
columns of CSV files are those of the pages."""
import os
import pathlib
import re
import shutil
import subprocess

import pytest
from crowd_drawing.errors import InputError
from crowd_generated.program import main as generate
from programs import ANTICIPATION_TABLE, PACKAGE, in_package, page_examples, page_text, read_text, tools_folder

LONGEST = 250  # [lines] of a page in docs/
LONGEST_OF = {'architecture.md': 100}  # [lines]
DOCS = sorted(pathlib.Path(in_package('docs')).glob('*.md'))
PAGES = [*sorted(pathlib.Path(PACKAGE).glob('*.md')), *DOCS,
         *sorted(pathlib.Path(in_package('research')).rglob('*.md'))]
# Folders and files with texts that name pages.
NAMING = ('CHANGELOG.rst', 'CMakeLists.txt', 'package.xml', 'bench', 'config', 'include', 'launch', 'msg', 'python',
          'research', 'rviz', 'scripts', 'src', 'srv', 'test')
WITH_ROBOT = '''
name: short
duration: 1
goal_tolerance: 0.3
agents:
  - {position: [1, 1], goal: [3, 1], speed: 0.5, radius: 0.25}
robots:
  - {name: robot, position: [1, 3], goal: [3, 3], radius: 0.25, max_speed: 0.5}
'''
FENCED = re.compile(r'^( *)```.*?^\1```$', re.DOTALL | re.MULTILINE)
INLINE = re.compile(r'`[^`\n]+`')
LINK = re.compile(r'\]\(([^)\s]+)\)')
# A path from the package's folder, which may have an asterisk.
PATH = re.compile(r'`((?:bench|config|docs|include|launch|msg|python|research|rviz|scripts|src|srv|test)/[\w./*-]+)`')
# A page, and the quoted titles of its sections behind it, also in a comment of several lines.
NAMED = re.compile(r'(?:[\w.]+/)*docs/\w+\.md(?:#[\w-]+)?(?:,[\s/#*]+"[^"\n]+")*')


def text_of(page):
    """Returns the text of a page without blocks of code."""
    return FENCED.sub('', read_text(page))


def titles(page):
    """Returns the titles of the sections of a page, as they are shown."""
    found = re.findall(r'^#+ (.*?)\s*$', text_of(page), re.MULTILINE)
    return [re.sub(r'\[([^]]*)\]\([^)]*\)', r'\1', title).replace('`', '') for title in found]


def anchors(page):
    """Returns the anchors of a page, as GitHub makes them."""
    found = []
    for title in titles(page):
        anchor = re.sub(r'[^\w\- ]', '', title.lower()).replace(' ', '-')
        same = sum(known == anchor or re.fullmatch(f'{re.escape(anchor)}-\\d+', known) is not None for known in found)
        found.append(f'{anchor}-{same}' if same else anchor)
    return found


def problem_of(page, target):
    """Returns what is wrong with a link on a page, or None."""
    file, _, anchor = target.partition('#')
    linked = (page.parent / file).resolve() if file else page
    if not linked.exists():
        return f'{page}: {target}: there is no such file'
    if anchor and anchor not in anchors(linked):
        return f'{page}: {target}: there is no such section; sections are {", ".join(anchors(linked))}'
    return None


def texts_that_name_pages():
    """Returns {file: text} of the source files that name a page in docs/."""
    done = subprocess.run(['grep', '-rIlE', '--exclude=*.md', '--exclude-dir=data', r'docs/\w+\.md', *NAMING],
                          cwd=PACKAGE, stdout=subprocess.PIPE, check=True)
    files = [pathlib.Path(PACKAGE, name) for name in done.stdout.decode().splitlines()]
    return {file: read_text(file) for file in files if file != pathlib.Path(__file__).resolve()}


class LinksTest:
    """Links between pages, and names of pages elsewhere."""

    @pytest.mark.parametrize('page', PAGES, ids=lambda page: os.path.relpath(page, PACKAGE))
    def test_links(self, page):
        targets = [target for target in LINK.findall(INLINE.sub('', text_of(page))) if '://' not in target]
        assert [problem for problem in (problem_of(page, target) for target in targets) if problem] == []

    @pytest.mark.parametrize('page', PAGES, ids=lambda page: os.path.relpath(page, PACKAGE))
    def test_paths(self, page):
        """Files and folders of the package that a page names, such as `src/learning/states/`, exist."""
        named = [path.rstrip('/') for path in PATH.findall(text_of(page)) if 'NAME' not in path]
        assert [path for path in named if not list(pathlib.Path(PACKAGE).glob(path))] == []

    def test_anchors(self, tmp_path):
        """As GitHub makes them."""
        page = tmp_path / 'page.md'
        text = '# `some_node`, and more\n## Up to 2 m/s\n```\n# no title\n```\n## Up to 2 m/s\n'
        page.write_text(text, encoding='utf-8')
        assert anchors(page) == ['some_node-and-more', 'up-to-2-ms', 'up-to-2-ms-1']

    def test_pages_that_texts_name(self):
        """In comments, messages and --help: `docs/PAGE.md`, `docs/PAGE.md#ANCHOR`, or `docs/PAGE.md, "Section"`."""
        texts = texts_that_name_pages()
        assert len(texts) > 20
        problems = []
        for file, text in texts.items():
            for named in NAMED.findall(text):
                page, *sections = re.split(r',[\s/#*]+(?=")', named)
                problem = problem_of(pathlib.Path(PACKAGE, 'README.md'), page)
                if not problem:
                    of_page = titles(pathlib.Path(PACKAGE, page.partition('#')[0]))
                    problem = [section for section in sections if section.strip('"') not in of_page]
                if problem:
                    problems.append(f'{os.path.relpath(file, PACKAGE)}: {named}: {problem}')
        assert problems == []


class PagesTest:
    """Pages in docs/."""

    @pytest.mark.parametrize('page', DOCS, ids=lambda page: page.name)
    def test_pages_are_short(self, page):
        assert len(read_text(page).splitlines()) <= LONGEST_OF.get(page.name, LONGEST)

    def test_the_index_has_all_pages(self):
        linked = LINK.findall(read_text(in_package('docs', 'README.md')))
        assert sorted(page.name for page in DOCS if page.name != 'README.md') == sorted(set(
            target for target in linked if '/' not in target))


def columns_of(file):
    """Returns the names of the columns of a CSV file."""
    return read_text(file).splitlines()[0].split(',')


def documented_columns(page, title):
    """Returns the names in the first column of the first table with this title on a page."""
    table = re.search(rf'^\| {title} \|.*\n\|[-| ]*\n((?:\|.*\n)+)', page, re.MULTILINE)[1]
    return [name for line in table.splitlines() for name in re.findall(r'`(\w+)`', line.split('|')[1])]


class TypesTableTest:
    """The table of state sets, action sets and rewards."""

    def test_it_is_that_of_the_program(self):
        generate(['types', '--check', '--tools', tools_folder()])

    def test_an_old_one(self, tmp_path):
        page = tmp_path / 'docs' / 'state_sets.md'
        page.parent.mkdir()
        page.write_text(page_text('state_sets.md').replace('| `occupancy` |', '| `old` |', 1), encoding='utf-8')
        words = ['types', '--package', str(tmp_path), '--tools', tools_folder()]
        with pytest.raises(InputError, match='scripts/generate types'):
            generate([*words, '--check'])
        generate(words)
        assert read_text(page) == page_text('state_sets.md')

    def test_a_page_without_the_table(self, tmp_path):
        page = tmp_path / 'docs' / 'state_sets.md'
        page.parent.mkdir()
        page.write_text(page_text('state_sets.md').replace('<!-- types -->', ''), encoding='utf-8')
        with pytest.raises(InputError, match='has 0 tables'):
            generate(['types', '--check', '--package', str(tmp_path), '--tools', tools_folder()])


class ColumnsTest:
    """Columns of CSV files are those of the pages."""

    def test_robots(self, runner):
        file = runner.path('robots.csv')
        scenario = runner.write('short.yaml', WITH_ROBOT)
        runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--robots-csv', file, scenario)
        columns = columns_of(file)
        assert columns[:3] == ['episode', 'scenario', 'robot']
        fields = runner.tool('score_robots', '--fields').splitlines()[1:]
        assert columns[3:] == [line.split(',')[0] for line in fields]

    def test_what_fields_of_results_say(self):
        """Lists, messages and docs/metrics.md are those of scripts/generate."""
        generate(['metrics', '--check'])

    def test_another_field(self, tmp_path):
        """A new field of a robot's result gets its place in all files; one that is no longer there leaves them."""
        for folder in ('include', 'msg', 'docs'):
            shutil.copytree(in_package(folder), tmp_path / folder)
        header = tmp_path / 'include' / 'social_crowd' / 'robot_result.h'
        text = header.read_text(encoding='utf-8')
        new = '  double mean_noise = NONE;  ///< of the robot, above |\n         ///< silence [dB]\n'
        text = re.sub(r'.*double max_jerk .*\n', '', text)
        text = re.sub(r'(  double path_length = 0.0;.*\n)', rf'\1{new}', text)
        header.write_text(text, encoding='utf-8')
        generate(['metrics', '--package', str(tmp_path)])
        visits = '    visit(MetricName{"path_length", "m"}, results.path_length...);\n'
        assert visits + visits.replace('path_length', 'mean_noise').replace('"m"', '"dB"') in read_text(header)
        message = read_text(tmp_path / 'msg' / 'RobotResult.msg').splitlines()
        place = message.index('float64 path_length                     # [m]')
        assert message[place + 1] == 'float64 mean_noise                      # of the robot, above | silence [dB]'
        page = read_text(tmp_path / 'docs' / 'metrics.md')
        assert '| `path_length` | m | F: PL; H; S: total path length | sum of the steps |\n' \
            '| `mean_noise` | dB | | of the robot, above \\| silence |\n' in page
        assert '| `min_jerk`, `avg_jerk` | m/s^3 |' in page
        assert 'max_jerk' not in read_text(header) + page + '\n'.join(message)

    @pytest.mark.parametrize('file, old, new, error', [
        ('include/social_crowd/robot_result.h', 'double path_length', 'int path_length', 'its type is int'),
        ('include/social_crowd/results.h', 'struct AgentResult', 'struct Result', 'AgentResult: expected this struct'),
        ('msg/AgentResult.msg', '# walked', 'walked', 'expected a type, a name and a comment'),
    ])
    def test_a_field_that_cannot_be_written(self, tmp_path, file, old, new, error):
        for folder in ('include', 'msg', 'docs'):
            shutil.copytree(in_package(folder), tmp_path / folder)
        text = read_text(tmp_path / file)
        assert old in text
        (tmp_path / file).write_text(text.replace(old, new, 1), encoding='utf-8')
        with pytest.raises(InputError, match=error):
            generate(['metrics', '--package', str(tmp_path)])

    def test_goals_and_ticks_of_robots(self, runner):
        goals, series = runner.path('goals.csv'), runner.path('series')
        scenario = runner.write('short.yaml', WITH_ROBOT)
        runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--robot-goals', goals, '--robot-series', series,
                    scenario)
        message = re.findall(r'^\w+ (\w+) +# ', read_text(in_package('msg', 'RobotGoalResult.msg')), re.MULTILINE)
        assert columns_of(goals) == ['episode', 'scenario', 'robot', 'goal', *message]
        page = page_text('metrics.md')
        section = page.partition('\n## Goals of a tour\n')[2]
        assert documented_columns(section, 'column') == message
        section = page.partition('\n## Each tick\n')[2].partition('\n## ')[0]
        forces = [line.split('`')[1] for line in page.partition('\n## Forces\n')[2].split('\n## ')[0].splitlines()
                  if line.startswith('| `')]
        named = re.findall(r'`(\w+)`', section.partition('Columns are')[2].partition('five forces')[0])
        assert [*(name for name in named if name != 'nan'), *forces] == columns_of(os.path.join(series, 'short.csv'))

    def test_logs_and_records(self, runner):
        config = runner.write('least.yaml', page_examples('learning.md')['least.yaml'])
        runner.tool('train', config, '--episodes', 1, '--output', runner.path('table.txt'),
                    '--log', runner.path('log.csv'), '--record', runner.path('record.csv'))
        for name, title in (('log.csv', 'Logs'), ('record.csv', 'Records')):
            section = page_text('train.md').partition(f'\n## {title}\n')[2]
            assert documented_columns(section, 'column') == columns_of(runner.path(name))
