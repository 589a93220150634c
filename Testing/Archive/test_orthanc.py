#!/usr/bin/env python3
"""varimarch archive, with a real Orthanc on this computer.

Usage: test_orthanc.py VARIMARCH CASE
Exit code 77 if Orthanc or its plugin for DICOMweb is not installed.
"""

import base64
import contextlib
import json
import os
import pathlib
import shutil
import socket
import ssl
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request

import dicom_file
from certificates import make_certificate

PLUGIN = pathlib.Path("/usr/share/orthanc/plugins/libOrthancDicomWeb.so")
SKIPPED = 77
SIZE = 5
STUDY = "1.2.826.0.1.77"
SERIES = STUDY + ".1"


def free_port():
    with socket.socket() as place:
        place.bind(("127.0.0.1", 0))
        return place.getsockname()[1]


def phantom_pixels(number):
    return [100 * number + 7 * i - 50 for i in range(SIZE * (SIZE - 1))]


class Orthanc:
    """Orthanc with an empty storage of its own, as long as the block."""

    def __init__(self, folder, secure=False, asks_us=False):
        self.folder = folder
        self.dicom, self.http, self.back = free_port(), free_port(), free_port()
        self.certificate = str(folder / "server.crt")
        settings = {
            "StorageDirectory": str(folder / "storage"),
            "IndexDirectory": str(folder / "storage"),
            "Plugins": [str(PLUGIN)],
            "HttpPort": self.http,
            "RemoteAccessAllowed": False,
            "AuthenticationEnabled": secure,
            "RegisteredUsers": {"jane": "secret"},
            "DicomAet": "ORTHANC",
            "DicomPort": self.dicom,
            "DicomCheckCalledAet": True,
            "DicomAlwaysAllowStore": True,
            "DicomAlwaysAllowFind": True,
            "DicomAlwaysAllowGet": True,
            "DicomAlwaysAllowMove": True,
            "DicomModalities": {
                "us": {
                    "AET": "VARIMARCH",
                    "Host": "127.0.0.1",
                    "Port": self.back,
                    "UseDicomTls": secure,
                }
            },
            "DicomWeb": {"Enable": True, "Root": "/dicom-web/"},
        }
        if secure:
            make_certificate(folder)
            (folder / "us").mkdir()
            ours = make_certificate(folder / "us")
            trusted = folder / "trusted.crt"
            trusted.write_text(pathlib.Path(ours).read_text())
            settings |= {
                "DicomTlsEnabled": True,
                "DicomTlsCertificate": self.certificate,
                "DicomTlsPrivateKey": str(folder / "server.key"),
                "DicomTlsTrustedCertificates": str(trusted),
                "DicomTlsRemoteCertificateRequired": asks_us,
            }
        (folder / "orthanc.json").write_text(json.dumps(settings))
        self.log = (folder / "log").open("w")
        self.process = subprocess.Popen(
            ["Orthanc", str(folder / "orthanc.json")], stdout=self.log, stderr=self.log
        )

    def __enter__(self):
        for _ in range(300):
            try:
                self.rest("/system")
                return self
            except OSError:
                assert self.process.poll() is None, (self.folder / "log").read_text()[-2000:]
                time.sleep(0.1)
        raise AssertionError("Orthanc does not answer")

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(30)
        self.log.close()

    def rest(self, path, data=None):
        """The answer of Orthanc's own interface, which is not DICOM's."""
        request = urllib.request.Request(
            f"http://localhost:{self.http}{path}", data
        )
        request.add_header("Authorization", "Basic " + base64.b64encode(b"jane:secret").decode())
        with urllib.request.urlopen(request) as answer:
            return answer.read()

    def stored(self):
        """All stored files, by the UID of their image."""
        files = {}
        for name in json.loads(self.rest("/instances")):
            uid = json.loads(self.rest(f"/instances/{name}"))["MainDicomTags"]["SOPInstanceUID"]
            files[uid] = self.rest(f"/instances/{name}/file")
        return files

    def dimse(self):
        return f"dicom://ORTHANC@localhost:{self.dicom}"

    def web(self):
        return f"http://localhost:{self.http}/dicom-web"


