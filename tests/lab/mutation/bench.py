"""The test programs of a folder, with all mutants in them or with one, and what they say of a mutant."""
import collections
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import builds
import mutants
import schemata

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
BUILD = ROOT / 'build/release'
WORK = ROOT / 'build/mutation'
LEAST_DEADLINE_S, WHOLE_DEADLINE_S = 4.0, 300.0
SINGLES = 5
DOES_NOT_COMPILE = 2  # as in switches.h
MOST_MEMORY = 4 << 30  # a mutant may grow without end

# The test programs of a folder; beside some are the programs that they start.
PROGRAMS = {
    'safety': ('haptics/safety', ['safety_test']),
    'sandbox': ('app/isolation/sandbox', ['sandbox_policy_test', 'worker_test', 'stick_fence_test', 'sandbox_test']),
    'contact': ('haptics/contact', ['contact_traces_test', 'contact_test', 'groove_test', 'contact_diagram_test']),
}
STARTED = {'sandbox_test': ['sandbox_probe']}


def enumerated(folder):
    """All mutants of a folder, always in the same order."""
    paths = sorted(p.relative_to(ROOT) for p in (ROOT / folder).iterdir() if p.suffix in ('.h', '.cpp'))
    return [m for p in paths for m in mutants.mutants_of(str(p), (ROOT / p).read_text())]


def tested(at, cases, deadline_s, **surroundings):
    """What the program at this place says of the cases: ('passed', 'killed' or 'timeout', the last that it ran, its work in s)."""
    environment = dict(os.environ, RC_PARAMS='seed=1', TOUCHLINE_PROGRAMS=str(BUILD / 'app/main'), **surroundings)
    words = ['prlimit', f'--as={MOST_MEMORY}', 'timeout', '-k', '1', f'{deadline_s:.0f}', str(at), '--gtest_fail_fast',
             f'--gtest_filter={":".join(cases)}']
    with tempfile.TemporaryFile() as told:
        run = subprocess.Popen(words, cwd=BUILD, env=environment, stdin=subprocess.DEVNULL, stdout=told, stderr=told)
        _, status, used = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
        told.seek(0)
        last = re.findall(rb'^\[ RUN      \] (\S+)', told.read(1 << 20), re.M)
    end = {0: 'passed', 124: 'timeout', 137: 'timeout'}.get(run.returncode, 'killed')
    return end, last[-1].decode() if last else '', used.ru_utime + used.ru_stime


class Bench:
    """Test programs of one folder without a mutant, and how they are made."""

    def __init__(self, name, jobs):
        self.folder, self.names = PROGRAMS[name]
        self.work, self.jobs = WORK / name, jobs
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        setup = f'. {ROOT}/app/setup.sh; install_packages build test reliability; ' + \
            ''.join(f'build release {p} -DBUILD_TESTING=ON; ' for p in self.names)
        subprocess.run(['bash', '-euo', 'pipefail', '-c', setup], check=True, env=dict(os.environ, CI='true'))
        self.programs = {n: builds.Program(BUILD, n) for p in self.names for n in (p, *STARTED.get(p, []))}
        self.dependants = builds.dependants(BUILD)
        self.pool = ThreadPoolExecutor(max_workers=jobs)

    def touched(self, paths):
        """The objects that are made from these files: the command of each."""
        made = set().union(*(self.dependants.get(str(ROOT / p), set()) for p in paths))
        return {o: p.compiles[o] for p in self.programs.values() for o in p.objects & made}

    def linked(self, objects, where):
        """True if all programs could be linked in the folder `where` with these objects in place of theirs."""
        return all(builds.linked(BUILD, p, {o: at for o, at in objects.items() if o in p.objects}, where / n)
                   for n, p in self.programs.items())

    def made_alone(self, mutant, where, most=None):
        """The objects (at most so many) of a mutant that is compiled by itself; none if it does not compile."""
        (where / mutant.path).parent.mkdir(parents=True)
        (where / mutant.path).write_text(mutants.applied(mutant, (ROOT / mutant.path).read_text()))
        objects = {}
        for old, command in list(self.touched([mutant.path]).items())[:most]:
            objects[old] = where / f'{len(objects)}.o'
            if builds.compiler_says(BUILD, command, where, ROOT, objects[old], ['-O1']):
                return {}
        return objects

    def judged_alone(self, mutant, is_reached=True):
        """(end, by) of a mutant that is compiled by itself, as each of them could be. All cases are run."""
        where = self.work / mutant.name
        try:
            objects = self.made_alone(mutant, where, None if is_reached else 1)
            if not objects:
                return 'not compiling', ''
            if not is_reached:
                return 'survived', 'not reached'
            if not self.linked(objects, where):
                return 'not compiling', 'linker'
            for name in self.names:
                end, case, _ = tested(where / name, '*', WHOLE_DEADLINE_S)
                if end != 'passed':
                    return end, case or name
            return 'survived', ''
        finally:
            shutil.rmtree(where)


