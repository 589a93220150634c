#!/usr/bin/env python3
"""DICOM inputs whose frames, images and values are easily taken for something else.

Each is compared with pydicom and the standard, with dcm2niix or with dcmtk, as it says.
Usage: dicom_inputs.py [INPUT...]
"""

import numpy
from pydicom.sequence import Sequence
from pydicom.uid import generate_uid

from comparison import agree, phantom, refused, run
from dicom_writing import (
    CORONAL, ENHANCED_CT, MR, NUCLEAR, PET, SAGITTAL, SLIDE, at, by_dcm2niix, by_pydicom,
    enhanced, frames_by_pydicom, item, sequence, slices, write)

# Frames of one file.


def perfusion_of_one_place_stored_backwards(folder):
    """pydicom: the dimension is time, and the frame of the first time is stored last."""
    path = enhanced(
        folder / "a.dcm", phantom(), {"PlanePositionSequence": at(-10, -20, 30)},
        lambda frame: {"FrameContentSequence": sequence(
            TemporalPositionIndex=4 - frame, DimensionIndexValues=[4 - frame],
            TemporalPositionTimeOffset=2.0 * (3 - frame))},
        of_class=ENHANCED_CT,
        DimensionIndexSequence=sequence(DimensionIndexPointer=0x00209128,
                                        FunctionalGroupPointer=0x00209111))
    agree(path, [frames_by_pydicom(path, [frame]) for frame in (3, 2, 1, 0)], times=[0, 2, 4, 6])


