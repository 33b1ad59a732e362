//! The grammars that are played. `CGA_BLESS=1` writes this file.

use crate::played::Make;
use cga::cga;

/// Each with the seed it is written with.
pub(crate) const ALL: &[(u64, Make)] = &[
    (100, || Box::new(G100::default())),
    (101, || Box::new(G101::default())),
    (102, || Box::new(G102::default())),
    (103, || Box::new(G103::default())),
    (104, || Box::new(G104::default())),
    (105, || Box::new(G105::default())),
    (106, || Box::new(G106::default())),
    (107, || Box::new(G107::default())),
    (108, || Box::new(G108::default())),
    (109, || Box::new(G109::default())),
    (110, || Box::new(G110::default())),
    (111, || Box::new(G111::default())),
    (112, || Box::new(G112::default())),
    (113, || Box::new(G113::default())),
    (114, || Box::new(G114::default())),
    (115, || Box::new(G115::default())),
    (116, || Box::new(G116::default())),
    (117, || Box::new(G117::default())),
];

cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G100 in "played/rules/100.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G101 in "played/rules/101.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G102 in "played/rules/102.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G103 in "played/rules/103.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G104 in "played/rules/104.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G105 in "played/rules/105.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G106 in "played/rules/106.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G107 in "played/rules/107.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G108 in "played/rules/108.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G109 in "played/rules/109.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G110 in "played/rules/110.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G111 in "played/rules/111.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G112 in "played/rules/112.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G113 in "played/rules/113.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G114 in "played/rules/114.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G115 in "played/rules/115.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G116 in "played/rules/116.cga"; }
cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G117 in "played/rules/117.cga"; }
