"""All mutants of C++ sources under a fixed list of operators. Text in, values out; nothing is run here.

The sources are formatted (tests/lint/format.sh), so a binary operator stands between blanks and brackets of
templates do not. Comments, texts and lines of the preprocessor are left alone.
"""
import hashlib
import re
from dataclasses import dataclass

# Each text in the source, and its replacements. One mutant for each pair at each place.
SWAPS = [
    ('relation', '<', '<='), ('relation', '<=', '<'), ('relation', '>', '>='), ('relation', '>=', '>'),
    ('equality', '==', '!='), ('equality', '!=', '=='),
    ('sum', '+', '-'), ('sum', '-', '+'), ('sum', '+=', '-='), ('sum', '-=', '+='),
    ('product', '*', '/'), ('product', '/', '*'), ('product', '*=', '/='), ('product', '/=', '*='),
    ('extremum', 'std::min(', 'std::max('), ('extremum', 'std::max(', 'std::min('),
    ('logic', '&&', '||'), ('logic', '||', '&&'),
]
NUMBER = re.compile(r"(?<![\w.'])(?:0x[0-9a-fA-F']+|\d[\d']*\.?\d*(?:[eE][+-]?\d+)?)[uUlLfF]*(?![\w.])")
TRUTH = re.compile(r'\b(?:true|false)\b')
CONDITION = re.compile(r'\b(?:if|while) \(')
TYPE_HEAD = re.compile(r'\b(?:class|struct|enum|union|namespace)\b')
NO_STATEMENT = re.compile(
    r'(?:using|typedef|static_assert|static|constexpr|const|auto|class|struct|enum|case|default|public|private|'
    r'protected|else|return(?!$)|friend|template|extern|\[\[|explicit|virtual|goto)\b')
DECLARATION = re.compile(r'[A-Za-z_][\w:]*(?:<[^;=()]*>)?[&*]* [A-Za-z_]\w*(?: =|\{|\(|,|$)')


@dataclass(frozen=True)
class Mutant:
    path: str      # from the root of the tree
    line: int      # counted from 1
    operator: str
    begin: int     # offset in the file's text
    end: int
    before: str    # the original part, on one line
    after: str     # its replacement
    name: str      # the same as long as the line is the same


