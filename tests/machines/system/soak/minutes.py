"""Visits one after the other for so long; every second what the kiosk and its children hold."""

import os
import statistics
import subprocess
import time

import processes
from figures import middle_slope, slope
from world import Kiosk, Visitor, wait_for

SEED = 13
ACTIVE_S = 60.0  # keys and a moving hand, then nobody: the kiosk asks, waits and wipes
REST_S = 75.0
OVER_S = 66.0  # the visit ends after so long without a key (inactivity_s and answer_s of the world)
WARM_UP = 0.2  # share of the whole time
MOST_SLOPE_MB_PER_H = 1.0
PUBLISHED_S = 1200.0  # shorter runs judge no slope, and leave chart and table unchanged
TABLE_STEP_S = 300
COLUMNS = ['time_s', 'phase', 'kiosk_rss_MB', 'kiosk_own_MB', 'servo_own_MB', 'tree_rss_MB', 'tree_own_MB',
           'kiosk_descriptors', 'servo_descriptors', 'kiosk_threads', 'tree_threads', 'children', 'log_bytes']


def sample(kiosk, time_s, phase):
    tree = processes.tree(kiosk.pid)
    memory = {pid: processes.memory_kB(pid) for pid in tree}
    servo = kiosk.world.board.owner
    own, its = memory.get(kiosk.pid, (0, 0)), memory.get(servo, (0, 0))
    return [round(time_s, 2), phase, own[0] / 1024, own[1] / 1024, its[1] / 1024,
            sum(rss for rss, _ in memory.values()) / 1024, sum(anonymous for _, anonymous in memory.values()) / 1024,
            processes.descriptors(kiosk.pid), processes.descriptors(servo), tree[kiosk.pid]['threads'],
            sum(stat['threads'] for stat in tree.values()), len(tree) - 1, os.path.getsize(kiosk.log_path)]


def phase_of(time_s):
    within = time_s % (ACTIVE_S + REST_S)
    if within < ACTIVE_S:
        return 'visit'
    return 'over' if within > ACTIVE_S + OVER_S else 'ending'


def watch(world, kiosk, span_s):
    """A row a second, written as it comes."""
    visitor = Visitor(kiosk, SEED)
    begin, rows = time.monotonic(), []
    with open(f'{world.root}/build/reliability/soak/samples.csv', 'w', encoding='ascii') as file:
        file.write(','.join(COLUMNS) + '\n')
        while (time_s := time.monotonic() - begin) < span_s and kiosk.starts == 1:
            phase = phase_of(time_s)
            is_visit = phase == 'visit'
            world.board.move_hand(is_visit)
            (visitor.rests.clear if is_visit else visitor.rests.set)()
            rows.append(sample(kiosk, time_s, phase))
            file.write(','.join(f'{cell:.3f}' if isinstance(cell, float) else str(cell) for cell in rows[-1]) + '\n')
            file.flush()
            time.sleep(max(0.0, begin + len(rows) - time.monotonic()))
    visitor.end()
    return rows


def run(world, figures, span_s):
    os.makedirs(f'{world.root}/build/reliability/soak', exist_ok=True)
    world.start_bus()
    world.make_stick()
    kiosk = Kiosk(world)
    wait_for('ready', kiosk.is_ready)
    world.plug_stick(0)
    rows = watch(world, kiosk, span_s)
    starts, log_bytes = kiosk.starts, os.path.getsize(kiosk.log_path)
    status, _ = kiosk.end()
    report(figures, rows, span_s, {'starts': starts, 'status': status, 'log_bytes': log_bytes})
    if span_s >= PUBLISHED_S:
        publish(world, rows, span_s)


def column(rows, name):
    return [row[COLUMNS.index(name)] for row in rows]


