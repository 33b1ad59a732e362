"""A house on an L-shaped lot: `python examples/hello.py` writes house.glb."""

from pathlib import Path

import pycga

rules = pycga.RuleFile(Path(__file__).with_name("house.cga"))
for attribute in rules.attributes.values():
    print(f"{attribute.name}: {attribute.type}, {attribute.about}")

lot = pycga.Shape([(0, 0), (18, 0), (18, 8), (10, 8), (10, 14), (0, 14)], name="Mill Street 4")
house = rules.generate(lot, attributes={"height": 12}, seed=1)
house.write("house.glb")

print(house, {rule: count for rule, count in house.counts.items()})
print("floor area:", house.reports["floor area"]["sum"], "m²")
for mesh in house.meshes():
    print(mesh, "positions", mesh.positions.shape)
