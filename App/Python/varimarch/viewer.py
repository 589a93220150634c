"""A viewer of its own process, whose look a script changes and reads."""

import json
import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time
import weakref

import numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

from .arguments import number
from .pictures import image_of
from .vtk_messages import vtk_messages_as_exceptions

SECONDS_BETWEEN_QUESTIONS = 0.05


class Viewer:
    """Opens varimarch-viewer in a process of its own, and exchanges looks with it.

        viewer = varimarch.Viewer("head.nii.gz")
        viewer.look = "mr-head"                         # the name of a preset
        viewer.commit()                                 # the running picture changes
        look = viewer.look                              # with what the user has edited since
        look["shading"]["specular"] = 0.5
        viewer.look = look
        viewer.commit()

    volume: the path of a volume file, a folder with a DICOM series or a session; or an array
        [z, y, x] or a vtkImageData, which is passed in a temporary file that only this user can read.
    spacing: distances between the voxels of an array along x, y, z [mm]; default: 1, 1, 1.
    program: the viewer's program; default: the one on PATH.
    timeout: longest time for an answer and for opening the volume [s].

    The window stays open when the script ends, and the script goes on when the window is closed; the
    next commit() then raises a ConnectionError. The constructor raises OSError if the program is
    missing or cannot open the volume, with one sentence.
    """

    def __init__(self, volume, *, spacing=None, program="varimarch-viewer", timeout=120):
        self._timeout = number("timeout", timeout, 0.1, 1e6)
        self._pending = None
        self._folder = pathlib.Path(tempfile.mkdtemp(prefix="varimarch-"))
        self._clean = weakref.finalize(self, shutil.rmtree, self._folder, ignore_errors=True)
        self._end = time.monotonic() + self._timeout
        path, is_temporary = self._path_of(volume, spacing)
        self._process = self._started(program, path)
        try:
            self._socket = self._connected()
            self._lines = self._socket.makefile("rb")
            self._await_volume()
        except BaseException:
            self._process.terminate()
            raise
        if is_temporary:
            path.unlink()

    @property
    def look(self):
        """The look in the window, or the one that waits for commit(): a dictionary as in
        Documentation/SceneFormat.md. Assign one, or the name of a preset, to change it.
        """
        return self._ask({"get": "look"})["look"] if self._pending is None else self._pending

    @look.setter
    def look(self, look):
        if not isinstance(look, (dict, str)):
            raise TypeError(f"look: expected a dictionary or the name of a preset, found {look!r}")
        self._pending = look

    def commit(self):
        """Shows the look that was assigned, as an edit that the user can undo.

        Raises ValueError with one sentence if the look is not one; the window keeps its look.
        """
        if self._pending is not None:
            pending, self._pending = self._pending, None
            self._ask({"set": pending})

    def close(self):
        """Lets go of the window, which stays open."""
        self._lines.close()
        self._socket.close()
        self._clean()

    def _path_of(self, volume, spacing):
        if isinstance(volume, (str, os.PathLike)):
            if spacing is not None:
                raise ValueError("spacing: expected only with an array; a file has its own")
            return os.path.abspath(os.fspath(volume)), False
        path = self._folder / "volume.vti"
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(image_of(volume, spacing))
        writer.SetCompressorTypeToNone()
        writer.EncodeAppendedDataOff()
        try:
            with vtk_messages_as_exceptions(writer):
                writer.Write()
        except RuntimeError as error:
            raise OSError(str(error)) from None
        return path, True

    def _started(self, program, path):
        found = shutil.which(os.fspath(program))
        if found is None:
            raise FileNotFoundError(
                f"program: expected the viewer, found no program {os.fspath(program)!r} on PATH; "
                "install varimarch-viewer, or pass its path"
            )
        # A session of its own, so that an interrupted script does not interrupt the viewer.
        with open(self._folder / "messages", "wb") as messages:
            return subprocess.Popen(
                [found, "--listen", str(self._folder / "socket"), str(path)],
                stdin=subprocess.DEVNULL,
                stdout=messages,
                stderr=messages,
                start_new_session=True,
            )

    def _connected(self):
        while self._process.poll() is None:
            connection = socket.socket(socket.AF_UNIX)
            connection.settimeout(self._timeout)
            try:
                connection.connect(str(self._folder / "socket"))
                return connection
            except (FileNotFoundError, ConnectionRefusedError):
                connection.close()
            self._wait("the viewer does not answer")
        lines = (self._folder / "messages").read_text(errors="replace").split("\n")
        reason = next((line for line in lines if line.strip()), "no message")
        raise OSError(f"the viewer ended with code {self._process.returncode}: {reason}")

    def _await_volume(self):
        while True:
            answer = self._ask({"get": "status"})
            if answer["status"] == "shown":
                return
            if answer["status"] == "failed":
                raise OSError(answer["reason"])
            self._wait("the viewer does not show the volume")

    def _wait(self, problem):
        if time.monotonic() > self._end:
            raise TimeoutError(f"{problem}; expected within {self._timeout:g} s")
        time.sleep(SECONDS_BETWEEN_QUESTIONS)

    def _ask(self, request):
        text = json.dumps(request, default=plain)
        try:
            self._socket.sendall(text.encode() + b"\n")
            line = self._lines.readline()
        except TimeoutError:
            raise TimeoutError(
                f"the viewer does not answer; expected within {self._timeout:g} s"
            ) from None
        except (OSError, ValueError):  # the second is raised by a file that is closed
            line = b""
        if not line:
            raise ConnectionError("the viewer is closed; make another varimarch.Viewer")
        answer = json.loads(line)
        if "error" in answer:
            raise ValueError(answer["error"])
        return answer


def plain(value):
    """Returns the numbers of numpy as those of Python."""
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        return value.tolist()
    raise TypeError(f"look: expected numbers, texts, lists and dictionaries, found {value!r}")
