#!/usr/bin/env python3
"""Inputs of NRRD, MetaImage, MIF and VTI, whose axes are easily taken for others.

Each is compared with teem's unu, VTK's reader of MetaImage, mrconvert of MRtrix, or Python's parsers
of XML and base64, as it says. unu and mrconvert also write most of them.
Usage: grid_inputs.py [INPUT...]
"""

import base64
import subprocess
import xml.etree.ElementTree
import zlib

import nibabel
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkMetaImageReader

from comparison import Volume, affine_of, agree, from_ras, phantom, refused, run

SIDES = "which side is the patient's left"
TURN = numpy.array(((0.6, -0.8, 0), (0.8, 0.6, 0), (0, 0, 1)))


def unu(*arguments):
    """Runs teem's unu."""
    subprocess.run(["teem-unu", *map(str, arguments)], check=True, capture_output=True)


def raw_nrrd(path, values, *options):
    """Writes an array, whose last index runs fastest, by unu."""
    raw = path.with_suffix(".bytes")
    raw.write_bytes(values.tobytes())
    unu("make", "-i", raw, "-t", {"u2": "ushort", "i2": "short", "f4": "float"}[values.dtype.str[1:]],
        "-s", *values.shape[::-1], "-en", "little", *options, "-o", path)
    return path


def by_unu(path, signs=(1, 1, 1)):
    """The array [..., y, x] that unu reads, and the matrix to LPS of the axes that have directions.

    signs: those of the axes of its space in LPS.
    """
    plain = path.with_name("unu.nrrd")
    unu("save", "-i", path, "-f", "nrrd", "-e", "raw", "-o", plain)
    header, voxels = plain.read_bytes().split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line)
    kinds = {"unsigned short": "u2", "short": "i2", "float": "f4"}
    order = ">" if fields.get("endian") == "big" else "<"
    shape = [int(size) for size in fields["sizes"].split()][::-1]
    values = numpy.frombuffer(voxels, order + kinds[fields["type"]]).reshape(shape)
    vectors = [[float(x) for x in word.strip("()").split(",")]
               for word in fields["space directions"].split() if word != "none"]
    origin = [float(x) for x in fields["space origin"].strip("()").split(",")]
    columns = numpy.diag(signs) @ numpy.array(vectors).T
    return values, affine_of((1, 1, 1), numpy.diag(signs) @ origin, columns)


# NRRD.


def nrrd_in_ras_with_permuted_axes(folder):
    """unu: axes exchanged and one flipped, after which the directions follow."""
    path = raw_nrrd(folder / "a.nrrd", phantom(), "-spc", "right-anterior-superior", "-orig", "(10,20,30)",
                    "-dirs", "(0.7,0,0) (0,0.8,0) (0,0,2.5)")
    unu("permute", "-i", path, "-p", 2, 0, 1, "-o", path)
    unu("flip", "-i", path, "-a", 1, "-o", path)
    agree(path, Volume(*by_unu(path, (-1, -1, 1))))


def oblique_nrrd_in_hexadecimal(folder):
    """unu: directions that are no right angles to the patient, a detached header, hexadecimal bytes."""
    path = raw_nrrd(folder / "a.nrrd", phantom(), "-spc", "LPS", "-orig", "(-10,-20,30)",
                    "-dirs", "(0.42,0.56,0) (-0.64,0.48,0) (0,0,-2.5)")
    unu("save", "-i", path, "-f", "nrrd", "-e", "hex", "-o", folder / "b.nhdr")
    agree(folder / "b.nhdr", Volume(*by_unu(path)))


def nrrd_whose_first_axis_is_a_list(folder):
    """unu: three volumes whose values alternate, in big endian and gzip."""
    path = raw_nrrd(folder / "a.nrrd", phantom(shape=(4, 5, 6, 3)), "-spc", "LAS", "-orig", "(1,2,3)",
                    "-dirs", "none (0.7,0,0) (0,0.8,0) (0,0,2.5)", "-k", "list", "space", "space", "space")
    unu("save", "-i", path, "-f", "nrrd", "-e", "gzip", "-en", "big", "-o", path)
    values, affine = by_unu(path, (1, -1, 1))
    agree(path, [Volume(values[..., index], affine) for index in range(3)], times=[0, 1, 2])


def nrrd_of_vectors_at_the_end(folder):
    """unu: three numbers of a vector behind the axes of space."""
    path = raw_nrrd(folder / "a.nrrd", phantom(shape=(3, 4, 5, 6), kind="f4") / 3, "-spc", "LPS",
                    "-orig", "(1,2,3)", "-dirs", "(0.7,0,0) (0,0.8,0) (0,0,2.5) none",
                    "-k", "space", "space", "space", "3-vector")
    values, affine = by_unu(path)
    agree(path, Volume(numpy.moveaxis(values, 0, -1), affine))


