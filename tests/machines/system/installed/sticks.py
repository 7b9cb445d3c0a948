"""USB sticks as files: what a visitor might bring, clean and as it was left by a machine that lost its power."""
import hashlib
import os
import subprocess

PNG = 'circle.png'
PDF = 'house.pdf'


def _run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def sha256(file):
    with open(file, 'rb') as bytes_of:
        return hashlib.file_digest(bytes_of, 'sha256').hexdigest()


def _pdf(shapes):
    """One page of 200 x 150 points with these drawing orders."""
    parts = [b'<< /Type /Catalog /Pages 2 0 R >>', b'<< /Type /Pages /Kids [3 0 R] /Count 1 >>',
             b'<< /Type /Page /Parent 2 0 R /MediaBox [0 0 200 150] /Contents 4 0 R /Resources << >> >>',
             b'<< /Length %d >>\nstream\n%s\nendstream' % (len(shapes), shapes)]
    text, places = b'%PDF-1.4\n', []
    for number, part in enumerate(parts, 1):
        places.append(len(text))
        text += b'%d 0 obj\n%s\nendobj\n' % (number, part)
    table = b''.join(b'%010d 00000 n \n' % place for place in places)
    return text + (b'xref\n0 5\n0000000000 65535 f \n%strailer\n<< /Size 5 /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n'
                   % (table, len(text)))


def make_files(folder, is_large=False):
    """The two files of every stick, in a new folder; large: the picture is one that takes long to read."""
    os.makedirs(folder, exist_ok=True)
    if is_large:
        _run('convert', '-size', '2400x2400', 'xc:gray', '+noise', 'Random', f'{folder}/{PNG}')
    else:
        _run('convert', '-size', '320x240', 'xc:white', '-fill', 'none', '-stroke', 'black', '-strokewidth', '6',
             '-draw', 'circle 160,120 160,40', f'{folder}/{PNG}')
    with open(f'{folder}/{PDF}', 'wb') as out:
        out.write(_pdf(b'4 w 40 20 120 70 re S 40 90 m 100 140 l 160 90 l S'))
    return folder


def make_many_folders(folder, count=300):
    """Folders with a file each, which take long to list."""
    for number in range(count):
        os.makedirs(f'{folder}/{number}')
        with open(f'{folder}/{number}/{PNG}', 'wb') as out:
            out.write(b'a picture')
    return folder


def _blank(file, megabytes):
    with open(file, 'wb') as out:
        out.truncate(megabytes << 20)


def _set_bits(file, offset, bits):
    with open(file, 'r+b') as disk:
        disk.seek(offset)
        byte = disk.read(1)[0]
        disk.seek(offset)
        disk.write(bytes([byte | bits]))


def make_fat(file, folder, is_dirty=False):
    """FAT32 in the first partition; dirty: the bit in the boot sector, and that in the table, which say that it was
    not unmounted."""
    start = 1 << 20
    _blank(file, 66)
    subprocess.run(['sfdisk', '-q', file], input=b'start=2048, type=c\n', check=True)
    _run('mkfs.vfat', '-F', '32', '--offset', start // 512, file, 65 << 10)
    _run('mcopy', '-s', '-i', f'{file}@@{start}', *(f'{folder}/{name}' for name in sorted(os.listdir(folder))), '::')
    if is_dirty:
        _set_bits(file, start + 0x41, 1)
        with open(file, 'r+b') as disk:
            disk.seek(start + 14)
            high = start + int.from_bytes(disk.read(2), 'little') * 512 + 7
            disk.seek(high)
            byte = disk.read(1)[0]
            disk.seek(high)
            disk.write(bytes([byte & ~0x08]))


def make_ext4(file, folder, is_dirty=False):
    """Dirty: the journal is said to hold what the volume has not."""
    _blank(file, 32)
    _run('mke2fs', '-q', '-t', 'ext4', '-d', folder, file)
    if is_dirty:
        _run('debugfs', '-w', '-R', 'feature needs_recovery', file)


def make_ntfs(file, folder, is_dirty=False):
    """Dirty: Windows is asleep on it (a file hiberfil.sys that begins as one of a sleeping machine)."""
    _blank(file, 16)
    _run('mkfs.ntfs', '-q', '-Q', '-F', file)
    for name in sorted(os.listdir(folder)):
        _run('ntfscp', '-q', file, f'{folder}/{name}', name)
    if is_dirty:
        asleep = f'{file}.hiberfil'
        with open(asleep, 'wb') as out:
            out.write(b'hibr' + bytes(4092))
        _run('ntfscp', '-q', file, asleep, 'hiberfil.sys')
        os.remove(asleep)


def make_exfat(machine, file, other, is_dirty=False):
    """Nothing but a kernel writes exFAT: the machine formats it and copies from the stick `other`. The kiosk must not
    be running. Dirty: the bit VolumeDirty."""
    _blank(file, 16)
    to, source = machine.plug_stick(file), machine.plug_stick(other)
    machine.wait('(($(ls /dev/sd? 2>/dev/null | wc -l) == 2))', 60, 'two sticks')
    size = os.path.getsize(file) // 512
    machine.said(f'for disk in /sys/block/sd?; do [[ $(<$disk/size) == {size} ]] && to=/dev/${{disk##*/}} || '
                 'from=/dev/${disk##*/}; done; udevadm settle; mkfs.exfat "$to" && mkdir -p /run/to /run/from && '
                 'mount "$to" /run/to && mount -o ro "$from" /run/from && cp /run/from/*.* /run/to && '
                 'umount /run/to /run/from && sync')
    machine.pull_stick(to)
    machine.pull_stick(source)
    machine.wait('! ls /dev/sd? 2>/dev/null', 60, 'no stick')
    if is_dirty:
        _set_bits(file, 106, 2)
