"""Half an hour in which nobody comes: the screen stays lit."""
from kiosk import X
from machine import wait_for

MINUTES = 30


def run(table, bench):
    kiosk = bench.ready(table, 'idle')
    machine = kiosk.machine
    with table.check('idle', f'lit after {MINUTES} minutes without a key, by the clock of the machine') as note:
        began = _up_s(machine)
        wait_for(lambda: _up_s(machine) >= began + 60 * MINUTES, 4 * 60 * MINUTES, 'half an hour', 20)
        machine.wait_screen(['Pictures to feel'])
        machine.said(f'{X} xset q | grep -q "Monitor is On" || ! {X} xset q | grep -q "DPMS is Enabled"')
        note(f'{_up_s(machine) - began} s')


def _up_s(machine):
    return int(machine.said('cut -d. -f1 /proc/uptime'))
