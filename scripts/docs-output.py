#!/usr/bin/env python3
"""Keeps what the pages of the manual show equal to the models and to the output of the program.

A line `[examples/NAME.toml](...):` is followed by a block with the content of that model. A page shows a session as a fenced block of the language `console`: lines that start with `$ ` are
commands, what follows is their output. Commands run in a copy of docs/src/examples; pictures that
they write to ../images, or under the name of a picture that is there, are kept in docs/src/images.

    scripts/docs-output.py PROGRAM           write models and output into the pages
    scripts/docs-output.py PROGRAM --check   fail where a page shows something else
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent / "docs" / "src"
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)
MODEL = re.compile(r"^(\[(examples/[\w-]+\.toml)\]\([^)]*\):\n\n)```toml\n.*?^```$", re.M | re.S)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
# Counts of steps and iterations may differ by a few from machine to machine.
COUNTS = re.compile(r"^\s*(instants|steps|\d+: \w+, residual) ")


def run(command, program, folder):
    """The output of one command, with its exit code where that is not zero."""
    script = f'dalembert() {{ "$PROGRAM" "$@"; }}\nset -o pipefail\n{command}'
    answer = subprocess.run(
        ["bash", "-c", script],
        cwd=folder,
        env={**os.environ, "PROGRAM": str(program)},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    lines = [line.rstrip() for line in answer.stdout.rstrip().splitlines()]
    if answer.returncode:
        lines.append(f"[exit code {answer.returncode}]")
    return lines


def session(text, program, folder):
    """A console block with fresh output."""
    out = []
    for line in text.splitlines():
        if line.startswith("$ "):
            out += [line, *run(line[2:], program, folder)]
    return out


def same_token(a, b):
    """Are two words equal, numbers up to rounding?"""
    if a == b:
        return True
    if NUMBER.sub("#", a) != NUMBER.sub("#", b):
        # A residual of rounding may change its notation: 0 and 1.2e-17.
        try:
            return abs(float(a.strip(",;"))) < 1e-7 and abs(float(b.strip(",;."))) < 1e-7
        except ValueError:
            return a in (".", "0") and small(b) or b in (".", "0") and small(a)
    pairs = zip(NUMBER.findall(a), NUMBER.findall(b))
    return all(abs(float(x) - float(y)) <= 1e-7 + 1e-4 * abs(float(y)) for x, y in pairs)


def small(word):
    try:
        return abs(float(word)) < 1e-7
    except ValueError:
        return False


def same_line(a, b):
    if COUNTS.match(a) and COUNTS.match(b):
        return True
    a, b = a.split(), b.split()
    return len(a) == len(b) and all(map(same_token, a, b))


def main():
    arguments = [a for a in sys.argv[1:] if a != "--check"]
    check = "--check" in sys.argv
    if len(arguments) != 1:
        sys.exit(__doc__)
    program = Path(arguments[0]).resolve()
    stale = 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "examples"
        shutil.copytree(SOURCE / "examples", folder)
        images = Path(scratch) / "images"
        images.mkdir()
        for page in sorted(SOURCE.rglob("*.md")):
            text = page.read_text()

            def replace(match):
                nonlocal stale
                fresh = session(match[1], program, folder)
                shown = match[1].splitlines()
                if check:
                    if len(fresh) != len(shown) or not all(map(same_line, fresh, shown)):
                        stale += 1
                        print(f"{page.relative_to(SOURCE)}: {fresh[0]}: the output is now")
                        print("\n".join(f"    {line}" for line in fresh[1:]))
                    return match[0]
                return "```console\n" + "\n".join(fresh) + "\n```"

            def model(match):
                return f"{match[1]}```toml\n{(SOURCE / match[2]).read_text()}```"

            new = MODEL.sub(model, text)
            if check and new != text:
                stale += 1
                print(f"{page.relative_to(SOURCE)}: a model differs from its file")
            new = BLOCK.sub(replace, new)
            if new != text and not check:
                page.write_text(new)
        if not check:
            # Pictures that readers write beside the model are shown from the folder of pictures.
            for picture in sorted(folder.glob("*.svg")):
                if (SOURCE / "images" / picture.name).exists():
                    shutil.copy(picture, images)
            for image in sorted(images.iterdir()):
                shutil.copy(image, SOURCE / "images" / image.name)
    if stale:
        sys.exit(f"{stale} parts of the manual are stale: run scripts/docs-output.py PROGRAM")


if __name__ == "__main__":
    main()
