"""A newer package from an operator's stick, without a network, under a running kiosk."""
import os
import shutil
import subprocess

import sticks
from kiosk import FIRST_SETTINGS, SETTINGS
from machine import Fault

NEWER = '99.0'


def newer(deb, folder):
    """The same package with a later version."""
    parts = f'{folder}/parts'
    shutil.rmtree(parts, ignore_errors=True)
    subprocess.run(['fakeroot', 'sh', '-c', f'dpkg-deb -R {deb} {parts} && '
                    f'sed -i "s/^Version:.*/Version: {NEWER}/" {parts}/DEBIAN/control && '
                    f'dpkg-deb -b {parts} {folder}/stick/touchline.deb'], check=True, stdout=subprocess.DEVNULL)
    shutil.rmtree(parts)


def run(table, bench):
    folder = bench.folder('update')
    with table.check('update', 'boot, READY', True):
        os.makedirs(f'{folder}/stick')
        newer(bench.deb, folder)
        sticks.make_fat(f'{folder}/FAT', f'{folder}/stick')
        kiosk = bench.start('update')
        machine = kiosk.machine
        kiosk.begin()
        kiosk.wait_ready()
    with table.check('update', 'installed from a stick without a network: the new version READY, settings kept') as note:
        process = kiosk.process()
        machine.said('! ip route 2>/dev/null | grep -q default')
        plugged = machine.plug_stick(f'{folder}/FAT')
        machine.wait('ls /dev/sda1', 120)
        machine.said('mkdir -p /run/stick && mount -o ro /dev/sda1 /run/stick && '
                     'dpkg -i /run/stick/touchline.deb && umount /run/stick', 600)
        machine.pull_stick(plugged)
        note(f'READY {kiosk.wait_ready(process):.0f} s after')
        version = machine.said("dpkg-query -W -f '${Status} ${Version}' touchline")
        if version != f'install ok installed {NEWER}':
            raise Fault(version)
        if machine.said(f'cat {SETTINGS}').strip() != FIRST_SETTINGS.strip():
            raise Fault('the settings are others')
    with table.check('update', 'no unit has failed'):
        failed = machine.said('systemctl --failed --no-legend --plain')
        if failed:
            raise Fault(failed)
