#include "Core/Quality/ImageError.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/SceneLights.h"
#include "Scene/Reference/ReferencePicture.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <vector>

using namespace varimarch;

namespace
{

/// A small scene whose volume has as many voxels across as the image has pixels.
Scene SceneOf(Blend blend, bool shading)
{
  Scene scene;
  scene.look.colors = { { 0.0, { 1.0, 0.2, 0.1 } }, { 0.5, { 0.2, 1.0, 0.3 } },
    { 1.0, { 0.2, 0.3, 1.0 } } };
  scene.look.opacities = { { 0.1, 0.0 }, { 0.4, 0.02 }, { 0.7, 0.01 }, { 1.0, 0.3 } };
  scene.look.shading.enabled = shading;
  scene.look.blend = blend;
  scene.camera.azimuthDegrees = 30.0;
  scene.camera.elevationDegrees = 20.0;
  scene.size = { 60, 50 };
  scene.render.acceleration = Acceleration::Off;
  scene.render.earlyTerminationTransmittance = 0.0;
  return scene;
}

/// Error of the mapper's image.
/// @param tolerance  of the reference
ImageError ErrorOf(const Scene& scene, vtkImageData* image, double tolerance = 1e-6)
{
  OffscreenView view(scene, image, MapperKind::Varimarch);
  const auto picture = view.FloatImage();
  const auto truth = DrawReferencePicture(scene, image, tolerance);
  const auto* pixels = static_cast<const float*>(truth.value().image->GetScalarPointer());
  const std::size_t count = std::size_t(scene.size[0]) * scene.size[1];
  EXPECT_GT(*std::max_element(pixels, pixels + 4 * count), 0.1) << "the image is empty";
  return CompareImages(static_cast<const float*>(picture->GetScalarPointer()), pixels, count);
}

ImageError ErrorAtDistance(Scene scene, double sampleDistanceMm)
{
  scene.render.sampleDistanceMm = sampleDistanceMm;
  return ErrorOf(scene, ProceduralVolume({ ProceduralKind::MarschnerLobb, { 40, 44, 48 } }));
}

}

// Mapper and reference share no formula. Agreement to thousandths of 1/255 leaves no room for a
// wrong ray, voxel position, opacity correction or light.

TEST(PictureAgainstReference, ShadedIsosurfacesHaveTheirOwnColoursAndOpacities)
{
  Scene scene = SceneOf(Blend::Isosurface, true);
  scene.look.isosurfaces = { { 0.4, { 1.0, 0.5, 0.0 }, 0.25 }, { 0.7, { 0.0, 0.5, 1.0 }, 0.75 } };
  EXPECT_LT(ErrorAtDistance(scene, 1.0).rootMeanSquare, 0.1);
}

// Every ray crosses values in the range; samples would miss a range that a ray only grazes.
TEST(PictureAgainstReference, AnAverageIsThatOfTheValuesInItsRange)
{
  Scene scene = SceneOf(Blend::AverageIntensity, false);
  scene.look.averagedRange = { { -1.0, 0.6 } };
  EXPECT_LT(ErrorAtDistance(scene, 0.02).rootMeanSquare, 0.1);
}

TEST(PictureAgainstReference, CompositeConvergesToTheIntegral)
{
  const Scene scene = SceneOf(Blend::Composite, false);
  const double coarse = ErrorAtDistance(scene, 0.8).rootMeanSquare;
  const ImageError fine = ErrorAtDistance(scene, 0.1);
  EXPECT_LT(fine.rootMeanSquare, 0.003);
  EXPECT_LT(fine.largest, 0.05);
  EXPECT_LT(fine.rootMeanSquare, coarse / 16.0) << "at least order 4 / 3; 2 where all is smooth";
}

TEST(PictureAgainstReference, ShadedCompositeConvergesToTheIntegral)
{
  const Scene scene = SceneOf(Blend::Composite, true);
  const ImageError fine = ErrorAtDistance(scene, 0.1);
  EXPECT_LT(fine.rootMeanSquare, 0.03);
  EXPECT_LT(fine.largest, 2.0);
}

TEST(PictureAgainstReference, MaximumConvergesToTheLargestValue)
{
  const Scene scene = SceneOf(Blend::MaximumIntensity, false);
  const ImageError fine = ErrorAtDistance(scene, 0.05);
  EXPECT_LT(fine.rootMeanSquare, 0.1);
  EXPECT_LT(fine.largest, 1.0);
}

TEST(PictureAgainstReference, TheOtherBlendsConvergeToWhatTheyAreCalled)
{
  for (const Blend blend : { Blend::MinimumIntensity, Blend::AverageIntensity, Blend::Additive })
  {
    const ImageError fine = ErrorAtDistance(SceneOf(blend, false), 0.05);
    EXPECT_LT(fine.rootMeanSquare, 0.1) << int(blend);
    EXPECT_LT(fine.largest, 1.0) << int(blend);
  }
}

