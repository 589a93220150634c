#!/usr/bin/env python3
"""Inputs of NIfTI, Analyze, MGH, AFNI and MINC, whose axes, times or values are easily mistaken.

Each is compared with nibabel, which also writes most of them.
Usage: scan_inputs.py [INPUT...]
"""

import gzip
import json

import h5py
import nibabel
import numpy

from comparison import Volume, agree, compare, from_ras, phantom, program, read, run

RAS = numpy.array(((-0.7, 0, 0, 10), (0, -0.8, 0, 20), (0, 0, 2.5, 30), (0, 0, 0, 1.0)))
SAGITTAL = numpy.array(((0, 0, 2.5, -10), (-0.8, 0, 0, 20), (0, -0.7, 0, 30), (0, 0, 0, 1.0)))
OBLIQUE = numpy.array(((0.6, -0.48, 0.8, 5), (0.36, 0.64, -1.2, -7), (0, 0.5, 2.1, 9), (0, 0, 0, 1.0)))


def save(image, path):
    """Writes an image of nibabel, and returns its path."""
    nibabel.save(image, str(path))
    return path


def by_nibabel(path):
    """The volumes that nibabel reads, one for each time."""
    image = nibabel.load(str(path))
    values = image.get_fdata().T
    return [Volume(one, from_ras(image.affine)) for one in (values if values.ndim == 4 else [values])]


# NIfTI and Analyze.


def nifti_2_in_big_endian_with_times_in_ms(folder):
    """nibabel: times of NIfTI-2 from an offset on, in the other byte order."""
    header = nibabel.Nifti2Header(endianness=">")
    header["toffset"] = 40
    image = nibabel.Nifti2Image(phantom(shape=(3, 4, 5, 6), kind=">i2").T, OBLIQUE, header)
    image.header.set_zooms((*image.header.get_zooms()[:3], 250.0))
    image.header.set_xyzt_units("mm", "msec")
    path = save(image, folder / "a.nii")
    agree(path, by_nibabel(path), times=[0.04, 0.29, 0.54])


def quaternion_alone_with_a_mirrored_axis(folder):
    """nibabel: only the qform, whose third axis is mirrored by qfac."""
    image = nibabel.Nifti1Image(phantom(kind="f4").T, None)
    image.set_sform(None, 0)
    image.set_qform(numpy.array(((0, -0.8, 0, 4), (0.7, 0, 0, 5), (0, 0, -2.5, 6), (0, 0, 0, 1.0))), 1)
    assert image.header["pixdim"][0] == -1
    path = save(image, folder / "a.nii.gz")
    agree(path, by_nibabel(path))


def slope_that_is_no_number(folder):
    """nibabel: a slope of 0 and an intercept that is no number mean stored values."""
    path = save(nibabel.Nifti1Image(phantom(kind="i2").T, RAS), folder / "a.nii")
    content = bytearray(path.read_bytes())
    content[112:120] = numpy.array((0, numpy.nan), "<f4").tobytes()
    path.write_bytes(bytes(content))
    agree(path, by_nibabel(path))


def unsigned_shorts_with_a_negative_slope(folder):
    """nibabel: values that fall as the stored ones rise."""
    path = save(nibabel.Nifti1Image(phantom().T, SAGITTAL), folder / "a.nii")
    content = bytearray(path.read_bytes())
    content[112:120] = numpy.array((-0.125, 90), "<f4").tobytes()
    path.write_bytes(bytes(content))
    agree(path, by_nibabel(path))


def colours_of_a_fibre_map(folder):
    """nibabel: red, green and blue in a sagittal grid."""
    colours = phantom(shape=(4, 5, 6, 3), kind="u1")
    kind = numpy.dtype([(name, "u1") for name in "RGB"])
    path = save(nibabel.Nifti1Image(colours.copy().view(kind)[..., 0].T, SAGITTAL), folder / "a.nii")
    image = nibabel.load(str(path))
    stored = numpy.asanyarray(image.dataobj)
    agree(path, Volume(numpy.stack([stored[name].T for name in "RGB"], -1), from_ras(image.affine)))


def gzip_in_many_members_with_an_extension(folder):
    """nibabel: a header with an extension, in a file of gzip that was compressed block by block."""
    image = nibabel.Nifti1Image(phantom(kind="i4").T, RAS)
    image.header.extensions.append(nibabel.nifti1.Nifti1Extension("comment", b"x" * 1000))
    plain = save(image, folder / "a.nii").read_bytes()
    path = folder / "b.nii.gz"
    path.write_bytes(b"".join(gzip.compress(plain[i:i + 700]) for i in range(0, len(plain), 700)))
    agree(path, by_nibabel(path))


