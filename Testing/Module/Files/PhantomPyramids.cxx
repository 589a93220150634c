// Files with chunks and levels: Zarr, and the kinds of HDF5.
#include "PhantomLibraryFiles.h"
#include "PhantomText.h"

#include <glm/geometric.hpp>

#include <blosc.h>
#include <hdf5.h>

#include <algorithm>

namespace
{

/// Writes numbers as an attribute.
void PutNumbers(hid_t object, const char* name, const std::vector<double>& numbers)
{
  const hsize_t count = numbers.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t attribute = H5Acreate(object, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, numbers.data());
  H5Aclose(attribute);
  H5Sclose(space);
}

/// Writes a text as an attribute of single letters, as Imaris does.
void PutLetters(hid_t object, const std::string& name, const std::string& text)
{
  const hsize_t count = text.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t attribute =
    H5Acreate(object, name.c_str(), H5T_C_S1, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_C_S1, text.data());
  H5Aclose(attribute);
  H5Sclose(space);
}

hid_t NewGroup(hid_t file, const char* name)
{
  const hid_t links = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(links, 1);
  const hid_t group = H5Gcreate(file, name, links, H5P_DEFAULT, H5P_DEFAULT);
  H5Pclose(links);
  return group;
}

/// Writes the voxels in chunks of two slices.
void PutVoxels(hid_t file, const char* name, const StoredVolume& volume)
{
  const auto& size = volume.dimensions;
  const hsize_t sizes[3] = { hsize_t(size[2]), hsize_t(size[1]), hsize_t(size[0]) };
  const hsize_t chunk[3] = { std::min<hsize_t>(2, sizes[0]), sizes[1], sizes[2] };
  const hid_t space = H5Screate_simple(3, sizes, nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 3, chunk);
  H5Pset_deflate(creation, 6);
  const hid_t links = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(links, 1);
  const hid_t data = H5Dcreate(file, name, H5T_STD_I16LE, space, links, creation, H5P_DEFAULT);
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, volume.values.data());
  PutNumbers(data, "element_size_um", { 3.0, 2.0, 1.0 });
  H5Dclose(data);
  H5Pclose(links);
  H5Pclose(creation);
  H5Sclose(space);
}

void PutImaris(hid_t file, const StoredVolume& volume)
{
  const hid_t image = NewGroup(file, "DataSetInfo/Image");
  const char* const group = "DataSet/ResolutionLevel 0/TimePoint 0/Channel 0";
  PutVoxels(file, "DataSet/ResolutionLevel 0/TimePoint 0/Channel 0/Data", volume);
  const hid_t channel = H5Gopen(file, group, H5P_DEFAULT);
  PutLetters(image, "Unit", "um");
  for (int axis = 0; axis < 3; ++axis)
  {
    PutLetters(image, Text("ExtMin", axis), "0");
    PutLetters(image, Text("ExtMax", axis), "12");
    PutLetters(channel, std::string("ImageSize") + "XYZ"[axis], Text(volume.dimensions[axis]));
  }
  H5Gclose(channel);
  H5Gclose(image);
}

void PutBigDataViewer(hid_t file, const StoredVolume& volume)
{
  PutVoxels(file, "t00000/s00/0/cells", volume);
  H5Gclose(NewGroup(file, "s00"));
  const hsize_t sizes[2] = { 1, 3 };
  const double factors[3] = { 1.0, 1.0, 1.0 };
  const hid_t space = H5Screate_simple(2, sizes, nullptr);
  const hid_t data = H5Dcreate(
    file, "s00/resolutions", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, factors);
  H5Dclose(data);
  H5Sclose(space);
}

using SizeOfHdf5 = std::array<hsize_t, 3>;

SizeOfHdf5 SlowestFirst(const std::array<int, 3>& numbers)
{
  return { hsize_t(numbers[2]), hsize_t(numbers[1]), hsize_t(numbers[0]) };
}

}

