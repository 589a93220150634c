#!/usr/bin/env python3
"""Takes from varimarch what it needs: disk space, memory, OpenGL, processors, its input.

Whatever is missing, the program ends by itself, with exit code 1 and one sentence that names the
cause, leaves the file that was there before as it was, and nothing else beside it.

Usage: test_starvation.py VARIMARCH CASE
"""

import os
import pathlib
import random
import resource
import shutil
import signal
import stat
import struct
import subprocess
import sys
import tempfile
import threading
import time

VOLUME = "procedural:torso:48x40x32"
OLD = b"the file that was there before"
SKIPPED = 77
NOBODY = 65534
MEGABYTE = 1 << 20


def run(*arguments, before=lambda: None, output=subprocess.DEVNULL, **environment):
    """The ended program. `before` runs in the new process before the program."""
    def prepare():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        before()
    return subprocess.run(
        [sys.argv[1], *map(str, arguments)], stdout=output, stderr=subprocess.PIPE, text=True,
        errors="replace", check=False, timeout=100, preexec_fn=prepare,
        env={**os.environ, **environment})


def check_sentence(done, *words):
    """The program has ended by itself, and its one message has these words."""
    assert done.returncode == 1, f"exit code {done.returncode}: {done.stderr}"
    lines = [line for line in done.stderr.splitlines()
             if line.startswith("varimarch: ") and not line.startswith("varimarch: warning")]
    assert len(lines) == 1, done.stderr
    assert "ERR|" not in done.stderr and "terminate called" not in done.stderr, done.stderr
    for word in words:
        assert word in lines[0], f"{word!r} is missing in {lines[0]!r}"


def outputs(folder):
    """Every kind of file that the program writes: its path, and the arguments that write it."""
    render = ["render", VOLUME, "--size", "200x200", "-o"]
    yield folder / "a.png", [*render, folder / "a.png"]
    yield folder / "b.json", [*render, folder.parent / "b.png", "--json", folder / "b.json"]
    yield folder / "c.json", ["info", VOLUME, "--json", folder / "c.json"]
    for name in ("d.nii", "e.nii.gz", "f.nrrd", "g.mha", "h.vti", "i.tif", "j.tiff"):
        yield folder / name, ["convert", VOLUME, folder / name, "--overwrite"]
    for name in ("reference.png", "ours.png", "side-by-side.png", "compare.csv", "compare.json"):
        yield folder / name, ["compare", VOLUME, "-o", folder, "--size", "32x32", "--rounds", "1"]


def fail_at_every_output(folder, reasons, **how):
    """Every output fails for one of the reasons, and the old files stay as they were."""
    count = 0
    for path, arguments in outputs(folder):
        writable = os.access(folder, os.W_OK) and not how.get("is_full")
        if writable and not path.exists():
            path.write_bytes(OLD)
        earlier = {file: file.read_bytes() for file in folder.iterdir() if file.name != "filler"}
        done = run(*arguments, before=how.get("before", lambda: None))
        check_sentence(done, "cannot be written")
        assert any(reason in done.stderr for reason in reasons), done.stderr
        for file, content in earlier.items():
            assert file.read_bytes() == content, f"{file} has changed"
        assert not list(folder.glob("*.part*")), "an unfinished file is left"
        count += 1
    print(f"{count} outputs")


