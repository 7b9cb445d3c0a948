"""How a test program is made, as ninja tells it, and made again with files of it changed."""
import re
import shlex
import subprocess
from pathlib import Path

SILENT = ['-g0', '-w', '-Wno-narrowing']  # warnings do not matter here


def said_by_ninja(build, *words):
    return subprocess.run(['ninja', '-C', build, *words], check=True, capture_output=True, text=True).stdout


class Program:
    """One test program: what it is compiled, archived and linked from. Paths are seen from the build's folder."""

    def __init__(self, build, name):
        self.name = name
        self.compiles, self.objects_of_library = {}, {}
        for line in said_by_ninja(build, '-t', 'commands', name).splitlines():
            words = shlex.split(line)
            if ' -c ' in line and '-o' in words and words[words.index('-o') + 1].endswith('.o'):
                self.compiles[words[words.index('-o') + 1]] = words
            elif ' qc ' in line:
                library = words[words.index('qc') + 1]
                self.objects_of_library[library] = [w for w in words if w.endswith('.o')]
            elif '-o' in words and Path(words[words.index('-o') + 1]).name == name:
                first = next(i for i, w in enumerate(words) if re.search(r'(g\+\+|c\+\+)$', w))
                last = words.index('&&', first) if '&&' in words[first:] else len(words)
                self.link = words[first:last]
        libraries = [w for w in self.link if w in self.objects_of_library]
        self.own = sorted(set(w for w in self.link if w.endswith('.o')))
        self.objects = set(self.own) | {o for library in libraries for o in self.objects_of_library[library]}


def dependants(build):
    """The objects that are made from each file, by the file's whole path."""
    made_from, target = {}, None
    for line in said_by_ninja(build, '-t', 'deps').splitlines():
        if line.startswith('    '):
            path = (Path(build) / line.strip()).resolve() if not line.strip().startswith('/') else Path(line.strip())
            made_from.setdefault(str(path), set()).add(target)
        elif ':' in line:
            target = line.split(':')[0]
    return made_from


def without_flags(words):
    """A compile command without levels, warnings and dependency files."""
    kept, skip = [], False
    for word in words:
        if skip or word in ('-MD', '-g') or re.match(r'-O|-W(?!l)', word):
            skip = False
            continue
        if word in ('-MT', '-MF'):
            skip = True
            continue
        kept.append(word)
    return kept


def compiler_says(build, command, overlay, root, target, options):
    """What the compiler complains of, nothing if the object was made at `target`, the overlay's files before the root's."""
    words = without_flags(command)
    source = Path(words[words.index('-c') + 1])
    changed = Path(overlay) / source.relative_to(root)
    if changed.exists():
        words[words.index('-c') + 1] = str(changed)
    words[words.index('-o') + 1] = str(target)
    first = 2 if words[0].endswith('ccache') else 1
    words[first:first] = [f'-I{overlay}', *SILENT, *options]
    made = subprocess.run(words, cwd=build, capture_output=True, text=True)
    return made.stderr if made.returncode else ''


def linked(build, program, replaced, target):
    """True if the program could be linked at `target` with these objects in place of its own or its libraries'."""
    words, members = [], [str(o) for old, o in replaced.items() if old not in program.own]
    for word in program.link:
        if word.endswith('.a') and members:
            words += members
            members = []
        words.append(str(replaced.get(word, word)))
    words[words.index('-o') + 1] = str(target)
    words.append('-Wl,--strip-debug')
    return subprocess.run(words, cwd=build, capture_output=True).returncode == 0
