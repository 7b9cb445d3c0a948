"""udisks2 as the kiosk sees it, for python3-dbusmock: drives, block devices, mounting.

A test plugs and pulls; what was asked of a device is in the mock's list of calls.
"""

import dbus
from dbusmock import MOCK_IFACE
from dbusmock.mockobject import objects

BUS_NAME = 'org.freedesktop.UDisks2'
MAIN_OBJ = '/org/freedesktop/UDisks2'
IS_OBJECT_MANAGER = True
SYSTEM_BUS = True

BLOCK = BUS_NAME + '.Block'
DRIVE = BUS_NAME + '.Drive'
FILES = BUS_NAME + '.Filesystem'
READ_ONLY = 'ro,nosuid,nodev,noexec,nosymfollow'


def load(mock, parameters):
    """What is plugged in before anybody can ask, as lists of Plug's arguments."""
    for one in parameters.get('plugged', []):
        Plug(mock, *one)


def block_path(name):
    return MAIN_OBJ + '/block_devices/' + name


def drive_path(drive):
    return MAIN_OBJ + '/drives/' + drive


def set_root(block, root):
    roots = [[dbus.Byte(byte) for byte in root.encode() + b'\0']] if root else []
    block.UpdateProperties(FILES, {
        'MountPoints': dbus.Array([dbus.Array(one, signature='y') for one in roots], signature='ay')})


def mount(block, options):
    if not str(options.get('options', '')).startswith(READ_ONLY):
        raise dbus.exceptions.DBusException('not read-only', name=BUS_NAME + '.Error.OptionNotPermitted')
    if block.behaviour == 'fails':
        raise dbus.exceptions.DBusException('wrong fs type', name=BUS_NAME + '.Error.Failed')
    if block.behaviour == 'desktop':
        set_root(block, '/desktop/' + block.label)
        raise dbus.exceptions.DBusException('already', name=BUS_NAME + '.Error.AlreadyMounted')
    root = '/media/' + block.label
    if block.behaviour != 'late':
        set_root(block, root)
    return root


def unmount(block, _options):
    set_root(block, '')


@dbus.service.method(MOCK_IFACE, in_signature='ssssts', out_signature='')
def Plug(self, name, drive, bus, file_system, detected_us, behaviour):
    """behaviour: 'good', 'fails', 'late' (mounted, but the property never says so), 'desktop'
    (somebody else is quicker), 'mounted' (it already is)."""
    path = block_path(name)
    if drive_path(drive) not in objects:
        self.AddObject(drive_path(drive), DRIVE,
                       {'ConnectionBus': dbus.String(bus),
                        'TimeMediaDetected': dbus.UInt64(detected_us)}, [])
        self.object_manager_emit_added(drive_path(drive))
    self.AddObject(path, BLOCK,
                   {'Drive': dbus.ObjectPath(drive_path(drive)),
                    'IdUsage': dbus.String('crypto' if file_system == 'crypto_LUKS' else 'filesystem'),
                    'IdType': dbus.String(file_system),
                    'Size': dbus.UInt64(1 << 30),
                    'HintSystem': dbus.Boolean(bus == 'ata'),
                    'HintIgnore': dbus.Boolean(False)}, [])
    block = objects[path]
    block.behaviour = behaviour
    block.label = name
    block.AddProperties(FILES, {'MountPoints': dbus.Array([], signature='ay')})
    block.AddMethod(FILES, 'Mount', 'a{sv}', 's', mount)
    block.AddMethod(FILES, 'Unmount', 'a{sv}', '', unmount)
    if behaviour == 'mounted':
        set_root(block, '/media/' + name)
    self.object_manager_emit_added(path)


@dbus.service.method(MOCK_IFACE, in_signature='ss', out_signature='')
def Pull(self, name, drive):
    for path in (block_path(name), drive_path(drive)):
        self.object_manager_emit_removed(path)
        self.RemoveObject(path)


@dbus.service.method(MOCK_IFACE, in_signature='s', out_signature='as')
def Asked(self, name):
    """'Mount vfat ro,...', 'Unmount forced', in order."""
    asked = []
    for _, method, arguments in objects[block_path(name)].call_log:
        options = arguments[0]
        if method == 'Mount':
            asked.append('Mount %s %s' % (options['fstype'], options['options']))
        if method == 'Unmount':
            asked.append('Unmount forced' if options.get('force') else 'Unmount')
    return dbus.Array(asked, signature='s')
