"""Blender: a house whose parts are objects with names and materials. `pip install bpy`, or run it inside of Blender."""

from pathlib import Path

import bpy

import pycga

rules = pycga.RuleFile(Path(__file__).with_name("house.cga"))
house = rules.generate([(0, 0), (18, 0), (18, 8), (10, 8), (10, 14), (0, 14)], attributes={"height": 12})

bpy.ops.wm.read_factory_settings(use_empty=True)
collection = bpy.data.collections.new("House")
bpy.context.scene.collection.children.link(collection)
for mesh in house.meshes(by="rule"):
    name = mesh.rule or "Part"
    # Rules have y up, Blender has z up: (x, y, z) becomes (x, −z, y).
    positions = mesh.positions[:, [0, 2, 1]] * (1, -1, 1)
    data = bpy.data.meshes.new(name)
    data.from_pydata(positions.tolist(), [], mesh.indices.tolist())
    material = bpy.data.materials.new(name)
    material.diffuse_color = (*mesh.material.color, mesh.material.opacity)
    data.materials.append(material)
    collection.objects.link(bpy.data.objects.new(name, data))

bpy.ops.wm.save_as_mainfile(filepath=str(Path("house.blend").resolve()))
print("objects:", sorted(item.name for item in collection.objects))
