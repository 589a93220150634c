// InVesalius projects: an archive, which is unpacked before, with a property list main.plist and
// the voxels in a file that it names. See https://github.com/invesalius/invesalius3
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/Parsing/Nesting.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/VoxelFile.h"

#include <plist/plist.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace varimarch
{
namespace
{

/// A dictionary, with keys and values, of an Apple property list in XML or binary.
class Plist
{
public:
  /// Parses a property list whose root is a dictionary.
  /// @param path  path for error messages
  /// @throws std::runtime_error if it is not one
  Plist(const std::string& path, const std::string& bytes);

  /// Text of a value that is a string or a number; empty if the key does not exist.
  std::string Text(const std::string& key) const;

  /// Texts of the values of an array; empty if the key does not exist.
  std::vector<std::string> Texts(const std::string& key) const;

  /// The dictionary with the given key.
  /// @throws std::runtime_error if there is none
  Plist Dictionary(const std::string& key) const;

private:
  using Node = void*; ///< libplist's plist_t

  Plist(const std::string& path, std::shared_ptr<void> root, Node dictionary);
  Node Value(const std::string& key) const;

  std::string path;
  std::shared_ptr<void> root; ///< owner of all nodes
  Node dictionary;
};

bool IsDictionary(plist_t node)
{
  return node && plist_get_node_type(node) == PLIST_DICT;
}

std::string TextOf(plist_t node)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  std::uint64_t integer = 0;
  double real = 0.0;
  switch (node ? plist_get_node_type(node) : PLIST_NONE)
  {
    case PLIST_STRING:
      text << plist_get_string_ptr(node, nullptr);
      break;
    case PLIST_UINT:
      // libplist keeps negative integers as their complements.
      plist_get_uint_val(node, &integer);
      text << std::int64_t(integer);
      break;
    case PLIST_REAL:
      plist_get_real_val(node, &real);
      text << real;
      break;
    default:
      break;
  }
  return text.str();
}

Plist::Plist(const std::string& path, const std::string& bytes)
  : path(path)
{
  if (MayBeNestedTooDeep(bytes))
  {
    FailToRead(path,
      "a property list of at most " + std::to_string(MostNestedElements) + " elements", "more");
  }
  plist_t top = nullptr;
  plist_from_memory(bytes.data(), std::uint32_t(bytes.size()), &top);
  this->root = std::shared_ptr<void>(top, &plist_free);
  this->dictionary = top;
  if (!IsDictionary(top))
  {
    FailToRead(path, "a property list that is a dictionary", Quoted(bytes));
  }
}

Plist::Plist(const std::string& path, std::shared_ptr<void> root, Node dictionary)
  : path(path)
  , root(std::move(root))
  , dictionary(dictionary)
{
}

Plist::Node Plist::Value(const std::string& key) const
{
  return plist_dict_get_item(this->dictionary, key.c_str());
}

std::string Plist::Text(const std::string& key) const
{
  return TextOf(this->Value(key));
}

std::vector<std::string> Plist::Texts(const std::string& key) const
{
  std::vector<std::string> texts;
  const Node value = this->Value(key);
  const std::uint32_t count =
    value && plist_get_node_type(value) == PLIST_ARRAY ? plist_array_get_size(value) : 0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    texts.push_back(TextOf(plist_array_get_item(value, i)));
  }
  return texts;
}

Plist Plist::Dictionary(const std::string& key) const
{
  const Node value = this->Value(key);
  if (!IsDictionary(value))
  {
    FailToRead(this->path, "a property list with the dictionary " + Quoted(key), "none");
  }
  return Plist(this->path, this->root, value);
}

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