def cropped_nrrd_begins_elsewhere(folder):
    """unu: a part of a volume, whose origin unu moves."""
    path = raw_nrrd(folder / "a.nrrd", phantom(kind="i2"), "-spc", "RAS", "-orig", "(10,20,30)",
                    "-dirs", "(0.7,0,0) (0,0.8,0) (0,0,2.5)")
    unu("crop", "-i", path, "-min", 1, 2, 1, "-max", "M-1", "M", "M", "-o", path)
    values, affine = by_unu(path, (-1, -1, 1))
    assert values.shape == (3, 3, 4)
    agree(path, Volume(values, affine))


def nrrd_of_no_patient_says_so(folder):
    """unu: a right-handed space of no patient."""
    path = raw_nrrd(folder / "a.nrrd", phantom(), "-spc", "3D-right-handed", "-orig", "(1,2,3)",
                    "-dirs", "(0.7,0,0) (0,0.8,0) (0,0,2.5)")
    agree(path, Volume(*by_unu(path)), SIDES)


# MetaImage. VTK's reader has values, spacing and origin; MetaIO's description says what directions are.


def by_vtk(path, columns=numpy.eye(3)):
    """The volume that VTK reads, with directions along the columns of a matrix."""
    reader = vtkMetaImageReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    scalars = vtk_to_numpy(image.GetPointData().GetScalars())
    shape = image.GetDimensions()[::-1] + scalars.shape[1:]
    return Volume(scalars.reshape(shape), affine_of(image.GetSpacing(), image.GetOrigin(), columns))


def write_meta(path, values, pixels, **fields):
    """Writes a header of MetaImage, with the pixels behind it unless they are in files."""
    kinds = {"u1": "MET_UCHAR", "i2": "MET_SHORT", "u2": "MET_USHORT", "f4": "MET_FLOAT"}
    entries = {"ObjectType": "Image", "NDims": 3, "BinaryData": "True", "Offset": "-10 -20 30",
               "ElementSpacing": "0.7 0.8 2.5", "DimSize": "6 5 4",
               "ElementType": kinds[values.dtype.str[1:]], **fields}
    entries.setdefault("ElementDataFile", "LOCAL")
    text = "".join(f"{name} = {value}\n" for name, value in entries.items())
    path.write_bytes(text.encode() + pixels)
    return path


def directions_of_metaimage_in_zlib(folder):
    """VTK: compressed shorts of big endian, whose matrix has the direction of an axis in each row."""
    values = phantom(kind="i2") - 400
    packed = zlib.compress(values.astype(">i2").tobytes())
    path = write_meta(folder / "a.mha", values, packed, BinaryDataByteOrderMSB="True",
                      CompressedData="True", CompressedDataSize=len(packed),
                      TransformMatrix=" ".join(f"{x:g}" for x in TURN.T.ravel()))
    agree(path, by_vtk(path, TURN))


def channels_of_metaimage_in_text(folder):
    """NumPy, and VTK for the place: three channels in text, of which VTK 9.1 mistakes two."""
    values = phantom(shape=(4, 5, 6, 3), kind="u1")
    text = " ".join(map(str, values.ravel().tolist())).encode() + b"\n"
    path = write_meta(folder / "a.mha", values, text, BinaryData="False", ElementNumberOfChannels=3)
    numbers = numpy.array(path.read_bytes().split(b"LOCAL\n")[1].split(), float)
    agree(path, by_vtk(path)._replace(values=numbers.reshape(values.shape)), SIDES)


def metaimage_with_a_header_before_its_pixels(folder):
    """VTK: pixels at the end of a file, behind bytes that nobody counts."""
    values = phantom(kind="f4") / 3
    (folder / "a.raw").write_bytes(b"\xff" * 777 + values.tobytes())
    path = write_meta(folder / "a.mhd", values, b"", HeaderSize=-1, ElementDataFile="a.raw",
                      TransformMatrix="1 0 0 0 1 0 0 0 1")
    agree(path, by_vtk(path))


def slices_of_metaimage_in_a_pattern(folder):
    """VTK: a file for each slice, of which every second is named."""
    values = phantom()
    for z in range(4):
        (folder / f"s{2 * z + 1:02}.raw").write_bytes(values[z].tobytes())
    path = write_meta(folder / "a.mhd", values, b"", ElementDataFile="s%02d.raw 1 7 2")
    agree(path, by_vtk(path))


# MIF. mrconvert makes it of NIfTI, which nibabel reads.


def mif_of(folder, values, name, *options):
    """A file that mrconvert makes, and its volumes."""
    affine = numpy.array(((0.42, -0.64, 0, 5), (0.56, 0.48, 0, -7), (0, 0, 2.5, 9), (0, 0, 0, 1.0)))
    nibabel.save(nibabel.Nifti1Image(values.T, affine), str(folder / "a.nii"))
    image = nibabel.load(str(folder / "a.nii"))
    subprocess.run(["mrconvert", "-quiet", "-config", "RealignTransform", "false",
                    str(folder / "a.nii"), str(folder / name), *options], check=True)
    stored = image.get_fdata().T
    return folder / name, [Volume(one, from_ras(image.affine))
                           for one in (stored if stored.ndim == 4 else [stored])]


