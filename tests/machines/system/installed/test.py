"""test.py --image FOLDER --deb FILE --devices FOLDER --work FOLDER --figures FILE --checks FILE [--page FILE] [--short]
[--cuts N] GROUP...: the groups, one machine after the other, and the table, in the page too. Ends with 1 when a check failed."""
import argparse
import importlib
import os
import shutil
import signal
import subprocess
import sys

from kiosk import Kiosk
from machine import Fault, Machine
from table import Table, page, read

GROUPS = ('boot', 'power', 'stick', 'sound', 'keys', 'board', 'camera', 'screen', 'braille', 'idle', 'update')
# Groups in which the kiosk must keep deadlines of milliseconds, or of seconds with much to do.
BY_INSTRUCTIONS = ('board', 'camera')
FILL = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../../lab/bench/fill.awk')


class Bench:
    """What the groups are given: the image, the package, a folder of their own."""

    def __init__(self, arguments):
        self.image = arguments.image
        self.deb = arguments.deb
        self.devices = arguments.devices
        self.work = arguments.work
        self.is_short = arguments.short
        self.cuts = arguments.cuts or (3 if arguments.short else 50)
        self.kiosk = None

    def folder(self, group):
        os.makedirs(f'{self.work}/{group}', exist_ok=True)
        return f'{self.work}/{group}'

    def power(self, group):
        """The power comes, on the overlay that the group has or on a new one; one machine at a time."""
        self.stop()
        folder = self.folder(group)
        self.kiosk = Kiosk(Machine(self.image, f'{folder}/disk.qcow2', folder, group in BY_INSTRUCTIONS))
        return self.kiosk

    def start(self, group, longest_s=400):
        """The kiosk's machine, booted so far that it answers. In the short form one machine serves all groups."""
        if self.is_short and self.kiosk:
            return self.kiosk
        return self.boot(group, longest_s)

    def boot(self, group, longest_s=400):
        kiosk = self.power(group)
        kiosk.machine.run('true', longest_s)
        return kiosk

    def ready(self, table, group, plug_first=None):
        """The kiosk switched on, its first words on the screen; plug_first(machine) before that. Where another group had
        the machine, its visit goes on."""
        with table.check(group, 'boot, READY', True):
            is_under_way = self.is_short and self.kiosk
            kiosk = self.start(group)
            if plug_first:
                plug_first(kiosk.machine)
            kiosk.begin()
            kiosk.wait_ready()
            if is_under_way:
                kiosk.to_choose()
            else:
                kiosk.machine.wait_screen(['Pictures to feel'])
        return kiosk

    def stop(self):
        if self.kiosk:
            self.kiosk.machine.cut()
        self.kiosk = None


def fill(readme, groups, work):
    with open(f'{work}/groups.md', 'w') as file:
        file.write(groups)
    filled = subprocess.run(['awk', '-v', f'tables={work}', '-f', FILL, readme], capture_output=True, check=True).stdout
    with open(readme, 'wb') as file:
        file.write(filled)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ('image', 'deb', 'devices', 'work', 'figures', 'checks'):
        parser.add_argument(f'--{name}', required=True)
    parser.add_argument('--page')
    parser.add_argument('--short', action='store_true')
    parser.add_argument('--cuts', type=int, default=0)
    parser.add_argument('groups', nargs='+', choices=GROUPS)
    arguments = parser.parse_args()
    bench, table = Bench(arguments), Table()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    for group in arguments.groups:
        print(f'{group}:', flush=True)
        shutil.rmtree(f'{bench.work}/{group}', ignore_errors=True)
        try:
            importlib.import_module(group).run(table, bench)
        except Fault as fault:
            table.fail(group, 'the rest of the group', fault)
        except Exception as problem:  # of any kind: a group that broke off has not passed
            table.fail(group, 'the rest of the group', repr(problem))
        except KeyboardInterrupt:  # finished groups count, the others are missing in the table
            break
        finally:
            table.write(arguments.figures, arguments.checks)
        if not bench.is_short:
            bench.stop()
    bench.stop()
    if arguments.page:
        fill(arguments.page, page(read(arguments.checks), GROUPS), arguments.work)
    table.print()
    return 1 if table.failed() else 0


if __name__ == '__main__':
    sys.exit(main())
