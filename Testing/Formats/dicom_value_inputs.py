#!/usr/bin/env python3
"""DICOM inputs whose values, segments, views or sizes are easily taken for something else.

Each is compared with pydicom and the standard, or with dcmtk, as it says.
Usage: dicom_value_inputs.py [INPUT...]
"""

import json
import subprocess

import numpy
import pydicom
import varimarch
from pydicom.sequence import Sequence
from pydicom.uid import ExplicitVRBigEndian

from comparison import Volume, affine_of, agree, phantom, program, read, run
from dicom_writing import (
    AXIAL, DX, MR, PET, SEGMENTATION, US, at, by_pydicom, enhanced, frames_by_pydicom, item, sequence,
    slices, write)

# Maps of values.


def packed_table_of_an_odd_number_of_entries(folder):
    """pydicom: 255 entries of 8 bits in words, the last of which is padded."""
    entries = bytes((7 * entry) % 251 for entry in range(255))
    paths = slices(folder, phantom(kind="u1"), ModalityLUTSequence=sequence(
        LUTDescriptor=[255, 0, 8], ModalityLUTType="US", LUTData=entries + b"\0"))
    table = numpy.frombuffer(entries, "u1")
    agree(folder, by_pydicom(paths, lambda file: table[numpy.minimum(file.pixel_array, 254)]))


def table_whose_first_entry_is_for_a_negative_value(folder):
    """pydicom: a modality table of signed pixels that begins at -100."""
    paths = slices(folder, phantom(kind="i2") - 500, ModalityLUTSequence=sequence(
        LUTDescriptor=[400, -100, 16], ModalityLUTType="HU",
        LUTData=(3 * numpy.arange(400, dtype="u2") + 5).tobytes()))
    agree(folder, by_pydicom(
        paths, lambda file: 3 * numpy.clip(file.pixel_array + 100.0, 0, 399) + 5))


def real_world_map_of_each_frame(folder):
    """pydicom: an enhanced file without another map, whose frames have real-world slopes of their own."""
    path = enhanced(
        folder / "a.dcm", phantom(), {},
        lambda frame: {"PlanePositionSequence": at(-10, -20, 30 + 2.5 * frame),
                       "RealWorldValueMappingSequence": sequence(
                           RealWorldValueFirstValueMapped=0, RealWorldValueLastValueMapped=999,
                           RealWorldValueSlope=0.5 + frame, RealWorldValueIntercept=-frame,
                           LUTLabel="T1", MeasurementUnitsCodeSequence=sequence(CodeValue="ms"))})
    file = pydicom.dcmread(str(path))
    maps = [groups.RealWorldValueMappingSequence[0] for groups in file.PerFrameFunctionalGroupsSequence]
    values = [pixels * one.RealWorldValueSlope + one.RealWorldValueIntercept
              for pixels, one in zip(file.pixel_array, maps)]
    agree(path, frames_by_pydicom(path, range(4))._replace(values=numpy.array(values)))


def real_world_table_is_named(folder):
    """pydicom: a real-world map that is a table beside a slope: the slope counts, and a warning names it."""
    paths = slices(folder, phantom(), RescaleSlope=2, RescaleIntercept=-100,
                   RealWorldValueMappingSequence=sequence(
                       RealWorldValueFirstValueMapped=0, RealWorldValueLastValueMapped=3,
                       RealWorldValueLUTData=[0.0, 1.0, 4.0, 9.0], LUTLabel="square",
                       MeasurementUnitsCodeSequence=sequence(CodeValue="mm2")))
    agree(folder, by_pydicom(paths), "also map their values to \"mm2\"")


def words_of_8_bit_pixels_in_big_endian(folder):
    """dcmtk: odd rows of 8 bits in words whose bytes are exchanged, in several frames."""
    little = write(folder / "little.dcm", phantom(shape=(4, 3, 5), kind="u1"), of_class=US,
                   SpacingBetweenSlices=2.5, PixelSpacing=[0.8, 0.7], ImagePositionPatient=[-10, -20, 30],
                   ImageOrientationPatient=list(AXIAL), FrameIncrementPointer=0x00182005,
                   SliceLocationVector=[0.0, 2.5, 5.0, 7.5])
    big = folder / "big.dcm"
    subprocess.run(["dcmconv", "+tb", str(little), str(big)], check=True)
    assert pydicom.dcmread(str(big)).file_meta.TransferSyntaxUID == ExplicitVRBigEndian
    agree(big, frames_by_pydicom(little, range(4)))


