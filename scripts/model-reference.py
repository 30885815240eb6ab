#!/usr/bin/env python3
"""Writes the reference of model files, docs/src/model-file.md, from their JSON Schema.

    dalembert schema | scripts/model-reference.py           write the page
    dalembert schema | scripts/model-reference.py --check   fail if the page is stale
"""

import json
import sys
from pathlib import Path

PAGE = Path(__file__).resolve().parent.parent / "docs" / "src" / "model-file.md"

HEAD = """\
# Model files

This page is generated from the JSON Schema of model files (`dalembert schema`) by
`scripts/model-reference.py`; do not edit it.

A model file is [TOML](https://toml.io). Sections of which there is one are tables (`[model]`),
elements of which there may be many are arrays of tables (`[[body]]`). An unknown key is an error.
A *value* is a number in SI units, or a text with a number and a unit (`"30 deg"`) or an
expression: see [Values, units, expressions](values-units-expressions.md).

To have an editor complete and check the keys, save the schema and name it in the first line of a
model: `#:schema dalembert-model.schema.json` (the TOML language server Taplo reads it).
"""

# Sections in the order in which a model is usually written.
ORDER = [
    "model", "parameters", "table", "body", "joint", "constraint", "driver", "force", "initial",
    "trace", "analysis", "output",
]
DETAILS = {
    "joint": "The equations of each kind stand in [Joints](joints/index.md).",
    "constraint": "The equations stand in [Constraints](joints/constraints.md).",
    "driver": "The equations stand in [Drivers](joints/drivers.md).",
    "force": "The equations of each kind stand in [Force elements](forces/index.md).",
    "analysis": "What each command does stands in [Analyses](analyses.md).",
    "output": "The channels stand in [Results](results.md).",
    "table": "How tables are used stands in [Values, units, expressions](values-units-expressions.md).",
}


class Schema:
    def __init__(self, root):
        self.root = root

    def name(self, schema):
        reference = schema.get("$ref")
        return reference.rsplit("/", 1)[-1] if reference else None

    def resolve(self, schema):
        name = self.name(schema)
        return self.root["$defs"][name] if name else schema

    def words(self, schema):
        """The type of a value, in words."""
        if self.name(schema) == "Value":
            return "value"
        target = self.resolve(schema)
        if "const" in target:
            return f'`"{target["const"]}"`'
        choices = target.get("oneOf") or target.get("anyOf")
        if choices and all("const" in c for c in choices):
            return ", ".join(f'`"{c["const"]}"`' for c in choices)
        if choices and not target.get("properties") and not any("properties" in c for c in choices):
            return " or ".join(dict.fromkeys(self.words(c) for c in choices))
        kind = target.get("type")
        if kind == "array":
            item = self.words(target["items"])
            least, most = target.get("minItems"), target.get("maxItems")
            count = f"{least} " if least is not None and least == most else ""
            return f"list of {count}{plural(item)}"
        if choices or kind == "object":
            return f"[{self.name(schema) or 'table'}](#{(self.name(schema) or '').lower()})"
        return {"string": "text", "integer": "whole number", "number": "number"}.get(kind, kind or "")

    def row(self, key, schema, required):
        text = schema.get("description") or self.resolve(schema).get("description", "")
        if "default" in schema and schema["default"] not in ({}, None):
            text += f" Default: `{json.dumps(schema['default'])}`."
        return f"| `{key}` | {self.words(schema)} | {'yes' if required else ''} | {one_line(text)} |"

    def table(self, schema):
        properties = schema.get("properties", {})
        required = schema.get("required", [])
        keys = sorted(properties, key=lambda k: (k != "name", k != "kind", k not in required))
        rows = [self.row(key, properties[key], key in required) for key in keys]
        return ["| key | type | required | meaning |", "|---|---|---|---|", *rows, ""] if rows else []

    def kind(self, schema):
        """The word that selects this kind of element, if it has one of its own."""
        tag = self.resolve(schema.get("properties", {}).get("kind", {}))
        only = tag.get("oneOf", [])
        return only[0].get("const") if len(only) == 1 else tag.get("const")

    def variants(self, schema, level):
        """Tables of the kinds of an element."""
        out = []
        # What holds for several kinds comes before the headings of single ones.
        for choice in schema.get("anyOf", []) + schema.get("oneOf", []):
            choice = self.resolve(choice)
            kind = self.kind(choice)
            title = f"{'#' * level} `kind = \"{kind}\"`" if kind else None
            text = choice.get("description", "")
            nested = choice.get("oneOf") or choice.get("anyOf")
            if title:
                out += [title, "", text, ""]
                keys = choice["properties"].items()
                rest = dict(choice, properties={k: v for k, v in keys if k != "kind" and in_space(v, text)})
                out += self.table(rest) + self.variants(choice, level + 1)
            else:
                out += [text, ""] if text else []
                out += self.table(choice)
                if nested:
                    out += self.variants(choice, level)
        return out

    def used(self):
        """Named types that a table refers to, in the order of their first use."""
        skip = {"Value"}
        seen = []

        def visit(schema):
            if isinstance(schema, dict):
                name = self.name(schema)
                if name and name not in skip and name not in seen:
                    target = self.root["$defs"][name]
                    choices = target.get("oneOf") or target.get("anyOf") or []
                    if any("properties" in c for c in choices) or target.get("properties"):
                        seen.append(name)
                    visit(target)
                for key, part in schema.items():
                    if key != "$defs":
                        visit(part)
            elif isinstance(schema, list):
                for part in schema:
                    visit(part)

        visit(self.root["properties"])
        return seen


