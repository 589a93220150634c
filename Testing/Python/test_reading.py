#!/usr/bin/env python3
"""Volumes that the Python package reads in part: one of several times, or the voxels in their file.

Usage: test_reading.py CASE
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import warnings

import numpy
import varimarch

from nifti_files import nifti_of_times


def volumes_larger_than_memory_stay_in_their_file(folder):
    ramp = numpy.arange(24**3, dtype="<u2").reshape(24, 24, 24)
    header = "NRRD0004\ntype: uint16\ndimension: 3\nsizes: 24 24 24\nendian: little\nencoding: raw\n"
    header += "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
    header += "#" + "." * ((len(header) + 3) % 2) + "\n\n"  # voxels begin at an even byte
    path = folder / "ramp.nrrd"
    path.write_bytes(header.encode() + ramp.tobytes())
    on_disk = varimarch.read(path, memory=20000)
    assert (folder / "ramp.nrrd.varimarch-ranges").exists()
    arguments = {"size": (40, 30), "opacity": [(0, 0), (15000, 0.2)]}
    expected = varimarch.render(varimarch.read(path), **arguments)
    assert (varimarch.render(on_disk, **arguments) == expected).all()
    assert (varimarch.render(on_disk, detail="coarse", **arguments) != expected).any()


def volumes_on_disk_leave_signals_to_the_program(folder):
    """The signal of a page that cannot be read ends the program if another program sends it."""
    (folder / "voxels.raw").write_bytes(bytes(24**3))
    code = ("import os, signal, sys, varimarch\n"
            "reader = varimarch.vtkVolumeFileReader()\n"
            "reader.SetFileName(sys.argv[1])\n"
            "reader.SetRawDimensions(24, 24, 24)\n"
            "reader.SetMaximumHostMemory(20000)\n"
            "reader.Update()\n"
            "print(reader.HasVoxelsOnDisk(), flush=True)\n"
            "os.kill(os.getpid(), signal.SIGBUS)\n")
    done = subprocess.run([sys.executable, "-c", code, folder / "voxels.raw"],
                          stdout=subprocess.PIPE, text=True)
    assert done.stdout == "True\n" and done.returncode != 0, done


def volumes_on_disk_are_released_by_copies_of_a_process(folder):
    """A copy has no thread that watches the memory, and must not wait for its end."""
    (folder / "voxels.raw").write_bytes(bytes(24**3))
    reader = varimarch.vtkVolumeFileReader()
    reader.SetFileName(str(folder / "voxels.raw"))
    reader.SetRawDimensions(24, 24, 24)
    reader.SetMaximumHostMemory(20000)
    reader.Update()
    assert reader.HasVoxelsOnDisk()
    for _ in range(20):
        copy = os.fork()
        if copy == 0:
            signal.alarm(10)
            reader.GetOutput().Initialize()
            reader.Modified()
            reader.Update()
            reader.GetOutput().Initialize()
            os._exit(0)
        assert os.waitpid(copy, 0)[1] == 0


def times_are_read_one_by_one(folder):
    path = nifti_of_times(folder / "times.nii", range(3), has_place=True)
    assert list(varimarch.times(path)) == [0, 2, 4]
    for time in (2, 0, 1):
        assert (varimarch.to_array(varimarch.read(path, time=time)) == time).all(), time
    for arguments, expected in (({}, 1), ({"time": 0}, 0)):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            varimarch.read(path, **arguments)
        told = [warning for warning in caught if "holds 3 times" in str(warning.message)]
        assert len(told) == expected, (arguments, caught)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[1]](pathlib.Path(name))
