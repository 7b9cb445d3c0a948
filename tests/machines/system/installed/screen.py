"""The screen is never dark, and no key leads out of the kiosk."""
from kiosk import X
from machine import Fault


def run(table, bench):
    kiosk = bench.ready(table, 'screen')
    machine = kiosk.machine
    with table.check('screen', 'no blanking, no saver, no power saving, by what the X server says'):
        said = machine.said(f'{X} xset q')
        if 'timeout:  0' not in said:
            raise Fault(f'the saver has a time: {said}')
        if 'DPMS is Enabled' in said:
            raise Fault(f'power saving is on: {said}')
    with table.check('screen', 'Ctrl, Alt and F2, or Backspace, or Delete lead nowhere'):
        process = kiosk.process()
        for key in ('f2', 'f3', 'backspace', 'delete'):
            machine.ask('send-key', keys=[{'type': 'qcode', 'data': name} for name in ('ctrl', 'alt', key)],
                        **{'hold-time': 200})
        machine.said('sleep 5')
        if machine.said('cat /sys/class/tty/tty0/active') != 'tty7':
            raise Fault(f'the screen is on {machine.said("cat /sys/class/tty/tty0/active")}')
        if kiosk.process() != process or not machine.holds('systemctl is-system-running | grep -qv stopping'):
            raise Fault('the kiosk was left or the machine goes down')
