//! The linker: joins files into one program. Imports and styles are resolved before any check.
//!
//! Each file is parsed once. An *instance* is one file with one style in force at one import site. Instances share the
//! tokens and the tree of their file; side tables are keyed by the instance and the name. Two imports of one file share no
//! values, as CGA documents; styles are merged after lowering (`lower/merge.rs`).

mod asset;
mod instantiate;
mod overrides;
mod paths;
mod style;
#[cfg(test)]
pub(crate) mod tests;

use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::dialect::Dialect;
use crate::span::Span;
use crate::suggest::nearest;
use crate::syntax::ast::{Ast, DEFAULT, Import, Name, Override};
use crate::syntax::parse::parse_part;
use crate::syntax::token::Tokens;
use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;

pub use asset::Asset;
pub(crate) use asset::Assets;
pub(crate) use instantiate::{Instantiations, Types, Wanted};
pub use paths::{candidates, folder, normal, stray_character};
pub(crate) use style::Styles;

/// The maximum number of instances in a program. Files that import each other twice on each level would create
/// millions.
const MOST_INSTANCES: usize = 1000;

/// The maximum number of declarations in all instances. Each declaration is checked and lowered once per instance.
const MOST_DECLARATIONS: usize = 250_000;

/// The number of tokens of a program after which it imports no more files. Checks take some 300 bytes for each.
const MOST_TOKENS: usize = 2_000_000;

/// The maximum depth of nested imports.
const MOST_NESTED: usize = 64;

/// A rule file as tokens.
#[derive(Clone, Debug)]
pub struct Unit {
    /// The name in messages. Units with the same name are one file.
    pub name: String,
    /// The tokens of the file.
    pub tokens: Tokens,
    /// The dialect of the file.
    pub dialect: Dialect,
    /// The diagnostics of the source that made the tokens.
    pub found: Vec<Diag>,
}

impl Unit {
    /// Creates a unit without a name and without diagnostics.
    pub fn new(tokens: Tokens, dialect: Dialect) -> Unit {
        Unit { name: String::new(), tokens, dialect, found: Vec::new() }
    }
}

/// The provider of imported files.
pub trait Files {
    /// Opens the file for a path written in the file `from`.
    ///
    /// # Errors
    /// Returns the reason if the file cannot be opened. The message continues after "cannot import `path`: ".
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String>;

    /// The names of the files in the folder of a path written in the file `from`. They are candidates for a
    /// suggestion if the path does not exist.
    fn beside(&mut self, _path: &str, _from: &str) -> Vec<String> {
        Vec::new()
    }

    /// The known properties of a file that rules name: a mesh, an image, a table. The path is relative to the asset
    /// folder, for which the package is used. Returns `None` if nothing is known.
    fn asset(&mut self, _path: &str) -> Option<Asset> {
        None
    }
}

/// A provider without files.
#[derive(Clone, Copy, Debug)]
pub struct NoFiles;

impl Files for NoFiles {
    fn open(&mut self, _: &str, _: &str) -> Result<Unit, String> {
        Err("there is no folder to look for it in".into())
    }
}

/// A file that was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileTokens {
    /// The name of its [`Unit`].
    pub name: String,
    /// The range of its tokens, as spans count them. The tokens of all files follow each other.
    pub tokens: Range<u32>,
}

/// The number of an instance: an index into [`Program::instances`], or beyond it the number of a declaration that is
/// instantiated for types of its own.
pub(crate) type InstanceId = usize;

/// The key of the side tables: a name, by [`Name::id`], in an instance.
pub(crate) type Key = (InstanceId, u32);

/// All files and instances.
pub(crate) struct Program {
    /// The tokens of all files, in the order of `files`.
    pub(crate) tokens: Tokens,
    /// The files; the compiled file comes first.
    pub(crate) files: Vec<Rc<SourceFile>>,
    /// The instances; the root with its style `Default` comes first.
    pub(crate) instances: Vec<Instance>,
    /// The root's instances by style: `Default`, then the others in source order.
    pub(crate) roots: Vec<InstanceId>,
    /// Declarations that are instantiated for several tuples of types.
    pub(crate) typed: Instantiations,
    pub(crate) assets: Assets,
}

