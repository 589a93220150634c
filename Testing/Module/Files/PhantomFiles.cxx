#include "PhantomFiles.h"
#include "PhantomText.h"

#include <vtkByteSwap.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSetGet.h>
#include <vtkXMLImageDataWriter.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace
{

const glm::dvec3 phantomOriginMm(-31.0, 17.5, 120.25);

glm::dmat3 PhantomAxesMm()
{
  const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(0.9, 0.21, -0.13, 0.34)));
  return turn * glm::dmat3(0.7, 0, 0, 0, 1.1, 0, 0, 0, 2.5);
}

std::string Vector(const glm::dvec3& v)
{
  return Text('(', v.x, ',', v.y, ',', v.z, ')');
}

const char* NameOfType(int scalarType, const std::array<const char*, 10>& names)
{
  switch (scalarType)
  {
    case VTK_SIGNED_CHAR:
      return names[0];
    case VTK_UNSIGNED_CHAR:
      return names[1];
    case VTK_SHORT:
      return names[2];
    case VTK_UNSIGNED_SHORT:
      return names[3];
    case VTK_INT:
      return names[4];
    case VTK_UNSIGNED_INT:
      return names[5];
    case VTK_FLOAT:
      return names[6];
    case VTK_DOUBLE:
      return names[7];
    case VTK_TYPE_INT64:
      return names[8];
    case VTK_TYPE_UINT64:
      return names[9];
    default:
      throw std::logic_error("a type that the tests do not write");
  }
}

template <class Value>
std::string BytesOf(const std::vector<double>& values, Value, bool bigEndian)
{
  std::string bytes;
  for (const double number : values)
  {
    auto value = Value(number);
    if (bigEndian)
    {
      vtkByteSwap::SwapVoidRange(&value, 1, sizeof(value));
    }
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  return bytes;
}

std::string Deflated(const std::string& bytes, int windowBits)
{
  z_stream state = {};
  if (deflateInit2(&state, 9, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY) != Z_OK)
  {
    throw std::bad_alloc();
  }
  std::string result(deflateBound(&state, uLong(bytes.size())), '\0');
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  state.avail_in = uInt(bytes.size());
  state.next_out = reinterpret_cast<Bytef*>(result.data());
  state.avail_out = uInt(result.size());
  deflate(&state, Z_FINISH);
  result.resize(state.total_out);
  deflateEnd(&state);
  return result;
}

}

double phantom::ValueAt(const glm::ivec3& index)
{
  return 1.0 + index.x + dimensions[0] * (index.y + dimensions[1] * index.z);
}

glm::dvec3 phantom::IndexAt(const glm::dvec3& worldMm)
{
  return glm::inverse(PhantomAxesMm()) * (worldMm - phantomOriginMm);
}

StoredVolume phantom::Stored(int orientation)
{
  std::array<int, 3> order = { 0, 1, 2 };
  for (int i = 0; i < orientation / 8; ++i)
  {
    std::next_permutation(order.begin(), order.end());
  }
  const auto isBackwards = [&](int axis) { return (orientation >> axis) % 2 == 1; };

  StoredVolume stored;
  glm::ivec3 first(0);
  for (int axis = 0; axis < 3; ++axis)
  {
    stored.dimensions[axis] = dimensions[order[axis]];
    first[order[axis]] = isBackwards(axis) ? dimensions[order[axis]] - 1 : 0;
    stored.axesMm[axis] = PhantomAxesMm()[order[axis]] * (isBackwards(axis) ? -1.0 : 1.0);
  }
  stored.originMm = phantomOriginMm + PhantomAxesMm() * glm::dvec3(first);
  for (int k = 0; k < stored.dimensions[2]; ++k)
  {
    for (int j = 0; j < stored.dimensions[1]; ++j)
    {
      for (int i = 0; i < stored.dimensions[0]; ++i)
      {
        const glm::ivec3 step(i, j, k);
        glm::ivec3 index = first;
        for (int axis = 0; axis < 3; ++axis)
        {
          index[order[axis]] += isBackwards(axis) ? -step[axis] : step[axis];
        }
        stored.values.push_back(ValueAt(index));
      }
    }
  }
  return stored;
}

TemporaryFolder::TemporaryFolder()
{
  std::string name = (std::filesystem::temp_directory_path() / "varimarch-XXXXXX").string();
  if (!mkdtemp(name.data()))
  {
    throw std::runtime_error("no temporary folder");
  }
  this->path = name;
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->path, ignored);
}

std::string TemporaryFolder::Write(const std::string& name, const std::string& bytes) const
{
  const std::filesystem::path file = this->path / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
  return file.string();
}

std::string TemporaryFolder::Bytes(const std::string& name) const
{
  std::ostringstream bytes;
  bytes << std::ifstream(this->path / name, std::ios::binary).rdbuf();
  return bytes.str();
}

std::string VoxelBytes(const StoredVolume& volume, bool bigEndian)
{
  switch (volume.scalarType)
  {
    vtkTemplateMacro(return BytesOf(volume.values, VTK_TT(), bigEndian));
  }
  return "";
}

std::string VoxelText(const StoredVolume& volume)
{
  std::string text;
  for (const double value : volume.values)
  {
    text += Text(value, text.size() % 7 == 0 ? '\n' : ' ');
  }
  return text;
}

std::string Gzipped(const std::string& bytes)
{
  return Deflated(bytes, 15 + 16);
}

