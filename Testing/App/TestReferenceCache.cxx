#include "Scene/Json/SceneNames.h"
#include "Scene/Model/SceneLights.h"
#include "Scene/Reference/ReferenceCache.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <tuple>

#include <unistd.h>

using namespace varimarch;
namespace fs = std::filesystem;

namespace
{

/// Images of 8 x 8 pixels in a cache folder of their own.
class ReferenceCacheTest : public testing::Test
{
protected:
  ReferenceCacheTest()
  {
    this->scene.look.colors = { { 0.0, { 1.0, 0.5, 0.2 } }, { 1.0, { 0.2, 0.3, 1.0 } } };
    this->scene.look.opacities = { { 0.0, 0.0 }, { 1.0, 0.05 } };
    this->scene.look.shading.enabled = false;
    this->scene.size = { 8, 8 };
    fs::remove_all(this->folder);
  }
  ~ReferenceCacheTest() override { fs::remove_all(this->folder); }

  /// True if the image had to be computed.
  bool Draws(const Scene& asked, double tolerance = 1e-4)
  {
    bool drawn = false;
    const auto picture = this->cache.Picture(asked, this->image, tolerance,
      [&](double)
      {
        drawn = true;
        return true;
      });
    const auto* pixels = static_cast<const float*>(picture.value().image->GetScalarPointer());
    this->pixels.assign(pixels, pixels + 4 * picture->image->GetNumberOfPoints());
    this->largestError = picture->largestError;
    return drawn;
  }

  std::vector<fs::path> Files() const
  {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(this->folder))
    {
      files.push_back(entry.path());
    }
    return files;
  }

  const std::string folder =
    fs::path(testing::TempDir()) / ("reference-cache-" + std::to_string(getpid()));
  const ReferenceCache cache{ this->folder };
  vtkSmartPointer<vtkImageData> image =
    ProceduralVolume({ ProceduralKind::MarschnerLobb, { 12, 12, 12 } });
  Scene scene;
  std::vector<float> pixels;
  double largestError = 0.0;
};

}

TEST_F(ReferenceCacheTest, ASecondRequestReturnsTheFirstImage)
{
  EXPECT_TRUE(this->Draws(this->scene));
  const std::vector<float> first = this->pixels;
  const double error = this->largestError;
  EXPECT_GT(*std::max_element(first.begin(), first.end()), 0.5f);
  EXPECT_FALSE(this->Draws(this->scene));
  EXPECT_EQ(this->pixels, first);
  EXPECT_EQ(this->largestError, error);
}

TEST_F(ReferenceCacheTest, EveryChangeOfTheImageComputesAnother)
{
  EXPECT_TRUE(this->Draws(this->scene));
  EXPECT_TRUE(this->Draws(this->scene, 1e-5)) << "tolerance";
  const auto drawsWith = [this](auto change)
  {
    Scene changed = this->scene;
    change(changed);
    return this->Draws(changed);
  };
  EXPECT_TRUE(drawsWith([](Scene& s) { s.look.colors[0].rgb.g = 0.4; })) << "colour";
  EXPECT_TRUE(drawsWith([](Scene& s) { s.look.colors[0].shape.midpoint = 0.4; })) << "midpoint";
  EXPECT_TRUE(drawsWith([](Scene& s) { s.look.opacities[1].opacity = 0.06; })) << "opacity";
  EXPECT_TRUE(drawsWith([](Scene& s) { s.look.opacityUnitDistanceMm = 2.0; })) << "unit distance";
  EXPECT_TRUE(drawsWith([](Scene& s) { s.look.shading.enabled = true; })) << "shading";
  for (const auto& [name, blend] : BlendNames())
  {
    const bool isOther = blend != this->scene.look.blend;
    EXPECT_EQ(drawsWith([blend = blend](Scene& s) { s.look.blend = blend; }), isOther) << name;
  }
  EXPECT_TRUE(drawsWith([](Scene& s) { s.camera.azimuthDegrees = 1.0; })) << "camera";
  EXPECT_TRUE(drawsWith([](Scene& s) { s.camera.parallel = true; })) << "projection";
  EXPECT_TRUE(drawsWith([](Scene& s) { s.cuts.box[0] = 0.5; })) << "cuts";
  EXPECT_TRUE(drawsWith([](Scene& s) { s.size = { 4, 16 }; })) << "size";
  static_cast<float*>(this->image->GetScalarPointer())[700] += 0.1f;
  EXPECT_TRUE(this->Draws(this->scene)) << "a voxel";
}

