#!/usr/bin/env python3
"""varimarch archive, with servers that are silent, end in the middle, or send nonsense.

Usage: test_bad_archives.py VARIMARCH CASE
Each ends in one sentence that names the archive, within the patience that it was given.
"""

import contextlib
import json
import os
import pathlib
import random
import socket
import subprocess
import sys
import tempfile
import threading
import time

import dicom_file
from dimse_messages import (
    RELEASE_ANSWER,
    RELEASE_REQUEST,
    accepted_association,
    find_answer,
    implicit,
)

PATIENCE = 1.0
# Much longer than the patience: the machine may be busy. A program that waits on is killed later.
MOST_SECONDS = 30.0


@contextlib.contextmanager
def server(serve):
    """A server that calls serve(connection) for each connection, in a thread. Yields its port."""
    listening = socket.create_server(("127.0.0.1", 0))
    open_connections = []

    def accept():
        with contextlib.suppress(OSError):
            while True:
                connection, _ = listening.accept()
                open_connections.append(connection)
                with contextlib.suppress(OSError):
                    serve(connection)

    threading.Thread(target=accept, daemon=True).start()
    yield listening.getsockname()[1]
    for connection in open_connections:
        connection.close()
    listening.shutdown(socket.SHUT_RDWR)
    listening.close()


def sentence(*arguments):
    """The only line that the program prints as it fails."""
    start = time.monotonic()
    answer = subprocess.run(
        [sys.argv[1], "archive", *arguments, "--patience", str(PATIENCE)],
        capture_output=True,
        text=True,
        timeout=4 * MOST_SECONDS,
    )
    assert answer.returncode == 1, answer
    # The program announces steps of a second or more, such as "searching ...".
    lines = [line for line in answer.stderr.splitlines() if not line.endswith("ing ...")]
    assert len(lines) == 1 and lines[0].endswith(".") and arguments[1] in lines[0], answer.stderr
    assert not lines[0].endswith(".."), lines[0]
    assert time.monotonic() - start < MOST_SECONDS
    return lines[0]


def dimse(port):
    return f"dicom://FAKE@127.0.0.1:{port}"


def web(port):
    return f"http://127.0.0.1:{port}/dicom-web"


def read_request(connection):
    request = b""
    while b"\r\n\r\n" not in request:
        more = connection.recv(65536)
        if not more:
            break
        request += more


def answering(*parts, pause=0.0, closes=True):
    """A server of HTTP that sends these bytes."""

    def serve(connection):
        read_request(connection)
        for part in parts:
            connection.sendall(part)
            time.sleep(pause)
        if closes:
            connection.close()

    return serve


def silent_servers_are_not_waited_for():
    with server(lambda connection: None) as port:
        assert "has been silent for 1 s" in sentence("check", web(port))
        sentence("check", dimse(port))
    head = b"HTTP/1.1 200 OK\r\nContent-Length: 500\r\nContent-Type: application/json\r\n\r\n["
    with server(answering(head, closes=False)) as port:
        assert "has been silent for 1 s" in sentence("find", web(port))


def nobody_at_the_port_is_told():
    with socket.socket() as place:
        place.bind(("127.0.0.1", 0))
        for archive in (dimse, web):
            sentence("check", archive(place.getsockname()[1]))


def connections_that_end_are_told():
    with server(lambda connection: connection.close()) as port:
        for archive in (dimse, web):
            sentence("check", archive(port))
    accepted = accepted_association()

    def end_after_accepting(connection):
        connection.recv(65536)
        connection.sendall(accepted)
        connection.recv(65536)
        connection.close()

    with server(end_after_accepting) as port:
        sentence("check", dimse(port))
        sentence("find", dimse(port))


def connections_that_end_while_a_file_is_sent_are_told():
    size = 1024
    image = dicom_file.ct_slice(
        patient="", patient_id="", study="1.2", series="1.3", number=1, pixels=[0] * size**2, size=size
    )

    def end_in_the_middle(connection):
        connection.recv(65536)
        connection.sendall(accepted_association(dicom_file.SYNTAX.encode()))
        connection.recv(1000)
        connection.close()

    with server(end_in_the_middle) as port, tempfile.NamedTemporaryFile() as file:
        file.write(image)
        file.flush()
        told = sentence("send", dimse(port), file.name)
        # Whether the data or the end of the connection is met first is chance.
        assert "it has stopped receiving" in told or "it has ended the connection" in told, told


