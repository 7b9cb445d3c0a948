#!/usr/bin/python3
"""marks.py MATERIAL: masks of the figures that we marked by hand in photographs: MATERIAL/marked/NAME.png, NAME.mask.png.

marks.tsv has a photograph's name and rough outlines, corners in per cent of width and height. GrabCut draws them onto
the picture's edges within a band round the outline."""
import os
import sys

import cv2
import numpy as np

BAND = .035  # of the longer side, to both sides of the outline
LIMIT = 500


def mask_of(picture, outlines):
    height, width = picture.shape[:2]
    rough = np.zeros((height, width), 'u1')
    for outline in outlines.split(';'):
        corners = [[float(n) for n in corner.split(',')] for corner in outline.split()]
        points = np.array(corners) * (width, height) / 100
        cv2.fillPoly(rough, [np.round(points).astype(int)], 1)
    inside = cv2.distanceTransform(rough, cv2.DIST_L2, 5)
    outside = cv2.distanceTransform(1 - rough, cv2.DIST_L2, 5)
    band = BAND * max(width, height)
    mask = np.where(rough > 0, cv2.GC_PR_FGD, cv2.GC_PR_BGD).astype('u1')
    # A thin figure has sure places too: those deepest in it.
    mask[inside > min(band, .6 * inside.max())] = cv2.GC_FGD
    mask[outside > band] = cv2.GC_BGD
    cv2.setRNGSeed(1)
    cv2.grabCut(picture, mask, None, np.zeros((1, 65)), np.zeros((1, 65)), 4, cv2.GC_INIT_WITH_MASK)
    figure = ((mask == cv2.GC_FGD) | (mask == cv2.GC_PR_FGD)).astype('u1') * 255
    return cv2.GaussianBlur(cv2.medianBlur(figure, 5), (0, 0), 1)


def main():
    folder, = sys.argv[1:]
    here = os.path.dirname(os.path.abspath(__file__))
    os.makedirs(os.path.join(folder, 'marked'), exist_ok=True)
    with open(os.path.join(here, 'marks.tsv'), encoding='utf-8') as file:
        rows = [line.rstrip('\n').split('\t') for line in file][1:]
    for name, outlines in rows:
        picture = cv2.imread(os.path.join(folder, 'photos', name + '.png'))
        if picture is None:
            raise SystemExit(f'{name}: no such photograph; material.py makes them')
        scale = min(1, LIMIT / max(picture.shape[:2]))
        picture = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        cv2.imwrite(os.path.join(folder, 'marked', name + '.png'), picture)
        cv2.imwrite(os.path.join(folder, 'marked', name + '.mask.png'), mask_of(picture, outlines))


if __name__ == '__main__':
    main()
