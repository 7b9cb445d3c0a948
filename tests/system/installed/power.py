"""The power goes at random moments; the kiosk comes back with the last good settings."""
import random
import time

from kiosk import SETTINGS, UNIT
from machine import Fault

# Somebody saves settings over and over while the power goes: whole as an editor does (a new file in its place), and
# in place as a careless one does; what that cuts short must not be what holds.
WRITER = r'''
n=0
while :; do
    n=$((n + 1))
    printf '[time]\ninactivity_s = 1800\n[care]\nnotice = "number %d"\n' $n >SETTINGS.new
    chown touchline: SETTINGS.new
    sync SETTINGS.new
    if ((n % 2)); then mv SETTINGS.new SETTINGS; else cat SETTINGS.new >SETTINGS; fi
    sleep 1.2
done
'''


def run(table, bench):
    times = bench.cuts
    moments = random.Random(20)
    seconds, done = [], 0
    with table.check('power', f'power cut at {times} random moments: READY with good settings') as note:
        kiosk = bench.boot('power')
        kiosk.begin()
        kiosk.wait_ready()
        for number in range(times):
            _cut(kiosk.machine, moments)
            if number % 3 == 2:
                _cut_in_boot(bench, moments)
            start = time.monotonic()
            kiosk = bench.boot('power')
            kiosk.wait_ready()
            seconds.append(time.monotonic() - start)
            _settings_hold(kiosk.machine)
            done += 1
            print(f'    cut {done}: READY {seconds[-1]:.0f} s after power', flush=True)
        note(f'READY {min(seconds):.0f} to {max(seconds):.0f} s after power, emulated')
    table.figure(20, 'power cuts in the guest: came back with good settings', f'{done} of {times}', 'all',
                 done == times,
                 'QEMU killed while settings are saved and while it boots; the disk keeps what was written to it')


def _cut(machine, moments):
    """While somebody saves settings."""
    script = WRITER.replace('SETTINGS', SETTINGS)
    machine.said(f"cat >/run/writer <<'END'\n{script}\nEND\nsystemd-run -q bash /run/writer")
    time.sleep(moments.uniform(0.2, 8))
    machine.cut()


def _cut_in_boot(bench, moments):
    machine = bench.power('power').machine
    time.sleep(moments.uniform(1, 60))
    machine.cut()


def _settings_hold(machine):
    """What holds is whole: the site's file, or the copy of the last good one, which the kiosk then tells."""
    if machine.holds(f'grep -q "inactivity_s = 1800" {SETTINGS} && touchline settings check {SETTINGS}'):
        return
    good = f'{SETTINGS}.good'
    if not machine.holds(f'grep -q "inactivity_s = 1800" {good} && touchline settings check {good}'):
        raise Fault('neither the settings nor the last good ones are whole')
    machine.said(f'journalctl -b -u {UNIT} -o cat | grep -q "the settings before hold"')
