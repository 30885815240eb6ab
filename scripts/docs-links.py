#!/usr/bin/env python3
"""Fails where a page of the manual links or includes a file that does not exist, or where a page
is missing in SUMMARY.md."""

import re
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent / "docs" / "src"
LINK = re.compile(r"\]\(([^)#]+?)(?:#[^)]*)?\)")
INCLUDE = re.compile(r"\{\{#include ([^}]+)\}\}")


def main():
    broken = []
    for page in sorted(SOURCE.rglob("*.md")):
        text = page.read_text()
        for target in LINK.findall(text) + INCLUDE.findall(text):
            if "://" not in target and not (page.parent / target.strip()).exists():
                broken.append(f"{page.relative_to(SOURCE)}: {target} does not exist")
    summary = (SOURCE / "SUMMARY.md").read_text()
    for page in sorted(SOURCE.rglob("*.md")):
        name = page.relative_to(SOURCE).as_posix()
        if name != "SUMMARY.md" and f"({name})" not in summary:
            broken.append(f"SUMMARY.md: {name} is missing")
    print("\n".join(broken), end="\n" if broken else "")
    sys.exit(bool(broken))


if __name__ == "__main__":
    main()
