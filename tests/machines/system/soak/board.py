"""The board of soak_board.h, seen through its file. It holds its torque whatever dies."""

import mmap
import os
import struct

import processes

SIZE = 80
PRESSED, OWNER, OPENED, READS, TORQUE, ZEROED_NS, UNPLUGGED = 0, 8, 12, 16, 24, 32, 72


class Board:
    def __init__(self, path):
        self.path = path
        with open(path, 'wb') as file:
            file.write(bytes(SIZE))
        self.file = os.open(path, os.O_RDWR)
        self.memory = mmap.mmap(self.file, SIZE)

    def close(self):
        self.memory.close()
        os.close(self.file)

    def number(self, offset, kind='i'):
        return struct.unpack_from(kind, self.memory, offset)[0]

    def put(self, offset, value):
        struct.pack_into('i', self.memory, offset, value)

    def move_hand(self, moves):
        self.put(PRESSED, int(moves))

    def plug(self, is_in):
        self.put(UNPLUGGED, int(not is_in))

    @property
    def owner(self):
        """The servo that holds it or held it last."""
        return self.number(OWNER)

    @property
    def opened(self):
        return self.number(OPENED)

    @property
    def has_torque(self):
        return self.number(TORQUE) != 0

    @property
    def zeroed_s(self):
        """When torque last went to zero, of the monotonic clock."""
        return 1e-9 * self.number(ZEROED_NS, 'q')

    def ticks_for(self, kiosk):
        """Of the servo that this kiosk has; 0 while it has none."""
        servo = processes.stat_of(self.owner) if self.owner else None
        return self.number(READS, 'Q') if servo and servo['parent'] == kiosk else 0
