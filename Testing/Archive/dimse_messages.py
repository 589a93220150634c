"""The bytes of messages of DIMSE (PS3.7, PS3.8)."""

import struct

import dicom_file

RELEASE_REQUEST = bytes([5, 0, 0, 0, 0, 4, 0, 0, 0, 0])
RELEASE_ANSWER = bytes([6, 0, 0, 0, 0, 4, 0, 0, 0, 0])


def item(kind, content):
    """A part of a message about an association (PS3.8 9.3.2)."""
    return struct.pack(">BxH", kind, len(content)) + content


def association(kind, called, calling, context):
    application = item(0x10, b"1.2.840.10008.3.1.1.1")
    user = item(0x50, item(0x51, struct.pack(">I", 16384)) + item(0x52, b"1.2.3.4"))
    titles = called.ljust(16) + calling.ljust(16)
    content = struct.pack(">Hxx", 1) + titles + bytes(32) + application + context + user
    return struct.pack(">BxI", kind, len(content)) + content


def accepted_association(encoding=b"1.2.840.10008.1.2"):
    """A-ASSOCIATE-AC that accepts the first context, usually in implicit little endian (PS3.8 9.3.3)."""
    context = item(0x21, bytes([1, 0, 0, 0]) + item(0x40, encoding))
    return association(2, b"FAKE", b"VARIMARCH", context)


def requested_association():
    """A-ASSOCIATE-RQ for CT images, from the archive to us (PS3.8 9.3.2)."""
    syntaxes = item(0x30, dicom_file.CT_CLASS.encode()) + item(0x40, dicom_file.SYNTAX.encode())
    context = item(0x20, bytes([1, 0, 0, 0]) + syntaxes)
    return association(1, b"VARIMARCH", b"FAKE", context)


def implicit(tag, value):
    """The bytes of an attribute in implicit little endian."""
    value += b" " * (len(value) % 2)
    return struct.pack("<HHI", tag >> 16, tag & 0xFFFF, len(value)) + value


def find_answer(answered, data):
    """C-FIND-RSP with a data set, or the last one without (PS3.7 9.3.2.2, PS3.8 9.3.5)."""
    fields = [
        (0x00000002, b"1.2.840.10008.5.1.4.1.2.2.1\0"),
        (0x00000100, b"\x20\x80"),
        (0x00000120, answered),
        (0x00000800, b"\0\0" if data else b"\x01\x01"),
        (0x00000900, b"\0\xff" if data else b"\0\0"),
    ]
    command = b"".join(implicit(*field) for field in fields)
    command = implicit(0, struct.pack("<I", len(command))) + command

    def part(flags, content):
        return struct.pack(">IBB", len(content) + 2, 1, flags) + content

    parts = part(3, command)
    message = struct.pack(">BxI", 4, len(parts)) + parts
    if data:
        parts = part(2, data)
        message += struct.pack(">BxI", 4, len(parts)) + parts
    return message
