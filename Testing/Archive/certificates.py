"""Makes certificates for TLS, with OpenSSL's own program."""

import subprocess


def make_certificate(folder, *options):
    """Makes a certificate for this computer, signed by itself. Returns the path of the file with the
    certificate alone; own.pem beside it holds its private key too."""
    certificate, key = folder / "server.crt", folder / "server.key"
    subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-days", "2", *(options or ["-nodes"])]
        + ["-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost"]
        + ["-keyout", key, "-out", certificate],
        check=True,
        capture_output=True,
    )
    (folder / "own.pem").write_text(certificate.read_text() + key.read_text())
    return str(certificate)