@contextlib.contextmanager
def encrypted(port, certificate, key):
    """A port that forwards what comes in TLS to another one: Orthanc 1.10.1 of Debian 12 crashes
    when it speaks HTTPS itself."""
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(certificate, key)
    listening = socket.create_server(("127.0.0.1", 0))

    def pipe(source, sink):
        with contextlib.suppress(OSError):
            while block := source.recv(65536):
                sink.sendall(block)
            sink.shutdown(socket.SHUT_RDWR)

    def accept():
        with contextlib.suppress(OSError):
            while True:
                connection, _ = listening.accept()
                with contextlib.suppress(OSError):
                    inner = context.wrap_socket(connection, server_side=True)
                    outer = socket.create_connection(("localhost", port))
                    for ends in ((inner, outer), (outer, inner)):
                        threading.Thread(target=pipe, args=ends, daemon=True).start()

    threading.Thread(target=accept, daemon=True).start()
    yield listening.getsockname()[1]
    listening.close()


def write_phantom(folder, patient="Doe^Jane", study=STUDY, date="20261126"):
    files = []
    for number in range(1, 4):
        path = folder / f"{study}-{number}.dcm"
        path.write_bytes(
            dicom_file.ct_slice(
                patient=patient,
                patient_id="id-" + patient[:3],
                study=study,
                series=study + ".1",
                number=number,
                pixels=phantom_pixels(number),
                size=SIZE,
                date=date,
            )
        )
        files.append(str(path))
    return files


def run(*arguments, fails_with=None, **variables):
    """The output of varimarch archive; its error if it is to fail."""
    answer = subprocess.run(
        [sys.argv[1], "archive", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, **variables},
    )
    # The program announces steps of a second or more, such as "searching ...".
    errors = [line for line in answer.stderr.splitlines() if not line.endswith("ing ...")]
    text = answer.stdout if fails_with is None else "\n".join(errors)
    assert answer.returncode == (0 if fails_with is None else fails_with), answer
    return text


def rows_of(table):
    return [line.split("\t") for line in table.splitlines()[1:]]


def check_fetched(folder):
    """The files are the phantom, and the program that draws reads them as one volume."""
    pixels = sorted(dicom_file.pixels_of(path.read_bytes()) for path in folder.iterdir())
    assert pixels == [phantom_pixels(number) for number in (1, 2, 3)], pixels
    described = subprocess.run([sys.argv[1], "info", folder], capture_output=True, text=True)
    assert described.returncode == 0 and f"{SIZE} x {SIZE - 1} x 3" in described.stdout, described


def walk(archive, orthanc, folder, *options, **variables):
    """Stores the phantom, finds and fetches it."""
    assert "answers" in run("check", archive, *options, **variables)
    run("send", archive, *write_phantom(folder), *options, **variables)
    stored = orthanc.stored()
    assert len(stored) == 3
    for number in (1, 2, 3):
        assert dicom_file.pixels_of(stored[f"{SERIES}.{number}"]) == phantom_pixels(number)
    (study,) = rows_of(run("find", archive, *options, **variables))
    assert study == [STUDY, "20261126", "CT", "id-Doe", "Doe^Jane", "Phantom study"], study
    (series,) = rows_of(run("find", archive, "--study", STUDY, *options, **variables))
    assert series == [SERIES, "7", "CT", "3", "Phantom series"], series
    run("get", archive, "--study", STUDY, "-o", folder / "study", *options, **variables)
    check_fetched(folder / "study")
    run("get", archive, "--study", STUDY, "--series", SERIES, "-o", folder / "series", *options, **variables)
    check_fetched(folder / "series")
    missing = run("get", archive, "--study", "1.2.3.99", "-o", folder / "no", *options, fails_with=1, **variables)
    assert archive in missing and missing.count("\n") == 0, missing


def dimse(folder):
    with Orthanc(folder) as orthanc:
        walk(orthanc.dimse(), orthanc, folder)


def web(folder):
    with Orthanc(folder) as orthanc:
        walk(orthanc.web(), orthanc, folder)


def move(folder):
    with Orthanc(folder) as orthanc:
        run("send", orthanc.dimse(), *write_phantom(folder))
        fetch = ["get", orthanc.dimse(), "--study", STUDY, "--move", orthanc.back]
        run(*fetch, "-o", folder / "moved")
        check_fetched(folder / "moved")
        with socket.create_server(("", orthanc.back)):
            refused = run(*fetch, "-o", folder / "none", fails_with=1)
            assert f"the port {orthanc.back}, which another program uses" in refused, refused


