// A target for each volume format but DICOM.
#include "Fuzz/FuzzInput.h"
#include "Fuzz/FuzzTarget.h"
#include "Fuzz/ReadInput.h"
#include "Fuzz/VolumeSeeds.h"

namespace varimarch
{

namespace
{

/// A format: names of the files of an input, of which the first is opened, or the folder if `opens`
/// is empty.
struct VolumeRow
{
  const char* name;
  std::vector<std::string> files;
  std::string opens;
  std::vector<std::string> (*seeds)();
  std::vector<std::string> words;
};

const std::vector<std::string> XmlWords = { "<?xml version=\"1.0\"?>", "<![CDATA[", "<!DOCTYPE",
  "<!ENTITY", "&amp;", "&#0;", "/>", "-->" };

std::vector<std::string> WithXml(std::vector<std::string> words)
{
  words.insert(words.end(), XmlWords.begin(), XmlWords.end());
  return words;
}

std::vector<VolumeRow> TextRows()
{
  return {
    { "nrrd", { "a.nrrd", "b" }, "a.nrrd", NrrdSeeds,
      { "NRRD0005", "type: ", "block",
        "dimension: ", "sizes: ", "spacings: ", "space: ", "space directions: ", "space origin: ",
        "space dimension: ", "kinds: ", "centerings: ", "encoding: ", "raw", "gzip", "bzip2",
        "ascii", "hex", "endian: ", "line skip: ", "byte skip: ", "data file: ", "LIST",
        "%03d.raw 1 9 1", "measurement frame: ", "none", "nan", "units: ", ":=", "(1,0,0)" } },
    { "metaimage", { "a.mha", "b" }, "a.mha", MetaImageSeeds,
      { "ObjectType = Image", "NDims = ", "DimSize = ", "ElementType = ", "MET_UCHAR", "MET_DOUBLE",
        "MET_LONG_LONG", "ElementSpacing = ", "ElementSize = ", "Offset = ", "Position = ",
        "TransformMatrix = ", "Orientation = ", "AnatomicalOrientation = ",
        "ElementNumberOfChannels = ", "CompressedData = True",
        "CompressedDataSize = ", "BinaryData = False", "BinaryDataByteOrderMSB = True",
        "HeaderSize = -1", "ElementDataFile = ", "LOCAL", "LIST", "%03d.raw 1 9 1" } },
    { "afni", { "a.HEAD", "a.BRIK" }, "a.HEAD", AfniSeeds,
      { "type  = string-attribute", "type  = integer-attribute", "type  = float-attribute",
        "name  = ", "count = ", "DATASET_RANK", "DATASET_DIMENSIONS", "BRICK_TYPES",
        "BRICK_FLOAT_FACS", "BYTEORDER_STRING", "'MSB_FIRST~", "IJK_TO_DICOM_REAL", "ORIGIN",
        "DELTA", "ORIENT_SPECIFIC" } },
    { "mif", { "a.mif", "b" }, "a.mif", MifSeeds,
      { "mrtrix image", "dim: ", "vox: ", "layout: ", "datatype: ", "Bit", "CFloat32LE",
        "Float64BE", "transform: ", "scaling: ", "file: . 0", "file: b", "END" } },
    { "par", { "a.PAR", "a.REC" }, "a.PAR", ParRecSeeds,
      { "# === DATA DESCRIPTION FILE", "Research image export tool", "V4.2", "V3", "V4.1",
        "Max. number of slices/locations", "Angulation midslice(ap,fh,rl)[degr]",
        "Off Centre midslice(ap,fh,rl) [mm]", "Recon resolution (x, y)", "# === IMAGE" } },
    { "npy", { "a.npy" }, "a.npy", NpySeeds,
      { "\x93NUMPY", "'descr': '", "<f8", ">i2", "|u1", "<c8", "|b1", "'fortran_order': ", "True",
        "'shape': (", "3, 4, 5, " } },
  };
}

std::vector<VolumeRow> VtkRows()
{
  return {
    { "vti", { "a.vti" }, "a.vti", VtiSeeds,
      WithXml({ "<VTKFile", "type=\"ImageData\"", "byte_order=\"BigEndian\"", "WholeExtent=\"",
        "Extent=\"", "Origin=\"", "Spacing=\"", "Direction=\"", "<Piece", "<PointData", "<CellData",
        "<DataArray", "NumberOfComponents=\"", "format=\"appended\"", "offset=\"",
        "format=\"binary\"", "header_type=\"UInt64\"", "compressor=\"vtkZLibDataCompressor\"",
        "<AppendedData encoding=\"raw\">", "_" }) },
    { "pvti", { "a.pvti", "b" }, "a.pvti", PvtiSeeds,
      WithXml({ "<VTKFile type=\"PImageData\"", "<PImageData", "WholeExtent=\"", "<Piece Source=\"",
        "b", "a.pvti", "Extent=\"" }) },
    { "vtk", { "a.vtk" }, "a.vtk", LegacyVtkSeeds,
      { "# vtk DataFile Version", "ASCII", "BINARY", "DATASET STRUCTURED_POINTS", "DIMENSIONS",
        "SPACING", "ASPECT_RATIO", "ORIGIN", "POINT_DATA", "CELL_DATA", "SCALARS", "VECTORS",
        "TENSORS", "LOOKUP_TABLE", "FIELD", "METADATA", "unsigned_char", "vtktypeint64", "bit",
        "string" } },
  };
}

std::vector<VolumeRow> BinaryRows()
{
  return {
    { "nifti", { "a.nii" }, "a.nii", NiftiSeeds, { "n+1", "n+2", "ni1" } },
    { "analyze", { "a.hdr", "a.img", "a.mat" }, "a.hdr", AnalyzeSeeds, { "ni1", "M" } },
    { "inv3", { "a.inv3" }, "a.inv3", Inv3Seeds,
      WithXml({ "main.plist", "<key>", "<dict>", "<array>", "<integer>", "<string>", "<data>",
        "bplist00", "ustar", "matrix.dat" }) },
    { "tiff", { "a.tif" }, "a.tif", TiffSeeds,
      { "II*", "MM",
        "ImageJ=", "images=", "slices=", "channels=", "frames=", "spacing=", "hyperstack=true",
        "<OME", "<Pixels", "SizeX=\"", "DimensionOrder=\"XYZCT\"", "PhysicalSizeZ=\"" } },
    { "pictures", { "1.png", "2.png", "3.png", "4.png" }, "", PictureStackSeeds,
      { "IHDR", "IDAT", "IEND", "PLTE", "tRNS", "pHYs", "BM", "JFIF" } },
    { "mgh", { "a.mgh" }, "a.mgh", MghSeeds, {} },
    { "minc", { "a.mnc" }, "a.mnc", MincSeeds,
      { "CDF", "HDF", "minc-2.0", "/image/0/image", "xspace", "yspace", "zspace", "time",
        "direction_cosines", "valid_range", "image-max", "dimorder", "signtype" } },
    { "zarr", { "a/.zattrs", "a/0/.zarray", "a/0/0.0.0" }, "a/.zattrs", ZarrSeeds,
      { "\"multiscales\": ", "\"axes\": ", "\"name\": \"c\"", "\"unit\": \"micrometer\"",
        "\"datasets\": ", "\"path\": \"0\"",
        "\"coordinateTransformations\": ", "\"type\": \"scale\"",
        "\"translation\": ", "\"omero\": ", "\"shape\": ", "\"chunks\": ", "\"dtype\": \">f8\"",
        "\"compressor\": ", "{\"id\": \"blosc\"}", "{\"id\": \"lz4\"}", "{\"id\": \"zstd\"}",
        "\"filters\": ", "\"fill_value\": \"NaN\"", "\"order\": \"F\"" } },
    { "hdf5", { "a.h5" }, "a.h5", Hdf5Seeds,
      { "HDF", "DataSet", "ResolutionLevel 0", "TimePoint 0", "Channel 0", "Data", "ImageSizeX",
        "ExtMin0", "t00000", "s00", "cells", "resolutions", "element_size_um" } },
    { "bigdataviewer", { "a.xml", "a.h5" }, "a.xml", BigDataViewerSeeds,
      WithXml({ "<SpimData", "<ImageLoader format=\"bdv.hdf5\">", "<hdf5 type=\"relative\">",
        "a.h5", "<ViewSetups>", "<ViewSetup>", "<id>0</id>", "<voxelSize>", "<unit>um</unit>",
        "<size>" }) },
    { "gipl", { "a.gipl" }, "a.gipl", GiplSeeds, {} },
    { "mrc", { "a.mrc" }, "a.mrc", MrcSeeds, { "MAP " } },
    { "slc", { "a.slc" }, "a.slc", SlcSeeds, { "11111", "X" } },
    { "pvm", { "a.pvm" }, "a.pvm", PvmSeeds, { "PVM", "PVM2", "PVM3", "DDS v3d", "DDS v3e" } },
    { "archive", { "a.zip" }, "a.zip", ArchiveSeeds,
      { "PK", "ustar", "../", "a/head.mhd", "BZh9", "path=", "GNU.sparse.size=" } },
  };
}

}

std::vector<FuzzTarget> VolumeTargets()
{
  std::vector<VolumeRow> rows = TextRows();
  for (const std::vector<VolumeRow>& more : { VtkRows(), BinaryRows() })
  {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  std::vector<FuzzTarget> targets;
  for (const VolumeRow& row : rows)
  {
    const auto run = [files = row.files, opens = row.opens](const std::string& input)
    {
      Inputs().Replace(files, input);
      return ReadInput(Inputs().Path(opens));
    };
    std::vector<std::string> words = row.words;
    if (row.files.size() > 1)
    {
      words.push_back(FileBoundary);
    }
    targets.push_back({ row.name, run, row.seeds, words });
  }
  return targets;
}

}
