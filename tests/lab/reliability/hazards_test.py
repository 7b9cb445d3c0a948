"""How a row of the tables is judged by its tests and figures."""
import sys
import unittest

sys.dont_write_bytecode = True
import hazards  # noqa: E402
import tables  # noqa: E402


def figure(row, name, passed):
    return {'row': row, 'figure': name, 'value': '1', 'bar': '-' if passed == '-' else '1', 'passed': passed}


class Judged(unittest.TestCase):
    def test_evidence_is_tests_and_figures_with_words(self):
        self.assertEqual(hazards.evidence_of('A.Is figure:16:cases of it B.Is'), ['A.Is', 'figure:16:cases of it', 'B.Is'])
        self.assertEqual(hazards.evidence_of('-'), [])

    def test_every_case_of_a_name_counts(self):
        cases = [('All/A.Is/1', 'passed'), ('All/A.Is/2', 'failed'), ('A.IsNot', 'passed')]
        self.assertEqual(hazards.ended('A.Is', cases), 'failed')
        self.assertEqual(hazards.ended('A.IsNot', cases), 'passed')
        self.assertEqual(hazards.ended('B.Is', cases), '')
        of_types = [('A.Is<touchline::One>', 'passed'), ('A.Is<touchline::Other>', 'failed')]  # as ctest names them
        self.assertEqual(hazards.ended('A.Is', of_types), 'failed')
        self.assertEqual(hazards.ended('A.Is', of_types[:1]), 'passed')
        self.assertEqual(hazards.ended('A.Is', [('A/0.Is', 'passed'), ('A/1.Is', 'failed'), ('A/0.IsNot', 'passed')]), 'failed')

    def test_a_row_is_as_good_as_its_worst_evidence(self):
        known = {'A.Is': 'passed', 'B.Is': 'failed'}
        figures = [figure('16', 'cases of it', 'yes')]
        self.assertEqual(hazards.judged(['A.Is', 'figure:16:cases'], known, figures), 'passed')
        self.assertEqual(hazards.judged(['A.Is', 'B.Is'], known, figures), 'failed')
        self.assertEqual(hazards.judged(['A.Is', 'C.Is'], known, figures), 'passed as far as measured')
        self.assertEqual(hazards.judged(['figure:17:cases'], known, figures), 'not measured yet')
        self.assertEqual(hazards.judged([], known, figures), 'not run')

    def test_a_row_without_figures_says_so(self):
        self.assertEqual(tables.end_of([], '0'), 'not measured yet')
        self.assertEqual(tables.end_of([], 'published'), 'not measured yet')
        self.assertEqual(tables.short([]), 'not measured yet')

    def test_a_row_reaches_its_bar_if_all_its_figures_do(self):
        yes, no, told = figure('1', 'a', 'yes'), figure('1', 'b', 'no'), figure('1', 'c', '-')
        self.assertEqual(tables.end_of([yes, no, told], '0'), 'no')
        self.assertEqual(tables.end_of([yes, told], '0'), 'yes')
        self.assertEqual(tables.end_of([told], '0'), 'not measured yet')
        self.assertEqual(tables.end_of([told], 'published'), 'published')
        self.assertEqual(tables.end_of([yes, dict(told, bar='1')], '0'), 'in part')


unittest.main()
