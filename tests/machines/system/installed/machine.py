"""A virtual machine with the installed package: power, plugs, keys, screen, and commands in it.

One QEMU process, emulated (TCG). What is written to its disk stays in the overlay that it is given; `cut` takes
its power away. All waiting is for a condition, with a time after which it is an error.
"""
import base64
import ctypes
import json
import mmap
import os
import platform
import select
import socket
import subprocess
import time

READ_COUNTER = bytes.fromhex('0f31 48c1e220 4809d0 c3')  # rdtsc; shl rdx, 32; or rax, rdx; ret


class Fault(Exception):
    """A condition that did not come true, or a machine that has gone."""


def ticks_kHz(span_s=0.5):
    """Ticks in a millisecond of the counter that an emulated processor shows as its own; None where there is no such counter.
    A busy host makes the machine measure it wrong while it boots, and its clock then runs at several times its pace:
    time-outs come early."""
    if platform.machine() != 'x86_64':
        return None
    with mmap.mmap(-1, mmap.PAGESIZE, prot=mmap.PROT_READ | mmap.PROT_WRITE | mmap.PROT_EXEC) as page:
        page.write(READ_COUNTER)
        place = ctypes.c_char.from_buffer(page)
        count = ctypes.CFUNCTYPE(ctypes.c_uint64)(ctypes.addressof(place))
        began, first = time.monotonic(), count()
        time.sleep(span_s)
        ended, last = time.monotonic(), count()
        del place
    return round((last - first) / (ended - began) / 1000)


def own_cores():
    """As many processors as QEMU may use, two at most: two emulated ones on one real one wait for each other."""
    return min(2, len(os.sched_getaffinity(0)))


def wait_for(condition, longest_s, what, pause_s=0.5):
    """The first true value of condition(); Fault when there was none within longest_s."""
    end = time.monotonic() + longest_s
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise Fault(f'not within {longest_s} s: {what}')
        time.sleep(pause_s)


class Line:
    """A unix socket of QEMU's, read and written by lines."""

    def __init__(self, path, longest_s=30):
        def connected():
            try:
                end = socket.socket(socket.AF_UNIX)
                end.connect(path)
                return end
            except OSError:
                return None
        self.socket = wait_for(connected, longest_s, f'{path} can be connected', 0.05)
        self.rest = b''

    def send(self, text):
        self.socket.sendall(text.encode() + b'\n')

    def receive(self, longest_s):
        end = time.monotonic() + longest_s
        while b'\n' not in self.rest:
            left_s = end - time.monotonic()
            if left_s <= 0:
                raise Fault(f'no answer within {longest_s} s')
            self.socket.settimeout(left_s)
            try:
                more = self.socket.recv(65536)
            except TimeoutError:
                continue
            if not more:
                raise Fault('the machine has gone')
            self.rest += more
        line, self.rest = self.rest.split(b'\n', 1)
        return line.decode()


