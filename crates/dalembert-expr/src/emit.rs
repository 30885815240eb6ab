//! From a checked syntax tree to instructions.

use crate::builtin::Operation;
use crate::check::{Callee, Meaning, fold};
use crate::derive::bivariate::Bivariate;
use crate::instruction::{Comparison, Instruction};
use crate::scope::Function;
use crate::syntax::tree::{Binary, Id, Node, Tree};
use std::ops::Range;
use std::sync::Arc;

/// Instructions with what they refer to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Code {
    pub instructions: Vec<Instruction>,
    /// The place in the text of each instruction.
    pub spans: Vec<Range<usize>>,
    pub tables: Vec<Arc<dyn Function>>,
    /// The caller's numbers of the values in use, ascending.
    pub slots: Vec<usize>,
    pub depth: usize,
}

/// Writes the instructions of a tree without errors.
pub(crate) fn emit(tree: &Tree, known: &[Meaning]) -> Code {
    let mut slots: Vec<usize> = known.iter().filter_map(|m| m.slot).collect();
    slots.sort_unstable();
    slots.dedup();
    let mut emitter = Emitter {
        tree,
        known,
        code: Code {
            slots,
            ..Code::default()
        },
        depth: 0,
        branches: Vec::new(),
    };
    emitter.run(tree.len() - 1);
    emitter.keep_used_slots();
    emitter.code
}

/// What is left to do, the next step last: a stack of our own, so that long sums are no danger.
enum Step {
    Visit(Id),
    Write(Id, Instruction),
    /// Between condition and value of an `if`.
    Then(Id),
    /// Between value and alternative.
    Else(Id),
    EndIf,
}

struct Emitter<'a> {
    tree: &'a Tree,
    known: &'a [Meaning],
    code: Code,
    depth: usize,
    /// Jumps whose goal is not known yet.
    branches: Vec<usize>,
}

