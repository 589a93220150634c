#!/usr/bin/env python3
"""Checks that the packets of a set of instructions define nothing but the marches of tiles.

Usage: check_packet_symbols.py NM OBJECT...

If the compiler emits an inline function in such an object, of GLM for example, the linker may
choose this copy for the whole program, which then crashes on a processor without the instructions.
"""

import subprocess
import sys

nm, *objects = sys.argv[1:]
command = [nm, "--demangle", "--defined-only", "--extern-only", "--no-sort", *objects]
lines = subprocess.run(command, capture_output=True, check=True, text=True).stdout.splitlines()
symbols = [line.split(maxsplit=2)[2] for line in lines if line.count(" ") >= 2]
strangers = [symbol for symbol in symbols if not symbol.startswith("void varimarch::MarchTile<")]
for symbol in strangers:
    print(f"{symbol}: give it internal linkage, or have it inlined (the build must be optimised)")
print(f"{len(symbols)} symbols, of which {len(strangers)} should not be there")
sys.exit(1 if strangers or not symbols else 0)