class Machine:
    """`image`: the folder that tests/machines/system/installed/image made. `overlay`: a qcow2 file on its disk, made
    here when it is not there. `folder`: where console, sockets and pictures of the screen go. `counts_instructions`: its
    clock goes a nanosecond with each instruction, so that it keeps its deadlines however slow it is emulated; a second of
    it takes five to ten."""

    def __init__(self, image, overlay, folder, counts_instructions=False):
        self.folder = folder
        self.ids = 0
        self.commands = 0
        os.makedirs(folder, exist_ok=True)
        for name in ('qmp', 'agent'):
            if os.path.exists(f'{folder}/{name}'):
                os.remove(f'{folder}/{name}')
        if not os.path.exists(overlay):
            subprocess.run(['qemu-img', 'create', '-q', '-f', 'qcow2', '-F', 'raw', '-b', f'{image}/disk', overlay],
                           check=True)
        if counts_instructions:
            pace, ticks = ['tcg,thread=single,tb-size=512', '-icount', 'shift=0,sleep=on'], 1_000_000
            preemption = 'full'  # Debian's kernel can; by default a tick waits for whole calls of other programs
        else:
            pace, ticks = ['tcg,thread=multi,tb-size=512', '-smp', str(own_cores())], ticks_kHz() or 0
            preemption = 'voluntary'
        words = ('root=/dev/vda ro console=ttyS0 loglevel=5 panic=-1 mitigations=off nokaslr tsc=reliable '
                 f'preempt={preemption} tsc_early_khz={ticks} no_timer_check random.trust_cpu=on systemd.show_status=1 '
                 'systemd.default_timeout_start_sec=600')
        # cache: what the machine flushes is flushed; after a cut it must be there, in qcow2's own
        # tables too.
        self.console = open(f'{folder}/console.txt', 'ab')
        self.process = subprocess.Popen(
            ['qemu-system-x86_64', '-M', 'q35,usb=off', '-accel', *pace, '-cpu', 'Westmere', '-m', '2G',
             '-nodefaults', '-no-reboot', '-display', 'none',
             '-kernel', f'{image}/vmlinuz', '-initrd', f'{image}/initrd.img', '-append', words,
             '-drive', f'file={overlay},if=none,id=disk,cache=writeback,discard=unmap',
             '-device', 'virtio-blk-pci,drive=disk', '-device', 'VGA,edid=on,xres=800,yres=600',
             '-device', 'virtio-rng-pci', '-device', 'qemu-xhci,id=xhci,p2=8,p3=8',
             '-device', 'virtio-serial-pci', '-chardev', f'socket,id=agent,path={folder}/agent,server=on,wait=off',
             '-device', 'virtserialport,chardev=agent,name=touchline.test',
             '-qmp', f'unix:{folder}/qmp,server=on,wait=off', '-serial', 'stdio'],
            stdin=subprocess.DEVNULL, stdout=self.console, stderr=subprocess.STDOUT)
        self.control = Line(f'{folder}/qmp')
        self.control.receive(30)
        self.ask('qmp_capabilities')
        self.agent = Line(f'{folder}/agent')

    def ask(self, order, **arguments):
        """A QMP order; Fault when QEMU refuses it."""
        self.control.send(json.dumps({'execute': order, 'arguments': arguments}))
        while True:
            answer = json.loads(self.control.receive(60))
            if 'error' in answer:
                raise Fault(f"{order}: {answer['error']['desc']}")
            if 'return' in answer:
                return answer['return']

    def run(self, command, longest_s=120):
        """(status, what it said) of a command of bash in the machine, as root; status 124: it took longer."""
        self.commands += 1
        self.agent.send(f'{self.commands} {longest_s} {base64.b64encode(command.encode()).decode()}')
        while True:
            # The time is the machine's, and a busy machine answers late.
            number, status, said = (self.agent.receive(2 * longest_s + 120) + ' ').split(' ', 2)
            if number == str(self.commands):
                return int(status), base64.b64decode(said).decode(errors='replace').strip()

    def said(self, command, longest_s=120):
        """What a command said that has to succeed."""
        status, said = self.run(command, longest_s)
        if status != 0:
            raise Fault(f'{command}: status {status}: {said[-400:]}')
        return said

    def holds(self, command):
        return self.run(command)[0] == 0

    def wait(self, command, longest_s, what=None):
        """Until a command in the machine succeeds."""
        wait_for(lambda: self.holds(command), longest_s, what or command)

    def cut(self):
        """The power goes; again changes nothing."""
        self.process.kill()
        self.process.wait()
        self.console.close()

    # Plugs

    def plug_stick(self, file, reads_a_s=0):
        """A USB stick with these bytes, writable for whoever would write; its name for `pull`. reads_a_s: a slow one, which
        answers so often at most."""
        self.ids += 1
        name = f'stick{self.ids}'
        # All sticks are in one group, which has no limit except for a slow one, which is alone.
        if self.ids == 1:
            self.ask('object-add', **{'qom-type': 'throttle-group', 'id': 'pace'})
        self.ask('qom-set', path='/objects/pace', property='limits', value={'iops-total': reads_a_s})
        self.ask('blockdev-add', **{'driver': 'throttle', 'node-name': f'{name}-bytes', 'throttle-group': 'pace',
                                    'file': {'driver': 'file', 'filename': file, 'locking': 'off'}})
        self.ask('device_add', driver='usb-storage', id=name, drive=f'{name}-bytes', bus='xhci.0', removable=True)
        return name

    def pull_stick(self, name):
        self.ask('device_del', id=name)

        def is_free():
            try:
                self.ask('blockdev-del', **{'node-name': f'{name}-bytes'})
                return True
            except Fault:
                return False
        wait_for(is_free, 60, f'{name} is out', 0.05)

    # Keys and screen

    def press(self, key):
        """A key of the machine's own keyboard, by QEMU's name."""
        self.ask('send-key', keys=[{'type': 'qcode', 'data': key}], **{'hold-time': 150})

    def picture(self):
        """The screen as a PPM file."""
        file = f'{self.folder}/screen.ppm'
        self.ask('screendump', filename=file)
        return file

    def screen(self):
        """The words on the screen, as tesseract reads them, in one line."""
        grey = f'{self.folder}/screen.png'
        subprocess.run(['convert', self.picture(), '-colorspace', 'Gray', '-negate', grey], check=True)
        read = subprocess.run(['tesseract', grey, '-', '--psm', '11'], capture_output=True, text=True, check=True,
                              env={**os.environ, 'OMP_THREAD_LIMIT': '1'})
        return ' '.join(read.stdout.split())

    def wait_screen(self, words, longest_s=180):
        """Until all these words are on the screen, spelt as they are there."""
        last = ''

        def there():
            nonlocal last
            last = self.screen()
            return all(word in last for word in words)
        try:
            return wait_for(there, longest_s, f'the screen says {words}', 1)
        except Fault as fault:
            raise Fault(f'{fault}; it says: {last[-300:]}') from None


class Redirected:
    """A program that emulates a USB device (tests/machines/sim/usbredir), its standard input and output, and its plug in the machine."""

    def __init__(self, machine, program, *arguments):
        self.machine = machine
        self.name = os.path.basename(program)
        path = f'{machine.folder}/{self.name}'
        self.process = subprocess.Popen([program, path, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        bufsize=0)
        wait_for(lambda: os.path.exists(path), 30, f'{self.name} listens', 0.05)
        # QEMU asks again each second after a plug is pulled at the device's end.
        address = {'type': 'unix', 'data': {'path': path}}
        machine.ask('chardev-add', id=self.name, backend={
            'type': 'socket', 'data': {'addr': address, 'server': False, 'reconnect': 1}})
        machine.ask('device_add', driver='usb-redir', id=f'{self.name}-plug', chardev=self.name, bus='xhci.0')

    def order(self, line):
        self.process.stdin.write(line.encode() + b'\n')

    def said(self, longest_s=30):
        """The next line that the program says."""
        if not select.select([self.process.stdout], [], [], longest_s)[0]:
            raise Fault(f'{self.name} says nothing')
        return self.process.stdout.readline().decode().strip()

    def pull(self):
        """The plug at the machine's end; the program ends and leaves its last line."""
        self.machine.ask('device_del', id=f'{self.name}-plug')
        # The plug takes its line to the program with it.
        wait_for(lambda: self.name not in [line['label'] for line in self.machine.ask('query-chardev')], 60,
                 f'{self.name} is out', 0.1)
        try:
            return self.process.communicate(timeout=30)[0].decode().strip()
        finally:
            self.process.kill()
