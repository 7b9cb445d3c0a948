"""What the kiosk plays is recorded on the other side of a sound card that loops back."""

HEARD = '/run/heard.raw'
PLAYED = '/proc/asound/Loopback/pcm0p/sub0/hw_params'


def run(table, bench):
    kiosk = bench.ready(table, 'sound')
    machine = kiosk.machine
    with table.check('sound', 'the first words of a visit are heard') as note:
        machine.wait(f'grep -q format {PLAYED}', 120, 'the kiosk has the sound card')
        # The loopback keeps the sound as played: it changes neither rate nor format.
        machine.said(f'systemd-run -q --unit=ear bash -c "arecord -q -D hw:Loopback,1,0 -t raw {_as_played(machine)} '
                     f'>{HEARD}"')
        machine.wait(f'[[ -s {HEARD} ]]', 120, 'something plays: the recording begins')
        before = _loud_bytes(machine)
        kiosk.press('ret')
        # A second of speech is 384 000 bytes in floating point, some of them zero.
        machine.wait(f'(($(tr -d "\\0" <{HEARD} | wc -c) > {before + 50_000}))', 180, 'speech is in the recording')
        note(f'{_loud_bytes(machine) - before} bytes that are not silence')
        machine.said('systemctl stop ear')


def _as_played(machine):
    """Format, rate and channels, in arecord's words."""
    lines = dict(line.split(': ', 1) for line in machine.said(f'cat {PLAYED}').splitlines())
    return f"-f {lines['format']} -r {lines['rate'].split()[0]} -c {lines['channels']}"


def _loud_bytes(machine):
    return int(machine.said(f'tr -d "\\0" <{HEARD} | wc -c'))
