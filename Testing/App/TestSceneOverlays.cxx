// Several volumes in one scene: a volume over itself is twice as dense, and a placement is where
// the volume is.

#include "Core/Quality/ImageError.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Model/SceneLights.h"
#include "Scene/Volumes/Placing.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

constexpr double Levels = 255.0; // CompareImages counts in levels of 8 bits

Look Fog(const glm::dvec3& rgb)
{
  Look look;
  look.colors = { { 0.0, rgb } };
  look.opacities = { { -200.0, 0.0 }, { 300.0, 0.02 } };
  look.shading.enabled = false;
  return look;
}

struct Overlaid
{
  Scene scene;
  vtkSmartPointer<vtkImageData> image =
    ProceduralVolume({ ProceduralKind::Torso, { 48, 40, 36 }, 1 });
  std::vector<OverlayVoxels> others;

  Overlaid()
  {
    this->scene.look = Fog({ 1.0, 0.5, 0.25 });
    this->scene.size = { 64, 64 };
    this->scene.camera.azimuthDegrees = 20.0;
    this->scene.render.sampleDistanceMm = 1.0;
  }

  void Add(const OverlaidVolume& overlay, vtkImageData* other)
  {
    this->scene.overlays.push_back(overlay);
    this->others.push_back({ other });
  }

  vtkSmartPointer<vtkImageData> Draw(MapperKind kind = MapperKind::Varimarch) const
  {
    OffscreenView view(this->scene, this->image, kind);
    view.Pipeline().SetOverlays(this->scene.overlays, this->others);
    view.Render(); // VTK's GPU mapper renders its first frame only into the window itself
    return view.FloatImage();
  }
};

// A cube of clear voxels, 1 mm apart, whose slab of 8 voxels along y is a segment.
vtkSmartPointer<vtkImageData> ClearCube()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(17, 17, 17);
  image->AllocateScalars(VTK_SHORT, 1);
  image->GetPointData()->GetScalars()->Fill(0.0);
  return image;
}

constexpr int SlabVoxels = 8;

std::shared_ptr<const LabelMap> SlabOf(vtkImageData* scan, const Segment& segment)
{
  auto map = std::make_shared<LabelMap>();
  map->image = vtkSmartPointer<vtkImageData>::New();
  map->image->CopyStructure(scan);
  map->image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  map->image->GetPointData()->GetScalars()->Fill(0.0);
  for (int voxel = 0; voxel < 17 * SlabVoxels * 17; ++voxel)
  {
    const int x = voxel % 17;
    const int y = 4 + voxel / 17 % SlabVoxels;
    map->image->SetScalarComponentFromDouble(x, y, voxel / (17 * SlabVoxels), 0, 1.0);
  }
  map->segments = { segment };
  map->sizes = SizesOf(map->image, 1);
  return map;
}

// Two clear cubes, one over the other, seen along y.
struct ClearCubes : Overlaid
{
  ClearCubes()
  {
    this->image = ClearCube();
    this->scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
    this->scene.look.opacities = { { 0.0, 0.0 } };
    this->scene.camera = {};
    this->scene.camera.view = View::Anterior;
    this->scene.camera.parallel = true;
    this->Add({ ProceduralSource(), this->scene.look }, ClearCube());
  }

  void Label(const Segment& segment)
  {
    this->scene.overlays[0].labels = SceneLabels{ "labels", {}, { segment } };
    this->others[0].labels = SlabOf(this->others[0].image, segment);
  }

  std::array<double, 4> Middle()
  {
    const auto picture = this->Draw();
    std::array<double, 4> color;
    for (int channel = 0; channel < 4; ++channel)
    {
      color[channel] = picture->GetScalarComponentAsDouble(32, 32, 0, channel);
    }
    return color;
  }
};

ImageError Difference(vtkImageData* a, vtkImageData* b)
{
  return CompareImages(static_cast<const float*>(a->GetScalarPointer()),
    static_cast<const float*>(b->GetScalarPointer()), std::size_t(a->GetNumberOfPoints()));
}

}

TEST(SceneOverlays, AVolumeOverItselfIsTwiceAsDense)
{
  Overlaid both;
  both.Add({ ProceduralSource(), both.scene.look }, both.image);
  Overlaid dense;
  dense.scene.look.opacityUnitDistanceMm = 0.5;
  // Both are integrated by the same steps, but by different rules.
  EXPECT_LT(Difference(both.Draw(), dense.Draw()).largest, 0.01 * Levels);
  Overlaid once;
  EXPECT_GT(Difference(both.Draw(), once.Draw()).largest, 0.1 * Levels);
}

