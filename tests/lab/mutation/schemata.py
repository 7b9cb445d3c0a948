"""All mutants of a source in one text, each chosen while the program runs (switches.h). Lines stay where they are.

Most need no operand to be found: an operator becomes two with an object between, a condition or a number is
wrapped. Only what && and || join is looked for, for the right side must not be computed in vain. Constants
become variables. What a compiler does not take in that form is left as it stood, line by line (`without`).
"""
import re
from dataclasses import dataclass

import mutants

# The replacement of an operator: the sign on both sides of an object of this name.
OBJECTS = {
    '<': ('<', 'Less', '>'), '<=': ('<', 'LessOrEqual', '>'), '>': ('<', 'Greater', '>'), '>=': ('<', 'GreaterOrEqual', '>'),
    '==': ('==', 'Equal', '=='), '!=': ('==', 'Unequal', '=='), '+': ('+', 'Plus', '+'), '-': ('+', 'Minus', '+'),
    '*': ('*', 'Times', '*'), '/': ('*', 'Over', '*'), '+=': ('+=', 'Add', '+='), '-=': ('-=', 'Subtract', '-='),
    '*=': ('*=', 'Multiply', '*='), '/=': ('/=', 'Divide', '/='),
}
# The end of what && and || join: every operator that binds less, and every enclosing bracket.
LOOSER = re.compile(r'[;,?}]| : | [-+*/|&^%]?= |\breturn\b|&&|\|\|')
OPEN, CLOSE = '([{', ')]}'


@dataclass(frozen=True)
class Edit:
    """`begin` to `end` of the text get these around, or, where `inside` is text, that in their place."""
    begin: int
    end: int
    before: str
    after: str = ''
    inside: str | None = None
    names: tuple = ()  # of the mutants that it makes
    depth: int = 1     # of two around the same text the outer one has the smaller


def without_inside_brackets(code, begin, end):
    """The same length, with everything within brackets blanked."""
    depth, out = 0, []
    for sign in code[begin:end]:
        depth -= sign in CLOSE
        out.append(' ' if depth > 0 else sign)
        depth += sign in OPEN
    return ''.join(out)


def surrounding(code, at):
    """(begin, end) of what stands within the nearest brackets around `at`."""
    depth, begin = 0, at
    while begin > 0 and depth >= 0:
        begin -= 1
        depth += (code[begin] in CLOSE) - (code[begin] in OPEN)
    depth, end = 0, at
    while end < len(code) and depth >= 0:
        depth += (code[end] in OPEN) - (code[end] in CLOSE)
        end += 1
    return begin + 1, end - 1


def operands(code, at, sign):
    """[(begin, end)] of all that are joined with the one before `at` by this sign, && or ||."""
    outer_begin, outer_end = surrounding(code, at)
    flat = without_inside_brackets(code, outer_begin, outer_end)
    cuts, chain = [0], []
    for found in LOOSER.finditer(flat):
        word = found.group(0)
        if word == sign or (word == '&&' and sign == '||'):
            if word == sign:
                chain.append(outer_begin + found.start())
            continue
        if outer_begin + found.start() > at:
            cuts.append(found.start())
            break
        cuts, chain = [found.end()], []
    else:
        cuts.append(len(flat))
    bounds = [outer_begin + cuts[0], *[c for here in chain for c in (here, here + 2)], outer_begin + cuts[1]]
    spans = []
    for begin, end in zip(bounds[::2], bounds[1::2]):
        part = code[begin:end]
        begin += len(part) - len(part.lstrip())
        spans.append((begin, begin + len(part.strip())))
    return spans


def constants(code):
    """Edits that make variables and functions of what the compiler would compute; names are none."""
    for found in re.finditer(r'\b(?:(inline|static) )?constexpr ', code):
        if code[:found.start()].endswith('if '):
            continue
        head = re.match(r'[^;={(]*', code[found.end():]).group(0)
        at = found.end() + len(head)
        if re.search(r'\boperator\b', head) or code[at] == '(':
            brace, semicolon = code.find('{', at), code.find(';', at)
            end = mutants.closing(code, brace, '{}') if 0 <= brace < semicolon else semicolon
            word = f'{found.group(1)} ' if found.group(1) else 'inline '
        else:
            end = code.find(';', at)
            word = {'inline': 'inline const ', 'static': 'static inline const ', None: 'const '}[found.group(1)]
        yield Edit(found.start(), found.end(), '', inside=word), (found.start(), end)


