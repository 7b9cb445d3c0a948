"""The network of the figure: ordinary convolutions, 9 planes in, likelihoods at half the side out."""
import torch
import torch.nn as nn
import torch.nn.functional as F

WIDTHS = (24, 32, 64, 96, 128)
FINE = 16  # planes at half the side, where the boundary is decided


class Step(nn.Sequential):
    def __init__(self, inputs, outputs, stride=1, side=3, apart=1):
        super().__init__(nn.Conv2d(inputs, outputs, side, stride, apart * (side // 2), apart, bias=False),
                         nn.BatchNorm2d(outputs), nn.ReLU())


class Residual(nn.Module):
    def __init__(self, width, apart=1):
        super().__init__()
        self.first = Step(width, width, apart=apart)
        self.second = nn.Sequential(nn.Conv2d(width, width, 3, 1, apart, apart, bias=False), nn.BatchNorm2d(width))

    def forward(self, x):
        return F.relu(x + self.second(self.first(x)))


def doubled(x):
    return F.interpolate(x, scale_factor=2.0, mode='bilinear', align_corners=False)


class FigureNet(nn.Module):
    def __init__(self, planes=9):
        super().__init__()
        a, b, c, d, e = WIDTHS
        self.second = Step(planes, a, 2)
        self.quarter = nn.Sequential(Step(a, b, 2), Residual(b))
        self.eighth = nn.Sequential(Step(b, c, 2), Residual(c))
        self.sixteenth = nn.Sequential(Step(c, d, 2), Residual(d), Residual(d, 2))
        self.last = nn.Sequential(Step(d, e, 2), Residual(e))
        self.whole = nn.Sequential(nn.AdaptiveAvgPool2d(1), nn.Conv2d(e, e, 1), nn.ReLU())
        self.up16 = Step(e + d, d, side=1)
        self.mix16 = Residual(d)
        self.up8 = Step(d + c, c, side=1)
        self.mix8 = Residual(c)
        self.up4 = Step(c + b, b, side=1)
        self.mix4 = Residual(b)
        self.far = nn.Conv2d(b, FINE, 1)
        self.near = nn.Conv2d(a, FINE, 1)
        self.answer = nn.Conv2d(FINE, 1, 3, 1, 1)

    def forward(self, x):
        second = self.second(x)
        quarter = self.quarter(second)
        eighth = self.eighth(quarter)
        sixteenth = self.sixteenth(eighth)
        x = self.last(sixteenth)
        x = x + self.whole(x)
        for behind, up, mix in ((sixteenth, self.up16, self.mix16), (eighth, self.up8, self.mix8),
                                (quarter, self.up4, self.mix4)):
            x = mix(up(torch.cat([doubled(x), behind], 1)))
        return self.answer(F.relu(self.near(second) + doubled(self.far(x))))