impl Emitter<'_> {
    fn run(&mut self, root: Id) {
        let mut steps = vec![Step::Visit(root)];
        while let Some(step) = steps.pop() {
            match step {
                Step::Visit(id) => self.visit(id, &mut steps),
                Step::Write(id, instruction) => self.write(id, instruction),
                Step::Then(id) => {
                    self.branches.push(self.code.instructions.len());
                    self.write(id, Instruction::Unless(0));
                }
                Step::Else(id) => {
                    let after = self.code.instructions.len();
                    self.write(id, Instruction::Jump(0));
                    self.land();
                    self.branches.push(after);
                    // The value of the other branch is not there in this one.
                    self.depth -= 1;
                }
                Step::EndIf => self.land(),
            }
        }
    }

    /// Lets the latest open jump lead to the next instruction.
    fn land(&mut self) {
        let goal = self.code.instructions.len() as u32;
        if let Some(from) = self.branches.pop() {
            self.code.instructions[from] = match self.code.instructions[from] {
                Instruction::Unless(_) => Instruction::Unless(goal),
                _ => Instruction::Jump(goal),
            };
        }
    }

    fn write(&mut self, id: Id, instruction: Instruction) {
        use Instruction as I;
        match instruction {
            I::Constant(_) | I::Slot(_) => self.depth += 1,
            I::Add | I::Subtract | I::Multiply | I::Divide | I::SubtractFrom | I::DivideInto => {
                self.depth -= 1;
            }
            I::Bivariate(_) | I::Compare(_) | I::And | I::Or | I::Min | I::Max | I::Mod => {
                self.depth -= 1;
            }
            I::Blend => self.depth -= 2,
            I::Unless(_) => self.depth -= 1,
            I::AddSlot(_) | I::SubtractSlot(_) | I::MultiplySlot(_) | I::DivideSlot(_) => {}
            I::AddConstant(_) | I::MultiplyConstant(_) | I::DivideConstant(_) => {}
            I::FromConstant(_) | I::OverConstant(_) | I::Negate | I::Not => {}
            I::Univariate(_) | I::Table(_) | I::Jump(_) => {}
        }
        self.code.depth = self.code.depth.max(self.depth);
        self.code.instructions.push(instruction);
        self.code.spans.push(self.tree.span(id));
    }

    /// The position of a variable among the values in use.
    fn slot(&self, id: Id) -> Option<u32> {
        let slot = self.known[id].slot?;
        let position = self.code.slots.binary_search(&slot).ok()?;
        Some(position as u32)
    }

    fn visit(&mut self, id: Id, steps: &mut Vec<Step>) {
        let meaning = &self.known[id];
        if let Some(value) = meaning.value {
            return self.write(id, Instruction::Constant(value));
        }
        if let Some(taken) = meaning.taken {
            return steps.push(Step::Visit(taken));
        }
        if let Some(slot) = self.slot(id) {
            return self.write(id, Instruction::Slot(slot));
        }
        match self.tree.node(id) {
            // Numbers and names have a value or a slot.
            Node::Number { .. } | Node::Name(_) | Node::Invalid => {}
            Node::Negate(operand) => {
                steps.push(Step::Write(id, Instruction::Negate));
                steps.push(Step::Visit(*operand));
            }
            Node::Not(operand) => {
                steps.push(Step::Write(id, Instruction::Not));
                steps.push(Step::Visit(*operand));
            }
            Node::Binary(operator, left, right) => self.binary(id, *operator, *left, *right, steps),
            Node::Call { arguments, .. } => self.call(id, arguments, steps),
        }
    }

    fn binary(&self, id: Id, operator: Binary, left: Id, right: Id, steps: &mut Vec<Step>) {
        use Instruction as I;
        let value = |id: Id| self.known[id].value;
        // An operand that is a number or a variable goes into the instruction.
        let fused = match (operator, value(left), value(right)) {
            (Binary::Add, Some(c), _) => Some((right, I::AddConstant(c))),
            (Binary::Add, _, Some(c)) => Some((left, I::AddConstant(c))),
            (Binary::Subtract, Some(c), _) => Some((right, I::FromConstant(c))),
            (Binary::Subtract, _, Some(c)) => Some((left, I::AddConstant(-c))),
            (Binary::Multiply, Some(c), _) => Some((right, I::MultiplyConstant(c))),
            (Binary::Multiply, _, Some(c)) => Some((left, I::MultiplyConstant(c))),
            (Binary::Divide, Some(c), _) => Some((right, I::OverConstant(c))),
            (Binary::Divide, _, Some(c)) => Some((left, I::DivideConstant(c))),
            (Binary::Power, _, Some(c)) => fold::power(c).map(|p| (left, I::Univariate(p))),
            _ => self.fuse_slot(operator, left, right),
        };
        if let Some((operand, instruction)) = fused {
            steps.push(Step::Write(id, instruction));
            steps.push(Step::Visit(operand));
            return;
        }
        let (instruction, swapped) = match operator {
            Binary::Add => (I::Add, Some(I::Add)),
            Binary::Subtract => (I::Subtract, Some(I::SubtractFrom)),
            Binary::Multiply => (I::Multiply, Some(I::Multiply)),
            Binary::Divide => (I::Divide, Some(I::DivideInto)),
            Binary::Power => (I::Bivariate(Bivariate::Power), None),
            Binary::Less => (I::Compare(Comparison::Less), None),
            Binary::LessEqual => (I::Compare(Comparison::LessEqual), None),
            Binary::Greater => (I::Compare(Comparison::Greater), None),
            Binary::GreaterEqual => (I::Compare(Comparison::GreaterEqual), None),
            Binary::Equal => (I::Compare(Comparison::Equal), None),
            Binary::NotEqual => (I::Compare(Comparison::NotEqual), None),
            Binary::And => (I::And, None),
            Binary::Or => (I::Or, None),
        };
        // The larger operand first keeps the stack shallow: a + (b + (c + ...)).
        let size = |id: Id| id - self.tree.first(id);
        match swapped {
            Some(swapped) if size(right) > size(left) => {
                steps.push(Step::Write(id, swapped));
                steps.extend([Step::Visit(left), Step::Visit(right)]);
            }
            _ => {
                steps.push(Step::Write(id, instruction));
                steps.extend([Step::Visit(right), Step::Visit(left)]);
            }
        }
    }

    fn fuse_slot(&self, operator: Binary, left: Id, right: Id) -> Option<(Id, Instruction)> {
        use Instruction as I;
        if let Some(slot) = self.slot(right) {
            let instruction = match operator {
                Binary::Add => I::AddSlot(slot),
                Binary::Subtract => I::SubtractSlot(slot),
                Binary::Multiply => I::MultiplySlot(slot),
                Binary::Divide => I::DivideSlot(slot),
                _ => return None,
            };
            return Some((left, instruction));
        }
        let slot = self.slot(left)?;
        match operator {
            Binary::Add => Some((right, I::AddSlot(slot))),
            Binary::Multiply => Some((right, I::MultiplySlot(slot))),
            _ => None,
        }
    }

    fn call(&mut self, id: Id, arguments: &[Id], steps: &mut Vec<Step>) {
        use Instruction as I;
        let function = match &self.known[id].callee {
            Some(Callee::Builtin(function)) => *function,
            Some(Callee::Table(table)) => {
                let number = self.code.tables.len() as u32;
                self.code.tables.push(Arc::clone(table));
                steps.push(Step::Write(id, I::Table(number)));
                steps.extend(arguments.iter().copied().map(Step::Visit));
                return;
            }
            // A call without a meaning has been reported.
            None => return,
        };
        let instruction = match function.operation {
            Operation::Univariate(f) => I::Univariate(f),
            Operation::Bivariate(f) => I::Bivariate(f),
            Operation::Min => I::Min,
            Operation::Max => I::Max,
            Operation::Mod => I::Mod,
            Operation::Blend => I::Blend,
            Operation::If => {
                if let &[condition, value, otherwise] = arguments {
                    steps.push(Step::EndIf);
                    steps.push(Step::Visit(otherwise));
                    steps.push(Step::Else(id));
                    steps.push(Step::Visit(value));
                    steps.push(Step::Then(id));
                    steps.push(Step::Visit(condition));
                }
                return;
            }
        };
        if matches!(instruction, I::Min | I::Max) {
            for &argument in arguments[1..].iter().rev() {
                steps.push(Step::Write(id, instruction));
                steps.push(Step::Visit(argument));
            }
            steps.push(Step::Visit(arguments[0]));
            return;
        }
        steps.push(Step::Write(id, instruction));
        steps.extend(arguments.iter().rev().copied().map(Step::Visit));
    }

    /// Drops the variables that only stand in branches that are never taken.
    fn keep_used_slots(&mut self) {
        use Instruction as I;
        fn slot(instruction: &mut Instruction) -> Option<&mut u32> {
            match instruction {
                I::Slot(k) | I::AddSlot(k) | I::SubtractSlot(k) => Some(k),
                I::MultiplySlot(k) | I::DivideSlot(k) => Some(k),
                _ => None,
            }
        }
        let instructions = &mut self.code.instructions;
        let mut used: Vec<u32> = instructions
            .iter_mut()
            .filter_map(slot)
            .map(|k| *k)
            .collect();
        used.sort_unstable();
        used.dedup();
        for k in instructions.iter_mut().filter_map(slot) {
            // Every number is in the list of those in use.
            *k = used.partition_point(|u| u < k) as u32;
        }
        self.code.slots = used.iter().map(|&k| self.code.slots[k as usize]).collect();
    }
}