def masked(text):
    """The text with everything that is not to be changed blanked, character by character."""
    blank = lambda found: re.sub(r'[^\n]', ' ', found.group(0))
    text = re.sub(r'//[^\n]*|/\*.*?\*/', blank, text, flags=re.S)
    text = re.sub(r'"(?:[^"\\\n]|\\.)*"|(?<![\w])\'(?:[^\'\\\n]|\\.)+\'', blank, text)
    text = re.sub(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', blank, text, flags=re.M)
    text = re.sub(r'^ *template <[^\n]*', blank, text, flags=re.M)
    return re.sub(r'\bstatic_assert\([^;]*;', blank, text)


def closing(code, opening, pair='()'):
    """Where the bracket that opens at `opening` closes; the end of the code where it does not."""
    depth = 0
    for i in range(opening, len(code)):
        depth += (code[i] == pair[0]) - (code[i] == pair[1])
        if depth == 0:
            return i
    return len(code)


def kind_of_brace(head, parent):
    """What an opening brace after `head` begins: names of a type, a function, a block, or values."""
    head = head.strip()
    if TYPE_HEAD.search(head) and '(' not in head:
        return 'type'
    ends_as_code = re.search(r'(?:\)|\bconst|\bnoexcept|\boverride|\belse|\bdo|\))(?: ->[^{}]*)?$', head)
    if parent == 'type':
        return 'function' if '(' in head and (ends_as_code or re.search(r'\) : ', head)) else 'values'
    if not head:
        return 'block'
    return 'block' if ends_as_code or re.search(r'\bcase .*:$|\bdefault:$', head) else 'values'


def statements_and_functions(code):
    """(begin, end) of every statement that may be dropped, and (place, head) of every function's body."""
    statements, functions = [], []
    stack, begin, i = ['type'], 0, 0
    while i < len(code):
        sign = code[i]
        if sign == '(':
            # Walks the bodies of lambdas too: passes over only the content of the round brackets.
            end = closing(code, i)
            inner = re.search(r'\]\s*(?:\([^()]*\))?[^(){};]*\{', code[i:end])
            if not inner:
                i = end
        elif sign == '{':
            kind = kind_of_brace(code[begin:i], stack[-1])
            if kind == 'values':
                i = closing(code, i, '{}')
            else:
                if kind == 'function':
                    functions.append((i + 1, ' '.join(code[begin:i].split())))
                stack.append(kind)
                begin = i + 1
        elif sign == '}':
            if len(stack) > 1:
                stack.pop()
            begin = i + 1
        elif sign == ';':
            if stack[-1] != 'type':
                first = begin + len(code[begin:i]) - len(code[begin:i].lstrip())
                statement = code[first:i]
                if statement and not NO_STATEMENT.match(statement) and not DECLARATION.match(statement):
                    statements.append((first, i + 1))
            begin = i + 1
        i += 1
    return statements, functions


def early_return(head):
    """What a function with this head could return at once; None: a constructor or a destructor."""
    head = re.sub(r'^(?:public:|private:|protected:)\s*|\[\[[^\]]*\]\]\s*', '', head)
    if re.match(r'(?:explicit |constexpr |~)*[A-Z]\w*(?:::~?[A-Z]\w*)?\(', head):
        return None
    return ' return;' if re.match(r'(?:static |inline |constexpr |friend )*void ', head) else ' return {};'


def found_in(code):
    """(operator, begin, end, after) of every mutant of the masked code."""
    for operator, before, after in SWAPS:
        sign = re.escape(before) if operator == 'extremum' else rf'(?<= ){re.escape(before)}(?=[ \n])'
        for at in (m.start() for m in re.finditer(sign, code)):
            yield operator, at, at + len(before), after
    for found in NUMBER.finditer(code):
        number = found.group(0)
        value = float(re.sub(r"[uUlLfF']", '', number)) if not number.startswith('0x') else 16.0
        point = '.0' if '.' in number or 'e' in number.lower() and not number.startswith('0x') else ''
        for constant in (0, 1):
            if value != constant:
                yield 'constant', found.start(), found.end(), f'{constant}{point}'
    for found in TRUTH.finditer(code):
        yield 'constant', found.start(), found.end(), 'false' if found.group(0) == 'true' else 'true'
    for found in CONDITION.finditer(code):
        opening = found.end() - 1
        end = closing(code, opening)
        if ';' not in code[opening:end]:
            yield 'negation', opening, end + 1, '(!' + '{}' + ')'
    statements, functions = statements_and_functions(code)
    for begin, end in statements:
        yield 'drop', begin, end, ';'
    for place, head in functions:
        early = early_return(head)
        if early:
            yield 'return', place, place, early


def mutants_of(path, text):
    """All mutants of one file, in the order of their places. `text` is what the file holds."""
    code = masked(text)
    seen, all_mutants = {}, []
    for operator, begin, end, after in sorted(set(found_in(code))):
        before = text[begin:end]
        after = after.replace('{}', before) if operator == 'negation' else after
        line_begin = text.rfind('\n', 0, begin) + 1
        line_text = text[line_begin:text.find('\n', begin)].strip()
        between_blanks = f' {after} ' if re.fullmatch(r'[-<>=!+*/&|]+', after) else after
        key = (path, operator, line_text, ' '.join(before.split()), between_blanks)
        seen[key] = seen.get(key, 0) + 1
        name = hashlib.sha1('|'.join((*key, str(seen[key]))).encode()).hexdigest()[:10]
        shown = ' '.join(before.split()) or line_text
        all_mutants.append(Mutant(path, text.count('\n', 0, begin) + 1, operator, begin, end, shown,
                                  ' '.join(after.split()), name))
    return sorted(all_mutants, key=lambda m: (m.begin, m.end, m.operator, m.after))


def applied(mutant, text):
    """The text of the file with the mutant in it. Lines stay where they are."""
    before = text[mutant.begin:mutant.end]
    after = {'drop': ';', 'negation': '(!' + before + ')', 'return': ' ' + mutant.after}.get(mutant.operator)
    after = mutant.after if after is None else after
    return text[:mutant.begin] + after + '\n' * (before.count('\n') - after.count('\n')) + text[mutant.end:]