def mif_from_head_to_feet(folder):
    """mrconvert: z runs fastest and backwards, then x backwards."""
    path, others = mif_of(folder, phantom(kind="i2"), "b.mif", "-strides", "-2,3,-1")
    agree(path, others)


def mif_of_alternating_times(folder):
    """mrconvert: the times of a voxel lie beside each other, in big endian."""
    path, others = mif_of(folder, phantom(shape=(3, 4, 5, 6), kind="f4") / 7, "b.mif",
                          "-strides", "2,3,4,1", "-datatype", "float32be", "-vox", ",,,2.5")
    agree(path, others, times=[0, 2.5, 5])


def voxels_of_mif_in_another_file(folder):
    """mrconvert: a header that names a file of voxels, and so has no line END."""
    path, others = mif_of(folder, phantom(kind="i2"), "b.mih", "-strides", "1,-3,2")
    assert b"END" not in path.read_bytes()
    agree(path, others)


def compressed_mif_of_doubles(folder):
    """mrconvert: a file of gzip, turned to the sides of the patient."""
    path, others = mif_of(folder, phantom(kind="i2"), "b.mif.gz", "-datatype", "float64",
                          "-strides", "3,1,2")
    agree(path, others)


def bits_of_mif_are_refused(folder):
    """mrconvert: masks have a bit for each voxel."""
    path, _ = mif_of(folder, (phantom(kind="i2") > 500).astype("i2"), "b.mif", "-datatype", "bit")
    refused(path, "Bit")


# VTI, which VTK's reader reads for varimarch: Python's XML and base64 are the other program.


def write_vti(path, arrays, extent, **attributes):
    """Writes VTI with arrays as (place, name, text, values); the text is what DataArray contains."""
    root = xml.etree.ElementTree.Element("VTKFile", {"type": "ImageData", "version": "1.0",
                                                     "byte_order": "LittleEndian",
                                                     "header_type": "UInt64", **attributes})
    image = xml.etree.ElementTree.SubElement(root, "ImageData", {
        "WholeExtent": extent, "Origin": "-10 -20 30", "Spacing": "0.7 0.8 2.5",
        "Direction": " ".join(f"{x:g}" for x in TURN.ravel())})
    piece = xml.etree.ElementTree.SubElement(image, "Piece", Extent=extent)
    for place, name, form, content in arrays:
        data = xml.etree.ElementTree.SubElement(piece, place, Scalars=name)
        array = xml.etree.ElementTree.SubElement(data, "DataArray", type="UInt16", Name=name, format=form)
        array.text = content
    xml.etree.ElementTree.ElementTree(root).write(str(path), xml_declaration=True)
    return path


def by_elementtree(path, decoded):
    """The volume of a file by its text: where its first point lies, and what its array holds."""
    image = xml.etree.ElementTree.parse(str(path)).getroot().find("ImageData")
    extent = [int(x) for x in image.get("WholeExtent").split()]
    numbers = {name: numpy.array([float(x) for x in image.get(name).split()])
               for name in ("Origin", "Spacing", "Direction")}
    columns = numbers["Direction"].reshape(3, 3)
    array = next(image.iter("DataArray"))
    shift = numpy.array(extent[::2]) + (0.5 if next(image.iter("CellData"), None) is not None else 0.0)
    origin = numbers["Origin"] + columns @ (numbers["Spacing"] * shift)
    return Volume(decoded(array.text), affine_of(numbers["Spacing"], origin, columns))


def vti_whose_extent_begins_elsewhere(folder):
    """ElementTree: a turned image whose first point has the index (2, -3, 4), in text."""
    values = phantom()
    path = write_vti(folder / "a.vti", [("PointData", "v", "ascii", " ".join(map(str, values.ravel())))],
                     "2 7 -3 1 4 7")
    agree(path, by_elementtree(path, lambda text: numpy.array(text.split(), float).reshape(4, 5, 6)))


def cells_of_vti_in_compressed_base64(folder):
    """ElementTree, base64 and zlib: values in cells, whose centres lie half a step from the points."""
    values = phantom()
    packed = zlib.compress(values.tobytes())
    sizes = numpy.array((1, values.nbytes, 0, len(packed)), "u8").tobytes()
    text = base64.b64encode(sizes).decode() + base64.b64encode(packed).decode()
    path = write_vti(folder / "a.vti", [("CellData", "v", "binary", text)], "0 6 0 5 0 4",
                     compressor="vtkZLibDataCompressor")

    def decoded(content):
        # 32 bytes of sizes are 44 letters.
        return numpy.frombuffer(zlib.decompress(base64.b64decode(content[44:])), "u2").reshape(4, 5, 6)

    agree(path, by_elementtree(path, decoded))


if __name__ == "__main__":
    run(globals())
