"""The world of one kiosk: display, bus, sticks, board, and whoever starts it again when it dies."""

import os
import random
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time

import processes
from board import Board

LONGEST_WAIT_S = 120.0  # for what must come at some time; only a broken kiosk reaches it
HARMLESS = 'b'  # error boxes of the live view: the first key after the window appears may be lost


class Failed(Exception):
    """What the run is to end with: one line."""


def wait_for(what, is_so, longest_s=LONGEST_WAIT_S, every_s=0.02):
    """Seconds until it was so."""
    begin = time.monotonic()
    while not (answer := is_so()):
        if time.monotonic() - begin > longest_s:
            raise Failed(f'{what}: not within {longest_s:.0f} s')
        time.sleep(every_s)
    del answer
    return time.monotonic() - begin


def reap_orphans():
    """What a dead kiosk had started is ours to bury: this is process 1 of its namespace. A corpse would count as alive
    for whoever asks by its number. The others have a Popen that waits for them."""
    while True:
        for pid in processes.corpses_of(os.getpid()):
            os.waitpid(pid, os.WNOHANG)
        time.sleep(0.005)


class World:
    """Everything lies in `folder`; the PID namespace is ours alone."""

    def __init__(self, root, folder):
        self.root, self.folder = root, folder
        self.programs = f'{root}/build/release/app/main'
        self.kiosk_program = f'{root}/build/release/tests/machines/system/soak_kiosk'
        shutil.rmtree(folder, ignore_errors=True)
        for name in ('person', 'kept', 'temporary', 'camera'):
            os.makedirs(f'{folder}/{name}')
        for place in (f'{tempfile.gettempdir()}/.X11-unix', '/media', '/dev/shm'):
            os.makedirs(place, exist_ok=True)
            subprocess.run(['mount', '-t', 'tmpfs', 'none', place], check=True)
        shutil.copy(f'{root}/app/documents/gallery/all-pictures.png', f'{folder}/camera/table.png')
        self.board = Board('/dev/shm/board')
        self.environment = {
            'PATH': os.environ['PATH'], 'HOME': f'{folder}/person', 'TMPDIR': f'{folder}/temporary',
            'LP_NUM_THREADS': '1', 'SDL_AUDIODRIVER': 'dummy', 'LANG': 'C.UTF-8',
            'TOUCHLINE_PROGRAMS': self.programs, 'TOUCHLINE_GALLERY': f'{root}/app/documents/gallery/pictures',
            'TOUCHLINE_SETTINGS': f'{folder}/person/kiosk.toml', 'TOUCHLINE_RECORDINGS': f'{folder}/kept',
            'TOUCHLINE_CAMERA': f'{folder}/camera', 'TOUCHLINE_SOAK_BOARD': self.board.path,
            'DBUS_SYSTEM_BUS_ADDRESS': f'unix:path={folder}/bus'}
        with open(f'{folder}/person/kiosk.toml', 'w', encoding='ascii') as file:
            file.write('[time]\ninactivity_s = 30\nanswer_s = 30\n')
        threading.Thread(target=reap_orphans, daemon=True).start()
        self.start_display()
        self.bus = self.service = None

    def start_display(self):
        reading, writing = os.pipe()
        self.display = subprocess.Popen(
            ['Xvfb', '-displayfd', str(writing), '-screen', '0', '800x600x24', '-nolisten', 'tcp', '-noreset', '-r'],
            pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if not number:
            raise Failed('Xvfb did not start')
        self.environment['DISPLAY'] = ':' + number

    def start_bus(self):
        """A bus with the udisks2 of tests/app/documents/sticks on it."""
        nothing = {'stdout': subprocess.DEVNULL, 'stderr': subprocess.DEVNULL}
        address = self.environment['DBUS_SYSTEM_BUS_ADDRESS']
        self.bus = subprocess.Popen(
            ['dbus-daemon', '--session', '--nofork', '--nopidfile', '--address=' + address], **nothing)
        wait_for('the bus', lambda: os.path.exists(f'{self.folder}/bus'))
        self.service = subprocess.Popen(
            ['/usr/bin/python3', '-B', '-m', 'dbusmock', '--system', '--template',
             f'{self.root}/tests/app/documents/sticks/udisks_mock.py'],
            env=dict(os.environ, DBUS_SYSTEM_BUS_ADDRESS=address), **nothing)
        import dbus.bus  # of python3-dbusmock
        connection = dbus.bus.BusConnection(address)
        wait_for('udisks2', lambda: connection.name_has_owner('org.freedesktop.UDisks2'))
        drives = connection.get_object('org.freedesktop.UDisks2', '/org/freedesktop/UDisks2')
        self.udisks = dbus.Interface(drives, 'org.freedesktop.DBus.Mock')

    def make_stick(self, name='sdb1'):
        """Pictures of several kinds, a document, and two that nobody can feel."""
        place = f'/media/{name}'
        os.makedirs(place)
        gallery = f'{self.root}/app/documents/gallery/pictures'
        for picture in sorted(os.listdir(gallery))[:4]:
            if picture.endswith('.svg'):
                shutil.copy(f'{gallery}/{picture}', place)
        shutil.copy(f'{self.root}/app/screen/screen-of-a-fish.png', f'{place}/fish.png')
        pages = [f'{gallery}/{name}' for name in sorted(os.listdir(gallery)) if name.endswith('.svg')][:3]
        subprocess.run(['rsvg-convert', '-f', 'pdf', '-o', f'{place}/book.pdf', *pages], check=True)
        with open(f'{place}/broken.png', 'wb') as file:
            file.write(b'\x89PNG\r\n\x1a\n' + b'nothing' * 100)

    def plug_stick(self, serial, name='sdb1'):
        """`serial`: another one each time."""
        self.udisks.Plug(name, f'stick{serial}', 'usb', 'vfat', 10 + serial, 'good')

    def pull_stick(self, serial, name='sdb1'):
        self.udisks.Pull(name, f'stick{serial}')

    def files(self):
        """All that is there for longer than a moment: of the folder, of shared memory, of sticks."""
        found = set()
        for top in (self.folder, '/dev/shm', '/media'):
            for place, _, names in os.walk(top):
                found |= {os.path.join(place, name) for name in names}
        return found

    def close(self):
        self.board.close()
        for process in (self.service, self.bus, self.display):
            if process:
                process.kill()
                process.wait()


def restart_after_s(root):
    """RestartSec of the kiosk's unit."""
    with open(f'{root}/app/package/units/touchline-kiosk.service', encoding='utf-8') as unit:
        return float(re.search(r'^RestartSec=([0-9.]+)$', unit.read(), re.MULTILINE)[1])


class Kiosk:
    """The kiosk and its supervisor, which starts it again as systemd's Restart=always does."""

    def __init__(self, world, settings=None, before=(), has_board=True, log='kiosk.log'):
        """`settings` of the environment, None for none; `before`: what the program is started by."""
        self.world, self.has_board = world, has_board
        self.restart_after_s = restart_after_s(world.root)
        program = [world.kiosk_program] if has_board else [f'{world.programs}/touchline', '--window']
        self.command = [*before, *program]
        self.environment = dict(world.environment, **(settings or {}))
        self.environment = {name: value for name, value in self.environment.items() if value is not None}
        self.log_path = f'{world.folder}/{log}'
        self.process, self.starts, self.ends, self.is_wanted = None, 0, [], True
        self.window = None
        self.listen()
        self.supervisor = threading.Thread(target=self.supervise, daemon=True)
        self.started = threading.Event()
        self.supervisor.start()
        self.started.wait()

    def listen(self):
        """READY=1 and its kin, as systemd hears them."""
        path = f'{self.world.folder}/notify'
        if os.path.exists(path):
            os.remove(path)
        self.notify = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.notify.bind(path)
        self.environment['NOTIFY_SOCKET'] = path
        self.is_ready_told = False
        threading.Thread(target=self.hear, args=(self.notify,), daemon=True).start()

    def hear(self, notify):
        while True:
            try:
                words = notify.recv(4096)
            except OSError:
                return
            if b'READY=1' in words:
                self.is_ready_told = True

    def supervise(self):
        with open(self.log_path, 'ab') as log:
            while self.is_wanted:
                self.is_ready_told, self.window = False, None
                self.process = subprocess.Popen(self.command, env=self.environment, stdin=subprocess.DEVNULL,
                                                stdout=log, stderr=log, start_new_session=True)
                self.starts += 1
                self.started.set()
                self.ends.append(self.process.wait())
                if self.is_wanted:
                    time.sleep(self.restart_after_s)

    @property
    def pid(self):
        return self.process.pid

    def log(self):
        with open(self.log_path, encoding='utf-8', errors='replace') as file:
            return file.read()

    def is_ready(self):
        """It says so itself after its first frame; and its servo ticks."""
        return self.is_ready_told and (not self.has_board or self.world.board.ticks_for(self.pid) > 50)

    def find_window(self):
        found = subprocess.run(['xdotool', 'search', '--pid', str(self.pid), '--name', '^Touchline$'],
                               env=self.environment, capture_output=True, text=True, check=False)
        self.window = (found.stdout.split() or [None])[0]
        return self.window

    def press(self, *keys):
        """To its window; what a kiosk that just died misses is nobody's fault."""
        if not self.window:
            if not self.find_window():
                return
            keys = (HARMLESS, HARMLESS, *keys)
        done = subprocess.run(['xdotool', 'key', '--window', self.window, '--delay', '150', *keys],
                              env=self.environment, capture_output=True, timeout=60, check=False)
        if done.returncode != 0 or done.stderr:  # it died while a key is down: the display would hold it for ever
            subprocess.run(['xdotool', 'keyup', *keys], env=self.environment, capture_output=True, timeout=60, check=False)

    def children(self):
        """PID to name, of the workers, voice and servo."""
        return {pid: stat['name'] for pid, stat in processes.tree(self.pid).items() if pid != self.pid}

    def end(self, with_signal=signal.SIGTERM):
        """Its exit status, and how long it took."""
        self.is_wanted = False
        begin = time.monotonic()
        self.process.send_signal(with_signal)
        self.supervisor.join(LONGEST_WAIT_S)
        if self.supervisor.is_alive():
            self.process.kill()
            self.supervisor.join()
        self.notify.close()
        return self.process.returncode, time.monotonic() - begin


class Visitor(threading.Thread):
    """Somebody who presses keys without end, never those of the staff that stop the kiosk."""

    # Weights: forwards more than back, or no picture would ever be felt.
    keys = (['Return'] * 8 + ['Down'] * 6 + ['Up'] * 2 + ['Right'] * 2 + ['Left'] * 2 +
            ['h', 'plus', 'minus', 'a', 'z', 'comma', 'period', 'F15', 'F16'])

    def __init__(self, kiosk, seed, pause_s=0.3):
        super().__init__(daemon=True)
        self.kiosk, self.random, self.pause_s = kiosk, random.Random(seed), pause_s
        self.rests, self.ends = threading.Event(), threading.Event()
        self.start()

    def run(self):
        while not self.ends.is_set():
            if not self.rests.is_set():
                self.kiosk.press(*self.random.choices(self.keys, k=self.random.randint(1, 4)))
            self.ends.wait(self.pause_s)

    def end(self):
        self.ends.set()
        self.join()


def lines_about(pattern, text):
    return [line for line in text.splitlines() if re.search(pattern, line)]
