"""A stick and the board, plugged in and pulled over and over: nothing of it stays in the kiosk."""

import random
import threading
import time

import processes
from figures import quantile
from missing import feel_a_picture
from world import Kiosk, wait_for

SEED = 12
FAST_S = 0.002
MOST_GROWTH_MB = 1.0
REST_S = 3.0
LONG = 50  # sticks; fewer judge neither growth nor the number of lists read to their end
STICKS_PER_BOARD = 10  # a board takes some ten seconds: its servo waits up to eight before it looks again


class BoardPlug(threading.Thread):
    """Pulls the board, sees its servo end, puts it in again, sees it tick; as long as it is wanted."""

    def __init__(self, kiosk):
        super().__init__(daemon=True)
        self.kiosk, self.board = kiosk, kiosk.world.board
        self.ends, self.cycles, self.back_s, self.problem = threading.Event(), 0, [], None
        self.start()

    def run(self):
        while not self.ends.is_set():
            try:
                self.cycle()
            except Exception as problem:  # the run that waits for it reports this
                self.problem = problem
                return

    def cycle(self):
        opened = self.board.opened
        servo = self.board.owner
        self.board.plug(False)
        wait_for('the end of a servo without its board', lambda: servo not in processes.alive())
        self.board.plug(True)
        begin = time.monotonic()
        wait_for('the servo to take its board again',
                 lambda: self.board.opened > opened and self.board.ticks_for(self.kiosk.pid) > 50)
        self.back_s.append(time.monotonic() - begin)
        self.cycles += 1

    def end(self):
        self.ends.set()
        self.join()
        if self.problem:
            raise self.problem


def imports(kiosk):
    return [pid for pid, name in kiosk.children().items() if name == 'touchline-impor']


def stick_cycle(world, kiosk, serial, is_hasty, chance):
    """A stick that is read to the end of its list or, if hasty, pulled at any moment. True: its reader was seen."""
    world.plug_stick(serial)
    wait_for('the stick to be mounted', lambda: list(world.udisks.Asked('sdb1')))
    is_read = False
    if is_hasty:
        time.sleep(0.1 * chance.random())
    else:
        end = time.monotonic() + 1.0
        while time.monotonic() < end and not is_read:
            is_read = bool(imports(kiosk))
            time.sleep(FAST_S)
        wait_for('the end of its list', lambda: not imports(kiosk))
    world.pull_stick(serial)
    wait_for('the end of its reader', lambda: not imports(kiosk))
    return is_read


def look(pid):
    """(Rss of the kiosk in MB, its descriptors, its threads)."""
    stat = processes.stat_of(pid)
    return processes.memory_kB(pid)[0] / 1024.0, processes.descriptors(pid), stat['threads'] if stat else 0


def look_at_rest(kiosk):
    """While only its servo is there, nobody died unnoticed: a voice that speaks and a list that is read have descriptors
    in the kiosk, too, until it has seen their end, and before they are started. So the least of some seconds."""
    def is_alone():
        return list(kiosk.children().values()) == ['soak_servo'] and not processes.corpses_of(kiosk.pid)

    seen, end = [], time.monotonic() + REST_S

    def is_at_rest():
        was_alone = is_alone()
        now = look(kiosk.pid)
        if was_alone and is_alone():
            seen.append(now)
        return seen and time.monotonic() >= end

    wait_for('a moment of rest', is_at_rest, every_s=FAST_S)
    return tuple(min(part) for part in zip(*seen))


def run(world, figures, count):
    world.start_bus()
    world.make_stick()
    kiosk = Kiosk(world)
    wait_for('ready', kiosk.is_ready)
    feel_a_picture(kiosk)
    chance, seen, lists = random.Random(SEED), [], 0
    stick_cycle(world, kiosk, 0, False, chance)  # the reader of sticks starts with the first one, and stays
    before = look_at_rest(kiosk)
    plug = BoardPlug(kiosk)
    for serial in range(1, count + 1):
        lists += stick_cycle(world, kiosk, serial, chance.random() < 0.5, chance)
        seen.append(look(kiosk.pid))
        if serial % 50 == 0:
            print(f'  {serial} of {count} sticks, {plug.cycles} boards, {seen[-1]}', flush=True)
    boards = max(1, count // STICKS_PER_BOARD)
    wait_for('the boards', lambda: plug.cycles >= boards or plug.problem, longest_s=60.0 * boards)
    plug.end()
    seen.append(look_at_rest(kiosk))
    starts = kiosk.starts
    lines = len(kiosk.log().splitlines())
    status, _ = kiosk.end()
    report(figures, count, before, seen, plug, {'starts': starts, 'status': status, 'lines': lines, 'lists': lists})


def report(figures, count, before, seen, plug, end):
    how = (f'tests/machines/system/soak/run plugs {count}: seed {SEED}, udisks2 mocked on a bus of its own, board in a file; '
           'first and last tenth compared, at least five cycles')
    tenth = max(1, min(len(seen) // 3, max(5, len(seen) // 10)))
    first, last = seen[tenth:2 * tenth], seen[-tenth:]
    # The least counts: a list that is being read has a thread and descriptors of its own for a
    # moment.
    rss = [min(look[0] for look in part) for part in (first, last)]
    figures.keep(19, 'plug cycles: sticks, of them listed to the end, boards', f'{count}, {end["lists"]}, {plug.cycles}',
                 f'{count} sticks, a fourth listed', end['starts'] == 1 and end['status'] == 0 and
                 (count < LONG or 4 * end['lists'] >= count), how)
    figures.keep(19, 'time to ticks after the board is plugged in, s',
                 f'{quantile(plug.back_s, 0.5):.1f} median, {max(plug.back_s):.1f} worst', 'reported (waits up to 8 by design)',
                 None, how)
    for i, name in ((1, 'descriptors'), (2, 'threads')):
        figures.keep(19, f'{name} of the kiosk, before and after', f'{before[i]}, {seen[-1][i]}', 'no more', seen[-1][i] <= before[i], how)
    is_long = count >= LONG
    figures.keep(19, 'Rss of the kiosk, early and late, MB', f'{rss[0]:.1f}, {rss[1]:.1f}',
                 f'grows by < {MOST_GROWTH_MB:.0f}' if is_long else 'reported: too short to judge',
                 rss[1] - rss[0] < MOST_GROWTH_MB if is_long else None, how)
    figures.keep(19, 'lines of the log per board cycle', f'{end["lines"] / max(1, plug.cycles):.1f}', 'reported', None, how)
