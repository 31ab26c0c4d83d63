"""Answers with certainty when moving shapes first touch, or proves that they never do.

    import taut2d

    scene = taut2d.Scene(
        time=(0, 10),
        bodies=[
            taut2d.Body("anvil", [(0, 0), (4, 0), (4, 1), (0, 1)]),
            taut2d.Body("hammer", [(1, 5), (3, 5), (2, 6)], taut2d.Velocity((0, -0.5))),
        ],
    )
    answer = taut2d.check(scene)
    print(answer.outcome, answer.contact.t)     # contact (8.0, 8.000000000000002)

Scene, Body and Part say what there is; Keyframes, Sweep, Velocity, Polynomial and Pieces how it moves. check() gives an
Answer; prove() gives a Proof besides, which verify() checks. "free" and "contact" are proofs, not samples: there is no
step size and no tolerance. "undecided" is an answer, too, where a limit was hit. Shapes are lists, numpy arrays,
anything with __geo_interface__ (shapely, geopandas), or WKT.

clearance() says how close bodies come, distance_profile() how far they are at every time, check_clearance() whether they
keep a distance, intervals() when they overlap, all of the time, range() how far they can go without, and separate() in
which directions they come apart. envelope() says for which combinations of joint values bodies of a Linkage keep apart,
along all motions at once; path() finds a way from a start to a goal, or proves that there is none. check_many() takes arrays of motions, or many scenes, and answers on all processors; sweep()
does, too, into files. Shape prepares a shape for many scenes, StaticMap a map for bodies that move in it, and Simulation
goes from event to event, with plans that may change. cells() lists the cells of a grid that a body touches, and
swept() is the region that it passes over; follow() is the lift of a follower on a cam. flatten()
makes polygons of curves, scene_from_frame() and answers_frame() are for tables of GeoPandas and pandas, and read_drawing() a scene of SVG, DXF and other drawings. Scene.plot() and Scene.animate() draw
by matplotlib, and so do the methods plot() of answers.

Errors are TautError; InputError, with place, problem and hint, is a ValueError as well. Ctrl-C ends every function within
moments. Functions may be called from several threads, which then run at the same time.
"""

from . import _taut2d, directions, followers, linkages, margins, motions, mechanisms, paths, questions
from .answers import (Answer, Contact, Coverage, EdgeRef, Geometry, PairAnswer, Proof, ProvedCloseness, Verified,
                      VertexRef)
from .asking import check, prove, verify
from .cells import Cells, cells
from .directions import *
from .mechanisms import *
from .drawings import Crossing, Drawing, DrawingBody, DrawingFile, Gap, OpenLine, Repair, Skipped, read_drawing
from .errors import InputError, InternalError, TautError, UndecidedError
from .flattening import flatten
from .followers import *
from .frames import answers_frame, scene_from_frame
from .linkages import *
from .many import Outcome, answer_dtype, check_many
from .maps import Mover, StaticMap
from .margins import *
from .motions import *
from .parts import GeojsonFile, Part, Path, WktFile
from .paths import *
from .pictures import Pose
from .questions import *
# Not in __all__: `from taut2d import *` must leave Python's own range() alone.
from .questions import range as range
from .regions import SweptRegion, swept
from .scene import Body, PairClearance, Scene
from .shape import Shape
from .simulations import ContactMotion, SimulatedContact, Simulation, Tiling, TilingEdge, TilingFace
from .svg import draw
from .sweeps import SweepAnswers, sweep
from .variants import KeyframeRows, VelocityRows
from .viewer import Viewer

# A module that is imported by a star lists its own names.
__all__ = [
    "Answer", "Body", "Cells", "Contact", "ContactMotion", "Coverage", "Crossing", "Drawing", "DrawingBody",
    "DrawingFile", "EdgeRef", "Gap", "GeojsonFile", "Geometry", "InputError", "InternalError", "KeyframeRows",
    "Mover", "OpenLine", "Outcome", "PairAnswer", "PairClearance", "Part", "Path", "Pose", "Proof",
    "ProvedCloseness", "Repair", "Scene", "Shape", "SimulatedContact", "Simulation", "Skipped", "StaticMap",
    "SweepAnswers", "SweptRegion", "TautError", "Tiling", "TilingEdge", "TilingFace", "UndecidedError",
    "VelocityRows", "Verified", "VertexRef", "Viewer", "WktFile", "answer_dtype", "answers_frame", "cells", "check",
    "check_many", "draw", "flatten", "prove", "read_drawing", "scene_from_frame", "sweep", "swept", "verify",
]
__all__ += directions.__all__
__all__ += followers.__all__
__all__ += mechanisms.__all__
__all__ += linkages.__all__
__all__ += margins.__all__
__all__ += motions.__all__
__all__ += paths.__all__
__all__ += questions.__all__

__version__: str = _taut2d.version()
