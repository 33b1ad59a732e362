//! The guide: how to write rules and what programs do with them. The pages are the files of `docs/guide`.
//!
//! - [Tutorial](tutorial): from a lot to a street of houses.
//! - [Recipes](recipes): uses of grammars in programs.
//! - [Questions](questions): where to find an answer.
//! - [Declarations](declarations): the syntax of attributes, functions, rules, styles and imports.
//! - [Results](results): seeds, coordinates, levels of detail, tuning.
//! - [Faults](faults): each problem of a run, with its cause and remedy.
//! - [Programs](programs): grammars in programs, from one house to a city.
//! - [Writing](writing): rules without a build.
//! - [CityEngine](cityengine): for users of CityEngine.
//! - [PyPRT](pyprt): for users of PyPRT.
//!
//! The words of the language are in the [reference](crate::reference).

/// The address of a file of this package.
#[cfg(docsrs)]
macro_rules! file {
    ($path:literal) => {
        concat!("<https://docs.rs/crate/cga/", env!("CARGO_PKG_VERSION"), "/source/", $path, ">")
    };
}

/// The address of a file of this package.
#[cfg(not(docsrs))]
macro_rules! file {
    ($path:literal) => {
        concat!("<file://", env!("CARGO_MANIFEST_DIR"), "/", $path, ">")
    };
}

/// A page. The first definition of a link counts: these replace the links at the end of the file, which are right in the repository.
macro_rules! page {
    ($name:ident, $path:literal) => {
        #[doc = "[cityengine]: crate::guide::cityengine"]
        #[doc = "[declarations]: crate::guide::declarations"]
        #[doc = "[faults]: crate::guide::faults"]
        #[doc = "[pyprt]: crate::guide::pyprt"]
        #[doc = "[recipes]: crate::guide::recipes"]
        #[doc = "[reference]: crate::reference"]
        #[doc = "[results]: crate::guide::results"]
        #[doc = "[tutorial]: crate::guide::tutorial"]
        #[doc = "[writing]: crate::guide::writing"]
        #[doc = "[alone]: crate::guide::writing#rules-of-others"]
        #[doc = "[assets]: crate::guide::recipes#assets"]
        #[doc = "[coordinates]: crate::guide::results#coordinates"]
        #[doc = "[engines]: crate::guide::recipes#engines-and-browsers"]
        #[doc = "[follow]: crate::guide::writing#a-program-that-follows-its-rules"]
        #[doc = "[levels]: crate::guide::results#levels-of-detail"]
        #[doc = "[limits]: crate::guide::recipes#limits"]
        #[doc = "[lots]: crate::guide::recipes#lots-with-attributes"]
        #[doc = "[materials]: crate::guide::recipes#meshes-by-material"]
        #[doc = "[neighbours]: crate::guide::recipes#rules-that-ask-about-neighbours"]
        #[doc = "[seeds]: crate::guide::results#seeds-and-determinism"]
        #[doc = "[sinks]: crate::guide::recipes#your-own-sink"]
        #[doc = "[sliders]: crate::guide::recipes#attributes-in-a-user-interface"]
        #[doc = "[streets]: crate::guide::recipes#streets"]
        #[doc = "[styles]: crate::guide::declarations#styles"]
        #[doc = "[textures]: crate::guide::tutorial#9-texture"]
        #[doc = "[tiles]: crate::guide::recipes#maps-and-3d-tiles"]
        #[doc = concat!("[diagnostics]: ", file!("docs/diagnostics.md"))]
        #[doc = concat!("[editor]: ", file!("docs/editor.md"))]
        #[doc = concat!("[features]: ", file!("docs/features.md"))]
        #[doc = concat!("[performance]: ", file!("docs/performance.md"))]
        #[doc = concat!("[tags]: ", file!("docs/tags.md"))]
        #[doc = concat!("[gallery]: ", file!("docs/gallery/scenes.md"))]
        #[doc = concat!("[house]: ", file!("docs/guide/house.cga"))]
        #[doc = concat!("[map]: ", file!("docs/guide/street.geojson"))]
        #[doc = concat!("[bevy]: ", file!("docs/guide/bevy.png"))]
        #[doc = concat!("[playground]: ", file!("docs/guide/playground.png"))]
        #[doc = concat!("[wgpu]: ", file!("docs/guide/wgpu.png"))]
        #[doc = concat!("[step-01]: ", file!("docs/guide/step-01.png"))]
        #[doc = concat!("[step-02]: ", file!("docs/guide/step-02.png"))]
        #[doc = concat!("[step-03]: ", file!("docs/guide/step-03.png"))]
        #[doc = concat!("[step-04]: ", file!("docs/guide/step-04.png"))]
        #[doc = concat!("[step-05]: ", file!("docs/guide/step-05.png"))]
        #[doc = concat!("[step-06]: ", file!("docs/guide/step-06.png"))]
        #[doc = concat!("[step-07]: ", file!("docs/guide/step-07.png"))]
        #[doc = concat!("[step-08]: ", file!("docs/guide/step-08.png"))]
        #[doc = concat!("[step-09]: ", file!("docs/guide/step-09.png"))]
        #[doc = concat!("[step-10]: ", file!("docs/guide/step-10.png"))]
        #[doc = concat!("[step-12]: ", file!("docs/guide/step-12.png"))]
        #[doc = ""]
        #[doc = include_str!($path)]
        pub mod $name {}
    };
}

page!(tutorial, "../docs/guide/tutorial.md");
page!(recipes, "../docs/guide/recipes.md");
page!(questions, "../docs/guide/questions.md");
page!(declarations, "../docs/guide/declarations.md");
page!(results, "../docs/guide/results.md");
page!(faults, "../docs/guide/faults.md");
page!(programs, "../docs/guide/programs.md");
page!(writing, "../docs/guide/writing.md");
page!(cityengine, "../docs/guide/cityengine.md");
page!(pyprt, "../docs/guide/pyprt.md");
