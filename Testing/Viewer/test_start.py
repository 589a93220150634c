#!/usr/bin/env python3
"""Starts the viewer where it cannot work, or takes its display away: it ends with one sentence
instead of a crash.

Usage: test_start.py VIEWER XVFB_RUN
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

VIEWER, XVFB_RUN = sys.argv[1:]


def sentence(text):
    lines = [line for line in text.splitlines() if line.startswith("varimarch-viewer: ")]
    assert len(lines) == 1, text
    return lines[0]


def without_display(home):
    """There is no display, or none that answers."""
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
    for display in ({}, {"DISPLAY": ":77"}):
        done = subprocess.run([VIEWER], env={**environment, **display, "HOME": home}, check=False,
                              capture_output=True, text=True, timeout=60)
        assert done.returncode == 1, f"exit code {done.returncode}: {done.stderr}"
        assert "no window can be opened" in sentence(done.stderr), done.stderr


def without_opengl(home):
    """The display has no OpenGL, or one that is too old. The sentence is in a box too, which waits."""
    for screen, environment in (("-extension GLX", {}), ("", {"MESA_GL_VERSION_OVERRIDE": "2.1"})):
        process = subprocess.Popen(
            [XVFB_RUN, "--auto-servernum", "--server-args", f"-screen 0 640x480x24 {screen}", VIEWER],
            env={**os.environ, **environment, "HOME": home, "QT_QPA_PLATFORM": "xcb"},
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True)
        try:
            told = ""
            while "varimarch-viewer: " not in told:
                line = process.stderr.readline()
                assert line, f"the viewer ended with {process.wait()}: {told}"
                told += line
            assert "OpenGL 3.2" in sentence(told), told
        finally:
            os.killpg(process.pid, signal.SIGTERM)
            process.wait(timeout=30)


def display_that_ends(home):
    """The display ends while a volume is shown and the presets are drawn: no crash, but a code."""
    volume = pathlib.Path(home) / "a.nrrd"
    header = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 40 40 40\nencoding: raw\n\n"
    volume.write_bytes(header.encode() + bytes(i % 251 for i in range(40**3)))
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24"],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    try:
        environment = {**os.environ, "HOME": home, "QT_QPA_PLATFORM": "xcb",
                       "DISPLAY": ":" + os.read(read, 16).decode().strip()}
        process = subprocess.Popen([VIEWER, volume], env=environment, text=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        while not any("volume" in log.read_text() for log in pathlib.Path(home).rglob("*.log")):
            assert process.poll() is None, process.stderr.read()
            time.sleep(0.1)
        time.sleep(0.5)
    finally:
        server.kill()
        server.wait()
    _, told = process.communicate(timeout=60)
    assert process.returncode == 1, f"exit code {process.returncode}: {told}"
    assert "X11 connection broke" in told, told


with tempfile.TemporaryDirectory() as folder:
    without_display(folder)
    without_opengl(folder)
    display_that_ends(folder)
