//! Files to one program: imports and styles are resolved before anything is checked.
//!
//! An *instance* is one file with one style in force, imported in one place. Each instance has tokens and a tree of its
//! own: the file is read again for it, behind the tokens so far, so that a name is still identified by its token. Two
//! imports of one file share nothing, as CGA wants it; styles are merged after lowering
//! (`lower/merge.rs`).

mod asset;
mod copies;
mod overrides;
mod paths;
mod style;

use crate::ast::{Ast, Import, Name, Override};
use crate::code::Code;
use crate::diag::{Diag, Diags};
use crate::door::Door;
use crate::parse::parse_part;
use crate::span::Span;
use crate::token::Tokens;
use std::collections::HashMap;
use std::ops::Range;

pub use asset::Asset;
pub(crate) use asset::Assets;
pub(crate) use copies::{Copies, Types, Wanted};
pub(crate) use overrides::dynamic_calls;
pub use paths::{candidates, folder, stray_character};
pub(crate) use style::Styles;

/// Most instances a program may have: files that import each other twice, level by level, would become millions.
const MOST_INSTANCES: usize = 1000;

/// Tokens that all instances together may have in any case, whatever the compiled file itself has.
const FEW_TOKENS: usize = 1_000_000;

/// How often the tokens of all files may be read, on average, where that makes more than [`FEW_TOKENS`]: a large file has a
/// dozen styles, and no file is read a thousand times.
const MOST_READINGS: usize = 32;

/// Most tokens that all instances together may have: a token takes about 300 bytes, with its tree and all that is known
/// of it.
const MOST_TOKENS: usize = 8_000_000;

/// How deep imports may be nested.
const MOST_NESTED: usize = 64;

/// A file of rules as tokens.
#[derive(Clone, Debug)]
pub struct Unit {
    /// What messages call it. Units of one name are one file.
    pub name: String,
    /// Its tokens.
    pub tokens: Tokens,
    /// How strict to be with it.
    pub door: Door,
    /// What whoever made the tokens has found.
    pub found: Vec<Diag>,
}

/// Where imported files come from.
pub trait Files {
    /// The file of a path that stands in the file `from`.
    ///
    /// # Errors
    /// Why there is none, as a message goes on after "cannot import `path`: ".
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String>;

    /// The names of the files in the folder to which a path leads that stands in the file `from`: one of them may have
    /// been meant where there is none of that name.
    fn beside(&mut self, _path: &str, _from: &str) -> Vec<String> {
        Vec::new()
    }

    /// What is known of a file that rules name: a mesh, an image, a table. The path is the file's place below the folder of
    /// assets, for which the package stands. `None` where nothing is known.
    fn asset(&mut self, _path: &str) -> Option<Asset> {
        None
    }
}

/// There are no files.
#[derive(Clone, Copy, Debug)]
pub struct NoFiles;

impl Files for NoFiles {
    fn open(&mut self, _: &str, _: &str) -> Result<Unit, String> {
        Err("there is no folder to look for it in".into())
    }
}

/// Where in a program the tokens of a file are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The file, by number. 0 is the one that was compiled.
    pub file: usize,
    /// Its tokens in the program.
    pub tokens: Range<u32>,
    /// Which of the file's tokens is the first of these: 0, but for a declaration that was read again with other types.
    pub from: u32,
}

/// Index into [`Program::instances`].
pub(crate) type InstanceId = usize;

/// Everything that was read.
pub(crate) struct Program {
    pub(crate) tokens: Tokens,
    pub(crate) pieces: Vec<Piece>,
    /// Names of the files.
    pub(crate) files: Vec<String>,
    /// The root with its style `Default` first.
    pub(crate) instances: Vec<Instance>,
    /// The root's instances by style: `Default`, then the others in source order.
    pub(crate) roots: Vec<InstanceId>,
    pub(crate) copies: Copies,
    pub(crate) assets: Assets,
}

