#[allow(unexpected_cfgs, non_upper_case_globals, non_snake_case)]
const _: () = {
    #[cfg(rust_analyzer)]
    const _: () = {
        const Lot: () = ::core::unreachable!();
        const _: () = {};
        const Facade: () = ::core::unreachable!();
        const _: () = {
            _ = Facade;
        };
        const Roof: () = ::core::unreachable!();
        const _: () = {
            _ = Roof;
        };
        fn attributes(grammar: &Tower) {
            _ = &grammar.height;
            _ = &grammar.height;
        }
        const _: () = {
            fn parameters(width: f64) {
                _ = width;
            }
        };
    };
};
