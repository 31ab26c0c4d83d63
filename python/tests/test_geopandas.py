"""The recipe of docs/python.md for maps from GeoPandas, as its reader runs it."""

import pathlib
import re
import subprocess
import sys

import pytest

geopandas = pytest.importorskip("geopandas", reason="GeoPandas is not installed: on Debian, python3-geopandas")
root = pathlib.Path(__file__).resolve().parents[2]


def recipe():
    page = (root / "docs" / "python.md").read_text(encoding="utf-8")
    return re.search(r"<!-- file: buildings.py -->\n```python\n(.*?)```", page, re.DOTALL)[1]


@pytest.mark.parametrize("name, driver, reading", [
    ("town.gpkg", "GPKG", None), ("town.shp", "ESRI Shapefile", 'read_file("town.shp")'),
    ("town.geojson", "GeoJSON", 'read_file("town.geojson")')])
def test_a_map_from_a_file(name, driver, reading, tmp_path):
    from shapely.geometry import MultiPolygon, Polygon, box
    houses = [box(500 + 20 * i, 10 * j, 512 + 20 * i, 10 * j + 6) for i in range(3) for j in range(3)]
    houses[4] = Polygon(houses[4].exterior.coords, [box(525, 12, 527, 14).exterior.coords])
    houses[8] = MultiPolygon([houses[8], box(560, 20, 562, 22)])
    frame = geopandas.GeoDataFrame({"number": [100 + k for k in range(9)]}, geometry=houses)
    frame.to_file(tmp_path / name, driver=driver, **({"layer": "buildings"} if driver == "GPKG" else {}))
    program = recipe()
    if reading:
        program = program.replace('read_file("town.gpkg", layer="buildings")', reading)
    run = subprocess.run([sys.executable, "-W", "ignore", "-c", program], cwd=tmp_path, text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE)
    assert run.returncode == 0, run.stderr
    # The crane stands in the street between two rows and turns into a corner of the building 1,2.
    assert run.stdout.startswith("contact ('building 5', 'crane') ") and run.stdout.rstrip().endswith("105")
