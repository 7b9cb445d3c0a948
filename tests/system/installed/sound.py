"""What the kiosk plays is recorded on the other side of a sound card that loops back."""

HEARD = '/run/heard.raw'


def run(table, bench):
    kiosk = bench.ready(table, 'sound')
    machine = kiosk.machine
    with table.check('sound', 'the first words of a visit are heard') as note:
        machine.said('grep -q Loopback /proc/asound/cards')
        machine.said(f'systemd-run -q --unit=ear bash -c "arecord -q -D hw:Loopback,1 -t raw -f S16_LE '
                     f'-r 48000 -c 2 >{HEARD}"')
        machine.wait(f'[[ -s {HEARD} ]]', 120, 'something plays: the recording begins')
        before = _loud_bytes(machine)
        kiosk.press('ret')
        # A second of speech is 192 000 bytes, some of them zero.
        machine.wait(f'(($(tr -d "\\0" <{HEARD} | wc -c) > {before + 50_000}))', 180, 'speech is in the recording')
        note(f'{_loud_bytes(machine) - before} bytes that are not silence')
        machine.said('systemctl stop ear')


def _loud_bytes(machine):
    return int(machine.said(f'tr -d "\\0" <{HEARD} | wc -c'))
