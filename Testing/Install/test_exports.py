#!/usr/bin/env python3
"""The shared library exports its VTK classes and what else has its export macro, and nothing more.

Usage: test_exports.py LIBRARY FOLDER, the library and the folder of its headers.
"""

import pathlib
import re
import subprocess
import sys

# Instances of the standard library's templates: its headers make them visible, in every C++ library.
# The type descriptions of functions, which std::function and std::shared_ptr keep, are visible too.
STANDARD_LIBRARY = re.compile(r"_Z(T[ISTV]|GV)?Z?(NK?)?(St|9__gnu_cxx)|_ZT[IS]P?F")
LINKER = {"__bss_start", "_edata", "_end"}


def exported_symbols(library):
    """The symbols that other libraries and programs can bind to, demangled."""
    lines = output_of("nm", "--dynamic", "--defined-only", library).splitlines()
    named = [line.split()[1:] for line in lines]
    # VTK's headers make its inline functions visible, as weak symbols, in every library that calls them.
    symbols = [name for kind, name in named if not (kind == "W" and re.match(r"_ZNK?\d+vtk", name))]
    ours = [symbol for symbol in symbols if not STANDARD_LIBRARY.match(symbol)]
    return [symbol for symbol in output_of("c++filt", *ours).splitlines() if symbol not in LINKER]


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def marked_names(folder):
    """The classes and the functions with the macro, without the namespaces and classes around them."""
    text = "\n".join(path.read_text() for path in folder.rglob("*.[hc]*"))
    classes = re.findall(r"\b(?:class|struct) VARIMARCHVOLUME_EXPORT (\w+)", text)
    functions = re.findall(r"VARIMARCHVOLUME_EXPORT\s+(?!class|struct)[\w:<>*&\s]+?(\w+)\(", text)
    return set(classes), set(functions)


def is_of(symbol, classes, functions):
    """True for a function with the macro, and for all that belongs to a class with the macro."""
    # "typeinfo for vtkThing", "non-virtual thunk to vtkThing::Render()".
    entity = re.sub(r"^[\w -]+ (for|to) |\[abi:\w+\]", "", symbol)
    *scopes, name = entity.partition("(")[0].split("::")
    return name in functions or not classes.isdisjoint([*scopes, name])


if __name__ == "__main__":
    symbols = exported_symbols(sys.argv[1])
    marked = marked_names(pathlib.Path(sys.argv[2]))
    strangers = [symbol for symbol in symbols if not is_of(symbol, *marked)]
    print(f"{len(symbols)} symbols are exported, {len(strangers)} of them without the macro:")
    print("\n".join(strangers))
    sys.exit(1 if strangers or not symbols else 0)
