"""Models: meshes, reports, prints, faults, files."""

from pathlib import Path

import numpy as np
import pytest

import pycga

LOT = pycga.Shape([(0, 0), (18, 0), (18, 8), (10, 8), (10, 14), (0, 14)])


def area(mesh: pycga.Mesh) -> float:
    a, b, c = (mesh.positions[mesh.indices[:, corner]].astype(float) for corner in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def volume(mesh: pycga.Mesh) -> float:
    a, b, c = (mesh.positions[mesh.indices[:, corner]].astype(float) for corner in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


@pytest.mark.parametrize("by", ["material", "building", "rule", "leaf"])
def test_areas_of_meshes_add_up(house: pycga.RuleFile, by: str) -> None:
    model = house.generate(LOT)
    meshes = model.meshes(by=by)
    assert sum(area(mesh) for mesh in meshes) == pytest.approx(model.area, rel=1e-6)
    assert sum(len(mesh.indices) for mesh in meshes) == model.triangle_count


def test_volumes_of_meshes_add_up(box: pycga.RuleFile) -> None:
    parts = pycga.RuleFile.from_text("Lot --> extrude(5) split(x) { ~1 : A. | ~2 : B. }")
    model = parts.generate(LOT)
    assert sum(volume(mesh) for mesh in model.meshes()) == pytest.approx(model.volume) == pytest.approx(5 * 204)
    # The faces of a box enclose it, although each is a part of its own.
    assert sum(volume(mesh) for mesh in box.generate(LOT).meshes()) == pytest.approx(5 * 204)


def test_meshes_have_rows_of_numbers(house: pycga.RuleFile) -> None:
    model = house.generate(LOT, attributes={"wall": "#ff0000"})
    meshes = {mesh.rule: mesh for mesh in model.meshes()}
    assert set(meshes) == set(model.counts) == {"Wall", "Glass", "Roof"}
    for mesh in meshes.values():
        count = len(mesh.positions)
        assert mesh.positions.shape == mesh.normals.shape == (count, 3) and mesh.indices.shape[1] == 3
        assert [str(array.dtype) for array in (mesh.positions, mesh.normals, mesh.indices)] == ["float32", "float32", "uint32"]
        assert mesh.indices.max() == count - 1 and mesh.places.shape == (0, 4, 4) and mesh.uvs is None
        assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1)
    assert meshes["Wall"].material.color == (1.0, 0.0, 0.0) and meshes["Wall"].material.opacity == 1.0
    with pytest.raises(ValueError, match='"rule"'):
        model.meshes(by="floor")


def test_meshes_have_texture_coordinates_and_materials() -> None:
    rules = pycga.RuleFile.from_text(
        'Lot --> setupProjection(0, scope.xz, 2, 2) projectUV(0) texture("brick.png") set(material.roughness, 0.25) set(material.name, "M") Lawn.'
    )
    (mesh,) = rules.generate(pycga.Shape.rectangle(4, 6)).meshes()
    assert mesh.uvs is not None and mesh.uvs.shape == (4, 2)
    assert (mesh.uvs.min(axis=0) == 0).all() and mesh.uvs.max(axis=0).tolist() == [2.0, 3.0]
    material = mesh.material
    assert (material.texture, material.roughness, material.name, material.double_sided) == ("brick.png", 0.25, "M", True)


def test_assets_have_places(tmp_path: Path) -> None:
    (tmp_path / "lamp.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    text = 'Lot --> split(x) { { 2 : i("lamp.obj") Lamp. }* }'
    rules = pycga.RuleFile.from_text(text, assets=tmp_path)
    model = rules.generate(pycga.Shape.rectangle(8, 3))
    assert model.counts == {"Lamp": 4} and not model.faults
    (mesh,) = model.meshes()
    assert mesh.places.shape == (4, 4, 4) and (mesh.places[:, 3] == [0, 0, 0, 1]).all()
    corners = np.concatenate([mesh.positions, np.ones((3, 1))], axis=1)
    moved = np.einsum("kij,nj->kni", mesh.places, corners)[:, :, :3]
    assert model.bounds is not None
    assert np.allclose(moved.min(axis=(0, 1)), model.bounds[0]) and np.allclose(moved.max(axis=(0, 1)), model.bounds[1])


def test_reports_are_dicts() -> None:
    rules = pycga.RuleFile.from_text(
        'Lot --> split(x) { { 2 : report("width", scope.sx) report("kind", "bay") report("wide", scope.sx > 1) X. }* } report("width", "two")'
    )
    reports = rules.generate(pycga.Shape.rectangle(8, 3)).reports
    assert reports["width"] == {"count": 4, "nans": 0, "sum": 8.0, "average": 2.0, "min": 2.0, "max": 2.0, "texts": {}}
    assert (reports["kind"]["count"], reports["kind"]["texts"]) == (4, {"bay": 4})
    assert reports["wide"]["sum"] == 4.0 and reports["width (string)"]["texts"] == {"two": 1}


def test_prints_and_faults_are_lists() -> None:
    rules = pycga.RuleFile.from_text('Lot --> print("a") print(1 + 1) i("none.obj") X.')
    model = rules.generate(pycga.Shape.rectangle(8, 3))
    assert model.prints == ["a", "2"]
    (fault,) = model.faults
    assert (fault.kind, fault.count, fault.trail) == ("asset", 1, ["Lot"]) and "none.obj" in fault.message and fault.text == str(fault)


def test_files_have_the_bytes_of_the_model(house: pycga.RuleFile, tmp_path: Path) -> None:
    model = house.generate(LOT)
    model.write_glb(tmp_path / "a.glb")
    model.write(str(tmp_path / "b.glb"))
    assert (tmp_path / "a.glb").read_bytes() == (tmp_path / "b.glb").read_bytes() == model.to_glb()
    assert model.to_glb()[:4] == b"glTF"
    for ending, begin in [("obj", b"#"), ("svg", b"<svg"), ("png", b"\x89PNG")]:
        model.write(tmp_path / f"c.{ending}", width=64, height=48)
        content = (tmp_path / f"c.{ending}").read_bytes()
        assert content.startswith(begin) or ending == "obj" and b"\nv " in content
    assert (tmp_path / "c.mtl").exists()


def test_files_that_cannot_be_written_are_errors(house: pycga.RuleFile, tmp_path: Path) -> None:
    model = house.generate(LOT)
    with pytest.raises(pycga.WriteError):
        model.write_glb(tmp_path / "none" / "a.glb")
    with pytest.raises(ValueError, match="ends in none of"):
        model.write(tmp_path / "a.fbx")
    with pytest.raises(ValueError, match="pixels"):
        model.write(tmp_path / "a.png", width=0)


def test_equal_seeds_are_equal_models(house: pycga.RuleFile) -> None:
    walls = {house.generate(LOT, seed=seed).attributes["wall"] for seed in range(20)}
    assert 1 < len(walls)
    assert house.generate(LOT, seed=3).to_glb() == house.generate(LOT, seed=3).to_glb()
    assert house.generate(LOT).seed == 0 and house.generate(LOT, seed=2**64 - 1).seed == 2**64 - 1
    with pytest.raises(OverflowError):
        house.generate(LOT, seed=-1)


def test_a_model_without_geometry_is_a_model() -> None:
    model = pycga.RuleFile.from_text("Lot --> NIL").generate(LOT)
    assert (len(model), model.bounds, model.meshes(), model.counts, model.area) == (0, None, [], {}, 0.0) and model