/// A file of rules.
pub(crate) struct SourceFile {
    pub(crate) name: String,
    pub(crate) dialect: Dialect,
    pub(crate) ast: Ast,
    /// The range of its tokens in the program.
    pub(crate) tokens: Range<u32>,
    /// True if a comment or string without an end has swallowed declarations.
    pub(crate) is_torn: bool,
    number: usize,
    /// Dynamic calls with rules: the name of the import, and the overrides.
    calls: Vec<(Name, Vec<Override>)>,
}

impl SourceFile {
    /// The number of declarations and styles: the size of an instance.
    fn declared(&self) -> usize {
        self.ast.decls.len() + self.ast.styles.len()
    }
}

/// A file with the style in force, at one import site.
pub(crate) struct Instance {
    pub(crate) file: Rc<SourceFile>,
    /// The styles of the file, from the one in force to `Default`.
    pub(crate) styles: Styles,
    /// The number of the style of the root that it belongs to.
    pub(crate) root_style: u32,
    /// The names of the imports that lead to its names: `imp.`, empty for the root.
    pub(crate) prefix: String,
    /// The importing instance.
    pub(crate) parent: Option<InstanceId>,
    /// The imported instances by prefix. `None` for a file that could not be read.
    pub(crate) imports: HashMap<String, Option<InstanceId>>,
    /// The overrides of its import, then the overrides of a dynamic call.
    pub(crate) layers: Vec<OverrideLayer>,
    /// The instance for each dynamic call with rules, by the id of the import's name in the call.
    pub(crate) dynamic: HashMap<u32, InstanceId>,
}

/// The overrides of one place.
#[derive(Clone)]
pub(crate) struct OverrideLayer {
    /// The instance that has the overrides and in which their names are looked up.
    pub(crate) home: InstanceId,
    source: LayerSource,
}

/// The number of the overrides in the file that has them.
#[derive(Clone, Copy)]
enum LayerSource {
    Import(usize),
    Call(usize),
}

/// Reads all files of a program.
pub(crate) fn link(root: Unit, files: &mut dyn Files, diags: &mut Diags) -> Program {
    let mut link = Link {
        files,
        diags,
        by_name: HashMap::new(),
        under_way: Vec::new(),
        declared: 0,
        full: false,
        program: Program {
            tokens: Tokens::new(),
            files: Vec::new(),
            instances: Vec::new(),
            roots: Vec::new(),
            typed: Instantiations::default(),
            assets: Assets::default(),
        },
    };
    let file = link.file(root);
    let first = link.instance(&file, 0, String::new(), None, Vec::new());
    link.program.roots.push(first);
    for (number, style) in (1..).zip(&file.ast.styles) {
        if link.full_up(&file, style.name.span) {
            break;
        }
        let root = link.instance(&file, number, String::new(), None, Vec::new());
        link.program.roots.push(root);
    }
    link.program.assets = Assets::new(&link.program, link.files);
    link.program
}

impl Program {
    /// Returns true if the compiled file can be imported by other files.
    pub(crate) fn may_be_imported(&self) -> bool {
        self.files.first().is_some_and(|file| !file.name.is_empty())
    }

    /// The number of declarations in all instances.
    pub(crate) fn declarations(&self) -> usize {
        self.instances.iter().map(|instance| instance.file.ast.decls.len()).sum()
    }

    /// The overrides of a layer. With `None`, none are written, and attributes of the same name flow in.
    pub(crate) fn overrides(&self, layer: &OverrideLayer) -> Option<&[Override]> {
        let file = &self.instances[layer.home].file;
        match layer.source {
            LayerSource::Import(at) => file.ast.imports[at].overrides.as_deref(),
            LayerSource::Call(at) => Some(&file.calls[at].1),
        }
    }

