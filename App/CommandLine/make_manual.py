#!/usr/bin/env python3
"""Writes the manual pages of varimarch, one per subcommand, from the output of --help.

Usage: make_manual.py VARIMARCH VERSION FOLDER
"""

import gzip
import pathlib
import re
import subprocess
import sys


def main(program, version, folder):
    for outdated in pathlib.Path(folder).glob("*.1.gz"):
        outdated.unlink()
    pages = dict(pages_below(program, ["varimarch"]))
    for name, page in pages.items():
        others = ", ".join(f"\\fB{escaped(other)}\\fR(1)" for other in pages if other != name)
        text = f'.TH {name.upper()} 1 "" "varimarch {version}" "User Commands"\n'
        text += f"{page}.SH SEE ALSO\n{others}\n"
        # The files have no time stamp, so that the same program gives the same file.
        compressed = gzip.compress(text.encode(), mtime=0)
        (pathlib.Path(folder) / f"{name}.1.gz").write_bytes(compressed)


def pages_below(program, command):
    """Yields the name and the text of the command's page, and of its subcommands' pages."""
    answer = subprocess.run(
        [program, *command[1:], "--help"], capture_output=True, text=True, check=True
    )
    summary, usage, *rest = answer.stdout.strip().splitlines()
    name = "-".join(command)
    page = f".SH NAME\n{escaped(name)} \\- {escaped(summary[0].lower() + summary[1:].rstrip('.'))}\n"
    page += f".SH SYNOPSIS\n{escaped(usage.removeprefix('Usage: '))}\n"
    sections = sections_of(rest)
    yield name, page + "".join(section_text(title, lines) for title, lines in sections)
    for subcommand in [line.split()[0] for line in dict(sections).get("Subcommands", [])]:
        yield from pages_below(program, [*command, subcommand])


def sections_of(lines):
    """Returns pairs of a title and the lines below it. A title without lines is a remark."""
    sections = []
    for line in filter(None, lines):
        if line.startswith(" ") and sections:
            sections[-1][1].append(line)
        elif re.fullmatch(r"[A-Z][^.]*:", line):
            sections.append((line[:-1], []))
        else:
            sections.append((line, []))
    return sections


def section_text(title, lines):
    if not lines:
        return f".PP\n{escaped(title)}\n"
    heading = f".SH {escaped(title.upper())}\n"
    if title.startswith("Example"):
        return heading + ".nf\n" + "".join(f"{escaped(line.strip())}\n" for line in lines) + ".fi\n"
    return heading + "".join(entry_text(line) for line in lines)


def entry_text(line):
    """Formats an option or its description, which begins in column 30 or on the next line."""
    if not re.match(r" {2}\S", line):
        return f"{escaped(line.strip())}\n"
    # An option that just fits has a single space between it and its description.
    option, *description = re.split(
        r" {2,}|(?<=^.{27}) (?=[A-Z][a-z])(?!Needs:|Excludes:)", line[2:], maxsplit=1
    )
    # "TEXT:a|b" lists the words to choose from.
    words = escaped(re.sub(r"\b[A-Z]+:(?=[\w-]+\|)", "", option)).replace("|", "|\\:")
    return f".TP\n\\fB{words}\\fR\n" + "".join(f"{escaped(text)}\n" for text in description)


def escaped(text):
    """Escapes text for troff, in which an apostrophe or a dot at the start begins a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^([.'])", r"\\&\1", text)


if __name__ == "__main__":
    main(*sys.argv[1:])
