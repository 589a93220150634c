#include "Scene/ReferenceCache.h"

#include "Scene/ContentDigest.h"
#include "Scene/OutputFile.h"
#include "Scene/ReferenceRequest.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace varimarch
{

namespace
{

/// Version of the cache. Increase it when the reference gives another image for the same request,
/// or when the file format changes.
constexpr int version = 2;

template <class Matrix>
void AddMatrix(ContentDigest& digest, const Matrix& matrix)
{
  digest.AddBytes(glm::value_ptr(matrix), sizeof(matrix));
}

void AddShape(ContentDigest& digest, double value, const NodeShape& shape)
{
  digest.Add(value);
  digest.Add(shape.midpoint);
  digest.Add(shape.sharpness);
}

void AddOpacities(ContentDigest& digest, const std::vector<OpacityNode>& nodes)
{
  digest.Add(nodes.size());
  for (const OpacityNode& node : nodes)
  {
    AddShape(digest, node.value, node.shape);
    digest.Add(node.opacity);
  }
}

void AddTransferFunction(ContentDigest& digest, const TransferFunction& transferFunction)
{
  digest.Add(transferFunction.Colors().size());
  for (const ColorNode& node : transferFunction.Colors())
  {
    AddShape(digest, node.value, node.shape);
    AddMatrix(digest, node.rgb);
  }
  AddOpacities(digest, transferFunction.Opacities());
  digest.Add(transferFunction.OpacityUnitDistanceMm());
}

void AddRegions(ContentDigest& digest, const std::vector<LookRegion>& regions)
{
  digest.Add(regions.size());
  for (const LookRegion& region : regions)
  {
    digest.Add(region.shape);
    digest.Add(region.values[0]);
    digest.Add(region.values[1]);
    digest.Add(region.gradients[0]);
    digest.Add(region.gradients[1]);
    AddMatrix(digest, region.rgb);
    digest.Add(region.opacity);
    digest.Add(region.softness);
  }
}

void AddLighting(ContentDigest& digest, const std::optional<ReferenceLighting>& lighting)
{
  digest.Add(lighting.has_value());
  if (lighting)
  {
    digest.Add(lighting->shading.ambient);
    digest.Add(lighting->shading.diffuse);
    digest.Add(lighting->shading.specular);
    digest.Add(lighting->shading.specularPower);
    digest.Add(lighting->dampingGradient);
    digest.Add(lighting->castsShadows);
    digest.Add(lighting->surfacesInShadow);
    digest.Add(lighting->reachMm);
    digest.Add(lighting->scatteredPart);
    digest.Add(lighting->anisotropy);
    digest.Add(lighting->lights.size());
    for (const PlacedLight& light : lighting->lights)
    {
      digest.Add(light.kind);
      AddMatrix(digest, light.rgb);
      AddMatrix(digest, light.place);
      digest.Add(light.softnessDegrees);
    }
  }
}

void AddCuts(ContentDigest& digest, const ReferenceCuts& cuts)
{
  digest.Add(cuts.planesGrid.size());
  for (const glm::dvec4& plane : cuts.planesGrid)
  {
    AddMatrix(digest, plane);
  }
  digest.Add(cuts.mask != nullptr);
  if (cuts.mask)
  {
    digest.AddBytes(cuts.mask->GetScalarPointer(), std::size_t(cuts.mask->GetNumberOfPoints()));
  }
}

void AddView(ContentDigest& digest, const ReferenceView& view)
{
  for (const glm::dvec4& start : view.rays.startGrid)
  {
    AddMatrix(digest, start);
  }
  for (const glm::dvec3& direction : view.rays.directionGrid)
  {
    AddMatrix(digest, direction);
  }
  AddMatrix(digest, view.rays.nearPlaneGrid);
  AddMatrix(digest, view.rays.farPlaneGrid);
  AddMatrix(digest, view.worldFromGridDirection);
  digest.Add(view.width);
  digest.Add(view.height);
}

/// The file name that identifies a request's image.
std::string KeyOf(const ReferenceRequest& request)
{
  ContentDigest digest;
  digest.Add(version);
  digest.Add(request.scalars->GetDataType());
  digest.AddBytes(request.scalars->GetVoidPointer(0),
    std::size_t(request.scalars->GetDataSize()) * request.scalars->GetDataTypeSize());
  AddMatrix(digest, request.geometry.dimensions);
  AddMatrix(digest, request.geometry.boxGrid.lower);
  AddMatrix(digest, request.geometry.boxGrid.upper);
  AddMatrix(digest, request.geometry.worldFromGrid);
  AddMatrix(digest, request.geometry.gradientFactors);
  digest.Add(request.meanSpacingMm);
  AddTransferFunction(digest, request.transferFunction);
  digest.Add(request.interpolation);
  digest.Add(request.occlusion.strength);
  digest.Add(request.occlusion.reachMm);
  AddOpacities(digest, request.gradientOpacities);
  AddRegions(digest, request.regions);
  AddLighting(digest, request.lighting);
  digest.Add(request.blend);
  for (const double isovalue : request.isovalues)
  {
    digest.Add(isovalue);
  }
  digest.Add(request.averagedRange.has_value());
  if (request.averagedRange)
  {
    digest.Add(request.averagedRange->lower);
    digest.Add(request.averagedRange->upper);
  }
  AddCuts(digest, request.cuts);
  AddView(digest, request.view);
  digest.Add(request.tolerance);
  return digest.Text();
}

// A file consists of a digest of the rest, the error estimate, and the pixels.
constexpr std::size_t digestBytes = 32;
constexpr std::size_t headerBytes = digestBytes + sizeof(double);

std::string DigestOf(const char* bytes, std::size_t count)
{
  ContentDigest digest;
  digest.AddBytes(bytes, count);
  return digest.Text();
}

std::string FileBytes(const ReferencePicture& picture)
{
  const std::size_t pixelBytes =
    std::size_t(picture.image->GetNumberOfPoints()) * 4 * sizeof(float);
  std::string content(sizeof(double) + pixelBytes, '\0');
  std::memcpy(content.data(), &picture.largestError, sizeof(double));
  std::memcpy(content.data() + sizeof(double), picture.image->GetScalarPointer(), pixelBytes);
  return DigestOf(content.data(), content.size()) + content;
}

/// Reads the image of a file; empty if the file is missing or damaged.
std::optional<ReferencePicture> PictureIn(const std::string& path, int width, int height)
{
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream), {} };
  const std::size_t pixelBytes = std::size_t(width) * height * 4 * sizeof(float);
  if (bytes.size() != headerBytes + pixelBytes ||
    bytes.compare(
      0, digestBytes, DigestOf(bytes.data() + digestBytes, bytes.size() - digestBytes)) != 0)
  {
    return std::nullopt;
  }
  ReferencePicture picture{ vtkSmartPointer<vtkImageData>::New(), 0.0 };
  picture.image->SetDimensions(width, height, 1);
  picture.image->AllocateScalars(VTK_FLOAT, 4);
  std::memcpy(&picture.largestError, bytes.data() + digestBytes, sizeof(double));
  std::memcpy(picture.image->GetScalarPointer(), bytes.data() + headerBytes, pixelBytes);
  return picture;
}

}

