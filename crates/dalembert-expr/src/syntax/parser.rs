//! From words to a syntax tree: a Pratt parser.

use super::lexer;
use super::token::{Path, Spanned, Token};
use super::tree::{Binary, Id, Node, Tree};
use crate::error::{ExprError, Fault, MOST_ERRORS, excerpt};
use crate::{Scope, Unit};
use std::ops::Range;

/// How deeply parentheses, calls and prefixes may nest.
const DEEPEST: usize = 200;
/// The most words of a name with spaces that is looked for without its backticks.
const MOST_WORDS: usize = 6;
/// The longest text, in bytes.
const LONGEST: usize = 1 << 16;

/// Binding powers, weak to strong.
const NOT: u8 = 5;
const NEGATE: u8 = 13;
const PRODUCT: u8 = 11;
const COMPARISON: u8 = 7;

/// Parses a text. The scope, where there is one, tells names from units.
///
/// The tree is complete where there are no errors.
pub(crate) fn parse(text: &str, scope: Option<&dyn Scope>) -> (Tree, Vec<ExprError>) {
    let whole = 0..text.len();
    let one = |fault: Fault| (Tree::default(), vec![ExprError::new(&fault, whole.clone())]);
    if text.trim().is_empty() {
        return one(Fault::Empty);
    }
    if text.len() > LONGEST {
        return one(Fault::TooLong { limit: LONGEST });
    }
    let (tokens, faults) = lexer::lex(text);
    if !faults.is_empty() {
        let errors = faults
            .iter()
            .take(MOST_ERRORS)
            .map(|(f, s)| ExprError::new(f, s.clone()));
        return (Tree::default(), errors.collect());
    }
    let mut parser = Parser::new(text, scope, tokens);
    // A stop has reported its error.
    if parser.expression(0).is_ok() && parser.peek() != &Token::End {
        let found = parser.word_ahead(0);
        parser.report(Fault::Trailing { found }, parser.span_ahead(0));
    }
    (parser.tree, parser.errors)
}

/// Parses a text that is a unit expression and nothing else.
pub(crate) fn parse_unit(text: &str) -> Result<Unit, Vec<ExprError>> {
    let (tokens, faults) = lexer::lex(text);
    if !faults.is_empty() {
        return Err(faults
            .iter()
            .map(|(f, s)| ExprError::new(f, s.clone()))
            .collect());
    }
    let mut parser = Parser::new(text, None, tokens);
    let unit = parser.unit().unwrap_or(Unit::ONE);
    if parser.peek() != &Token::End {
        let found = parser.word_ahead(0);
        parser.report(Fault::Trailing { found }, parser.span_ahead(0));
    }
    if parser.errors.is_empty() {
        Ok(unit)
    } else {
        Err(parser.errors)
    }
}

/// Parsing cannot go on; the error has been reported.
struct Stop;

pub(super) struct Parser<'a> {
    text: &'a str,
    scope: Option<&'a dyn Scope>,
    tokens: Vec<Spanned>,
    at: usize,
    depth: usize,
    tree: Tree,
    errors: Vec<ExprError>,
}

impl<'a> Parser<'a> {
    fn new(text: &'a str, scope: Option<&'a dyn Scope>, tokens: Vec<Spanned>) -> Self {
        Self {
            text,
            scope,
            tokens,
            at: 0,
            depth: 0,
            tree: Tree::default(),
            errors: Vec::new(),
        }
    }
}

