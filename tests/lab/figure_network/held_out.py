#!/usr/bin/python3
"""held_out.py MATERIAL OUT: the held-out marked photographs, as tests/lab/bench/vision/run --figures takes them.

OUT/pictures has NAME.jpg and NAME-human1.png, white on the boundary of the figure; OUT/truths has NAME.png. OUT/none has
NAME.jpg of the held-out grounds of none.txt, which have no main thing."""
import glob
import os
import sys

import cv2
import numpy as np

sys.dont_write_bytecode = True
import compose  # noqa: E402


def main():
    material, out = sys.argv[1:]
    for kind in ('pictures', 'truths', 'none'):
        os.makedirs(os.path.join(out, kind), exist_ok=True)
    for name in sorted(glob.glob(os.path.join(material, 'marked', '*.mask.png'))):
        if not compose.is_held_out(name):
            continue
        short = os.path.basename(name).split('+')[-1][:-len('.mask.png')]
        figure = ((cv2.imread(name, 0) > 127) * 255).astype('u1')
        boundary = cv2.morphologyEx(figure, cv2.MORPH_GRADIENT, np.ones((2, 2), 'u1'))
        cv2.imwrite(os.path.join(out, 'pictures', short + '.jpg'), cv2.imread(name.replace('.mask', '')),
                    [cv2.IMWRITE_JPEG_QUALITY, 97])
        cv2.imwrite(os.path.join(out, 'pictures', short + '-human1.png'), boundary)
        cv2.imwrite(os.path.join(out, 'truths', short + '.png'), figure)
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'none.txt'), encoding='utf-8') as file:
        for name in file.read().splitlines():
            cv2.imwrite(os.path.join(out, 'none', name + '.jpg'), cv2.imread(os.path.join(material, 'grounds', name + '.png')),
                        [cv2.IMWRITE_JPEG_QUALITY, 97])


if __name__ == '__main__':
    main()
