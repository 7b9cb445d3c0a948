"""A kiosk that lacks something: it runs on, feels a picture, answers, and says one line for what is missing."""

import ctypes
import mmap
import os
import signal
import struct
import subprocess
import time

from world import HARMLESS, Failed, Kiosk, lines_about, wait_for

TO_A_PICTURE = ['Return', 'Return', 'Return']  # language, practice or gallery, its first picture
LONGEST_END_S = 4.0
YEAR_S = 365 * 86400


def feel_a_picture(kiosk):
    """Until there is torque: keys, loading, tracing, servo and hand all work."""
    kiosk.world.board.move_hand(True)

    def is_felt():
        if kiosk.world.board.has_torque:
            return True
        kiosk.press(*TO_A_PICTURE)
        return False
    wait_for('a picture that is felt', is_felt, every_s=0.5)


def quit_by_key(kiosk):
    """It still answers: the staff's key and a yes end it."""
    kiosk.is_wanted = False

    def has_ended():
        kiosk.press('q', 'Down', 'Return')
        return kiosk.process.poll() is not None
    wait_for('the end by its key', has_ended, every_s=0.2)
    return kiosk.end()[0]


def lack(world, figures, what, pattern, settings=None, before=(), has_board=True, act=None):
    """One start without `what`. `pattern`: of its one line; none: nothing is to be said."""
    kiosk = Kiosk(world, settings, before, has_board, log=f'missing-{what.split()[0]}.log')
    try:
        wait_for(f'ready without {what}', kiosk.is_ready)
        if has_board:
            feel_a_picture(kiosk)
        if act:
            act(kiosk)
        if pattern:
            wait_for(f'a line about {what}', lambda: lines_about(pattern, kiosk.log()))
        status = quit_by_key(kiosk)
        text = kiosk.log()
        told = lines_about(pattern, text) if pattern else []
        others = [line for line in text.splitlines() if line not in told]
        runs_on = kiosk.starts == 1 and status == 0
        is_told = len(told) == 1 if pattern else True
        value = ('runs on' if runs_on else f'ended with {kiosk.ends}')
        value += f', says: {told[0].replace(world.root + "/", "")}' if told else ', nothing to say'
        for line in others:
            print('    beside it: ' + line)
        figures.keep(21, f'missing: {what}', value, 'runs on, one clear line' if pattern else 'runs on',
                     runs_on and is_told and not others and not world.board.has_torque,
                     'tests/machines/system/soak/run missing: started without it under Xvfb' +
                     (', a picture felt with torque' if has_board else '') + ', ended by its key')
    finally:
        kiosk.end(signal.SIGKILL)


def full_disk(world):
    place = f'{world.folder}/full'
    os.makedirs(place)
    subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=64k', 'none', place], check=True)
    with open(f'{place}/kiosk.toml', 'w', encoding='ascii') as file:
        file.write('[time]\ninactivity_s = 30\nanswer_s = 30\n')
    with open(f'{place}/filling', 'wb', buffering=0) as file:
        try:
            while file.write(bytes(512)):
                pass
        except OSError:
            pass
    return {'TOUCHLINE_SETTINGS': f'{place}/kiosk.toml', 'TOUCHLINE_RECORDINGS': place, 'TMPDIR': place, 'HOME': place}


class SteppedClock:
    """The wall clock of the programs that have the library before them (tests/app/force/servo/stepped_clock.h)."""

    def __init__(self, world):
        path = '/dev/shm/clock'
        with open(path, 'wb') as file:
            file.write(bytes(16))
        with open(path, 'r+b') as file:
            self.memory = mmap.mmap(file.fileno(), 16)
        self.settings = {'LD_PRELOAD': f'{world.root}/build/release/tests/app/force/servo/libstepped_clock.so',
                         'TOUCHLINE_STEPPED_CLOCK': path}

    def step(self, by_s):
        struct.pack_into('q', self.memory, 0, by_s * 10**9)

    def jump(self, kiosk):
        for by_s in (3600, -7200, YEAR_S, -10 * YEAR_S, 0):
            reads = struct.unpack_from('Q', self.memory, 8)[0]
            ticks = kiosk.world.board.ticks_for(kiosk.pid)
            self.step(by_s)
            wait_for('a look at the clock', lambda r=reads: struct.unpack_from('Q', self.memory, 8)[0] > r)
            wait_for('ticks after a jump', lambda t=ticks: kiosk.world.board.ticks_for(kiosk.pid) > t + 1000)
        feel_a_picture(kiosk)


def hung_display(world, figures):
    """SIGTERM ends it within four seconds, the torque at zero, though its main thread hangs in the display."""
    kiosk = Kiosk(world, log='missing-display.log')
    try:
        wait_for('ready', kiosk.is_ready)
        feel_a_picture(kiosk)
        world.display.send_signal(signal.SIGSTOP)
        status, took_s = kiosk.end()
        world.display.send_signal(signal.SIGCONT)
        wait_for('zero torque', lambda: not world.board.has_torque)
        told = lines_about('something hangs', kiosk.log())
        figures.keep(21, 'end on SIGTERM while the display hangs, s', f'{took_s:.1f}', f'<= {LONGEST_END_S:.0f}, torque zero',
                     took_s <= LONGEST_END_S and status == 1 and len(told) == 1,
                     'tests/machines/system/soak/run missing: Xvfb stopped while a picture is felt, then SIGTERM')
    finally:
        world.display.send_signal(signal.SIGCONT)
        kiosk.end(signal.SIGKILL)


def no_network_is_there():
    with open('/proc/net/route', encoding='ascii') as file:
        if len(file.readlines()) > 1:
            raise Failed('this namespace has a network')


def run(world, figures):
    no_network_is_there()
    world.start_bus()
    lack(world, figures, 'network', None)
    lack(world, figures, 'sound', 'there is no sound: ', {'SDL_AUDIODRIVER': 'none'})
    lack(world, figures, 'camera', 'there is no camera: ', {'TOUCHLINE_CAMERA': None})
    lack(world, figures, 'device', 'there is no pantograph: ', has_board=False)
    lack(world, figures, 'bus of udisks2', 'USB sticks are not offered: ',
         {'DBUS_SYSTEM_BUS_ADDRESS': f'unix:path={world.folder}/nowhere'})
    lack(world, figures, 'room on the disk', 'nothing can be kept in ', full_disk(world))
    lack(world, figures, 'disk that may be written (all read-only)', 'nothing can be kept in ',
         before=['unshare', '--mount', 'sh', '-c', 'mount -o remount,bind,ro / && exec "$0"'])
    clock = SteppedClock(world)
    lack(world, figures, 'steady wall clock (steps of an hour to ten years)', None, clock.settings, act=clock.jump)
    hung_display(world, figures)


def run_short(world, figures):
    """Those that the short run has time for."""
    no_network_is_there()
    world.start_bus()
    lack(world, figures, 'sound', 'there is no sound: ', {'SDL_AUDIODRIVER': 'none'})
    lack(world, figures, 'room on the disk', 'nothing can be kept in ', full_disk(world))
    hung_display(world, figures)
