#!/usr/bin/python3
"""export.py OUT/state.pt NETWORK.onnx [LIMIT]: what train.py learned, as OpenCV 4.6 reads it, with weights of 8 bits.

LIMIT is the likelihood of the trained network from which a place is figure; it becomes the 0.3 of vision/figure/figures.h.
judge.py says which is best on held-out photographs."""
import io
import math
import os
import sys

import onnx
import torch
from onnx import TensorProto, helper

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path[:0] = [HERE, os.path.join(HERE, '..', '..', '..', 'app', 'documents', 'models')]
import figure  # noqa: E402
from network import FigureNet  # noqa: E402

SIDE = 256
LIMIT_THERE = .3


def odds(likelihood):
    return math.log(likelihood / (1 - likelihood))


class Likely(torch.nn.Module):
    """The network with its limit moved to that of figures.h."""

    def __init__(self, net, limit):
        super().__init__()
        self.net, self.shift = net, odds(LIMIT_THERE) - odds(limit)
        with torch.no_grad():
            net.answer.bias += self.shift

    def forward(self, x):
        return torch.sigmoid(self.net(x))


def main():
    state, out = sys.argv[1:3]
    limit = float(sys.argv[3]) if len(sys.argv) > 3 else .5
    net = FigureNet()
    net.load_state_dict(torch.load(state)['mean'])
    data = io.BytesIO()
    torch.onnx.export(Likely(net, limit).eval(), torch.zeros(1, 9, SIDE, SIDE), data, opset_version=11,
                      input_names=['planes'], output_names=['likelihood'])
    figure.KEPT += ('GlobalAveragePool',)
    graph = figure.Graph(onnx.load_from_string(data.getvalue()).graph)
    parts = figure.packed(graph)
    made = helper.make_graph(
        parts.nodes, 'figure', [helper.make_tensor_value_info(graph.input, TensorProto.FLOAT, [1, 9, SIDE, SIDE])],
        [helper.make_tensor_value_info(graph.output, TensorProto.FLOAT, [1, 1, SIDE // 4, SIDE // 4])], parts.constants)
    model = helper.make_model(made, opset_imports=[helper.make_opsetid('', 11)], producer_name='touchline')
    model.ir_version = 6
    onnx.save(model, out)


if __name__ == '__main__':
    main()
