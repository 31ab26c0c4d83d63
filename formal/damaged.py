"""Exact logs, damaged in ways that matter."""

import copy


def numbers_in(log):
    """Where the numbers of windows are: lists that have them, and their places."""
    places = []
    for pair in log["pairs"]:
        for window in pair["windows"]:
            places += [(window, 0), (window, 1)]
            for step in window[2:]:
                if isinstance(step, list):
                    places += [(step, k) for k in range(len(step))]
    return places


def damage(rng, log):
    """What was done to the log, and what is left of it."""
    log = copy.deepcopy(log)
    pair = rng.choice(log["pairs"])
    window = rng.choice(pair["windows"])
    lines = [(w, k) for p in log["pairs"] for w in p["windows"] for k in range(2, len(w)) if isinstance(w[k], list)]
    kind = rng.randrange(10)
    if kind == 0:
        pair["windows"].remove(window)
        return "window left out", log
    if kind == 1:
        log["pairs"].remove(pair)
        return "pair left out", log
    if kind == 2:
        log["until"] += abs(log["until"] or 1) * rng.choice([1e-15, 1e-3, 1])
        return "later end", log
    if kind == 3:
        where, k = rng.choice(numbers_in(log))
        where[k] += rng.choice([-1, 1]) * abs(where[k] or 1) * 2.0 ** -rng.randrange(1, 30)
        return "number", log
    if kind == 4:
        where, k = rng.choice(lines)
        where[k][:2] = [-where[k][0], -where[k][1]]
        return "direction turned round", log
    if kind == 5:
        where, k = rng.choice(lines)
        other, m = rng.choice(lines)
        where[k], other[m] = other[m], where[k]
        return "lines exchanged", log
    if kind == 6:
        k = rng.randrange(2, len(window))
        if not isinstance(window[k], list):
            window[k] = 3 - window[k]
        else:
            window.insert(k, rng.choice([1, 2]))
            window.insert(k + 1, window[k + 1])
        return "halving", log
    if kind == 7:
        pair["pair"] = pair["pair"][::-1] if rng.random() < 0.5 else [pair["pair"][0], pair["pair"][1] + 1]
        return "other pair", log
    if kind == 8:
        where, k = rng.choice(lines)
        where[k] += [rng.uniform(-1, 1) * abs(complex(*where[k][:2])) * 2.0 ** rng.randrange(-20, 20)]
        return "level bent", log
    window[0], window[1] = (rng.choice(pair["windows"])[0], window[1]) if rng.random() < 0.5 else (window[0], rng.choice(pair["windows"])[1])
    return "window's end", log