void WriteHdf5(const std::string& path, const StoredVolume& volume, Hdf5Kind kind)
{
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  switch (kind)
  {
    case Hdf5Kind::DataSet:
      PutVoxels(file, "volume", volume);
      break;
    case Hdf5Kind::BigDataViewer:
      PutBigDataViewer(file, volume);
      break;
    case Hdf5Kind::Imaris:
      PutImaris(file, volume);
      break;
  }
  H5Fclose(file);
}

void WriteSparseHdf5(const std::string& path, const SparseVolume& volume)
{
  const SizeOfHdf5 size = SlowestFirst(volume.size);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(3, size.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 3, SlowestFirst(volume.chunk).data());
  H5Pset_fill_value(creation, H5T_NATIVE_INT, &volume.fill);
  const hid_t data =
    H5Dcreate(file, "volume", H5T_STD_I16LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  for (int i = 0; i < volume.size[0] * volume.size[1] * volume.size[2]; ++i)
  {
    const std::array<int, 3> at = { i % volume.size[0], i / volume.size[0] % volume.size[1],
      i / (volume.size[0] * volume.size[1]) };
    const auto& chunk = volume.chunk;
    const bool isFirst = at[0] % chunk[0] == 0 && at[1] % chunk[1] == 0 && at[2] % chunk[2] == 0;
    if (isFirst && volume.isStored({ at[0] / chunk[0], at[1] / chunk[1], at[2] / chunk[2] }))
    {
      const SizeOfHdf5 count = SlowestFirst({ std::min(chunk[0], volume.size[0] - at[0]),
        std::min(chunk[1], volume.size[1] - at[1]), std::min(chunk[2], volume.size[2] - at[2]) });
      H5Sselect_hyperslab(
        space, H5S_SELECT_SET, SlowestFirst(at).data(), nullptr, count.data(), nullptr);
      H5Dwrite(data, H5T_NATIVE_SHORT, space, space, H5P_DEFAULT, volume.voxels.data());
    }
  }
  H5Dclose(data);
  H5Pclose(creation);
  H5Sclose(space);
  H5Fclose(file);
}

std::string ZarrArrayText(const StoredVolume& volume, const std::string& compressor)
{
  const auto& size = volume.dimensions;
  const std::string shape = Text('[', size[2], ", ", size[1], ", ", size[0], ']');
  return Text(R"({"zarr_format": 2, "shape": )", shape, R"(, "chunks": )", shape, R"(, "dtype": ")",
    volume.scalarType == VTK_SHORT ? "<i2" : "<u4", R"(", "compressor": )", compressor,
    R"(, "fill_value": 0, "order": "C", "filters": null})");
}

std::string OmeZarrText(const StoredVolume& volume)
{
  const auto axis = [](const char* name)
  { return Text(R"({"name": ")", name, R"(", "type": "space", "unit": "millimeter"})"); };
  const auto& steps = volume.axesMm;
  return Text(R"({"multiscales": [{"version": "0.4", "axes": [)", axis("z"), ", ", axis("y"), ", ",
    axis("x"), R"(], "datasets": [{"path": "0", "coordinateTransformations": [{"type": "scale", )",
    R"("scale": [)", glm::length(steps[2]), ", ", glm::length(steps[1]), ", ",
    glm::length(steps[0]), R"(]}, {"type": "translation", "translation": [)", volume.originMm.z,
    ", ", volume.originMm.y, ", ", volume.originMm.x, "]}]}]}]}");
}

std::string Blosced(const std::string& bytes, const std::string& method)
{
  std::string packed(bytes.size() + BLOSC_MAX_OVERHEAD, '\0');
  const int count = blosc_compress_ctx(5, BLOSC_SHUFFLE, 2, bytes.size(), bytes.data(),
    packed.data(), packed.size(), method.c_str(), 0, 1);
  packed.resize(std::size_t(std::max(0, count)));
  return packed;
}
