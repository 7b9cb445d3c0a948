"""Gathers build/reliability/*.csv into results/figures.csv, and writes the tables of the pages into build/reliability/tables."""
import csv
import datetime
import os
import platform
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import figures  # noqa: E402
import hazards  # noqa: E402

RESULTS = figures.HERE / 'results'
TABLES = figures.OUT / 'tables'
UNMEASURED = 'not measured yet'


def machine():
    model = re.search(r'model name\s*: (.*)', open('/proc/cpuinfo').read())
    name = model[1] if model else platform.machine()
    release = platform.freedesktop_os_release()
    system = f'{release["NAME"].split()[0]} {release.get("VERSION_ID", "")}'.strip()
    return f'{os.cpu_count()} processors ({name}), {system}, Linux {platform.release().split("-")[0]}, load {os.getloadavg()[2]:.0f}'


def commit():
    said = subprocess.run(['git', '-C', figures.ROOT, 'rev-parse', '--short', 'HEAD'], capture_output=True, text=True)
    return said.stdout.strip() or 'unknown'


def kept(name):
    """The rows of a file of results."""
    path = RESULTS / f'{name}.csv'
    if not path.exists():
        return []
    with open(path, newline='') as file:
        return list(csv.DictReader(file))


def keep(name, columns, rows):
    with open(RESULTS / f'{name}.csv', 'w', newline='') as file:
        out = csv.DictWriter(file, columns, lineterminator='\n')
        out.writeheader()
        out.writerows(rows)


def gather():
    """(figures, parts): a part's new figures take the place of its old ones; where they come from is kept beside them."""
    rows, parts = kept('figures'), {row['part']: row for row in kept('parts')}
    for path in sorted(figures.OUT.glob('*.csv')):
        part = path.stem
        new = [dict(row, part=part, how=re.sub(r'(?<![\w.])/[\w./-]*?/build/', 'build/', row['how'])) for row in figures.read(path)]
        if not new or new == [row for row in rows if row['part'] == part]:
            continue
        rows = [row for row in rows if row['part'] != part] + new
        date = datetime.date.fromtimestamp(path.stat().st_mtime).isoformat()
        parts[part] = {'part': part, 'machine': machine(), 'commit': commit(), 'date': date}
    rows.sort(key=lambda row: row['part'])
    keep('figures', ['part', *figures.COLUMNS], rows)
    keep('parts', ['part', 'machine', 'commit', 'date'], [parts[name] for name in sorted(parts)])
    return rows, parts


def unproven():
    return [dict(zip(figures.COLUMNS, ('28', text.split(':')[0], text.split(': ', 1)[1], '-', '-', 'words')), part='')
            for text in (figures.HERE / 'unproven.txt').read_text().splitlines()]


def cell(text):
    return text.replace('|', '/').replace('\n', ' ')


def end_of(rows, bar):
    """One word for all figures of a row whose bar is this; a figure with a bar that is not judged yet leaves it in part."""
    ends = [row['passed'] for row in rows]
    if 'no' in ends:
        return 'no'
    if not re.match('published|stated|listed', bar) and 'yes' not in ends or not rows:
        return UNMEASURED
    is_in_part = any(row['passed'] == '-' and row['bar'] != '-' for row in rows)
    return 'in part' if is_in_part else 'yes' if 'yes' in ends else 'published'


def short(rows):
    """At most three figures in words; of more, how many there are."""
    if not rows:
        return UNMEASURED
    if rows[0]['row'] == '28':
        return '; '.join(row['figure'] for row in rows)
    if len(rows) <= 3:
        return '; '.join(f'{row["figure"]}: {row["value"]}' for row in rows)
    missed = sum(row['passed'] == 'no' for row in rows)
    return f'{len(rows)} figures, ' + (f'{missed} of them below the bar' if missed else 'none below the bar')


def row_table(rows):
    """(the table of 28 rows, its words)"""
    lines, ends = ['| row | figure | value | bar | passed |', '|---|---|---|---|---|'], {}
    with open(figures.HERE / 'rows.csv', newline='') as file:
        for row in csv.DictReader(file):
            of_row = [figure for figure in rows if figure['row'] == row['row']]
            ends[row['row']] = end_of(of_row, row['bar'])
            lines.append(cell_row(row['row'], row['figure'], short(of_row), row['bar'], ends[row['row']]))
    return lines, ends