TEST_F(ReferenceCacheTest, EveryPartOfALookComputesAnother)
{
  this->scene.look.shading.enabled = true;
  this->scene.lights = { CameraLight(20.0, 10.0) };
  EXPECT_TRUE(this->Draws(this->scene));
  const std::tuple<const char*, std::function<void(Scene&)>> parts[] = {
    { "opacity by gradient",
      [](Scene& s) {
        s.look.gradientOpacities = { { 0.0, 0.5 } };
      } },
    { "regions",
      [](Scene& s) {
        s.look.regions = { { RegionShape::Ellipse, { 0.0, 1.0 }, { 0.0, 1.0 }, { 1, 1, 1 } } };
      } },
    { "interpolation", [](Scene& s) { s.render.interpolation = Interpolation::Nearest; } },
    { "damping", [](Scene& s) { s.look.dampingGradient = 0.5; } },
    { "lights", [](Scene& s) { s.lights[0].rgb[1] = 0.5; } },
    { "softness", [](Scene& s) { s.lights[0].softnessDegrees = 5.0; } },
    { "shadows", [](Scene& s) { s.shadows = 1.0; } },
    { "strength of shadows", [](Scene& s) { s.shadows = 0.5; } },
    { "scattering", [](Scene& s) { s.scattering.blending = 0.5; } },
    { "anisotropy",
      [](Scene& s) {
        s.scattering = { 0.5, 0.5, 0.0 };
      } },
    { "reach of scattering",
      [](Scene& s) {
        s.scattering = { 0.5, 0.0, 0.5 };
      } },
    { "occlusion", [](Scene& s) { s.occlusion.strength = 0.5; } },
    { "reach of occlusion",
      [](Scene& s) {
        s.occlusion = { 0.5, 2.0 };
      } },
  };
  for (const auto& [name, change] : parts)
  {
    Scene changed = this->scene;
    change(changed);
    EXPECT_TRUE(this->Draws(changed)) << name;
    EXPECT_FALSE(this->Draws(changed)) << name;
  }
}

TEST_F(ReferenceCacheTest, ChangesThatDoNotAffectTheImageComputeNone)
{
  EXPECT_TRUE(this->Draws(this->scene));
  this->scene.render.sampleDistanceMm = 7.0;
  this->scene.render.acceleration = Acceleration::Off;
  this->scene.look.shading.ambient = 0.9; // shading is off
  this->scene.background = { 1.0, 1.0, 1.0 };
  EXPECT_FALSE(this->Draws(this->scene));
}

TEST_F(ReferenceCacheTest, ADamagedFileIsComputedAgain)
{
  EXPECT_TRUE(this->Draws(this->scene));
  const std::vector<float> first = this->pixels;
  const fs::path file = this->Files().at(0);
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(200).put('x');
  EXPECT_TRUE(this->Draws(this->scene)) << "one byte is wrong";
  EXPECT_EQ(this->pixels, first);
  fs::resize_file(file, 100);
  EXPECT_TRUE(this->Draws(this->scene)) << "the end is missing";
  EXPECT_FALSE(this->Draws(this->scene));
}

TEST_F(ReferenceCacheTest, LeavesOnlyWholeFilesAndNoneAfterCancelling)
{
  fs::create_directories(this->folder);
  this->cache.Picture(this->scene, this->image, 1e-4, [](double) { return false; });
  EXPECT_TRUE(this->Files().empty());
  this->Draws(this->scene);
  ASSERT_EQ(this->Files().size(), 1u);
  EXPECT_EQ(this->Files()[0].extension(), "");
}

