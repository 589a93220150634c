// The formats of PhantomFiles.h with binary headers.
#include "PhantomFiles.h"

#include <vtkByteSwap.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <cstdint>
#include <cstring>
#include <map>

namespace
{

/// A header of fixed size whose fields are set at their offsets.
class BinaryHeader
{
public:
  BinaryHeader(std::size_t size, bool bigEndian)
    : bytes(size, '\0')
    , bigEndian(bigEndian)
  {
  }

  template <class Value>
  void Put(std::size_t offset, Value value)
  {
    if (this->bigEndian)
    {
      vtkByteSwap::SwapVoidRange(&value, 1, sizeof(value));
    }
    std::memcpy(this->bytes.data() + offset, &value, sizeof(value));
  }

  void PutText(std::size_t offset, const std::string& text)
  {
    this->bytes.replace(offset, text.size(), text);
  }

  const std::string& Bytes() const { return this->bytes; }

private:
  std::string bytes;
  bool bigEndian;
};

std::int16_t NiftiCode(int scalarType)
{
  static const std::map<int, std::int16_t> codes = {
    { VTK_UNSIGNED_CHAR, 2 },
    { VTK_SHORT, 4 },
    { VTK_INT, 8 },
    { VTK_FLOAT, 16 },
    { VTK_DOUBLE, 64 },
    { VTK_SIGNED_CHAR, 256 },
    { VTK_UNSIGNED_SHORT, 512 },
    { VTK_UNSIGNED_INT, 768 },
    { VTK_TYPE_INT64, 1024 },
    { VTK_TYPE_UINT64, 1280 },
  };
  return codes.at(scalarType);
}

/// Offsets from the NIfTI-1 specification, nifti1.h.
void PutNiftiSizes(const StoredVolume& volume, BinaryHeader& header)
{
  header.Put(0, std::int32_t(348));
  header.Put(40, std::int16_t(3));
  for (int axis = 0; axis < 3; ++axis)
  {
    header.Put(42 + 2 * axis, std::int16_t(volume.dimensions[axis]));
    header.Put(80 + 4 * axis, float(glm::length(volume.axesMm[axis])));
  }
  header.Put(70, NiftiCode(volume.scalarType));
  header.Put(108, 352.0f);  // vox_offset
  header.Put(123, char(2)); // xyzt_units: mm
  header.PutText(344, "n+1");
}

}

std::string NiftiBytes(const StoredVolume& volume, NiftiForm form, bool bigEndian)
{
  BinaryHeader header(352, bigEndian);
  PutNiftiSizes(volume, header);
  const glm::dvec3 rasFromLps(-1.0, -1.0, 1.0);
  const glm::dvec3 origin = rasFromLps * volume.originMm;
  glm::dmat3 axes;
  glm::dmat3 turn;
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[axis] = rasFromLps * volume.axesMm[axis];
    turn[axis] = glm::normalize(axes[axis]);
  }
  if (form == NiftiForm::Affine)
  {
    header.Put(254, std::int16_t(1)); // sform_code
    for (int row = 0; row < 3; ++row)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        header.Put(280 + 16 * row + 4 * axis, float(axes[axis][row]));
      }
      header.Put(280 + 16 * row + 12, float(origin[row]));
    }
    return header.Bytes() + VoxelBytes(volume, bigEndian);
  }

  // A quaternion cannot mirror, so the third axis is reversed, which qfac records.
  const double handedness = glm::determinant(turn) < 0 ? -1.0 : 1.0;
  turn[2] *= handedness;
  glm::dquat quaternion = glm::normalize(glm::quat_cast(turn));
  quaternion = quaternion.w < 0 ? -quaternion : quaternion;
  header.Put(252, std::int16_t(1)); // qform_code
  header.Put(76, float(handedness));
  header.Put(256, float(quaternion.x));
  header.Put(260, float(quaternion.y));
  header.Put(264, float(quaternion.z));
  for (int row = 0; row < 3; ++row)
  {
    header.Put(268 + 4 * row, float(origin[row]));
  }
  return header.Bytes() + VoxelBytes(volume, bigEndian);
}

std::string AnalyzeHeaderBytes(
  const StoredVolume& volume, const std::array<int, 3>& spmOrigin, bool bigEndian)
{
  BinaryHeader header(348, bigEndian);
  PutNiftiSizes(volume, header);
  header.Put(32, std::int32_t(16384)); // extents
  header.PutText(38, "r");             // regular
  header.Put(108, 0.0f);               // vox_offset
  header.Put(123, char(0));
  header.PutText(344, std::string(4, '\0'));
  for (int axis = 0; axis < 3; ++axis)
  {
    header.Put(253 + 2 * axis, std::int16_t(spmOrigin[axis])); // originator
  }
  return header.Bytes();
}

std::string SpmMatrixBytes(const StoredVolume& volume)
{
  // A MATLAB file of version 4: type, rows, columns, no imaginary part, length of the name.
  constexpr int FirstNumber = 24;
  BinaryHeader file(FirstNumber + 16 * 8, false);
  file.Put(4, std::int32_t(4));
  file.Put(8, std::int32_t(4));
  file.Put(16, std::int32_t(4));
  file.PutText(20, std::string("mat\0", 4));
  const auto putColumn = [&](int column, const glm::dvec3& values, double last)
  {
    for (int row = 0; row < 4; ++row)
    {
      file.Put(FirstNumber + 8 * (4 * column + row), row < 3 ? values[row] : last);
    }
  };
  const glm::dvec3 rasFromLps(-1.0, -1.0, 1.0);
  glm::dvec3 origin = rasFromLps * volume.originMm;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 step = rasFromLps * volume.axesMm[axis];
    putColumn(axis, step, 0.0);
    // The first voxel has the index 1.
    origin -= step;
  }
  putColumn(3, origin, 1.0);
  return file.Bytes();
}

std::string Nifti2Bytes(const StoredVolume& volume, bool bigEndian)
{
  // Offsets from the NIfTI-2 specification, nifti2.h.
  BinaryHeader header(544, bigEndian);
  header.Put(0, std::int32_t(540));
  header.PutText(4, std::string("n+2\0\r\n\x1a\n", 8));
  header.Put(12, NiftiCode(volume.scalarType));
  header.Put(16, std::int64_t(3));
  header.Put(168, std::int64_t(544)); // vox_offset
  header.Put(348, std::int32_t(1));   // sform_code
  header.Put(500, std::int32_t(2));   // xyzt_units: mm
  const glm::dvec3 rasFromLps(-1.0, -1.0, 1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    header.Put(24 + 8 * axis, std::int64_t(volume.dimensions[axis]));
    header.Put(112 + 8 * axis, glm::length(volume.axesMm[axis]));
    header.Put(424 + 32 * axis, rasFromLps[axis] * volume.originMm[axis]);
    for (int row = 0; row < 3; ++row)
    {
      header.Put(400 + 32 * row + 8 * axis, rasFromLps[row] * volume.axesMm[axis][row]);
    }
  }
  return header.Bytes() + VoxelBytes(volume, bigEndian);
}
