"""DICOM files of any kind, made by pydicom, and what pydicom, dcm2niix and dcmtk read of them.

pydicom reads attributes and stored values. What they mean is computed here after PS3.3: the affine
of C.7.6.2.1.1 and the values of C.11.1.
"""

import subprocess

import nibabel
import numpy
import pydicom
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.pixel_data_handlers.util import apply_modality_lut
from pydicom.sequence import Sequence
from pydicom.uid import ExplicitVRBigEndian, ExplicitVRLittleEndian, generate_uid

from comparison import Volume, from_ras

CT = "1.2.840.10008.5.1.4.1.1.2"
MR = "1.2.840.10008.5.1.4.1.1.4"
PET = "1.2.840.10008.5.1.4.1.1.128"
DX = "1.2.840.10008.5.1.4.1.1.1.1"
US = "1.2.840.10008.5.1.4.1.1.3.1"
NUCLEAR = "1.2.840.10008.5.1.4.1.1.20"
ENHANCED_CT = "1.2.840.10008.5.1.4.1.1.2.1"
ENHANCED_MR = "1.2.840.10008.5.1.4.1.1.4.1"
SEGMENTATION = "1.2.840.10008.5.1.4.1.1.66.4"
SLIDE = "1.2.840.10008.5.1.4.1.1.77.1.6"

AXIAL = (1, 0, 0, 0, 1, 0)
CORONAL = (1, 0, 0, 0, 0, -1)
SAGITTAL = (0, 1, 0, 0, 0, -1)


def item(**attributes):
    """A data set with the attributes."""
    data = Dataset()
    for name, value in attributes.items():
        setattr(data, name, value)
    return data


def sequence(**attributes):
    """A sequence of one item."""
    return Sequence([item(**attributes)])


def write(path, pixels, of_class=CT, syntax=ExplicitVRLittleEndian, **attributes):
    """Writes a file with one frame for [y, x], or several for [frame, y, x]."""
    path.parent.mkdir(parents=True, exist_ok=True)
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID = of_class, generate_uid()
    meta.TransferSyntaxUID = syntax
    data = FileDataset(str(path), {}, file_meta=meta, preamble=bytes(128))
    data.is_little_endian, data.is_implicit_VR = syntax != ExplicitVRBigEndian, False
    bits = 8 * pixels.dtype.itemsize
    common = {
        "SOPClassUID": of_class, "SOPInstanceUID": meta.MediaStorageSOPInstanceUID,
        "StudyInstanceUID": "1.2.826.0.1.4", "SeriesInstanceUID": "1.2.826.0.1.5",
        "FrameOfReferenceUID": "1.2.826.0.1.9", "PatientName": "Phantom", "PatientID": "0",
        "Modality": {CT: "CT", PET: "PT", DX: "DX", US: "US", NUCLEAR: "NM", ENHANCED_CT: "CT",
                     SEGMENTATION: "SEG", SLIDE: "SM"}.get(of_class, "MR"),
        "SeriesNumber": 1, "InstanceNumber": 1, "SamplesPerPixel": 1,
        "PhotometricInterpretation": "MONOCHROME2", "Rows": pixels.shape[-2],
        "Columns": pixels.shape[-1], "BitsAllocated": bits, "BitsStored": bits, "HighBit": bits - 1,
        "PixelRepresentation": int(pixels.dtype.kind == "i"), "PixelData": pixels.tobytes()}
    if pixels.ndim == 3:
        common["NumberOfFrames"] = len(pixels)
    for name, value in {**common, **attributes}.items():
        setattr(data, name, value)
    data.save_as(str(path), write_like_original=False)
    return path


def slices(folder, values, name="", first=(-10.0, -20.0, 30.0), step=(0.0, 0.0, 2.5),
           direction=AXIAL, each=lambda index: {}, **attributes):
    """Writes a file for each slice, with the attributes that a function adds, and returns the paths."""
    return [write(folder / f"{name}{index:03}.dcm", pixels, **{
        "ImageOrientationPatient": list(direction), "PixelSpacing": [0.8, 0.7],
        "ImagePositionPatient": [float(a + index * b) for a, b in zip(first, step)],
        "SliceThickness": 2.5, "InstanceNumber": index + 1, **attributes, **each(index)})
        for index, pixels in enumerate(values)]


def placed(values, direction, pixel_mm, places):
    """The volume of slices at the places of their first pixels."""
    affine = numpy.eye(4)
    affine[:3, 0] = numpy.asarray(direction[:3], float) * pixel_mm[1]
    affine[:3, 1] = numpy.asarray(direction[3:], float) * pixel_mm[0]
    step = (numpy.asarray(places[-1], float) - places[0]) / max(1, len(places) - 1)
    affine[:3, 2] = step if len(places) > 1 else 2.5 * numpy.cross(direction[:3], direction[3:])
    affine[:3, 3] = places[0]
    return Volume(numpy.asarray(values), affine)


def by_pydicom(paths, values_of=lambda file: apply_modality_lut(file.pixel_array, file)):
    """The volume of files that hold one slice each, in the order given, with the values of a file."""
    files = [pydicom.dcmread(str(path)) for path in paths]
    first = files[0]
    return placed([values_of(file) for file in files],
                  first.ImageOrientationPatient, first.PixelSpacing,
                  [[float(x) for x in file.ImagePositionPatient] for file in files])


def frames_by_pydicom(path, frames, direction=AXIAL, first=(-10.0, -20.0, 30.0), distance_mm=2.5):
    """The volume of frames of a file at even distances along their normal, in the order given."""
    file = pydicom.dcmread(str(path))
    normal = distance_mm * numpy.cross(direction[:3], direction[3:])
    pixels = apply_modality_lut(file.pixel_array, file)
    return placed([pixels[frame] for frame in frames], direction, (0.8, 0.7),
                  [first + index * normal for index in range(len(frames))])


def by_dcm2niix(folder):
    """The volumes that dcm2niix makes of a folder, as lists of times, by the ends of their names.

    A name ends in what dcm2niix adds for an echo, a phase or another part of a series.
    """
    output = folder.parent / (folder.name + "-nifti")
    output.mkdir()
    subprocess.run(["dcm2niix", "-b", "n", "-f", "scan", "-o", str(output), str(folder)],
                   capture_output=True, check=True)
    volumes = {}
    for path in sorted(output.glob("*.nii")):
        image = nibabel.load(str(path))
        values = image.get_fdata().T
        volumes[path.stem.removeprefix("scan")] = [
            Volume(values_of_time, from_ras(image.affine))
            for values_of_time in (values if values.ndim == 4 else [values])]
    return volumes


def enhanced(path, pixels, shared, each, of_class=ENHANCED_MR, **attributes):
    """Writes an enhanced file whose functional groups are the shared ones and those of each frame."""
    groups = {"PixelMeasuresSequence": sequence(PixelSpacing=[0.8, 0.7], SliceThickness=2.5),
              "PlaneOrientationSequence": sequence(ImageOrientationPatient=list(AXIAL)), **shared}
    return write(path, pixels, of_class=of_class, **{
        "SharedFunctionalGroupsSequence": sequence(**groups),
        "PerFrameFunctionalGroupsSequence": Sequence(
            [item(**each(frame)) for frame in range(len(pixels))]), **attributes})


def at(*place):
    """The functional group of a place."""
    return sequence(ImagePositionPatient=[float(x) for x in place])
