"""A keypad that is plugged in while the kiosk runs leads the visit."""
from machine import Fault


def run(table, bench):
    kiosk = bench.ready(table, 'keys')
    machine = kiosk.machine
    with table.check('keys', 'a USB keypad is plugged in and noticed by the X server', True):
        machine.ask('device_add', driver='usb-kbd', id='keypad', bus='xhci.0')
        machine.wait('grep -q "QEMU USB Keyboard" /proc/bus/input/devices', 120)
        machine.wait('grep -q "QEMU USB Keyboard" /var/log/Xorg.0.log', 120)
    with table.check('keys', 'its keys begin a visit and lead it to the settings and back'):
        handler = machine.said('grep -A6 "QEMU USB Keyboard" /proc/bus/input/devices | grep -o "event[0-9]*" | head -1')
        machine.said(f'systemd-run -q --unit=pad bash -c "cat /dev/input/{handler} >/run/pad"')
        kiosk.to_choose()
        kiosk.to_item('Settings')
        kiosk.press('ret')
        machine.wait_screen(['Volume'])
        kiosk.press('left')
        machine.wait_screen(['What to feel'])
        if int(machine.said('wc -c </run/pad')) == 0:
            raise Fault('the keys came from another keyboard')
    with table.check('keys', 'pulled out: the kiosk goes on, another keyboard leads'):
        process = kiosk.process()
        machine.ask('device_del', id='keypad')
        machine.wait('! grep -q "QEMU USB Keyboard" /proc/bus/input/devices', 120)
        kiosk.to_item('Finish')
        if kiosk.process() != process:
            raise Fault('the kiosk was started again')