impl Parser<'_> {
    pub(super) fn peek(&self) -> &Token {
        self.peek_ahead(0)
    }

    pub(super) fn peek_ahead(&self, ahead: usize) -> &Token {
        &self.tokens[self.clamp(ahead)].0
    }

    pub(super) fn span_ahead(&self, ahead: usize) -> Range<usize> {
        self.tokens[self.clamp(ahead)].1.clone()
    }

    /// Index of a word ahead; all words after the end are the end.
    fn clamp(&self, ahead: usize) -> usize {
        (self.at + ahead).min(self.tokens.len() - 1)
    }

    fn word_ahead(&self, ahead: usize) -> String {
        self.text[self.span_ahead(ahead)].to_owned()
    }

    pub(super) fn skip(&mut self, count: usize) {
        self.at = self.clamp(count);
    }

    pub(super) fn report(&mut self, fault: Fault, span: Range<usize>) {
        // Nobody reads more, and a long text of nonsense must not cost much.
        if self.errors.len() < MOST_ERRORS {
            self.errors.push(ExprError::new(&fault, span));
        }
    }

    /// Does the scope know a variable of this name?
    pub(super) fn is_variable(&self, name: &str) -> bool {
        self.scope.is_some_and(|s| s.variable(&[name]).is_ok())
    }

    fn stop<T>(&mut self, fault: Fault, span: Range<usize>) -> Result<T, Stop> {
        self.report(fault, span);
        Err(Stop)
    }

    fn expression(&mut self, weakest: u8) -> Result<Id, Stop> {
        if self.depth == DEEPEST {
            return self.stop(Fault::TooDeep, self.span_ahead(0));
        }
        self.depth += 1;
        let result = self.operators(weakest);
        self.depth -= 1;
        result
    }

    fn operators(&mut self, weakest: u8) -> Result<Id, Stop> {
        let mut left = self.prefix()?;
        let mut compared = false;
        loop {
            let starts_value = matches!(
                self.peek(),
                Token::Number(_) | Token::Name(_) | Token::Open | Token::Not
            );
            let (operator, power, right_power) = match infix(self.peek()) {
                Some(infix) => infix,
                None if starts_value => (Binary::Multiply, PRODUCT, PRODUCT + 1),
                None => return Ok(left),
            };
            if power < weakest {
                return Ok(left);
            }
            if power == COMPARISON && compared {
                self.report(Fault::ComparisonChain, self.span_ahead(0));
            }
            compared = power == COMPARISON;
            if starts_value {
                self.report_missing_operator(left);
            } else {
                self.skip(1);
            }
            let plain_number = matches!(self.peek(), Token::Number(_));
            let right = self.expression(right_power)?;
            if operator == Binary::Divide && plain_number {
                self.check_fraction(left, right);
            }
            let span = self.tree.span(left).start..self.tree.span(right).end;
            let first = self.tree.first(left);
            left = self
                .tree
                .push(Node::Binary(operator, left, right), first, span);
        }
    }

    fn report_missing_operator(&mut self, left: Id) {
        let before = self.tree.span(left);
        let span = before.start..self.span_ahead(0).end;
        let left = excerpt(&self.text[before]);
        let call = matches!(self.peek(), Token::Name(_)) && self.peek_ahead(1) == &Token::Open;
        let mut right = self.word_ahead(0);
        if call || right == "(" {
            right.push_str(if call { "(...)" } else { "...)" });
        }
        self.report(Fault::MissingOperator { left, right }, span);
    }

    /// Refuses `1/2 in`, which reads as half an inch and is one over two inches.
    fn check_fraction(&mut self, left: Id, right: Id) {
        let Node::Number {
            unit: Some(unit), ..
        } = self.tree.node(right)
        else {
            return;
        };
        let bare = self.tree.subtree(left).iter().all(|node| match node {
            Node::Number { unit, .. } => unit.is_none(),
            Node::Name(path) => path.word() == Some("pi"),
            Node::Binary(..) | Node::Negate(_) => true,
            _ => false,
        });
        if bare && !unit.is_si() {
            let denominator = self.tree.span(right);
            let span = self.tree.span(left).start..denominator.end;
            let fault = Fault::AmbiguousFraction {
                text: excerpt(&self.text[span.clone()]),
                denominator: self.text[denominator].to_owned(),
            };
            self.report(fault, span);
        }
    }

    fn prefix(&mut self) -> Result<Id, Stop> {
        let span = self.span_ahead(0);
        let token = self.peek().clone();
        match token {
            Token::Number(value) => {
                self.skip(1);
                let reported = self.errors.len();
                let unit = self.unit();
                let end = self.tokens[self.at - 1].1.end;
                let node = match self.errors.len() == reported {
                    true => Node::Number { value, unit },
                    false => Node::Invalid,
                };
                Ok(self.tree.leaf(node, span.start..end))
            }
            Token::Name(path) => {
                if let Some((path, written, count)) = self.spaced_name() {
                    let whole = span.start..self.span_ahead(count - 1).end;
                    self.skip(count);
                    self.report(Fault::SpacedName { written }, whole.clone());
                    return Ok(self.tree.leaf(Node::Name(path), whole));
                }
                self.skip(1);
                if self.peek() != &Token::Open {
                    return Ok(self.tree.leaf(Node::Name(path), span));
                }
                if path.parts.len() > 1 {
                    let name = path.parts.join(".");
                    let fault = Fault::UnknownFunction {
                        name,
                        suggestions: Vec::new(),
                        variable: true,
                    };
                    return self.stop(fault, span);
                }
                self.call(path.parts.concat(), span)
            }
            Token::Open => {
                self.skip(1);
                let inside = self.expression(0)?;
                let end = self.close(&span)?;
                self.tree.widen(inside, span.start..end);
                Ok(inside)
            }
            Token::Minus | Token::Plus | Token::Not => {
                self.skip(1);
                let power = if token == Token::Not { NOT } else { NEGATE };
                let operand = self.expression(power)?;
                let whole = span.start..self.tree.span(operand).end;
                let first = self.tree.first(operand);
                Ok(match token {
                    Token::Minus => self.tree.push(Node::Negate(operand), first, whole),
                    Token::Not => self.tree.push(Node::Not(operand), first, whole),
                    _ => operand,
                })
            }
            Token::End => self.stop(Fault::UnexpectedEnd, span),
            _ => {
                let found = self.word_ahead(0);
                self.stop(Fault::UnexpectedWord { found }, span)
            }
        }
    }

    /// A known name with spaces that was written without backticks: itself, how to write it, and
    /// its number of words.
    fn spaced_name(&self) -> Option<(Path, String, usize)> {
        let mut words: Vec<&str> = Vec::new();
        for count in 1..=MOST_WORDS {
            let Token::Name(path) = self.peek_ahead(count - 1) else {
                return None;
            };
            let (word, properties) = path.parts.split_first()?;
            words.push(word);
            let joined = words.join(" ");
            let mut names = vec![joined.as_str()];
            names.extend(properties.iter().map(String::as_str));
            if count > 1 && self.scope?.variable(&names).is_ok() {
                let properties = properties.iter().map(|p| format!(".{p}"));
                let written = format!("`{joined}`{}", properties.collect::<String>());
                let parts = names.into_iter().map(str::to_owned).collect();
                let quoted = true;
                return Some((Path { parts, quoted }, written, count));
            }
            // Behind a property a name cannot go on.
            if path.quoted || !properties.is_empty() {
                return None;
            }
        }
        None
    }

    fn call(&mut self, name: String, name_span: Range<usize>) -> Result<Id, Stop> {
        let open = self.span_ahead(0);
        let first = self.tree.len();
        self.skip(1);
        let mut arguments = Vec::new();
        if self.peek() != &Token::Close {
            arguments.push(self.expression(0)?);
            while self.peek() == &Token::Comma {
                self.skip(1);
                arguments.push(self.expression(0)?);
            }
        }
        let end = self.close(&open)?;
        let span = name_span.start..end;
        let node = Node::Call {
            name,
            name_span,
            arguments,
        };
        Ok(self.tree.push(node, first, span))
    }

    /// Takes the closing parenthesis and gives its end.
    fn close(&mut self, open: &Range<usize>) -> Result<usize, Stop> {
        let span = self.span_ahead(0);
        match self.peek() {
            Token::Close => {
                self.skip(1);
                Ok(span.end)
            }
            _ => self.stop(Fault::MissingParenthesis, open.clone()),
        }
    }
}

/// Operator between two values, its left binding power and that of its right operand.
fn infix(token: &Token) -> Option<(Binary, u8, u8)> {
    Some(match token {
        Token::Or => (Binary::Or, 1, 2),
        Token::And => (Binary::And, 3, 4),
        Token::Less => (Binary::Less, COMPARISON, 8),
        Token::LessEqual => (Binary::LessEqual, COMPARISON, 8),
        Token::Greater => (Binary::Greater, COMPARISON, 8),
        Token::GreaterEqual => (Binary::GreaterEqual, COMPARISON, 8),
        Token::Equal => (Binary::Equal, COMPARISON, 8),
        Token::NotEqual => (Binary::NotEqual, COMPARISON, 8),
        Token::Plus => (Binary::Add, 9, 10),
        Token::Minus => (Binary::Subtract, 9, 10),
        Token::Star => (Binary::Multiply, PRODUCT, 12),
        Token::Slash => (Binary::Divide, PRODUCT, 12),
        Token::Caret => (Binary::Power, 16, 15),
        _ => return None,
    })
}
