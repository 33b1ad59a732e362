use cga::cga;

cga! {
    pub grammar Values;
    Lot --> color("red") t(1 / 0, 0, 0) A.
    Wall --> projectUV(10) A.
    @Deny(not_a_color)
    Roof --> color(255, 128, 0) A.
    Shed --> setPivot(xyz, 8) A.
    @Deny(split_without_uv)
    Street --> setupProjection(0, scope.xy, 1, 1) split(u, uvSpace, 0) { 0.5 : A. | ~1 : A. }
    @Deny(missing_uv_set)
    Hut --> primitiveCube() tileUV(2, 1, 1) A.
    @Deny(unknown_tag)
    Barn --> extrude(9) comp(f) { isTagged("extrude.sides") : A. }
    @Deny(unknown_label)
    Fort --> label("gate") print(contextCount(intra, "gates")) A.
    @Deny(lost_label)
    Keep --> union { label("tower") A. | A. } A.
    @Deny(idle_query)
    attr hidden = touches(intra)
    Moat --> print(hidden) A.
}

cga! {
    pub grammar Textures;
    @Deny(texture_without_uv)
    Shed --> deleteUV(0) texture("brick") A.
}

fn main() {}
