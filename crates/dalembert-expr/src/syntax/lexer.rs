//! From text to words.

use super::token::{Path, Spanned, Token};
use crate::error::Fault;
use std::ops::Range;

/// Splits a text into words, the last of which is `End`; all faults at once.
pub(crate) fn lex(text: &str) -> (Vec<Spanned>, Vec<(Fault, Range<usize>)>) {
    let mut lexer = Lexer {
        text,
        at: 0,
        faults: Vec::new(),
    };
    let mut tokens = Vec::new();
    while let Some(character) = lexer.skip_space() {
        let start = lexer.at;
        if let Some(token) = lexer.token(character) {
            tokens.push((token, start..lexer.at));
        }
    }
    tokens.push((Token::End, text.len()..text.len()));
    (tokens, lexer.faults)
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    faults: Vec<(Fault, Range<usize>)>,
}

impl Lexer<'_> {
    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// Moves past the characters that satisfy a condition.
    fn skip(&mut self, condition: impl Fn(char) -> bool) {
        let rest = self.rest();
        self.at += rest.find(|c| !condition(c)).unwrap_or(rest.len());
    }

    fn skip_space(&mut self) -> Option<char> {
        self.skip(char::is_whitespace);
        self.peek()
    }

    fn token(&mut self, character: char) -> Option<Token> {
        if character.is_ascii_digit() || (character == '.' && self.digit_follows(1)) {
            return Some(self.number());
        }
        if is_name_start(character) || character == '`' {
            return self.name();
        }
        const SYMBOLS: &[(&str, Token)] = &[
            ("<=", Token::LessEqual),
            (">=", Token::GreaterEqual),
            ("==", Token::Equal),
            ("!=", Token::NotEqual),
            ("<", Token::Less),
            (">", Token::Greater),
            ("+", Token::Plus),
            ("-", Token::Minus),
            ("*", Token::Star),
            ("/", Token::Slash),
            ("^", Token::Caret),
            ("(", Token::Open),
            (")", Token::Close),
            (",", Token::Comma),
        ];
        let start = self.at;
        let symbol = SYMBOLS.iter().find(|(s, _)| self.rest().starts_with(s));
        if let Some((symbol, token)) = symbol {
            self.at += symbol.len();
            // `**` is a habit from other languages and would read as two products.
            if *token == Token::Star && self.peek() == Some('*') {
                self.at += 1;
                self.faults.push((Fault::DoubleStar, start..self.at));
                return Some(Token::Caret);
            }
            return Some(token.clone());
        }
        self.at += character.len_utf8();
        // `a ? b : c` is one habit from other languages, not two mistakes.
        let question = Fault::UnexpectedCharacter { found: '?' };
        if character != ':' || self.faults.iter().all(|(fault, _)| *fault != question) {
            let fault = Fault::UnexpectedCharacter { found: character };
            self.faults.push((fault, start..self.at));
        }
        None
    }

    fn digit_follows(&self, offset: usize) -> bool {
        let byte = self.text.as_bytes().get(self.at + offset);
        byte.is_some_and(u8::is_ascii_digit)
    }

    fn number(&mut self) -> Token {
        let start = self.at;
        let digit = |c: char| c.is_ascii_digit();
        self.skip(digit);
        if self.peek() == Some('.') {
            self.at += 1;
            self.skip(digit);
        }
        if matches!(self.peek(), Some('e' | 'E')) {
            let signed = self.text.as_bytes().get(self.at + 1);
            let sign = usize::from(matches!(signed, Some(b'+' | b'-')));
            if self.digit_follows(1 + sign) {
                self.at += 1 + sign;
                self.skip(digit);
            }
        }
        // Only digits, a point and an exponent have been taken: this always parses. Too large a
        // number becomes infinite, which the check of constants reports.
        Token::Number(self.text[start..self.at].parse().unwrap_or(f64::NAN))
    }

    fn name(&mut self) -> Option<Token> {
        let mut path = Path {
            parts: Vec::new(),
            quoted: false,
        };
        loop {
            path.parts.push(self.part(&mut path.quoted)?);
            if self.peek() != Some('.') {
                break;
            }
            let dot = self.at;
            self.at += 1;
            if !self.peek().is_some_and(|c| is_name_start(c) || c == '`') {
                self.faults.push((Fault::MissingProperty, dot..self.at));
                return None;
            }
        }
        Some(match path.word() {
            Some("and") => Token::And,
            Some("or") => Token::Or,
            Some("not") => Token::Not,
            _ => Token::Name(path),
        })
    }

    fn part(&mut self, quoted: &mut bool) -> Option<String> {
        let start = self.at;
        if self.peek() != Some('`') {
            self.skip(is_name_part);
            return Some(self.text[start..self.at].to_owned());
        }
        *quoted = true;
        let inside = &self.text[start + 1..];
        let Some(length) = inside.find('`') else {
            self.at = self.text.len();
            self.faults.push((Fault::OpenBacktick, start..self.at));
            return None;
        };
        self.at = start + length + 2;
        if inside[..length].trim().is_empty() {
            self.faults.push((Fault::EmptyName, start..self.at));
            return None;
        }
        Some(inside[..length].to_owned())
    }
}

/// Can a name stand in an expression without backticks, as far as its letters go: an ASCII letter
/// or underscore, then ASCII letters, digits and underscores?
pub fn is_identifier(name: &str) -> bool {
    name.starts_with(is_name_start) && name.chars().all(is_name_part)
}

fn is_name_part(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

fn is_name_start(c: char) -> bool {
    c.is_ascii_alphabetic() || c == '_'
}