def file_size_limit(folder):
    """As on a full disk. Without a handler, the signal SIGXFSZ would end the program."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_FSIZE, (300, 300))
    (folder / "out").mkdir()
    os.environ["XDG_CACHE_HOME"] = str(folder / "cache")
    fail_at_every_output(folder / "out", ["File too large"], before=limit)


def full_disk(folder):
    """A file system in memory that is full."""
    disk = folder / "disk"
    disk.mkdir()
    mounted = os.geteuid() == 0 and subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=64k", "none", disk], check=False,
        stderr=subprocess.DEVNULL).returncode == 0
    if not mounted:
        sys.exit(SKIPPED)
    try:
        for path, _ in outputs(disk):
            path.write_bytes(OLD)
        try:
            (disk / "filler").write_bytes(bytes(MEGABYTE))
        except OSError:
            pass
        fail_at_every_output(disk, ["No space left"], is_full=True)
    finally:
        subprocess.run(["umount", disk], check=True)


def read_only(folder):
    """A folder without the permission to write, and files that are protected themselves."""
    def drop():
        # Root may write everywhere.
        if os.geteuid() == 0:
            os.setgroups([])
            os.setgid(NOBODY)
            os.setuid(NOBODY)
    program = folder / "varimarch"
    shutil.copy(sys.argv[1], program)
    for part in (folder, program):
        part.chmod(0o755)
    if subprocess.run([program, "--version"], preexec_fn=drop, check=False,
                      capture_output=True).returncode != 0:
        sys.exit(SKIPPED)  # the libraries are where only root reads
    sys.argv[1] = str(program)
    os.environ["HOME"] = str(folder)
    out = folder / "out"
    out.mkdir()
    (folder / "b.png").touch()
    (folder / "b.png").chmod(0o666)
    folder.chmod(0o777)
    for path, _ in outputs(out):
        path.write_bytes(OLD)
        path.chmod(0o444)
    out.chmod(0o777)
    fail_at_every_output(out, ["Permission denied"], before=drop, is_full=True)
    out.chmod(0o555)
    fail_at_every_output(out, ["Permission denied"], before=drop, is_full=True)


def devices(folder):
    """Names of devices and pipes are refused, not replaced by files. What cannot be printed fails."""
    pipe = folder / "pipe.png"
    os.mkfifo(pipe)
    check_sentence(run("render", VOLUME, "-o", pipe), str(pipe), "expected the name of a file")
    for path in (pipe, "/dev/full", folder):
        kind = stat.S_IFMT(os.stat(path).st_mode)
        check_sentence(
            run("info", VOLUME, "--json", path), str(path), "expected the name of a file")
        assert stat.S_IFMT(os.stat(path).st_mode) == kind, path
    with open("/dev/full", "w") as full:
        check_sentence(run("info", VOLUME, output=full), "standard output", "No space left")


def smallest_memory(kind):
    """The least limit with which the program's libraries can be loaded [MB]."""
    for megabytes in range(10, 600, 10):
        def limit(size=megabytes * MEGABYTE):
            resource.setrlimit(kind, (size, size))
        if run("--version", before=limit).returncode == 0:
            return megabytes
    raise AssertionError("the program needs more than 600 MB to start")


def memory(folder):
    """Less memory than is needed, in small steps."""
    scan = folder / "scan.nrrd"
    assert run("convert", "procedural:torso:160x160x160", scan).returncode == 0
    tried, failed = 0, 0
    for kind in (resource.RLIMIT_AS, resource.RLIMIT_DATA):
        start = smallest_memory(kind)
        for arguments in (["info", scan], ["convert", scan, folder / "a.nii.gz", "--overwrite"],
                          ["convert", scan, folder / "a.vti", "--overwrite"],
                          ["render", scan, "-o", folder / "a.png", "--size", "128x128"],
                          ["render", scan, "-o", folder / "a.png", "--renderer", "ours-shader"]):
            for megabytes in [start + more for more in (0, 8, 16, 80, 240, 480)]:
                def limit(size=megabytes * MEGABYTE):
                    resource.setrlimit(kind, (size, size))
                for path in (folder / "a.nii.gz", folder / "a.vti", folder / "a.png"):
                    path.write_bytes(OLD)
                done = run(*arguments, before=limit)
                tried += 1
                if done.returncode == 0:
                    continue
                failed += 1
                try:
                    check_sentence(done)
                except AssertionError as problem:
                    raise AssertionError(f"{arguments} with {megabytes} MB: {problem}") from None
                for path in (folder / "a.nii.gz", folder / "a.vti", folder / "a.png"):
                    assert path.read_bytes() == OLD, f"{path} has changed"
                assert not list(folder.glob("*.part*")), "an unfinished file is left"
    print(f"{tried} runs, {failed} of them with too little memory")
    assert failed > 10


def sizes(folder):
    """Files that promise, or hold, more than fits."""
    huge = folder / "huge.raw"
    with open(huge, "wb") as file:
        file.truncate(4000 * MEGABYTE)
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (2000 * MEGABYTE, 2000 * MEGABYTE))
    done = run("info", huge, "--raw-dimensions", "2000x1000x1000", "--raw-type", "uint16",
               before=limit)
    check_sentence(done, "memory")
    (folder / "lie.nrrd").write_text("NRRD0004\ntype: short\ndimension: 3\nsizes: 100000 100000 "
                                     "1000\nencoding: raw\n\n")
    check_sentence(run("info", folder / "lie.nrrd"), "lie.nrrd")


