"""Rows of the reliability table as files: row, figure, value, bar, passed (yes, no, or - where there is no bar), how."""
import csv
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
OUT = ROOT / 'build/reliability'
COLUMNS = ['row', 'figure', 'value', 'bar', 'passed', 'how']


def write(part, rows):
    """rows: (row, figure, value, bar, passed or None, how)."""
    OUT.mkdir(parents=True, exist_ok=True)
    with open(OUT / f'{part}.csv', 'w', newline='') as file:
        out = csv.writer(file, quoting=csv.QUOTE_ALL, lineterminator='\n')
        csv.writer(file, lineterminator='\n').writerow(COLUMNS)
        for row, figure, value, bar, passed, how in rows:
            out.writerow([row, figure, value, bar, {None: '-', True: 'yes', False: 'no'}[passed], how])


def read(path):
    """The rows of such a file as dictionaries; nothing where it is of another kind."""
    with open(path, newline='') as file:
        table = csv.DictReader(file)
        return list(table) if table.fieldnames == COLUMNS else []


def divided(name):
    """The rows of a file of this folder that is divided by tabs."""
    return [line.split('\t') for line in (HERE / name).read_text().splitlines() if line and not line.startswith('#')]
