"""The program `report`."""
import os
import pathlib
import tempfile

from crowd_drawing.errors import InputError, check_output
from crowd_experiments.arguments import add_file, parser_of
from crowd_experiments.pages import write_page
from crowd_report.chapters import chapters_of
from crowd_report.tables import HEADERS, LOG, RECORD, source_of

EXAMPLES = '''examples:
  for table in anticipation human; do mkdir -p $table
      rosrun social_crowd evaluate --q-table config/q_tables/$table.txt --episodes 20 \\
      --csv $table/metrics.csv --record $table/record.csv --trajectories $table circle6 place_corner; done
  report anticipation/*.csv human/*.csv --output report.html
  report one=a/metrics.csv other=b/metrics.csv --training one=a/learning.csv other=b/learning.csv --output report.html

The kind of a file is recognised by its header: ''' + '; '.join(program for _, program in HEADERS.values()) + '''.
Files with the same label are runs of the same thing, such as seeds; the default label is the name of the folder.
Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def parser():
    """Returns the parser of the command line."""
    result = parser_of('report',
                       'Writes a page with the results of runs, which needs no other file: metrics, comparison, '
                       'learning curves, paths, separation, speed against density.', EXAMPLES)
    result.add_argument('files', nargs='*', metavar='[LABEL=]CSV', help='results of `evaluate`, see below')
    result.add_argument('--training', nargs='+', default=[], metavar='[LABEL=]CSV',
                        help='logs or records of `train`')
    add_file(result, '--output', required=True, metavar='FILE.html', help='the page')
    result.add_argument('--title', default='Crowd report', help='title of the page (default: %(default)s)')
    return result


def write_report(output, title, sources, training):
    """Writes the page; it appears when it is complete. Raises InputError, OSError."""
    part = output.with_name(f'.{output.name}.part')
    try:
        with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
            chapters = chapters_of(sources, training, pathlib.Path(folder))
            labels = dict.fromkeys(source.label for source in [*sources, *training])
            write_page(part, title, None, chapters, f"{len(sources) + len(training)} files of {', '.join(labels)}.")
        os.replace(part, output)
    finally:
        part.unlink(missing_ok=True)


def main(words=None):
    """Runs the program with command line words."""
    checked = parser()
    arguments = checked.parse_args(words)
    if not (arguments.files or arguments.training):
        checked.error('expected at least one file')
    if arguments.output.suffix.lower() not in ('.html', '.htm'):
        checked.error(f"--output: expected FILE.html, got '{arguments.output}'")
    check_output(arguments.output)
    sources, training = ([source_of(word) for word in words] for words in (arguments.files, arguments.training))
    for source in training:
        if source.kind not in (LOG, RECORD):
            raise InputError(f'{source.file}: --training: expected a record or log of `train`, with the header '
                             f'{HEADERS[RECORD][0]}... or {HEADERS[LOG][0]}...')
    training += [source for source in sources if source.kind == LOG]
    write_report(arguments.output, arguments.title, [source for source in sources if source.kind != LOG], training)
    print(f'{arguments.output}: {arguments.output.stat().st_size / 1e6:.1f} MB')
