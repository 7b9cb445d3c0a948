"""A visit on a braille display alone: brltty as installed, its virtual driver, and a display of bash at its other end."""
from machine import Fault

SERVER = 'server:127.0.0.1:35752'
SHOWN = '/run/braille.shown'  # what brltty wrote, a line each
KEYS = '/run/braille.keys'  # a pipe: brltty's commands
DISPLAY = f'''until exec 3<>/dev/tcp/127.0.0.1/35752; do sleep 1; done
echo "cells 40" >&3
cat <&3 >{SHOWN} &
exec 4<>{KEYS}
while read -r key <&4; do echo "$key" >&3; done'''
DOTS = {c: '|'.join(cell) for c, cell in {
    'Finish': ('6', '124', '24', '1345', '24', '234', '125'), 'English': ('6', '15', '1345', '1245', '123', '24', '234', '125'),
    'Gallery': ('6', '1245', '1', '123', '123', '15', '1235', '13456'),
    'Pictures': ('6', '1234', '24', '14', '2345', '136', '1235', '15', '234')}.items()}  # uncontracted; dot 6 makes a capital letter
MOST_KEYS = 30


def run(table, bench):
    kiosk = bench.ready(table, 'braille', _install)
    machine = kiosk.machine
    with table.check('braille', 'the kiosk writes on the display, as its own user'):
        machine.said(f"mkfifo {KEYS} && printf '%s' '{DISPLAY}' >/run/display.sh")
        _plug_in(machine, 'Pictures')
    with table.check('braille', "a visit by the display's keys: a language, the gallery, the end") as note:
        _key(machine, 'Route 1')
        _find(machine, 'English')
        _key(machine, 'Route 1')
        _find(machine, 'Gallery')
        _key(machine, 'Route 1')
        _key(machine, 'Top')
        _find(machine, 'Finish')
        note(f'{_count(machine)} lines written')
    with table.check('braille', 'the display goes and comes back: the kiosk goes on'):
        process = kiosk.process()
        machine.said(f'systemctl stop display brltty-test; systemctl reset-failed; rm -f {SHOWN}')
        _plug_in(machine, 'Finish')
        if kiosk.process() != process:
            raise Fault('the kiosk was started again')


def _install(machine):
    """What an operator installs who has a display; the kiosk that starts next has the group."""
    machine.said('dpkg -i /usr/local/lib/touchline-test/touchline-braille.deb')
    machine.said('id -nG touchline | grep -qw brlapi')


def _plug_in(machine, word):
    """brltty, the display at the other end of its socket, and the kiosk's words there: brltty has some of its own."""
    machine.said(f'systemd-run -q --unit=brltty-test brltty -n -b vr -d {SERVER} -s no -x no -f /dev/null')
    machine.said('systemd-run -q --unit=display bash /run/display.sh')
    machine.wait(f'grep -qF \'"{DOTS[word]}\' {SHOWN}', 180, f'{word} on the display')


def _count(machine):
    return int(machine.said(f'grep -c Braille {SHOWN}'))


def _last(machine):
    return machine.said(f'grep Braille {SHOWN} | tail -n 1')


def _key(machine, command):
    """Waits until the display was written anew: every key changes what stands there."""
    before = _count(machine)
    machine.said(f"echo '{command}' >{KEYS}")
    machine.wait(f'(($(grep -c Braille {SHOWN}) > {before}))', 60, f'an answer to {command}')


def _find(machine, word):
    """Line down until the word begins the line."""
    for _ in range(MOST_KEYS):
        if f'"{DOTS[word]}' in _last(machine):
            return
        _key(machine, 'LnDn')
    raise Fault(f'{word} does not come; the display has {_last(machine)}')
