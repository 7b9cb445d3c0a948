"""Half an hour in which nobody comes: the screen stays lit."""
import time

from kiosk import X
from machine import Fault

MINUTES = 30


def run(table, bench):
    kiosk = bench.ready(table, 'idle')
    machine = kiosk.machine
    with table.check('idle', f'lit after {MINUTES} minutes without a key') as note:
        began = _up_s(machine)
        # The test asks nothing of it meanwhile.
        time.sleep(60 * MINUTES + 10)
        machine.wait_screen(['Pictures to feel'])
        machine.said(f'{X} xset q | grep -q "Monitor is On" || ! {X} xset q | grep -q "DPMS is Enabled"')
        passed = _up_s(machine) - began
        note(f'{passed} s by the clock of the machine')
        if passed < 60 * MINUTES:
            raise Fault('the clock of the machine is slow')


def _up_s(machine):
    return int(machine.said('cut -d. -f1 /proc/uptime'))
