#ifndef Varimarch_Scene_WrittenImage_h
#define Varimarch_Scene_WrittenImage_h

#include <vtkImageData.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <string>

namespace varimarch
{

/// A type of numbers, and the names that formats have for it; empty where a format has none.
struct WrittenType
{
  int scalarType;
  const char* nrrd;
  const char* metaImage;
  int nifti; ///< a NIfTI data type
  const char* ome;
};

/// An image as writers see it: its values, and the geometry in LPS [mm].
class WrittenImage
{
public:
  /// @param image  must outlive this object
  /// @throws std::runtime_error if it has no voxels, or of a type that no format has
  WrittenImage(const std::string& path, vtkImageData* image);

  const WrittenType& Type() const { return *this->type; }
  std::array<int, 3> Size() const;
  int ComponentCount() const { return this->image->GetNumberOfScalarComponents(); }
  std::size_t VoxelCount() const { return std::size_t(this->image->GetNumberOfPoints()); }
  std::size_t ValueBytes() const { return std::size_t(this->image->GetScalarSize()); }

  /// All values, voxel by voxel, with the components of a voxel together.
  const char* Values() const { return static_cast<const char*>(this->image->GetScalarPointer()); }
  std::size_t ByteCount() const;

  /// Passes all values on in copies of one piece after the other. System calls that write a file
  /// may refuse the addresses of voxels that come into memory when they are touched.
  void EachPiece(const std::function<void(const char* bytes, std::size_t count)>& take) const;

  glm::dvec3 OriginMm() const;
  glm::dvec3 SpacingMm() const;
  /// Column a is the direction of axis a.
  glm::dmat3 Direction() const;

private:
  vtkImageData* image;
  const WrittenType* type = nullptr;
};

/// Numbers with blanks between them, exact and independent of the locale.
std::string TextOf(const glm::dvec3& vector, char separator = ' ');

/// Writes a header and the values behind it. @returns false if the system refuses to
bool WriteHeaderAndValues(
  const std::string& path, const std::string& header, const WrittenImage& image);

/// True on machines whose numbers have their highest byte first.
constexpr bool IsBigEndianMachine()
{
#ifdef VTK_WORDS_BIGENDIAN
  return true;
#else
  return false;
#endif
}

}

#endif
