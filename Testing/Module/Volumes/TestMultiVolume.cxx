// Overlapping volumes of a vtkMultiVolume: their extinctions and emissions add up.

#include "Module/Scenes/HomogeneousScene.h"
#include "Module/Scenes/OverlapScene.h"

#include <vtkPlane.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// The same opacity for all values from 0 to 2.
ComponentLook OneMaterial(glm::dvec3 color, double opacity)
{
  return { color, -2.0, -1.0, opacity };
}

const ComponentLook red = OneMaterial({ 0.9, 0.2, 0.1 }, 0.1);
const ComponentLook blue = OneMaterial({ 0.1, 0.3, 0.8 }, 0.05);

// A box of one material in world space, for closed forms.
struct ClosedBox
{
  VolumeGeometry geometry;
  ComponentLook look;

  Interval PartOf(const Ray& rayWorld) const
  {
    const glm::dmat4 gridFromWorld = glm::inverse(this->geometry.worldFromGrid);
    const Ray ray{ glm::dvec3(gridFromWorld * glm::dvec4(rayWorld.origin, 1.0)),
      glm::dmat3(gridFromWorld) * rayWorld.direction };
    return Intersection(ray, this->geometry.boxGrid);
  }
};

// Emission and absorption along a ray with a unit direction, piece by piece between the faces of
// all boxes.
glm::dvec4 ClosedForm(const std::vector<ClosedBox>& boxes, const Ray& rayWorld)
{
  std::vector<double> faces;
  for (const ClosedBox& box : boxes)
  {
    const Interval part = box.PartOf(rayWorld);
    faces.insert(faces.end(), { part.enter, part.exit });
  }
  std::sort(faces.begin(), faces.end());
  glm::dvec4 sum(0.0);
  for (std::size_t i = 1; i < faces.size(); ++i)
  {
    const double middle = 0.5 * (faces[i - 1] + faces[i]);
    glm::dvec3 emission(0.0);
    double extinction = 0.0;
    for (const ClosedBox& box : boxes)
    {
      const Interval part = box.PartOf(rayWorld);
      const bool isIn = part.enter < middle && middle < part.exit;
      const double own = isIn ? -std::log1p(-box.look.opacity) : 0.0;
      emission += own * box.look.color;
      extinction += own;
    }
    if (extinction > 0.0)
    {
      const double absorbed = -std::expm1(-extinction * (faces[i] - faces[i - 1]));
      sum += (1.0 - sum.a) * absorbed * glm::dvec4(emission / extinction, 1.0);
    }
  }
  return sum;
}

void ExpectClosedForm(
  OverlapScene& scene, const std::vector<float>& drawn, const std::vector<ClosedBox>& boxes)
{
  ASSERT_STREQ(scene.mapper->GetReasonForVtkMapper(), "");
  const PixelRays rays = scene.RaysWorld();
  double seen = 0.0;
  for (int pixel = 0; pixel < scene.size * scene.size; ++pixel)
  {
    const double x = (pixel % scene.size + 0.5) / scene.size * 2.0 - 1.0;
    const double y = (pixel / scene.size + 0.5) / scene.size * 2.0 - 1.0;
    Ray ray = rays.At(x, y);
    ray.direction = glm::normalize(ray.direction);
    const glm::dvec4 truth = ClosedForm(boxes, ray);
    for (int channel = 0; channel < 4; ++channel)
    {
      // Rounding of float positions of about ten millimetres.
      ASSERT_NEAR(drawn[4 * pixel + channel], truth[channel], 5e-5) << x << " " << y;
    }
    seen = std::max(seen, truth.a);
  }
  EXPECT_GT(seen, 0.3) << "the image is empty";
}

void ExpectClosedForm(OverlapScene& scene, const std::vector<ClosedBox>& boxes)
{
  ExpectClosedForm(scene, scene.DrawByProcessor(), boxes);
  ExpectClosedForm(scene, scene.Draw(), boxes);
}

struct TwoBoxes
{
  explicit TwoBoxes(OverlapScene& scene, int firstPort = 0, int secondPort = 3)
  {
    this->images = { HomogeneousBox({ 12.0, 16.0, 10.0 }), HomogeneousBox({ 18.0, 8.0, 14.0 }) };
    this->volumes = { scene.Add(firstPort, this->images[0], red),
      scene.Add(secondPort, this->images[1], blue) };
    this->volumes[0]->RotateX(20.0);
    this->volumes[1]->SetPosition(3.0, -2.0, 1.0);
    this->volumes[1]->SetScale(1.0, 1.3, 0.8);
    this->volumes[1]->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  }

  std::vector<ClosedBox> Closed() const
  {
    return { { VolumeGeometryOf(this->images[0], this->volumes[0]), red },
      { VolumeGeometryOf(this->images[1], this->volumes[1]), blue } };
  }

  std::vector<vtkSmartPointer<vtkImageData>> images;
  std::vector<vtkSmartPointer<vtkVolume>> volumes;
};

}

