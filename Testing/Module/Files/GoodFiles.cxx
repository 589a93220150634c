#include "GoodFiles.h"

#include "PhantomFormats.h"
#include "PhantomLibraryFiles.h"

namespace
{

/// The bytes of a file that a library writes.
template <class Write>
std::string BytesOf(Write write, const std::string& name = "file.png")
{
  const TemporaryFolder folder;
  write(folder.Path(name));
  return folder.Bytes(name);
}

}

StoredVolume PhantomOfBytes()
{
  StoredVolume volume = phantom::Stored(0);
  volume.scalarType = VTK_UNSIGNED_CHAR;
  return volume;
}

std::vector<GoodFile> MoreGoodFiles()
{
  const StoredVolume volume = phantom::Stored(0);
  const StoredVolume bytes = PhantomOfBytes();
  const std::string mif = MifHeaderText(volume, { 2, 0, 1 }, { true, false, true });
  const auto picture = [&](const std::string& path) { WritePicture(path, bytes, 0); };
  // A PVM file has comments after its voxels, a BMP file at most three bytes after its last row.
  return { { "a.mgh", MghBytes(volume) }, { "a.mgz", Gzipped(MghBytes(volume)), 12 },
    { "a.gipl", GiplBytes(volume) }, { "a.mrc", MrcBytes(volume) },
    { "a.mif", mif + VoxelBytes(volume) }, { "a.npy", NpyBytes(volume, { 3, 4, 5 }) },
    { "a.slc", SlcBytes(bytes, false) }, { "b.slc", SlcBytes(bytes, true) },
    { "a.pvm", PvmBytes(bytes), 8 }, { "b.pvm", DdsBytes(PvmBytes(bytes), 1, 5), 24 },
    { "a.tif", BytesOf([&](const std::string& path) { WriteTiff(path, volume); }) },
    { "lzw.tif",
      BytesOf(
        [&](const std::string& path) {
          WriteTiff(path, volume, { "", 1, false, true, 5 });
        }) },
    { "a.png", BytesOf(picture) }, { "a.jpg", BytesOf(picture, "file.jpg") },
    { "a.bmp", BytesOf(picture, "file.bmp"), 3 },
    { "a.h5",
      BytesOf([&](const std::string& path) { WriteHdf5(path, volume, Hdf5Kind::DataSet); }) },
    { "1.mnc", BytesOf([&](const std::string& path) { WriteMinc1(path, volume); }) },
    { "2.mnc", BytesOf([&](const std::string& path) { WriteMinc2(path, volume); }) } };
}
