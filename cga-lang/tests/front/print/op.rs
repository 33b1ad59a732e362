//! Steps of rules.

use super::{Printer, Spelling};
use cga_lang::syntax::ast::{Arg, Arm, ArmMode, Block, BlockPart, Name, Op, OpKind, Percent, Prefix, SplitItem};

impl Printer<'_> {
    pub(super) fn ops(&mut self, ops: &[Op]) {
        for op in ops {
            self.word(" ");
            self.op(op);
        }
    }

    fn op(&mut self, op: &Op) {
        match &op.kind {
            OpKind::Call(name, args) => self.call(name, args),
            OpKind::Leaf(name) => {
                self.word(&name.text);
                // After the prefix of an import a name would go on; arguments, which do nothing, keep them apart.
                self.word(if self.imports.contains(&&*name.text) { ".()" } else { "." });
            }
            OpKind::Nil => self.word("NIL"),
            OpKind::Path(name, args) => {
                self.word(&name.text);
                self.args(args);
            }
            OpKind::Push(ops) => {
                self.word("[");
                self.ops(ops);
                self.word(" ]");
            }
            OpKind::Case(arms, otherwise) => {
                for (condition, ops) in arms {
                    self.word("case ");
                    self.expr(condition);
                    self.word(" :");
                    self.ops(ops);
                    self.word(" ");
                }
                self.word("else :");
                self.ops(otherwise);
            }
            OpKind::Chance(arms, otherwise) => {
                for (percent, ops) in arms {
                    self.percent(percent);
                    self.ops(ops);
                    self.word(" ");
                }
                self.word("else :");
                self.ops(otherwise);
            }
            OpKind::Dynamic { import, overrides, rule, args } => {
                self.word(&import.text);
                self.overrides(overrides);
                self.word(".");
                self.call(rule, args);
            }
            OpKind::Block(block) => self.block(block),
            OpKind::Error => self.word("ERROR"),
        }
    }

    pub(super) fn percent(&mut self, percent: &Percent) {
        self.word(&percent.value.to_string());
        self.word("% :");
    }

    fn call(&mut self, name: &Name, args: &[Arg]) {
        self.word(&name.text);
        // Such a word and the name of the next rule would be a declaration.
        let keyword = matches!(&*name.text, "start" | "extension" | "style" | "import" | "attr" | "const");
        if !args.is_empty() || keyword {
            self.args(args);
        }
    }

    fn args(&mut self, args: &[Arg]) {
        self.word("(");
        self.list(args, ", ", Self::arg);
        self.word(")");
    }

    fn arg(&mut self, arg: &Arg) {
        match (arg.prefix, self.spelling) {
            (Some((Prefix::Relative, _)), Spelling::Text) => self.word("'"),
            (Some((Prefix::Relative, _)), Spelling::Inline) => self.word("^"),
            (Some((Prefix::Floating, _)), _) => self.word("~"),
            (None, _) => {}
        }
        self.expr(&arg.value);
    }

    fn items(&mut self, items: &[SplitItem], repeat: bool) {
        self.word("{ ");
        self.list(items, " | ", |own, item| match item {
            SplitItem::Slot(size, ops) => {
                own.arg(size);
                own.word(" :");
                own.ops(ops);
            }
            SplitItem::Group(items, repeat) => own.items(items, *repeat),
        });
        self.word(if repeat { " }*" } else { " }" });
    }

    fn arms(&mut self, arms: &[Arm]) {
        self.word("{ ");
        self.list(arms, " | ", |own, arm| {
            own.expr(&arm.selector);
            own.mode(arm.mode);
            own.ops(&arm.ops);
        });
        self.word(" }");
    }

    pub(super) fn mode(&mut self, mode: ArmMode) {
        self.word(match mode {
            ArmMode::Each => " :",
            ArmMode::Together => " =",
            ArmMode::Connected => " =:",
        });
    }

    fn block(&mut self, block: &Block) {
        self.call(&block.name, &block.args);
        for part in &block.parts {
            self.word(" ");
            match part {
                BlockPart::Slots(items, repeat) => self.items(items, *repeat),
                BlockPart::Sections(sections, repeat) => {
                    self.word("{ ");
                    self.list(sections, " | ", |own, section| {
                        own.arg(&section.length);
                        own.word(" : ");
                        own.expr(&section.depth);
                        own.word(" :");
                        own.ops(&section.ops);
                    });
                    self.word(if *repeat { " }*" } else { " }" });
                }
                BlockPart::Arms(arms) => self.arms(arms),
                // In braces these would have two sides.
                BlockPart::Ops(operands)
                    if operands.len() == 1 && matches!(&*block.name.text, "union" | "subtract" | "intersect") =>
                {
                    self.list(&operands[0], " ", Self::op);
                }
                BlockPart::Ops(operands) => {
                    self.word("{");
                    self.list(operands, " |", |own, ops| own.ops(ops));
                    self.word(" }");
                }
            }
        }
    }
}
