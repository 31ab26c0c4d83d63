"""How much a random test does: a quarter where TAUT_EFFORT says `tenth`, as `./dev test` does. A tenth would be too little
for each kind of what is drawn to be there."""

import os


def effort(n, fewer=None):
    return fewer or n // 4 if os.environ.get("TAUT_EFFORT") == "tenth" else n
