#!/usr/bin/env python3
"""Reads from the built programs and libraries that the compiler and the linker have hardened them.

Usage: test_hardening.py READELF BINARY...
"""

import re
import subprocess
import sys


def read(readelf, *options):
    return subprocess.run([readelf, "--wide", *options], capture_output=True, text=True,
                          check=True).stdout


def faults(readelf, binary):
    """What is missing, in words."""
    header = read(readelf, "--file-header", binary)
    segments = read(readelf, "--segments", binary)
    dynamic = read(readelf, "--dynamic", binary)
    imported = {re.split(r"[@ ]", line.split()[7])[0]
                for line in read(readelf, "--dyn-syms", binary).splitlines()
                if " UND " in line and len(line.split()) > 7}
    is_program = "INTERP" in segments
    if "DYN" not in re.search(r"Type:\s+(\w+)", header).group(1):
        yield "a random address (PIE): CMAKE_POSITION_INDEPENDENT_CODE"
    if is_program and not re.search(r"FLAGS_1\).*\bPIE\b", dynamic):
        yield "a random address (PIE): check_pie_supported()"
    if "GNU_RELRO" not in segments:
        yield "read-only tables of addresses: -z relro"
    if not re.search(r"\(BIND_NOW\)|FLAGS\).*BIND_NOW|FLAGS_1\).*\bNOW\b", dynamic):
        yield "tables of addresses that are filled at the start: -z now"
    if not re.search(r"GNU_STACK\s+(?:0x\w+\s+){5}RW\s", segments):
        yield "a stack without code: no object may ask for an executable one"
    if "__stack_chk_fail" not in imported:
        yield "guarded stacks: -fstack-protector-strong"
    # A small library may have no copy whose size the compiler knows.
    if is_program and not any(re.fullmatch(r"__\w+_chk", name) for name in imported):
        yield "checked copies: -D_FORTIFY_SOURCE=2"


def main():
    readelf, *binaries = sys.argv[1:]
    missing = [f"{binary}: expected {fault}; see VarimarchHardening in CMakeLists.txt"
               for binary in binaries for fault in faults(readelf, binary)]
    print("\n".join(missing) or f"{len(binaries)} binaries are hardened")
    sys.exit(1 if missing else 0)


main()
