"""The power goes at random moments; the kiosk comes back with the last good settings."""
import random
import re
import time

from kiosk import SETTINGS, UNIT
from machine import Fault

# Somebody saves settings again and again while the power goes: atomically as an editor does (a new
# file replaces the old), and in place as a careless one does; a half-written file must not take
# effect. The kiosk copies what it took over.
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
WHOLE = re.compile(r'\[time\]\ninactivity_s = 1800(\n\[care\]\nnotice = "number [0-9]+")?')
IN_BOOT = 5  # one in this many cuts is followed by another while the machine starts


def run(table, bench):
    moments = random.Random(20)
    with table.check('power', 'READY before the first cut', True):
        kiosk = bench.boot('power')
        kiosk.begin()
        kiosk.wait_ready()
    cuts = Cuts(bench)
    with table.check('power', f'power cut at {bench.cuts} random moments: READY with good settings') as note:
        try:
            for number in range(1, bench.cuts + 1):
                cuts.one(number, moments)
        finally:
            note(cuts.words())
            table.figure(20, 'power cuts in the guest: came back with good settings',
                         f'{len(cuts.seconds)} of {cuts.done}', f'all of {bench.cuts}',
                         len(cuts.seconds) == bench.cuts,
                         f'QEMU killed while settings are saved, each {IN_BOOT}th time again while it boots; the disk '
                         f'keeps what was written to it; {cuts.words()}')
        if cuts.faults:
            raise Fault('; '.join(cuts.faults))


class Cuts:
    """What came of the cuts so far. One that fails does not end the others."""

    def __init__(self, bench):
        self.bench = bench
        self.seconds = []
        self.done = 0
        self.copies = 0
        self.faults = []

    def one(self, number, moments):
        try:
            _cut(self.bench.kiosk.machine, moments)
            if number % IN_BOOT == 0:
                _cut_in_boot(self.bench, moments)
            start = time.monotonic()
            kiosk = self.bench.boot('power')
            kiosk.wait_ready()
            took = time.monotonic() - start
            self.copies += _settings_are_a_copy(kiosk.machine)
        except Fault as fault:
            self.faults.append(f'cut {number}: {fault}')
        else:
            self.seconds.append(took)
        self.done += 1
        print(f'    {number}: {self.words()}', flush=True)

    def words(self):
        return (f'{len(self.seconds)} came back, {self.copies} of them with the copy of the last good settings, '
                f'READY {min(self.seconds, default=0):.0f} to {max(self.seconds, default=0):.0f} s after power '
                f'(emulated), {len(self.faults)} did not')


def _cut(machine, moments):
    """While somebody saves settings."""
    script = WRITER.replace('SETTINGS', SETTINGS)
    machine.said(f"cat >/run/writer <<'END'\n{script}\nEND\nsystemd-run -q bash /run/writer")
    time.sleep(moments.uniform(0.2, 8))
    machine.cut()


def _cut_in_boot(bench, moments):
    machine = bench.power('power').machine
    time.sleep(moments.uniform(1, 40))
    machine.cut()


def _settings_are_a_copy(machine):
    """Whether the site's file was cut short, so that the copy of the last good one holds; Fault when that is not whole
    either, or the kiosk does not say so."""
    if WHOLE.fullmatch(machine.said(f'cat {SETTINGS}')):
        return False
    if not WHOLE.fullmatch(machine.said(f'cat {SETTINGS}.good')):
        raise Fault('neither the settings nor the last good ones are whole')
    machine.said(f'journalctl -b -u {UNIT} -o cat | grep -q "the settings before hold"')
    return True
