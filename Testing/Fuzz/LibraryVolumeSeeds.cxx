// Seeds of the formats whose files foreign libraries parse.
#include "Fuzz/VolumeSeeds.h"

#include "Fuzz/FuzzInput.h"
#include "Module/Files/GoodFiles.h"
#include "Module/Files/PhantomLibraryFiles.h"

#include <vtkXMLWriter.h>

namespace varimarch
{

namespace
{

/// The bytes of a file that a library writes.
template <class Write>
std::string BytesWrittenBy(const std::string& name, Write write)
{
  const TemporaryFolder folder;
  write(folder.Path(name));
  return folder.Bytes(name);
}

std::string Tiff(const StoredVolume& volume, const TiffOptions& options = {})
{
  return BytesWrittenBy(
    "a.tif", [&](const std::string& path) { WriteTiff(path, volume, options); });
}

/// Three slices as files of one kind of picture.
std::string Pictures(const std::string& extension)
{
  std::vector<std::string> slices;
  for (int slice = 0; slice < 3; ++slice)
  {
    slices.push_back(BytesWrittenBy("a" + extension,
      [&](const std::string& path) { WritePicture(path, PhantomOfBytes(), slice); }));
  }
  return JoinedFiles(slices);
}

}

std::vector<std::string> VtiSeeds()
{
  const StoredVolume volume = phantom::Stored(0);
  const auto encoded = [&](const VtiEncoding& encoding)
  { return EncodedVti(volume, VoxelBytes(volume, encoding.bigEndian), encoding); };
  return { VtiText(volume), VtiCellText(volume), encoded({ vtkXMLWriter::Binary }),
    encoded({ vtkXMLWriter::Appended }), encoded({ vtkXMLWriter::Appended, false }),
    encoded({ vtkXMLWriter::Appended, false, vtkXMLWriter::ZLIB }),
    encoded({ vtkXMLWriter::Binary, true, vtkXMLWriter::LZ4, false, 64 }),
    encoded({ vtkXMLWriter::Appended, false, vtkXMLWriter::LZMA, true }) };
}

std::vector<std::string> PvtiSeeds()
{
  const StoredVolume volume = phantom::Stored(0);
  return { JoinedFiles({ "<?xml version=\"1.0\"?>\n<VTKFile type=\"PImageData\" version=\"0.1\">\n"
                         "<PImageData WholeExtent=\"0 4 0 3 0 2\">\n<Piece Source=\"b\"/>\n"
                         "</PImageData>\n</VTKFile>\n",
    VtiText(volume) }) };
}

std::vector<std::string> LegacyVtkSeeds()
{
  const StoredVolume volume = phantom::Stored(0);
  const auto head = [](const std::string& mode)
  {
    return "# vtk DataFile Version 3.0\na volume\n" + mode +
      "\nDATASET STRUCTURED_POINTS\nDIMENSIONS 5 4 3\nSPACING 0.7 1.1 2.5\nORIGIN -10 -20 30\n"
      "POINT_DATA 60\nSCALARS values short\nLOOKUP_TABLE default\n";
  };
  return { head("ASCII") + VoxelText(volume), head("BINARY") + VoxelBytes(volume, true),
    "# vtk DataFile Version 4.2\nb\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
    "SPACING 1 1 1\nORIGIN 0 0 0\nCELL_DATA 1\nFIELD FieldData 1\ndensity 1 1 float\n5\n"
    "METADATA\nINFORMATION 0\n\n" };
}

std::vector<std::string> Inv3Seeds()
{
  const StoredVolume volume = phantom::Stored(0);
  const std::string project =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<plist version=\"1.0\"><dict>"
    "<key>matrix</key><dict><key>dtype</key><string>int16</string>"
    "<key>filename</key><string>matrix.dat</string><key>shape</key>"
    "<array><integer>3</integer><integer>4</integer><integer>5</integer></array></dict>"
    "<key>modality</key><string>CT</string>"
    "<key>spacing</key><array><real>0.7</real><real>1.1</real><real>2.5</real></array>"
    "<key>window_level</key><real>40.0</real><key>window_width</key><real>400.0</real>"
    "</dict></plist>\n";
  const std::vector<ArchiveEntry> entries = { { "a/main.plist", project },
    { "a/matrix.dat", VoxelBytes(volume) } };
  return { Archived(entries, "gnutar"), Archived(entries, "gnutar", "gzip") };
}

std::vector<std::string> TiffSeeds()
{
  const StoredVolume volume = phantom::Stored(0);
  constexpr int Lzw = 5;
  constexpr int Deflate = 8;
  return { Tiff(volume), Tiff(volume, { "", 1, false, true, Lzw }),
    Tiff(volume, { "ImageJ=1.53\nimages=3\nslices=3\nspacing=2.5\nunit=mm\n" }),
    Tiff(volume, { "", 1, false, false, Deflate, true, true, 10.0, 4 }) };
}

std::vector<std::string> PictureStackSeeds()
{
  return { Pictures(".png"), Pictures(".bmp"), Pictures(".jpg") };
}

std::vector<std::string> MincSeeds()
{
  const StoredVolume volume = phantom::Stored(0);
  const auto first = [&](const MincOptions& options)
  {
    return BytesWrittenBy(
      "1.mnc", [&](const std::string& path) { WriteMinc1(path, volume, options); });
  };
  const auto second = [&](const MincOptions& options)
  {
    return BytesWrittenBy(
      "2.mnc", [&](const std::string& path) { WriteMinc2(path, volume, options); });
  };
  return { first({}), first({ true, 2 }), second({}), second({ true, 2 }) };
}

std::vector<std::string> ZarrSeeds()
{
  const StoredVolume volume = phantom::Stored(0);
  const auto seed = [&](const std::string& compressor, const std::string& chunk) {
    return JoinedFiles({ OmeZarrText(volume), ZarrArrayText(volume, compressor), chunk });
  };
  const std::string voxels = VoxelBytes(volume);
  return { seed("null", voxels), seed(R"({"id": "blosc"})", Blosced(voxels, "zstd")),
    seed(R"({"id": "blosc"})", Blosced(voxels, "lz4")), seed(R"({"id": "zlib"})", Zlibbed(voxels)),
    seed(R"({"id": "zstd"})", Compressed(voxels, "zstd")) };
}

std::vector<std::string> Hdf5Seeds()
{
  const StoredVolume volume = phantom::Stored(0);
  const auto written = [&](Hdf5Kind kind) {
    return BytesWrittenBy("a.h5", [&](const std::string& path) { WriteHdf5(path, volume, kind); });
  };
  return { written(Hdf5Kind::DataSet), written(Hdf5Kind::BigDataViewer),
    written(Hdf5Kind::Imaris) };
}

std::vector<std::string> BigDataViewerSeeds()
{
  const std::string description =
    "<?xml version=\"1.0\"?><SpimData><SequenceDescription><ImageLoader format=\"bdv.hdf5\">"
    "<hdf5 type=\"relative\">a.h5</hdf5></ImageLoader><ViewSetups><ViewSetup><id>0</id>"
    "<voxelSize><unit>um</unit><size>1 2 3</size></voxelSize></ViewSetup></ViewSetups>"
    "</SequenceDescription></SpimData>";
  return { JoinedFiles({ description, Hdf5Seeds()[1] }) };
}

std::vector<std::string> ArchiveSeeds()
{
  const StoredVolume volume = phantom::Stored(0);
  const std::vector<ArchiveEntry> entries = { { "README.TXT", "a disc" },
    { "a/head.mhd", MetaImageHeaderText(volume) + "ElementDataFile = voxels.raw\n" },
    { "a/voxels.raw", VoxelBytes(volume) }, { "a/link", "", "../../outside" } };
  const std::string nrrd =
    NrrdHeaderText(volume) + "endian: little\nencoding: raw\n\n" + VoxelBytes(volume);
  return { Archived(entries, "zip"), Archived(entries, "pax", "gzip"),
    Archived(entries, "gnutar", "bzip2"), Archived(entries, "v7tar"), Compressed(nrrd, "xz"),
    Compressed(nrrd, "zstd") };
}

}
