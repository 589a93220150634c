#include "Scene/VolumeWriters/WrittenImage.h"

#include <vtkMatrix3x3.h>
#include <vtkNIFTIPrivate.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace varimarch
{

namespace
{

constexpr WrittenType types[] = {
  { VTK_SIGNED_CHAR, "int8", "MET_CHAR", NIFTI_TYPE_INT8, "int8" },
  { VTK_CHAR, "int8", "MET_CHAR", NIFTI_TYPE_INT8, "int8" },
  { VTK_UNSIGNED_CHAR, "uint8", "MET_UCHAR", NIFTI_TYPE_UINT8, "uint8" },
  { VTK_SHORT, "int16", "MET_SHORT", NIFTI_TYPE_INT16, "int16" },
  { VTK_UNSIGNED_SHORT, "uint16", "MET_USHORT", NIFTI_TYPE_UINT16, "uint16" },
  { VTK_INT, "int32", "MET_INT", NIFTI_TYPE_INT32, "int32" },
  { VTK_UNSIGNED_INT, "uint32", "MET_UINT", NIFTI_TYPE_UINT32, "uint32" },
  { VTK_TYPE_INT64, "int64", "MET_LONG_LONG", NIFTI_TYPE_INT64, "" },
  { VTK_TYPE_UINT64, "uint64", "MET_ULONG_LONG", NIFTI_TYPE_UINT64, "" },
  { VTK_FLOAT, "float", "MET_FLOAT", NIFTI_TYPE_FLOAT32, "float" },
  { VTK_DOUBLE, "double", "MET_DOUBLE", NIFTI_TYPE_FLOAT64, "double" },
};

}

WrittenImage::WrittenImage(const std::string& path, vtkImageData* image)
  : image(image)
{
  const auto* const row = std::find_if(std::begin(types), std::end(types),
    [&](const WrittenType& candidate) { return candidate.scalarType == image->GetScalarType(); });
  if (image->GetNumberOfPoints() == 0 || row == std::end(types))
  {
    throw std::runtime_error(path + ": expected voxels of 8 to 64 bits, found " +
      std::to_string(image->GetNumberOfPoints()) + " of type " + image->GetScalarTypeAsString());
  }
  this->type = row;
}

std::array<int, 3> WrittenImage::Size() const
{
  const int* const size = this->image->GetDimensions();
  return { size[0], size[1], size[2] };
}

std::size_t WrittenImage::ByteCount() const
{
  return this->VoxelCount() * std::size_t(this->ComponentCount()) * this->ValueBytes();
}

void WrittenImage::EachPiece(
  const std::function<void(const char* bytes, std::size_t count)>& take) const
{
  constexpr std::size_t PieceBytes = 1 << 20;
  std::vector<char> piece;
  for (std::size_t begin = 0; begin < this->ByteCount(); begin += PieceBytes)
  {
    const std::size_t end = std::min(begin + PieceBytes, this->ByteCount());
    piece.assign(this->Values() + begin, this->Values() + end);
    take(piece.data(), piece.size());
  }
}

glm::dvec3 WrittenImage::OriginMm() const
{
  // The first voxel, even if the extent does not begin at 0.
  glm::dvec3 positionMm;
  const int* const extent = this->image->GetExtent();
  this->image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], &positionMm[0]);
  return positionMm;
}

glm::dvec3 WrittenImage::SpacingMm() const
{
  return glm::make_vec3(this->image->GetSpacing());
}

glm::dmat3 WrittenImage::Direction() const
{
  return glm::transpose(glm::make_mat3(this->image->GetDirectionMatrix()->GetData()));
}

std::string TextOf(const glm::dvec3& vector, char separator)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << vector.x << separator << vector.y << separator << vector.z;
  return text.str();
}

bool WriteHeaderAndValues(
  const std::string& path, const std::string& header, const WrittenImage& image)
{
  std::ofstream stream(path, std::ios::binary);
  stream << header;
  image.EachPiece(
    [&](const char* bytes, std::size_t count) { stream.write(bytes, std::streamsize(count)); });
  stream.close();
  return bool(stream);
}

}