TEST(MultiVolume, HomogeneousBoxesAtAnAngleHaveTheirClosedForm)
{
  OverlapScene scene;
  const TwoBoxes boxes(scene);
  ExpectClosedForm(scene, boxes.Closed());
  // The renderer derives the clipping range from the bounds that VTK reports.
  scene.renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.renderer->ResetCamera();
  ExpectClosedForm(scene, boxes.Closed());
}

class CutVolumes : public testing::TestWithParam<bool>
{
};

TEST_P(CutVolumes, AreCutByClippingPlanesAndEndAtOpaqueGeometry)
{
  OverlapScene scene;
  scene.mapper->GetVariationFieldMapper()->SetProcessorMarching(GetParam());
  const TwoBoxes boxes(scene);
  const std::vector<float> whole = scene.Draw();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 1.0);
  plane->SetNormal(0.0, 0.0, -1.0);
  scene.mapper->AddClippingPlane(plane);
  const std::vector<float> behind = scene.Draw();
  plane->SetNormal(0.0, 0.0, 1.0);
  const std::vector<float> front = scene.Draw();
  scene.mapper->RemoveAllClippingPlanes();
  scene.renderer->AddActor(Plane(1.0, -100.0, { 0.0, 0.0, 0.0 }));
  const std::vector<float> beforeGeometry = scene.Draw();
  double largest = 0.0;
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    // The front part transmits some of the back part, and geometry shows only the front part.
    const double joined = front[i] + (1.0 - front[i / 4 * 4 + 3]) * behind[i];
    ASSERT_NEAR(joined, whole[i], 5e-5);
    const bool isAlpha = i % 4 == 3;
    ASSERT_NEAR(beforeGeometry[i], isAlpha ? 1.0 : front[i], 5e-5);
    largest = std::max(largest, double(std::min(front[i], behind[i])));
  }
  EXPECT_GT(largest, 0.2) << "the plane cuts nothing";
}

INSTANTIATE_TEST_SUITE_P(ByProcessorOrNot, CutVolumes, testing::Bool());

TEST(MultiVolume, AVolumeFarFromTheOtherIsRenderedAsIfAlone)
{
  OverlapScene scene;
  const TwoBoxes boxes(scene);
  const std::vector<float> together = scene.Draw();
  boxes.volumes[1]->SetPosition(1000.0, 0.0, 300.0);
  ExpectClosedForm(scene, boxes.Closed());
  boxes.volumes[0]->SetPosition(-1000.0, 0.0, 300.0);
  boxes.volumes[1]->SetPosition(3.0, -2.0, 1.0);
  ExpectClosedForm(scene, boxes.Closed());
  boxes.volumes[0]->SetPosition(0.0, 0.0, 0.0);
  EXPECT_EQ(scene.Draw(), together);
}

TEST(MultiVolume, ASingleVolumeIsRenderedAsWithoutAMultiVolume)
{
  OverlapScene scene;
  const TwoBoxes boxes(scene);
  scene.Draw();
  const vtkIdType bytesOfTwo = scene.mapper->GetVariationFieldMapper()->GetGraphicsMemoryBytes();
  scene.Remove(3);
  const std::vector<float> left = scene.Draw();
  ASSERT_STREQ(scene.mapper->GetReasonForVtkMapper(), "");
  const vtkIdType bytesLeft = scene.mapper->GetVariationFieldMapper()->GetGraphicsMemoryBytes();
  for (const std::string& part : scene.ShaderParts())
  {
    EXPECT_TRUE(part.find("Volumes/") != 0 && part.find("Reading/") != 0) << part;
  }

  vtkNew<vtkVolume> alone;
  alone->SetProperty(boxes.volumes[0]->GetProperty());
  alone->RotateX(20.0);
  vtkNew<vtkVariationFieldVolumeMapper> mapper;
  mapper->SetInputData(boxes.images[0]);
  mapper->SetErrorTolerance(0.0);
  mapper->ProcessorMarchingOff();
  alone->SetMapper(mapper);
  scene.renderer->RemoveVolume(scene.several);
  scene.renderer->AddVolume(alone);
  EXPECT_EQ(scene.Draw(), left);
  EXPECT_EQ(mapper->GetGraphicsMemoryBytes(), bytesLeft);
  EXPECT_LT(bytesLeft, bytesOfTwo);
}

class OverlappingBalls : public testing::TestWithParam<BallLooks>
{
};

TEST_P(OverlappingBalls, KeepTheErrorTolerance)
{
  OverlapScene scene;
  AddBalls(scene, GetParam());
  for (const double ofGrayLevels : { 4.0, 0.5 })
  {
    scene.mapper->GetVariationFieldMapper()->SetErrorTolerance(ofGrayLevels / 255.0);
    const ImageError error = scene.Error();
    ASSERT_STREQ(scene.mapper->GetReasonForVtkMapper(), "");
    EXPECT_LT(error.percentile999, ofGrayLevels);
    EXPECT_LT(error.largest, 2.0 * ofGrayLevels);
  }
  const std::vector<float> drawn = scene.Draw();
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.5) << "the image is empty";
}

