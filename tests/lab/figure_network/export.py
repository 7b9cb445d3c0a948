#!/usr/bin/python3
"""export.py OUT/state.pt NETWORK.onnx: what train.py learned, as OpenCV 4.6 reads it, with weights of 8 bits."""
import io
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


class Likely(torch.nn.Module):
    def __init__(self, net):
        super().__init__()
        self.net = net

    def forward(self, x):
        return torch.sigmoid(self.net(x))


def main():
    state, out = sys.argv[1:]
    net = FigureNet()
    net.load_state_dict(torch.load(state)['mean'])
    data = io.BytesIO()
    torch.onnx.export(Likely(net).eval(), torch.zeros(1, 9, SIDE, SIDE), data, opset_version=11,
                      input_names=['planes'], output_names=['likelihood'])
    figure.KEPT += ('GlobalAveragePool',)
    graph = figure.Graph(onnx.load_from_string(data.getvalue()).graph)
    parts = figure.packed(graph)
    made = helper.make_graph(
        parts.nodes, 'figure', [helper.make_tensor_value_info(graph.input, TensorProto.FLOAT, [1, 9, SIDE, SIDE])],
        [helper.make_tensor_value_info(graph.output, TensorProto.FLOAT, [1, 1, SIDE // 2, SIDE // 2])], parts.constants)
    model = helper.make_model(made, opset_imports=[helper.make_opsetid('', 11)], producer_name='touchline')
    model.ir_version = 6
    onnx.save(model, out)


if __name__ == '__main__':
    main()
