"""Sticks as visitors bring them, plugged into a running kiosk, browsed, pulled; not a byte of them changes."""
import os
import shutil

import sticks
from kiosk import FIRST_SETTINGS, UNIT
from machine import Fault

# To the kernel, `ntfs` by ntfs-3g is fuseblk.
KINDS = {'FAT': sticks.make_fat, 'ext4': sticks.make_ext4, 'NTFS': sticks.make_ntfs, 'exFAT': None}
OURS = 'findmnt -rno FSTYPE,OPTIONS,TARGET | grep /media/'


def _make(machine, folder, is_short):
    """(name, file, sum of its bytes) of each stick."""
    files = sticks.make_files(f'{folder}/files')
    made = []
    for kind, make in list(KINDS.items())[:1 if is_short else None]:
        for is_dirty in (False,) if is_short else (False, True):
            file = f'{folder}/{kind}{"-dirty" if is_dirty else ""}'
            if make:
                make(file, files, is_dirty)
            else:
                sticks.make_exfat(machine, file, f'{folder}/ext4', is_dirty)
            made.append((f'{kind}{", not unmounted" if is_dirty else ""}', file, sticks.sha256(file)))
    return made


def run(table, bench):
    folder = bench.folder('stick')
    with table.check('stick', 'boot, READY', True):
        kiosk = bench.start('stick')
        machine = kiosk.machine
        made = _make(machine, folder, bench.is_short)
        kiosk.begin()
        kiosk.wait_ready()
        process = kiosk.process()
        kiosk.to_choose()
    if not bench.is_short:
        with table.check('stick', 'ext4 is told and not mounted before the operator allows it'):
            _refused(kiosk, f'{folder}/ext4')
    kiosk.put_settings(f'{FIRST_SETTINGS}[stick]\nmore_file_systems = true\n')
    for name, file, _ in made:
        _visit(table, kiosk, name, file)
    if not bench.is_short:
        for phase, name in PHASES.items():
            with table.check('stick', f'pulled {name}'):
                _pulled(kiosk, folder, phase)
    with table.check('stick', 'the kiosk is the same process, and none of its workers is left'):
        if kiosk.process() != process:
            raise Fault(f'it was started again: {machine.run(f"journalctl -u {UNIT} -n 5 -o cat")[1]}')
        machine.wait('! pgrep "^touchline-(impor|decod)"', 60)
    changed = [name for name, file, bytes_of in made if sticks.sha256(file) != bytes_of]
    with table.check('stick', 'not a byte of a stick has changed'):
        if changed:
            raise Fault(f'changed: {changed}')
    table.figure(17, 'sticks of the guest whose bytes changed', len(changed), '0', not changed,
                 f'sha256 before and after of {len(made)} sticks: {", ".join(name for name, _, _ in made)}')
    passed, all_of = table.passed_of('stick')
    table.figure(16, 'stick cases in the guest: passed', f'{passed} of {all_of}', 'all', passed == all_of,
                 'installed package, real kernel, udisks2, emulated USB sticks')


def _wait_gone(machine):
    machine.wait(f'! {OURS}', 120, 'nothing of the stick is mounted')


def _refused(kiosk, file):
    machine = kiosk.machine
    plugged = machine.plug_stick(file)
    try:
        machine.wait_screen(['format is not read here'])
        if machine.holds(OURS):
            raise Fault(f'mounted: {machine.said(OURS)}')
    finally:
        machine.pull_stick(plugged)
    kiosk.to_choose()


def _visit(table, kiosk, name, file):
    """From plugging in to pulling out."""
    with table.check('stick', f'{name}: mounted read only, listed, pulled, unmounted'):
        plugged = _plug(kiosk, file)
        try:
            with table.check('stick', f'{name}: a PNG and a PDF open') as note:
                png = kiosk.open_stick(sticks.PNG)
                kiosk.to_choose()
                note(f'asked {png} and {kiosk.open_stick(sticks.PDF)} times')
        finally:
            kiosk.machine.pull_stick(plugged)
        _wait_gone(kiosk.machine)
        kiosk.to_choose()


def _plug(kiosk, file, reads_a_s=0):
    """Until the kiosk tells how many pictures the stick has."""
    machine = kiosk.machine
    plugged = machine.plug_stick(file, reads_a_s)
    try:
        machine.wait(OURS, 240, 'the stick is mounted')
        options = machine.said(OURS).split()[1].split(',')
        for option in ('ro', 'nosuid', 'nodev', 'noexec'):
            if option not in options:
                raise Fault(f'mounted without {option}: {options}')
        kiosk.to_choose()
        kiosk.to_item('Your USB stick, 2 pictures')
    except Fault:
        machine.pull_stick(plugged)
        _wait_gone(machine)
        raise
    return plugged


PHASES = {'mount': 'while it is mounted', 'list': 'while it is listed', 'read': 'while a file is read',
          'felt': 'while its picture is felt'}
SLOW_READS_A_S = 20  # so that its list takes all the allowed time, and a large file some seconds
# Uses only builtins: in an emulated machine a program that looks is too slow to catch a short one.
IMPORT_IS_THERE = """while sleep 0.1; do
    for of in /proc/[0-9]*/comm; do
        read -r name 2>/dev/null <"$of" && [[ $name == touchline-impor ]] && exit 0
    done
done"""


def _pulled(kiosk, folder, phase):
    """Pulled at a phase; then the next stick works."""
    machine = kiosk.machine
    file = f'{folder}/pulled'
    if phase == 'list':
        sticks.make_fat(file, sticks.make_many_folders(f'{folder}/many'))
    elif phase == 'read':
        sticks.make_fat(file, sticks.make_files(f'{folder}/large', is_large=True))
    else:
        shutil.copy(f'{folder}/FAT', file)
    machine.pull_stick(_plug_until(kiosk, file, phase))
    _wait_gone(machine)
    os.remove(file)
    kiosk.to_choose()
    machine.pull_stick(_plug(kiosk, f'{folder}/FAT'))
    _wait_gone(machine)


def _plug_until(kiosk, file, phase):
    """Returns in the midst of that phase."""
    machine = kiosk.machine
    if phase == 'mount':
        plugged = machine.plug_stick(file)
        machine.said('until ls /sys/block/sd? >/dev/null 2>&1; do :; done')
    elif phase == 'list':
        plugged = machine.plug_stick(file, SLOW_READS_A_S)
        machine.said(IMPORT_IS_THERE)
    else:
        plugged = _plug(kiosk, file, SLOW_READS_A_S if phase == 'read' else 0)
        if phase == 'felt':
            kiosk.open_stick(sticks.PNG)
        else:
            kiosk.ask_stick(sticks.PNG)
            machine.said(IMPORT_IS_THERE)
    return plugged
