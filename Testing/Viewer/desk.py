"""A screen of its own with a window manager, on which programs are used by keys and mouse and seen
by their pixels."""

import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import time

WIDTH, HEIGHT = 1280, 800
MOST_SECONDS = 90
SETTINGS = "[notice]\nread=true\n"


def missing_package():
    """The Debian package that a desk lacks, if any."""
    for program, package in {"Xvfb": "xvfb", "openbox": "openbox", "xdotool": "xdotool"}.items():
        if not shutil.which(program):
            return package
    try:
        import numpy  # noqa: F401
    except ImportError:
        return "python3-numpy"
    return None


def wait_for(condition, what, seconds=MOST_SECONDS):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.1)
    raise AssertionError(f"this never happened: {what}")


def ink(pixels):
    """The mask of the white letters that the viewer draws over its pictures."""
    return (pixels > 200).all(axis=2)


def colour_count(pixels):
    import numpy

    return len(numpy.unique(pixels.reshape(-1, 3), axis=0))


class Desk:
    """An X server with a window manager. The server writes its pixels into a file."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        settings = self.folder / "home/.config/varimarch/varimarch-viewer.conf"
        settings.parent.mkdir(parents=True)
        settings.write_text(SETTINGS)
        (self.folder / "screen").mkdir()
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-noreset", "-screen", "0", f"{WIDTH}x{HEIGHT}x24",
             "-fbdir", self.folder / "screen"], pass_fds=[write], stderr=subprocess.DEVNULL)
        self.environment = {**os.environ, "DISPLAY": ":" + os.read(read, 16).decode().strip(),
                            "HOME": str(self.folder / "home"), "QT_QPA_PLATFORM": "xcb"}
        for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "WAYLAND_DISPLAY"):
            self.environment.pop(name, None)
        self.manager = subprocess.Popen(["openbox"], env=self.environment, stderr=subprocess.DEVNULL)

    def pixels(self):
        """The screen, row by row: red, green and blue. The server's file is one of xwd."""
        import numpy

        content = (self.folder / "screen/Xvfb_screen0").read_bytes()
        header = struct.unpack(">25I", content[:100])
        size, width, height, line, colours = header[0], header[4], header[5], header[12], header[19]
        start = size + 12 * colours
        rows = numpy.frombuffer(content, numpy.uint8, line * height, start).reshape(height, line)
        return rows[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1]

    def do(self, *words):
        """Uses the keys and the mouse, in the words of xdotool."""
        done = subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True,
                              capture_output=True, text=True)
        return done.stdout

    def end(self):
        for process in (self.manager, self.server):
            process.terminate()
            process.wait()


class Viewer:
    """The program, on the whole screen of a desk."""

    # Rows and columns of parts of the window when all views are shown.
    VIEWS = (slice(94, 768), slice(2, 890))
    VOLUME = (slice(94, 768), slice(2, 554))
    CORNER = (slice(98, 152), slice(5, 330))
    AXIAL = (slice(94, 304), slice(564, 890))
    CORONAL = (slice(312, 520), slice(564, 890))

    def __init__(self, program, desk, *arguments):
        self.desk = desk
        self.process = subprocess.Popen([program, *arguments], env=desk.environment)
        self.window = wait_for(self._window, "the window appears")
        desk.do("windowactivate", "--sync", self.window, "windowmove", self.window, 0, 0,
                "windowsize", self.window, WIDTH, HEIGHT)

    def _window(self):
        found = subprocess.run(
            ["xdotool", "search", "--onlyvisible", "--name", "not for diagnostic use"],
            env=self.desk.environment, capture_output=True, text=True, check=False).stdout.split()
        return found[-1] if found else None

    def see(self, part):
        return self.desk.pixels()[part]

    def choose(self, words):
        """Runs a command of the palette by some words of its name."""
        self.desk.do("key", "ctrl+k")
        time.sleep(1)
        self.desk.do("type", words)
        time.sleep(0.5)
        self.desk.do("key", "Return")

    def report_width(self):
        """The width of the line below the time in the corner of the volume [pixels]."""
        import numpy

        letters = ink(self.see(self.CORNER))
        rows = numpy.flatnonzero(letters.any(axis=1))
        lines = numpy.split(rows, numpy.flatnonzero(numpy.diff(rows) > 1) + 1)
        lines = [line for line in lines if len(line) > 4]
        if len(lines) < 2:
            return 0
        columns = numpy.flatnonzero(letters[lines[1]].any(axis=0))
        return int(columns[-1] - columns[0])

    def end(self):
        self.process.kill()
        self.process.wait()


def run_case(case, program):
    """Calls a case with a desk, the program and a folder, which are gone afterwards."""
    with tempfile.TemporaryDirectory() as folder:
        desk = Desk(folder)
        try:
            case(desk, program, pathlib.Path(folder))
        finally:
            desk.end()