def enhanced_times_in_the_middle_of_places(folder):
    """pydicom: two times of three places, stored place by place from the head to the feet."""
    path = enhanced(
        folder / "a.dcm", phantom(shape=(6, 5, 6)), {},
        lambda frame: {
            "PlanePositionSequence": at(-10, -20, 35 - 2.5 * (frame // 2)),
            "FrameContentSequence": sequence(
                StackID="1", InStackPositionNumber=3 - frame // 2,
                TemporalPositionIndex=1 + frame % 2,
                DimensionIndexValues=[1, 3 - frame // 2, 1 + frame % 2])})
    agree(path, [frames_by_pydicom(path, frames) for frames in ((4, 2, 0), (5, 3, 1))], times=[0, 1])


def nuclear_frames_of_a_dynamic_scan(folder):
    """pydicom: the frame increment pointer names time slices, and a thickness is stated."""
    path = write(folder / "a.dcm", phantom(), of_class=NUCLEAR, PixelSpacing=[0.8, 0.7],
                 SliceThickness=2.5, FrameIncrementPointer=[0x00540030, 0x00540100],
                 PhaseVector=[1, 1, 2, 2], TimeSliceVector=[1, 2, 1, 2],
                 DetectorInformationSequence=sequence(
                     ImagePositionPatient=[-10.0, -20.0, 30.0],
                     ImageOrientationPatient=[1.0, 0, 0, 0, 1, 0]))
    agree(path, [frames_by_pydicom(path, [frame]) for frame in range(4)], times=[0, 1, 2, 3])


def nuclear_slices_of_a_gated_heart(folder):
    """pydicom: two time slots of three slices, the slots stored first and the slices backwards."""
    path = write(folder / "a.dcm", phantom(shape=(6, 5, 6)), of_class=NUCLEAR,
                 PixelSpacing=[0.8, 0.7], SpacingBetweenSlices=2.5,
                 FrameIncrementPointer=[0x00540060, 0x00540070, 0x00540080],
                 RRIntervalVector=[1] * 6, TimeSlotVector=[1, 1, 1, 2, 2, 2],
                 SliceVector=[3, 2, 1, 3, 2, 1], DetectorInformationSequence=sequence(
                     ImagePositionPatient=[-10.0, -20.0, 35.0],
                     ImageOrientationPatient=[1.0, 0, 0, 0, 1, 0]))
    agree(path, [frames_by_pydicom(path, frames) for frames in ((2, 1, 0), (5, 4, 3))], times=[0, 1])


def nuclear_slices_of_two_energies(folder):
    """pydicom: two windows of energy are kinds, not slices."""
    path = write(folder / "a.dcm", phantom(shape=(6, 5, 6)), of_class=NUCLEAR,
                 PixelSpacing=[0.8, 0.7], SpacingBetweenSlices=2.5,
                 FrameIncrementPointer=[0x00540010, 0x00540080],
                 EnergyWindowVector=[1, 2, 1, 2, 1, 2], SliceVector=[1, 1, 2, 2, 3, 3],
                 DetectorInformationSequence=sequence(
                     ImagePositionPatient=[-10.0, -20.0, 30.0],
                     ImageOrientationPatient=[1.0, 0, 0, 0, 1, 0]))
    agree(path, frames_by_pydicom(path, (0, 2, 4)), "energy")
    agree(path, frames_by_pydicom(path, (1, 3, 5)), kind=2)


def projections_of_two_detectors(folder):
    """pydicom: three angles of each of two detectors are six views."""
    path = write(folder / "a.dcm", phantom(shape=(6, 5, 6)), of_class=NUCLEAR, PixelSpacing=[0.8, 0.7],
                 SliceThickness=2.5, FrameIncrementPointer=[0x00540020, 0x00540050, 0x00540090],
                 DetectorVector=[1, 1, 1, 2, 2, 2], RotationVector=[1] * 6,
                 AngularViewVector=[1, 2, 3, 1, 2, 3], DetectorInformationSequence=sequence(
                     ImagePositionPatient=[-10.0, -20.0, 30.0],
                     ImageOrientationPatient=[1.0, 0, 0, 0, 0, -1]))
    for frame in range(6):
        agree(path, frames_by_pydicom(path, [frame], direction=CORONAL), kind=frame + 1)


def nuclear_slices_at_a_negative_distance(folder):
    """pydicom: slices that follow each other against their normal (PS3.3 C.8.4.15)."""
    path = write(folder / "a.dcm", phantom(), of_class=NUCLEAR, PixelSpacing=[0.8, 0.7],
                 SpacingBetweenSlices=-2.5, FrameIncrementPointer=0x00540080, SliceVector=[1, 2, 3, 4],
                 DetectorInformationSequence=sequence(
                     ImagePositionPatient=[-10.0, -20.0, 30.0],
                     ImageOrientationPatient=[1.0, 0, 0, 0, 1, 0]))
    agree(path, frames_by_pydicom(path, range(4), distance_mm=-2.5))


def slices_at_falling_locations(folder):
    """pydicom: the vector of slice locations falls, and only the first position is stated."""
    path = write(folder / "a.dcm", phantom(), PixelSpacing=[0.8, 0.7], SliceThickness=1.0,
                 ImagePositionPatient=[-10.0, -20.0, 30.0], ImageOrientationPatient=[1.0, 0, 0, 0, 1, 0],
                 FrameIncrementPointer=0x00182005, SliceLocationVector=[120.0, 117.5, 115.0, 112.5])
    agree(path, frames_by_pydicom(path, range(4), distance_mm=-2.5))


def tiles_of_a_sparse_slide(folder):
    """pydicom: tiles that state their column and row in the slide are one plane."""
    path = write(folder / "a.dcm", phantom(kind="u1"), of_class=SLIDE, SliceThickness=0.01,
                 TotalPixelMatrixColumns=12, TotalPixelMatrixRows=10,
                 DimensionOrganizationType="TILED_SPARSE", PerFrameFunctionalGroupsSequence=Sequence([
                     item(PlanePositionSlideSequence=sequence(
                         ColumnPositionInTotalImagePixelMatrix=1 + 6 * (frame % 2),
                         RowPositionInTotalImagePixelMatrix=1 + 5 * (frame // 2)))
                     for frame in range(4)]))
    refused(path, "tiles of a flat slide of 12 x 10 pixels")


# Images that differ in more than their places.


def echoes_interleaved_by_instance_number(folder):
    """dcm2niix: three echoes, whose images are numbered place by place."""
    values = phantom(shape=(3, 4, 5, 6))
    for echo in range(3):
        slices(folder / "scan", values[echo], f"{echo}-", of_class=MR, EchoTime=[2.4, 12.1, 4.8][echo],
               each=lambda index, echo=echo: {"InstanceNumber": 3 * index + echo + 1})
    others = by_dcm2niix(folder / "scan")
    assert len(others) == 3, list(others)
    shortest_first = [values[echo] for echo in (0, 2, 1)]
    for kind, stored in enumerate(shortest_first, 1):
        other = next(volumes[0] for volumes in others.values()
                     if numpy.array_equal(numpy.sort(volumes[0].values.ravel()), numpy.sort(stored.ravel())))
        agree(folder / "scan", other, *(["echo"] if kind == 1 else []),
              **({"kind": kind} if kind > 1 else {}))


def b_values_at_shifted_heights(folder):
    """pydicom: two b-values, the second 1 mm higher after a pause of the patient."""
    values = phantom(shape=(2, 4, 5, 6))
    volumes = [slices(folder / "scan", values[b], f"{b}-", of_class=MR, first=(-10, -20, 30 + b),
                      DiffusionBValue=[0.0, 800.0][b], AcquisitionNumber=b + 1,
                      each=lambda index, b=b: {"InstanceNumber": 4 * b + index + 1}) for b in range(2)]
    agree(folder / "scan", by_pydicom(volumes[0]), "b-value")
    agree(folder / "scan", by_pydicom(volumes[1]), kind=2)


def magnitude_and_phase_with_maps_of_their_own(folder):
    """dcm2niix: the phase has a slope of its own, and is a kind."""
    values = phantom(shape=(2, 4, 5, 6))
    for part, letter in enumerate("MP"):
        slices(folder / "scan", values[part], letter, of_class=MR, EchoTime=4.6,
               ImageType=["ORIGINAL", "PRIMARY", letter, "ND"],
               RescaleSlope=[1, 2][part], RescaleIntercept=[0, -1000][part],
               each=lambda index, part=part: {"InstanceNumber": 4 * part + index + 1})
    others = by_dcm2niix(folder / "scan")
    phase = next(volumes[0] for volumes in others.values() if volumes[0].values.min() < 0)
    magnitude = next(volumes[0] for volumes in others.values() if volumes[0].values.min() >= 0)
    agree(folder / "scan", magnitude, "kind of image")
    agree(folder / "scan", phase, kind=2)


def flip_angles_of_a_relaxation_map(folder):
    """pydicom: three flip angles of one series, whose numbers repeat."""
    values = phantom(shape=(3, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], f"{i}-", of_class=MR, FlipAngle=[2, 9, 19][i])
               for i in range(3)]
    agree(folder / "scan", by_pydicom(volumes[0]), "flip angle")
    agree(folder / "scan", by_pydicom(volumes[2]), kind=3)


def echoes_of_each_time(folder):
    """pydicom: two echoes and two temporal positions, so that each kind has times."""
    values = phantom(shape=(2, 2, 4, 5, 6))
    volumes = {(echo, time): slices(
        folder / "scan", values[echo, time], f"{echo}{time}-", of_class=MR, EchoTime=[10.0, 30.0][echo],
        TemporalPositionIdentifier=time + 1, each=lambda index, start=8 * time + 4 * echo: {
            "InstanceNumber": start + index + 1}) for echo in range(2) for time in range(2)}
    for echo in range(2):
        agree(folder / "scan", [by_pydicom(volumes[echo, time]) for time in range(2)], kind=echo + 1)


def directions_of_one_b_value(folder):
    """pydicom: one image without weighting and three directions of one b-value are four kinds."""
    values = phantom(shape=(4, 4, 5, 6))
    directions = None, [1.0, 0, 0], [0, 1.0, 0], [0, 0.6, 0.8]
    volumes = [slices(folder / "scan", values[i], f"{i}-", of_class=MR,
                      DiffusionBValue=1000.0 if direction else 0.0,
                      **({"DiffusionGradientOrientation": direction} if direction else {}),
                      each=lambda index, i=i: {"InstanceNumber": 4 * index + i + 1})
               for i, direction in enumerate(directions)]
    agree(folder / "scan", by_pydicom(volumes[0]), "4 kinds", "b-value")
    agree(folder / "scan", by_pydicom(volumes[3]), kind=4)


def water_and_fat_of_each_half(folder):
    """pydicom: water and fat, each acquired in two halves with numbers of their own."""
    values = phantom(shape=(2, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], letter, of_class=MR,
                      ImageType=["DERIVED", "PRIMARY", "DIXON", letter],
                      each=lambda index, i=i: {"AcquisitionNumber": 1 + index // 2,
                                               "InstanceNumber": 4 * i + index + 1})
               for i, letter in enumerate(("WATER", "FAT"))]
    agree(folder / "scan", by_pydicom(volumes[0]), "kind of image")
    agree(folder / "scan", by_pydicom(volumes[1]), kind=2)


# Times.


def slices_of_a_time_acquired_in_two_passes(folder):
    """dcm2niix: each slice has a time of acquisition of its own, odd slices before even ones."""
    values = phantom(shape=(3, 4, 5, 6))
    for time in range(3):
        slices(folder / "scan", values[time], f"{time}-", of_class=MR, AcquisitionNumber=1,
               each=lambda index, time=time: {
                   "InstanceNumber": 4 * time + index + 1, "AcquisitionDate": "20240110",
                   "AcquisitionTime": f"1000{2 * time + (index % 2) + 0.25 * (index // 2):05.2f}"})
    times = next(iter(by_dcm2niix(folder / "scan").values()))
    assert len(times) == 3, len(times)
    agree(folder / "scan", times, "order of their acquisition time")


def odd_and_even_slices_without_a_stated_distance(folder):
    """pydicom: two acquisitions in turns, whose slices are even together and state no thickness."""
    paths = slices(folder / "scan", phantom(shape=(6, 5, 6)), each=lambda index: {
        "AcquisitionNumber": 1 + index % 2, "SliceThickness": None})
    agree(folder / "scan", by_pydicom(paths), times=[0])


def some_slices_with_a_value_of_their_own(folder):
    """pydicom: one volume, of which a few slices state another echo time, angle, kind or acquisition."""
    differences = [("EchoTime", 4.6, 4.61), ("FlipAngle", 90, 80), ("AcquisitionNumber", 1, 2),
                   ("ImageType", ["ORIGINAL", "PRIMARY", "AXIAL"], ["DERIVED", "PRIMARY", "AXIAL"])]
    for name, usual, other in differences:
        paths = slices(folder / name, phantom(shape=(8, 5, 6)), of_class=MR, each=lambda index: {
            name: other if index in (1, 4, 5) else usual})
        agree(folder / name, by_pydicom(paths), times=[0])


def phases_told_by_their_moment_alone(folder):
    """pydicom: two phases, the second 0.7 mm higher, that differ in their time of acquisition only."""
    values = phantom(shape=(2, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], f"{i}-", first=(-10, -20, 30 + 0.7 * i),
                      AcquisitionDate="20240110", AcquisitionTime=f"1000{8 * i:02}",
                      each=lambda index, i=i: {"InstanceNumber": 4 * i + index + 1}) for i in range(2)]
    agree(folder / "scan", [by_pydicom(paths) for paths in volumes], times=[0, 8])


def voltages_of_a_scan_with_two_energies(folder):
    """pydicom: images of 140 and 80 kV at the same places are kinds, not times."""
    values = phantom(shape=(2, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], f"{i}-", KVP=(140, 80)[i],
                      each=lambda index, i=i: {"InstanceNumber": 2 * index + i + 1}) for i in range(2)]
    agree(folder / "scan", by_pydicom(volumes[1]), "energy", times=[0])
    agree(folder / "scan", by_pydicom(volumes[0]), kind=2)


def dynamic_pet_with_a_slope_for_each_slice(folder):
    """pydicom: the reference times of frames of growing length, and slopes that differ everywhere."""
    values = phantom(shape=(3, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], f"{i}-", of_class=PET, RescaleIntercept=0,
                      FrameReferenceTime=[2500.0, 10000.0, 45000.0][i], AcquisitionDate="20240110",
                      AcquisitionTime=["100000", "100005", "100015"][i], each=lambda index, i=i: {
                          "InstanceNumber": 4 * i + index + 1, "RescaleSlope": 1 + i + 0.125 * index})
               for i in range(3)]
    agree(folder / "scan", [by_pydicom(paths) for paths in volumes], times=[2.5, 10, 45])


def table_that_moves_to_and_fro(folder):
    """pydicom: a perfusion whose table moves between two halves, each acquisition with its number."""
    values = phantom(shape=(3, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], f"{i}-", each=lambda index, i=i: {
        "InstanceNumber": 4 * i + index + 1, "AcquisitionNumber": 1 + 2 * i + index // 2,
        "AcquisitionDate": "20240110", "AcquisitionTime": f"1000{4 * i + 2 * (index // 2):02}.5"})
        for i in range(3)]
    agree(folder / "scan", [by_pydicom(paths) for paths in volumes], "3 images")


def contrast_over_the_turn_of_the_year(folder):
    """pydicom: dates and times of the contents, from the last minute of a year."""
    values = phantom(shape=(3, 4, 5, 6))
    moments = ("20231231", "235940"), ("20240101", "000000"), ("20240101", "000020.5")
    volumes = [slices(folder / "scan", values[i], f"{9 - i}-", ContentDate=moments[i][0],
                      ContentTime=moments[i][1]) for i in range(3)]
    agree(folder / "scan", [by_pydicom(paths) for paths in volumes], times=[0, 20, 40.5])


def moments_over_midnight_in_one_attribute(folder):
    """pydicom: dates with times, stored backwards."""
    values = phantom(shape=(2, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], f"{1 - i}-", of_class=MR, AcquisitionDateTime=moment,
                      each=lambda index, i=i: {"InstanceNumber": 5 - i + 2 * index})
               for i, moment in enumerate(("20240229235958.000000", "20240301000003.500000"))]
    agree(folder / "scan", [by_pydicom(paths) for paths in volumes], times=[0, 5.5])


def phases_of_the_breath_in_turns_of_numbers(folder):
    """pydicom: three phases of a planning scan, numbered place by place from 50 % on."""
    values = phantom(shape=(3, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], f"{i}-", AcquisitionNumber=1,
                      NominalPercentageOfRespiratoryPhase=[50.0, 0.0, 100.0][i],
                      each=lambda index, i=i: {"InstanceNumber": 3 * index + i + 1}) for i in range(3)]
    agree(folder / "scan", [by_pydicom(volumes[i]) for i in (1, 0, 2)])


# Places beside each other.


def stations_of_a_coronal_whole_body(folder):
    """pydicom: three stations along the patient, each of coronal slices at the same heights."""
    values = phantom(shape=(3, 4, 5, 6))
    volumes = [slices(folder / "scan", values[i], f"{i}-", of_class=MR, direction=CORONAL,
                      first=(-10, -20, 30 - 4 * i), step=(0, 2.5, 0),
                      each=lambda index, i=i: {"InstanceNumber": 4 * i + index + 1})
               for i in range(3)]
    agree(folder / "scan", by_pydicom(volumes[0]), "station")
    agree(folder / "scan", by_pydicom(volumes[2]), kind=3)


def knees_of_one_sagittal_series(folder):
    """pydicom: two knees 200 mm apart, of which the one with more slices is read first."""
    left, right = phantom(1, (5, 5, 6)), phantom(2, (4, 5, 6))
    first = slices(folder / "scan", left, "l", of_class=MR, direction=SAGITTAL, first=(95, -20, 30),
                   step=(2.5, 0, 0))
    second = slices(folder / "scan", right, "r", of_class=MR, direction=SAGITTAL, first=(-105, -20, 30),
                    step=(2.5, 0, 0), each=lambda index: {"InstanceNumber": 6 + index})
    agree(folder / "scan", by_pydicom(first), "slices from")
    agree(folder / "scan", by_pydicom(second), kind=2)


def an_image_that_was_sent_twice_with_new_identifiers(folder):
    """pydicom: two copies by content, whose identifiers differ since they were anonymised twice."""
    paths = slices(folder / "scan", phantom())
    slices(folder / "scan" / "again", phantom())
    agree(folder / "scan", by_pydicom(paths))


def one_identifier_for_all_coronal_slices(folder):
    """dcm2niix: an anonymiser gave all images one identifier, and copied one of them."""
    paths = slices(folder / "scan", phantom(), of_class=MR, direction=CORONAL, step=(0, 2.5, 0),
                   SOPInstanceUID="1.2.826.0.1.77")
    others = by_dcm2niix(folder / "scan")
    (folder / "scan" / "copy.dcm").write_bytes(paths[2].read_bytes())
    agree(folder / "scan", next(iter(others.values()))[0])


def a_series_for_each_sagittal_slice(folder):
    """pydicom: images of one number, description and space, each in a series of its own."""
    paths = slices(folder / "scan", phantom(), of_class=MR, direction=SAGITTAL, step=(2.5, 0, 0),
                   SeriesDescription="T1", each=lambda index: {"SeriesInstanceUID": generate_uid()})
    agree(folder / "scan", by_pydicom(paths), "were joined")


if __name__ == "__main__":
    run(globals())
