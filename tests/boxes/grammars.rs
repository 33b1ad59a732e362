//! The grammars that are played, each with its seed. They are written, not edited.

use crate::play::Make;
use cga::cga;

/// Each with the seed it is written with.
pub(crate) const ALL: &[(u64, Make)] = &[
    (2007, || Box::new(G2007::default())),
    (2008, || Box::new(G2008::default())),
    (2009, || Box::new(G2009::default())),
    (2010, || Box::new(G2010::default())),
    (2011, || Box::new(G2011::default())),
    (2012, || Box::new(G2012::default())),
    (2013, || Box::new(G2013::default())),
    (2014, || Box::new(G2014::default())),
    (2015, || Box::new(G2015::default())),
    (2016, || Box::new(G2016::default())),
    (2017, || Box::new(G2017::default())),
    (2018, || Box::new(G2018::default())),
    (2019, || Box::new(G2019::default())),
    (2020, || Box::new(G2020::default())),
    (2021, || Box::new(G2021::default())),
    (2022, || Box::new(G2022::default())),
    (2023, || Box::new(G2023::default())),
    (2024, || Box::new(G2024::default())),
    (2025, || Box::new(G2025::default())),
    (2026, || Box::new(G2026::default())),
    (2027, || Box::new(G2027::default())),
    (2028, || Box::new(G2028::default())),
    (2029, || Box::new(G2029::default())),
    (2030, || Box::new(G2030::default())),
];

cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2007 in "tests/boxes/rules/2007.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2008 in "tests/boxes/rules/2008.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2009 in "tests/boxes/rules/2009.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2010 in "tests/boxes/rules/2010.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2011 in "tests/boxes/rules/2011.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2012 in "tests/boxes/rules/2012.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2013 in "tests/boxes/rules/2013.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2014 in "tests/boxes/rules/2014.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2015 in "tests/boxes/rules/2015.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2016 in "tests/boxes/rules/2016.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2017 in "tests/boxes/rules/2017.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2018 in "tests/boxes/rules/2018.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2019 in "tests/boxes/rules/2019.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2020 in "tests/boxes/rules/2020.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2021 in "tests/boxes/rules/2021.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2022 in "tests/boxes/rules/2022.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2023 in "tests/boxes/rules/2023.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2024 in "tests/boxes/rules/2024.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2025 in "tests/boxes/rules/2025.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2026 in "tests/boxes/rules/2026.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2027 in "tests/boxes/rules/2027.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2028 in "tests/boxes/rules/2028.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2029 in "tests/boxes/rules/2029.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G2030 in "tests/boxes/rules/2030.cga"; }