def in_space(schema, kind):
    """Has the kind of element of this description the key? Keys and kinds of one space say so."""
    for own, other in [("(planar)", "(spatial)"), ("(spatial)", "(planar)")]:
        if own in kind and other not in kind:
            return not schema.get("description", "").rstrip(".").endswith(other)
    return True


def plural(words):
    """"value" becomes "values", "list of 2 values" becomes "lists of 2 values"."""
    if words.startswith("list of"):
        return "lists" + words[4:]
    return words + "s" if words.replace(" ", "").isalpha() else words


def one_line(text):
    return " ".join(text.split()).replace("|", "\\|")


def paragraphs(text):
    """Joins the lines of each paragraph."""
    return [line for part in text.split("\n\n") for line in (" ".join(part.split()), "")]


def page(root):
    schema = Schema(root)
    out = [HEAD]
    sections = root["properties"]
    names = ORDER + [n for n in sections if n not in ORDER]
    done = set()
    for name in names:
        section = sections[name]
        repeated = section.get("type") == "array"
        inner = section["items"] if repeated else section
        target = schema.resolve(inner)
        done.add(schema.name(inner))
        out += [f"## `{'[[' if repeated else '['}{name}{']]' if repeated else ']'}`", ""]
        out += paragraphs(target.get("description") or section.get("description", ""))
        if name == "parameters":
            out += ["Every key is the name of a parameter, and its content a value.", ""]
        if name in DETAILS:
            out += [DETAILS[name], ""]
        out += schema.table(target)
        out += schema.variants(target, 3)
    out += ["## Types", ""]
    for name in schema.used():
        if name in done:
            continue
        target = root["$defs"][name]
        out += [f"### {name}", ""] + paragraphs(target.get("description", ""))
        out += schema.table(target) + schema.variants(target, 4)
    return "\n".join(out).rstrip() + "\n"


def main():
    text = page(json.load(sys.stdin))
    if "--check" in sys.argv[1:]:
        if not PAGE.exists() or PAGE.read_text() != text:
            sys.exit(f"{PAGE.name} is stale: run dalembert schema | scripts/model-reference.py")
    else:
        PAGE.write_text(text)


if __name__ == "__main__":
    main()
