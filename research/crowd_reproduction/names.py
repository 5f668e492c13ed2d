"""Names and colours of the rewards and parameters in the figures and tables of the thesis's experiments."""
REWARD_COLOURS = {'distance_gained': '#0072b2', 'cosine_cubed': '#d55e00'}
REWARD_NAMES = {'distance_gained': 'distance gained', 'cosine_cubed': 'cos³'}
PARAMETER_NAMES = {'thesis': "thesis's parameters", 'better': 'better parameters'}
THESIS_MARK = dict(marker='D', color='black', linestyle='', markersize=7, zorder=6)
