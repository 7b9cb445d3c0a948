"""The installed kiosk in its machine: its unit, its visit by keys and by what the screen says."""
import re
import time

from machine import Fault, wait_for

UNIT = 'touchline-kiosk.service'
SETTINGS = '/var/lib/touchline/kiosk.toml'
X = 'DISPLAY=:0 XAUTHORITY=/run/touchline-display/cookie'  # for programs that ask the X server
TRIES = 5
FELT = 'Guide me round|Explore freely|Bring me back'  # some of what can be done with a picture
TROUBLE = 'Something is wrong|ress Select to go on'
STAFF = ('h', 'up', 'up', 'down', 'down', 'ret')  # Help, Up, Up, Down, Down, Select
PIN = (1, 2, 3, 4)
KEY_S = 1.5  # a key in an emulated machine
MOST_LOOKS = 20  # at a screen that does not answer a key
READY_S = 600  # an emulated machine beside other work; a real one needs seconds
# Nobody presses a key for minutes while a slow machine reads, and the visit must not end meanwhile.
FIRST_SETTINGS = '[time]\ninactivity_s = 1800\n'


# Times of the unit for an emulated processor, fifty times slower than a real one. Otherwise the
# unit is as installed.
SLOW = '[Service]\nTimeoutStartSec=600\nTimeoutStopSec=120\nWatchdogSec=60\n'


class Kiosk:
    def __init__(self, machine):
        self.machine = machine

    def state(self):
        """ActiveState, main process, restarts of the unit."""
        said = self.machine.said(f'systemctl show -p ActiveState -p MainPID -p NRestarts {UNIT}')
        values = dict(line.split('=', 1) for line in said.splitlines())
        return values['ActiveState'], int(values['MainPID']), int(values['NRestarts'])

    def is_ready(self):
        """Type=notify: active is what the kiosk itself said, after its first frame."""
        return self.state()[0] == 'active'

    def wait_ready(self, not_process=0):
        """Seconds until READY, by a process other than that one."""
        start = time.monotonic()

        def is_back():
            active, process, _ = self.state()
            return active == 'active' and process not in (0, not_process)
        try:
            wait_for(is_back, READY_S, 'the kiosk is ready', 2)  # each question takes time from the boot of an emulated machine
        except Fault as fault:
            raise Fault(f'{fault}: {self.machine.run(f"journalctl -u {UNIT} -n 8 -o cat")[1]}') from None
        return time.monotonic() - start

    def begin(self):
        """The settings of the test, the kiosk switched on as its operator does it."""
        if self.machine.holds(f'systemctl is-active {UNIT}'):
            return
        self.machine.wait('[[ $(systemctl is-system-running) != starting ]]', READY_S, 'the machine is up')
        self.put_settings(FIRST_SETTINGS)
        self.machine.said(f"mkdir -p /etc/systemd/system/{UNIT}.d && printf '{SLOW}' "
                          f'>/etc/systemd/system/{UNIT}.d/slow.conf && systemctl daemon-reload && sync')
        self.machine.said(f'systemctl enable --now --no-block {UNIT}')

    def put_settings(self, text):
        self.machine.said(f"install -d -o touchline -g touchline -m 700 {SETTINGS.rsplit('/', 1)[0]} && "
                          f"printf '%s' '{text}' >{SETTINGS}.new && chown touchline: {SETTINGS}.new && "
                          f'mv {SETTINGS}.new {SETTINGS} && sync')

    def process(self):
        return self.state()[1]

    # A visit

    def press(self, key):
        self.machine.press(key)

    def go(self, is_there, else_key, what):
        """Presses a key after two looks at the screen that are alike and do not show it; the look is its words. The next
        key waits until the screen has answered the last one, or did not for a while. Two looks have to show it: an answer
        to an earlier key may still come."""
        words = pressed_at = ''
        looks = hits = 0

        def step():
            nonlocal words, pressed_at, looks, hits
            before, words = words, self.machine.screen()
            if is_there(words):
                hits += 1
                return hits == 2
            looks, hits = looks + 1, 0
            if words == before and (words != pressed_at or looks > MOST_LOOKS):
                self.press(else_key(words))
                pressed_at, looks = words, 0
            return False
        try:
            wait_for(step, 400, what, 1)
        except Fault as fault:
            raise Fault(f'{fault}; the screen says: {words[-300:]}') from None

    def to_choose(self):
        """From wherever the visit is to the list of what to feel."""
        def key(words):
            return 'ret' if re.search('ress any key|' + TROUBLE, words) else 'left'
        self.go(lambda words: 'What to feel' in words, key, 'the screen "What to feel"')

    def press_all(self, keys):
        """One after the other, each by itself."""
        for key in keys:
            self.press(key)
            time.sleep(KEY_S)

    def to_staff(self):
        """The operator's menu, for the first time: a PIN is chosen."""
        self.to_choose()
        self.press_all(STAFF)
        self.machine.wait_screen(['PIN'])
        for _ in range(2):
            for digit in PIN:
                self.press_all(['up'] * digit + ['ret'])
            self.press_all(['ret'])
        self.machine.wait_screen(['The PIN is saved'])
        self.press_all(['left'])  # from the first screen to the menu

    def to_item(self, name):
        """Down until the caption tells of it, and which of how many it is: its frame in the list hides it from tesseract.
        The list itself, with another item's caption behind it, must not pass for that."""
        focus = re.compile(re.escape(name) + r'(, [^,:]{1,30})?, \d+ of \d+')
        self.go(focus.search, lambda words: 'ret' if re.search(TROUBLE, words) else 'down', f'the item "{name}"')

    def is_felt(self):
        """Waits for the screen of a picture that is felt, or of why there is none; which of them it is."""
        said = wait_for(lambda: re.search(f'{FELT}|{TROUBLE}', self.machine.screen()), 300, 'a picture, or why not', 1)
        return not re.fullmatch(TROUBLE, said.group())

    def ask_stick(self, file):
        """From "What to feel" to a picture of the stick being opened."""
        name = file.rsplit('.', 1)[0]
        self.to_item('Your USB stick')
        self.press('ret')
        self.machine.wait_screen(['1 of 3'])
        self.to_item(name)
        self.press('ret')

    def open_stick(self, file):
        """From "What to feel" to a picture of the stick that is felt. A worker that was too slow for its deadline, as
        happens in an emulated machine beside other work, is asked again; how often it was asked."""
        for tries in range(1, TRIES + 1):
            self.ask_stick(file)
            if self.is_felt():
                return tries
            self.to_choose()
        raise Fault(f'{file} was not opened in {TRIES} tries: {self.machine.screen()}')
