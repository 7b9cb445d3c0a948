#!/usr/bin/python3
"""material.py PACKAGES OUT: what the network of the figure learns from, out of unpacked packages.

PACKAGES holds each package of packages.tsv, unpacked into a folder of its name. OUT gets figures/, rendered/ and drawn/
(with alpha), grounds/ (without a main thing, as far as one can tell) and photos/ (for marks.py), all small. The same
packages make the same files."""
import glob
import os
import struct
import sys
import zlib

import cv2
import numpy as np
from PIL import Image

HERE = os.path.dirname(os.path.abspath(__file__))
FIGURE_SIDE = 360
GROUND_SIDE = 560
CLIPART = 'animals food plants people tools transportation recreation buildings electronics science containers'.split()
NO_STAMPS = ('cartoon', 'symbols/alphabets', 'symbols/math', 'symbols/money/00', 'symbols/music', 'symbols/shapes',
             'symbols/faces', 'symbols/chess', 'roadsigns', 'flags')
# Of the wallpapers, what is a photograph of ground, plants, water, sky or rooms.
GROUND_NAMES = open(os.path.join(HERE, 'grounds.txt'), encoding='utf-8').read().split()
# Of the pictures of Scratch, those that are photographs.
SCRATCH_PHOTOGRAPHS = open(os.path.join(HERE, 'scratch.txt'), encoding='utf-8').read().split()
# Licences that ask to pass on a text of their own with each picture: we do without those photographs.
GFDL_ONLY = ('animals/kangaroo',)


def emoji():
    """The code points of emoji.txt: animals, plants, food, people in motion and things, no faces and no signs."""
    for word in open(os.path.join(HERE, 'emoji.txt'), encoding='utf-8').read().split():
        first, _, last = word.partition('-')
        yield from range(int(first, 16), int(last or first, 16) + 1)


def unpacked(file):
    """The pictures of a Qt resource file: pairs of name and bytes."""
    data = open(file, 'rb').read()
    version, tree, content, names = struct.unpack('>4I', data[4:20])
    width = 22 if version >= 2 else 14

    def name_at(at):
        length, = struct.unpack('>H', data[names + at:names + at + 2])
        return data[names + at + 6:names + at + 6 + 2 * length].decode('utf-16-be')

    def walk(index, path):
        at = tree + index * width
        name, flags = struct.unpack('>IH', data[at:at + 6])
        path = os.path.join(path, name_at(name)) if index else path
        if flags & 2:
            count, first = struct.unpack('>II', data[at + 6:at + 14])
            for child in range(first, first + count):
                yield from walk(child, path)
        elif path.endswith('.webp'):
            offset, = struct.unpack('>I', data[at + 10:at + 14])
            size, = struct.unpack('>I', data[content + offset:content + offset + 4])
            raw = data[content + offset + 4:content + offset + 4 + size]
            yield path, zlib.decompress(raw[4:]) if flags & 1 else raw

    if data[:4] == b'qres':
        yield from walk(0, '')


def read(file):
    if file.endswith('.gif'):
        return cv2.cvtColor(np.array(Image.open(file).convert('RGBA')), cv2.COLOR_RGBA2BGRA)
    return cv2.imread(file, cv2.IMREAD_UNCHANGED)


def eight_bits(picture):
    picture = picture if picture.dtype == np.uint8 else (picture >> 8).astype('u1')
    return cv2.cvtColor(picture, cv2.COLOR_GRAY2BGR) if picture.ndim == 2 else picture


def shrunk(picture, side):
    scale = side / max(picture.shape[:2])
    return picture if scale >= 1 else cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)


def figure_of(picture):
    """The picture cropped to its alpha; none if it has none, or nearly none, or fills its box."""
    if picture is None or picture.ndim != 3 or picture.shape[2] != 4:
        return None
    picture = eight_bits(picture)
    solid = picture[..., 3] > 127
    rows, columns = np.flatnonzero(solid.any(1)), np.flatnonzero(solid.any(0))
    if not len(rows) or min(len(rows), len(columns)) < 24:
        return None
    cut = picture[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]
    share = (cut[..., 3] > 127).mean()
    return shrunk(cut, FIGURE_SIDE) if .08 < share < .97 else None


def off_white(picture):
    """A thing photographed on white, with alpha; none if the frame is not white."""
    frame = np.concatenate([picture[0], picture[-1], picture[:, 0], picture[:, -1]])
    if (frame.min(1) > 232).mean() < .85:
        return None
    near = np.zeros((picture.shape[0] + 2, picture.shape[1] + 2), 'u1')
    filled = cv2.copyMakeBorder(picture, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=(255, 255, 255))
    near = np.zeros((filled.shape[0] + 2, filled.shape[1] + 2), 'u1')
    cv2.floodFill(filled, near, (0, 0), 0, (6, 6, 6), (12, 12, 12), 4 | cv2.FLOODFILL_MASK_ONLY | (255 << 8))
    alpha = cv2.medianBlur(255 - near[2:-2, 2:-2], 3)
    return np.dstack([picture, cv2.GaussianBlur(alpha, (0, 0), .6)])


