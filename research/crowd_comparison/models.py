"""The compared models, with their names and colours in all tables and figures."""
THESIS_MODELS = ('thesis_nearest', 'thesis_occupancy')
OURS = 'anticipation'
LEARNED = (*THESIS_MODELS, OURS)
REFERENCES = ('orca_best', 'orca_fixed', 'social_force')
ORCA = 'orca_best'  # reference for times

NAMES = {'thesis_nearest': 'thesis set 1', 'thesis_occupancy': 'thesis set 2', 'anticipation': 'anticipation',
         'orca_best': 'ORCA, best', 'orca_fixed': 'ORCA, fixed', 'social_force': 'social force'}
COLOURS = {'thesis_nearest': '#009e73', 'thesis_occupancy': '#8e5ea2', 'anticipation': '#d55e00',
           'orca_best': '#0072b2', 'orca_fixed': '#56b4e9', 'social_force': '0.45'}
