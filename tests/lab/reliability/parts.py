"""Turns what the tools of a part left in build/reliability into its rows: parts.py PART [SECONDS]."""
import fnmatch
import json
import os
import re
import subprocess
import sys
import tarfile
import time
import xml.etree.ElementTree as xml

sys.dont_write_bytecode = True
import figures  # noqa: E402
import hazards  # noqa: E402

OUT, ROOT = figures.OUT, figures.ROOT


def coverage():
    rows = []
    for name, what in (('safety', 'haptics/safety'), ('sandbox', 'the policy of app/isolation/sandbox')):
        found = json.loads((OUT / f'{name}.json').read_text())
        covered, of_all = found['branch_covered'], found['branch_total']
        share = 100.0 * covered / of_all
        rows.append((23, f'branches of {what} that tests take', f'{share:.1f} % ({covered} of {of_all})', '>= 95 %',
                     share >= 95.0, 'tests/lab/reliability/coverage: gcovr, without throw and unreachable branches'))
    figures.write('coverage', rows)


def hazard_rows():
    known_before = hazards.TESTED.exists()
    hazards.keep(OUT / 'tests.xml')
    known = hazards.tested()
    ends = [hazards.judged([e for e in row[3] if not e.startswith('figure:')], known, []) for row in hazards.rows()
            if row[0] == 'stick']
    passed, without = ends.count('passed'), ends.count('not run')
    rows = [(16, 'stick cases whose tests on this machine passed', f'{passed} of {len(ends)}; {without} not run, with its reason',
             'all or the reason', passed + without == len(ends), 'tests/lab/reliability/run tests: hazards.tsv')]
    still = [known.get(name, '') for name in ('MountedStick.IsReadWithoutChangingAByte', 'Fence.NothingOnTheStickIsWritten')]
    if all(still):
        rows.append((17, 'bytes changed on sticks that are mounted here', '0' if still == ['passed'] * 2 else 'some', '0',
                     still == ['passed'] * 2, 'tests MountedStick and Fence: every byte before and after'))
    failed = sum(1 for _, end in hazards.cases_of(OUT / 'tests.xml') if end == 'failed')
    print(f'{failed} tests failed; {len(known)} of {len(hazards.names())} named tests have a result'
          + ('' if known_before else ', for the first time'))
    figures.write('hazards', rows)


def instructions():
    rows, cases = [], dict(hazards.cases_of(OUT / 'instructions.xml'))
    for name, recorded, unit in (('AStepTakesNoMoreThanRecorded', 'recorded.txt', 'a servo step'),
                                 ('APicturesMapTakesNoMoreThanRecorded', 'recorded_map.txt', "a picture's map")):
        lines = [line.split() for line in (ROOT / 'tests/lab/bench/instructions' / recorded).read_text().splitlines()]
        for line in (words for words in lines if words and words[0] != '#'):
            end = cases.get(f'InstructionGate.{name}')
            if end:
                rows.append((7, f'instructions of {unit}: {line[0]} {line[1]}', f'{float(line[2]):.0f}',
                             'at most 5 % more', end == 'passed', f'callgrind; test InstructionGate.{name}'))
    figures.write('instructions', rows)


def fuzzing(seconds):
    target, executed, broken = '', {}, []
    for line in (OUT / 'fuzzing.log').read_text(errors='replace').splitlines():
        word = line.split()
        if line.startswith('target '):
            target = word[1]
        elif line.startswith('stat::number_of_executed_units:'):
            executed[target] = executed.get(target, 0) + int(word[1])
        elif line.startswith('broken ') or 'SUMMARY: ' in line:
            broken.append(target)
    how = f'tests/fuzz/run NAME {seconds}: libFuzzer with the address and undefined-behaviour sanitizers'
    rows = [(10, f'inputs tried: {name}', f'{count}', '>= 1000000', count >= 1_000_000, how)
            for name, count in sorted(executed.items()) if name != 'picture']
    # Tracing takes a second under the sanitizers, so this target has its own bar, which another
    # command reaches.
    if 'picture' in executed:
        rows.append((10, 'inputs tried: picture', f'{executed["picture"]}', '-', None,
                     f'{how}; 50000 are tried by TOUCHLINE_EXHAUSTIVE=1 random_pictures_test, built with both sanitizers'))
    kept = 0
    for path in sorted((ROOT / 'tests/fuzz/corpus').glob('*.tar.xz')):
        with tarfile.open(path) as corpus:
            kept += len(corpus.getnames())
    rows.append((10, 'inputs kept and replayed every day', f'{kept}', '-', None, 'inputs in tests/fuzz/corpus'))
    rows.append((11, 'targets that crashed, hung or leaked', f'{len(set(broken))} of {len(executed)}', '0', not broken, how))
    figures.write('fuzzing', rows)