    /// The folder of the file that has the token, by the name of the file.
    pub(crate) fn folder(&self, token: u32) -> &str {
        self.file(token).map_or("", |file| folder_of(&file.name))
    }

    /// The known properties of a file named in the file of a token. `None` for a missing file whose existence the
    /// rules test.
    pub(crate) fn asset(&self, name: &str, token: u32) -> Option<&Asset> {
        self.assets.of(name, self.folder(token))
    }

    /// The file of a token.
    fn file(&self, token: u32) -> Option<&SourceFile> {
        let after = self.files.partition_point(|file| file.tokens.start <= token);
        after.checked_sub(1).map(|at| &*self.files[at])
    }

    /// The dialect of the file of a token.
    pub(crate) fn dialect(&self, token: u32) -> Dialect {
        self.file(token).map_or(Dialect::Text, |file| file.dialect)
    }
}

/// The folder of a file.
fn folder_of(name: &str) -> &str {
    name.rsplit_once('/').map_or("", |(folder, _)| folder)
}

struct Link<'l> {
    files: &'l mut dyn Files,
    diags: &'l mut Diags,
    by_name: HashMap<String, usize>,
    /// The numbers of files that are being imported, outermost first.
    under_way: Vec<usize>,
    /// The number of declarations in all instances.
    declared: usize,
    /// True if the limit of instances was reported.
    full: bool,
    program: Program,
}

