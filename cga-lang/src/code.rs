//! Every kind of finding: its name, its usual level and what it means.

/// How bad a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Not shown.
    Allow,
    /// The rules have a meaning, though hardly the one that was meant.
    Warning,
    /// The rules have no meaning.
    Error,
}

macro_rules! codes {
    ($($name:ident $text:literal $level:ident $about:literal,)*) => {
        /// A kind of finding.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code { $(#[doc = $about] $name,)* }

        impl Code {
            /// Every code.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];

            /// As written in `@Allow(…)` and in the documentation.
            pub const fn name(self) -> &'static str {
                match self { $(Code::$name => $text,)* }
            }

            /// Its level where nothing else is said.
            pub const fn level(self) -> Level {
                match self { $(Code::$name => Level::$level,)* }
            }

            /// What it means, in a line.
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
    BadNumber "bad_number" Error "A number that cannot be read.",
    BadEscape "bad_escape" Warning "A backslash in a string before a character it does not go with.",
    // Reading tokens.
    Syntax "syntax" Error "Something else was expected here.",
    UnclosedBracket "unclosed_bracket" Error "An opening bracket that is never closed.",
    TooDeep "too_deep" Error "Brackets, branches or operators nested too deeply.",
    MissingElse "missing_else" Error "A `case` or a percentage block without `else`.",
    MixedBranches "mixed_branches" Error "Conditions and percentages in one block.",
    BranchNotFirst "branch_not_first" Error "A `case` or percentage block after other operations.",
    MissingSize "missing_size" Error "A slot of a split without a size.",
    EmptyGroup "empty_group" Error "A split, a group or a comp with nothing in it.",
    MisplacedPrefix "misplaced_prefix" Error "`'` or `~` where no size stands.",
    StrayQuote "stray_quote" Warning "A `'` behind a size.",
    NotImplemented "not_implemented" Warning "A part of CGA that is known and does nothing yet.",
    OldSpelling "old_spelling" Warning "Something that is accepted though newer CGA writes it in another way.",
    CannotImport "cannot_import" Error "A file that cannot be imported.",
    UnknownStyle "unknown_style" Error "A style that does not exist.",
    // Declarations.
    DuplicateName "duplicate_name" Error "Two declarations of one name.",
    BadAnnotation "bad_annotation" Error "An annotation with arguments it cannot have.",
    StrayDefault "stray_default" Warning "A default that is not among the values to which its attribute is restricted.",
    UnknownAnnotation "unknown_annotation" Warning "An annotation that is not one of CGA's.",
    UnknownCode "unknown_code" Warning "`@Allow`, `@Warn` or `@Deny` of a finding that does not exist.",
    NoStartRule "no_start_rule" Warning "No rule without parameters to begin with.",
    // Names.
    UndefinedRule "undefined_rule" Warning "A call that matches no rule by name and number of arguments.",
    NotAnOperation "not_an_operation" Error "A function where an operation or a rule must stand.",
    UnknownName "unknown_name" Error "A name that is not declared.",
    UnknownFunction "unknown_function" Error "A function that is not declared.",
    UnknownAxis "unknown_axis" Error "An axis a split does not have.",
    UnknownSelector "unknown_selector" Error "A component selector that does not exist.",
    UnknownWord "unknown_word" Error "A word an operation does not know in that place.",
    NotSettable "not_settable" Error "`set` on something that cannot be set.",
    // Arguments and types.
    ArgumentCount "argument_count" Error "An operation or function with the wrong number of arguments.",
    TypeMismatch "type_mismatch" Error "A value of the wrong type.",
    OutOfRange "out_of_range" Error "An argument outside the values that CGA documents.",
    // Sizes.
    SizeNotPositive "size_not_positive" Warning "A slot whose size is never positive.",
    SlotNeverMade "slot_never_made" Warning "A slot for which the sizes before it never leave room.",
    FloatWithoutSpace "float_without_space" Warning "A floating slot for which the other sizes never leave room.",
    SlotAlwaysCut "slot_always_cut" Warning "A slot that always reaches beyond the end of the scope.",
    SharesBeyondWhole "shares_beyond_whole" Warning "Relative sizes that add up to more than the whole.",
    SizesBeyondExtent "sizes_beyond_extent" Warning "Sizes that add up to more than the extent, which is known.",
    GapLeft "gap_left" Warning "Sizes that leave a gap thinner than any slot.",
    FlatSplit "flat_split" Warning "A split along an axis without an extent.",
    // Repeats.
    RepeatNoProgress "repeat_no_progress" Error "A repeat in which no size is positive.",
    TooManyPieces "too_many_pieces" Warning "A repeat that makes more pieces than a run may make.",
    RepeatOnce "repeat_once" Warning "A repeat that always happens once.",
    RepeatSliver "repeat_sliver" Warning "A repeat of relative sizes that ends with a sliver.",
    // Flow.
    CaseAlways "case_always" Warning "A condition that is always true or always false.",
    RuleNotReached "rule_not_reached" Warning "A rule that no run gets to.",
    EndlessRules "endless_rules" Error "Rules that call themselves on every path.",
    OnlyChanceEnds "only_chance_ends" Warning "Rules that call themselves until chance ends it.",
    SelectorHidden "selector_hidden" Warning "A selector that never finds anything: earlier ones leave nothing, or no component has that number.",
    NoEffect "no_effect" Warning "Operations on a shape of which nothing is made after them.",
    // What is declared.
    UnusedAttribute "unused_attribute" Warning "An attribute that nothing reads.",
    UnusedConstant "unused_constant" Warning "A constant that nothing reads.",
    UnusedParameter "unused_parameter" Warning "A parameter or local value that nothing reads.",
    UnusedImport "unused_import" Warning "An import that nothing names.",
    Shadowing "shadowing" Warning "A parameter or local value that hides something of the grammar, or that a selector hides.",
    // Geometry.
    NotAColor "not_a_color" Error "Text where a colour must stand, or a part of a colour, that is none.",
    UnknownUvSet "unknown_uv_set" Error "A uv set that does not exist.",
    SplitWithoutUv "split_without_uv" Warning "A split in texture space before there are texture coordinates.",
    MissingUvSet "missing_uv_set" Warning "Texture coordinates of a set that the shape does not have.",
    TextureWithoutUv "texture_without_uv" Warning "A texture on a shape that has no texture coordinates.",
    MissingAsset "missing_asset" Warning "A file that the package does not have, or an asset without faces.",
    UnknownGroup "unknown_group" Warning "A group or material that an asset does not have.",
    DivisionByZero "division_by_zero" Warning "A division by what is always zero.",
    // Values.
    PercentOver100 "percent_over_100" Error "Percentages that add up to more than 100.",
    InitCycle "init_cycle" Error "Attributes and constants that need each other on every path.",
    EndlessFunction "endless_function" Error "A function that calls itself on every path.",
}

impl Code {
    /// The code of that name.
    pub fn from_name(name: &str) -> Option<Code> {
        Code::ALL.iter().copied().find(|code| code.name() == name)
    }

    /// Whether it is an error though rules with it could run: to a limit, or with a fault.
    const fn is_wrong_in_runs(self) -> bool {
        matches!(
            self,
            Code::RepeatNoProgress | Code::EndlessRules | Code::UnknownUvSet | Code::NotAColor | Code::OutOfRange
        )
    }

    /// Whether `@Allow`, `@Warn` and `@Deny` may change its level: then the rules have a meaning all the same.
    pub fn is_lint(self) -> bool {
        self.level() != Level::Error || self.is_wrong_in_runs()
    }
}
