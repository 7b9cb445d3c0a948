"""Pictures to learn from, each made from its number alone: figures of free packages on free grounds, made hard.

A sample is a square BGR picture of 8 bits and the share of figure at each of its pixels, 0..1."""
import ctypes
import glob
import os
import zlib

import cv2
import numpy as np

CUES = 6


def is_held_out(name):
    """Kept for validation: one figure in seven, all pictures of one kind of thing together; and half of the animals of
    one collection of photographs."""
    name = os.path.basename(name).replace('.mask', '').replace('.png', '')
    number = zlib.crc32(name.split('+')[-1].rstrip('0123456789_- ').lower().encode())
    return number % 7 == 3 or (name.startswith('erase') and number % 2 == 0)


class Cues:
    """vision/figure/figure_cues of a picture, by the library that the run script builds."""

    def __init__(self, library):
        self.call = ctypes.CDLL(library).figure_cues_of

    def __call__(self, picture):
        planes = np.empty((CUES,) + picture.shape[:2], 'f4')
        picture = np.ascontiguousarray(picture)
        self.call(picture.ctypes.data_as(ctypes.c_void_p), ctypes.c_int(picture.shape[0]),
                  planes.ctypes.data_as(ctypes.c_void_p))
        return planes


def input_of(picture, cues):
    """What the network sees: red, green, blue as (v - 128) / 128, and the cues."""
    colours = (picture[..., ::-1].astype('f4') - 128) / 128
    return np.concatenate([colours.transpose(2, 0, 1), cues(picture)])


class Material:
    """What material.py wrote, for learning or for validation."""

    def __init__(self, folder, for_validation):
        def all_of(kind, ending='*.png'):
            names = sorted(glob.glob(os.path.join(folder, kind, ending)))
            return [cv2.imread(name, cv2.IMREAD_UNCHANGED) for name in names
                    if is_held_out(name) == for_validation]
        self.figures = all_of('figures')
        self.rendered = all_of('rendered')
        self.drawn = all_of('drawn')
        self.scenes = [ground for ground in all_of('grounds', '[!t]*.png')]
        self.textures = all_of('grounds', 't*.png')
        self.marked = []  # pairs of photograph and mask: marks.py
        marked = set()
        for name in sorted(glob.glob(os.path.join(folder, 'marked', '*.mask.png'))):
            if is_held_out(name) == for_validation:
                picture, mask = cv2.imread(name.replace('.mask', '')), cv2.imread(name, 0)
                marked.add(os.path.basename(name).replace('.mask', ''))
                # Animals in the open are the hard ones: each twice.
                is_easy = 'categorization' in name or 'monuments' in name
                self.marked += [(picture, mask)] * (1 if for_validation or is_easy else 2)
                rows, columns = np.flatnonzero((mask > 127).any(1)), np.flatnonzero((mask > 127).any(0))
                self.figures.append(np.dstack([picture, mask])[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1])
        # Grounds beside figures: pairs again, without a mask where nobody marked a main thing.
        self.photos = [(picture, mask) for picture, mask in self.marked if min(mask.shape) >= 128]
        for name in sorted(glob.glob(os.path.join(folder, 'photos', '*.png'))):
            if os.path.basename(name) not in marked and not for_validation and not is_held_out(name):
                self.photos.append((cv2.imread(name), None))


