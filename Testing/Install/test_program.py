#!/usr/bin/env python3
"""Tests the installed program and its manual.

Usage: test_program.py PREFIX VERSION
"""

import gzip
import pathlib
import re
import subprocess
import sys
import tempfile

PREFIX, VERSION = pathlib.Path(sys.argv[1]), sys.argv[2]


def varimarch(*arguments):
    """Output of the installed program, which finds its library by itself."""
    done = subprocess.run([PREFIX / "bin/varimarch", *arguments], capture_output=True, text=True,
                          check=False, env={})
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def check_manual(command):
    """The manual must name every option and subcommand of the help, and every subcommand's page must exist."""
    help_text = varimarch(*command[1:], "--help")
    page = PREFIX / "share/man/man1" / ("-".join(command) + ".1.gz")
    text = gzip.decompress(page.read_bytes()).decode()
    assert f"varimarch {VERSION}" in text.splitlines()[0], text[:80]
    plain = re.sub(r"\\[&:]", "", text).replace("\\-", "-")
    # Options are bold, and a backslash in the page shows as a letter after it: \fB.
    options = re.findall(r"^ {2}(-\S+|[A-Z]\S*) ", help_text, flags=re.M)
    examples = re.findall(r"^ {2}(varimarch .*)", help_text, flags=re.M)
    assert "-h,--help" in options, help_text
    for option in options:
        assert re.search(rf"^\\fB{re.escape(option)}[ \\]", plain, flags=re.M), (page, option)
    for example in examples:
        assert f"\n{example}\n" in plain, (page, example)
    subcommands = help_text.partition("\nSubcommands:\n")[2].partition("\n\n")[0]
    for subcommand in re.findall(r"^ {2}(\S+)", subcommands, flags=re.M):
        check_manual([*command, subcommand])


if __name__ == "__main__":
    assert varimarch("--version") == f"varimarch {VERSION}\n"
    assert "16 x 16 x 16" in varimarch("info", "procedural:shells:16x16x16")
    # The library finds the installed decoder by itself.
    assert (PREFIX / "lib/varimarch/varimarch-decode").is_file()
    with tempfile.TemporaryDirectory() as folder:
        varimarch("convert", "procedural:shells:8x8x8", f"{folder}/shells.vti")
        assert "8 x 8 x 8" in varimarch("info", f"{folder}/shells.vti")
    scenes = sorted((PREFIX / "share/varimarch/Scenes").glob("*.json"))
    assert scenes, "no scenes are installed"
    check_manual(["varimarch"])
