"""Ray Data: each batch of lots becomes models on some machine of a cluster. The wheel must be installed on all of them."""

from pathlib import Path

import pyarrow as pa
import ray
import shapely

import pycga

TEXT = Path(__file__).with_name("house.cga").read_text()


class Builder:
    """Loads the rules once for each worker."""

    def __init__(self) -> None:
        self.rules = pycga.RuleFile.from_text(TEXT, name="house")

    def __call__(self, batch: pa.Table) -> pa.Table:
        # Seeds follow from ids, so the batches make no difference. Rows without a model have their reason in `error`.
        return pa.table(self.rules.generate_all(batch, name="id", threads=1).table(glb=True))


boxes = [shapely.box(25 * n, 0, 25 * n + 16, 11) for n in range(1000)]
lots = pa.table({"id": [str(n) for n in range(1000)], "height": [6.0 + n % 9 for n in range(1000)], "geometry": shapely.to_wkb(boxes)})

ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
rows = ray.data.from_arrow(lots).map_batches(Builder, batch_format="pyarrow", batch_size=250, concurrency=2)
for row in rows.sort("name").take(3):
    print(row["name"], len(row["glb"]), "bytes,", row["floor area"], "m²")
print(rows.count(), "rows")
ray.shutdown()