def silence_after_a_greeting_is_not_waited_for():
    def serve(connection):
        connection.recv(65536)
        connection.sendall(accepted_association())

    with server(serve) as port:
        assert "has been silent for 1 s" in sentence("check", dimse(port))


def nonsense_is_told():
    noise = random.Random(1).randbytes(4096)
    with server(lambda connection: connection.sendall(noise)) as port:
        sentence("check", dimse(port))

    def answer_with_nonsense(connection):
        connection.recv(65536)
        connection.sendall(accepted_association() + b"\x04\x00\x00\x00\x00\x20" + b"\xff" * 32)

    with server(answer_with_nonsense) as port:
        sentence("find", dimse(port))
    for body in (b"{}", b"[1, 2", b"<html>", b"\xff\xfe"):
        with server(answering(page(body))) as port:
            assert "not a list in JSON" in sentence("find", web(port))


def page(body, kind=b"application/dicom+json", status=b"200 OK"):
    length = str(len(body)).encode()
    return b"HTTP/1.1 %s\r\nContent-Type: %s\r\nContent-Length: %s\r\n\r\n%s" % (
        status,
        kind,
        length,
        body,
    )


def refusals_are_told():
    with server(answering(page(b"", status=b"401 Unauthorized"))) as port:
        assert "asks for a user and a password" in sentence("check", web(port))
    with server(answering(page(b"", status=b"500 Oh"))) as port:
        assert "status 500" in sentence("check", web(port))


def redirections_are_not_followed():
    """A password reaches only the server that the user has named."""
    visits = []
    with server(visits.append) as elsewhere:
        moved = (
            b"HTTP/1.1 302 Found\r\nLocation: http://127.0.0.1:%d/\r\nContent-Length: 0\r\n\r\n"
        )
        with server(answering(moved % elsewhere)) as port:
            assert f"to \"http://127.0.0.1:{elsewhere}/\"" in sentence("check", web(port))
    assert not visits


def errors_without_an_end_are_not_read():
    def serve(connection):
        read_request(connection)
        connection.sendall(b"HTTP/1.1 500 Oh\r\nContent-Type: text/plain\r\n\r\n")
        deadline = time.monotonic() + MOST_SECONDS
        while time.monotonic() < deadline:
            connection.sendall(bytes(1024))
            time.sleep(0.001)

    with server(serve) as port:
        assert "status 500" in sentence("find", web(port))


def damaged_images_leave_a_sentence():
    multipart = b'multipart/related; type="application/dicom"; boundary="==b"'
    part = b"--==b\r\nContent-Type: application/dicom\r\n\r\nDICM bytes"
    for body, words in [
        (part, "ends early"),
        (part + b"\r\n--==b\r\n", "ends early"),
        (b"x" * 200000, "not in parts"),
        (b"--==b--", "no image"),
    ]:
        with server(answering(page(body, multipart))) as port:
            with tempfile.TemporaryDirectory() as folder:
                told = sentence("get", web(port), "--study", "1.2", "-o", folder)
                assert words in told, told
    with server(answering(page(part, b"application/json"))) as port:
        with tempfile.TemporaryDirectory() as folder:
            sentence("get", web(port), "--study", "1.2", "-o", folder)