def no_opengl(folder):
    """No driver, and one that is too old."""
    for environment in ({"__EGL_VENDOR_LIBRARY_DIRS": "/nonexistent"},
                        {"LIBGL_DRIVERS_PATH": "/nonexistent"},
                        {"MESA_GL_VERSION_OVERRIDE": "2.1"}):
        for arguments in (["render", VOLUME, "-o", folder / "a.png"],
                          ["compare", VOLUME, "-o", folder / "out", "--size", "32x32"]):
            done = run(*arguments, DISPLAY="", **environment)
            check_sentence(done, "OpenGL 3.2", "libgl1-mesa-dri")
    assert not list(folder.rglob("*.p*")), "nothing is written"
    for display in ("", ":77"):
        assert run("render", VOLUME, "-o", folder / "a.png", "--size", "32x32",
                   DISPLAY=display).returncode == 0, "no display is needed"


def pipes(folder):
    """A pipe instead of a file is refused: reading it would wait for its writer."""
    for name in ("a.json", "a.nii", "a.vp", "a.raw", "a.plist", "a.nrrd", "a"):
        os.mkfifo(folder / name)
    for name in ("a.json", "a.nii", "a.raw", "a.nrrd", "a"):
        check_sentence(run("render", folder / name, "-o", folder / "b.png"), name)
        check_sentence(run("info", folder / name), name)
    for name in ("a.json", "a.vp", "a.plist"):
        check_sentence(run("render", VOLUME, "-o", folder / "b.png",
                           "--transfer-function", folder / name), name)


