"""NIfTI files for the tests of programs and of the Python package."""

import struct


def nifti_of_times(path, values, step_s=2, has_place=False):
    """Writes 3 x 4 x 5 bytes at several times: all voxels of a time have the next of the values."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 4, 3, 4, 5, len(values), 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8)
    struct.pack_into("<8f", header, 76, 1, 1, 1, 1, step_s, 1, 1, 1)
    struct.pack_into("<f", header, 108, 352)
    header[123] = 2 + 8  # mm and s
    struct.pack_into("<h", header, 254, int(has_place))
    struct.pack_into("<12f", header, 280, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)
    header[344:348] = b"n+1\0"
    path.write_bytes(header + b"".join(bytes([value]) * 60 for value in values))
    return path
