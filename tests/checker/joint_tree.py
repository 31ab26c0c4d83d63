"""The tree of a mechanism's joints: docs/separation-logs.md, "Mechanisms"."""


class GivenJoint:
    """Two bodies, by number. `at` is the direction of a slide."""

    def __init__(self, name, slide, bodies, at, shared):
        self.name, self.slide, self.bodies, self.at, self.shared = name, slide, bodies, at, shared
        self.kind = "slide" if slide else "revolute"


def expanded_joints(json, names):
    out = []
    for name, joint in json["joints"].items():
        slide = "slide" in joint
        bodies = [names[body] for body in joint["slide" if slide else "revolute"]]
        at = tuple(float(c) for c in joint["direction" if slide else "at"])
        out += [GivenJoint(name, slide, (bodies[0], other), at, len(bodies) > 2) for other in bodies[1:]]
    return out


class Link:
    def __init__(self, body, parent, joint, is_reversed):
        self.body, self.parent, self.joint, self.reversed = body, parent, joint, is_reversed


class Tree:
    def __init__(self, json, names):
        self.joints = expanded_joints(json, names)
        self.ground = names[json["ground"]]
        known = set(json.get("drive", {})) | {c[key] for c in json.get("couple", []) for key in ("joint", "to")}
        depth = self.depths()
        order = []
        for k, joint in enumerate(self.joints):
            kind = 0 if joint.name in known else 1 if joint.slide else 2
            order.append((kind, min(depth[body] for body in joint.bodies) if kind == 2 else 0, k))
        group, chosen = {}, set()

        def root(body):
            while group.get(body, body) != body:
                body = group[body]
            return body

        for *_, k in sorted(order):
            a, b = map(root, self.joints[k].bodies)
            if a != b:
                group[a] = b
                chosen.add(k)
        self.links, self.link_of = [], {}
        reached, front = {self.ground}, [self.ground]
        while front:
            after = []
            for body in front:
                for k, joint in enumerate(self.joints):
                    if k not in chosen or body not in joint.bodies:
                        continue
                    is_reversed = joint.bodies[1] == body
                    other = joint.bodies[0] if is_reversed else joint.bodies[1]
                    if other in reached:
                        continue
                    reached.add(other)
                    self.link_of[other] = len(self.links)
                    self.links.append(Link(other, self.link_of.get(body, -1), k, is_reversed))
                    after.append(other)
            front = after
        self.closures = [k for k in range(len(self.joints)) if k not in chosen]

    def named(self, name):
        return next(k for k, joint in enumerate(self.joints) if joint.name == name)

    def depths(self):
        """How many joints away from the ground each body is."""
        depth = {self.ground: 0}
        changed = True
        while changed:
            changed = False
            for joint in self.joints:
                for a, b in (joint.bodies, joint.bodies[::-1]):
                    if a in depth and depth.get(b, len(self.joints) + 2) > depth[a] + 1:
                        depth[b], changed = depth[a] + 1, True
        return depth