TEST_F(ReferenceCacheTest, TheOldestImagesAreDeletedWhenTheFolderIsFull)
{
  const std::uintmax_t threePictures = 3 * (32 + 8 + 8 * 8 * 16);
  const ReferenceCache small(this->folder, threePictures);
  for (int i = 0; i < 3; ++i)
  {
    this->scene.camera.azimuthDegrees = i;
    small.Picture(this->scene, this->image, 1e-4);
  }
  // Mark all images but the first as used long ago.
  this->scene.camera.azimuthDegrees = 0.0;
  for (const fs::path& file : this->Files())
  {
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
  }
  EXPECT_FALSE(this->Draws(this->scene));
  this->scene.camera.azimuthDegrees = 3.0;
  small.Picture(this->scene, this->image, 1e-4);
  EXPECT_EQ(this->Files().size(), 3u);
  EXPECT_FALSE(this->Draws(this->scene)) << "the newest is kept";
  this->scene.camera.azimuthDegrees = 0.0;
  EXPECT_FALSE(this->Draws(this->scene)) << "the recently used image is kept";
}

TEST_F(ReferenceCacheTest, AFolderThatCannotBeCreatedDoesNotMatter)
{
  std::ofstream(this->folder) << "a file";
  EXPECT_TRUE(this->Draws(this->scene));
  EXPECT_TRUE(this->Draws(this->scene));
  const ReferenceCache none("");
  EXPECT_TRUE(none.Picture(this->scene, this->image, 1e-4).has_value());
}

namespace
{

/// Restores an environment variable at the end of its scope.
class Environment
{
public:
  explicit Environment(const char* name)
    : name(name)
    , before(std::getenv(name) ? std::optional<std::string>(std::getenv(name)) : std::nullopt)
  {
  }
  ~Environment() { this->Set(this->before ? this->before->c_str() : nullptr); }
  Environment(const Environment&) = delete;
  void operator=(const Environment&) = delete;

  void Set(const char* value) { value ? setenv(this->name, value, 1) : unsetenv(this->name); }

private:
  const char* name;
  std::optional<std::string> before;
};

}

TEST_F(ReferenceCacheTest, ItsFolderFollowsTheXdgSpecification)
{
  Environment home("HOME");
  Environment cacheHome("XDG_CACHE_HOME");
  home.Set("/somebody");
  cacheHome.Set("/fast/cache");
  EXPECT_EQ(ReferenceCache::DefaultFolder(), "/fast/cache/varimarch/reference");
  cacheHome.Set("relative");
  EXPECT_EQ(ReferenceCache::DefaultFolder(), "/somebody/.cache/varimarch/reference");
  cacheHome.Set(nullptr);
  EXPECT_EQ(ReferenceCache::DefaultFolder(), "/somebody/.cache/varimarch/reference");
  home.Set(nullptr);
  EXPECT_EQ(ReferenceCache::DefaultFolder(), "");
}

TEST_F(ReferenceCacheTest, ScenesThatTheReferenceCannotDrawAreRefused)
{
  const std::tuple<const char*, std::function<void(Scene&)>> refused[] = {
    { "labels", [](Scene& scene) { scene.labels = SceneLabels{ "labels.nrrd" }; } },
    { "first distance", [](Scene& scene) { scene.render.firstDistanceMm = 1.0; } },
    { "interpolation",
      [](Scene& scene)
      {
        scene.look.blend = Blend::MaximumIntensity;
        scene.render.interpolation = Interpolation::Cubic;
      } },
  };
  for (const auto& [word, change] : refused)
  {
    Scene changed = this->scene;
    changed.look.shading.enabled = true;
    change(changed);
    try
    {
      this->cache.Picture(changed, this->image, 1e-4);
      ADD_FAILURE() << word;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

TEST_F(ReferenceCacheTest, AVolumeWithoutOneComponentIsRefused)
{
  vtkNew<vtkImageData> colored;
  colored->SetDimensions(4, 4, 4);
  EXPECT_THROW(this->cache.Picture(this->scene, colored, 1e-4), std::invalid_argument);
  colored->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  EXPECT_THROW(this->cache.Picture(this->scene, colored, 1e-4), std::invalid_argument);
}

TEST_F(ReferenceCacheTest, IsReadableByItsUserOnly)
{
  this->Draws(this->scene);
  EXPECT_EQ(fs::status(this->folder).permissions(), fs::perms::owner_all);
}
