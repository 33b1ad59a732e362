"""Spark: 3D Tiles of a GeoParquet file on many machines: `python spark_tiles.py lots.parquet rules.cga tiles`. It needs Java 17.

All machines have the wheel, and the folder of the tiles at the same path."""

import os
import sys
from collections.abc import Iterable, Iterator

import pyarrow as pa
from pyspark.sql import SparkSession

import pycga

lots, rules, folder = sys.argv[1:]
# The smallest units keep most machines busy.
city = pycga.City(folder, pycga.RuleFile(rules), unit_lots=1)


def count(batches: Iterable[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
    for batch in batches:
        yield pa.record_batch({"count": [city.count(batch)]})


def split(batches: Iterable[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
    for batch in batches:
        yield from pa.table(plan.lots(batch)).to_batches()


def make(group: pa.Table) -> pa.Table:
    return pa.table({"made": [plan.make(group, threads=1)]})


os.environ["PYSPARK_PYTHON"] = sys.executable
spark = SparkSession.builder.master("local[2]").config("spark.ui.enabled", "false").getOrCreate()
rows = spark.read.parquet(lots)
plan = city.plan(row["count"] for row in rows.mapInArrow(count, "count binary").toLocalIterator())
units = rows.mapInArrow(split, "unit int, lot binary").groupBy("unit")
print(plan.finish(row["made"] for row in units.applyInArrow(make, "made binary").toLocalIterator()))
spark.stop()
