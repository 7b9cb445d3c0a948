"""The tables of hazards: which tests each row rests on, and how those ended last."""
import re
import xml.etree.ElementTree as xml

import figures

TESTED = figures.HERE / 'results/tested.csv'
FAULTS = figures.ROOT / 'tests/machines/sim/faults.md'
# The test that judges every fault of a way into the driver (tests/machines/sim/faults.md).
OF_WAY = {'driver': 'FaultMatrix.EndsInZeroTorqueAndFindsBack', 'servo': 'LoopFaults.EndInZeroTorqueAreSaidAndForceComesBackArmed',
          'libusb': 'UsbFault.EndsInZeroTorqueAndFindsBack', 'processes': 'ProcessFault.EndsInZeroTorqueAndFindsBack'}


def rows():
    """(group, hazard, expected, evidence as a list, remark)"""
    for group, hazard, expected, evidence, remark in figures.divided('hazards.tsv'):
        yield group, hazard, expected, evidence_of(evidence), remark


def evidence_of(text):
    """Names of tests, and `figure:ROW:words` whose words go up to the next name."""
    found = []
    for word in text.split(' ') if text != '-' else []:
        if found and found[-1].startswith('figure:') and not re.match(r'figure:|[A-Z]\w*\.[A-Z]\w*$', word):
            found[-1] += ' ' + word
        else:
            found.append(word)
    return found


def names():
    """Every test that a row of hazards or a way of faults names."""
    named = [e for row in rows() for e in row[3] if not e.startswith('figure:')]
    return sorted({*named, *OF_WAY.values()})


def ended(name, cases):
    """'passed', 'failed' or '': of all the cases of this test, whatever they are called with."""
    suite, case_name = map(re.escape, name.split('.'))
    of_name = re.compile(rf'(?:\w+/)?{suite}(?:/\d+)?\.{case_name}(?:[/<].*)?$')
    ends = [end for case, end in cases if of_name.match(case)]
    return '' if not ends else 'failed' if 'failed' in ends else 'passed'


def cases_of(path):
    """(name, passed or failed) of every case in a JUnit file that was run."""
    for case in xml.parse(path).getroot().iter('testcase'):
        status = case.get('status', 'run')
        if status in ('run', 'fail'):
            bad = status == 'fail' or case.find('failure') is not None or case.find('error') is not None
            yield case.get('name'), 'failed' if bad else 'passed'


def tested():
    """Test -> how it ended last, as kept."""
    if not TESTED.exists():
        return {}
    return dict(line.split(',') for line in TESTED.read_text().splitlines()[1:])


def keep(path):
    """Takes over what a JUnit file tells of the named tests."""
    cases, kept = list(cases_of(path)), tested()
    new = {name: ended(name, cases) or kept.get(name, '') for name in names()}
    TESTED.parent.mkdir(exist_ok=True)
    TESTED.write_text('test,ended\n' + ''.join(f'{name},{end}\n' for name, end in new.items() if end))


def end_of(evidence, known, all_figures):
    """'passed', 'failed' or 'not measured yet' of one test or figure."""
    if not evidence.startswith('figure:'):
        return known.get(evidence, 'not measured yet')
    _, row, beginning = evidence.split(':', 2)
    ends = [f['passed'] for f in all_figures if f['row'] == row and f['figure'].startswith(beginning)]
    return 'not measured yet' if not ends else 'failed' if 'no' in ends else 'passed'


def judged(evidence, known, all_figures):
    """One word for a row: failed, not measured yet (in part), passed, or not run."""
    ends = [end_of(e, known, all_figures) for e in evidence]
    if not ends:
        return 'not run'
    if 'failed' in ends:
        return 'failed'
    if 'not measured yet' in ends:
        return 'passed as far as measured' if 'passed' in ends else 'not measured yet'
    return 'passed'


def faults():
    """(way, fault, runs, zero torque after, state, force back) of every fault, as tests/machines/sim keeps them."""
    found = []
    for line in FAULTS.read_text().splitlines():
        cells = [cell.strip() for cell in line.strip('|').split('|')]
        if line.startswith('|') and cells[0] in OF_WAY:
            found.append(cells[:6])
    # A page without faults would say that none is listed, as if nobody had looked.
    if not found:
        raise SystemExit(f'{FAULTS} lists no fault: tests/machines/sim/faults writes it')
    return found
