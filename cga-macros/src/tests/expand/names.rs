#[allow(unexpected_cfgs, non_upper_case_globals, non_snake_case)]
const _: () = {
    #[cfg(rust_analyzer)]
    const _: () = {
        const floor: f64 = ::core::unreachable!();
        const _: () = {
            _ = floor;
        };
        fn attributes(grammar: &Tower) {
            _ = &grammar.height;
            _ = &grammar.height;
            _ = &grammar.height;
            _ = &grammar.height;
        }
        const _: () = {
            fn parameters(n: f64) {
                _ = n;
            }
        };
        const _: () = {
            fn parameters(width: f64, kind: &'static str, wide: bool) {
                _ = width;
                _ = kind;
                _ = wide;
            }
        };
    };
};
