// The grammars that are played, each with its seed. They are written, not edited.

use crate::host::Make;

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
    (118, || Box::new(G118::default())),
    (119, || Box::new(G119::default())),
    (120, || Box::new(G120::default())),
    (121, || Box::new(G121::default())),
    (122, || Box::new(G122::default())),
    (123, || Box::new(G123::default())),
    (124, || Box::new(G124::default())),
    (125, || Box::new(G125::default())),
    (126, || Box::new(G126::default())),
    (127, || Box::new(G127::default())),
    (128, || Box::new(G128::default())),
    (129, || Box::new(G129::default())),
    (130, || Box::new(G130::default())),
    (131, || Box::new(G131::default())),
];

cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G100 in "rules/100.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G101 in "rules/101.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G102 in "rules/102.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G103 in "rules/103.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G104 in "rules/104.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G105 in "rules/105.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G106 in "rules/106.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G107 in "rules/107.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G108 in "rules/108.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G109 in "rules/109.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G110 in "rules/110.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G111 in "rules/111.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G112 in "rules/112.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G113 in "rules/113.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G114 in "rules/114.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G115 in "rules/115.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G116 in "rules/116.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G117 in "rules/117.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G118 in "rules/118.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G119 in "rules/119.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G120 in "rules/120.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G121 in "rules/121.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G122 in "rules/122.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G123 in "rules/123.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G124 in "rules/124.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G125 in "rules/125.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G126 in "rules/126.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G127 in "rules/127.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G128 in "rules/128.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G129 in "rules/129.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G130 in "rules/130.cga"; }
cga::cga! { @Warn(repeat_no_progress, endless_rules) pub grammar G131 in "rules/131.cga"; }
