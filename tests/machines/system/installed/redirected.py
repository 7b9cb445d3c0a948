"""An emulated USB device (tests/machines/sim/usbredir) at the machine's USB controller."""
import os
import select
import subprocess

from machine import Fault, wait_for


class Redirected:
    """A program that emulates a device, its standard input and output, and its plug in the machine."""

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
