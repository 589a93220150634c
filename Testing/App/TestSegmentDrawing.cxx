// Labels over a scan: a visible segment has its own colour and opacity, everything else the look.
#include "Core/Quality/ImageError.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Segments/LabelMap.h"

#include <vtkCamera.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

constexpr int Side = 24;
constexpr int Picture = 48;

// A scan of values from 0 to 230 along x, with two segments: a box of 8 x 8 x 8 mm around the
// middle, and one of 4 x 24 x 24 mm at the right.
class LabelledScan : public testing::Test
{
protected:
  LabelledScan()
  {
    this->labels->image->SetDimensions(Side, Side, Side);
    this->labels->image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    this->scan->SetDimensions(Side, Side, Side);
    this->scan->AllocateScalars(VTK_SHORT, 1);
    const auto isMiddle = [](int index) { return index >= 8 && index < 16; };
    for (int z = 0; z < Side; ++z)
    {
      for (int y = 0; y < Side; ++y)
      {
        for (int x = 0; x < Side; ++x)
        {
          const int number = isMiddle(x) && isMiddle(y) && isMiddle(z) ? 1 : x >= 20 ? 2 : 0;
          this->labels->image->SetScalarComponentFromDouble(x, y, z, 0, number);
          this->scan->SetScalarComponentFromDouble(x, y, z, 0, 10 * x);
        }
      }
    }
    this->labels->segments = { { 3, "middle", { 1.0, 0.0, 0.0 }, true, 0.5 },
      { 8, "side", { 0.0, 0.0, 1.0 }, true, 1.0 } };
    this->labels->sizes = SizesOf(this->labels->image, 2);
    this->scene.look = LookOfLabelsOnly();
    this->scene.look.shading.enabled = false;
    this->scene.camera.view = View::Anterior;
    this->scene.camera.parallel = true;
    this->scene.size = { Picture, Picture };
  }

  vtkSmartPointer<vtkImageData> Draw(MapperKind kind = MapperKind::Varimarch)
  {
    OffscreenView view(this->scene, this->scan, kind);
    view.Pipeline().SetLabels(this->labels);
    view.Render(); // VTK's mapper draws its first frame only into the window itself
    return view.FloatImage();
  }

  static double ErrorBetween(vtkImageData* one, vtkImageData* other)
  {
    return CompareImages(static_cast<const float*>(one->GetScalarPointer()),
      static_cast<const float*>(other->GetScalarPointer()), std::size_t(Picture * Picture))
      .largest;
  }

  // A channel of the pixel in the middle, or of the one through the right box.
  static double Middle(vtkImageData* picture, int channel)
  {
    return picture->GetScalarComponentAsDouble(Picture / 2, Picture / 2, 0, channel);
  }
  static double RightBox(vtkImageData* picture, int channel)
  {
    return picture->GetScalarComponentAsDouble(Picture / 2 + 20, Picture / 2, 0, channel);
  }

  const std::shared_ptr<LabelMap> labels = []
  {
    auto map = std::make_shared<LabelMap>();
    map->image = vtkSmartPointer<vtkImageData>::New();
    return map;
  }();
  vtkNew<vtkImageData> scan;
  Scene scene;
};

constexpr double Tolerance = 1.0 / 255.0;

}

TEST_F(LabelledScan, HasSegmentsInTheirOwnColourWhereTheLookIsTransparent)
{
  const auto picture = this->Draw();
  EXPECT_NEAR(RightBox(picture, 2), 1.0, Tolerance);
  EXPECT_NEAR(RightBox(picture, 3), 1.0, Tolerance);
  EXPECT_NEAR(RightBox(picture, 0), 0.0, Tolerance);
  // A cube of 8 mm has this mean thickness too, so a ray along its axis has the stated opacity.
  ASSERT_NEAR(this->labels->sizes[0].thicknessMm, 8.0, 1e-9);
  EXPECT_NEAR(Middle(picture, 0), 0.5, Tolerance);
  EXPECT_NEAR(Middle(picture, 3), 0.5, Tolerance);
  EXPECT_NEAR(picture->GetScalarComponentAsDouble(4, 4, 0, 3), 0.0, Tolerance);
}

TEST_F(LabelledScan, HasOpaqueSegmentsEvenWhereTheyAreOneVoxelThick)
{
  for (int z = 0; z < Side; ++z)
  {
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        this->labels->image->SetScalarComponentFromDouble(x, y, z, 0, y == Side / 2 ? 2 : 0);
      }
    }
  }
  this->labels->sizes = SizesOf(this->labels->image, 2);
  EXPECT_GT(RightBox(this->Draw(), 3), 0.97);
}

TEST_F(LabelledScan, KeepsTheOpacityOfSegmentsForOtherUnitDistances)
{
  this->scene.look.opacityUnitDistanceMm = 7.0;
  EXPECT_NEAR(Middle(this->Draw(), 3), 0.5, Tolerance);
}

TEST_F(LabelledScan, IsDrawnByTheLookOutsideAndInsideHiddenSegments)
{
  this->scene.look.colors = { { 0.0, { 0.0, 1.0, 0.0 } }, { 230.0, { 1.0, 1.0, 0.0 } } };
  this->scene.look.opacities = { { 0.0, 0.0 }, { 230.0, 0.1 } };
  const auto plain = OffscreenView(this->scene, this->scan, MapperKind::Varimarch).FloatImage();
  EXPECT_GT(ErrorBetween(plain, this->Draw()), 20.0);
  this->labels->segments[0].visible = false;
  this->labels->segments[1].visible = false;
  EXPECT_LT(ErrorBetween(plain, this->Draw()), 1.5);
}