def changing_files(folder):
    """A file that is cut, or replaced by another one, while it is read."""
    numbers = random.Random(1)
    tried, failed = 0, 0
    for name in ("a.nrrd", "a.nii.gz", "a.mha", "a.vti", "a.tif"):
        whole = folder / f"whole-{name}"
        assert run("convert", "procedural:torso:200x200x200", whole).returncode == 0
        start = time.monotonic()
        assert run("info", whole).returncode == 0
        seconds = time.monotonic() - start
        for i in range(8):
            path = folder / name
            shutil.copy(whole, path)
            def change(path=path, whole=whole, how=i % 2):
                if how == 0:
                    os.truncate(path, whole.stat().st_size // 3)
                else:
                    (folder / "other").write_bytes(OLD)
                    os.replace(folder / "other", path)
            timer = threading.Timer(numbers.uniform(0, seconds), change)
            timer.start()
            done = run("info", path)
            timer.join()
            tried += 1
            if done.returncode != 0:
                failed += 1
                check_sentence(done, name)
    print(f"{tried} changes, {failed} of them noticed")


def deep_documents(folder):
    """Documents that nest without end, and entities that grow or read other files."""
    levels = 300000
    xml = '<?xml version="1.0"?>'
    deep = "<a>" * levels + "</a>" * levels
    entities = "".join(f'<!ENTITY l{i} "{f"&l{i - 1};" * 10}">' for i in range(1, 10))
    laughs = f'{xml}<!DOCTYPE l [<!ENTITY l0 "lol">{entities}]>'
    for name, text in (
        ("a.json", '{"colors":' + "[" * levels + "]" * levels + "}"),
        ("a.vp.json", '{"volumeProperties":' + "[" * levels + "]" * levels + "}"),
        ("a.plist", f'{xml}<plist version="1.0">{"<array>" * levels}{"</array>" * levels}</plist>'),
        ("a.xml", xml + deep), ("a.mrml", xml + deep), ("a.itf", xml + deep),
        ("b.xml", laughs + "<MRML>&l9;</MRML>"), ("b.itf", laughs + "<a>&l9;</a>"),
        ("b.plist", laughs + "<plist><string>&l9;</string></plist>"),
    ):
        (folder / name).write_text(text)
        check_sentence(run("render", VOLUME, "-o", folder / "b.png", "--transfer-function",
                           folder / name), name)
    arrays = b"".join(b"\xa1" + (i + 1).to_bytes(3, "big") for i in range(levels)) + b"\xd0"
    places = b"".join((8 + 4 * i).to_bytes(3, "big") for i in range(levels + 1))
    (folder / "c.plist").write_bytes(b"bplist00" + arrays + places + bytes(6) + bytes([3, 3]) +
                                     struct.pack(">QQQ", levels + 1, 0, 8 + len(arrays)))
    check_sentence(run("render", VOLUME, "-o", folder / "b.png", "--transfer-function",
                       folder / "c.plist"), "c.plist")
    for name, text in (("a.vti", f'{xml}<VTKFile type="ImageData">{deep}</VTKFile>'),
                       ("a.pvti", f'{xml}<VTKFile type="PImageData">{deep}</VTKFile>'),
                       ("b.vti", laughs + '<VTKFile type="ImageData">&l9;</VTKFile>')):
        (folder / name).write_text(text)
        check_sentence(run("info", folder / name), name)
    (folder / "s.json").write_text("[" * levels + "]" * levels)
    check_sentence(run("render", folder / "s.json", "-o", folder / "b.png"), "s.json")


def processors(folder):
    """One processor, and many more threads of the driver than processors, draw the same picture."""
    pictures = []
    for before, environment in ((lambda: None, {}), (lambda: os.sched_setaffinity(0, {0}), {}),
                                (lambda: None, {"LP_NUM_THREADS": "16"})):
        done = run("render", VOLUME, "-o", folder / "a.png", "--size", "200x150", before=before,
                   **environment)
        assert done.returncode == 0, done.stderr
        pictures.append((folder / "a.png").read_bytes())
    assert pictures[0] == pictures[1] == pictures[2]


def gone_disk(folder):
    """Ctrl+C ends the program even if the server of a file's file system answers no more."""
    source, mounted = folder / "source", folder / "mounted"
    source.mkdir()
    mounted.mkdir()
    for name in ("a.nrrd", "a.vti"):
        assert run("convert", "procedural:torso:160x160x160", source / name).returncode == 0
        server = subprocess.Popen(
            ["/usr/bin/python3", "-B", pathlib.Path(__file__).with_name("serve_until_stopped.py"),
             source, mounted], stderr=subprocess.DEVNULL)
        try:
            while not os.path.ismount(mounted):
                if server.poll() is not None:
                    sys.exit(SKIPPED)  # no FUSE here
                time.sleep(0.1)
            process = subprocess.Popen([sys.argv[1], "info", mounted / name],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            assert process.stderr.readline().startswith("Reading "), "the user is told what is awaited"
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            assert process.wait(timeout=30) == -signal.SIGINT
        finally:
            server.kill()
            server.wait()
            subprocess.run(["umount", "--lazy", mounted], check=False, stderr=subprocess.DEVNULL)


def killed(folder):
    """Killed at random moments, programs leave the old file or the new one, and no rest for long."""
    numbers = random.Random(1)
    kills, unfinished = 0, 0
    out = folder / "out"
    out.mkdir()
    for name, arguments in (("a.png", ["render", VOLUME, "--size", "300x300", "-o"]),
                            ("a.nii.gz", ["convert", "procedural:torso:128x128x128", "--overwrite"]),
                            ("a.vti", ["convert", "procedural:torso:128x128x128", "--overwrite"]),
                            ("a.tif", ["convert", "procedural:torso:128x128x128", "--overwrite"])):
        path = out / name
        start = time.monotonic()
        assert run(*arguments, path).returncode == 0
        seconds = time.monotonic() - start
        whole = path.read_bytes()
        for _ in range(15):
            path.write_bytes(OLD)
            process = subprocess.Popen([sys.argv[1], *map(str, arguments), path],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(numbers.uniform(0, seconds))
            process.kill()
            process.wait()
            assert path.read_bytes() in (OLD, whole), f"{name} is neither the old nor the new file"
            kills += 1
            unfinished += len(list(out.glob("*.part*"))) > 0
        assert run(*arguments, path).returncode == 0
        assert not list(out.glob("*.part*")), "what was left is not found and deleted"
    print(f"{kills} kills, {unfinished} of them while a file was being written")


CASES = (file_size_limit, full_disk, read_only, devices, memory, sizes, no_opengl, pipes,
         changing_files, gone_disk, deep_documents, processors, killed)

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        {case.__name__: case for case in CASES}[sys.argv[2]](pathlib.Path(name))
