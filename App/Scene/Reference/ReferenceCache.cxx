#include "Scene/Reference/ReferenceCache.h"

#include "Scene/Files/OutputFile.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Reference/ReferenceRequest.h"

#include <vtksys/MD5.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

namespace fs = std::filesystem;

namespace varimarch
{

namespace
{

/// MD5 digest of a sequence of values, for cache keys and to detect damaged files. Not for
/// security.
class ContentDigest
{
public:
  ContentDigest();
  ~ContentDigest();
  ContentDigest(const ContentDigest&) = delete;
  void operator=(const ContentDigest&) = delete;

  void AddBytes(const void* bytes, std::size_t count);

  /// Adds the bits of a number or enumerator.
  template <class Number>
  void Add(Number number)
  {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    this->AddBytes(&number, sizeof(number));
  }

  /// The digest as 32 hexadecimal digits. Nothing can be added afterwards.
  std::string Text();

private:
  vtksysMD5_s* md5;
};

ContentDigest::ContentDigest()
  : md5(vtksysMD5_New())
{
  vtksysMD5_Initialize(this->md5);
}

ContentDigest::~ContentDigest()
{
  vtksysMD5_Delete(this->md5);
}

void ContentDigest::AddBytes(const void* bytes, std::size_t count)
{
  // vtksysMD5_Append counts in int.
  constexpr std::size_t most = std::size_t(1) << 30;
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (count > 0)
  {
    const std::size_t part = std::min(count, most);
    vtksysMD5_Append(this->md5, next, int(part));
    next += part;
    count -= part;
  }
}

std::string ContentDigest::Text()
{
  std::string text(32, '\0');
  vtksysMD5_FinalizeHex(this->md5, text.data());
  return text;
}

/// Version of the cache. Increase it when the reference gives another image for the same request,
/// or when the file format changes.
constexpr int version = 3;

/// The scene with the defaults of what does not affect a reference image. What is forgotten here
/// costs an integration, never a wrong image.
Scene Essential(Scene scene, vtkImageData* image)
{
  scene.look = InUnitsOfData(scene.look, image);
  scene.look.name.clear();
  scene.look.description.clear();
  if (!scene.look.shading.enabled)
  {
    scene.look.shading = { false };
  }
  const Scene usual;
  scene.volume = usual.volume;
  scene.slices = usual.slices;
  scene.measures.clear();
  scene.keyImages.clear();
  scene.background = usual.background;
  const Interpolation interpolation = scene.render.interpolation;
  scene.render = usual.render;
  scene.render.interpolation = interpolation;
  return scene;
}

/// The file name that identifies a request's image: a digest of the scene's JSON and of what the
/// volume contributes. The rays are the scene's camera in front of this volume.
std::string KeyOf(const Scene& scene, vtkImageData* image, const ReferenceRequest& request)
{
  const std::string json = SceneText(Essential(scene, image));
  ContentDigest digest;
  digest.Add(version);
  digest.Add(request.tolerance);
  digest.AddBytes(json.data(), json.size());
  digest.AddBytes(&request.geometry.dimensions, sizeof(request.geometry.dimensions));
  digest.AddBytes(&request.geometry.worldFromGrid, sizeof(request.geometry.worldFromGrid));
  digest.AddBytes(&request.view.rays, sizeof(request.view.rays));
  digest.Add(request.scalars->GetDataType());
  digest.AddBytes(request.scalars->GetVoidPointer(0),
    std::size_t(request.scalars->GetDataSize()) * request.scalars->GetDataTypeSize());
  if (request.cuts.mask)
  {
    digest.AddBytes(
      request.cuts.mask->GetScalarPointer(), std::size_t(request.cuts.mask->GetNumberOfPoints()));
  }
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
  const std::string path = fs::path(this->folder) / KeyOf(scene, image, request);
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
