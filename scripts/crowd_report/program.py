"""The program `report`, and the chapters of its pages."""
import pathlib
import tempfile

from crowd_curves.program import default_window, draw_curves, measures_of, read_run
from crowd_drawing.errors import InputError, check_output, replaced
from crowd_drawing.files import DEFAULT_TICK
from crowd_experiments.arguments import add_file, parser_of
from crowd_experiments.pages import Chapter, write_page
from crowd_report.figures import draw_paths, draw_separations, draw_speeds, scenario_of
from crowd_report.tables import (HEADERS, LOG, METRICS, RECORD, ROBOTS, TRAJECTORIES, comparison_rows, metrics_rows,
                                 of_kind, robot_field_rows, robot_rows, source_of)

EXAMPLES = '''examples:
  for table in anticipation human; do mkdir -p $table
      rosrun social_crowd evaluate --q-table $table --episodes 20 \\
      --csv $table/metrics.csv --record $table/record.csv --trajectories $table circle6 place_corner; done
  report anticipation/*.csv human/*.csv --output report.html
  report one=a/metrics.csv other=b/metrics.csv --training one=a/learning.csv other=b/learning.csv --output report.html

The kind of a file is recognised by its header: ''' + '; '.join(program for _, program in HEADERS.values()) + '''.
Files with the same label are runs of the same thing, such as seeds; the default label is the name of the folder.'''


def chapters_of(sources, training, folder):
    """Returns the chapters for which there are files. Figures are written to a folder."""
    groups, records = of_kind(sources, METRICS), of_kind(sources, RECORD)
    metrics, comparison = Chapter('metrics', 'Metrics'), Chapter('comparison', 'Comparison')
    if groups:
        metrics.add_text('Success: people who reach their goals in time. Contact: bodies overlap. Collision: another '
                         'body is within the collision radius. Path and time are ratios to the straight way at full '
                         'speed. With several runs: mean ± half of the 95 % confidence interval (t).')
        metrics.add_table('Metrics of the runs', *metrics_rows(groups))
    if len(records) > 1:
        comparison.add_text(f'Differences from {next(iter(records))}, with 95 % confidence intervals by bootstrap '
                            '(2000 samples with replacement, percentiles). The samples are the means of the runs if a '
                            'label has several, else the means of its episodes.')
        comparison.add_table('Differences', *comparison_rows(records))
    robots = Chapter('robots', 'Robots')
    if robot_groups := of_kind(sources, ROBOTS):
        robots.add_text('Means of the episodes ± half of the 95 % confidence interval (t), without episodes in which a '
                        'number was not measured. docs/metrics.md defines them.')
        robots.add_table('Metrics of robots', *robot_rows(robot_groups))
        robots.add_table('All fields, over all scenarios (units: `score_robots --fields`)',
                         *robot_field_rows(robot_groups))
    learning = Chapter('learning', 'Learning curves')
    for kind in dict.fromkeys(source.kind for source in training):  # logs and records have other columns
        runs = [read_run(source.label, source.file) for source in training if source.kind == kind]
        window = default_window(runs)
        learning.add_figure(draw_curves(folder / f'curves_{kind}.png', runs, measures_of(runs), window),
                            f'Means over {window} episodes and over the runs, with 95 % confidence bands (t).')
    paths, crowding = Chapter('paths', 'Paths'), Chapter('crowding', 'Separation, and speed against density')
    add_walking(paths, crowding, of_kind(sources, TRAJECTORIES), folder)
    return [chapter for chapter in (metrics, robots, comparison, learning, paths, crowding) if chapter.parts]


def add_walking(paths, crowding, groups, folder):
    """Adds paths, separations, and speeds at densities."""
    files = [source.file for sources in groups.values() for source in sources]
    for scenario in dict.fromkeys(file.stem for file in files):
        chosen = {label: [source for source in sources if source.file.stem == scenario]
                  for label, sources in groups.items()}
        chosen = {label: sources for label, sources in chosen.items() if sources}
        unknown = [str(source.file) for sources in chosen.values() for source in sources
                   if scenario_of(source.file) is None]
        note = f" Scenario unknown, a tick of {DEFAULT_TICK} s assumed: {', '.join(unknown)}." if unknown else ''
        name = f'{scenario}.png'
        paths.add_figure(draw_paths(folder / f'paths_{name}', chosen),
                         f'{scenario}: paths of the first episode; circles: ends.{note}')
        crowding.add_figure(draw_separations(folder / f'separation_{name}', chosen),
                            f'{scenario}: distance from each person to the nearest other one, every 0.5 s.{note}')
        crowding.add_figure(
            draw_speeds(folder / f'speed_{name}', chosen), f'{scenario}: speed over one second against the number of '
            'people within 2 m, including the person, divided by the area. Bars: standard deviation; at least 20 '
            f'values each.{note}')


def write_report(output, title, sources, training):
    """Writes the page; it appears when it is complete. Raises InputError, OSError."""
    with replaced(output) as part, tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        chapters = chapters_of(sources, training, pathlib.Path(folder))
        labels = dict.fromkeys(source.label for source in [*sources, *training])
        write_page(part, title, None, chapters, f"{len(sources) + len(training)} files of {', '.join(labels)}.")


def main(words=None):
    parser = parser_of('report',
                       'Writes a page with the results of runs, which needs no other file: metrics, robots, '
                       'comparison, learning curves, paths, separation, speed against density.', EXAMPLES)
    parser.add_argument('files', nargs='*', metavar='[LABEL=]CSV', help='results of `evaluate`, see below')
    parser.add_argument('--training', nargs='+', default=[], metavar='[LABEL=]CSV',
                        help='logs or records of `train`')
    add_file(parser, '--output', required=True, metavar='FILE.html', help='the page')
    parser.add_argument('--title', default='Crowd report', help='title of the page (default: %(default)s)')
    arguments = parser.parse_args(words)
    if not (arguments.files or arguments.training):
        parser.error('expected at least one file')
    if arguments.output.suffix.lower() not in ('.html', '.htm'):
        parser.error(f"--output: expected FILE.html, got '{arguments.output}'")
    check_output(arguments.output)
    sources, training = ([source_of(word) for word in words] for words in (arguments.files, arguments.training))
    for source in training:
        if source.kind not in (LOG, RECORD):
            raise InputError(f'{source.file}: --training: expected a record or log of `train`, with the header '
                             f'{HEADERS[RECORD][0]}... or {HEADERS[LOG][0]}...')
    training += [source for source in sources if source.kind == LOG]
    write_report(arguments.output, arguments.title, [source for source in sources if source.kind != LOG], training)
    print(f'{arguments.output}: {arguments.output.stat().st_size / 1e6:.1f} MB')