def words(folder):
    """A search finds what it is asked for, by both protocols."""
    with Orthanc(folder) as orthanc:
        run("send", orthanc.dimse(), *write_phantom(folder))
        other = "1.2.826.0.1.88"
        run("send", orthanc.web(), *write_phantom(folder, "Major^Tom", other, "20200229"))
        for archive in (orthanc.dimse(), orthanc.web()):
            for option, found in [
                (["--patient-name", "Maj"], {other}),
                (["--patient-name", "*Tom"], {other}),
                (["--patient-id", "id-Doe"], {STUDY}),
                (["--date", "20200101-20201231"], {other}),
                (["--date", "20210101-"], {STUDY}),
                (["--modality", "CT"], {STUDY, other}),
                (["--modality", "MR"], set()),
                (["--patient-name", "a&limit=0"], set()),
            ]:
                rows = rows_of(run("find", archive, *option))
                assert {row[0] for row in rows} == found, (archive, option, rows)


def picture(folder):
    """A picture that the program draws is stored as it is, by both protocols, without a name."""
    with Orthanc(folder) as orthanc:
        for archive in (orthanc.dimse(), orthanc.web()):
            path = folder / f"{archive[:4]}.dcm"
            subprocess.run(
                [sys.argv[1], "render", "procedural:torso:16x16x16", "-o", path, "--size", "32x24"],
                check=True,
                capture_output=True,
            )
            before = set(orthanc.stored())
            run("send", archive, path)
            (uid,) = set(orthanc.stored()) - before
            assert orthanc.stored()[uid][-32 * 24 * 3 :] == path.read_bytes()[-32 * 24 * 3 :]
        names = {row[4] for row in rows_of(run("find", orthanc.dimse()))}
        assert names == {""}, names


def secure(folder):
    """TLS for DIMSE, with a certificate that must be known."""
    with Orthanc(folder, secure=True) as orthanc:
        dicoms = orthanc.dimse().replace("dicom:", "dicoms:")
        walk(dicoms, orthanc, folder, "--certificate", orthanc.certificate)
        unknown = run("check", dicoms, "--certificate", stranger(folder), fails_with=1)
        assert dicoms in unknown and unknown.count("\n") == 0, unknown
        assert "certificate" in run("check", dicoms, fails_with=2)


def secure_move(folder):
    """An archive that knows its clients by certificates sends by C-MOVE over TLS."""
    with Orthanc(folder, secure=True, asks_us=True) as orthanc:
        dicoms = orthanc.dimse().replace("dicom:", "dicoms:")
        archive = [dicoms, "--certificate", orthanc.certificate]
        own = ["--own-certificate", folder / "us" / "own.pem"]
        run("check", *archive, fails_with=1)
        run("send", *archive, *own, *write_phantom(folder))
        fetch = ["--study", STUDY, "--move", orthanc.back]
        run("get", *archive, *own, *fetch, "-o", folder / "moved")
        check_fetched(folder / "moved")
        none = run("get", *archive, *fetch, "-o", folder / "none", fails_with=2)
        assert "our own certificate for encrypted C-MOVE" in none, none
        certificate, key = (pathlib.Path(path).read_text() for path in
            (stranger(folder), folder / "us" / "server.key"))
        (folder / "mixed.pem").write_text(certificate + key)
        mixed = ["--own-certificate", folder / "mixed.pem"]
        unfit = run("get", *archive, *mixed, *fetch, "-o", folder / "none", fails_with=1)
        assert "do not fit each other" in unfit and unfit.count("\n") == 0, unfit


def secure_web(folder):
    """HTTPS with a certificate that must be known, and a password."""
    with Orthanc(folder, secure=True) as orthanc:
        with encrypted(orthanc.http, orthanc.certificate, folder / "server.key") as port:
            https = f"https://localhost:{port}/dicom-web"
            user = ["--certificate", orthanc.certificate, "--user", "jane"]
            walk(https, orthanc, folder, *user, VARIMARCH_ARCHIVE_PASSWORD="secret")
            wrong = run("find", https, *user, fails_with=1, VARIMARCH_ARCHIVE_PASSWORD="wrong")
            assert "refuses" in wrong, wrong
            for options in ([], ["--certificate", stranger(folder)]):
                unknown = run("check", https, *options, fails_with=1)
                assert "certificate" in unknown.lower() and unknown.count("\n") == 0, unknown


def stranger(folder):
    """The certificate of somebody else."""
    (folder / "stranger").mkdir()
    return make_certificate(folder / "stranger")


def main():
    if not shutil.which("Orthanc") or not PLUGIN.exists():
        print("Orthanc is not installed; install the packages orthanc and orthanc-dicomweb.")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        globals()[sys.argv[2]](pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
