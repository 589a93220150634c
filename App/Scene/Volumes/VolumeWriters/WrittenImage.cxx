#include "Scene/Volumes/VolumeWriters/WrittenImage.h"

#include "Scene/Volumes/VolumeWriters/ZarrFolder.h"

#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkNIFTIPrivate.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
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

// Volumes for formats that hold no directions.

namespace
{

using Index = std::array<std::int64_t, 3>;

/// The axes of a volume in another order, some of them backwards.
struct Order
{
  std::array<int, 3> axes = { 0, 1, 2 }; ///< for each new axis, the old one
  std::array<bool, 3> isBackwards = { false, false, false };
};

/// The order in which each axis lies as near as possible to that of the world, forwards.
Order NearestOrder(const glm::dmat3& direction)
{
  std::array<int, 3> axes = { 0, 1, 2 };
  Order order;
  double best = -1.0;
  do
  {
    double sum = 0.0;
    for (int world = 0; world < 3; ++world)
    {
      sum += std::abs(direction[axes[world]][world]);
    }
    constexpr double Rounding = 1e-9;
    if (sum > best + Rounding)
    {
      best = sum;
      order.axes = axes;
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  for (int world = 0; world < 3; ++world)
  {
    order.isBackwards[world] = direction[order.axes[world]][world] < 0.0;
  }
  return order;
}

/// The first voxel of a box of the new axes along an old one, and the voxel behind its last.
std::array<std::int64_t, 2> Along(
  std::int64_t count, bool isBackwards, std::int64_t lower, std::int64_t upper)
{
  return isBackwards ? std::array<std::int64_t, 2>{ count - upper, count - lower }
                     : std::array<std::int64_t, 2>{ lower, upper };
}

/// Reads a box of the new axes.
void ReadInOrder(const ZarrInput& input, const Order& order, std::size_t voxelBytes,
  const Index& lower, const Index& upper, void* voxels)
{
  Index from;
  Index to;
  for (int world = 0; world < 3; ++world)
  {
    const int axis = order.axes[world];
    const auto [first, end] =
      Along(input.dimensions[axis], order.isBackwards[world], lower[world], upper[world]);
    from[axis] = first;
    to[axis] = end;
  }
  const Index size = { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  std::vector<char> box(std::size_t(size[0] * size[1] * size[2]) * voxelBytes);
  input.read(from, to, box.data());
  const Index steps = { 1, size[0], size[0] * size[1] };
  Index newSteps;
  std::int64_t first = 0;
  for (int world = 0; world < 3; ++world)
  {
    const int axis = order.axes[world];
    newSteps[world] = order.isBackwards[world] ? -steps[axis] : steps[axis];
    first += order.isBackwards[world] ? (size[axis] - 1) * steps[axis] : 0;
  }
  char* destination = static_cast<char*>(voxels);
  for (std::int64_t k = 0; k < upper[2] - lower[2]; ++k)
  {
    for (std::int64_t j = 0; j < upper[1] - lower[1]; ++j)
    {
      std::int64_t place = first + k * newSteps[2] + j * newSteps[1];
      for (std::int64_t i = lower[0]; i < upper[0]; ++i, place += newSteps[0])
      {
        std::memcpy(destination, box.data() + std::size_t(place) * voxelBytes, voxelBytes);
        destination += voxelBytes;
      }
    }
  }
}

}

ZarrInput InLpsOrder(const ZarrInput& input)
{
  const Order order = NearestOrder(input.direction);
  ZarrInput turned = input;
  for (int world = 0; world < 3; ++world)
  {
    const int axis = order.axes[world];
    const bool isBackwards = order.isBackwards[world];
    turned.dimensions[world] = input.dimensions[axis];
    turned.spacingMm[world] = input.spacingMm[axis];
    turned.direction[world] = isBackwards ? -input.direction[axis] : input.direction[axis];
    turned.originMm += isBackwards
      ? double(input.dimensions[axis] - 1) * input.spacingMm[axis] * input.direction[axis]
      : glm::dvec3(0.0);
  }
  const std::size_t voxelBytes = std::size_t(vtkDataArray::GetDataTypeSize(input.scalarType)) *
    std::size_t(input.componentCount);
  const bool isSame = order.axes == Order().axes && order.isBackwards == Order().isBackwards;
  if (!isSame)
  {
    turned.read = [=](const Index& lower, const Index& upper, void* voxels)
    { ReadInOrder(input, order, voxelBytes, lower, upper, voxels); };
  }
  return turned;
}

}