std::string Zlibbed(const std::string& bytes)
{
  return Deflated(bytes, 15);
}

std::string NrrdHeaderText(const StoredVolume& volume, const std::string& space)
{
  const glm::dvec3 signs(space.find('R') == 0 ? -1.0 : 1.0, space.find('A') == 1 ? -1.0 : 1.0, 1.0);
  const char* const type = NameOfType(volume.scalarType,
    { "signed char", "uchar", "int16_t", "unsigned short", "int", "uint32", "float", "double",
      "longlong", "uint64_t" });
  const auto& size = volume.dimensions;
  return Text("NRRD0005\n# a comment: with a colon\ntype: ", type, "\ndimension: 3\nspace: ", space,
    "\nsizes: ", size[0], ' ', size[1], ' ', size[2],
    "\nspace directions: ", Vector(signs * volume.axesMm[0]), ' ', Vector(signs * volume.axesMm[1]),
    ' ', Vector(signs * volume.axesMm[2]), "\nspace origin: ", Vector(signs * volume.originMm),
    "\nowner:=nobody\n");
}

std::string MetaImageHeaderText(const StoredVolume& volume)
{
  const char* const type = NameOfType(volume.scalarType,
    { "MET_CHAR", "MET_UCHAR", "MET_SHORT", "MET_USHORT", "MET_INT", "MET_UINT", "MET_FLOAT",
      "MET_DOUBLE", "MET_LONG_LONG", "MET_ULONG_LONG" });
  std::string matrix;
  std::string spacing;
  std::string offset;
  std::string size;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 direction = glm::normalize(volume.axesMm[axis]);
    matrix += Text(' ', direction.x, ' ', direction.y, ' ', direction.z);
    spacing += Text(' ', glm::length(volume.axesMm[axis]));
    offset += Text(' ', volume.originMm[axis]);
    size += Text(' ', volume.dimensions[axis]);
  }
  return "ObjectType = Image\nNDims = 3\nTransformMatrix =" + matrix + "\nOffset =" + offset +
    "\nElementSpacing =" + spacing + "\nDimSize =" + size + "\nElementType = " + type + "\n";
}

/// @param margin  0 for values at points, or 1 for values in cells between more points
static std::string VtiText(
  const StoredVolume& volume, const std::array<int, 3>& firstIndex, int margin)
{
  const char* const attributes = margin > 0 ? "CellData" : "PointData";
  const char* const type = NameOfType(volume.scalarType,
    { "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Float32", "Float64", "Int64",
      "UInt64" });
  std::string extent;
  std::string spacing;
  glm::dmat3 direction;
  glm::dvec3 originMm = volume.originMm;
  for (int axis = 0; axis < 3; ++axis)
  {
    extent += Text(axis ? " " : "", firstIndex[axis], ' ',
      firstIndex[axis] + volume.dimensions[axis] - 1 + margin);
    spacing += Text(axis ? " " : "", glm::length(volume.axesMm[axis]));
    direction[axis] = glm::normalize(volume.axesMm[axis]);
    originMm -= volume.axesMm[axis] * (firstIndex[axis] + 0.5 * margin);
  }
  std::string rows;
  for (int i = 0; i < 9; ++i)
  {
    rows += Text(i ? " " : "", direction[i % 3][i / 3]);
  }
  return Text("<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
              "byte_order=\"LittleEndian\">\n<ImageData WholeExtent=\"",
    extent, "\" Origin=\"", originMm.x, ' ', originMm.y, ' ', originMm.z, "\" Spacing=\"", spacing,
    "\" Direction=\"", rows, "\">\n<Piece Extent=\"", extent, "\">\n<", attributes,
    " Scalars=\"density\">\n<DataArray type=\"", type, "\" Name=\"density\" format=\"ascii\">\n",
    VoxelText(volume), "\n</DataArray>\n</", attributes, ">\n</Piece>\n</ImageData>\n</VTKFile>\n");
}

std::string VtiText(const StoredVolume& volume, const std::array<int, 3>& firstIndex)
{
  return VtiText(volume, firstIndex, 0);
}

std::string VtiCellText(const StoredVolume& volume)
{
  return VtiText(volume, { 0, 0, 0 }, 1);
}

std::string EncodedVti(
  const StoredVolume& volume, const std::string& voxelBytes, const VtiEncoding& encoding)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(volume.dimensions.data());
  image->SetOrigin(volume.originMm.x, volume.originMm.y, volume.originMm.z);
  image->AllocateScalars(volume.scalarType, 1);
  std::memcpy(image->GetScalarPointer(), voxelBytes.data(), voxelBytes.size());
  glm::dmat3 direction;
  glm::dvec3 spacingMm;
  for (int axis = 0; axis < 3; ++axis)
  {
    spacingMm[axis] = glm::length(volume.axesMm[axis]);
    direction[axis] = volume.axesMm[axis] / spacingMm[axis];
  }
  image->SetSpacing(&spacingMm[0]);
  image->SetDirectionMatrix(glm::value_ptr(glm::transpose(direction)));

  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetDataMode(encoding.dataMode);
  writer->SetEncodeAppendedData(encoding.base64);
  writer->SetCompressorType(encoding.compressor);
  writer->SetByteOrder(encoding.bigEndian ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
  writer->SetHeaderType(encoding.headerBits);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}
