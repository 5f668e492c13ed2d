"""The chapters of a report."""
from crowd_curves.drawing import draw_curves, measures_of
from crowd_curves.records import default_window, read_run
from crowd_drawing.files import DEFAULT_TICK
from crowd_experiments.pages import Chapter
from crowd_report.figures import draw_paths, draw_separations, draw_speeds, scenario_of
from crowd_report.tables import METRICS, RECORD, TRAJECTORIES, comparison_rows, metrics_rows, of_kind


def chapters_of(sources, training, folder):
    """Returns the chapters for which there are files. Figures are written to a folder."""
    made = [metrics_chapter(of_kind(sources, METRICS)), comparison_chapter(of_kind(sources, RECORD)),
            learning_chapter(training, folder), *walking_chapters(of_kind(sources, TRAJECTORIES), folder)]
    return [chapter for chapter in made if chapter is not None]


def metrics_chapter(groups):
    """Returns the table of metrics."""
    if not groups:
        return None
    chapter = Chapter('metrics', 'Metrics')
    chapter.add_text('Success: people who reach their goals in time. Contact: bodies overlap. Collision: another body '
                     'is within the collision radius. Path and time are ratios to the straight way at full speed. With '
                     'several runs: mean ± half of the 95 % confidence interval (t).')
    chapter.add_table('Metrics of the runs', *metrics_rows(groups))
    return chapter


def comparison_chapter(groups):
    """Returns the comparison of all labels with the first one."""
    if len(groups) < 2:
        return None
    chapter = Chapter('comparison', 'Comparison')
    chapter.add_text(f'Differences from {next(iter(groups))}, with 95 % confidence intervals by bootstrap (2000 '
                     'samples with replacement, percentiles). The samples are the means of the runs if a label has '
                     'several, else the means of its episodes.')
    chapter.add_table('Differences', *comparison_rows(groups))
    return chapter


def learning_chapter(training, folder):
    """Returns the learning curves."""
    if not training:
        return None
    chapter = Chapter('learning', 'Learning curves')
    for kind in dict.fromkeys(source.kind for source in training):  # logs and records have other columns
        runs = [read_run(source.label, source.file) for source in training if source.kind == kind]
        window = default_window(runs)
        file = draw_curves(folder / f'curves_{kind}.png', runs, measures_of(runs), window)
        chapter.add_figure(file, f'Means over {window} episodes and over the runs, with 95 % confidence bands (t).')
    return chapter


def walking_chapters(groups, folder):
    """Returns paths, separations, and speeds at densities."""
    if not groups:
        return []
    paths, crowding = Chapter('paths', 'Paths'), Chapter('crowding', 'Separation, and speed against density')
    files = [source.file for sources in groups.values() for source in sources]
    for scenario in dict.fromkeys(file.stem for file in files):
        chosen = {label: [source for source in sources if source.file.stem == scenario]
                  for label, sources in groups.items()}
        chosen = {label: sources for label, sources in chosen.items() if sources}
        name, note = f'{scenario}.png', note_of(source.file for sources in chosen.values() for source in sources)
        add(paths, draw_paths(folder / f'paths_{name}', chosen),
            f'{scenario}: paths of the first episode; circles: ends.{note}')
        add(crowding, draw_separations(folder / f'separation_{name}', chosen),
            f'{scenario}: distance from each person to the nearest other one, every 0.5 s.{note}')
        add(crowding, draw_speeds(folder / f'speed_{name}', chosen),
            f'{scenario}: speed over one second against the number of people within 2 m, including the person, divided '
            f'by the area. Bars: standard deviation; at least 20 values each.{note}')
    return [paths, *([crowding] if crowding.parts else [])]


def note_of(files):
    """Returns the part of a caption that says which files of trajectories have no known scenario."""
    unknown = [str(file) for file in files if scenario_of(file) is None]
    return f" Scenario unknown, a tick of {DEFAULT_TICK} s assumed: {', '.join(unknown)}." if unknown else ''


def add(chapter, file, caption):
    """Adds a figure, if there is one."""
    if file is not None:
        chapter.add_figure(file, caption)
