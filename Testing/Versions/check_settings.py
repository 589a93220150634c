#!/usr/bin/env python3
"""Every setting of VTK's volume classes has a decision in settings.csv, and the source agrees with it.

Usage: check_settings.py [FOLDER...]. A folder has VTK's headers, in itself or below: an installed
include folder, or VTK's sources. Without a folder, only the table itself is checked.

Columns of settings.csv: the class; the setting, without "Set", and with "Add" or "Select" where a
method is named so; the version of VTK that added it, 9.1 for older ones; the decision; and the
reason, if a setting has no effect. The decisions:
  alias      another name, in VTK too, for the setting in the last column
  forwarded  the GPU mapper passes it on to ours (ForwardSettings)
  read       our module reads it from VTK's object, by the setting's getter
  inherited  code of VTK that our classes inherit or call applies it, before or after the drawing
  vtk        if it is used, VTK's mapper draws the picture, and our mapper alone gives a message
  none       it has no effect on a picture of ours; the reason says why that loses nothing
"""

import csv
import pathlib
import re
import sys

TABLE = pathlib.Path(__file__).with_name("settings.csv")
MODULE = pathlib.Path(__file__).resolve().parents[2] / "VolumeModule"
CLASSES = (
    "vtkVolumeProperty vtkVolume vtkMultiVolume vtkAbstractVolumeMapper vtkVolumeMapper "
    "vtkGPUVolumeRayCastMapper vtkOpenGLGPUVolumeRayCastMapper"
).split()
DECISIONS = {"alias", "forwarded", "read", "inherited", "vtk", "none"}


def code_of(path):
    """A file of C++ without comments."""
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", path.read_text(errors="replace"), flags=re.S)


def public_text(header):
    """The public part of a class."""
    text = code_of(header)
    text = text[text.find("\npublic:") :]
    parts = re.split(r"^\s*(public|protected|private):", text, flags=re.M)
    return "".join(body for label, body in zip(parts[1::2], parts[2::2]) if label == "public")


def settings_of(header):
    """Names of the settings of a class: those of its macros, and of its methods."""
    text = public_text(header)
    names = set(re.findall(r"\bvtkSet\w*Macro\(\s*(\w+)", text))
    for verb, name in re.findall(r"\b(Set|Add|Select)([A-Z]\w*)\s*\(", text):
        names.add(name if verb == "Set" else verb + name)
    # SetMaskTypeToBinary() is a shortcut of SetMaskType().
    return {
        name
        for name in names
        if not any(name != other and name.startswith(other + "To") for other in names)
    }


def headers_below(folder):
    """The header of each class that the folder has."""
    found = {path.stem: path for path in pathlib.Path(folder).rglob("vtk*Volume*.h")}
    return {name: found[name] for name in CLASSES if name in found}


def text_of_module():
    """The texts in which each kind of decision must be found."""
    files = [path for suffix in ("*.h", "*.cxx") for path in MODULE.rglob(suffix)]
    adapter = code_of(MODULE / "vtkVariationFieldGPUVolumeRayCastMapper.cxx")
    versions = code_of(MODULE / "VtkVersions.h")
    return {
        "forwarded": adapter + versions,
        "read": "".join(map(code_of, files)),
        "vtk": adapter + versions,
    }


def is_applied(name, decision, texts):
    """True if the source does what the decision says."""
    bare = re.sub("^(Add|Select)", "", name)
    patterns = {
        "forwarded": rf"->(Set|Select|){bare}\b",
        "read": rf"->(Get|Has|){bare}s?(Function)?\(",
        "vtk": rf"->(Get|){bare}\b",
    }
    return decision not in patterns or re.search(patterns[decision], texts[decision])


def faults_of_table(rows):
    """Rows that the source contradicts, or that say too little."""
    texts = text_of_module()
    names = {(row["class"], row["setting"]) for row in rows}
    for row in rows:
        where = f"{TABLE.name}: {row['class']}, {row['setting']}"
        if row["decision"] not in DECISIONS:
            yield f"{where}: decision {row['decision']}: expected one of {sorted(DECISIONS)}"
        elif row["decision"] == "none" and not row["reason"]:
            yield f"{where}: a setting without effect needs a reason"
        elif row["decision"] == "alias" and (row["class"], row["reason"]) not in names:
            yield f"{where}: an alias of {row['reason']}, which the table does not have"
        elif not is_applied(row["setting"], row["decision"], texts):
            yield f"{where}: decided \"{row['decision']}\", but VolumeModule does not do it"


def faults_of_headers(rows, folder):
    """Settings in the headers of a folder that have no decision."""
    decided = {(row["class"], row["setting"]) for row in rows}
    headers = headers_below(folder)
    for name in CLASSES:
        if name not in headers:
            yield f"{folder}: expected the header {name}.h, found none"
            continue
        for setting in sorted(settings_of(headers[name])):
            if (name, setting) not in decided:
                yield (
                    f"{headers[name]}: nobody has decided about {name}::{setting}; honour it, or "
                    f"leave the picture to VTK's mapper, and add it to {TABLE.name}"
                )


def main():
    with TABLE.open(newline="") as file:
        rows = list(csv.DictReader(file))
    faults = list(faults_of_table(rows))
    for folder in sys.argv[1:]:
        faults += faults_of_headers(rows, folder)
    print("\n".join(faults) or f"{len(rows)} settings are decided; {len(sys.argv) - 1} VTKs read")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
