"""How fast the counter runs that an emulated processor shows as its own. A busy host makes the machine measure it wrong
while it boots, and its clock then runs at several times its pace: time-outs come early."""
import ctypes
import mmap
import platform
import time

READ = bytes.fromhex('0f31 48c1e220 4809d0 c3')  # rdtsc; shl rdx, 32; or rax, rdx; ret


def ticks_kHz(span_s=0.5):
    """Ticks of this machine's counter in a millisecond; None where there is no such counter."""
    if platform.machine() != 'x86_64':
        return None
    with mmap.mmap(-1, mmap.PAGESIZE, prot=mmap.PROT_READ | mmap.PROT_WRITE | mmap.PROT_EXEC) as page:
        page.write(READ)
        place = ctypes.c_char.from_buffer(page)
        count = ctypes.CFUNCTYPE(ctypes.c_uint64)(ctypes.addressof(place))
        began, first = time.monotonic(), count()
        time.sleep(span_s)
        ended, last = time.monotonic(), count()
        del place
    return round((last - first) / (ended - began) / 1000)