/// A file with a style in force, in one place.
pub(crate) struct Instance {
    pub(crate) ast: Ast,
    pub(crate) door: Door,
    /// Its styles, from the one in force to `Default`.
    pub(crate) styles: Styles,
    /// The number of the root's style it belongs to.
    pub(crate) root_style: u32,
    /// What stands before its names: `imp.`, empty for the root.
    pub(crate) prefix: String,
    /// Who imports it.
    pub(crate) parent: Option<InstanceId>,
    /// What it imports. `None` for a file that could not be read.
    pub(crate) imports: HashMap<String, Option<InstanceId>>,
    /// Overrides of its import, then those of a dynamic call.
    pub(crate) layers: Vec<Layer>,
    /// By the token of the import's name in a dynamic call with rules: the instance made for it.
    pub(crate) dynamic: HashMap<u32, InstanceId>,
    /// Whether anything may be declared where it could not be read.
    pub(crate) is_torn: bool,
    file: usize,
}

/// Overrides from one place.
#[derive(Clone)]
pub(crate) struct Layer {
    /// Where they stand, and where their names are looked up.
    pub(crate) home: InstanceId,
    /// `None`: nothing is written, attributes of the same name flow in.
    pub(crate) list: Option<Vec<Override>>,
}

/// Reads all that a file needs.
pub(crate) fn link(root: Unit, files: &mut dyn Files, diags: &mut Diags) -> Program {
    let mut link = Link {
        files,
        diags,
        units: Vec::new(),
        placed: Vec::new(),
        by_name: HashMap::new(),
        under_way: Vec::new(),
        written: 0,
        full: false,
        program: Program {
            tokens: Tokens::new(),
            pieces: Vec::new(),
            files: Vec::new(),
            instances: Vec::new(),
            roots: Vec::new(),
            copies: Copies::default(),
            assets: Assets::default(),
        },
    };
    let file = link.unit(root);
    link.under_way.push(file);
    let origin = Origin { prefix: String::new(), parent: None, layers: Vec::new() };
    let first = link.instance(file, 0, 0, origin.clone());
    link.program.roots.push(first);
    let styles: Vec<Span> = link.program.instances[first].ast.styles.iter().map(|style| style.name.span).collect();
    for (style, span) in (1..).zip(styles) {
        if link.full_up(file, span) {
            break;
        }
        let root = link.instance(file, style, style, origin.clone());
        link.program.roots.push(root);
    }
    link.program.assets = Assets::new(&link.program, link.files);
    link.program
}

impl Program {
    /// Whether what is compiled is a file, which others may import as well.
    pub(crate) fn may_be_imported(&self) -> bool {
        self.files.first().is_some_and(|name| !name.is_empty())
    }

    /// The folder of the file that a token is written in, as the file's name says.
    pub(crate) fn folder(&self, token: u32) -> &str {
        let file = self.pieces.get(self.piece(token)).and_then(|piece| self.files.get(piece.file));
        file.map_or("", |name| folder_of(name))
    }

    /// What is known of a file that is named in the file of a token. One that rules ask for may be missing.
    pub(crate) fn asset(&self, name: &str, token: u32) -> Option<&Asset> {
        self.assets.of(name, self.folder(token))
    }

    /// The number of the piece that has a token.
    fn piece(&self, token: u32) -> usize {
        self.pieces.partition_point(|piece| piece.tokens.start <= token).saturating_sub(1)
    }

    /// How strict to be with a token.
    pub(crate) fn door(&self, token: u32) -> Door {
        let at = self.piece(token);
        self.instances.get(self.copies.instance(token).unwrap_or(at)).map_or(Door::Text, |instance| instance.door)
    }
}

/// The folder of a file.
fn folder_of(name: &str) -> &str {
    name.rsplit_once('/').map_or("", |(folder, _)| folder)
}

/// Where an instance comes from.
#[derive(Clone)]
struct Origin {
    prefix: String,
    parent: Option<InstanceId>,
    layers: Vec<Layer>,
}

