"""From power to READY under the real units; killed, hung, and back; nothing else has failed."""
import random

from kiosk import FIRST_SETTINGS, SETTINGS, UNIT
from machine import Fault


def same_settings(machine):
    return machine.said(f'cat {SETTINGS}').strip() == FIRST_SETTINGS.strip()


def run(table, bench):
    with table.check('boot', 'from power to the agent', True):
        kiosk = bench.start('boot')
    machine = kiosk.machine
    with table.check('boot', 'READY under systemd, after the operator switched it on', True) as note:
        kiosk.begin()
        note(f'{kiosk.wait_ready():.0f} s')
    with table.check('boot', 'the screen says the first words'):
        machine.wait_screen(['Pictures to feel'])
    with table.check('boot', 'runs as its own user, in its own unit, fed to a watchdog of 10 s'):
        machine.said(f'systemctl cat {UNIT} | grep -qx WatchdogSec=10')
        machine.said(f'[[ $(stat -c %U /proc/{kiosk.process()}) == touchline ]]')
        fed = f'systemctl show -P WatchdogTimestampMonotonic {UNIT}'
        first = machine.said(fed)
        machine.wait(f'[[ $({fed}) != {first} ]]', 180, 'the watchdog is fed')
    with table.check('boot', 'memory is not limited in locking and never swapped; no memory left ends a worker, not the kiosk'):
        _limits(machine)
    with table.check('boot', 'no login on a spare terminal, no SysRq'):
        _closed(machine)
    _killed(table, kiosk, 1 if bench.is_short else 10)
    if not bench.is_short:
        with table.check('boot', 'stopped (SIGSTOP): the watchdog ends it, READY again'):
            process = kiosk.process()
            machine.said(f'kill -STOP {process}')
            kiosk.wait_ready(process)
            machine.said(f'journalctl -u {UNIT} -o cat | grep -qi watchdog')
    with table.check('boot', 'still no login and no SysRq; switched off: both are back, as they were'):
        _closed(machine)
        machine.said(f'systemctl stop {UNIT}', 240)
        machine.wait('[[ $(cat /proc/sys/kernel/sysrq) != 0 ]] && systemctl is-active -q getty@tty1', 120, 'they are back')
        machine.said(f'systemctl start --no-block {UNIT}')
        kiosk.wait_ready()
    with table.check('boot', 'settings are kept'):
        if not same_settings(machine):
            raise Fault('the settings are others')
    with table.check('boot', 'no unit has failed'):
        failed = machine.said('systemctl --failed --no-legend --plain')
        if failed:
            raise Fault(failed)


def _limits(machine):
    for unit in (UNIT, 'touchline-servo@test.service'):
        said = machine.said(f'systemctl show -p LimitMEMLOCK -p MemorySwapMax -p OOMPolicy {unit}').split()
        if sorted(said) != ['LimitMEMLOCK=infinity', 'MemorySwapMax=0', 'OOMPolicy=continue']:
            raise Fault(f'{unit}: {said}')
    machine.said(f'[[ $(cat /sys/fs/cgroup$(systemctl show -P ControlGroup {UNIT})/memory.swap.max) == 0 ]]')


def _closed(machine):
    machine.said('[[ $(cat /proc/sys/kernel/sysrq) == 0 ]]')
    machine.said('systemctl start getty@tty1 autovt@tty3; ! systemctl is-active -q getty@tty1 && ! pgrep -a agetty | grep -q tty[1-9]')


def _killed(table, kiosk, times):
    """kill -9 at random moments after READY; each time it has to come back."""
    seconds = []
    moments = random.Random(11)
    with table.check('boot', f'killed (SIGKILL) {times} times at random moments, READY again') as note:
        for _ in range(times):
            process = kiosk.process()
            kiosk.machine.said(f'sleep {moments.uniform(0, 3):.2f}; kill -KILL {process}')
            seconds.append(kiosk.wait_ready(process))
        note(f'{min(seconds):.0f} to {max(seconds):.0f} s, emulated')
    table.figure(20, 'kill -9 in the guest: came back', f'{len(seconds)} of {times}', 'all', len(seconds) == times,
                 f'installed package under its units; time to READY at most {max(seconds, default=0):.0f} s, emulated CPU')
