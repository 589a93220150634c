"""Writes and reads small DICOM files, in explicit little endian, without any library (PS3.5, PS3.10)."""

import struct

CT_CLASS = "1.2.840.10008.5.1.4.1.1.2"
SYNTAX = "1.2.840.10008.1.2.1"
PIXEL_DATA = 0x7FE00010


def element(tag, kind, value):
    """The bytes of an attribute."""
    value += b"\0" * (len(value) % 2) if kind in ("UI", "OB", "OW") else b" " * (len(value) % 2)
    head = struct.pack("<HH2s", tag >> 16, tag & 0xFFFF, kind.encode())
    is_long = kind in ("OB", "OW")
    return head + (struct.pack("<2xI", len(value)) if is_long else struct.pack("<H", len(value))) + value


def ct_slice(*, patient, patient_id, study, series, number, pixels, size, date="20261126"):
    """A file with a CT image: 16 bit pixels, rows of `size` numbers."""
    instance = f"{series}.{number}"
    texts = {
        0x00080016: ("UI", CT_CLASS),
        0x00080018: ("UI", instance),
        0x00080020: ("DA", date),
        0x00080060: ("CS", "CT"),
        0x00081030: ("LO", "Phantom study"),
        0x0008103E: ("LO", "Phantom series"),
        0x00100010: ("PN", patient),
        0x00100020: ("LO", patient_id),
        0x00180050: ("DS", "1"),
        0x0020000D: ("UI", study),
        0x0020000E: ("UI", series),
        0x00200011: ("IS", "7"),
        0x00200013: ("IS", str(number)),
        0x00200032: ("DS", f"0\\0\\{number}"),
        0x00200037: ("DS", "1\\0\\0\\0\\1\\0"),
        0x00280004: ("CS", "MONOCHROME2"),
        0x00280030: ("DS", "1\\1"),
        0x00281052: ("DS", "0"),
        0x00281053: ("DS", "1"),
    }
    shorts = {
        0x00280002: 1,
        0x00280010: len(pixels) // size,
        0x00280011: size,
        0x00280100: 16,
        0x00280101: 16,
        0x00280102: 15,
        0x00280103: 1,
    }
    elements = {tag: element(tag, kind, text.encode()) for tag, (kind, text) in texts.items()}
    elements |= {tag: element(tag, "US", struct.pack("<H", value)) for tag, value in shorts.items()}
    elements[PIXEL_DATA] = element(PIXEL_DATA, "OW", struct.pack(f"<{len(pixels)}h", *pixels))
    return with_head(b"".join(elements[tag] for tag in sorted(elements)), instance)


def with_head(data, instance):
    head = b"".join(
        element(tag, "UI", text.encode())
        for tag, text in [(0x00020002, CT_CLASS), (0x00020003, instance), (0x00020010, SYNTAX)]
    )
    length = element(0x00020000, "UL", struct.pack("<I", len(head)))
    return b"\0" * 128 + b"DICM" + length + head + data


def pixels_of(data):
    """The pixels of a file in explicit little endian whose last attribute they are."""
    mark = struct.pack("<HH2s2x", PIXEL_DATA >> 16, PIXEL_DATA & 0xFFFF, b"OW")
    place = data.rindex(mark) + len(mark)
    (length,) = struct.unpack_from("<I", data, place)
    return list(struct.unpack_from(f"<{length // 2}h", data, place + 4))