struct Link<'l> {
    files: &'l mut dyn Files,
    diags: &'l mut Diags,
    units: Vec<Unit>,
    /// By file: its tokens in the program, if it was read there. Its unit has none any more then.
    placed: Vec<Option<Range<u32>>>,
    by_name: HashMap<String, usize>,
    /// Files that are being imported, outermost first.
    under_way: Vec<usize>,
    /// How many tokens all files have, each read once.
    written: usize,
    /// Whether too many instances were reported.
    full: bool,
    program: Program,
}

impl Link<'_> {
    fn unit(&mut self, unit: Unit) -> usize {
        if let Some(&file) = self.by_name.get(&unit.name) {
            return file;
        }
        let file = self.units.len();
        self.by_name.insert(unit.name.clone(), file);
        self.program.files.push(unit.name.clone());
        self.written += unit.tokens.len();
        self.units.push(unit);
        self.placed.push(None);
        file
    }

    /// Puts the tokens of a file behind those so far.
    fn place(&mut self, file: usize) -> Range<u32> {
        let start = self.program.tokens.len() as u32;
        match &self.placed[file] {
            Some(first) => self.program.tokens.repeat(first.clone()),
            None => self.program.tokens.append(std::mem::take(&mut self.units[file].tokens)),
        }
        let tokens = start..self.program.tokens.len() as u32;
        self.placed[file].get_or_insert(tokens.clone());
        tokens
    }

    /// Reads a file with a style in force, and what it imports.
    fn instance(&mut self, file: usize, style: u32, root_style: u32, origin: Origin) -> InstanceId {
        let id = self.program.instances.len();
        let tokens = self.place(file);
        let unit = &self.units[file];
        let found = unit.found.iter().map(|diag| diag.clone().moved(|span| span.behind(tokens.start)));
        self.diags.append(found.collect());
        // It has swallowed what stands behind it.
        let is_torn = unit.found.iter().any(|diag| matches!(diag.code, Code::UnclosedComment | Code::UnclosedString));
        let ast = parse_part(&self.program.tokens, tokens.clone(), self.diags);
        self.program.pieces.push(Piece { file, tokens, from: 0 });
        let styles = Styles::new(&ast, style, self.diags);
        let imports = ast.imports.clone();
        let calls = dynamic_calls(&ast);
        let Origin { prefix, parent, layers } = origin;
        self.program.instances.push(Instance {
            ast,
            door: unit.door,
            styles,
            root_style,
            prefix,
            parent,
            imports: HashMap::new(),
            layers,
            dynamic: HashMap::new(),
            is_torn,
            file,
        });
        for import in &imports {
            let own = self.import(id, import);
            let name = import.id.text.clone();
            if self.program.instances[id].imports.contains_key(&name) {
                let message = format!("import `{name}` is declared twice");
                self.diags.report(Code::DuplicateName, import.id.span, message);
                continue;
            }
            self.program.instances[id].imports.insert(name, own);
        }
        for (import, overrides) in calls {
            let Some(&Some(target)) = self.program.instances[id].imports.get(&import.text) else { continue };
            if self.full_up(self.program.instances[target].file, import.span) {
                break;
            }
            let target = &self.program.instances[target];
            let (file, style) = (target.file, target.styles.in_force());
            let mut layers = target.layers.clone();
            layers.push(Layer { home: id, list: Some(overrides) });
            let prefix = target.prefix.clone();
            let own = self.under(file, style, root_style, Origin { prefix, parent: Some(id), layers });
            self.program.instances[id].dynamic.insert(import.id(), own);
        }
        id
    }

    fn under(&mut self, file: usize, style: u32, root_style: u32, origin: Origin) -> InstanceId {
        self.under_way.push(file);
        let id = self.instance(file, style, root_style, origin);
        self.under_way.pop();
        id
    }

    /// Whether there is no room for a file, which is said once.
    fn full_up(&mut self, file: usize, span: Span) -> bool {
        let length = self.placed[file].as_ref().map_or(self.units[file].tokens.len(), Range::len);
        let full = if MOST_INSTANCES <= self.program.instances.len() {
            format!("more than {MOST_INSTANCES} files")
        } else if MOST_NESTED <= self.under_way.len() {
            self.diags.report(Code::CannotImport, span, format!("imports are nested more than {MOST_NESTED} deep"));
            return true;
        } else if self.most_tokens() < self.program.tokens.len() + length {
            format!("styles and imports multiply these rules to more than {} tokens", self.most_tokens())
        } else {
            return false;
        };
        if !self.full {
            self.full = true;
            let diag = self.diags.report(Code::CannotImport, span, full);
            diag.note("a file counts once for each place and style it is used in");
            diag.help("use fewer styles, or import files that have styles fewer times");
        }
        true
    }

    /// How many tokens all instances may have: files that are long may have styles, and short ones that import each other
    /// twice, level by level, end early.
    fn most_tokens(&self) -> usize {
        self.written.saturating_mul(MOST_READINGS).clamp(FEW_TOKENS, MOST_TOKENS)
    }

    /// The number of a file's style, or else a name like it.
    fn style(&self, file: usize, name: &str) -> Result<u32, Option<String>> {
        match self.program.instances.iter().find(|instance| instance.file == file) {
            Some(instance) => style::position(&instance.ast, name),
            None => style::number(&self.units[file].tokens, name),
        }
    }

    /// The number of a style that an import names.
    fn wanted_style(&mut self, file: usize, name: &Name) -> u32 {
        // Which number a style has only the tree can tell.
        match self.style(file, &name.text) {
            Ok(style) => style,
            Err(near) => {
                let message = format!("`{}` has no style `{}`", self.units[file].name, name.text);
                self.diags.report(Code::UnknownStyle, name.span, message).suggest(near);
                0
            }
        }
    }

    fn import(&mut self, from: InstanceId, import: &Import) -> Option<InstanceId> {
        // Nobody opens files for nothing.
        if self.full {
            return None;
        }
        let (root_style, prefix, file) = {
            let own = &self.program.instances[from];
            (own.root_style, format!("{}{}.", own.prefix, import.id.text), own.file)
        };
        let from_name = self.units[file].name.clone();
        // *CGA changelog 2023.0*; and nobody reads other files this way.
        if !import.path.ends_with(".cga") {
            let message = format!("cannot import `{}`: only files that end in `.cga` can be imported", import.path);
            let diag = self.diags.report(Code::CannotImport, import.path_span, message);
            if !import.path.rsplit('/').next().unwrap_or_default().contains('.') {
                diag.help(format!("write `\"{}.cga\"`", import.path));
            }
            return None;
        }
        if let Some(stray) = stray_character(&import.path) {
            let message = format!("cannot import `{}`: the name of a rule file has no `{stray}`", import.path);
            self.diags.report(Code::CannotImport, import.path_span, message).help("rename the file");
            return None;
        }
        let opened = match self.files.open(&import.path, &from_name) {
            Ok(unit) => self.unit(unit),
            Err(why) => {
                let message = format!("cannot import `{}`: {why}", import.path);
                let mut names = self.files.beside(&import.path, &from_name);
                // A folder has no order of its own.
                names.sort();
                let near = paths::like(&import.path, &names);
                self.diags.report(Code::CannotImport, import.path_span, message).suggest(near);
                return None;
            }
        };
        if let Some(at) = self.under_way.iter().position(|&file| file == opened) {
            let way: Vec<&str> = self.under_way[at..].iter().map(|&file| self.units[file].name.as_str()).collect();
            let message = format!("`{}` imports itself: {} → {0}", self.units[opened].name, way.join(" → "));
            self.diags.report(Code::CannotImport, import.path_span, message);
            return None;
        }
        if self.full_up(opened, import.id.span) {
            return None;
        }
        let layer = Layer { home: from, list: import.overrides.clone() };
        let origin = Origin { prefix, parent: Some(from), layers: vec![layer] };
        // The first is in force; the others are for whoever chooses among them.
        let mut wanted = import.styles.iter().flatten().map(|name| self.wanted_style(opened, name)).collect::<Vec<_>>();
        let style = if wanted.is_empty() { 0 } else { wanted.swap_remove(0) };
        Some(self.under(opened, style, root_style, origin))
    }
}