def report(figures, rows, span_s, end):
    how = (f'tests/machines/system/soak/run minutes {span_s / 60:.0f}: visits of {ACTIVE_S:.0f} s and nobody for {REST_S:.0f} s, '
           f'a sample a second, the first fifth left out, median of the slopes of all pairs of samples, '
           'beside it least squares with its standard error')
    warm = [row for row in rows if row[0] >= WARM_UP * span_s]
    over = [row for row in warm if row[1] == 'over']
    is_long = span_s >= PUBLISHED_S and len(over) > 20
    bar = f'< {MOST_SLOPE_MB_PER_H:.0f}' if is_long else 'reported: too short to judge'
    for name, of, part in (('kiosk_own_MB', 'the kiosk between visits', over), ('servo_own_MB', 'the servo', warm),
                           ('kiosk_rss_MB', 'the kiosk between visits, Rss', over), ('tree_own_MB', 'all processes', warm)):
        hours = [row[0] / 3600 for row in part]
        rise, error = slope(hours, column(part, name))
        middle = middle_slope(hours[::5], column(part, name)[::5])
        is_judged = is_long and name in ('kiosk_own_MB', 'servo_own_MB')
        figures.keep(21, f'memory slope of {of}, MB/h', f'{middle:.2f} (least squares {rise:.2f} +- {error:.2f})', bar if is_judged else 'reported',
                     middle < MOST_SLOPE_MB_PER_H if is_judged else None, how)
    figures.keep(21, 'own memory of all processes (anonymous pages), MB', f'{statistics.median(column(warm, "tree_own_MB")):.0f} median, '
                 f'{max(column(warm, "tree_own_MB")):.0f} worst', 'reported', None, how)
    quiet = over or warm
    for name, words in (('kiosk_descriptors', 'descriptors of the kiosk'), ('servo_descriptors', 'descriptors of the servo'),
                        ('kiosk_threads', 'threads of the kiosk')):
        # The least counts: a visitor leaves one picture or another, and what is kept of it has its
        # own descriptors.
        first, last = (min(column(part, name)) for part in halves(quiet))
        figures.keep(21, f'{words} between visits, least of the first half and of the second', f'{first}, {last}',
                     'equal' if over else 'reported', first == last if over else None, how)
    figures.keep(21, 'log, bytes in all', end['log_bytes'], '< 100 kB a day', end['log_bytes'] < 1e5 * max(span_s, 3600) / 86400, how)
    figures.keep(21, 'minutes in which it ran on', f'{rows[-1][0] / 60:.1f}', f'{span_s / 60:.1f}, one start, status 0',
                 end['starts'] == 1 and end['status'] == 0, how)


def halves(rows):
    middle = (len(rows) + 1) // 2
    return rows[:middle], rows[-middle:]


def tabulate(rows, span_s):
    """A line for each five minutes: what lay in between."""
    lines = ['| minutes | kiosk own, MB | servo own, MB | all processes own, MB: median, worst | descriptors of the kiosk, worst | '
             'threads of the kiosk, worst | children, worst |', '|---|---|---|---|---|---|---|']
    for begin in range(0, int(span_s), TABLE_STEP_S):
        part = [row for row in rows if begin <= row[0] < begin + TABLE_STEP_S]
        tree = column(part, 'tree_own_MB')
        lines.append(f'| {begin // 60} to {(begin + TABLE_STEP_S) // 60} | {statistics.median(column(part, "kiosk_own_MB")):.0f} | '
                     f'{statistics.median(column(part, "servo_own_MB")):.0f} | {statistics.median(tree):.0f}, {max(tree):.0f} | '
                     f'{max(column(part, "kiosk_descriptors"))} | {max(column(part, "kiosk_threads"))} | '
                     f'{max(column(part, "children"))} |')
    return '\n'.join(lines) + '\n'


def publish(world, rows, span_s):
    """The chart, and the table of README.md."""
    here, folder = f'{world.root}/tests/machines/system/soak', f'{world.root}/build/reliability/soak'
    os.makedirs(f'{here}/results', exist_ok=True)
    subprocess.run(['gnuplot', '-e', f"samples='{folder}/samples.csv'; chart='{here}/results/memory.svg'",
                    f'{here}/memory.gnuplot'], check=True)
    with open(f'{folder}/minutes.md', 'w', encoding='ascii') as file:
        file.write(tabulate(rows, span_s))
    filled = subprocess.run(['awk', '-v', f'tables={folder}', '-f', f'{world.root}/tests/lab/bench/fill.awk', f'{here}/README.md'],
                            capture_output=True, text=True, check=True).stdout
    with open(f'{here}/README.md', 'w', encoding='utf-8') as file:
        file.write(filled)