def lengths_in_micrometres(folder):
    """nibabel's matrix, which leaves the unit to the reader: the header says that it is um."""
    image = nibabel.Nifti1Image(phantom().T, RAS)
    image.header.set_xyzt_units("micron")
    path = save(image, folder / "a.nii")
    other = by_nibabel(path)[0]
    agree(path, Volume(other.values, numpy.diag((1e-3, 1e-3, 1e-3, 1)) @ other.affine))


def displacements_are_components(folder):
    """nibabel: three numbers along the fifth axis, with the intent of a vector."""
    image = nibabel.Nifti1Image(phantom(shape=(3, 1, 4, 5, 6), kind="f4").T / 7, OBLIQUE)
    image.header.set_intent("vector")
    path = save(image, folder / "a.nii")
    stored = nibabel.load(str(path)).get_fdata()
    agree(path, Volume(stored[:, :, :, 0].transpose(2, 1, 0, 3), from_ras(OBLIQUE)))


def analyze_in_big_endian(folder):
    """nibabel: a pair of Analyze with the origin and the factor of SPM."""
    image = nibabel.Spm99AnalyzeImage(phantom(kind="i2").T, numpy.diag((-2.0, 3, 4, 1)))
    header = nibabel.Spm99AnalyzeHeader(endianness=">")
    header.set_data_shape((6, 5, 4))
    header.set_data_dtype("i2")
    header.set_zooms((2, 3, 4))
    header["origin"][:3] = (2, 3, 1)
    header["scl_slope"] = 0.5
    (folder / "a.hdr").write_bytes(header.binaryblock)
    (folder / "a.img").write_bytes(numpy.asarray(image.dataobj).astype(">i2").tobytes(order="F"))
    agree(folder / "a.img", by_nibabel(folder / "a.img"))


def sparse_numbers_of_an_atlas(folder):
    """nibabel and numpy: 300 labels from 1 to 14,175 keep their numbers, of which 253 are drawn."""
    numbers = numpy.unique(numpy.linspace(1, 14175, 300).astype("i4"))
    values = numpy.zeros((10, 10, 10), "i4")
    values.ravel()[:2 * len(numbers)] = numpy.repeat(numbers, 2)
    image = nibabel.Nifti1Image(values.T, RAS)
    image.header.set_intent(1002)
    path = save(image, folder / "labels.nii.gz")
    agree(path, by_nibabel(path))
    said = program("info", path, "--json", folder / "info.json")
    segments = json.loads((folder / "info.json").read_text())["segments"]
    stored = numpy.asarray(nibabel.load(str(path)).dataobj)
    found, counts = numpy.unique(stored[stored > 0], return_counts=True)
    assert [one["value"] for one in segments[:253]] == found[:253].tolist(), segments[:3]
    assert [one["voxels"] for one in segments] == [*counts[:253], sum(counts[253:])], segments[-3:]
    assert "Of 300 segments the 47 smallest share one colour" in said, said


def files_of_one_study_are_times_if_asked(folder):
    """nibabel: three files whose names count from 9 to 11 are times in the order of their numbers."""
    paths = [save(nibabel.Nifti1Image(phantom(number).T, SAGITTAL), folder / f"vol{number}.nii")
             for number in (9, 10, 11)]
    for time, path in enumerate(paths):
        found, _ = read(paths[0], time=time, files_are_times=True)
        compare(found, by_nibabel(path)[0])


# FreeSurfer, AFNI and MINC.


def frames_of_freesurfer(folder):
    """nibabel: an oblique MGZ of floats with three frames and a repetition time of 2 s."""
    image = nibabel.MGHImage(phantom(shape=(3, 4, 5, 6), kind="f4").T, OBLIQUE)
    image.header["tr"] = 2000.0
    path = save(image, folder / "a.mgz")
    agree(path, by_nibabel(path), times=[0, 2, 4])


def write_afni(folder, bricks, factors, attributes):
    """Writes an AFNI pair with a type and a factor for each brick; nibabel reads AFNI only."""
    codes = {"u1": 0, "i2": 1, "f4": 3}
    count = len(bricks)
    numbers = {"DATASET_RANK": ("integer", [3, count]), "DATASET_DIMENSIONS": ("integer", [6, 5, 4]),
               "BRICK_TYPES": ("integer", [codes[brick.dtype.str[1:]] for brick in bricks]),
               "BRICK_FLOAT_FACS": ("float", factors), "SCENE_DATA": ("integer", [0, 2, 0]),
               "TYPESTRING": ("string", "3DIM_HEAD_ANAT"), "BYTEORDER_STRING": ("string", "MSB_FIRST"),
               **attributes}
    text = ""
    for name, (kind, value) in numbers.items():
        body = f"'{value}~" if kind == "string" else " " + " ".join(map(str, value))
        length = len(value) + 1 if kind == "string" else len(value)
        text += f"\ntype = {kind}-attribute\nname = {name}\ncount = {length}\n{body}\n"
    (folder / "a+orig.HEAD").write_text(text)
    (folder / "a+orig.BRIK").write_bytes(b"".join(
        brick.astype(brick.dtype.newbyteorder(">")).tobytes() for brick in bricks))
    return folder / "a+orig.HEAD"