class Composer:
    def __init__(self, material, side, seed, marked_share=.45):
        self.material, self.side, self.seed, self.marked_share = material, side, seed, marked_share

    def sample(self, number):
        self.r = np.random.RandomState([self.seed & 0xffffffff, number])
        if self.material.marked and self.chance(self.marked_share):
            picture, share = self.marked()
        else:
            picture, share = self.composed()
        return self.taken(picture, share), share

    def chance(self, likelihood):
        return self.r.rand() < likelihood

    def one_of(self, things):
        return things[self.r.randint(len(things))]

    def between(self, low, high):
        return self.r.uniform(low, high)

    # The ground.

    def crop(self, picture, least=.35):
        height, width = picture.shape[:2]
        across = int(width * self.between(least, 1))
        down = int(np.clip(across * self.between(.6, 1.6), least * height, height))
        x, y = self.r.randint(width - across + 1), self.r.randint(height - down + 1)
        out = cv2.resize(picture[y:y + down, x:x + across, :3], (self.side, self.side), interpolation=cv2.INTER_AREA)
        return out[:, ::-1] if self.chance(.5) else out

    def beside_figure(self, picture, mask):
        """A part of the photograph without what is marked in it, or of a ground if none is found."""
        height, width = picture.shape[:2]
        for _ in range(12):
            down, across = [int(n * self.between(.3, .8)) for n in (height, width)]
            y, x = self.r.randint(height - down + 1), self.r.randint(width - across + 1)
            if mask is None or (mask[y:y + down, x:x + across] > 127).mean() < .005:
                return picture[y:y + down, x:x + across]
        return self.one_of(self.material.scenes)

    def one_ground(self):
        kind = self.r.rand()
        if kind < .40 or not self.material.photos:
            return self.crop(self.one_of(self.material.scenes), .25)
        if kind < .62:
            return self.crop(self.beside_figure(*self.one_of(self.material.photos)), .5)
        if kind < .86:
            return self.crop(self.one_of(self.material.textures), .3)
        if kind < .93:  # the inside of another figure: fur, skin, bark
            figure = self.one_of(self.material.figures)
            height, width = figure.shape[:2]
            return self.crop(figure[height // 3:2 * height // 3 + 8, width // 3:2 * width // 3 + 8], .5)
        ends = self.r.uniform(0, 255, (2, 1, 1, 3))
        fall = np.linspace(0, 1, self.side)[:, None, None] * np.ones((1, self.side, 1))
        return (ends[0] * (1 - fall) + ends[1] * fall).astype('u1')

    def ground(self):
        ground = self.jitter(self.one_ground(), .7)
        if self.chance(.3):  # ground below, another behind
            below = self.jitter(self.one_ground(), .7)
            line = self.side * self.between(.3, .8) + np.cumsum(self.r.randn(self.side)) * self.between(0, .8)
            mask = (np.arange(self.side)[:, None] > line[None]).astype('f4')
            mask = cv2.GaussianBlur(mask, (0, 0), self.between(.5, 3))[..., None]
            ground = ground * (1 - mask) + below * mask
        if self.chance(.4):
            ground = cv2.GaussianBlur(ground, (0, 0), self.between(.6, 5) * self.side / 256)
        return ground

    # The colours.

    def jitter(self, picture, strength=1.0):
        picture = picture.astype('f4')
        mean = picture.mean((0, 1))
        picture = (picture - mean) * self.between(1 - .35 * strength, 1 + .3 * strength) + mean
        picture = picture * (1 + strength * self.r.uniform(-.15, .15, 3)) + strength * self.between(-30, 30)
        if self.chance(.15 * strength):
            picture = picture[..., self.r.permutation(3)]
        return np.clip(picture, 0, 255)

    def like_ground(self, colours, alpha, ground):
        """The colours with means and deviations nearer to those of the ground round about: camouflage."""
        solid = alpha > .5
        if solid.sum() < 30:
            return colours
        how_much = self.between(.4, 1)
        near = int(self.side * self.between(.05, .3)) | 1
        round_about = (cv2.dilate(alpha, np.ones((near, near), 'u1')) > .5) & ~solid
        of_figure = colours[solid]
        of_ground = ground[round_about] if round_about.sum() > 30 else ground.reshape(-1, 3)
        scale = (of_ground.std(0) + 4) / (of_figure.std(0) + 4)
        like = (colours - of_figure.mean(0)) * np.clip(scale, .4, 2.5) + of_ground.mean(0) + self.between(-25, 25)
        return np.clip(colours * (1 - how_much) + like * how_much, 0, 255)

    # The figure.

    def placed(self, figure, share, at, angle=None):
        """The figure's colours and alpha over the whole picture; share: of the picture's area."""
        height, width = figure.shape[:2]
        solid = (figure[..., 3] > 127).mean() * height * width
        scale = np.sqrt(share * self.side ** 2 / max(solid, 1))
        stretch = np.exp(self.between(-.3, .3))
        turn = np.deg2rad(self.r.randn() * 9 if angle is None else angle)
        flip = -1 if self.chance(.5) else 1
        move = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) * scale
        move[0] *= stretch * 1.0
        move[1] /= stretch
        move[:, 0] *= flip
        shift = np.array(at) * self.side - move @ (width / 2, height / 2)
        if scale < .6:
            figure = cv2.resize(figure, None, fx=2 * scale, fy=2 * scale, interpolation=cv2.INTER_AREA) \
                if min(width, height) * 2 * scale >= 4 else figure
            again = np.array([width / figure.shape[1], height / figure.shape[0]])
            move = move * again[None]
        there = cv2.warpAffine(figure, np.hstack([move, shift[:, None]]), (self.side, self.side),
                               flags=cv2.INTER_LINEAR)
        alpha = cv2.GaussianBlur(there[..., 3].astype('f4') / 255, (0, 0), self.between(.4, .9))
        colours = there[..., :3].astype('f4')
        return colours, alpha

    def a_figure(self):
        kind = self.r.rand()
        if kind < .62:
            return self.one_of(self.material.figures)
        if kind < .84:
            figure = self.one_of(self.material.rendered)
            return self.filled(figure, 1) if self.chance(.5) else figure
        figure = self.one_of(self.material.drawn)
        return self.filled(figure, self.between(0, .6)) if self.chance(.75) else figure

    def filled(self, figure, shade):
        """The figure with a texture instead of its colours; shade: how much of its own light and dark is kept, 0..1."""
        height, width = figure.shape[:2]
        fill = self.one_of(self.material.textures + self.material.scenes)[..., :3]
        side = min(fill.shape[:2])
        part = max(8, int(side * self.between(.3, 1)))
        y, x = [self.r.randint(n - part + 1) for n in fill.shape[:2]]
        fill = cv2.resize(fill[y:y + part, x:x + part], (width, height), interpolation=cv2.INTER_AREA).astype('f4')
        grey = figure[..., :3].mean(2, keepdims=True)
        light = grey / max(grey[figure[..., 3] > 127].mean(), 32)
        return np.dstack([np.clip(fill * (1 - shade + shade * light), 0, 255).astype('u1'), figure[..., 3]])

    def put(self, picture, colours, alpha):
        return picture * (1 - alpha[..., None]) + colours * alpha[..., None]

    def lit(self, colours):
        if not self.chance(.35):
            return colours
        turn = self.between(0, 2 * np.pi)
        y, x = np.mgrid[-1:1:self.side * 1j, -1:1:self.side * 1j]
        return np.clip(colours * (1 + self.between(.1, .5) * (np.cos(turn) * x + np.sin(turn) * y))[..., None], 0, 255)

    def composed(self):
        ground = self.ground()
        picture = ground.copy()
        share = np.zeros((self.side, self.side), 'f4')
        if self.chance(.3):  # things that are not meant: small, far, dark or out of focus, mostly at the frame
            for _ in range(self.r.randint(1, 5)):
                at = self.r.uniform(-.05, 1.05, 2)
                if self.chance(.7):
                    at[self.r.randint(2)] = self.one_of((self.between(-.05, .12), self.between(.88, 1.05)))
                colours, alpha = self.placed(self.a_figure(), self.between(.001, .02), at)
                colours = self.like_ground(self.jitter(colours), alpha, ground)
                soft = self.between(.8, 4) * self.side / 256
                colours, alpha = cv2.GaussianBlur(colours, (0, 0), soft), cv2.GaussianBlur(alpha, (0, 0), soft)
                picture = self.put(picture, colours, alpha)
        if self.chance(.05):
            return picture, share
        figure, size = self.a_figure(), np.exp(self.between(np.log(.03), np.log(.6)))
        spread = .17 * (1 - size)
        middle = np.clip(.5 + self.r.randn(2) * spread, .15, .85)
        if self.chance(.18):  # cut by the frame
            middle[self.r.randint(2)] = self.one_of((self.between(-.02, .25), self.between(.75, 1.02)))
        count = self.r.choice((1, 2, 3, 4), p=(.74, .14, .07, .05))
        hidden = self.chance(.42)
        for index in range(count):
            if index and self.chance(.3):
                figure = self.a_figure()
            at = middle if count == 1 else np.clip(middle + self.r.randn(2) * .2, .1, .9)
            colours, alpha = self.placed(figure, size / count * self.between(.6, 1.2), at)
            colours = self.lit(self.jitter(colours))
            if hidden:
                colours = self.like_ground(colours, alpha, ground)
            if self.chance(.4):
                picture = self.shadowed(picture, alpha)
            elif self.chance(.3):
                alpha = self.sunk(alpha)
            picture = self.put(picture, colours, alpha)
            share = np.maximum(share, alpha)
        if self.chance(.15):
            picture = self.behind_blades(picture, share, ground)
        if self.chance(.12):  # something in front
            colours, alpha = self.placed(self.one_of(self.material.drawn), self.between(.02, .1),
                                         self.r.uniform(0, 1, 2), self.between(0, 360))
            picture = self.put(picture, self.like_ground(colours, alpha, ground), alpha)
            share = share * (1 - alpha)
        return picture, share

    def sunk(self, alpha):
        """The figure without its foot: in grass, snow or water."""
        rows = np.flatnonzero(alpha.max(1) > .5)
        if len(rows) < 8:
            return alpha
        line = rows[-1] - (rows[-1] - rows[0]) * self.between(.03, .3)
        rough = cv2.GaussianBlur(self.r.randn(1, self.side), (0, 0), self.between(.5, 6))[0]
        line = line + rough / (rough.std() + 1e-6) * self.side * self.between(0, .02)
        above = np.clip(line[None] - np.arange(self.side)[:, None], 0, 1)
        return (alpha * cv2.GaussianBlur(above, (0, 0), self.between(.3, 1.5))).astype('f4')

    def behind_blades(self, picture, share, ground):
        """Thin blades in the ground's colours before the figure; a person would outline it across them, so it stays."""
        rows, columns = np.flatnonzero(share.max(1) > .5), np.flatnonzero(share.max(0) > .5)
        if not len(rows):
            return picture
        picture = np.ascontiguousarray(picture, 'f4')
        height = (rows[-1] - rows[0] + 1) * self.between(.2, 1.1)
        foot = min(self.side, rows[-1] + self.side * self.between(0, .1))
        lean = self.between(-.3, .3)
        for _ in range(self.r.randint(8, 50)):
            x = self.between(columns[0] - 8, columns[-1] + 8)
            up = height * self.between(.3, 1)
            bend = up * (lean + self.between(-.25, .25))
            colour = ground[self.r.randint(self.side), self.r.randint(self.side)] * self.between(.7, 1.2)
            ends = np.int32([[x, foot], [x + .3 * bend, foot - .5 * up], [x + bend, foot - up]])
            cv2.polylines(picture, [ends], False, [float(c) for c in colour], 1, cv2.LINE_AA)
        return picture

    def shadowed(self, picture, alpha):
        move = np.float32([[1, self.between(-.3, .3), self.between(-8, 8)], [0, self.between(.4, 1), 0]])
        foot = np.flatnonzero(alpha.max(1) > .5)
        foot = foot[-1] if len(foot) else self.side
        move[1, 2] = foot * (1 - move[1, 1]) + self.between(0, 6)
        dark = cv2.warpAffine(alpha, move, (self.side, self.side))
        dark = cv2.GaussianBlur(dark, (0, 0), self.between(1, 7)) * self.between(.2, .7)
        return picture * (1 - dark[..., None])

    def marked(self):
        picture, mask = self.one_of(self.material.marked)
        height, width = mask.shape
        across, down = [int(n * self.between(.62, 1)) for n in (width, height)]
        x, y = self.r.randint(width - across + 1), self.r.randint(height - down + 1)
        picture, mask = [cv2.resize(plane[y:y + down, x:x + across], (self.side, self.side),
                                    interpolation=cv2.INTER_AREA) for plane in (picture, mask)]
        if self.chance(.5):
            picture, mask = picture[:, ::-1], mask[:, ::-1]
        return self.jitter(self.lit(picture.astype('f4'))), np.ascontiguousarray(mask.astype('f4') / 255)

    # The camera.

    def taken(self, picture, share):
        if self.chance(.25):
            picture = self.lit(picture)
        if self.chance(.06):
            picture = np.repeat(picture.mean(2, keepdims=True), 3, 2)
        if self.chance(.3):
            picture = cv2.GaussianBlur(picture, (0, 0), self.between(.4, 1.3))
        if self.chance(.5):
            picture = 255 * (np.clip(picture, 0, 255) / 255) ** self.between(.7, 1.5)
        if self.chance(.6):
            picture = picture + self.r.randn(*picture.shape) * self.between(1, 9)
        picture = np.ascontiguousarray(np.clip(picture, 0, 255).astype('u1'))
        if self.chance(.5):
            _, data = cv2.imencode('.jpg', picture, [cv2.IMWRITE_JPEG_QUALITY, int(self.between(30, 95))])
            picture = cv2.imdecode(data, cv2.IMREAD_COLOR)
        return picture
