"""SIGKILL at random moments to the kiosk, its servo, workers and voice: each time it comes back by itself."""

import os
import random
import signal
import subprocess
import time

import processes
from figures import quantile
from world import Failed, Kiosk, Visitor, wait_for

SEED = 11
LONGEST_READY_S = 5.0
LONG = 50  # kills; fewer judge no time, because the load of a CI machine decides nothing
# Weights. A servo that dies three times in a minute starts later and later, by design
# (app/force/servo/running_servo.h).
KINDS = {'kiosk': 8, 'servo': 5, 'voice': 3, 'decode': 1, 'import': 1}
MOST_SERVO_KILLS = 2  # in one life of a kiosk
NAMES = {'servo': 'soak_servo', 'voice': 'touchline-speak', 'decode': 'touchline-decod', 'import': 'touchline-impor'}
UNDER_TORQUE = 0.3  # of the kills wait for a picture to be felt
FAST_S = 0.002
PATIENCE_S = 4.0  # for a worker to show itself


class Kills:
    def __init__(self, world):
        self.world, self.random = world, random.Random(SEED)
        self.kiosk = Kiosk(world)
        self.took_s = {kind: [] for kind in KINDS}
        self.zero_s = []
        self.orphans = self.torque_left = 0
        self.servo_kills = self.serial = 0

    def ready(self):
        return wait_for('ready', self.kiosk.is_ready)

    def children_of(self, kind):
        return [pid for pid, name in self.kiosk.children().items() if name == NAMES[kind]]

    def kill_one(self):
        """False: nobody was killed."""
        kind = self.random.choices(list(KINDS), KINDS.values())[0]
        if kind == 'servo' and self.servo_kills == MOST_SERVO_KILLS:
            kind = 'kiosk'
        self.ready()
        if self.random.random() < UNDER_TORQUE:
            self.wait_for_torque()
        time.sleep(self.random.random())
        if kind in ('voice', 'decode', 'import'):
            return self.kill_worker(kind)
        (self.kill_kiosk if kind == 'kiosk' else self.kill_servo)()
        return True

    def wait_for_torque(self):
        """Where it comes within a while: the visitor goes where chance leads."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end and not self.world.board.has_torque:
            time.sleep(FAST_S)

    def kill_kiosk(self):
        kiosk, board = self.kiosk, self.world.board
        before = processes.tree(kiosk.pid).keys()
        starts, had_torque = kiosk.starts, board.has_torque
        begin = time.monotonic()
        os.kill(kiosk.pid, signal.SIGKILL)
        wait_for('the end of what it had started', lambda: not before & processes.alive().keys(), every_s=FAST_S)
        if board.has_torque and board.owner in before:
            self.torque_left += 1
        elif had_torque:
            self.zero_s.append(max(0.0, board.zeroed_s - begin))
        wait_for('the kiosk to come back', lambda: kiosk.starts > starts and kiosk.is_ready())
        self.took_s['kiosk'].append(time.monotonic() - begin)
        self.servo_kills = 0
        self.count_orphans()

    def kill_servo(self):
        board, starts = self.world.board, self.kiosk.starts
        opened, servo, had_torque = board.opened, board.owner, board.has_torque
        begin = time.monotonic()
        os.kill(servo, signal.SIGKILL)
        wait_for('the servo to come back',
                 lambda: board.opened > opened and board.ticks_for(self.kiosk.pid) > 50)
        self.took_s['servo'].append(time.monotonic() - begin)
        if had_torque:
            self.zero_s.append(max(0.0, board.zeroed_s - begin) if board.zeroed_s > begin else 0.0)
        self.servo_kills += 1
        self.stays(starts)

    def kill_worker(self, kind):
        """In the midst of its work. False: there was none to be found for a while."""
        starts = self.kiosk.starts
        begin = time.monotonic()
        while not (killed := self.one_dies(kind)):
            if time.monotonic() - begin > PATIENCE_S:
                return False
            time.sleep(FAST_S)
        begin = time.monotonic()
        if kind == 'voice':  # it goes on where it was
            wait_for('another voice', lambda: set(self.children_of(kind)) - {killed}, every_s=FAST_S)
        self.took_s[kind].append(time.monotonic() - begin)
        self.stays(starts)
        return True

    def one_dies(self, kind):
        if kind == 'import':
            self.replug()
        for pid in self.children_of(kind):
            time.sleep(0.02 * self.random.random())
            if pid in self.children_of(kind) and dies(pid):
                return pid
        return None

    def replug(self):
        self.world.pull_stick(self.serial)
        self.serial += 1
        self.world.plug_stick(self.serial)
        end = time.monotonic() + 0.5
        while time.monotonic() < end and not self.children_of('import'):
            time.sleep(FAST_S)

    def stays(self, starts):
        if self.kiosk.starts != starts:
            raise Failed('the kiosk died with its child')

    def count_orphans(self):
        """Processes of ours that are not below the kiosk; those that are ending get their time."""
        def strays():
            ours = {pid for pid, stat in processes.alive().items()
                    if stat['name'].startswith(('touchline', 'soak_'))}
            return ours - processes.tree(self.kiosk.pid).keys()
        try:
            wait_for('no orphan', lambda: not strays(), longest_s=5.0)
        except Failed:
            self.orphans += len(strays())


def dies(pid):
    """False: it had ended by itself, and the kiosk knows."""
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        return False
    return True


def shared_memory():
    with open('/proc/sysvipc/shm', encoding='ascii') as file:
        return len(file.readlines())


def run(world, figures, count, busy=0):
    """`busy`: programs beside that never wait."""
    others = [subprocess.Popen(['sh', '-c', 'while :; do :; done']) for _ in range(busy)]
    try:
        run_beside(world, figures, count, busy)
    finally:
        for other in others:
            other.kill()
            other.wait()


def run_beside(world, figures, count, busy):
    world.start_bus()
    world.make_stick()
    world.board.move_hand(True)
    memory = shared_memory()
    kills = Kills(world)
    world.plug_stick(0)
    kills.ready()
    visitor = Visitor(kills.kiosk, SEED)
    time.sleep(5.0)  # long enough for a visit, and its files, to begin
    files = world.files()
    done = 0
    try:
        for done in range(1, count + 1):
            while not kills.kill_one():
                pass
            if done % 50 == 0:
                print(f'  {done} of {count} kills', flush=True)
    except Failed as problem:
        figures.failed.append(f'kill {done}: {problem}')
        done -= 1
    visitor.end()
    status, _ = kills.kiosk.end()
    report(figures, kills, done, count, busy, {
        'orphans': kills.orphans, 'torque': kills.torque_left + int(world.board.has_torque), 'status': status,
        'files': sorted(world.files() - files - kept_by_design(world)), 'memory': shared_memory() - memory})


def kept_by_design(world):
    """Settings and counters. A recording is saved when the operator asks, which nobody does here."""
    return {path for path in world.files() if path.startswith(f'{world.folder}/person/')}


def report(figures, kills, done, count, busy, left):
    beside = f' beside {busy} busy programs' if busy else ''
    how = (f'tests/machines/system/soak/run kills {count}{f" {busy}" if busy else ""}: seed {SEED}, Xvfb, board in a file, '
           f'load {os.getloadavg()[0]:.0f}')

    def keep(figure, value, bar, passed):
        figures.keep(20, figure + beside, value, bar, passed, how)

    kinds = ', '.join(f'{kind} {len(times)}' for kind, times in kills.took_s.items())
    keep('SIGKILL at random moments: came back by themselves', f'{done} of {count} ({kinds})', 'all', done == count)
    for kind, words in (('kiosk', 'time to READY after the kiosk was killed'),
                        ('servo', 'time to ticks after the servo was killed'),
                        ('voice', 'time until the voice was there again')):
        times = kills.took_s[kind]
        if times:
            is_long = count >= LONG
            keep(words + ', s',
                 f'{quantile(times, 0.5):.2f} median, {quantile(times, 0.99):.2f} p99, {max(times):.2f} worst',
                 f'< {LONGEST_READY_S:.0f}' if is_long else 'reported',
                 max(times) < LONGEST_READY_S if is_long else None)
    if kills.zero_s:
        keep('time to zero torque after a kill under torque, ms',
             f'{1e3 * quantile(kills.zero_s, 0.5):.1f} median, {1e3 * max(kills.zero_s):.1f} worst of '
             f'{len(kills.zero_s)}', 'reported', None)
    if left['files']:
        print('  left: ' + ' '.join(left['files'][:20]))
    keep('left after all kills: orphans, torque, files, shared memory',
         f'{left["orphans"]}, {left["torque"]}, {len(left["files"])}, {left["memory"]}', '0, 0, 0, 0',
         left['orphans'] == left['torque'] == left['memory'] == 0 and not left['files'] and left['status'] == 0)
