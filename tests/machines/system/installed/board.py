"""A pantograph on the USB: its kind is chosen, the servo's unit takes it, words lead the hand to its stops, a line is met;
and again after its plug was pulled."""
import time

from kiosk import SETTINGS, UNIT
from machine import Fault, Redirected, wait_for

UNITS = f'{SETTINGS.rsplit("/", 1)[0]}/units.toml'
SERVO = "systemctl list-units --state=running --plain --no-legend 'touchline-servo@*' | grep -q ."
KIND = 'elbows 15 millimetres'
# What homing asks for, and what the hand is told to do. The last request on the screen counts, but
# the question about the arms goes first.
ASKED = {'away from you': 'away from you', 'towards you': 'towards you', 'to the left': 'to the left',
         'et go of it': 'middle, let go'}
QUESTION, OF_THE_ARMS = ('straight line', 'they do not', 'other hand'), 'one straight line'
ON_THE_CIRCLE = 'go 35 0'  # of the practice shape, in millimetres from the middle
LOOKS = 20  # at an unplugged board: the kiosk tries the servo again three times
PACE = '0.1'  # of board and hand, on a machine whose second takes five to ten
LONGEST_S = 900
ASLEEP, AWAKE = 'PM: suspend entry', 'PM: suspend exit'
# As logind sees it.
NOT_GOING_TO_SLEEP = ('busctl get-property org.freedesktop.login1 /org/freedesktop/login1 org.freedesktop.login1.Manager '
                      'PreparingForSleep | grep -q false')
SLEEP_S = 60
LOCKED_KB = 30_000  # the recording of the last minute alone


def run(table, bench):
    board = []

    def plug(machine):
        board.append(Redirected(machine, f'{bench.devices}/redirected_board', 'led', PACE))
    kiosk = bench.ready(table, 'board', plug)
    pantograph = board[0]
    try:
        _visits(table, kiosk, pantograph)
        # A board without its plug keeps its last torque, so the test stops the kiosk before, with
        # the hand at the line.
        with table.check('board', 'the kiosk is stopped: the board has been told zero torque') as note:
            kiosk.machine.said(f'systemctl stop {UNIT}', 240)
            note(pantograph.pull())
            if pantograph.process.returncode != 0:
                raise Fault('there is torque')
    finally:
        pantograph.process.kill()


def _visits(table, kiosk, board):
    with table.check('board', "its kind is chosen on the operator's screens: the servo's unit takes it", True):
        kiosk.machine.said(f'! {SERVO}')
        _choose_kind(kiosk)
        kiosk.machine.wait(SERVO, 120)
    with table.check('board', "the servo's memory is locked") as note:
        locked_kB = 'grep VmLck /proc/$(pgrep -x touchline-servo)/status | tr -dc 0-9'
        kiosk.machine.wait(f'(($({locked_kB}) > {LOCKED_KB}))', 120, f'more than {LOCKED_KB} kB are locked')
        note(f'VmLck {kiosk.machine.said(locked_kB).strip()} kB')
    with table.check('board', 'the words lead the hand to its stops and try the motors: homed, kept', True) as note:
        note(f'{_home(kiosk, board)} words')
        kiosk.machine.wait(f'grep -q serial {UNITS}', 60)
    with table.check('board', 'a line is met under the hand') as note:
        note(_feel(kiosk, board))
    _sleeps(table, kiosk, board)
    with table.check('board', 'unplugged: told on the screen, the kiosk stays', True):
        process = kiosk.process()
        board.order('unplug')
        board.said()
        kiosk.machine.wait_screen(['does not answer'])
        for _ in range(LOOKS):
            if 'works again' in kiosk.machine.screen():
                raise Fault('it is said to work again, without a board')
            time.sleep(1)
    with table.check('board', 'plugged again: homed, a line is met') as note:
        board.order('plug')
        words = _home(kiosk, board)
        note(f'{words} words; {_feel(kiosk, board)}')
        if kiosk.process() != process:
            raise Fault('the kiosk was started again')


def _choose_kind(kiosk):
    """Of a board that nobody has told of. The first one of the list is the board's."""
    kiosk.to_staff()
    for name in ('Handle and tests', 'Kind of handle'):
        kiosk.to_item(name)
        kiosk.press('ret')
    kiosk.machine.wait_screen([KIND])
    kiosk.press('ret')


def _sleeps(table, kiosk, board):
    """The hand is at a line, with torque."""
    machine = kiosk.machine
    servo = 'pgrep -x touchline-servo'
    with table.check('board', 'asked to sleep: the computer stays awake while the kiosk is on, the servo goes on'):
        before = machine.said(servo)
        machine.said('systemctl suspend', 240)
        machine.wait(NOT_GOING_TO_SLEEP, 120)
        machine.said(f'! journalctl -k -o cat | grep -q "{ASLEEP}"')
        machine.said(f'[[ $({servo}) == {before} ]]')
    with table.check('board', 'put to sleep all the same: no torque meanwhile, the handle is homed afterwards') as note:
        machine.said(f'rm /run/touchline-console/closed; rtcwake -m no -s {SLEEP_S}; systemctl --no-block suspend')
        time.sleep(SLEEP_S / 2)
        _told(board)
        time.sleep(SLEEP_S / 6)
        told = _told(board)
        machine.wait(f'journalctl -k -o cat | grep -q "{AWAKE}"', 240)
        machine.said('touch /run/touchline-console/closed')
        if float(told.split()[1]) != 0:
            raise Fault(f'there is torque: {told}')
        note(f'{told}; {_home(kiosk, board)} words; {_feel(kiosk, board)}')


def _home(kiosk, board):
    """Does what the words on the screen say, until they say that it works; how many it followed. Long words have pages,
    which turn by themselves."""
    followed = []

    def is_over():
        words = kiosk.machine.screen()
        said = [asked for asked in sorted(ASKED, key=words.rfind) if asked in words]
        told = OF_THE_ARMS if any(part in words for part in QUESTION) else said and ASKED[said[-1]]
        if told and followed[-1:] != [told]:
            followed.append(told)
            board.order(f'hear {told}')
        return followed and 'The force is back' in words
    kiosk.to_choose()
    try:
        wait_for(is_over, LONGEST_S, 'homing is over')
    except Fault as fault:
        raise Fault(f'{fault}; followed: {followed}') from fault
    return len(followed)


def _feel(kiosk, board):
    """The practice circle, the hand led to its line once there may be force; what the staff's live view says of it, and
    that there was torque."""
    kiosk.to_choose()
    kiosk.to_item('Practice shape')
    kiosk.press('ret')
    kiosk.machine.wait_screen(['until a line holds it'])
    board.order('go 0 0')
    kiosk.press('v')
    kiosk.machine.wait_screen(['pantograph', 'Motors on'])
    _told(board)
    board.order(ON_THE_CIRCLE)
    kiosk.machine.wait_screen(['pantograph', 'on a line'])
    kiosk.press('v')
    told = _told(board)
    if float(told.split()[1]) == 0:
        raise Fault(f'the line has no force: {told}')
    return told


def _told(board):
    """The largest torque since this was last asked, and where the hand is."""
    board.order('tell')
    return board.said()