# Padding outside the image, and images whose smallest values are white.


def padding_of_inverse_images_stays_out_of_the_range(folder):
    """pydicom: MONOCHROME1 with a range of padding below the image, whose extremes are those inside."""
    pixels = phantom(kind="i2") + 24
    pixels[:, :, 0], pixels[:, 0] = -2000, -1990
    paths = slices(folder / "scan", pixels, of_class=MR, PhotometricInterpretation="MONOCHROME1",
                   PixelPaddingValue=-2000, PixelPaddingRangeLimit=-1990)
    other = by_pydicom(paths)
    inside = other.values[other.values > -1990]
    agree(folder / "scan", other)
    output = folder / "info.json"
    program("info", folder / "scan", "--json", output)
    described = json.loads(output.read_text())
    assert described["volume"]["range"] == [inside.min(), inside.max()], described["volume"]["range"]


def padding_above_the_image_is_its_lowest_value(folder):
    """pydicom: padding whose number is unsigned in the file, of signed pixels with a slope."""
    pixels = phantom(kind="i2") - 300
    pixels[:, 2] = 32767
    paths = slices(folder, pixels, RescaleSlope=0.5, RescaleIntercept=-10, PixelPaddingValue=32767)
    other = by_pydicom(paths)
    values = numpy.where(other.values > 16000, numpy.min(other.values), other.values)
    agree(folder, other._replace(values=values), "outside the image")


# Standardized uptake values.


def uptake_factor(folder, **attributes):
    """The factor that varimarch computes for a scan of PET, and the warnings of its reader."""
    tracer = {"RadiopharmaceuticalStartTime": "080000", "RadionuclideTotalDose": 3e8,
              "RadionuclideHalfLife": 6586.2}
    tracer.update({name: attributes.pop(name) for name in list(attributes) if name.startswith("Radio")})
    slices(folder, phantom(), of_class=PET, RadiopharmaceuticalInformationSequence=sequence(**tracer), **{
        "SeriesDate": "20240110", "SeriesTime": "090000", "AcquisitionDate": "20240110",
        "AcquisitionTime": "090000", "Units": "BQML", "DecayCorrection": "START",
        "CorrectedImage": ["DECY", "ATTN"], "PatientWeight": 75, "RescaleSlope": 1, **attributes})
    reader = varimarch.vtkVolumeFileReader()
    reader.SetFileName(str(folder))
    reader.Update()
    doubts = reader.GetWarnings()
    return reader.GetUptakeValueFactor(), [
        doubts.GetValue(index) for index in range(doubts.GetNumberOfValues())]


def uptake_of_doses_in_megabecquerel_is_unknown(folder):
    """The standard: a dose is in Bq; 300 of them cannot be seen."""
    factor, doubts = uptake_factor(folder, RadionuclideTotalDose=300)
    assert factor == 0.0 and any("a dose of 300 Bq cannot be true" in one for one in doubts), doubts


def uptake_of_an_injection_in_another_zone(folder):
    """The standard: 01:30 in India is an hour before 16:00 of the day before in New York."""
    factor, doubts = uptake_factor(
        folder, SeriesDate="20240109", AcquisitionDate="20240109", SeriesTime="160000",
        AcquisitionTime="160100", TimezoneOffsetFromUTC="-0500",
        RadiopharmaceuticalStartDateTime="20240110013000.00+0530")
    expected = 75e3 / (3e8 * 2.0 ** (-3600.0 / 6586.2))
    assert numpy.isclose(factor, expected, rtol=1e-6), (factor, expected, doubts)


def uptake_of_counts_says_why_it_is_unknown(folder):
    """The standard: counts are no activity, unless a private factor says what they are."""
    factor, doubts = uptake_factor(folder, Units="CNTS")
    assert factor == 0.0 and any("counts without a factor" in one for one in doubts), doubts


def uptake_by_body_surface_is_not_by_weight(folder):
    """The standard: values in g/ml may be by body surface, which is not what the factor means."""
    factor, doubts = uptake_factor(folder, Units="GML", SUVType="BSA")
    assert factor == 0.0 and any("BSA" in one for one in doubts), doubts


# Segments, views and sizes.