class Switched:
    """The programs with all mutants in them that can be chosen while they run."""

    def __init__(self, bench, all_mutants):
        self.bench = bench
        self.number_of = {m.name: i + 1 for i, m in enumerate(all_mutants)}
        self.sources = {p: schemata.Schemata(p, (ROOT / p).read_text(), self.number_of)
                        for p in dict.fromkeys(m.path for m in all_mutants)}
        self.tree = bench.work / 'tree'
        self.build()
        self.names = set().union(*(s.switched() for s in self.sources.values()))
        print(f'{bench.folder}: {len(self.names)} of {len(all_mutants)} mutants in one build', flush=True)
        self.seconds, self.work_s, self.states = {}, {}, {}  # per case, (program, its name)
        self.kills = collections.Counter()
        self.watch()

    def build(self):
        """Until the compiler takes it: what it does not take is left as it stood."""
        commands = self.bench.touched(self.sources)
        runtime = [*next(iter(commands.values()))]
        runtime[runtime.index('-c') + 1] = str(HERE / 'switches.cpp')
        objects = {o: self.bench.work / f'{i}.o' for i, o in enumerate(commands)}
        made, left = set(), [o for o in commands if not o.startswith('tests/')]  # compiles the quick ones first
        while left:
            for path, source in self.sources.items():
                (self.tree / path).parent.mkdir(parents=True, exist_ok=True)
                (self.tree / path).write_text(str(source))
            said = list(self.bench.pool.map(lambda o: self.compiled(commands[o], objects[o]), left))
            complaints = {o: s for o, s in zip(left, said) if s}
            is_header_changed = self.leave_what_fails(complaints.values())
            made = set() if is_header_changed else made.union(left) - complaints.keys()
            left = list(complaints) or [o for o in commands if o not in made]
        self.compiled(runtime, self.bench.work / 'switches.o')
        for program in self.bench.programs.values():
            program.link.insert(program.link.index('-o'), str(self.bench.work / 'switches.o'))
        if not self.bench.linked(objects, self.bench.work):
            sys.exit('the programs with all mutants cannot be linked')

    def compiled(self, command, target):
        return builds.compiler_says(BUILD, command, self.tree, ROOT, target,
                                    ['-O2', '-include', str(HERE / 'switches.h'), '-fmax-errors=0'])

    def leave_what_fails(self, complaints):
        """True if a header is among what was left: of each error the first line that it names and that has a switch."""
        left = set()
        for at in (at for said in complaints for at in errors(said, self.tree)):
            left.add(next((p for p in at if p in left or self.sources[p[0]].leave(p[1])), None))
        if left == {None}:
            sys.exit('what the compiler does not take is no mutant:\n' + next(iter(complaints)))
        return any(p and p[0].endswith('.h') for p in left)

    def watch(self):
        """Runs each case alone: how long it takes, and which mutants it reaches."""
        def one(at):
            told = self.bench.work / f'states-{len(self.seconds)}-{at[1].replace("/", "-")}'
            told.write_bytes(bytes(len(self.number_of) + 1))
            begin = time.monotonic()
            end, _, self.work_s[at] = tested(self.bench.work / at[0], at[1:], 600, TOUCHLINE_MUTANTS_REACHED=str(told))
            if end != 'passed':
                sys.exit(f'{" ".join(at)} fails without a mutant: mend it first')
            self.seconds[at] = time.monotonic() - begin
            self.states[at] = told.read_bytes()

        cases = [(p, case) for p in self.bench.names for case in cases_of(self.bench.work / p)]
        list(self.bench.pool.map(one, cases))

    def judged(self, mutant, least_s, most_s):
        """(end, by): only cases that reach it are run, and cost so much; first those that have killed near it for little."""
        number = self.number_of[mutant.name]
        states = {self.states[at][number] for at in self.states}
        if DOES_NOT_COMPILE in states:
            return 'not compiling', ''
        reaching = [at for at in self.states if self.states[at][number]]
        if not reaching:
            return self.bench.judged_alone(mutant, is_reached=False)

        def worth(at):
            return (self.kills[mutant.path, at] + 0.1) / (self.work_s[at] + 0.01)

        order = sorted((at for at in reaching if least_s <= self.work_s[at] < most_s), key=worth, reverse=True)
        # The most promising run alone, the others together: starting a program costs more than a
        # small case.
        together = [[at for at in order[SINGLES:] if at[0] == program] for program in self.bench.names]
        for some in [*([at] for at in order[:SINGLES]), *filter(None, together)]:
            program, cases = some[0][0], [case for _, case in some]
            deadline_s = max(LEAST_DEADLINE_S, 10.0 * sum(self.seconds[at] for at in some))
            end, case, _ = tested(self.bench.work / program, cases, deadline_s, TOUCHLINE_MUTANT=str(number))
            if end != 'passed':
                self.kills[mutant.path, (program, case)] += 1
                return end, case or program
        return 'survived', ''


def errors(said, tree):
    """Of each error the (path, line) of the tree's files that it names: its own, for whom that was made, its notes."""
    found, required = [], []
    for line in said.splitlines():
        at = re.match(rf'\S*/{tree.parent.name}/{tree.name}/([^:]+):(\d+):', line)  # ccache shortens the path
        place = [(at.group(1), int(at.group(2)))] if at else []
        if ' error: ' in line:
            found.append(place + required)
            required = []
        elif ' note: ' in line and found:
            found[-1] += place
        elif 'required from' in line:
            required += place
    return found


def cases_of(program):
    """The names of all cases of a test program."""
    suite, cases = '', []
    told = subprocess.run([program, '--gtest_list_tests'], check=True, capture_output=True, text=True).stdout
    for line in told.splitlines():
        word = line.split('#')[0].rstrip()
        if word.startswith('  '):
            cases.append(suite + word.strip())
        elif word.endswith('.'):
            suite = word
    return cases
