"""tests/machines/system/machine/run, in its namespaces: machine.py ROOT WHAT..."""

import os
import re
import subprocess
import sys

ROOT = sys.argv[1]
sys.path.insert(0, f'{ROOT}/tests/machines/system/soak')

import missing
import world as soaked
from figures import Figures, quantile

BUILD = f'{ROOT}/build/release'
HOW = 'tests/machines/system/machine/run '
SECONDS = 10
# What each tier changes (haptics/servo/real_time.h).
TIERS = {'A': 'full stiffness', 'B': 'full stiffness', 'C': 'half the stiffness and force, damped', 'D': 'no force, sound only'}


def machine():
    with open('/proc/cpuinfo', encoding='ascii') as file:
        model = re.search(r'model name\s*: (.*)', file.read())
    return f'{os.cpu_count()} x {model[1] if model else "processor"}, Linux {os.uname().release.split("-")[0]}'


def answer_of(*command):
    """A line of names and numbers, as tests/machines/system/machine/measure_main.cpp prints it."""
    words = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    return {name: float(value) for name, value in zip(words[::2], words[1::2])}


def ticks(figures):
    told = answer_of(f'{BUILD}/tests/machines/system/measure', 'ticks')
    value = f'{told["allocations"]:.0f} / {told["locks"]:.0f} / {told["faults"]:.0f}'
    figures.keep(6, 'allocations / locks / page faults per 10^6 servo ticks', value, '0 / 0 / 0',
                 value == '0 / 0 / 0' and told['in_contact'] > 1e5,
                 HOW + f'ticks: {told["ticks"]:.0f} ticks of the loop, {told["in_contact"]:.0f} in contact, memory locked')


def lateness_of(command):
    """(tier, ticks, median, 99.9 %, worst in us), of tests/machines/sim/jitter."""
    row = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split('|')
    return row[3].strip(), int(row[4]), *(int(part) for part in row[-2].split('/'))


def baseline():
    """The same of cyclictest, a thread of priority 80 every millisecond."""
    text = subprocess.run(['cyclictest', '--quiet', '--mlockall', '--priority=80', '--interval=1000', '--threads=1',
                           f'--duration={SECONDS}', '--histogram=20000'], capture_output=True, text=True, check=True).stdout
    counts = [(int(us), int(count)) for us, count in re.findall(r'^(\d{6}) (\d+)', text, re.MULTILINE)]
    late = [us for us, count in counts for _ in range(count)]
    worst = int(re.search(r'# Max Latencies: (\d+)', text)[1])
    return '', len(late), quantile(late, 0.5), quantile(late, 0.999), max(worst, late[-1] if late else 0)


def lateness(figures):
    jitter = f'{BUILD}/tests/machines/sim/umockdev/jitter'
    ordinary = ['setpriv', '--reuid', '65534', '--regid', '65534', '--clear-groups']
    copy = '/dev/shm/jitter'  # an ordinary user may not enter another user's folders
    subprocess.run(['install', '-m', '755', jitter, copy], check=True)
    ways = {'servo, real-time priority': lambda: lateness_of([jitter, 'board', str(SECONDS)]),
            'servo, ordinary user': lambda: lateness_of([*ordinary, copy, 'board', str(SECONDS)]),
            'cyclictest, the baseline': baseline}
    for load, command in (('as it is', None), ('under stress-ng --cpu 4', ['stress-ng', '--cpu', '4', '--quiet'])):
        stress = subprocess.Popen(command) if command else None
        try:
            for way, measure in ways.items():
                tier, count, median, most, worst = measure()
                if tier:
                    figures.keep(9, f'tier, {way}, {load}', f'{tier}: {TIERS[tier]}', 'stated', None, HOW + 'lateness: ' + machine())
                figures.keep(8, f'lateness of a tick, {way}, {load}: median / 99.9 % / worst us, ticks missing',
                             f'{median} / {most} / {worst}, {max(0, SECONDS * 1000 - count)} of {SECONDS * 1000}',
                             'reported', None, HOW + f'lateness: {machine()}, load before {os.getloadavg()[0]:.1f}')
        finally:
            if stress:
                stress.terminate()
                stress.wait()
    os.remove(copy)


def libraries(figures):
    for name in ('touchline-decode', 'touchline-servo', 'touchline'):
        text = subprocess.run(['ldd', f'{BUILD}/app/main/{name}'], capture_output=True, text=True, check=True).stdout
        figures.keep(15, f'shared libraries of {name}', text.count(' => '), 'reported', None,
                     HOW + 'libraries: ldd; 139 with the picture readers of OpenCV')


def listing(figures):
    told = answer_of(f'{BUILD}/tests/machines/system/measure', 'listing', f'{BUILD}/app/main/touchline-import')
    figures.keep(18, 'listing a stick with 10^5 files: s, MB', f'{told["s"]:.2f}, {told["MB"]:.1f}', '< 2, < 50',
                 told['s'] < 2.0 and told['MB'] < 50.0 and told['whole'] == 1,
                 HOW + f'listing: process started, list checked; files in memory; {machine()}, load {os.getloadavg()[0]:.1f}')


def valgrind(figures):
    """The simulated device, so that the servo's thread is looked at too; without the right to real time, or its
    thread would leave no time for the others at a fiftieth of its speed."""
    world = soaked.World(ROOT, f'{ROOT}/build/reliability/valgrind')
    soaked.LONGEST_WAIT_S = 900.0
    log = f'{world.folder}/memcheck.txt'
    world.start_bus()
    world.make_stick()
    kiosk = soaked.Kiosk(
        world, {'LD_PRELOAD': f'{BUILD}/tests/machines/system/libpidfd_of_valgrind.so'}, has_board=False,
        before=['setpriv', '--inh-caps=-sys_nice', '--bounding-set=-sys_nice',
                'valgrind', '--fair-sched=yes', '--child-silent-after-fork=yes', '--keep-debuginfo=yes', '--num-callers=30',
                '--leak-check=full', '--show-leak-kinds=definite', '--errors-for-leak-kinds=definite',
                f'--suppressions={ROOT}/tests/machines/system/machine/libraries.supp', f'--log-file={log}'])
    soaked.wait_for('ready under valgrind', kiosk.is_ready)
    world.plug_stick(0)
    visitor = soaked.Visitor(kiosk, 14, pause_s=2.0)
    visitor.ends.wait(90.0)
    visitor.end()
    status = missing.quit_by_key(kiosk)
    world.close()
    with open(log, encoding='utf-8', errors='replace') as file:
        text = file.read()
    lost = re.search(r'definitely lost: ([\d,]+) bytes', text)
    errors = re.search(r'ERROR SUMMARY: (\d+) errors from (\d+) contexts', text)
    print(text if errors and errors[1] != '0' else '')
    value = f'{errors[2] if errors else "?"} errors, {lost[1] if lost else "0"} bytes definitely lost'
    figures.keep(27, 'valgrind memcheck of the whole kiosk', value, '0 errors, 0 bytes',
                 bool(errors) and errors[1] == '0' and status == 0,
                 HOW + 'valgrind: touchline --window under Xvfb, 90 s of keys, pictures and a stick, ended by its key; '
                 'errors within libraries suppressed, each with its reason (tests/machines/system/machine/libraries.supp)')


def main():
    figures = Figures(f'{ROOT}/build/reliability/machine.csv')
    for what in sys.argv[2:]:
        {'ticks': ticks, 'lateness': lateness, 'libraries': libraries, 'listing': listing, 'valgrind': valgrind}[what](figures)
    sys.exit(1 if figures.failed else 0)


main()
