#!/usr/bin/env python3
"""Looks at the pixels of the viewer as it is installed, on a screen with a window manager.

Usage: test_seen.py VARIMARCH_VIEWER CASE
Exit code 77, with a sentence, where a package is missing.
"""

import json
import os
import pathlib
import subprocess
import sys
import time

import desk as desks
from desk import Viewer, colour_count, wait_for

SKIPPED = 77


def write_head(folder, side=64):
    """A ball of bone around soft tissue in air, as CT."""
    import numpy

    z, y, x = numpy.mgrid[:side, :side, :side] - side / 2 + 0.5
    radius = numpy.sqrt(x * x + y * y + (1.3 * z) ** 2) / side
    values = numpy.where(radius < 0.3, 40 + 30 * numpy.sin(x), numpy.where(radius < 0.4, 1200, -1000))
    header = f"NRRD0004\ntype: int16\ndimension: 3\nsizes: {side} {side} {side}\n"
    header += "space: left-posterior-superior\nspace directions: (3,0,0) (0,3,0) (0,0,3)\n"
    header += "encoding: raw\nendian: little\n\n"
    path = folder / "head.nrrd"
    path.write_bytes(header.encode() + values.astype("<i2").tobytes())
    return path


def write_series(folder, count=24, modality="MR", window=lambda i: None, uid="1.2.826.0.1.3680043.9.1",
                 photometric="MONOCHROME2"):
    """Axial images of DICOM with a bright square in a grey one."""
    import numpy
    from pydicom.dataset import Dataset, FileMetaDataset
    from pydicom.uid import ExplicitVRLittleEndian

    folder.mkdir(exist_ok=True)
    paths = []
    for i in range(count):
        image = Dataset()
        image.file_meta = FileMetaDataset()
        image.file_meta.TransferSyntaxUID = ExplicitVRLittleEndian
        image.file_meta.MediaStorageSOPClassUID = image.SOPClassUID = "1.2.840.10008.5.1.4.1.1.4"
        image.file_meta.MediaStorageSOPInstanceUID = image.SOPInstanceUID = f"{uid}.{i + 1}"
        image.is_little_endian, image.is_implicit_VR = True, False
        image.SeriesInstanceUID, image.StudyInstanceUID = uid, "1.2.826.0.1.3680043.9"
        image.FrameOfReferenceUID = uid + ".0"
        image.Modality, image.InstanceNumber = modality, i + 1
        image.Rows = image.Columns = 64
        image.PixelSpacing, image.SliceThickness = [3, 3], 4
        image.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
        image.ImagePositionPatient = [-96, -96, 4 * i]
        image.SamplesPerPixel, image.PhotometricInterpretation = 1, photometric
        image.BitsAllocated = image.BitsStored = 16
        image.HighBit, image.PixelRepresentation = 15, 0
        if window(i):
            image.WindowWidth, image.WindowCenter = window(i)
        pixels = numpy.zeros((64, 64), "<u2")
        pixels[8:56, 8:56] = 300 + numpy.arange(48)
        pixels[24:40, 24:40] = 600
        image.PixelData = pixels.tobytes()
        path = folder / f"{i + 1}.dcm"
        image.save_as(path, write_like_original=False)
        paths.append(path)
    return paths


# The panes of a comparison: ours and VTK's above the difference.
OURS = (slice(130, 390), slice(110, 330))
THEIRS = (slice(130, 390), slice(558, 778))
DIFFERENCE = (slice(445, 765), slice(10, 440))
NUMBERS = (slice(445, 520), slice(450, 890))


def shows_comparison(viewer):
    """The text about the difference is dark on the grey of the window."""
    return (viewer.see(NUMBERS) > 225).all(axis=2).mean() > 0.7


