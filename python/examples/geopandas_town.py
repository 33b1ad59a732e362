"""A town from a GeoDataFrame: footprints and heights in, one GLB and a column of floor areas out."""

from pathlib import Path

import geopandas
import pandas
import shapely

import pycga

rules = pycga.RuleFile(Path(__file__).with_name("house.cga"))

# Footprints in metres; with a file: geopandas.read_file("lots.gpkg").to_crs(32632).
east, north = 512_000, 5_400_000
boxes = [shapely.box(east + 25 * i, north + 20 * j, east + 25 * i + 16, north + 20 * j + 11) for i in range(10) for j in range(10)]
lots = geopandas.GeoDataFrame({"id": [f"lot {n}" for n in range(100)], "height": [6 + 3 * (n % 4) for n in range(100)]}, geometry=boxes, crs=32632)

# The column `height` sets the attribute of that name, and seeds follow from the column `id`.
models = rules.generate_all(lots.to_arrow(), name="id", origin=(east, north))
for failure in models.failures:
    print("left out:", failure)
models.to_model().write("town.glb")

table = pandas.DataFrame(models.reports())
lots["floor_area"] = table.set_index("row")["floor area"]
print(lots[["id", "height", "floor_area"]].head())
print(len(models), "houses,", round(lots["floor_area"].sum()), "m²")