def factors_of_bricks_of_afni(folder):
    """nibabel: three bricks of shorts in big endian, the second without a factor, from back to front."""
    bricks = [phantom(number, kind="i2") for number in range(3)]
    path = write_afni(folder, bricks, [0.5, 0.0, 2.0], {
        "ORIENT_SPECIFIC": ("integer", [1, 2, 4]), "ORIGIN": ("float", [10.0, 20.0, -30.0]),
        "DELTA": ("float", [-0.7, 0.8, 2.5]), "IJK_TO_DICOM_REAL": ("float", [
            -0.7, 0.0, 0.0, 10.0, 0.0, 0.0, 2.5, 20.0, 0.0, 0.8, 0.0, -30.0]),
        "TAXIS_NUMS": ("integer", [3, 0, 77002]), "TAXIS_FLOATS": ("float", [0, 2.5, 0, 0, 0])})
    others = by_nibabel(path)
    agree(path, others, times=[0, 2.5, 5])


def write_minc(path, values, dimensions, extremes=None, valid_range=None):
    """Writes MINC 2 of dimensions (name, start, step, cosines), slowest first; nibabel reads it only."""
    with h5py.File(path, "w") as file:
        for (name, start, step, cosines), length in zip(dimensions, values.shape):
            data = file.create_dataset(f"minc-2.0/dimensions/{name}", data=numpy.int32(0))
            data.attrs.update({"start": float(start), "step": float(step), "length": numpy.int32(length),
                               "spacing": numpy.bytes_("regular__")})
            if cosines is not None:
                data.attrs["direction_cosines"] = numpy.array(cosines, float)
        image = file.create_dataset("minc-2.0/image/0/image", data=values)
        image.attrs["dimorder"] = numpy.bytes_(",".join(name for name, *_ in dimensions))
        if valid_range:
            image.attrs["valid_range"] = numpy.array(valid_range, float)
        least, most = extremes if extremes else (0.0, 1.0)
        for name, value in ("image-min", least), ("image-max", most):
            stored = file.create_dataset(f"minc-2.0/image/0/{name}", data=value)
            stored.attrs["dimorder"] = numpy.bytes_(dimensions[0][0] if numpy.ndim(value) else "")


def minc_with_negative_steps_along_turned_axes(folder):
    """nibabel: the fastest axis is y, two axes run backwards, and all are turned about z."""
    c, s = numpy.cos(0.3), numpy.sin(0.3)
    write_minc(folder / "a.mnc", phantom(kind="u2"), [
        ("zspace", 30, -2.5, (0, 0, 1)), ("xspace", -10, 0.7, (c, s, 0)), ("yspace", 20, -0.8, (-s, c, 0))],
        (-5.0, 60.0), (0, 1000))
    agree(folder / "a.mnc", by_nibabel(folder / "a.mnc"))


def minc_with_extremes_of_each_slice(folder):
    """nibabel: signed bytes of sagittal slices, each with a smallest and a largest value of its own."""
    write_minc(folder / "a.mnc", (phantom(shape=(4, 5, 6)) % 256 - 128).astype("i1"), [
        ("xspace", -10, 2.5, None), ("zspace", 0, 0.8, None), ("yspace", 5, 0.7, None)],
        (numpy.arange(4.0), 10.0 + 3 * numpy.arange(4)), (-128, 127))
    agree(folder / "a.mnc", by_nibabel(folder / "a.mnc"))


def times_of_minc(folder):
    """nibabel: time before the axes of space, from 1 s on, each 1.5 s later."""
    write_minc(folder / "a.mnc", phantom(shape=(3, 4, 5, 6), kind="f4") / 3, [
        ("time", 1.0, 1.5, None), ("zspace", 30, 2.5, None), ("yspace", -20, 0.8, None),
        ("xspace", -10, 0.7, None)])
    times = nibabel.load(str(folder / "a.mnc")).get_fdata()  # [time, z, y, x]
    affine = from_ras(numpy.array(((0.7, 0, 0, -10), (0, 0.8, 0, -20), (0, 0, 2.5, 30), (0, 0, 0, 1.0))))
    agree(folder / "a.mnc", [Volume(one, affine) for one in times], times=[1, 2.5, 4])


if __name__ == "__main__":
    run(globals())