def main():
    packages, out = sys.argv[1:]
    for kind in ('figures', 'rendered', 'drawn', 'grounds', 'photos'):
        os.makedirs(os.path.join(out, kind), exist_ok=True)

    def keep(kind, name, picture):
        if picture is not None:
            cv2.imwrite(os.path.join(out, kind, name.replace('/', '+').rsplit('.', 1)[0] + '.png'), picture)

    def found(package, *endings):
        names = glob.glob(os.path.join(packages, package, '**', '*'), recursive=True)
        return sorted(name for name in names if name.endswith(endings) and os.path.isfile(name))

    drawn = set(open(os.path.join(HERE, 'drawn.txt'), encoding='utf-8').read().split())
    for file in found('tuxpaint-stamps-default', '.png'):
        name = file.split('/stamps/', 1)[1]
        if not any(part in name for part in NO_STAMPS) and '_mirror' not in name:
            keep('drawn' if name in drawn else 'figures', 'stamps/' + name, figure_of(read(file)))
    for file in found('openclipart-png', '.png'):
        name = file.split('/png/', 1)[1]
        if name.split('/')[0] in CLIPART:
            picture = read(file)
            if picture is not None and min(picture.shape[:2]) >= 96:
                keep('drawn', 'clipart/' + name, figure_of(picture))
    for file in found('pysiogame', '.png', '.jpg'):
        if '/fish/' in file:
            keep('figures', 'fish/' + os.path.basename(file), figure_of(read(file)))
    for file in found('scratch', '.png', '.jpg', '.gif'):
        name = file.split('/Media/')[-1].split('/', 1)[-1]
        is_photograph = any(part in name for part in SCRATCH_PHOTOGRAPHS)
        if '/Costumes/' in file and name.split('/')[0] in ('Animals', 'People', 'Things', 'Transportation'):
            keep('figures' if is_photograph else 'drawn', 'scratch/' + name, figure_of(read(file)))
        elif '/Backgrounds/' in file and any(part in name for part in GROUND_NAMES):
            keep('grounds', 'scratch/' + name, eight_bits(read(file))[..., :3])
    wanted = set(emoji())
    for file in found('@lobehub/fluent-emoji-3d', '.webp'):
        name = os.path.basename(file).split('.')[0].removesuffix('-fe0f')
        if all(c in '0123456789abcdef' for c in name) and int(name, 16) in wanted:
            keep('rendered', 'emoji/' + name, figure_of(read(file)))
    for file in found('gnome-taquin', '.jpg'):
        if '/cats/1-' in file:
            keep('photos', 'cats/' + os.path.basename(file)[2:], shrunk(read(file), GROUND_SIDE))
    for file in found('palapeli-data', 'european-honey-bee.jpg'):
        keep('photos', 'palapeli/' + os.path.basename(file), shrunk(read(file), GROUND_SIDE))
    for file in found('gcompris-qt-data', '.rcc'):
        for path, data in unpacked(file):
            picture = cv2.imdecode(np.frombuffer(data, 'u1'), cv2.IMREAD_UNCHANGED)
            name = path.split('activities/')[-1].replace('resource/', '').replace('images/', '')
            if picture is None or picture.ndim != 3 or min(picture.shape[:2]) < 120 or any(g in name for g in GFDL_ONLY):
                continue
            if picture.shape[2] == 3 and name.split('/')[0] in (
                    'categorization', 'erase', 'explore_world_animals', 'explore_farm_animals', 'explore_monuments', 'lang'):
                white = off_white(picture)
                if white is not None:
                    keep('figures', 'white/' + name, figure_of(white))
                else:
                    keep('photos', name, shrunk(picture, GROUND_SIDE))
    wallpapers = ('gnome-backgrounds', 'mate-backgrounds', 'lomiri-wallpapers-16.04', 'lomiri-wallpapers-20.04',
                  'plasma-workspace-wallpapers')
    for package in wallpapers:
        for file in found(package, '.jpg', '.jpeg', '.webp', '.png'):
            if any(name in file for name in ('Picture_0B', 'mate/nature/Garden.', 'YellowFlower')):
                keep('photos', package.split('-')[0] + '/' + os.path.basename(file), shrunk(read(file), GROUND_SIDE))
            elif any(name in file for name in GROUND_NAMES):
                keep('grounds', package + '/' + '+'.join(file.split('/')[-4:]),
                     shrunk(eight_bits(read(file))[..., :3], 2 * GROUND_SIDE))
    for file in found('supertuxkart-data', '.jpg'):
        picture = read(file)
        is_bumps = any(part in os.path.basename(file).lower() for part in ('norm', '_nm', 'gloss', 'kart', 'mask'))
        if picture is not None and picture.ndim == 3 and min(picture.shape[:2]) >= 256 and not is_bumps:
            keep('grounds', 'textures/' + '+'.join(file.split('/')[-2:]), shrunk(picture, GROUND_SIDE))


if __name__ == '__main__':
    main()
