"""Figures for the table of reliability: row,figure,value,bar,passed,how."""

import csv
import os


class Figures:
    """Kept in a CSV; a figure that is measured anew takes the place of the one before."""

    columns = ['row', 'figure', 'value', 'bar', 'passed', 'how']

    def __init__(self, path):
        self.path = path
        self.failed = []

    def keep(self, row, figure, value, bar, passed, how):
        """`passed`: true, false, or None for a figure without a bar."""
        verdict = 'reported' if passed is None else 'yes' if passed else 'no'
        if verdict == 'no':
            self.failed.append(figure)
        print(f'  {figure}: {value} (bar: {bar}): {verdict}', flush=True)
        rows = [old for old in self.read() if (old[0], old[1]) != (str(row), figure)]
        rows.append([str(row), figure, str(value), bar, verdict, how])
        rows.sort(key=lambda line: int(line[0]))
        with open(self.path + '.new', 'w', newline='', encoding='utf-8') as file:
            writer = csv.writer(file, quoting=csv.QUOTE_ALL, lineterminator='\n')
            file.write(','.join(self.columns) + '\n')
            writer.writerows(rows)
        os.replace(self.path + '.new', self.path)

    def read(self):
        if not os.path.exists(self.path):
            return []
        with open(self.path, newline='', encoding='utf-8') as file:
            return list(csv.reader(file))[1:]


def slope(times, values):
    """Least squares: (slope, its standard error), in units of values per unit of time."""
    count = len(times)
    if count < 3:
        return 0.0, float('inf')
    middle, mean = sum(times) / count, sum(values) / count
    spread = sum((t - middle) ** 2 for t in times)
    rise = sum((t - middle) * (v - mean) for t, v in zip(times, values)) / spread
    left = sum((v - mean - rise * (t - middle)) ** 2 for t, v in zip(times, values))
    return rise, (left / (count - 2) / spread) ** 0.5


def middle_slope(times, values):
    """The median of the slopes between all pairs (Theil and Sen): a sample that stands out does not turn it."""
    points = list(zip(times, values))
    slopes = [(b - a) / (t - s) for i, (s, a) in enumerate(points) for t, b in points[i + 1:]]
    return quantile(slopes, 0.5)


def quantile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0.0
