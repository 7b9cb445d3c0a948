"""A program with all mutants in it does, told to be one of them, what a program with that one alone does."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import mutants  # noqa: E402
import schemata  # noqa: E402

HERE = Path(__file__).resolve().parent
HEADERS = '#include <algorithm>\n#include <cstdio>\n#include <cstdlib>\n'
SOURCE = '''constexpr double most = 3.0;
constexpr int sizes[2] = {2, 5};

bool is_odd(int i) {
    return i % 2 == 1;
}

double felt(int i, double x) {
    double sum = 0.5 * i - x / 3.0 + 1e-1;
    if (i > 2 && x <= most && !is_odd(i)) sum += 2.0;
    if (i == 1 || x >= most && i != 3) {
        sum -= x * x;
        sum *= 0.7;
    } else {
        sum /= 1.0 + (x < 2.0 ? std::max(x, 1.5) : std::min({x, most, 2.5}));
    }
    while (sum > 5.0) sum -= 1.0;
    return sum + sizes[is_odd(i) ? 1 : 0];
}

void tell() {
    for (int i = 0; i < 6; ++i) {
        const bool is_last = i >= 5 || false;
        for (double x = 0.0; x < 5.0; x += 1.0) std::printf("%.9g ", felt(i, x));
        if (is_last) std::printf("end");
    }
}
'''


class Schemata(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.place = Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)
        self.all = mutants.mutants_of('a.cpp', SOURCE)
        self.number_of = {m.name: i + 1 for i, m in enumerate(self.all)}

    def compiled(self, text, *more):
        """What the compiler complains of; the program is `a`."""
        (self.place / 'a.cpp').write_text(HEADERS + text)
        words = ['g++', '-std=c++20', '-w', str(self.place / 'a.cpp'), *more, '-o', str(self.place / 'a')]
        return subprocess.run(words, capture_output=True, text=True).stderr

    def told(self, mutant):
        """Standard output and the way it ended, of half a second at most."""
        words = ['timeout', '0.5', str(self.place / 'a'), str(mutant)]
        run = subprocess.run(words, env={'TOUCHLINE_MUTANT': str(mutant)}, capture_output=True)
        return run.stdout[:2000], run.returncode

    def test_every_mutant_does_what_it_does_alone(self):
        source = schemata.Schemata('a.cpp', SOURCE, self.number_of)
        self.assertTrue(source.leave(2))  # the size of an array stays one
        numbers = [n for m, n in self.number_of.items() if m in source.switched()]
        self.assertGreater(len(numbers), 60)
        switches = [f'-I{HERE.parents[2]}', '-include', str(HERE / 'switches.h'), str(HERE / 'switches.cpp')]
        self.assertEqual(self.compiled(str(source) + 'int main() { tell(); }', *switches), '')
        together = [self.told(n) for n in (0, *numbers)]
        alone = {0: SOURCE, **{n: mutants.applied(self.all[n - 1], SOURCE) for n in numbers}}
        self.assertEqual(self.compiled('\n'.join(
            [*(f'namespace m{n} {{\n{text}}}' for n, text in alone.items()), 'int main(int, char** words) {',
             *(f'if (std::atoi(words[1]) == {n}) m{n}::tell();' for n in alone), '}'])), '')
        self.assertEqual([self.told(n) for n in alone], together)

    def test_lines_stay_where_they_are(self):
        source = schemata.Schemata('a.cpp', SOURCE, self.number_of)
        self.assertEqual(str(source).count('\n'), SOURCE.count('\n'))

    def test_what_is_left_is_as_it_stood(self):
        source = schemata.Schemata('a.cpp', SOURCE, self.number_of)
        for line in range(1, SOURCE.count('\n') + 1):
            source.leave(line)
        self.assertEqual(str(source), SOURCE)
        self.assertEqual(source.switched(), set())


unittest.main()
