//! The equivalent of `fuzz/fuzz_targets/obj.rs` for a stable compiler: files with a few changed bytes, and files made
//! of the format's words.

const FILE: &str = "\u{feff}# a square with all there is\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n\
    o one\ng a b\ns 1\nusemtl brick\nf 1/1/1 2/2/1 3/1/1 4/2/1\nf -1 -2 \\\n-3\nl 1 2 3\np 4\nnewmtl brick\nKd 1 0.5 0\nmap_Kd a.png\n";

const WORDS: [&str; 40] = [
    "v",
    "vt",
    "vn",
    "f",
    "l",
    "p",
    "g",
    "o",
    "s",
    "usemtl",
    "mtllib",
    "newmtl",
    "Kd",
    "map_Kd",
    "#",
    "\\\n",
    "\n",
    "\n",
    "\n",
    "\r\n",
    "0",
    "1",
    "2",
    "3",
    "-1",
    "-2",
    "4294967295",
    "99999999999999999999",
    "1e308",
    "-1e308",
    "1e-320",
    "nan",
    "inf",
    "0.5",
    "1//1",
    "1/1",
    "2/2/2",
    "//",
    "1/",
    "é",
];

struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit
    }
}

#[test]
fn changed_bytes_do_no_harm() {
    let mut random = Random(1);
    for _ in 0..5_000 {
        let mut bytes = FILE.as_bytes().to_vec();
        for _ in 0..1 + random.below(6) {
            let at = random.below(bytes.len());
            match random.below(3) {
                0 => bytes[at] = b"0123456789-/.e\\\n #vfnt\xff"[random.below(23)],
                1 => drop(bytes.remove(at)),
                _ => bytes.insert(at, random.below(256) as u8),
            }
        }
        crate::obj_support::check(&bytes);
    }
}

#[test]
fn words_in_any_order_do_no_harm() {
    let mut random = Random(2);
    for _ in 0..5_000 {
        let mut text = String::from("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\n");
        for _ in 0..random.below(60) {
            text.push_str(WORDS[random.below(WORDS.len())]);
            text.push(' ');
        }
        crate::obj_support::check(text.as_bytes());
    }
}
