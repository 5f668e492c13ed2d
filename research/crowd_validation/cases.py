"""The cases, in the order of the table. A new case is a function of an Evaluation that returns a Result, and a line in
ALL."""
from .crowds import rimea_9, rimea_10, rimea_11, rimea_12, rimea_14, rimea_15
from .evaluation import Case
from .movement import rimea_1, rimea_5, rimea_6, rimea_7

ALL = (
    Case('rimea_1', 'Walking speed in a corridor', rimea_1),
    Case('rimea_5', 'Reaction times', rimea_5),
    Case('rimea_6', 'Movement around a corner', rimea_6),
    Case('rimea_7', 'Walking speeds by age', rimea_7),
    Case('rimea_9', 'A crowd leaves a large room', rimea_9),
    Case('rimea_10', 'Assigned exits', rimea_10),
    Case('rimea_11', 'Choice of the exit', rimea_11),
    Case('rimea_12', 'Two bottlenecks in a row', rimea_12),
    Case('rimea_14', 'A short and a long way', rimea_14),
    Case('rimea_15', 'A large crowd around a corner', rimea_15),
)

# Cases of the guideline that are not here, and why.
LEFT_OUT = {
    'rimea_2': 'walking up stairs: the floor is plane',
    'rimea_3': 'walking down stairs: the floor is plane',
    'rimea_4': 'the fundamental diagram is measured by a case of its own',
    'rimea_8': 'a parameter study in a building of several floors',
    'rimea_13': 'fundamental diagram on stairs: the floor is plane',
}
