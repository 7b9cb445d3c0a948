"""What was checked, as a table, as rows of files, and as a page."""
import contextlib
import csv
import os
import time

from machine import Fault

CHECKS = ['group', 'check', 'result', 'seconds', 'note', 'date']


def read(file):
    """The rows of a CSV file, none where it is not there."""
    if not os.path.exists(file):
        return []
    with open(file, newline='') as old:
        return list(csv.DictReader(old))


def replace(file, head, rows):
    """Whole at once: another run may be reading it."""
    os.makedirs(os.path.dirname(file), exist_ok=True)
    with open(f'{file}.{os.getpid()}', 'w', newline='') as new:
        out = csv.writer(new, lineterminator='\n')
        out.writerow(head)
        out.writerows(rows)
    os.replace(new.name, file)


def page(checks, groups):
    """The outcome of each group, from its last run."""
    lines = ['| group | passed | minutes | on | what was noted |', '|---|---|---|---|---|']
    for group in groups:
        rows = [row for row in checks if row['group'] == group]
        if not rows:
            lines.append(f'| `{group}` | not run | | | |')
            continue
        passed = sum(row['result'] == 'passed' for row in rows)
        notes = '; '.join(f'{row["check"]}: {row["note"] if row["result"] == "passed" else "FAILED"}'
                          for row in rows if row['note'] or row['result'] != 'passed')
        lines.append(f'| `{group}` | {passed} of {len(rows)} | {sum(float(row["seconds"]) for row in rows) / 60:.0f} | '
                     f'{rows[0]["date"]} | {" ".join(notes.replace("|", "/").split())} |')
    return '\n'.join(lines) + '\n'


class Table:
    """Rows (group, check, passed or failed, seconds, note, date); figures of the reliability table."""

    def __init__(self):
        self.rows = []
        self.figures = []

    @contextlib.contextmanager
    def check(self, group, name, is_needed=False):
        """One check: fails by Fault. With is_needed the rest of the group cannot go on without it."""
        start = time.monotonic()
        note = []
        try:
            yield note.append
        except Fault as fault:
            self._add(group, name, False, start, [*note, str(fault)])
            if is_needed:
                raise
        except KeyboardInterrupt:
            self._add(group, name, False, start, [*note, 'stopped from outside'])
            raise
        else:
            self._add(group, name, True, start, note)

    def fail(self, group, name, fault):
        """What never came to be checked."""
        self._add(group, name, False, time.monotonic(), [str(fault)])

    def _add(self, group, name, has_passed, start, notes):
        row = (group, name, has_passed, time.monotonic() - start, '; '.join(notes), time.strftime('%Y-%m-%d'))
        self.rows.append(row)
        print(f'  {name}: {"passed" if has_passed else "FAILED"}, {row[3]:.0f} s {row[4]}', flush=True)

    def figure(self, row, figure, value, bar, has_passed, how):
        """A row of section 4 of the reliability facts, as far as the machine gives it."""
        self.figures.append((row, figure, value, bar, 'yes' if has_passed else 'no', how))

    def failed(self):
        return [row for row in self.rows if not row[2]]

    def passed_of(self, group, word=''):
        rows = [row for row in self.rows if row[0] == group and word in row[1]]
        return sum(row[2] for row in rows), len(rows)

    def print(self):
        width = max([len(row[1]) for row in self.rows], default=5)
        print(f'\n{"group":<8} {"check":<{width}} {"result":<7} seconds')
        for group, name, has_passed, seconds, note, _ in self.rows:
            print(f'{group:<8} {name:<{width}} {"passed" if has_passed else "FAILED":<7} {seconds:7.0f}  {note}')
        print(f'{len(self.rows) - len(self.failed())} passed, {len(self.failed())} failed')

    def write(self, figures, checks):
        """Figures and groups of this run take the place of those of an earlier one."""
        head = ['row', 'figure', 'value', 'bar', 'passed', 'how']
        kept = {line['figure']: [line[name] for name in head] for line in read(figures)}
        kept.update({row[1]: list(row) for row in self.figures})
        replace(figures, head, sorted(kept.values(), key=lambda row: (int(row[0]), row[1])))
        ours = {row[0] for row in self.rows}
        rows = [[line[name] for name in CHECKS] for line in read(checks) if line['group'] not in ours]
        rows += [[group, name, 'passed' if has_passed else 'failed', f'{seconds:.0f}', note, date]
                 for group, name, has_passed, seconds, note, date in self.rows]
        replace(checks, CHECKS, rows)
