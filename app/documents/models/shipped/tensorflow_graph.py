"""A graph of TensorFlow.js: NAME.json says what is done, NAME.bin holds the weights."""
import base64
import json

import numpy as np

STORED = {'float16': '<f2', 'float32': '<f4', 'int32': '<i4'}


def text(value):
    return base64.b64decode(value).decode()


def plain(attribute):
    """An attribute as a value of Python's; None for those that only say how numbers are stored."""
    if 'list' in attribute:
        values = attribute['list']
        return [int(value) for value in values.get('i', [])] + [text(value) for value in values.get('s', [])]
    if 'shape' in attribute:
        return [int(dimension['size']) for dimension in attribute['shape']['dim']]
    kinds = {'s': text, 'i': int, 'f': float, 'b': bool}
    return next((kinds[kind](value) for kind, value in attribute.items() if kind in kinds), None)


class Node:
    """One operation; its inputs are names of others, with ":1" behind them for a second output."""

    def __init__(self, entry):
        self.name, self.kind, self.inputs = entry['name'], entry['op'], entry.get('input', [])
        self.attributes = {key: plain(value) for key, value in entry.get('attr', {}).items()}

    def __getitem__(self, attribute):
        return self.attributes[attribute]


def weights_of(manifest, data):
    """The arrays by their names, half floats widened."""
    weights, at = {}, 0
    for entry in (entry for group in manifest for entry in group['weights']):
        stored = np.dtype(STORED[entry.get('quantization', entry)['dtype']])
        count = int(np.prod(entry['shape'], dtype=int))
        array = np.frombuffer(data, stored, count, at).reshape(entry['shape'])
        weights[entry['name']] = array.astype('f4') if stored.kind == 'f' else array
        at += count * stored.itemsize
    if at != len(data):
        raise SystemExit('the weights are not whole')
    return weights


class Graph:
    def __init__(self, folder, name):
        graph = json.loads((folder / f'{name}.json').read_text(encoding='utf-8'))
        self.nodes = {entry['name']: Node(entry) for entry in graph['modelTopology']['node']}
        self.weights = weights_of(graph['weightsManifest'], (folder / f'{name}.bin').read_bytes())

    def outputs(self):
        """The names of the nodes that nothing else takes."""
        taken = {name.partition(':')[0] for node in self.nodes.values() for name in node.inputs}
        return [name for name in self.nodes if name not in taken]
