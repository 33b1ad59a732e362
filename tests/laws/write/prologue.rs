//! Attributes, and functions that make text of everything a rule can observe.

/// The beginning of each grammar. The texts are words and numbers between semicolons.
pub(super) const TEXT: &str = r#"attr a = 3.71
attr b = 1.37
attr c = 0.613
attr on = true
frames(n) = "frames " + n + ";size;" + scope.sx + ";" + scope.sy + ";" + scope.sz +
    ";place;" + scope.tx + ";" + scope.ty + ";" + scope.tz +
    ";turn;" + turn(scope.rx) + ";" + turn(scope.ry) + ";" + turn(scope.rz) + ";elevation;" + scope.elevation +
    ";pivot;" + pivot.px + ";" + pivot.py + ";" + pivot.pz +
    ";pivot turn;" + turn(pivot.ox) + ";" + turn(pivot.oy) + ";" + turn(pivot.oz) +
    ";comp;" + comp.index + ";" + comp.total + ";" + comp.sel + ";split;" + split.index + ";" + split.total
turn(angle) = cos(angle) + ";" + sin(angle)
form(n) = "form " + n + ";area;" + geometry.area + ";volume;" + geometry.volume + ";height;" + geometry.height +
    ";counts;" + geometry.nVertices + ";" + geometry.nEdges + ";" + geometry.nFaces + ";" + geometry.nHoles +
    ";boundary;" + geometry.boundaryLength + ";slope;" + geometry.angle(maxSlope) +
    ";azimuth;" + turn(geometry.angle(azimuth)) + ";zenith;" + geometry.angle(zenith) +
    ";concave;" + geometry.isConcave + ";closed;" + geometry.isClosedSurface +
    ";rectangular;" + geometry.isRectangular(1) + ";planar;" + geometry.isPlanar(1) +
    ";groups;" + str(geometry.groups) + ";materials;" + str(geometry.materials) +
    ";tags;" + str(geometry.tags("*", faces)) + str(geometry.tags("*", edges)) + str(geometry.tags("*", vertices))
sides(n) = "sides " + n + ";areas;" + geometry.area(front) + ";" + geometry.area(side) + ";" + geometry.area(top) +
    ";" + geometry.area(object.front) + ";" + geometry.area(object.side) + ";" + geometry.area(world.up) +
    ";" + geometry.area(world.south) + ";" + geometry.area(street.front) +
    ";oriented;" + geometry.isOriented(front) + ";" + geometry.isOriented(back) + ";" + geometry.isOriented(left) +
    ";" + geometry.isOriented(right) + ";" + geometry.isOriented(top) + ";" + geometry.isOriented(bottom) +
    ";" + geometry.isOriented(object.left) + ";" + geometry.isOriented(object.right) +
    ";" + geometry.isOriented(object.back) + ";" + geometry.isOriented(world.down) +
    ";" + geometry.isOriented(world.east) + ";" + geometry.isOriented(street.side)
parts(n) = "parts " + n + ";faces;" + list(comp(f) { all : scope.sx }) + list(comp(f) { all : geometry.area }) +
    ";face edges;" + list(comp(fe) { all : scope.sx }) + ";edges;" + list(comp(e) { all : scope.sx }) +
    ";vertices;" + list(comp(v) { all : convert(x, scope, world, pos, 0, 0, 0) }) +
    list(comp(v) { all : convert(y, scope, world, pos, 0, 0, 0) }) +
    ";face vertices;" + list(comp(fv) { all : convert(z, scope, world, pos, 0, 0, 0) }) +
    ";words;" + str(comp(f) { front = comp.sel + comp.index | left = "l" + comp.total | top = "t" | side = "s" }) +
    str(comp(fe) { front : "f" | back = "b" + comp.index | border : "r" | inside = "i" + comp.total }) +
    str(comp(f) { isTagged("extrude.top") : "t" | isTagged("extrude.side") : "s" | isTagged("extrude") : "b" }) +
    str(comp(fe) { isTagged("mark.x") : "x" | isTagged("setback") : "k" | isTagged("mark", v) : "m" }) +
    str(comp(v) { isTagged("mark.x") : "x" | isTagged("mark") : "m" })
list(values) = numbers(values, 0)
numbers(values, i) = case i < size(values) : ";" + values[i] + numbers(values, i + 1) else : ";"
places(n) = "places " + n + ";world;" + at(convert(scope, world, pos, [1, 2, 3])) +
    ";pivot;" + at(convert(scope, pivot, pos, [1, 2, 3])) + ";object;" + at(convert(pivot, object, pos, [1, 2, 3])) +
    ";back;" + at(convert(world, scope, pos, [1, 2, 3]))
uvs(n) = "uvs " + n + ";has;" + geometry.hasUVs() + geometry.hasUVs(0) + geometry.hasUVs(1) + geometry.hasUVs(2) +
    ";coordinates;" + geometry.uMin(0) + ";" + geometry.uMax(0) + ";" + geometry.vMin(0) + ";" + geometry.vMax(0) +
    ";coordinates;" + geometry.uMin(1) + ";" + geometry.uMax(1) + ";" + geometry.vMin(1) + ";" + geometry.vMax(1) +
    ";coordinates;" + geometry.du(0, uvSpace) + ";" + geometry.dv(1, uvSpace) + ";" + geometry.du(2, uvSpace)
at(p) = p[0] + ";" + p[1] + ";" + p[2]
"#;
