"""Selected objects of a drawing: their names and centres, and a drawing of one of them alone."""

import copy

import inkex
from inkex import addNS
from lxml import etree

from taut_boxes import box_around, transform_of
from taut_command import TautError

SVG = "http://www.w3.org/2000/svg"
LINKS = (addNS("href", "xlink"), "href")


def millimetres(svg):
    """How long the drawing's own unit is on the page. Of a page without a size it is a pixel, 96 to the inch."""
    ratios = [page / box for page, box in ((svg.viewport_width, svg.viewbox_width),
                                           (svg.viewport_height, svg.viewbox_height)) if page and box]
    return min(ratios, default=1) * 25.4 / 96


def name_of(element):
    return element.get("inkscape:label") or element.get_id()


def named(svg, word, among=None):
    """The object with this label or id: one of `among`, or of the whole drawing."""
    word = word.strip().lstrip("#")
    everything = svg.xpath("//svg:*") if among is None else among
    found = [element for element in everything if word and word in (element.get_id(), element.get("inkscape:label"))]
    if len(found) == 1:
        return found[0]
    where = "in the drawing" if among is None else "among the selected objects"
    if not word:
        raise TautError("Name the object whose centre is the pivot.")
    raise TautError("%s %s %s called \"%s\"." % (*(("%d objects" % len(found), where, "are") if found else
                                                   ("No object", where, "is")), word))


def centre_of(element):
    """Of a circle or an ellipse its centre, also of an arc of one; else the middle of the box around it."""
    for x, y in (("cx", "cy"), ("sodipodi:cx", "sodipodi:cy")):
        if isinstance(element, (inkex.Circle, inkex.Ellipse, inkex.PathElement)) and element.get(x) and element.get(y):
            point = element.to_dimensionless(element.get(x)), element.to_dimensionless(element.get(y))
            return tuple(transform_of(element).apply_to_point(point))
    box = box_around(element)
    if box is None:
        raise TautError("%s has no centre: there is nothing in it." % name_of(element))
    return tuple(box.center)


def rotation_centre(element):
    """The cross that Inkscape shows when an object is clicked twice: the middle of its box, unless it was moved.

    Inkscape stores by how much it was moved, in the units of the drawing, with y upwards.
    """
    box = box_around(element)
    x, y = box.center if box else centre_of(element)
    return (x + float(element.get("inkscape:transform-center-x") or 0),
            y - float(element.get("inkscape:transform-center-y") or 0))


def drawing_of(element):
    """The text of a drawing of this object alone: one group with the object as it stands, in the drawing's own units.

    The groups that it is in are there, too, since it has styles and transforms from them; so are style sheets,
    definitions, and what it clones.
    """
    svg = element.getroottree().getroot()
    names = {None: SVG, "inkscape": inkex.NSS["inkscape"], "xlink": inkex.NSS["xlink"]}
    alone = etree.Element("{%s}svg" % SVG, nsmap=names)
    for key, value in svg.attrib.items():
        if key in ("style", "class", "fill", "stroke", "fill-rule", "stroke-width"):
            alone.set(key, value)
    for extra in svg.xpath("//svg:style | //svg:defs"):
        if not any(parent.tag == addNS("defs", "svg") for parent in extra.iterancestors()):
            alone.append(copy.deepcopy(extra))
    place = alone
    for group in reversed(list(element.iterancestors())[:-1]):
        if group.tag not in (addNS("g", "svg"), addNS("a", "svg")):
            raise TautError("%s is in a <%s>: select objects of the page." % (name_of(element), group.TAG))
        place = etree.SubElement(place, addNS("g", "svg"), group.attrib)
    place.append(copy.deepcopy(element))
    place[-1].tail = None
    if place is alone:
        group = etree.SubElement(alone, addNS("g", "svg"))
        group.append(place[-2])
    add_originals(svg, alone)
    return etree.tostring(alone, encoding="unicode")


def add_originals(svg, alone):
    """What clones are of, and is not there yet, becomes a definition."""
    definitions = etree.SubElement(alone, addNS("defs", "svg"))
    missing = True
    while missing:
        there = {part.get("id") for part in alone.iter()}
        links = [part.get(link, "") for part in alone.iter(addNS("use", "svg")) for link in LINKS]
        missing = {link[1:] for link in links if link.startswith("#")} - there
        originals = [original for original in map(svg.getElementById, missing) if original is not None]
        if not originals:
            break
        for original in originals:
            definitions.append(copy.deepcopy(original))
