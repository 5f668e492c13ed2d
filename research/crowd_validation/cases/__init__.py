"""The cases, in the order of the table. A new case is a module with CASE, and a line in ALL."""
from . import (rimea_01, rimea_05, rimea_06, rimea_07, rimea_09, rimea_10, rimea_11, rimea_12, rimea_14, rimea_15)

ALL = (rimea_01.CASE, rimea_05.CASE, rimea_06.CASE, rimea_07.CASE, rimea_09.CASE, rimea_10.CASE, rimea_11.CASE,
       rimea_12.CASE, rimea_14.CASE, rimea_15.CASE)

# Cases of the guideline that are not here, and why.
LEFT_OUT = {
    'rimea_2': 'walking up stairs: the floor is plane',
    'rimea_3': 'walking down stairs: the floor is plane',
    'rimea_4': 'the fundamental diagram is measured by a case of its own',
    'rimea_8': 'a parameter study in a building of several floors',
    'rimea_13': 'fundamental diagram on stairs: the floor is plane',
}
