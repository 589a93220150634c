#!/usr/bin/env python3
"""Drives the real viewer from Python, as a script does, on a display of its own.

Usage: test_viewer_from_python.py VIEWER CASE
"""

import os
import pathlib
import shutil
import socket
import stat
import subprocess
import sys
import tempfile
import time

import numpy
import varimarch

PROGRAM = sys.argv[1]
SKIPPED = 77


def ball(side=24):
    """Values that fall from 500 at the centre to below 0 in the corners."""
    z, y, x = numpy.mgrid[-1 : 1 : side * 1j, -1 : 1 : side * 1j, -1 : 1 : side * 1j]
    return (500 - 400 * numpy.sqrt(x * x + 2 * y * y + z * z)).astype(numpy.int16)


def opened(volume, **arguments):
    return varimarch.Viewer(volume, program=PROGRAM, **arguments)


def end(viewer):
    """Ends the viewer."""
    viewer._process.terminate()
    viewer._process.wait(timeout=60)


def looks_go_both_ways(_folder):
    viewer = opened(ball(), spacing=(1, 1, 2))
    assert viewer.look["domain"] == "data", "values are in units of the data"
    viewer.look = "ct-bone"
    assert viewer.look == "ct-bone", "what waits for commit()"
    viewer.commit()
    look = viewer.look
    assert look["name"] == "ct-bone"
    look["opacities"] = [{"value": numpy.float32(0), "opacity": 0}, {"value": 300, "opacity": 0.5}]
    viewer.look = look
    viewer.commit()
    assert viewer.look["opacities"] == [{"value": 0, "opacity": 0}, {"value": 300, "opacity": 0.5}]
    viewer.commit()  # nothing waits
    try:
        viewer.look = {"colors": []}
        viewer.commit()
        raise AssertionError("a look without colours was shown")
    except ValueError as error:
        assert "expected an array of 1" in str(error) and "\n" not in str(error), error
    assert viewer.look["opacities"][1]["value"] == 300
    end(viewer)


def edits_of_the_user_are_read_back(_folder):
    if not shutil.which("xdotool"):
        sys.exit(SKIPPED)
    viewer = opened(ball())
    first = viewer.look
    viewer.look = "ct-lung"
    viewer.commit()
    window = subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", "Varimarch"],
                            check=True, capture_output=True, text=True).stdout.split()[0]
    subprocess.run(["xdotool", "windowfocus", "--sync", window, "key", "ctrl+z"], check=True)
    for _ in range(200):
        if viewer.look == first:
            break
        time.sleep(0.05)
    assert viewer.look == first, "Ctrl+Z takes the script's look back"
    end(viewer)


def each_side_ends_without_the_other(folder):
    script = "import sys, numpy, varimarch; viewer = varimarch.Viewer(numpy.load(sys.argv[2]), " \
             "program=sys.argv[1]); print(viewer._process.pid)"
    numpy.save(folder / "ball.npy", ball())
    ended = subprocess.run([sys.executable, "-c", script, PROGRAM, folder / "ball.npy"],
                           check=True, capture_output=True, text=True)
    process = int(ended.stdout)
    time.sleep(1)
    os.kill(process, 0)  # raises if the viewer has ended too
    os.kill(process, 15)

    viewer = opened(ball())
    end(viewer)
    viewer.look = "ct-bone"
    try:
        viewer.commit()
        raise AssertionError("a closed viewer took a look")
    except ConnectionError as error:
        assert "viewer is closed" in str(error)
    viewer.close()


def arrays_pass_through_a_private_file_that_goes(_folder):
    viewer = opened(ball())
    private = viewer._folder
    assert stat.S_IMODE(private.stat().st_mode) == 0o700
    assert not (private / "volume.vti").exists(), "read, and no longer needed"
    viewer.close()
    assert not private.exists()
    end(viewer)


def what_is_wrong_is_one_sentence(folder):
    (folder / "bad.nrrd").write_text("NRRD0004\ntype: short\n")
    cases = (
        (OSError, "bad.nrrd", lambda: opened(folder / "bad.nrrd")),
        (OSError, "missing.nrrd", lambda: opened(folder / "missing.nrrd")),
        (FileNotFoundError, "varimarch-viewer", lambda: varimarch.Viewer(ball(), program="no-such")),
        (ValueError, "spacing", lambda: opened(folder / "bad.nrrd", spacing=(1, 1, 1))),
        (ValueError, "shape", lambda: opened(numpy.zeros((3, 3)))),
    )
    for kind, words, action in cases:
        try:
            action()
        except kind as error:
            assert words in str(error) and "\n" not in str(error), repr(str(error))
        else:
            raise AssertionError(f"no {kind.__name__} with {words!r}")


def bad_messages_leave_the_viewer_well(_folder):
    viewer = opened(ball())
    messages = (b"", b"{", b"\xff\x00\n"[:2], b'{"set": ' + b"[" * 1000, b" " * (2 << 20), b'{"get": 3}')
    with socket.socket(socket.AF_UNIX) as connection:
        connection.connect(str(viewer._folder / "socket"))
        lines = connection.makefile("rb")
        for message in messages:
            connection.sendall(message + b"\n")
            answer = lines.readline()
            assert answer.startswith(b'{"error":'), answer
    assert viewer.look["domain"] == "data"
    end(viewer)


def nothing_listens_unless_asked(folder):
    with subprocess.Popen([PROGRAM], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as viewer:
        time.sleep(3)
        descriptors = pathlib.Path(f"/proc/{viewer.pid}/fd")
        own = {os.readlink(one) for one in descriptors.iterdir()}
        listening = [
            line for line in pathlib.Path("/proc/net/unix").read_text().splitlines()[1:]
            if line.split()[3] == "00010000" and f"socket:[{line.split()[6]}]" in own
        ]
        viewer.terminate()
    assert not listening, listening


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        settings = folder / "config/varimarch/varimarch-viewer.conf"
        settings.parent.mkdir(parents=True)
        settings.write_text("[notice]\nread=true\n")
        os.environ.update(XDG_CONFIG_HOME=str(folder / "config"), XDG_DATA_HOME=str(folder / "data"))
        globals()[sys.argv[2]](folder)


if __name__ == "__main__":
    main()