def compares(viewer, mapper):
    viewer.choose(mapper)
    wait_for(lambda: shows_comparison(viewer), f"there is room for the difference to VTK's {mapper} mapper")
    wait_for(lambda: colour_count(viewer.see(THEIRS)) > 50, "VTK's picture is drawn")
    wait_for(lambda: colour_count(viewer.see(OURS)) > 50, f"our picture is drawn beside that of {mapper}")
    # The scene is the same, so the pictures are alike when both are complete.
    wait_for(lambda: abs(viewer.see(OURS).astype(int).mean() - viewer.see(THEIRS).astype(int).mean()) < 12,
             "our picture is about as bright as VTK's")


def comparison_draws_our_picture(desk, program, folder):
    viewer = Viewer(program, desk, write_head(folder))
    wait_for(lambda: colour_count(viewer.see(viewer.VOLUME)) > 50, "the head is drawn")
    compares(viewer, "gpu")
    wait_for(lambda: colour_count(viewer.see(DIFFERENCE)) > 50, "the difference is shown")
    compares(viewer, "cpu")
    viewer.choose("wipe")
    for columns in slice(220, 420), slice(480, 680):
        wait_for(lambda: colour_count(viewer.see((slice(250, 550), columns))) > 50,
                 "the wipe has both halves")
    viewer.end()


def difference_needs_the_whole_scene(desk, program, folder):
    """VTK's CPU mapper has no masks, so there is no difference that means anything."""
    write_head(folder)
    scene = {"volume": {"file": "head.nrrd"}, "cuts": {"bodyOnly": True}}
    (folder / "scene.json").write_text(json.dumps(scene))
    viewer = Viewer(program, desk, folder / "scene.json")
    wait_for(lambda: colour_count(viewer.see(viewer.VOLUME)) > 50, "the head is drawn")
    viewer.choose("gpu")
    wait_for(lambda: colour_count(viewer.see(DIFFERENCE)) > 50, "the difference to VTK's GPU mapper is shown")
    viewer.choose("cpu")
    wait_for(lambda: colour_count(viewer.see(DIFFERENCE)) < 20, "the difference goes")
    time.sleep(5)
    assert colour_count(viewer.see(DIFFERENCE)) < 20, "a difference to another scene is shown"
    assert (viewer.see(NUMBERS) < 100).any(), "nobody says why"
    viewer.end()


def corner_says_what_is_seen(desk, program, folder):
    """While the view moves its pixels have no bound, so the corner has a short word instead."""
    viewer = Viewer(program, desk, write_head(folder, 160))
    at_rest = wait_for(lambda: viewer.report_width() > 90 and viewer.report_width(), "the bound is told at rest")
    desk.do("mousemove", 280, 450, "mousedown", 1)
    widths = []
    for step in range(40):
        desk.do("mousemove", 280 + 4 * step, 450 + step)
        time.sleep(0.05)
        widths.append(viewer.report_width())
    held = viewer.report_width()
    desk.do("mouseup", 1)
    told = [width for width in widths[5:] if width > 90]
    assert not told, f"the bound is told while the view moves: widths {widths}, at rest {at_rest}"
    assert 0 < held < 90, f"nothing is told while the button is held: width {held}"
    wait_for(lambda: viewer.report_width() > 90, "the bound is told at rest again")
    viewer.end()


def window_is_that_of_the_series(desk, program, folder):
    """The first image is noise at the edge, with a window of its own."""
    write_series(folder / "mr", window=lambda i: (22, 11) if i < 2 else (500 + 40 * i, 250 + 20 * i))
    viewer = Viewer(program, desk, folder / "mr")
    wait_for(lambda: has_slices(viewer), "there are slices")
    white = (viewer.see((slice(140, 260), slice(665, 790))) > 250).all(axis=2).mean()
    assert white < 0.4, f"{100 * white:.0f} % of the slice are white"
    viewer.end()


def smallest_values_may_be_white(desk, program, folder):
    """The bright square of MONOCHROME2 is the dark one of MONOCHROME1."""
    write_series(folder / "mr", photometric="MONOCHROME1")
    viewer = Viewer(program, desk, folder / "mr")
    wait_for(lambda: has_slices(viewer), "there are slices")
    square = viewer.see((slice(180, 192), slice(708, 720))).mean()
    around = viewer.see((slice(136, 146), slice(662, 672))).mean()
    assert square < 60 < around, f"the square is {square:.0f}, and what is around it {around:.0f}"
    viewer.end()


