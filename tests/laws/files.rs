//! The module with written grammars.

/// The text of a module with grammars. `levels` go before the header of each, `rules` gives the source of its rules.
pub(crate) fn list(seeds: &[u64], levels: &str, rules: impl Fn(u64) -> String) -> String {
    let mut text =
        String::from("// The grammars that are played, each with its seed. They are written, not edited.\n\n");
    text += "use crate::host::Make;\n\n/// Each with the seed it is written with.\n";
    text += "pub(crate) const ALL: &[(u64, Make)] = &[\n";
    seeds.iter().for_each(|seed| text += &format!("    ({seed}, || Box::new(G{seed}::default())),\n"));
    text += "];\n\n";
    for seed in seeds {
        text += &format!("cga::cga! {{ {levels} pub grammar G{seed} {}; }}\n", rules(*seed));
    }
    text
}
