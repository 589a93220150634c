#!/usr/bin/env python3
"""Shows a folder as a FUSE file system, and stops when a file is read beyond its first megabyte.

A program that reads such a file then waits like one whose network disk is gone.

Usage: serve_until_stopped.py FOLDER MOUNTED
"""

import os
import signal
import sys

import fuse

fuse.fuse_python_api = (0, 2)


class Folder(fuse.Fuse):
    source = None

    def getattr(self, path):
        return os.lstat(self.source + path)

    def open(self, path, flags):
        return 0

    def read(self, path, size, offset):
        if offset + size > 1000000:
            os.kill(os.getpid(), signal.SIGSTOP)
        with open(self.source + path, "rb") as file:
            file.seek(offset)
            return file.read(size)


Folder.source = sys.argv[1]
server = Folder(dash_s_do="setsingle")
server.parse([sys.argv[2], "-f", "-s"], errex=1)
server.main()