// Twice the density casts the shadows of twice the density.
TEST(SceneOverlays, AVolumeOverItselfCastsItsShadowsToo)
{
  const auto light = [](Overlaid& scene, double opacityUnitDistanceMm)
  {
    scene.scene.look.shading.enabled = true;
    scene.scene.look.opacityUnitDistanceMm = opacityUnitDistanceMm;
    scene.scene.lights = { CameraLight(-50.0, 35.0) };
    scene.scene.shadows = 1.0;
    scene.scene.render.sampleDistanceMm.reset();
  };
  Overlaid both;
  light(both, 0.5);
  both.Add({ ProceduralSource(), both.scene.look }, both.image);
  Overlaid dense;
  light(dense, 0.25);
  const auto drawn = both.Draw();
  EXPECT_LT(Difference(drawn, dense.Draw()).percentile999, 2.0 / 64.0 * Levels);
  both.scene.shadows = 0.0;
  EXPECT_GT(Difference(drawn, both.Draw()).largest, 0.1 * Levels) << "shadows are seen";
}

TEST(SceneOverlays, HiddenOnesAndThoseOfNoOpacityLeaveTheImage)
{
  Overlaid alone;
  Overlaid hidden;
  OverlaidVolume overlay = { ProceduralSource(), Fog({ 0.0, 1.0, 0.0 }) };
  overlay.visible = false;
  hidden.Add(overlay, hidden.image);
  EXPECT_EQ(Difference(alone.Draw(), hidden.Draw()).largest, 0.0);
  Overlaid clear;
  overlay.visible = true;
  overlay.opacity = 0.0;
  clear.Add(overlay, clear.image);
  EXPECT_LT(Difference(alone.Draw(), clear.Draw()).largest, 0.01 * Levels);
}

TEST(SceneOverlays, APlacementIsWhereTheVolumeIs)
{
  const Placement placement = { { 10.0, 20.0, -30.0 }, { 40.0, -20.0, 10.0 } };
  Overlaid moved;
  moved.Add({ ProceduralSource(), Fog({ 0.0, 1.0, 0.0 }), "", placement }, moved.image);
  Overlaid there;
  there.Add({ ProceduralSource(), Fog({ 0.0, 1.0, 0.0 }) }, Placed(there.image, placement));
  const auto picture = moved.Draw();
  EXPECT_LT(Difference(picture, there.Draw()).largest, 1e-3 * Levels);
  Overlaid unmoved;
  unmoved.Add({ ProceduralSource(), Fog({ 0.0, 1.0, 0.0 }) }, unmoved.image);
  EXPECT_GT(Difference(picture, unmoved.Draw()).largest, 0.1 * Levels);
}

// The first volume is a maximum with a mask, which several volumes cannot be.
TEST(SceneOverlays, TheFirstVolumeIsItselfAgainWhenTheyGo)
{
  Overlaid scene;
  scene.scene.look.blend = Blend::MaximumIntensity;
  scene.scene.cuts.bodyOnly = true;
  const auto expected = scene.Draw();
  OffscreenView view(scene.scene, scene.image, MapperKind::Varimarch);
  view.Pipeline().SetOverlays(
    { { ProceduralSource(), Fog({ 0.0, 1.0, 0.0 }) } }, { { scene.image } });
  EXPECT_GT(Difference(view.FloatImage(), expected).largest, 0.1 * Levels);
  view.Pipeline().SetOverlays({}, {});
  EXPECT_EQ(Difference(view.FloatImage(), expected).largest, 0.0);
}

TEST(SceneOverlays, WhatIsCutAwayOfTheFirstVolumeIsNotDrawn)
{
  Overlaid cut;
  cut.Add({ ProceduralSource(), Fog({ 0.0, 1.0, 0.0 }), "", {}, true, 0.0 }, cut.image);
  const auto whole = cut.Draw();
  // The table of the torso has values that the fog shows; without it there is less of it.
  cut.scene.cuts.bodyOnly = true;
  const auto body = cut.Draw();
  Overlaid alone;
  alone.scene.cuts.bodyOnly = true;
  EXPECT_GT(Difference(whole, body).largest, 0.02 * Levels);
  EXPECT_LT(Difference(alone.Draw(), body).rootMeanSquare, 0.02 * Levels);
}

