"""The programs in examples/python/ and the notebook there, as their readers run them."""

import json
import os
import pathlib
import subprocess
import sys

import pytest

root = pathlib.Path(__file__).resolve().parents[2]
examples = root / "examples" / "python"

# What each program takes besides its picture, and what it prints.
PROGRAMS = {
    "hinge": ([], ["opening: free", "never closer than 1.768454, which is at 66.802 degrees"]),
    "gear_tolerances": (["400"], ["turns freely: 251", "teeth meet: 65", "does not fit: 84"]),
    "drive": ([], ["free ways: 19 of 61"]),
    "cartridge": ([], ["the cartridge: free, with 0.4994 to spare", "0.6 thicker: contact at t = 0.424967"]),
}


def test_every_program_is_run():
    assert set(PROGRAMS) == {path.stem for path in examples.glob("*.py")}


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_program_prints_its_answers_and_writes_its_picture(name, tmp_path):
    pytest.importorskip("matplotlib")
    pytest.importorskip("shapely")
    from matplotlib import image
    options, printed = PROGRAMS[name]
    run = subprocess.run([sys.executable, examples / f"{name}.py", tmp_path / "picture.png", *options],
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120, cwd=tmp_path)
    assert (run.returncode, run.stdout.splitlines(), run.stderr) == (0, printed, "")
    pixels = image.imread(tmp_path / "picture.png")
    assert pixels.shape[0] > 300 and pixels.shape[1] > 500
    # Lines, fills and words: no empty sheet.
    assert 0.02 < (pixels[:, :, :3] < 0.8).any(axis=2).mean() < 0.9


def test_the_notebook_runs(tmp_path):
    pytest.importorskip("nbconvert", reason="nbconvert is not installed: on Debian, python3-nbconvert")
    pytest.importorskip("ipykernel", reason="ipykernel is not installed: on Debian, python3-ipykernel")
    pytest.importorskip("matplotlib")
    import taut2d
    # The kernel is Debian's Python, which need not be the one that runs this.
    package = os.path.dirname(os.path.dirname(os.path.abspath(taut2d.__file__)))
    environment = dict(os.environ, PYTHONPATH=package, HOME=str(tmp_path), JUPYTER_ALLOW_INSECURE_WRITES="1")
    run = subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", tmp_path,
                          examples / "first_steps.ipynb"], stderr=subprocess.PIPE, text=True, timeout=300, env=environment)
    assert run.returncode == 0, run.stderr
    cells = json.loads((tmp_path / "first_steps.ipynb").read_text())["cells"]
    shown = [output.get("data", {}) for cell in cells for output in cell.get("outputs", [])]
    pages = ["".join(data["text/html"]) for data in shown if "text/html" in data]
    # The scene and the answer, as they show themselves, and the animation; two pictures of matplotlib.
    assert [page.count("data:image/svg+xml") for page in pages] == [1, 1, 0] and "contact at t = " in pages[1]
    assert sum("image/png" in data for data in shown) == 2


def test_the_notebook_is_kept_without_outputs():
    for cell in json.loads((examples / "first_steps.ipynb").read_text())["cells"]:
        assert not cell.get("outputs") and cell.get("execution_count") is None
