"""Whether bodies of a scene overlap clearly at an instant: placed and compared in floating point, with no code of taut. Motions
are those that taut writes: polynomials, pieces, rotations, orbits, parents. Only what is clear counts: edges that cross, or a
vertex inside, by more than a billionth of the bodies' size."""

import math

clear = 1e-9


def polynomial(coefficients, x):
    value = 0.0
    for c in reversed(coefficients or []):
        value = value * x + c
    return value


def cosine_and_sine(rotation, x):
    if not rotation:
        return 1.0, 0.0
    (kind, given), = rotation.items()
    if kind == "angle":
        return math.cos(polynomial(given, x)), math.sin(polynomial(given, x))
    if kind == "half_angle_tangent":
        s = polynomial(given, x)
        return (1 - s * s) / (1 + s * s), 2 * s / (1 + s * s)
    if kind == "cosine":
        c = max(-1.0, min(1.0, polynomial(given, x)))
        return c, math.sqrt(1 - c * c)
    if kind == "direction":
        a, b = polynomial(given["a"], x), polynomial(given["b"], x)
        return a / math.hypot(a, b), b / math.hypot(a, b)
    raise ValueError(f"rotation by {kind}")


def turned(cs, p):
    return cs[0] * p[0] - cs[1] * p[1], cs[1] * p[0] + cs[0] * p[1]


def moved(motion, t, p):
    """Where the motion puts a point. At a joint the piece that ends there counts, which is as good as the other one."""
    pieces = motion if isinstance(motion, list) else [motion]
    piece = next((m for m in pieces[:-1] if t <= m["until"]), pieces[-1])
    x, pivot = t - piece.get("origin", 0), piece.get("pivot", [0, 0])
    place = (pivot[0] + polynomial(piece.get("x"), x), pivot[1] + polynomial(piece.get("y"), x))
    if "orbit" in piece:
        centre, angle = piece["orbit"]["center"], polynomial(piece["orbit"]["angle"], x)
        around = turned((math.cos(angle), math.sin(angle)), (place[0] - centre[0], place[1] - centre[1]))
        place = (centre[0] + around[0], centre[1] + around[1])
    own = turned(cosine_and_sine(piece.get("rotation"), x), (p[0] - pivot[0], p[1] - pivot[1]))
    return place[0] + own[0], place[1] + own[1]


def chain(bodies, body):
    """Its own motion first, then its parents'."""
    motions = []
    while body is not None:
        motions.append(body.get("motion"))
        body = bodies.get(body.get("relative_to"))
    return [m for m in motions if m]


def moves(motion):
    pieces = motion if isinstance(motion, list) else [motion]
    return any(p.get("x") or p.get("y") or p.get("rotation") or "orbit" in p for p in pieces)


def parts(body):
    """Rings and heights of each part."""
    for part in body["parts"] if "parts" in body else [body["polygon"]]:
        if isinstance(part, list):
            part = {"outline": part}
        low, high = part.get("z", body.get("z", [None, None]))
        yield ([part["outline"], *part.get("holes", [])], -math.inf if low is None else low, math.inf if high is None else high)


def side(a, b, p):
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def box(rings):
    xs, ys = [p[0] for r in rings for p in r], [p[1] for r in rings for p in r]
    return min(xs), min(ys), max(xs), max(ys)


def edges(rings):
    return [(r[k - 1], r[k]) for r in rings for k in range(len(r))]


def depth_inside(rings, p):
    """The distance from the boundary, negative outside."""
    inside, nearest = False, math.inf
    for a, b in edges(rings):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]):
            inside = not inside
        d = (b[0] - a[0], b[1] - a[1])
        square = d[0] ** 2 + d[1] ** 2
        k = max(0.0, min(1.0, ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / square)) if square else 0.0
        nearest = min(nearest, math.hypot(a[0] + k * d[0] - p[0], a[1] + k * d[1] - p[1]))
    return nearest if inside else -nearest


def overlap(p, q):
    """Whether two parts, as lists of placed rings, overlap clearly."""
    a, b = box(p), box(q)
    if a[0] > b[2] or b[0] > a[2] or a[1] > b[3] or b[1] > a[3]:
        return False
    size = max(map(abs, (*a, *b)))
    room = clear * size * size
    for u, v in edges(p):
        for w, z in edges(q):
            if max(u[0], v[0]) < min(w[0], z[0]) or max(w[0], z[0]) < min(u[0], v[0]):
                continue
            s = [side(u, v, w), side(u, v, z), side(w, z, u), side(w, z, v)]
            if min(map(abs, s)) > room and s[0] * s[1] < 0 and s[2] * s[3] < 0:
                return True
    return depth_inside(q, p[0][0]) > clear * size or depth_inside(p, q[0][0]) > clear * size


def tested_pairs(scene):
    bodies = {b["name"]: b for b in scene["bodies"]}
    ignored = scene.get("ignore", [])
    chains = {name: [m for m in chain(bodies, b) if moves(m)] for name, b in bodies.items()}
    names = list(bodies)
    for i, a in enumerate(names):
        for b in names[i + 1:]:
            either = any({x, y} == {a, b} or ("*" in (x, y) and ({x, y} - {"*"} <= {a, b})) for x, y in ignored)
            if not either and (scene.get("at_rest") == "test" or chains[a] != chains[b]):
                yield a, b


def overlapping_pair(scene, t):
    """The names of two tested bodies that overlap clearly at t, or None."""
    bodies, placed = {b["name"]: b for b in scene["bodies"]}, {}

    def place(name):
        if name not in placed:
            motions = chain(bodies, bodies[name])

            def put(p):
                for m in motions:
                    p = moved(m, t, p)
                return p
            placed[name] = [([[put(p) for p in ring] for ring in rings], low, high) for rings, low, high in parts(bodies[name])]
        return placed[name]

    for a, b in tested_pairs(scene):
        for p, low, high in place(a):
            for q, other_low, other_high in place(b):
                if max(low, other_low) < min(high, other_high) and overlap(p, q):
                    return a, b
    return None
