"""What is a mutant and what is not, on a small source."""
import sys
import unittest

sys.dont_write_bytecode = True
import mutants  # noqa: E402

SOURCE = '''// a < b
#include "a.h"
namespace touchline {
constexpr double most = 3.0;

double held(double x, std::vector<int>& out) {
    if (x > most && out.size() == 2) {
        out.clear();
        x = std::min(x, most);
    }
    const double twice = 2 * x + 1;
    return twice;
}
}  // namespace touchline
'''


class Mutants(unittest.TestCase):
    def found(self):
        return [(m.line, m.operator, m.before, m.after) for m in mutants.mutants_of('a.cpp', SOURCE)]

    def test_every_operator_where_it_is(self):
        self.assertEqual(self.found(), [
            (4, 'constant', '3.0', '0.0'), (4, 'constant', '3.0', '1.0'),
            (6, 'return', 'double held(double x, std::vector<int>& out) {', 'return {};'),
            (7, 'negation', '(x > most && out.size() == 2)', '(!(x > most && out.size() == 2))'),
            (7, 'relation', '>', '>='), (7, 'logic', '&&', '||'), (7, 'equality', '==', '!='),
            (7, 'constant', '2', '0'), (7, 'constant', '2', '1'),
            (8, 'drop', 'out.clear();', ';'),
            (9, 'drop', 'x = std::min(x, most);', ';'), (9, 'extremum', 'std::min(', 'std::max('),
            (11, 'constant', '2', '0'), (11, 'constant', '2', '1'), (11, 'product', '*', '/'), (11, 'sum', '+', '-'),
            (11, 'constant', '1', '0')])

    def test_an_operator_may_end_a_line_and_a_declaration_is_no_statement(self):
        source = 'bool held() {\n    Force force;\n    return is_on() &&\n           is_near(force);\n}\n'
        found = [(m.line, m.before, m.after) for m in mutants.mutants_of('a.cpp', source)]
        self.assertEqual(found, [(1, 'bool held() {', 'return {};'), (3, '&&', '||')])

    def test_one_place_is_changed_and_lines_stay(self):
        for mutant in mutants.mutants_of('a.cpp', SOURCE):
            changed = mutants.applied(mutant, SOURCE).split('\n')
            different = [i + 1 for i, line in enumerate(SOURCE.split('\n')) if changed[i] != line]
            self.assertEqual(different, [mutant.line])
            self.assertEqual(len(changed), SOURCE.count('\n') + 1)

    def test_names_are_of_the_line_not_of_its_number(self):
        names = [m.name for m in mutants.mutants_of('a.cpp', SOURCE)]
        self.assertEqual(len(set(names)), len(names))
        self.assertEqual([m.name for m in mutants.mutants_of('a.cpp', '\n\n' + SOURCE)], names)


unittest.main()
