"""Spark: `mapInArrow` gives batches of Arrow to the rules. It needs Java 17, and the wheel on all machines."""

import os
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

import pyarrow as pa
import shapely
from pyspark.sql import SparkSession

import pycga

TEXT = Path(__file__).with_name("house.cga").read_text()
TYPES = {"row": pa.int64(), "name": pa.string(), "error": pa.string(), "glb": pa.binary(), "floor area": pa.float64()}
SCHEMA = "row long, name string, error string, glb binary, `floor area` double"


def build(batches: Iterable[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
    rules = pycga.RuleFile.from_text(TEXT, name="house")
    for batch in batches:
        table = pa.table(rules.generate_all(pa.table(batch), name="id", threads=1).table(glb=True))
        yield from table.select(list(TYPES)).cast(pa.schema(TYPES)).to_batches()


os.environ["PYSPARK_PYTHON"] = sys.executable
spark = SparkSession.builder.master("local[2]").config("spark.ui.enabled", "false").getOrCreate()
lots = [(str(n), 6.0 + n % 9, bytearray(shapely.box(25 * n, 0, 25 * n + 16, 11).wkb)) for n in range(1000)]
rows = spark.createDataFrame(lots, "id string, height double, geometry binary").repartition(4)
made = rows.mapInArrow(build, SCHEMA)
made.selectExpr("count(*) as houses", "sum(`floor area`) as floor_area", "sum(length(glb)) as bytes").show()
spark.stop()
