"""research/mutants: the list of mutants fits the present sources and tests."""
import pytest
from crowd_drawing.errors import InputError
from crowd_mutants.mutant_list import check_mutants, mutated, read_mutants


class MutantsTest:
    """The list, and what is wrong with one that does not fit."""

    def test_each_changes_one_place_and_names_a_test(self):
        mutants = read_mutants()
        assert len(mutants) >= 60
        check_mutants(mutants)

    def test_the_change(self):
        mutant = read_mutants()[0]._replace(before='a + b', after='a - b')
        assert mutated(mutant, 'x = a + b;') == 'x = a - b;'
        for text in ('x = a * b;', 'x = a + b; y = a + b;'):
            with pytest.raises(InputError, match='expected once'):
                mutated(mutant, text)

    def test_wrong_lists(self):
        mutant = read_mutants()[0]
        with pytest.raises(InputError, match='several mutants'):
            check_mutants([mutant, mutant])
        with pytest.raises(InputError, match='has no test'):
            check_mutants([mutant._replace(test='SeparationRule.IsNoTest')])
