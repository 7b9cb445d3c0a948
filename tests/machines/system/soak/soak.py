"""tests/machines/system/soak/run, in its namespaces: soak.py ROOT [--short | minutes N | kills N [BUSY] | plugs N | missing]."""

import os
import signal
import sys
import time

import kills
import minutes
import missing
import plugs
from figures import Figures
from world import Failed, World


def run(root, words):
    figures = Figures(f'{root}/build/reliability/soak.csv')
    what = words[0] if words else '--short'
    count = int(words[1]) if len(words) > 1 else 0
    busy = int(words[2]) if len(words) > 2 else 0
    parts = {'missing': [lambda world: missing.run(world, figures)],
             'minutes': [lambda world: minutes.run(world, figures, 60.0 * count)],
             'kills': [lambda world: kills.run(world, figures, count, busy)],
             'plugs': [lambda world: plugs.run(world, figures, count)],
             '--short': [lambda world: missing.run_short(world, figures),
                         lambda world: kills.run(world, figures, 8),
                         lambda world: plugs.run(world, figures, 4),
                         lambda world: minutes.run(world, figures, 40.0)]}[what]
    if what == '--short':
        figures.path = f'{root}/build/reliability/short/soak.csv'
        os.makedirs(os.path.dirname(figures.path), exist_ok=True)
    for number, part in enumerate(parts):
        world = World(root, f'{root}/build/reliability/{what.strip("-")}-{number}')
        try:
            part(world)
        finally:
            world.close()
    return figures.failed


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    begin = time.monotonic()
    try:
        failed = run(sys.argv[1], sys.argv[2:])
    except Failed as problem:
        failed = [str(problem)]
    for line in failed:
        print('failed: ' + line)
    print(f'{"failed" if failed else "passed"} after {time.monotonic() - begin:.0f} s, load {os.getloadavg()[0]:.1f}')
    sys.exit(1 if failed else 0)


main()
