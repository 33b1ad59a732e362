"""Ray Data: 3D Tiles of a GeoParquet file on many machines: `python ray_tiles.py lots.parquet rules.cga tiles`.

All machines have the wheel, and the folder of the tiles at the same path."""

import sys

import pyarrow as pa
import ray

import pycga

lots, rules, folder = sys.argv[1:]
# The smallest units keep most machines busy.
city = pycga.City(folder, pycga.RuleFile(rules), unit_lots=1)


def count(batch: pa.Table) -> pa.Table:
    return pa.table({"count": [city.count(batch)]})


def split(batch: pa.Table) -> pa.Table:
    return pa.table(plan.lots(batch))


def make(group: pa.Table) -> pa.Table:
    return pa.table({"made": [plan.make(group, threads=1)]})


if not ray.is_initialized():
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
# The usual shuffle of Ray 2.60 waited without end for the parts of a lost node.
ray.data.DataContext.get_current().shuffle_strategy = ray.data.context.ShuffleStrategy.SORT_SHUFFLE_PULL_BASED
rows = ray.data.read_parquet(lots)
counts = rows.map_batches(count, batch_format="pyarrow")
plan = city.plan(row["count"] for row in counts.iter_rows())
units = rows.map_batches(split, batch_format="pyarrow").groupby("unit")
made = units.map_groups(make, batch_format="pyarrow")
print(plan.finish(row["made"] for row in made.iter_rows()))
ray.shutdown()