INSTANTIATE_TEST_SUITE_P(ShadedOrNot, OverlappingBalls,
  testing::Values(BallLooks{ false, false, false, false }, BallLooks{ true, false, false, false },
    BallLooks{ true, true, false, false }, BallLooks{ true, false, false, true },
    BallLooks{ false, true, true, true }));

TEST(MultiVolume, TheOrderOfPortsMakesNoDifference)
{
  OverlapScene scene;
  AddBalls(scene, { true, false, false, false });
  OverlapScene swapped;
  AddBalls(swapped, { true, false, false, false }, { 5, 0 });
  for (const auto draw : { &OverlapScene::Draw, &OverlapScene::DrawByProcessor })
  {
    const std::vector<float> drawn = (scene.*draw)();
    const std::vector<float> other = (swapped.*draw)();
    // Rounding of floats differs because another grid is used.
    EXPECT_LT(CompareImages(drawn.data(), other.data(), drawn.size() / 4).largest, 0.1);
  }
}

namespace
{

// Two balls in a volume that is empty for several bricks around and between them.
vtkSmartPointer<vtkImageData> FarBalls(double y)
{
  return CenteredImage({ 64, 40, 40 }, { 18.0, 12.0, 12.0 },
    [y](glm::dvec3 voxel) {
      return std::max(BallField(voxel, { 16.0, y, 20.0 }), BallField(voxel, { 48.0, y, 20.0 }));
    });
}

}

class FieldsOfVolumes : public testing::TestWithParam<bool>
{
};

TEST_P(FieldsOfVolumes, LeaveOutWhatIsInvisibleInAllOfThem)
{
  OverlapScene scene;
  scene.mapper->GetVariationFieldMapper()->SetProcessorMarching(GetParam());
  scene.Add(0, FarBalls(16.0), ballLooks[0]);
  scene.Add(1, FarBalls(26.0), ballLooks[1])->RotateWXYZ(20.0, 0.0, 0.0, 1.0);
  vtkVariationFieldVolumeMapper* const mapper = scene.mapper->GetVariationFieldMapper();
  constexpr double grayLevels = 0.5;
  mapper->SetErrorTolerance(grayLevels / 255.0);
  const std::vector<float> drawn = scene.Draw();
  ASSERT_STREQ(scene.mapper->GetReasonForVtkMapper(), "");
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.5) << "the image is empty";
  mapper->SetAccelerationModeToOff();
  const std::vector<float> withoutField = scene.Draw();
  const ImageError difference = CompareImages(drawn.data(), withoutField.data(), drawn.size() / 4);
  EXPECT_LT(difference.percentile999, 2.0 * grayLevels);
  EXPECT_LT(difference.largest, 4.0 * grayLevels);
}

INSTANTIATE_TEST_SUITE_P(ByProcessorOrNot, FieldsOfVolumes, testing::Bool());

class ChangingVolumes : public testing::TestWithParam<bool>
{
};

TEST_P(ChangingVolumes, AreMadeAgainWhereOneOfThemHasChanged)
{
  OverlapScene scene;
  scene.mapper->GetVariationFieldMapper()->SetProcessorMarching(GetParam());
  const TwoBoxes boxes(scene);
  vtkVariationFieldVolumeMapper* const mapper = scene.mapper->GetVariationFieldMapper();
  mapper->SetErrorTolerance(1.0 / 64.0);
  std::vector<float> last = scene.Draw();
  int searches = mapper->GetToleranceSearches();
  EXPECT_EQ(scene.Draw(), last);
  EXPECT_EQ(mapper->GetToleranceSearches(), searches) << "nothing has changed";
  const std::function<void()> changes[] = {
    [&] { boxes.volumes[1]->RotateY(10.0); },
    [&] { SetLook(boxes.volumes[1]->GetProperty(), 0, red); },
    [&] {
      scene.mapper->SetInputDataObject(3, HomogeneousBox({ 5.0, 20.0, 3.0 }));
    },
  };
  for (const std::function<void()>& change : changes)
  {
    change();
    const std::vector<float> next = scene.Draw();
    EXPECT_NE(next, last);
    EXPECT_EQ(mapper->GetToleranceSearches(), searches + 1);
    searches = mapper->GetToleranceSearches();
    last = next;
  }
}

INSTANTIATE_TEST_SUITE_P(ByProcessorOrNot, ChangingVolumes, testing::Bool());

TEST(MultiVolume, UnsupportedSettingsAreLeftToVtksMapper)
{
  OverlapScene scene;
  const TwoBoxes boxes(scene);
  scene.Draw();
  scene.mapper->CroppingOn();
  scene.Draw();
  EXPECT_STREQ(
    scene.mapper->GetReasonForVtkMapper(), "Overlapping volumes cannot be drawn with cropping");
  scene.mapper->CroppingOff();
  scene.Draw();
  EXPECT_STREQ(scene.mapper->GetReasonForVtkMapper(), "");
}
