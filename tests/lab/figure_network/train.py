#!/usr/bin/python3
"""train.py MATERIAL LIBRARY OUT [--steps N] [--rate R] [--seed S]: trains the network of the figure.

One processor, one thread. N steps in the stages below, the pictures larger from stage to stage; the rate falls over all of
them. OUT/state.pt is written every 200 steps: the same command goes on from there. OUT/log.csv gets a row each time: step,
hours, side, loss, and the mean intersection over union with held-out figures, and with held-out marked photographs."""
import argparse
import csv
import os
import time

import cv2
import numpy as np
import torch
import torch.nn.functional as F

import compose
from network import FigureNet

STEPS_BETWEEN = 200
STAGES = ((.36, 160, 12), (.68, 192, 12), (1, 256, 8))  # until this share of the steps: side, pictures in a step
MOST_IN_A_STEP = 12
HELD_OUT, HELD_OUT_SIDE = 96, 192


def loss_of(answer, truth):
    """How wrong each place is, near the boundary up to five times as much, and how little figures overlap."""
    likely = torch.sigmoid(answer)
    soft = F.avg_pool2d(truth, 7, 1, 3, count_include_pad=False)
    weight = 1 + 16 * soft * (1 - soft)
    both = (likely * truth).sum((1, 2, 3))
    overlap = (both + 1) / ((likely + truth).sum((1, 2, 3)) - both + 1)
    wrong = (F.binary_cross_entropy_with_logits(answer, truth, reduction='none') * weight).mean() / weight.mean()
    return wrong + .6 * (1 - overlap).mean()


def batch_of(samples, cues):
    inputs = np.stack([compose.input_of(picture, cues) for picture, _ in samples])
    half = [cv2.resize(share, None, fx=.5, fy=.5, interpolation=cv2.INTER_AREA)[None] for _, share in samples]
    return torch.from_numpy(inputs), torch.from_numpy(np.stack(half).astype('f4'))


def overlap_with(net, pairs, cues, side):
    """The mean over pairs of picture and share, seen at a side; a likelihood of a half is figure."""
    found = []
    net.eval()
    with torch.no_grad():
        for picture, share in pairs:
            small = cv2.resize(picture, (side, side), interpolation=cv2.INTER_AREA)
            answer = torch.sigmoid(net(torch.from_numpy(compose.input_of(small, cues)[None])))[0, 0].numpy()
            figure = cv2.resize(answer, share.shape[::-1], interpolation=cv2.INTER_LINEAR) > .5
            truth = share > .5
            if truth.any():
                found.append((figure & truth).sum() / (figure | truth).sum())
    net.train()
    return float(np.mean(found)) if found else float('nan')


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('material')
    parser.add_argument('library')
    parser.add_argument('out')
    for name, kind, default in (('steps', int, 4800), ('rate', float, 2e-3), ('seed', int, 1)):
        parser.add_argument('--' + name, type=kind, default=default)
    chosen = parser.parse_args()
    torch.set_num_threads(1)
    cv2.setNumThreads(1)
    torch.manual_seed(chosen.seed)
    os.makedirs(chosen.out, exist_ok=True)
    cues = compose.Cues(chosen.library)
    maker = compose.Composer(compose.Material(chosen.material, False), STAGES[0][1], chosen.seed)
    held = compose.Material(chosen.material, True)
    held_maker = compose.Composer(held, HELD_OUT_SIDE, 7, 0)
    held_pairs = [held_maker.sample(number) for number in range(HELD_OUT)]
    net, mean = FigureNet(), FigureNet()
    learner = torch.optim.AdamW(net.parameters(), chosen.rate, weight_decay=1e-3)
    mean.load_state_dict(net.state_dict())
    at = {'step': 0, 'hours': 0.0}
    state = os.path.join(chosen.out, 'state.pt')
    if os.path.exists(state):
        kept = torch.load(state)
        net.load_state_dict(kept['net'])
        mean.load_state_dict(kept['mean'])
        learner.load_state_dict(kept['learner'])
        at = kept['at']
    print(f'{sum(p.numel() for p in net.parameters())} parameters, step {at["step"]} of {chosen.steps}', flush=True)
    log = os.path.join(chosen.out, 'log.csv')
    if not os.path.exists(log):
        with open(log, 'w', encoding='utf-8') as file:
            file.write('step,hours,side,loss,held_out,marked\n')
    losses, began, hours_before = [], time.time(), at['hours']
    while at['step'] < chosen.steps:
        part = at['step'] / chosen.steps
        _, maker.side, batch = next(stage for stage in STAGES if part < stage[0])
        rate = chosen.rate * min(1, (at['step'] + 1) / 100) * (.5 + .5 * np.cos(np.pi * part)) + 1e-6
        for group in learner.param_groups:
            group['lr'] = rate
        first = at['step'] * MOST_IN_A_STEP
        inputs, truth = batch_of([maker.sample(first + index) for index in range(batch)], cues)
        loss = loss_of(net(inputs), truth)
        learner.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(net.parameters(), 5)
        learner.step()
        losses.append(loss.item())
        at['step'] += 1
        decay = min(.998, at['step'] / (at['step'] + 20))
        with torch.no_grad():
            for kept, new in zip(mean.state_dict().values(), net.state_dict().values()):
                if kept.dtype.is_floating_point:
                    kept.mul_(decay).add_(new, alpha=1 - decay)
        at['hours'] = hours_before + (time.time() - began) / 3600
        if at['step'] % 20 == 0:
            print(at['step'], '%.3f' % np.mean(losses[-20:]), '%.2f h' % at['hours'], flush=True)
        if at['step'] % STEPS_BETWEEN == 0 or at['step'] == chosen.steps:
            torch.save({'net': net.state_dict(), 'mean': mean.state_dict(), 'learner': learner.state_dict(), 'at': at},
                       state + '.new')
            os.replace(state + '.new', state)
            row = (at['step'], '%.3f' % at['hours'], maker.side, '%.4f' % np.mean(losses[-STEPS_BETWEEN:]),
                   '%.4f' % overlap_with(mean, held_pairs, cues, 256),
                   '%.4f' % overlap_with(mean, [(p, m / 255) for p, m in held.marked], cues, 256))
            with open(log, 'a', encoding='utf-8') as file:
                csv.writer(file, lineterminator='\n').writerow(row)
            print(*row, flush=True)


if __name__ == '__main__':
    main()
