"""What the kernel tells of processes."""

import os


def stat_of(pid):
    """Name, state and parent; None for a process that is gone."""
    try:
        with open(f'/proc/{pid}/stat', encoding='utf-8', errors='replace') as file:
            text = file.read()
    except (FileNotFoundError, ProcessLookupError):
        return None
    name, rest = text[text.index('(') + 1:text.rindex(')')], text[text.rindex(')') + 2:].split()
    return {'name': name, 'state': rest[0], 'parent': int(rest[1]), 'threads': int(rest[17])}


def alive():
    """Of this PID namespace, but for the dead that nobody has reaped yet."""
    found = {}
    for entry in os.listdir('/proc'):
        if entry.isdigit():
            stat = stat_of(entry)
            if stat and stat['state'] not in 'ZX':
                found[int(entry)] = stat
    return found


def corpses_of(parent):
    """Dead children of this process that the kiosk had started."""
    found = []
    for entry in os.listdir('/proc'):
        stat = stat_of(entry) if entry.isdigit() else None
        if stat and stat['state'] == 'Z' and stat['parent'] == parent and \
                stat['name'].startswith(('soak_servo', 'touchline-')):
            found.append(int(entry))
    return found


def tree(root):
    """The process and all that it started, and they started: PID to stat."""
    processes = alive()
    members = {root} & processes.keys()
    while True:
        more = {pid for pid, stat in processes.items() if stat['parent'] in members} - members
        if not more:
            return {pid: processes[pid] for pid in members}
        members |= more


def memory_kB(pid):
    """(Rss, of it anonymous); zeros for a process that is gone. What is anonymous is its own: how much of a library's pages
    counts as whose depends on what else the machine runs."""
    figures = {'Rss': 0, 'Anonymous': 0}
    try:
        with open(f'/proc/{pid}/smaps_rollup', encoding='ascii') as file:
            for line in file:
                name, _, value = line.partition(':')
                if name in figures:
                    figures[name] = int(value.split()[0])
    except (FileNotFoundError, ProcessLookupError):
        pass
    return figures['Rss'], figures['Anonymous']


def descriptors(pid):
    """How many are open; 0 for a process that is gone."""
    try:
        return len(os.listdir(f'/proc/{pid}/fd'))
    except (FileNotFoundError, ProcessLookupError):
        return 0
