#!/usr/bin/env python3
"""varimarch archive get --move through TLS: who may send images to us, and our certificate.

Usage: test_return_port.py VARIMARCH CASE
"""

import contextlib
import pathlib
import socket
import ssl
import subprocess
import sys
import tempfile
import time

from certificates import make_certificate
from dimse_messages import requested_association

# The machine may be busy.
MOST_SECONDS = 30.0


def own_certificates_are_checked():
    """A key with a password would be asked for in the middle of a transfer."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        certificate = make_certificate(folder, "-passout", "pass:secret")
        for own in (certificate, folder / "server.key", folder / "own.pem", folder / "none.pem"):
            answer = subprocess.run(
                [sys.argv[1], "archive", "check", "dicoms://PACS@localhost:104"]
                + ["--certificate", certificate, "--own-certificate", str(own)],
                capture_output=True,
                text=True,
                stdin=subprocess.DEVNULL,
            )
            words = f'a certificate and its private key without a password in PEM in "{own}"'
            assert answer.returncode == 2 and words in answer.stderr, answer


def only_the_archive_may_send_images_through_tls():
    """While images are awaited, the port answers nobody but the owner of the archive's certificate."""
    with tempfile.TemporaryDirectory() as name, socket.create_server(("127.0.0.1", 0)) as silent:
        folders = [pathlib.Path(name) / part for part in ("archive", "us", "stranger")]
        certificates = []
        for folder in folders:
            folder.mkdir()
            certificates.append(make_certificate(folder))
        with socket.socket() as place:
            place.bind(("127.0.0.1", 0))
            back = place.getsockname()[1]
        archive = f"dicoms://FAKE@127.0.0.1:{silent.getsockname()[1]}"
        fetching = subprocess.Popen(
            [sys.argv[1], "archive", "get", archive, "--study", "1.2", "-o", name + "/images"]
            + ["--patience", "60", "--move", str(back)]
            + ["--certificate", certificates[0], "--own-certificate", str(folders[1] / "own.pem")],
            stderr=subprocess.DEVNULL,
        )
        try:
            wait_for_port(back)
            for key, is_answered in [
                (folders[2] / "own.pem", False),
                ("", False),
                (None, False),
                (folders[0] / "own.pem", True),
            ]:
                assert is_accepted(back, certificates[1], key) == is_answered, key
        finally:
            fetching.kill()
            fetching.wait()


def wait_for_port(port):
    end = time.monotonic() + MOST_SECONDS
    while time.monotonic() < end:
        with contextlib.suppress(OSError):
            socket.create_connection(("localhost", port)).close()
            return
        time.sleep(0.05)
    raise AssertionError("the port does not open")


def is_accepted(port, trusted, key):
    """Whether an association is accepted: without TLS if the key is None, without a certificate if it
    is empty."""
    try:
        with socket.create_connection(("localhost", port), timeout=MOST_SECONDS) as connection:
            if key is not None:
                context = ssl.create_default_context(cafile=trusted)
                if key:
                    context.load_cert_chain(key)
                connection = context.wrap_socket(connection, server_hostname="localhost")
            connection.sendall(requested_association())
            return connection.recv(1)[:1] == b"\x02"
    except OSError:
        return False


if __name__ == "__main__":
    globals()[sys.argv[2]]()