def edits_of(code, here, number_of):
    """All edits of one file: `here` are its mutants, `number_of` the number of each by its name."""
    of_numbers, of_chains = {}, {}
    for m in here:
        n = number_of[m.name]
        if m.operator == 'logic':
            spans = tuple(operands(code, m.begin, m.before))
            of_chains.setdefault((spans, m.before), []).append(m)
        elif m.operator == 'constant' and m.before[0].isdigit():
            if code[m.end] == '>':  # an argument of a template: everything of that type would fail
                continue
            of_numbers.setdefault((m.begin, m.end), []).append(m)
        elif m.operator == 'constant':
            yield Edit(m.begin, m.end, f'mutation::truth({n}, ', ')', names=(m.name,), depth=2)
        elif m.operator == 'negation':
            yield Edit(m.begin + 1, m.end - 1, f'mutation::on({n}) != bool(', ')', names=(m.name,), depth=0)
        elif m.operator == 'drop':
            yield Edit(m.begin, m.end, f'if (!mutation::on({n})) ', names=(m.name,))
        elif m.operator == 'return':
            yield Edit(m.begin, m.end, f' if (mutation::on({n})) {m.after}', names=(m.name,))
        elif m.operator == 'extremum':
            is_least = 'true' if m.before == 'std::min(' else 'false'
            yield Edit(m.begin, m.end, '', inside=f'mutation::Extremum<{is_least}>{{{n}}}(', names=(m.name,))
        else:
            opening, name, closing = OBJECTS[m.before]
            yield Edit(m.begin, m.end, '', inside=f'{opening} mutation::{name}{{{n}}} {closing}', names=(m.name,))
    for (begin, end), some in of_numbers.items():
        by_value = {float(m.after): number_of[m.name] for m in some}
        yield Edit(begin, end, f'mutation::number({by_value.get(0.0, 0)}, {by_value.get(1.0, 0)}, ', ')',
                   names=tuple(m.name for m in some), depth=2)
    for (spans, sign), some in of_chains.items():
        numbers = ', '.join(str(number_of[m.name]) for m in sorted(some, key=lambda m: m.begin))
        yield Edit(spans[0][0], spans[-1][1], f'mutation::chain<{"true" if sign == "||" else "false"}, {numbers}>(', ')',
                   inside=tuple((*span, next((m.begin for m in some if m.begin >= span[1]), None)) for span in spans),
                   names=tuple(m.name for m in some))


class Schemata:
    """One file with its switches."""

    def __init__(self, path, text, number_of):
        self.path, self.text, self.code = path, text, mutants.masked(text)
        here = [m for m in mutants.mutants_of(path, text)]
        self.edits = list(edits_of(self.code, here, number_of))
        self.extents = dict(constants(self.code))
        self.edits += self.extents

    def line(self, edit):
        return self.text.count('\n', 0, edit.begin) + 1

    def leave(self, line):
        """True if something on that line, or in the constant or the type that begins there, is now left as it stood."""
        gone = {e for e in self.edits if self.line(e) == line}
        for constant, (begin, end) in self.extents.items():
            if constant in gone:
                gone |= {e for e in self.edits if begin <= e.begin < end}
        begin = sum(len(one) + 1 for one in self.text.split('\n')[:line - 1])
        brace = self.code.find('{', begin)
        if not gone and re.match(r' *(?:struct|class) [^;]*$', self.code[begin:brace]):  # its members start as constants
            end = mutants.closing(self.code, brace, '{}')
            gone = {e for e in self.edits if begin <= e.begin < end and e.depth == 2}
        self.edits = [e for e in self.edits if e not in gone]
        return bool(gone)

    def switched(self):
        """The names of the mutants that it can be told to be."""
        return {name for e in self.edits for name in e.names}

    def __str__(self):
        # At one place: what ends there, inner before outer, and then what begins, outer before
        # inner.
        put, gone = [], {}
        for rank, e in enumerate(sorted(self.edits, key=lambda e: e.depth)):
            long = e.end - e.begin
            if isinstance(e.inside, str):
                gone[e.begin] = (e.end, e.inside)
                continue
            put += [(e.begin, 1, -long, rank, e.before), (e.end, 0, long, -rank, e.after)]
            for begin, end, sign in e.inside or ():
                put += [(begin, 1, begin - end, rank, '[&] { return bool('), (end, 0, end - begin, -rank, '); }')]
                if sign is not None:
                    gone[sign] = (sign + 2, ',')
        put.sort()
        out, at = [], 0
        for place in sorted({p[0] for p in put} | set(gone)):
            out += [self.text[at:place], *(p[-1] for p in put if p[0] == place)]
            at = place
            if place in gone:
                at, text = gone[place]
                out.append(text)
        return ''.join(out) + self.text[at:]
