#!/usr/bin/python3
"""train.py MATERIAL LIBRARY OUT [--steps N] [--side S] [--rate R] [--batch B] [--marked M] [--anew N]: trains the network of
the figure.

One processor, one thread. OUT/state.pt is written every 200 steps: the same command goes on from there. OUT/log.csv gets a
row each time: step, hours, loss, and the mean intersection over union with held-out figures, and with held-out marked
photographs. --marked M: so large a share are marked photographs. --anew N: forget the rate's fall and learn N more steps from the state."""
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
HELD_OUT = 96


def loss_of(answer, truth):
    likely = torch.sigmoid(answer)
    both = (likely * truth).sum((1, 2, 3))
    overlap = (both + 1) / ((likely + truth).sum((1, 2, 3)) - both + 1)
    return F.binary_cross_entropy_with_logits(answer, truth) + .6 * (1 - overlap).mean()


def batch_of(samples, cues):
    inputs = np.stack([compose.input_of(picture, cues) for picture, _ in samples])
    quarter = [cv2.resize(share, None, fx=.25, fy=.25, interpolation=cv2.INTER_AREA)[None] for _, share in samples]
    return torch.from_numpy(inputs), torch.from_numpy(np.stack(quarter).astype('f4'))


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
    for name, kind, default in (('steps', int, 6000), ('side', int, 192), ('rate', float, 2e-3), ('batch', int, 12),
                                ('anew', int, 0), ('seed', int, 1), ('marked', float, .3)):
        parser.add_argument('--' + name, type=kind, default=default)
    chosen = parser.parse_args()
    torch.set_num_threads(1)
    cv2.setNumThreads(1)
    torch.manual_seed(chosen.seed)
    os.makedirs(chosen.out, exist_ok=True)
    cues = compose.Cues(chosen.library)
    maker = compose.Composer(compose.Material(chosen.material, False), chosen.side, chosen.seed, chosen.marked)
    held = compose.Material(chosen.material, True)
    held_maker = compose.Composer(held, chosen.side, 7)
    held_maker.material.photos = []
    held_pairs = [held_maker.sample(number) for number in range(HELD_OUT)]
    net, mean = FigureNet(), FigureNet()
    learner = torch.optim.AdamW(net.parameters(), chosen.rate, weight_decay=1e-3)
    mean.load_state_dict(net.state_dict())
    at = {'step': 0, 'hours': 0.0, 'from': 0, 'to': chosen.steps}
    state = os.path.join(chosen.out, 'state.pt')
    if os.path.exists(state):
        kept = torch.load(state)
        net.load_state_dict(kept['net'])
        mean.load_state_dict(kept['mean'])
        learner.load_state_dict(kept['learner'])
        at = {**kept['at'], 'to': chosen.steps}
    if chosen.anew:
        at.update({'from': at['step'], 'to': at['step'] + chosen.anew})
    print(f'{sum(p.numel() for p in net.parameters())} parameters, step {at["step"]} of {at["to"]}', flush=True)
    log = os.path.join(chosen.out, 'log.csv')
    if not os.path.exists(log):
        with open(log, 'w', encoding='utf-8') as file:
            file.write('step,hours,side,loss,held_out,marked\n')
    losses, began, hours_before = [], time.time(), at['hours']
    while at['step'] < at['to']:
        part = (at['step'] - at['from']) / (at['to'] - at['from'])
        rate = chosen.rate * min(1, (at['step'] - at['from'] + 1) / 100) * (.5 + .5 * np.cos(np.pi * part)) + 1e-6
        for group in learner.param_groups:
            group['lr'] = rate
        first = at['step'] * chosen.batch
        inputs, truth = batch_of([maker.sample(first + index) for index in range(chosen.batch)], cues)
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
        if at['step'] % STEPS_BETWEEN == 0 or at['step'] == at['to']:
            torch.save({'net': net.state_dict(), 'mean': mean.state_dict(), 'learner': learner.state_dict(), 'at': at},
                       state + '.new')
            os.replace(state + '.new', state)
            row = (at['step'], '%.3f' % at['hours'], chosen.side, '%.4f' % np.mean(losses[-STEPS_BETWEEN:]),
                   '%.4f' % overlap_with(mean, held_pairs, cues, 256),
                   '%.4f' % overlap_with(mean, [(p, m / 255) for p, m in held.marked], cues, 256))
            with open(log, 'a', encoding='utf-8') as file:
                csv.writer(file, lineterminator='\n').writerow(row)
            print(*row, flush=True)


if __name__ == '__main__':
    main()