def segments_on_every_third_slice(folder):
    """pydicom: frames of two segments that state only their thickness, which is that of a slice."""
    masks = (phantom(shape=(4, 5, 6)) > 500).astype("u1")
    masks[1] &= 1 - masks[0]
    masks[3] &= 1 - masks[2]
    path = enhanced(
        folder / "seg.dcm", masks, {}, lambda frame: {
            "PlanePositionSequence": at(-10, -20, 30 + 7.5 * (frame // 2)),
            "SegmentIdentificationSequence": sequence(ReferencedSegmentNumber=1 + frame % 2)},
        of_class=SEGMENTATION, SegmentationType="BINARY", BitsAllocated=1, BitsStored=1, HighBit=0,
        PixelData=numpy.packbits(masks.ravel(), bitorder="little").tobytes() + b"\0",
        SegmentSequence=Sequence([item(SegmentNumber=number, SegmentLabel=f"S{number}")
                                  for number in (1, 2)]))
    values = numpy.zeros((4, 5, 6))
    pixels = pydicom.dcmread(str(path)).pixel_array
    values[0], values[3] = pixels[0] + 2 * pixels[1], pixels[2] + 2 * pixels[3]
    agree(path, Volume(values, affine_of()), "as thick as stated")


def mammograms_are_views(folder):
    """pydicom: two projections of one size are no slices."""
    views = phantom(shape=(2, 5, 6))
    for index, view in enumerate(("CC", "MLO")):
        write(folder / f"{view}.dcm", views[index], of_class=DX, Modality="MG", InstanceNumber=index + 1,
              ImagerPixelSpacing=[0.8, 0.7], ImageLaterality="L", ViewPosition=view)
    for kind, pixels in enumerate(views, 1):
        found, doubts = read(folder, kind=kind)
        assert numpy.array_equal(found.values, pixels[None]), kind
        assert numpy.allclose(numpy.linalg.norm(found.affine[:3, :2], axis=0), (0.7, 0.8)), kind
    assert any("MLO" in doubt for doubt in read(folder)[1])


def region_of_tissue_behind_a_spectrum_and_a_colour_bar(folder):
    """pydicom: the third region is the picture of tissue; the others have other units or scales."""
    def region(form, unit, mm):
        return item(RegionSpatialFormat=form, PhysicalUnitsXDirection=unit, PhysicalUnitsYDirection=unit,
                    PhysicalDeltaX=mm / 10, PhysicalDeltaY=mm / 10)
    regions = [region(3, 4, 5.0), region(0, 3, 9.0), region(1, 3, 0.25)]
    path = write(folder / "a.dcm", phantom(shape=(3, 5, 6), kind="u1"), of_class=US, FrameTime=40,
                 FrameIncrementPointer=0x00181063, SequenceOfUltrasoundRegions=Sequence(regions))
    found, _ = read(path, time=2)
    assert numpy.array_equal(found.values[0], pydicom.dcmread(str(path)).pixel_array[2])
    assert numpy.allclose(numpy.linalg.norm(found.affine[:3, :2], axis=0), 0.25), found.affine
    assert numpy.allclose(varimarch.times(path), (0.0, 0.04, 0.08))


def uneven_slices_are_resampled(folder):
    """A formula: a field that grows linearly with the height stays so where the distance doubles."""
    heights = numpy.array((0.0, 2.0, 4.0, 6.0, 10.0, 14.0))
    field = numpy.broadcast_to((100 + 10 * heights)[:, None, None], (6, 5, 6)).astype("u2")
    slices(folder, field, each=lambda index: {
        "ImagePositionPatient": [-10.0, -20.0, float(heights[index])]})
    found, _ = read(folder)
    z = found.affine[2, 3] + found.affine[2, 2] * numpy.arange(len(found.values))
    assert z.min() == 0.0 and 13.9 < z.max() < 14.1, z
    assert numpy.allclose(found.values[:, 2, 3], 100 + 10 * z, atol=1.0), (found.values[:, 2, 3], z)


def tilted_slices_of_signed_bytes_keep_their_shear(folder):
    """pydicom: slices that the gantry shears are sheared in the volume if they are kept as scanned."""
    paths = slices(folder, phantom(kind="i2").astype("i1"), step=(0.0, 0.6, 2.5))
    agree(folder, by_pydicom(paths), rectify=False)


if __name__ == "__main__":
    run(globals())