def images_in_small_pieces_are_whole():
    body = (
        b"--==b\r\nContent-Location: ../../evil\r\n\r\nfirst\r\n--==x\r\n--==b\r\n\r\nsecond\r\n--==b--\r\n"
    )
    multipart = b"multipart/related; boundary===b; type=application/dicom"
    message = page(body, multipart)
    pieces = [message[i : i + 3] for i in range(0, len(message), 3)]
    with server(answering(*pieces, pause=0.001)) as port, tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            [sys.argv[1], "archive", "get", web(port), "--study", "1.2", "-o", folder],
            check=True,
            capture_output=True,
            timeout=MOST_SECONDS,
        )
        files = {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
        assert files == {"image-1.dcm": b"first\r\n--==x", "image-2.dcm": b"second"}, files


def passwords_do_not_cross_the_network_in_clear():
    answer = subprocess.run(
        [sys.argv[1], "archive", "check", "http://pacs.example/dicom-web", "--user", "jane"],
        capture_output=True,
        text=True,
        env={**os.environ, "VARIMARCH_ARCHIVE_PASSWORD": "secret"},
    )
    assert answer.returncode == 1 and "expected https for a password" in answer.stderr, answer
    assert "secret" not in answer.stderr


def addresses_are_checked():
    for address, words in [
        ("pacs", "a URL such as"),
        ("ftp://host/", "a URL such as"),
        ("dicom://host:104", "title before '@'"),
        ("dicom://A_TITLE_THAT_IS_TOO_LONG@host:104", "title before '@'"),
        ("dicom://PACS@host", "a port"),
        ("dicoms://PACS@host:104", "the certificate"),
        ("https://jane:secret@host/", "no password in the URL"),
        ("https://host/ --certificate missing.crt", "a certificate in PEM in \"missing.crt\""),
        (f"dicoms://PACS@host:104 --certificate {__file__}", "a certificate in PEM"),
        (f"dicom://PACS@host:104 --own-certificate {__file__}", "dicoms: for a certificate"),
    ]:
        answer = subprocess.run(
            [sys.argv[1], "archive", "check", *address.split()], capture_output=True, text=True
        )
        assert answer.returncode == 2 and words in answer.stderr, answer
        assert "secret" not in answer.stderr


def names_in_unknown_characters_are_not_guessed():
    """A text that is read in another set of characters is another name."""
    studies = [
        (b"ISO_IR 100", b"M\xfcller^Ute", "M\u00fcller^Ute"),
        (b"ISO_IR 999", b"M\xfcller^Ute", ""),
        (b"", b"M\xfcller^Ute", ""),
        (b"ISO_IR 192", b"M\xfcller^Ute", ""),
        (b"ISO 2022 IR 999", b"\x1b$B;3ED", ""),
        (b"ISO_IR 999", b"Doe^Jane", "Doe^Jane"),
    ]

    def serve(connection):
        connection.recv(65536)
        connection.sendall(accepted_association())
        request = b""
        number = b"\x00\x00\x10\x01\x02\x00\x00\x00"  # the tag of the message's number
        while number not in request or b"1.2.840.10008.5.1.4.1.2.2.1" not in request:
            request += connection.recv(65536)
        answered = request[request.index(number) + 8 :][:2]
        for charset, patient, _ in studies:
            texts = [(0x00080005, charset), (0x00081030, b"Plain"), (0x00100010, patient)]
            connection.sendall(find_answer(answered, b"".join(implicit(*one) for one in texts)))
        connection.sendall(find_answer(answered, b""))
        while RELEASE_REQUEST not in request:
            request += connection.recv(65536)
        connection.sendall(RELEASE_ANSWER)

    with server(serve) as port:
        answer = subprocess.run(
            [sys.argv[1], "archive", "find", dimse(port)], capture_output=True, timeout=MOST_SECONDS
        )
    rows = [line.split("\t") for line in answer.stdout.decode().splitlines()[1:]]
    assert [row[4:] for row in rows] == [[name, "Plain"] for _, _, name in studies], rows
    assert b"Texts of 4 entries were left out" in answer.stderr, answer.stderr


def other_texts_than_uids_are_not_asked_for():
    """A server of DIMSE takes an empty text or a wild card for all studies."""
    nobody = 9
    for archive in (dimse(nobody), web(nobody)):
        for uid in ("", "*", "1.2\\1.3", "../../admin"):
            with tempfile.TemporaryDirectory() as folder:
                answer = subprocess.run(
                    [sys.argv[1], "archive", "get", archive, "--study", uid, "-o", folder],
                    capture_output=True,
                    text=True,
                )
                assert answer.returncode == 1 and "expected a UID" in answer.stderr, answer


def control_characters_do_not_reach_the_terminal():
    """Terminals obey those below 0x20, and those of Unicode up to 0x9f."""
    body = json.dumps([{"00081030": {"Value": ["a\x1b[2Jb\x9b2Jc\x7fd\u00e9"]}}]).encode()
    with server(answering(page(body))) as port:
        answer = subprocess.run(
            [sys.argv[1], "archive", "find", web(port)],
            capture_output=True,
            check=True,
            timeout=MOST_SECONDS,
        )
    assert answer.stdout.decode().splitlines()[1].endswith("\ta [2Jb 2Jc d\u00e9"), answer


if __name__ == "__main__":
    globals()[sys.argv[2]]()