def least_ms(words, runs):
    """Least and median time of starting a program and waiting for its end."""
    took = []
    for _ in range(runs):
        begin = time.monotonic()
        subprocess.run(words, cwd=OUT, check=True)
        took.append(1e3 * (time.monotonic() - begin))
    return min(took), sorted(took)[runs // 2]


def properties(program):
    found = {}
    for one in xml.parse(OUT / f'{program}.xml').getroot().iter('property'):
        found.setdefault(one.get('name'), []).append(int(one.get('value')))
    return {name: values if len(values) > 1 else values[0] for name, values in found.items()}


def workers():
    allowed, bombs = properties('sandbox_policy_test'), properties('liar_test')
    acts = properties('sandbox_test')
    how = 'tests/lab/reliability/run workers'
    rows = [(12, 'refusing the slowest bomb, ms', f'{bombs["worst_ms"]}', '<= 6000, its deadline',
             bombs['worst_ms'] <= 6000, f'{how}: test Bombs.AreRefusedWithoutHarm, {bombs["tried"]} bombs'),
            (12, "growth of the kiosk's memory by a bomb, worst, kB", f'{bombs["worst_kB"]}', '<= 1024',
             bombs['worst_kB'] <= 1024, f'{how}: test Bombs.AreRefusedWithoutHarm')]
    probe = str(ROOT / 'build/release/tests/app/isolation/sandbox/sandbox_probe')
    with_it, median_with = least_ms([probe, 'all', '0', 'nothing'], 300)
    without, median_without = least_ms([probe, 'none', '0', 'nothing'], 300)
    rows.append((13, 'cost of the sandbox, ms: least (median)',
                 f'{with_it - without:.2f} ({median_with - median_without:.2f})', '<= 1', with_it - without <= 1.0,
                 f'{how}: 300 starts of a program that does nothing, with the sandbox and without'))
    kinds = ['raster', 'heif', 'document', 'ocr', 'speech', 'pack']
    rows.append((14, 'calls that a worker may make, by kind',
                 ', '.join(f'{kind} {allowed[f"allowed_{i}"]}' for i, kind in enumerate(kinds)), '-', None,
                 'test SandboxPolicy.CallsThatAreAllowedWhateverTheirArguments counts the rules'))
    rows.append((14, 'forbidden acts denied, of those tried by every kind', f'{min(acts["denied"])} of {max(acts["tried"])}', 'all',
                 min(acts['denied']) == max(acts['tried']), f'{how}: test Sandbox.EveryActIsDenied'))
    figures.write('workers', rows)


def machines():
    rows = []
    for program, case, what in (
            ('safety_test', 'EveryStateUnderEveryCombinationOfFlags', 'force: states under every combination of 13 flags'),
            ('visit_test', 'IN5_EveryKeyIsAnsweredAtOnceEverywhere', 'visit: states that keys, work, time and trouble lead to'),
            ('operator_test', 'EveryScreenIsReachedAndLeftByFourPressesAtMost', "operator's screens: states under six keys"),
            ('contact_diagram_test', 'HoldsOnEvery*', 'contact: small worlds under sequences of three places, the everyday share of them')):
        found, failed = properties(program), [c for c, end in hazards.cases_of(OUT / f'{program}.xml') if end != 'passed']
        states, steps = (sum(v) if isinstance(v, list) else v for v in (found['states'], found['steps']))
        rows.append((24, what, f'{states} states, {steps} steps, {len(failed)} errors', 'all; 0 errors', not failed,
                     f'tests/lab/reliability/run machines: {program}, {case}'))
    claims = [line.split() for line in (OUT / 'guard.log').read_text().splitlines()]
    whole = len(claims) == 3 and all(len(claim) == 3 and claim[2] == '0' for claim in claims)
    rows.append((24, 'kiosk, guard and servo in every order of their steps', '; '.join(
        f'{claim[0]}: {claim[1]} states, {claim[2]} errors' for claim in claims if len(claim) == 3), '0 errors', whole,
        'tests/machines/sim/guard/run: spin, a model by hand; three broken models are found out'))
    figures.write('machines', rows)


def devices():
    words = {'zero_wanted': 'wanted off', 'answers_stop': 'answers stop', 'line_cut': 'line cut', 'ticks_stop': 'servo stops'}
    rows = []
    for case in xml.parse(OUT / 'conformance_test.xml').getroot().iter('testcase'):
        told = {one.get('name'): int(one.get('value')) for one in case.iter('property')}
        make, failed = case.get('name').split('/')[1], case.find('failure') is not None
        for cause in (cause for cause in words if cause in told):
            us, stated_us = told[cause], told[f'{cause}_stated']
            rows.append((3, f'zero force after: {words[cause]}, {make}', f'{us / 1000:.1f} ms', f'{stated_us / 1000:.0f} ms',
                         us <= stated_us and not failed, 'tests/lab/reliability/run devices: test '
                         'Conformance.ForceEndsInTheTimeThatItStatesWheneverThatIsWanted, the longest of ten moments, emulator, virtual clock'))
    figures.write('devices', rows)


def stages():
    told = (OUT / 'stages.log').read_text()
    start = re.search(r"worker's start, to a refusal: ([\d.]+) \(([\d.]+)\)", told)
    picture = re.search(r'one-megapixel\.png \|[^|]*\| ([\d.]+ \([\d.]+\))', told)
    how = 'tests/lab/bench/opening/run stages'
    figures.write('stages', [
        (13, 'start of a worker, to a refusal, ms: least (median)', f'{start[1]} ({start[2]})', '<= 5',
         float(start[1]) <= 5.0, how),
        (13, 'a PNG of noise of 1 Mpx, opened, ms: least (median)', picture[1], '-', None, how)])


def sanitizers():
    rows = []
    for preset, what in (('asan', 'address and undefined-behaviour sanitizers'), ('tsan', 'thread sanitizer')):
        ends = [end for _, end in hazards.cases_of(OUT / f'{preset}.xml')]
        failed = ends.count('failed')
        rows.append((27, f'tests that fail under the {what}', f'{failed} of {len(ends)}', '0', failed == 0 and bool(ends),
                     f'tests/run --{preset}; what is left out: part exclusions'))
    figures.write('sanitizers', rows)


def programs_of(preset):
    lines = (OUT / f'programs-{preset}.txt').read_text().split(';')
    return dict(line.rsplit(' ', 1) for line in sorted(set(lines)) if line.strip())


def exclusions():
    """A page of them, and one row for each sanitizer; a program without a reason ends the part."""
    all_programs = programs_of('release')
    left_out = {s: sorted(set(all_programs) - set(programs_of(s))) for s in ('asan', 'tsan')}
    reasons = figures.divided('exclusions.tsv')
    page, nameless = ['| test program | label | left out by | why |', '|---|---|---|---|'], []
    for program in sorted({p for programs in left_out.values() for p in programs}):
        by = [s for s in left_out if program in left_out[s]]
        why = [r for r in reasons if fnmatch.fnmatch(program, r[0]) and set(by) == set(r[1].split())]
        if not why:
            nameless.append(f'{program} ({", ".join(by)})')
        else:
            page.append(f'| {program} | {all_programs[program]} | {", ".join(by)} | {why[0][2]} |')
    if nameless:
        sys.exit('exclusions.tsv gives no reason for: ' + '; '.join(nameless))
    figures.write('exclusions', [
        (27, f'test programs that {s} leaves out', f'{len(programs)} of {len(all_programs)}', '-', None,
         'tests/lab/reliability/run exclusions; each runs in the build without sanitizers, tests/run')
        for s, programs in left_out.items()])
    (OUT / 'exclusions.md').write_text('\n'.join(page) + '\n')


PARTS = {'coverage': coverage, 'hazards': hazard_rows, 'instructions': instructions, 'workers': workers,
         'stages': stages, 'machines': machines, 'devices': devices, 'sanitizers': sanitizers, 'exclusions': exclusions}
if sys.argv[1] == 'pattern':
    # For ctest, whose expressions have no \w.
    print('^([A-Za-z0-9_]+/)?(' + '|'.join(re.escape(name) for name in hazards.names()) + ')(/|<|$)')
elif sys.argv[1] == 'fuzzing':
    fuzzing(sys.argv[2])
else:
    PARTS[sys.argv[1]]()
