#!/usr/bin/env python3
"""Lists the viewer's texts that lack a translation.

Usage: check_translations.py LUPDATE SOURCES FILE.ts...
Exit code 77 if any do, since a change of a text need not come with all translations.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

SOME_MISSING = 77


def untranslated(lupdate, sources, translation, folder):
    """Source texts for which the file has no finished translation."""
    copy = pathlib.Path(folder) / translation.name
    shutil.copy(translation, copy)
    subprocess.run(
        [lupdate, "-silent", "-recursive", sources, "-I", sources.parent, "-ts", copy], check=True
    )
    messages = xml.etree.ElementTree.parse(copy).iter("message")
    return [
        message.findtext("source")
        for message in messages
        if message.find("translation").get("type") == "unfinished"
    ]


def main():
    lupdate, sources, *translations = sys.argv[1:]
    missing = 0
    for path in map(pathlib.Path, translations):
        with tempfile.TemporaryDirectory() as folder:
            for text in untranslated(lupdate, pathlib.Path(sources), path, folder):
                print(f"{path.name}: no translation of {text!r}")
                missing += 1
    print(f"{missing} translations are missing.")
    return SOME_MISSING if missing else 0


if __name__ == "__main__":
    sys.exit(main())