impl Link<'_> {
    /// The file of a unit. It is parsed at its first use.
    fn file(&mut self, unit: Unit) -> Rc<SourceFile> {
        if let Some(&number) = self.by_name.get(&unit.name) {
            return Rc::clone(&self.program.files[number]);
        }
        let Unit { name, tokens, dialect, found } = unit;
        let start = self.program.tokens.len() as u32;
        self.program.tokens.append(tokens);
        let tokens = start..self.program.tokens.len() as u32;
        // Such a token has swallowed the declarations after it.
        let is_torn = found.iter().any(|diag| matches!(diag.code, Code::UnclosedComment | Code::UnclosedString));
        self.diags.append(found.into_iter().map(|diag| diag.moved(|span| span.behind(start))).collect());
        let ast = parse_part(&self.program.tokens, tokens.clone(), self.diags);
        let (number, calls) = (self.program.files.len(), overrides::dynamic_calls(&ast));
        self.by_name.insert(name.clone(), number);
        let file = Rc::new(SourceFile { name, dialect, ast, tokens, is_torn, number, calls });
        self.program.files.push(Rc::clone(&file));
        file
    }

    /// Instantiates a file with the style in force, and its imports.
    fn instance(
        &mut self,
        file: &Rc<SourceFile>,
        style: u32,
        prefix: String,
        parent: Option<InstanceId>,
        layers: Vec<OverrideLayer>,
    ) -> InstanceId {
        self.under_way.push(file.number);
        let id = self.program.instances.len();
        self.declared += file.declared();
        let styles = Styles::new(&file.ast, style, self.diags);
        let root_style = parent.map_or(style, |parent| self.program.instances[parent].root_style);
        self.program.instances.push(Instance {
            file: Rc::clone(file),
            styles,
            root_style,
            prefix,
            parent,
            imports: HashMap::new(),
            layers,
            dynamic: HashMap::new(),
        });
        for (at, import) in file.ast.imports.iter().enumerate() {
            let own = self.import(id, at, import);
            let name = import.id.text.clone();
            if self.program.instances[id].imports.contains_key(&name) {
                let message = format!("import `{name}` is declared twice");
                self.diags.report(Code::DuplicateName, import.id.span, message);
                continue;
            }
            self.program.instances[id].imports.insert(name, own);
        }
        for (at, (import, _)) in file.calls.iter().enumerate() {
            let Some(&Some(target)) = self.program.instances[id].imports.get(&import.text) else { continue };
            let target = &self.program.instances[target];
            let (file, style) = (Rc::clone(&target.file), target.styles.in_force());
            let (mut layers, prefix) = (target.layers.clone(), target.prefix.clone());
            if self.full_up(&file, import.span) {
                break;
            }
            layers.push(OverrideLayer { home: id, source: LayerSource::Call(at) });
            let own = self.instance(&file, style, prefix, Some(id), layers);
            self.program.instances[id].dynamic.insert(import.id(), own);
        }
        self.under_way.pop();
        id
    }

    /// Returns true if a limit is reached, which is reported once.
    fn full_up(&mut self, file: &SourceFile, span: Span) -> bool {
        const AGAIN: (&str, &str) = (
            "a file counts once for each place and style it is used in",
            "use fewer styles, or import files that have styles fewer times",
        );
        const LONG: (&str, &str) = ("each word, number and sign is a token", "divide the rules into several grammars");
        let (full, (note, help)) = if MOST_INSTANCES <= self.program.instances.len() {
            (format!("more than {MOST_INSTANCES} files"), AGAIN)
        } else if MOST_TOKENS < self.program.tokens.len() {
            (format!("more than {MOST_TOKENS} tokens in all files"), LONG)
        } else if MOST_NESTED <= self.under_way.len() {
            self.diags.report(Code::CannotImport, span, format!("imports are nested more than {MOST_NESTED} deep"));
            return true;
        } else if MOST_DECLARATIONS < self.declared + file.declared() {
            let message =
                format!("styles and imports multiply these rules to more than {MOST_DECLARATIONS} declarations");
            (message, AGAIN)
        } else {
            return false;
        };
        if !self.full {
            self.full = true;
            let diag = self.diags.report(Code::CannotImport, span, full);
            diag.note(note);
            diag.help(help);
        }
        true
    }

    /// The number of a style that an import names.
    fn wanted_style(&mut self, file: &SourceFile, name: &Name) -> u32 {
        let names = || file.ast.styles.iter().map(|style| style.name.text.as_str());
        match names().position(|own| own == name.text) {
            Some(index) => index as u32 + 1,
            None if name.text == DEFAULT => 0,
            None => {
                let message = format!("`{}` has no style `{}`", file.name, name.text);
                self.diags.report(Code::UnknownStyle, name.span, message).suggest(nearest(&name.text, names()));
                0
            }
        }
    }

    fn import(&mut self, from: InstanceId, at: usize, import: &Import) -> Option<InstanceId> {
        // No file is opened without use.
        if self.full {
            return None;
        }
        let own = &self.program.instances[from];
        let prefix = format!("{}{}.", own.prefix, import.id.text);
        let file = Rc::clone(&own.file);
        // *CGA changelog 2023.0*. No file is read under another extension.
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
        let opened = match self.files.open(&import.path, &file.name) {
            Ok(unit) => self.file(unit),
            Err(why) => {
                let message = format!("cannot import `{}`: {why}", import.path);
                let mut names = self.files.beside(&import.path, &file.name);
                // The order of a folder listing is undefined.
                names.sort();
                let near = paths::like(&import.path, &names);
                self.diags.report(Code::CannotImport, import.path_span, message).suggest(near);
                return None;
            }
        };
        if let Some(first) = self.under_way.iter().position(|&file| file == opened.number) {
            let names = self.under_way[first..].iter().map(|&file| self.program.files[file].name.as_str());
            let way: Vec<&str> = names.collect();
            let message = format!("`{}` imports itself: {} → {0}", opened.name, way.join(" → "));
            self.diags.report(Code::CannotImport, import.path_span, message);
            return None;
        }
        if self.full_up(&opened, import.id.span) {
            return None;
        }
        let layer = OverrideLayer { home: from, source: LayerSource::Import(at) };
        // The first style is in force; a host program may choose among the others.
        let mut wanted =
            import.styles.iter().flatten().map(|name| self.wanted_style(&opened, name)).collect::<Vec<_>>();
        let style = if wanted.is_empty() { 0 } else { wanted.swap_remove(0) };
        Some(self.instance(&opened, style, prefix, Some(from), vec![layer]))
    }
}