def cell_row(*cells):
    return '| ' + ' | '.join(cell(text) for text in cells) + ' |'


def listed(numbers):
    return f' ({", ".join(numbers)})' if numbers else ''


def words_of(ends):
    of = {end: [row for row, e in ends.items() if e == end] for end in ('yes', 'no', 'in part', 'published', UNMEASURED)}
    does = 'does' if len(of['no']) == 1 else 'do'
    return (f'Of {len(ends)} rows of figures {len(of["yes"])} reach their bar and {len(of["no"])} {does} not{listed(of["no"])}. '
            f'In part: {len(of["in part"])}{listed(of["in part"])}; told without a bar: {len(of["published"])}; not measured yet: {len(of[UNMEASURED])}'
            f'{listed(of[UNMEASURED])}.')


def figure_table(rows, parts):
    lines = ['| row | figure | value | bar | passed | how |', '|---|---|---|---|---|---|']
    for row in sorted(rows, key=lambda r: (int(r['row']), r['part'])):
        lines.append(cell_row(*(row[name] for name in figures.COLUMNS)))
    lines += ['', '| part | machine | commit | date |', '|---|---|---|---|']
    lines += [cell_row(*(parts[name][c] for c in ('part', 'machine', 'commit', 'date'))) for name in sorted(parts)]
    below = [row for row in rows if row['passed'] == 'no']
    words = f'{len(rows)} figures out of {len(parts)} parts are listed. {len(below)} of them miss their bar' + \
        (': ' + '; '.join(f'{row["figure"]} ({row["value"]})' for row in below) if below else '') + '.'
    return [*lines, '', words]


def hazard_table(rows):
    known, lines, ends = hazards.tested(), ['| of | hazard | expected | result | tests | not run, and why |'], []
    lines.append('|---|---|---|---|---|---|')
    for group, hazard, expected, evidence, remark in hazards.rows():
        ends.append(hazards.judged(evidence, known, rows))
        lines.append(cell_row(group, hazard, expected, ends[-1], ', '.join(evidence) or '-', remark))
    count = {end: ends.count(end) for end in sorted(set(ends))}
    words = f'{len(ends)} hazards are listed: ' + ', '.join(f'{n} {end}' for end, n in count.items()) + '. ' + \
        'Where something of a row is not run, the last column says why.'
    return [*lines, '', words]


def fault_table():
    known = hazards.tested()
    lines = ['| way | fault | runs | zero torque after, ms: median / worst | worst state | result |', '|---|---|---|---|---|---|']
    ends = []
    for way, fault, runs, zero, state, _ in hazards.faults():
        ends.append(known.get(hazards.OF_WAY[way], UNMEASURED))
        lines.append(cell_row(way, fault, runs, zero, state, ends[-1]))
    words = f'{len(ends)} faults in {len(hazards.OF_WAY)} ways are listed, of which {ends.count("passed")} passed. ' + \
        'The result is that of the test which makes the fault and judges the time to zero torque: ' + \
        ', '.join(f'{way} {test}' for way, test in hazards.OF_WAY.items()) + '.'
    return [*lines, '', words]


def save(name, lines):
    (TABLES / f'{name}.md').write_text('\n'.join(lines) + '\n')


def main():
    RESULTS.mkdir(exist_ok=True)
    TABLES.mkdir(parents=True, exist_ok=True)
    if (figures.OUT / 'tests.xml').exists():
        hazards.keep(figures.OUT / 'tests.xml')
    rows, parts = gather()
    rows += unproven()
    table, ends = row_table(rows)
    save('reliability-rows', [*table, '', words_of(ends)])
    save('reliability', [words_of(ends) + ' [The table](tests/lab/reliability/README.md) names each,',
                         'and the hazards and faults with their tests.'])
    save('reliability-figures', figure_table(rows, parts))
    save('reliability-hazards', hazard_table(rows))
    save('reliability-faults', fault_table())
    listing = figures.OUT / 'exclusions.md'
    if listing.exists():
        save('reliability-exclusions', listing.read_text().splitlines())
    print(words_of(ends))


if __name__ == '__main__':
    main()
