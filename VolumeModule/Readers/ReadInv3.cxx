// InVesalius projects: an archive, which is unpacked before, with a property list main.plist and
// the voxels in a file that it names. See https://github.com/invesalius/invesalius3
#include "Readers/FileContent.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/NumberText.h"
#include "Readers/Plist.h"
#include "Readers/VoxelFile.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace varimarch
{
namespace
{

/// The path of a file of a project; fails if there is none.
std::string FileOfProject(const std::string& path, const std::string& name)
{
  for (const std::string& file : FilesBelow(path))
  {
    if (std::filesystem::path(file).filename() == name)
    {
      return file;
    }
  }
  FailToRead(path, "an archive with the file " + Quoted(name), "none of that name");
}

Plist ReadProject(const std::string& path)
{
  // Real property lists have a few kB.
  constexpr std::uint64_t mostBytes = 1 << 24;
  const std::string file = FileOfProject(path, InVesaliusFile);
  const std::uint64_t byteCount = ReadableFileSize(file);
  if (byteCount > mostBytes)
  {
    FailToRead(path, "a main.plist of at most 16 MB", ByteText(double(byteCount)));
  }
  std::string bytes(std::size_t(byteCount), '\0');
  OpenStream(file, Compression::None)->Read(bytes.data(), bytes.size());
  return Plist(path, bytes);
}

/// Converts a numpy type name to a VTK type.
int TypeOfName(const std::string& path, const std::string& name)
{
  static const std::map<std::string, int> types = {
    { "int8", VTK_SIGNED_CHAR },
    { "uint8", VTK_UNSIGNED_CHAR },
    { "int16", VTK_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT },
    { "int32", VTK_INT },
    { "uint32", VTK_UNSIGNED_INT },
    { "int64", VTK_TYPE_INT64 },
    { "uint64", VTK_TYPE_UINT64 },
    { "float32", VTK_FLOAT },
    { "float64", VTK_DOUBLE },
  };
  const auto type = types.find(name);
  if (type == types.end())
  {
    FailToRead(path, "a matrix of integers or floats of 8 to 64 bits", "the type " + Quoted(name));
  }
  return type->second;
}

VoxelLayout LayoutOf(const std::string& path, const Plist& matrix)
{
  const std::vector<std::string> shape = matrix.Texts("shape");
  if (shape.size() != 3)
  {
    FailToRead(path, "a matrix with 3 dimensions", std::to_string(shape.size()));
  }
  VoxelLayout layout = { {}, TypeOfName(path, matrix.Text("dtype")) };
  // The slowest axis comes first.
  std::transform(shape.rbegin(), shape.rend(), layout.dimensions.begin(),
    [&](const std::string& word) { return IntegerFromText(path, "whole dimensions", word); });
  return layout;
}

ImageGeometry GeometryOf(const std::string& path, const Plist& project)
{
  const std::vector<std::string> words = project.Texts("spacing");
  if (words.size() != 3)
  {
    FailToRead(path, "a spacing of 3 numbers", std::to_string(words.size()));
  }
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis][axis] = NumberFromText(path, "a spacing of numbers", words[axis]);
  }
  // InVesalius stores rows from the patient's back to the front, columns from right to left and
  // slices from feet to head, for any orientation of the scan. It stores no origin.
  geometry.axesMm[1] *= -1.0;
  return geometry;
}

vtkSmartPointer<vtkImageData> ReadMatrix(
  const std::string& path, const Plist& matrix, ReadProgress& progress)
{
  const VoxelLayout layout = LayoutOf(path, matrix);
  const std::string file = FileOfProject(path, matrix.Text("filename"));
  if (ReadableFileSize(file) != CheckedByteCount(path, layout))
  {
    FailToRead(path, Text(layout) + " (" + ByteText(double(CheckedByteCount(path, layout))) + ")",
      ByteText(double(ReadableFileSize(file))) + " in " + Quoted(matrix.Text("filename")));
  }
  VoxelFile voxels;
  voxels.paths = { file };
  return ReadVoxels(voxels, layout, progress);
}

}

Volume ReadInv3(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  if (!std::filesystem::is_directory(path))
  {
    FailToRead(path, "a tar archive", DescribedContent(FirstBytes(path)));
  }
  // The project's "name" is not read, because it is the patient's.
  const Plist project = ReadProject(path);
  const ImageGeometry geometry = GeometryOf(path, project);
  Volume volume;
  volume.image = ReadMatrix(path, project.Dictionary("matrix"), progress);
  PlaceImage(path, geometry, volume.image);

  const std::string modality = project.Text("modality");
  const bool isMr = modality == "MR" || modality == "MRI" || modality == "RMI";
  volume.modality = isMr ? "MR" : modality == "CT" ? "CT" : "";
  const std::string window = project.Text("window_width");
  const std::string level = project.Text("window_level");
  if (!window.empty() && !level.empty())
  {
    volume.windowLevel = { NumberFromText(path, "a number as window_width", window),
      NumberFromText(path, "a number as window_level", level) };
  }
  return volume;
}

}