ReferenceCache::ReferenceCache(std::string folder, std::uintmax_t largestBytes)
  : folder(std::move(folder))
  , largestBytes(largestBytes)
{
}

std::string ReferenceCache::DefaultFolder()
{
  // The XDG Base Directory Specification says to ignore relative paths.
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && fs::path(cache).is_absolute())
  {
    return fs::path(cache) / "varimarch" / "reference";
  }
  const char* home = std::getenv("HOME");
  return home && *home ? fs::path(home) / ".cache" / "varimarch" / "reference" : fs::path();
}

std::optional<ReferencePicture> ReferenceCache::Picture(
  const Scene& scene, vtkImageData* image, double tolerance, const ProgressFunction& progress) const
{
  const ReferenceRequest request = ReferenceRequestFor(scene, image, tolerance);
  if (this->folder.empty())
  {
    return DrawReferencePicture(request, progress);
  }
  const std::string path = fs::path(this->folder) / KeyOf(request);
  std::optional<ReferencePicture> picture =
    PictureIn(path, request.view.width, request.view.height);
  if (picture)
  {
    std::error_code ignored; // another process may have just deleted it
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
    return picture;
  }
  picture = DrawReferencePicture(request, progress);
  if (picture)
  {
    this->Keep(path, *picture);
  }
  return picture;
}

void ReferenceCache::Keep(const std::string& path, const ReferencePicture& picture) const
{
  try
  {
    fs::create_directories(this->folder);
    // The images show a patient's scan.
    fs::permissions(this->folder, fs::perms::owner_all);
    WriteFileWhole(path, FileBytes(picture));
    this->DeleteOldest();
  }
  catch (const std::runtime_error&)
  {
    // The disk may be full or the folder not writable. The image is still valid; it is only not
    // kept.
  }
}

void ReferenceCache::DeleteOldest() const
{
  struct File
  {
    fs::file_time_type lastUse;
    std::uintmax_t bytes;
    fs::path path;
  };
  std::vector<File> files;
  std::uintmax_t sum = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(this->folder))
  {
    files.push_back({ entry.last_write_time(), entry.file_size(), entry.path() });
    sum += files.back().bytes;
  }
  std::sort(
    files.begin(), files.end(), [](const File& a, const File& b) { return a.lastUse < b.lastUse; });
  for (const File& file : files)
  {
    if (sum <= this->largestBytes)
    {
      return;
    }
    fs::remove(file.path);
    sum -= file.bytes;
  }
}

}