TEST(SceneOverlays, VtkDrawsThemAlike)
{
  Overlaid both;
  both.Add(
    { ProceduralSource(), Fog({ 0.0, 1.0, 0.0 }), "", { { 0.0, 0.0, 30.0 }, {} } }, both.image);
  const auto ours = both.Draw();
  // VTK's mapper composites its volumes one after another at each sample, and jitters none.
  EXPECT_LT(Difference(ours, both.Draw(MapperKind::VtkGpu)).rootMeanSquare, 0.03 * Levels);
}

// The opacity of a segment is that of its mean thickness, which fixes its extinction.
TEST(SceneOverlays, HaveSegmentsOfTheirOwn)
{
  ClearCubes cubes;
  EXPECT_EQ(cubes.Middle()[3], 0.0);
  const Segment segment = { 1, "slab", { 0.25, 0.5, 1.0 }, true, 0.5 };
  cubes.Label(segment);
  cubes.scene.overlays[0].look.shading.enabled = true; // but the inside has no surfaces
  const double thicknessMm = cubes.others[0].labels->sizes[0].thicknessMm;
  const double opacity = 1.0 - std::pow(1.0 - segment.opacity, SlabVoxels / thicknessMm);
  const auto middle = cubes.Middle();
  EXPECT_NEAR(middle[3], opacity, 1.0 / Levels);
  EXPECT_NEAR(middle[0], 0.25 * opacity, 1.0 / Levels);
  EXPECT_NEAR(middle[2], opacity, 1.0 / Levels);
  cubes.scene.overlays[0].labels->segments[0].visible = false;
  EXPECT_EQ(cubes.Middle()[3], 0.0);
}

TEST(SceneOverlays, LeaveTheSegmentsOfTheFirstVolumeVisible)
{
  ClearCubes cubes;
  cubes.scene.labels = SceneLabels{ "labels", {}, { { 1, "slab", { 1.0, 0.0, 0.0 } } } };
  OffscreenView view(cubes.scene, cubes.image, MapperKind::Varimarch);
  view.Pipeline().SetOverlays(cubes.scene.overlays, cubes.others);
  view.Pipeline().SetLabels(SlabOf(cubes.image, cubes.scene.labels->segments[0]));
  EXPECT_GT(view.FloatImage()->GetScalarComponentAsDouble(32, 32, 0, 0), 0.9);
  std::vector<Segment> blue = { { 1, "slab", { 0.0, 0.0, 1.0 } } };
  view.Pipeline().SetSegments(blue);
  EXPECT_GT(view.FloatImage()->GetScalarComponentAsDouble(32, 32, 0, 2), 0.9);
  view.Pipeline().SetLabels(nullptr);
  EXPECT_EQ(view.FloatImage()->GetScalarComponentAsDouble(32, 32, 0, 3), 0.0);
}

TEST(SceneOverlays, LightTheSegmentsOfTheFirstVolumeByItsLook)
{
  ClearCubes cubes;
  cubes.scene.labels = SceneLabels{ "labels", {}, { { 1, "slab", { 1.0, 1.0, 1.0 } } } };
  OffscreenView view(cubes.scene, cubes.image, MapperKind::Varimarch);
  view.Pipeline().SetOverlays(cubes.scene.overlays, cubes.others);
  view.Pipeline().SetLabels(SlabOf(cubes.image, cubes.scene.labels->segments[0]));
  const auto brightness = [&](double ambient, double diffuse)
  {
    Look look = cubes.scene.look;
    look.shading = { true, ambient, diffuse, 0.0, 1.0 };
    view.Pipeline().SetLook(look);
    return view.FloatImage()->GetScalarComponentAsDouble(32, 32, 0, 0);
  };
  EXPECT_GT(brightness(1.0, 0.0), 0.9);
  EXPECT_LT(brightness(0.1, 0.0), 0.2);
}

TEST(SceneOverlays, SayWhenNotAllSegmentationsFit)
{
  Scene scene;
  scene.overlays.resize(2);
  scene.labels = SceneLabels();
  EXPECT_TRUE(AreAllSegmentsDrawn(scene));
  scene.overlays[1].labels = SceneLabels();
  EXPECT_FALSE(AreAllSegmentsDrawn(scene));
  scene.overlays[0].visible = false;
  EXPECT_TRUE(AreAllSegmentsDrawn(scene));
}