TEST(PictureAgainstReference, ATurnedVolumeOfAnotherTypeIsInTheSamePlace)
{
  Scene scene = SceneOf(Blend::Composite, true);
  scene.look.domain = Domain::Relative;
  scene.camera.parallel = true;
  const auto image = ProceduralVolume({ ProceduralKind::Torso, { 40, 36, 24 }, 7 });
  const double direction[9] = { 0.0, 0.8, 0.6, -1.0, 0.0, 0.0, 0.0, 0.6, -0.8 };
  image->SetDirectionMatrix(direction);
  image->SetExtent(5, 44, -3, 32, 1, 24);
  image->SetSpacing(8.0, 9.0, 13.0);
  scene.render.sampleDistanceMm = 1.0;
  EXPECT_LT(ErrorOf(scene, image).rootMeanSquare, 0.3);
  scene.cuts = { { 0.2, 1.0, 0.0, 0.7, 0.1, 0.9 }, { { MiddleOf(image), { 1.0, -2.0, 0.5 } } },
    {} };
  scene.render.sampleDistanceMm = 0.5;
  EXPECT_LT(ErrorOf(scene, image).rootMeanSquare, 0.15) << "with cuts";
}

namespace
{

/// A change of a shaded composite, and the largest root mean square of what steps of 0.1 mm err.
struct ReferencePart
{
  const char* name;
  std::function<void(Scene&)> change;
  double rootMeanSquare = 0.05;
};

const std::vector<ReferencePart> ReferenceParts = {
  { "light of the camera", [](Scene& s) { s.lights = { CameraLight(-50.0, 35.0) }; } },
  { "lights of several kinds",
    [](Scene& s)
    {
      s.lights = { { LightKind::Directional, { 1.0, -1.0, 0.4 }, {}, { 1.0, 0.6, 0.3 }, 0.7 },
        { LightKind::Positional, {}, { -60.0, -50.0, 90.0 }, { 0.3, 0.5, 1.0 }, 0.6 }, {} };
    } },
  // Rays to lights have segments of the root of the sample distance.
  { "shadows",
    [](Scene& s)
    {
      s.lights = { CameraLight(-50.0, 35.0),
        { LightKind::Positional, {}, { 30.0, -50.0, 40.0 }, { 0.3, 0.5, 1.0 }, 0.6 } };
      s.shadows = 1.0;
    },
    0.2 },
  { "half of the shadows",
    [](Scene& s)
    {
      s.lights = { CameraLight(-50.0, 35.0) };
      s.shadows = 0.5;
    },
    0.2 },
  { "two lights at the eye",
    [](Scene& s)
    {
      s.lights = { { LightKind::Head, {}, {}, { 1.0, 0.6, 0.3 }, 0.4 },
        { LightKind::Head, {}, {}, { 0.2, 0.6, 0.9 }, 0.5 } };
    } },
  { "damping", [](Scene& s) { s.look.dampingGradient = 0.1; } },
  { "opacity by gradient",
    [](Scene& s) {
      s.look.gradientOpacities = { { 0.02, 0.1 }, { 0.1, 1.0 } };
    } },
  // The mapper's table has 512 values and 128 gradients.
  { "regions",
    [](Scene& s)
    {
      s.look.regions = { { RegionShape::Rectangle, { 0.3, 0.7 }, { 0.0, 0.15 }, { 1.0, 0.4, 0.2 },
                           0.03, 1.0 },
        { RegionShape::Ellipse, { 0.5, 1.1 }, { 0.03, 0.2 }, { 0.2, 0.5, 1.0 }, 0.2, 1.0 } };
    },
    0.3 },
  { "nearest voxels", [](Scene& s) { s.render.interpolation = Interpolation::Nearest; } },
  { "a spline", [](Scene& s) { s.render.interpolation = Interpolation::Cubic; } },
  { "scissors",
    [](Scene& s)
    {
      ScissorsCut cut;
      cut.camera = s.camera;
      cut.camera.pose =
        CameraPose{ { 0.0, -300.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 40.0 };
      cut.outline = { { -0.2, -1.0 }, { 1.0, 0.1 }, { 0.0, 1.0 } };
      s.cuts.scissors = { cut };
    } },
};

}

TEST(PictureAgainstReference, EveryPartOfALookConvergesToTheIntegral)
{
  for (const ReferencePart& part : ReferenceParts)
  {
    SCOPED_TRACE(part.name);
    Scene scene = SceneOf(Blend::Composite, true);
    scene.size = { 24, 20 };
    const auto image = ProceduralVolume({ ProceduralKind::MarschnerLobb, { 24, 26, 28 } });
    scene.render.sampleDistanceMm = 0.1;
    const auto without = DrawReferencePicture(scene, image, 1e-3);
    part.change(scene);
    EXPECT_LT(ErrorOf(scene, image, 1e-5).rootMeanSquare, part.rootMeanSquare);
    const auto with = DrawReferencePicture(scene, image, 1e-3);
    EXPECT_GT(CompareImages(static_cast<const float*>(with->image->GetScalarPointer()),
                static_cast<const float*>(without->image->GetScalarPointer()),
                std::size_t(without->image->GetNumberOfPoints()))
                .rootMeanSquare,
      20.0 * part.rootMeanSquare)
      << "nothing of the part is seen";
  }
}

TEST(PictureAgainstReference, SoftShadowsConvergeToTheIntegral)
{
  Scene scene = SceneOf(Blend::Composite, true);
  scene.size = { 6, 5 };
  scene.lights = { CameraLight(50.0, 30.0) };
  scene.lights[0].softnessDegrees = 20.0;
  scene.shadows = true;
  scene.render.sampleDistanceMm = 0.25;
  const auto image = ProceduralVolume({ ProceduralKind::MarschnerLobb, { 24, 26, 28 } });
  EXPECT_LT(ErrorOf(scene, image, 1e-3).rootMeanSquare, 0.3);
  scene.render.errorTolerance = 1.0 / 64.0;
  EXPECT_LT(ErrorOf(scene, image, 1e-3).percentile999, 255.0 / 64.0);
}

TEST(PictureAgainstReference, ScatteredLightConvergesToTheIntegral)
{
  Scene scene = SceneOf(Blend::Composite, true);
  scene.size = { 12, 10 };
  scene.lights = { CameraLight(50.0, 30.0), SceneLight() };
  scene.render.sampleDistanceMm = 0.1;
  const auto image = ProceduralVolume({ ProceduralKind::MarschnerLobb, { 24, 26, 28 } });
  for (const Scattering& scattering :
    { Scattering{ 2.0, 0.0, 0.0 }, Scattering{ 0.5, 0.4, 1.0 }, Scattering{ 1.0, -0.3, 0.05 } })
  {
    scene.scattering = scattering;
    EXPECT_LT(ErrorOf(scene, image, 1e-4).rootMeanSquare, 0.2) << scattering.reach;
  }
  scene.shadows = true;
  EXPECT_LT(ErrorOf(scene, image, 1e-4).rootMeanSquare, 0.2);
}

// A box keeps one part of its light, that of its middle, which rays through boxes find exactly.
TEST(PictureAgainstReference, AmbientOcclusionOfBoxesIsExact)
{
  Scene scene = SceneOf(Blend::Composite, true);
  scene.size = { 4, 4 };
  scene.render.interpolation = Interpolation::Nearest;
  scene.render.sampleDistanceMm = 0.25; // without a lattice of light, which has an error of its own
  scene.occlusion = { 0.6, 3.0 };
  const auto image = ProceduralVolume({ ProceduralKind::MarschnerLobb, { 8, 8, 8 } });
  EXPECT_LT(ErrorOf(scene, image, 1e-3).rootMeanSquare, 0.3);
}

// The reference traces 32 rays from every place at which it asks for the colour, so that the image
// is small and its tolerance a quarter of a level.
TEST(PictureAgainstReference, AmbientOcclusionOfLitAndOfUnlitMatterConvergesToTheIntegral)
{
  for (const bool isLit : { true, false })
  {
    Scene scene = SceneOf(Blend::Composite, isLit);
    scene.size = { 6, 5 };
    scene.render.sampleDistanceMm = 0.25;
    const auto image = ProceduralVolume({ ProceduralKind::MarschnerLobb, { 24, 26, 28 } });
    scene.occlusion = { isLit ? 0.4 : 1.0, 5.0 };
    EXPECT_LT(ErrorOf(scene, image, 1e-3).rootMeanSquare, 0.3) << isLit;
    Scene open = scene;
    open.occlusion = {};
    const auto with = DrawReferencePicture(scene, image, 1e-2);
    const auto without = DrawReferencePicture(open, image, 1e-2);
    EXPECT_GT(CompareImages(static_cast<const float*>(with->image->GetScalarPointer()),
                static_cast<const float*>(without->image->GetScalarPointer()),
                std::size_t(without->image->GetNumberOfPoints()))
                .rootMeanSquare,
      4.0)
      << isLit;
  }
}

TEST(PictureAgainstReference, ScissorsCutProjectionsToo)
{
  for (const Blend blend : { Blend::MaximumIntensity, Blend::AverageIntensity })
  {
    Scene scene = SceneOf(blend, false);
    ReferenceParts.back().change(scene);
    EXPECT_LT(ErrorAtDistance(scene, 0.05).rootMeanSquare, 0.1) << int(blend);
  }
}

/// A head CT of the package invesalius-examples, with default settings.
TEST(PictureAgainstReference, RealHeadIsWithinHalfAStepOfTheIntegralByDefault)
{
  const char* path = std::getenv("VARIMARCH_HEAD_CT");
  if (!path || !std::filesystem::exists(path))
  {
    GTEST_SKIP() << "VARIMARCH_HEAD_CT does not name the head CT; test.sh sets it";
  }
  const LoadedVolume volume = LoadVolume(FileSource{ path, std::nullopt });
  Scene scene;
  scene.look = BuiltInPreset("ct-bone").look;
  scene.size = { 128, 128 };
  for (const bool shading : { false, true })
  {
    scene.look.shading.enabled = shading;
    EXPECT_LT(ErrorOf(scene, volume.image).rootMeanSquare, 0.5) << "shading " << shading;
  }
}
