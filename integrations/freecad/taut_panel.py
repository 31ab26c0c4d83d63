"""FreeCAD: the task panel. What it asks becomes arguments of first_contact(); nothing is decided here."""

import os
import tempfile

import FreeCAD
from PySide import QtCore, QtGui

from taut_command import TautError
from taut_freecad import Placements, Turn, add_copies, first_contact
from taut_sections import Plane

try:
    from PySide2 import QtSvg
except ImportError:
    QtSvg = None

PREFERENCES = "User parameter:BaseApp/Preferences/Mod/Taut"


class TautPanel:
    """`selection`: objects that are bodies; the last one is offered as the one that moves."""

    def __init__(self, selection):
        self.bodies = list(selection)
        self.form = QtGui.QWidget()
        self.form.setObjectName("TautPanel")
        self.form.setWindowTitle("First contact (taut)")
        rows = QtGui.QFormLayout(self.form)
        rows.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        self.moving = QtGui.QListWidget()
        self.moving.setMaximumHeight(80)
        for body in self.bodies:
            item = QtGui.QListWidgetItem(body.Label, self.moving)
            item.setFlags(item.flags() | QtCore.Qt.ItemIsUserCheckable)
            item.setCheckState(QtCore.Qt.Checked if body is self.bodies[-1] else QtCore.Qt.Unchecked)
        rows.addRow("Ticked bodies move:", self.moving)
        self.plane = choice(rows, "Plane of the motion:", ["XY", "XZ", "YZ"])
        self.own_plane = None
        self.take_plane = QtGui.QPushButton("Plane of the selected face or sketch")
        self.take_plane.clicked.connect(self.use_selected_plane)
        rows.addRow(self.take_plane)
        self.layers = choice(rows, "Solids are:", ["in layers, with heights", "cut at one height"])
        self.height = number(rows, "Height of the cut (mm):", 0)
        self.motion = choice(rows, "Motion:", ["turn about an axis", "to another's placement"])
        self.x, self.y = number(rows, "Axis at x (mm):", 0), number(rows, "Axis at y (mm):", 0)
        self.take = QtGui.QPushButton("Axis of the selected edge or face")
        self.take.clicked.connect(self.take_axis)
        rows.addRow(self.take)
        self.angle = number(rows, "Angle (degrees):", 90)
        self.target = choice(rows, "Object at the end:", [thing.Label for thing in self.targets()])
        self.clearance = number(rows, "Distance to keep (mm):", 0, low=0)
        self.fit = number(rows, "Shrink bodies by (--fit, mm):", 0, low=0)
        self.tolerance = number(rows, "Tolerance of chords (mm):", 0.01, low=0.0001)
        self.command = QtGui.QLineEdit(FreeCAD.ParamGet(PREFERENCES).GetString("Command", ""))
        self.command.setPlaceholderText("where the system looks for programs")
        rows.addRow("The command taut:", self.command)
        self.copies = QtGui.QCheckBox("Add a copy at the contact")
        self.copies.setChecked(True)
        rows.addRow(self.copies)
        self.check = QtGui.QPushButton("Check")
        self.check.clicked.connect(self.run)
        rows.addRow(self.check)
        for box in (self.layers, self.motion):
            box.currentIndexChanged.connect(self.show_what_counts)
        self.show_what_counts()
        self.words, self.picture = QtGui.QLabel(), QtGui.QLabel()
        self.words.setWordWrap(True)
        rows.addRow(self.words)
        rows.addRow(self.picture)

    def show_what_counts(self, *_):
        """Hides what the choices leave without a meaning."""
        turns = self.motion.currentIndex() == 0
        for field, shown in ((self.height, self.layers.currentIndex() == 1), (self.x, turns), (self.y, turns),
                             (self.take, turns), (self.angle, turns), (self.target, not turns)):
            field.setVisible(shown)
            label = self.form.layout().labelForField(field)
            if label:
                label.setVisible(shown)

    def targets(self):
        document = self.bodies[0].Document if self.bodies else None
        return [thing for thing in document.Objects if hasattr(thing, "Placement")] if document else []

    def chosen_plane(self):
        """The last choice is the selected one, once there is one."""
        return Plane.named(self.plane.currentText()) if self.plane.currentIndex() < 3 else self.own_plane

    def use_selected_plane(self):
        import FreeCADGui
        selected = FreeCADGui.Selection.getSelectionEx()
        if not selected:
            self.say(["Select a flat face, or a sketch."])
            return
        try:
            self.use_plane(Plane.of_selected(selected[0].Object, *selected[0].SubObjects[:1]))
        except TautError as error:
            self.say([str(error)])

    def use_plane(self, plane):
        self.own_plane = plane
        if self.plane.count() == 3:
            self.plane.addItem("the selected one")
        self.plane.setCurrentIndex(3)

    def take_axis(self):
        """From the selected edge or face: the point, in the coordinates of the plane."""
        import FreeCADGui
        for selected in FreeCADGui.Selection.getSelectionEx():
            for part in selected.SubObjects:
                point = axis_point(part)
                if point:
                    local = self.chosen_plane().to(point)
                    self.x.setValue(local.x)
                    self.y.setValue(local.y)
                    return
        self.say(["Select a round edge, a cylinder, or an edge that stands on the plane."])

    def chosen_motion(self, plane, moving):
        if self.motion.currentIndex() == 0:
            base = plane.placement.multVec(FreeCAD.Vector(self.x.value(), self.y.value(), 0))
            return Turn(plane, base, plane.normal, self.angle.value())
        target = self.targets()[self.target.currentIndex()]
        return Placements(plane, [moving[-1].getGlobalPlacement(), target.getGlobalPlacement()])

    def answer(self):
        """The Result for what is entered."""
        if not self.bodies:
            raise TautError("Select at least two objects, and start the macro again.")
        plane = self.chosen_plane()
        moving = [body for row, body in enumerate(self.bodies)
                  if self.moving.item(row).checkState() == QtCore.Qt.Checked]
        if not moving:
            raise TautError("Tick the bodies that move.")
        document = moving[0].Document
        folder = os.path.dirname(document.FileName) if document.FileName else tempfile.gettempdir()
        picture = os.path.join(folder, document.Name + "-contact.svg")
        return first_contact(self.bodies, moving, self.chosen_motion(plane, moving), plane,
                             height=None if self.layers.currentIndex() == 0 else self.height.value(),
                             tolerance=self.tolerance.value(), clearance=self.clearance.value(),
                             fit=self.fit.value(),
                             command=self.command.text(), picture=picture)

    def run(self):
        FreeCAD.ParamGet(PREFERENCES).SetString("Command", self.command.text())
        self.picture.clear()
        try:
            result = self.answer()
        except TautError as error:
            FreeCAD.Console.PrintError("taut: %s\n" % error)
            self.say([str(error)])
            return
        result.report()
        self.say(result.lines)
        self.show_picture(result.picture)
        if self.copies.isChecked():
            add_copies(result)

    def say(self, lines):
        self.words.setText("\n".join(lines))

    def show_picture(self, path):
        if not QtSvg:
            return
        renderer = QtSvg.QSvgRenderer(path)
        size = renderer.defaultSize()
        size.scale(240, 240, QtCore.Qt.KeepAspectRatio)
        image = QtGui.QPixmap(size)
        image.fill(QtCore.Qt.white)
        painter = QtGui.QPainter(image)
        renderer.render(painter)
        painter.end()
        self.picture.setPixmap(image)

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Close)


def choice(rows, label, words):
    box = QtGui.QComboBox()
    box.addItems(words)
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    rows.addRow(label, box)
    return box


def number(rows, label, value, low=-1e6):
    box = QtGui.QDoubleSpinBox()
    box.setDecimals(6)
    box.setRange(low, 1e6)
    box.setValue(value)
    rows.addRow(label, box)
    return box


def axis_point(part):
    """A point on the axis of a round edge or face, or on a straight edge; None of other shapes."""
    curve = getattr(part, "Curve", None) or getattr(part, "Surface", None)
    for name in ("Center", "Location"):
        if hasattr(curve, name):
            return getattr(curve, name)
    return None


def show():
    """For the macro: the panel, for what is selected."""
    import FreeCADGui
    FreeCADGui.Control.showDialog(TautPanel(FreeCADGui.Selection.getSelection()))