def bright_part(viewer, part):
    return (viewer.see(part) > 60).all(axis=2).mean()


def has_slices(viewer):
    """The coronal view shows more than the line of a single image, and is no start page."""
    return 0.15 < bright_part(viewer, viewer.CORONAL) < 0.8


def several_files_are_one_request(desk, program, folder):
    files = write_series(folder / "two", uid="1.2.826.0.1.3680043.9.2")
    other = write_series(folder / "other", count=3, uid="1.2.826.0.1.3680043.9.3")
    for path in other:
        path.rename(folder / "two" / ("other-" + path.name))
    viewer = Viewer(program, desk, *files)
    wait_for(lambda: has_slices(viewer), "all images of the series are slices")
    viewer.end()


def single_image_is_large(desk, program, folder):
    viewer = Viewer(program, desk, write_series(folder / "one", count=1)[0])
    wait_for(lambda: 0.3 < bright_part(viewer, viewer.VIEWS) < 0.8, "the image fills the window")
    viewer.end()


def single_image_offers_its_series(desk, program, folder):
    files = write_series(folder / "series")
    viewer = Viewer(program, desk, files[3])
    bar = (slice(95, 115), slice(300, 700))
    wait_for(lambda: (abs(viewer.see(bar).astype(int) - [255, 243, 205]) < 3).all(axis=2).mean() > 0.5,
             "a bar offers the series")
    desk.do("mousemove", 810, 108, "click", 1)
    wait_for(lambda: has_slices(viewer), "the series is opened")
    viewer.end()


def recent_scans_are_legible(desk, program, folder):
    """Large letters are not cut at the edge of their button."""
    write_series(folder / "a", count=124)
    viewer = Viewer(program, desk, folder / "a")
    wait_for(lambda: has_slices(viewer), "the scan is opened")
    desk.do("key", "ctrl+q")
    viewer.process.wait(timeout=60)
    desk.environment["QT_FONT_DPI"] = "120"
    viewer = Viewer(program, desk)
    desk.do("mousemove", 1000, 700)

    def has_letters(columns):
        return (viewer.see((slice(200, 640), columns)) < 90).all(axis=2).any()

    wait_for(lambda: has_letters(slice(230, 600)), "the start page has letters")
    time.sleep(1)
    assert not has_letters(slice(645, 670)), "a text is cut at the edge of its button"
    viewer.end()


def is_stopped(process):
    return pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()[0] == "T"


def quitting_ends_at_once(desk, program, folder):
    """A scan is being read from a disk that does not answer any more."""
    source, mounted = folder / "source", folder / "mounted"
    source.mkdir()
    mounted.mkdir()
    scan = mounted / write_head(source, 160).name
    server = subprocess.Popen(
        [sys.executable, "-B", pathlib.Path(__file__).parents[1] / "App/serve_until_stopped.py", source,
         mounted], stderr=subprocess.DEVNULL)
    try:
        while not os.path.ismount(mounted):
            if server.poll() is not None:
                print("FUSE cannot be used here.")
                sys.exit(SKIPPED)
            time.sleep(0.1)
        viewer = Viewer(program, desk, scan)
        wait_for(lambda: is_stopped(server), "the scan is being read")
        desk.do("key", "ctrl+q")
        # A thread that waits for its file was given ten seconds before.
        assert viewer.process.wait(timeout=8) == 0
    finally:
        server.kill()
        server.wait()
        subprocess.run(["umount", "--lazy", mounted], check=False, stderr=subprocess.DEVNULL)


def main():
    program, case = sys.argv[1:]
    package = desks.missing_package()
    if not package:
        try:
            import pydicom  # noqa: F401
        except ImportError:
            package = "python3-pydicom"
    if package:
        print(f"skipped: the package {package} is missing")
        return SKIPPED
    desks.run_case(globals()[case], pathlib.Path(program).resolve())
    return 0


if __name__ == "__main__":
    sys.exit(main())
