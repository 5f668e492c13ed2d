"""The program `occlusion_time`: processor time of decisions with and without occlusion (thesis, 5.2)."""
import pathlib
import resource
import tempfile

import numpy
import yaml
from crowd_drawing.errors import read_documents
from crowd_experiments.arguments import add_tools, parser_of, positive
from crowd_experiments.records import read_csv
from crowd_experiments.runs import output_of
from crowd_experiments.tools import find_config, find_tools

RADII = 1.0, 3.0, 6.0  # [m], of vision
SCENARIOS = {'circle12_varied': 10, 'crowd_circle_200': 1}  # with numbers of episodes
LEARNED = 300  # episodes
EXAMPLE = '''example:
  research/occlusion_time

For each radius of vision one agent learns with state set 2 of the thesis. Crowds then walk with its table, with and
without occlusion in turn. Prints a row for each crowd: processor time of a tick divided by its decisions [us],
and the ratio; medians of all rounds.'''


def main(words=None):
    parser = parser_of('occlusion_time', 'Measures the time of decisions with and without occlusion.', EXAMPLE)
    parser.add_argument('--rounds', type=positive, default=5, help='number of repetitions (default: %(default)s)')
    add_tools(parser)
    arguments = parser.parse_args(words)
    tools = find_tools(arguments.tools)
    print('| radius of vision [m] | crowd | without | with occlusion | ratio |\n|---|---|---|---|---|')
    with tempfile.TemporaryDirectory() as folder:
        for radius in RADII:
            files = learn(tools, pathlib.Path(folder), radius)
            for scenario, episodes in SCENARIOS.items():
                times = numpy.array([[time_of(tools, files, occludes, scenario, episodes) for occludes in (False, True)]
                                     for _ in range(arguments.rounds)])
                ratio = numpy.median(times[:, 1] / times[:, 0])
                print(f'| {radius:g} | {scenario} | {" | ".join(f"{one:.2f}" for one in numpy.median(times, axis=0))} '
                      f'| {ratio:.2f} |', flush=True)


def learn(tools, folder, radius):
    """Returns a Q-table, and the configurations without and with occlusion."""
    config = read_documents(find_config() / 'learning' / 'thesis_occupancy.yaml')[0]
    config['state_set']['vision_radius'] = radius
    config['training']['scenarios'] = [str(find_config() / 'scenarios' / 'single_obstacle.yaml')]
    configs = []
    for occludes in (False, True):
        configs.append(folder / f'{radius}_{occludes}.yaml')
        configs[-1].write_text(yaml.safe_dump({**config, 'vision': {'occlusion': occludes}}), encoding='utf-8')
    table = folder / f'{radius}.txt'
    output_of([tools / 'train', configs[0], '--output', table, '--episodes', LEARNED])
    return table, configs


def time_of(tools, files, occludes, scenario, episodes):
    """Returns the processor time of a decision [us]."""
    table, configs = files
    record = table.with_suffix('.csv')
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    output_of([tools / 'evaluate', '--q-table', table, '--config', configs[occludes], '--threads', 1, '--episodes',
               episodes, '--record', record, find_config() / 'scenarios' / f'{scenario}.yaml'])
    taken = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return 1e6 * taken / sum(read_csv(record)['ticks'])
