//! The kinds of diagnostics: name, default level, meaning.

/// The level of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Not shown.
    Allow,
    /// The rules have a meaning, but probably not the intended one.
    Warning,
    /// The rules have no meaning.
    Error,
}

macro_rules! codes {
    ($($name:ident $text:literal $level:ident $about:literal,)*) => {
        /// A kind of diagnostic.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code { $(#[doc = $about] $name,)* }

        impl Code {
            /// All codes.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];

            /// The name in `@Allow(…)` and in the documentation.
            pub const fn name(self) -> &'static str {
                match self { $(Code::$name => $text,)* }
            }

            /// The default level.
            pub const fn level(self) -> Level {
                match self { $(Code::$name => Level::$level,)* }
            }

            /// The meaning, in one line.
            pub const fn about(self) -> &'static str {
                match self { $(Code::$name => $about,)* }
            }
        }
    };
}

codes! {
    // Reading characters.
    UnknownCharacter "unknown_character" Error "A character that means nothing in CGA.",
    UnclosedString "unclosed_string" Error "A string without its closing quote.",
    UnclosedComment "unclosed_comment" Error "A `/*` without its `*/`.",
    BadNumber "bad_number" Error "A number that cannot be parsed.",
    BadEscape "bad_escape" Warning "An unknown escape sequence in a string.",
    // Reading tokens.
    Syntax "syntax" Error "A syntax error: another token was expected.",
    UnclosedBracket "unclosed_bracket" Error "An opening bracket that is never closed.",
    TooDeep "too_deep" Error "Brackets, branches or operators nested too deeply.",
    MissingElse "missing_else" Error "A `case` or percentage block without `else`.",
    MixedBranches "mixed_branches" Error "Conditions and percentages in one block.",
    BranchNotFirst "branch_not_first" Error "A `case` or percentage block after other operations.",
    MissingSize "missing_size" Error "A slot of a split without a size.",
    EmptyGroup "empty_group" Error "A split, a group or a comp with nothing in it.",
    MisplacedPrefix "misplaced_prefix" Error "`'` or `~` before something other than a size.",
    StrayQuote "stray_quote" Warning "A `'` after a size.",
    OldSpelling "old_spelling" Warning "A deprecated spelling of CGA.",
    CannotImport "cannot_import" Error "A file that cannot be imported.",
    UnknownStyle "unknown_style" Error "A style that does not exist.",
    // Declarations.
    DuplicateName "duplicate_name" Error "Two declarations of one name.",
    BadAnnotation "bad_annotation" Error "An annotation with arguments it cannot have.",
    StrayDefault "stray_default" Warning "A default outside the values to which the attribute is restricted.",
    UnknownAnnotation "unknown_annotation" Warning "An unknown annotation.",
    UnknownCode "unknown_code" Warning "`@Allow`, `@Warn` or `@Deny` with an unknown diagnostic.",
    NoStartRule "no_start_rule" Warning "No rule without parameters that a run could begin with.",
    UnmarkedStart "unmarked_start" Warning "Runs begin with the first rule, as none is marked, and it is a part of a later one.",
    // Names.
    UndefinedRule "undefined_rule" Warning "A call that matches no rule by name and number of arguments.",
    NotAnOperation "not_an_operation" Error "A function in the place of an operation or a rule.",
    UnknownName "unknown_name" Error "A name that is not declared.",
    UnknownFunction "unknown_function" Error "A function that is not declared.",
    UnknownAxis "unknown_axis" Error "An unknown axis of a split.",
    UnknownSelector "unknown_selector" Error "An unknown component selector.",
    UnknownWord "unknown_word" Error "An unknown keyword as an argument.",
    ComputedWord "computed_word" Error "A word that is computed, where the compiler must know it.",
    NotSettable "not_settable" Error "`set` of a name that cannot be set.",
    // Arguments and types.
    ArgumentCount "argument_count" Error "An operation or function with the wrong number of arguments.",
    TypeMismatch "type_mismatch" Error "A value of the wrong type.",
    OutOfRange "out_of_range" Error "An argument outside the values that CGA documents.",
    // Sizes.
    SizeNotPositive "size_not_positive" Warning "A slot whose size, or a section whose depth, is never positive.",
    SlotNeverMade "slot_never_made" Warning "A slot for which earlier sizes never leave room.",
    FloatWithoutSpace "float_without_space" Warning "A floating slot for which the other sizes never leave room.",
    SlotAlwaysCut "slot_always_cut" Warning "A slot that always reaches beyond the end of the scope.",
    SharesBeyondWhole "shares_beyond_whole" Warning "Relative sizes with a sum above 1.",
    SizesBeyondExtent "sizes_beyond_extent" Warning "Sizes with a sum above the known extent.",
    GapLeft "gap_left" Warning "Sizes that leave a gap thinner than any slot.",
    FlatSplit "flat_split" Warning "A split along an axis without an extent.",
    // Repeats.
    RepeatNoProgress "repeat_no_progress" Error "A repeat in which no size is positive.",
    TooManyPieces "too_many_pieces" Warning "A repeat with more pieces than a run may make.",
    RepeatOnce "repeat_once" Warning "A repeat with exactly one repetition in every run.",
    RepeatSliver "repeat_sliver" Warning "A repeat of relative sizes that ends with a sliver.",
    // Flow.
    CaseAlways "case_always" Warning "A condition that is always true or always false.",
    RuleNotReached "rule_not_reached" Warning "A rule that no run can reach.",
    EndlessRules "endless_rules" Error "Recursive rules without a path that ends.",
    OnlyChanceEnds "only_chance_ends" Warning "Recursive rules that only chance ends.",
    SelectorHidden "selector_hidden" Warning "A selector that never matches: earlier selectors take all components, none has that index, none faces that way, or its directions exclude each other.",
    NoEffect "no_effect" Warning "Operations whose result is never used, or setbacks of no edge.",
    NoFaces "no_faces" Warning "An operation on faces or edges of a point.",
    EmptyOperand "empty_operand" Warning "An operand of a boolean operation that never makes a shape.",
    // Declarations without a use.
    UnusedAttribute "unused_attribute" Warning "An attribute that is never read.",
    UnusedConstant "unused_constant" Warning "A constant that is never read.",
    UnusedParameter "unused_parameter" Warning "A parameter or local value that is never read.",
    UnusedImport "unused_import" Warning "An import that is never used.",
    Shadowing "shadowing" Warning "A parameter or local value that shadows another name, or that a selector shadows.",
    // Geometry.
    NotAColor "not_a_color" Error "An invalid colour, or a colour channel out of range.",
    UnknownUvSet "unknown_uv_set" Error "An unknown uv set.",
    SplitWithoutUv "split_without_uv" Warning "A split in texture space before there are texture coordinates.",
    MissingUvSet "missing_uv_set" Warning "Texture coordinates of a set that the shape does not have.",
    TextureWithoutUv "texture_without_uv" Warning "A texture on a shape without texture coordinates.",
    MissingAsset "missing_asset" Warning "A file that is missing from the package, or an asset without faces.",
    UnknownTag "unknown_tag" Warning "A query for a tag that no operation gives.",
    UnknownLabel "unknown_label" Warning "A query for a label that no rule leaves.",
    LostLabel "lost_label" Warning "A label below an operation with operands, where no query finds it.",
    IdleQuery "idle_query" Warning "A query of an attribute or constant that finds no shape.",
    UnknownGroup "unknown_group" Warning "A group or material that is missing from an asset.",
    DivisionByZero "division_by_zero" Warning "A division by zero in every run.",
    // Values.
    PercentOver100 "percent_over_100" Error "Percentages that add up to more than 100.",
    InitCycle "init_cycle" Error "Attributes and constants that depend on each other on every path.",
    EndlessFunction "endless_function" Error "A recursive function without a path that ends.",
}

impl Code {
    /// The code with a name.
    pub fn from_name(name: &str) -> Option<Code> {
        Code::ALL.iter().copied().find(|code| code.name() == name)
    }

    /// Returns true if `@Allow`, `@Warn` and `@Deny` may change the level, because the rules have a meaning.
    pub fn is_lint(self) -> bool {
        use Code::{EndlessRules, NotAColor, OutOfRange, RepeatNoProgress, UnknownUvSet};
        // These are errors in rules that could still run, up to a limit or with a fault.
        let runs = matches!(self, RepeatNoProgress | EndlessRules | UnknownUvSet | NotAColor | OutOfRange);
        runs || self.level() != Level::Error
    }
}