TEST_F(LabelledScan, IsFreeOfTheGradientOpacityOfTheLookInSegments)
{
  this->scene.look.gradientOpacities = { { 0.0, 0.0 } };
  EXPECT_NEAR(Middle(this->Draw(), 3), 0.5, Tolerance);
}

TEST_F(LabelledScan, HasItsSegmentsOverRegionsOfValueAndGradient)
{
  LookRegion green = { RegionShape::Rectangle, { -1.0, 231.0 }, { 0.0, 1000.0 },
    { 0.0, 1.0, 0.0 } };
  green.opacity = 0.0;
  this->scene.look.regions = { green };
  const auto clear = this->Draw();
  EXPECT_NEAR(Middle(clear, 0), 0.5, Tolerance);
  EXPECT_NEAR(Middle(clear, 3), 0.5, Tolerance);
  this->scene.look.regions[0].opacity = 0.1;
  const auto plain = OffscreenView(this->scene, this->scan, MapperKind::Varimarch).FloatImage();
  EXPECT_GT(ErrorBetween(plain, this->Draw()), 20.0);
  this->labels->segments[0].visible = false;
  this->labels->segments[1].visible = false;
  EXPECT_LT(ErrorBetween(plain, this->Draw()), 1.5);
}

TEST_F(LabelledScan, ChangesSegmentsWithoutTheirVoxels)
{
  OffscreenView view(this->scene, this->scan, MapperKind::Varimarch);
  view.Pipeline().SetLabels(this->labels);
  std::vector<Segment> segments = this->labels->segments;
  segments[0].rgb = { 0.0, 1.0, 0.0 };
  segments[0].opacity = 0.25;
  segments[1].visible = false;
  view.Pipeline().SetSegments(segments);
  const auto picture = view.FloatImage();
  EXPECT_NEAR(Middle(picture, 0), 0.0, Tolerance);
  EXPECT_NEAR(Middle(picture, 1), 0.25, Tolerance);
  EXPECT_NEAR(RightBox(picture, 3), 0.0, Tolerance);
  view.Pipeline().SetLabels(nullptr);
  EXPECT_NEAR(Middle(view.FloatImage(), 3), 0.0, Tolerance);
}

TEST_F(LabelledScan, LosesWhatScissorsRemove)
{
  const auto whole = this->Draw();
  OffscreenView posed(this->scene, this->scan, MapperKind::Varimarch);
  vtkCamera* const camera = posed.Pipeline().Renderer()->GetActiveCamera();
  ScissorsCut cut;
  cut.camera.parallel = true;
  cut.camera.pose.emplace();
  camera->GetPosition(cut.camera.pose->positionMm.data());
  camera->GetFocalPoint(cut.camera.pose->focalPointMm.data());
  camera->GetViewUp(cut.camera.pose->viewUp.data());
  cut.camera.pose->parallelScaleMm = camera->GetParallelScale();
  cut.outline = { { -0.1, -2.0 }, { 0.2, -2.0 }, { 0.2, 2.0 }, { -0.1, 2.0 } };
  this->scene.cuts.scissors = { cut };
  const auto picture = this->Draw();
  EXPECT_GT(Middle(whole, 3), 0.4);
  EXPECT_NEAR(Middle(picture, 3), 0.0, Tolerance);
  EXPECT_NEAR(RightBox(picture, 2), 1.0, Tolerance);
  // Without labels the same scissors still cut.
  this->scene.look.opacities = { { 0.0, 0.5 } };
  OffscreenView plain(this->scene, this->scan, MapperKind::Varimarch);
  EXPECT_NEAR(Middle(plain.FloatImage(), 3), 0.0, Tolerance);
}

TEST_F(LabelledScan, IsDrawnWithoutLabelsInProjections)
{
  EXPECT_FALSE(CanDrawLabels(MapperKind::Varimarch, Blend::MaximumIntensity, this->scan));
  EXPECT_FALSE(CanDrawLabels(MapperKind::VtkCpu, Blend::Composite, this->scan));
  EXPECT_TRUE(CanDrawLabels(MapperKind::VtkGpu, Blend::Composite, this->scan));
  this->scene.look.blend = Blend::MaximumIntensity;
  this->scene.look.opacities = { { 0.0, 0.0 }, { 230.0, 1.0 } };
  const auto plain = OffscreenView(this->scene, this->scan, MapperKind::Varimarch).FloatImage();
  EXPECT_LT(ErrorBetween(plain, this->Draw()), 1.0);
}

// VTK 9.1 does not correct the opacity of labels for the length of its steps, so only the colour
// can be compared.
TEST_F(LabelledScan, HasItsColoursByTheMapperOfVtkToo)
{
  this->scene.render.sampleDistanceMm = 1.0;
  const auto picture = this->Draw(MapperKind::VtkGpu);
  EXPECT_GT(Middle(picture, 0), 0.4);
  EXPECT_NEAR(Middle(picture, 1), 0.0, Tolerance);
}
