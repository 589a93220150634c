#include "Scene/Model/SceneCamera.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace varimarch;

namespace
{

using Vector = std::array<double, 3>;

constexpr double Bounds[6] = { -90.0, 110.0, -70.0, 90.0, 20.0, 260.0 };
constexpr Vector L = { 1, 0, 0 };
constexpr Vector R = { -1, 0, 0 };
constexpr Vector P = { 0, 1, 0 };
constexpr Vector A = { 0, -1, 0 };
constexpr Vector S = { 0, 0, 1 };
constexpr Vector I = { 0, 0, -1 };

// A direction of the patient in view coordinates: right, up, towards the eye.
Vector InPicture(vtkCamera* camera, const Vector& directionWorld)
{
  double direction[4] = { directionWorld[0], directionWorld[1], directionWorld[2], 0.0 };
  camera->GetViewTransformMatrix()->MultiplyPoint(direction, direction);
  return { direction[0], direction[1], direction[2] };
}

void ExpectNear(const Vector& found, const Vector& expected)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-9) << "component " << i;
  }
}

struct ViewCase
{
  View view;
  Vector right;
  Vector up;
  Vector towardsEye;
};

TEST(SceneCamera, LooksAtTheFaceOfAThinStackUnlessItIsToldOtherwise)
{
  const auto looksAlong = [](View view, std::array<double, 3> sides)
  {
    const double bounds[6] = { 0.0, sides[0], 0.0, sides[1], 0.0, sides[2] };
    Camera placement;
    placement.view = view;
    vtkNew<vtkCamera> camera;
    PlaceCamera(placement, bounds, 1.0, camera);
    const double* direction = camera->GetDirectionOfProjection();
    return int(std::max_element(direction, direction + 3,
                 [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      direction);
  };
  EXPECT_EQ(Camera().view, View::Automatic);
  EXPECT_EQ(looksAlong(View::Automatic, { 350.0, 350.0, 9.0 }), 2);
  EXPECT_EQ(looksAlong(View::Automatic, { 9.0, 350.0, 350.0 }), 0);
  EXPECT_EQ(looksAlong(View::Automatic, { 350.0, 9.0, 350.0 }), 1);
  EXPECT_EQ(looksAlong(View::Automatic, { 240.0, 240.0, 40.0 }), 1) << "not so thin";
  EXPECT_EQ(looksAlong(View::Automatic, { 400.0, 5.0, 5.0 }), 1) << "a rod has no face";
  EXPECT_EQ(looksAlong(View::Anterior, { 350.0, 350.0, 9.0 }), 1);
}

class PatientView : public testing::TestWithParam<ViewCase>
{
};

TEST_P(PatientView, PutsThePatientWhereRadiologistsExpect)
{
  Camera placement;
  placement.view = GetParam().view;
  vtkNew<vtkCamera> camera;
  PlaceCamera(placement, Bounds, 1.0, camera);
  ExpectNear(InPicture(camera, GetParam().right), { 1, 0, 0 });
  ExpectNear(InPicture(camera, GetParam().up), { 0, 1, 0 });
  ExpectNear(InPicture(camera, GetParam().towardsEye), { 0, 0, 1 });
}

INSTANTIATE_TEST_SUITE_P(Views, PatientView,
  testing::Values(ViewCase{ View::Anterior, L, S, A }, ViewCase{ View::Posterior, R, S, P },
    ViewCase{ View::Left, P, S, L }, ViewCase{ View::Right, A, S, R },
    ViewCase{ View::Superior, R, A, S }, ViewCase{ View::Inferior, L, A, I }));

// The largest |x| or |y| of the box's corners in the image, where 1 is the edge.
double LargestCornerOffset(vtkCamera* camera, double aspect)
{
  vtkMatrix4x4* clipFromWorld = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { Bounds[corner & 1], Bounds[2 + (corner >> 1 & 1)],
      Bounds[4 + (corner >> 2 & 1)], 1.0 };
    clipFromWorld->MultiplyPoint(point, point);
    largest = std::max({ largest, std::abs(point[0] / point[3]), std::abs(point[1] / point[3]) });
  }
  return largest;
}

TEST(PlaceCamera, TheBoxJustFitsFromEverySide)
{
  for (const bool parallel : { false, true })
  {
    for (const double aspect : { 0.5, 1.0, 2.0 })
    {
      for (const double azimuth : { 0.0, 30.0, 135.0 })
      {
        Camera placement;
        placement.azimuthDegrees = azimuth;
        placement.elevationDegrees = 25.0;
        placement.parallel = parallel;
        vtkNew<vtkCamera> camera;
        PlaceCamera(placement, Bounds, aspect, camera);
        EXPECT_NEAR(LargestCornerOffset(camera, aspect), 1.0, 1e-6)
          << parallel << " " << aspect << " " << azimuth;
      }
    }
  }
}

TEST(PlaceCamera, AzimuthTurnsTheEyeToThePatientsLeft)
{
  Camera placement;
  placement.azimuthDegrees = 90.0;
  vtkNew<vtkCamera> camera;
  PlaceCamera(placement, Bounds, 1.0, camera);
  ExpectNear(InPicture(camera, L), { 0, 0, 1 });
}

TEST(PlaceCamera, ElevationLiftsTheEye)
{
  Camera placement;
  placement.elevationDegrees = 45.0;
  vtkNew<vtkCamera> camera;
  PlaceCamera(placement, Bounds, 1.0, camera);
  EXPECT_NEAR(InPicture(camera, S)[2], std::sqrt(0.5), 1e-9);
}

TEST(PlaceCamera, ZoomEnlarges)
{
  Camera placement;
  placement.parallel = true;
  placement.zoom = 2.0;
  vtkNew<vtkCamera> camera;
  PlaceCamera(placement, Bounds, 1.0, camera);
  EXPECT_NEAR(LargestCornerOffset(camera, 1.0), 2.0, 1e-6);
}

// Height of the image at the focal point, for both projections.
double HeightAtFocus(const Camera& placement)
{
  vtkNew<vtkCamera> camera;
  PlaceCamera(placement, Bounds, 1.0, camera);
  return placement.parallel
    ? 2.0 * camera->GetParallelScale()
    : 2.0 * camera->GetDistance() * std::tan(0.5 * glm::radians(camera->GetViewAngle()));
}

TEST(WithProjection, KeepsTheSizeAtTheFocalPoint)
{
  Camera placement;
  placement.pose =
    CameraPose{ { 10.0, -300.0, 20.0 }, { 10.0, 0.0, 20.0 }, { 0.0, 0.0, 1.0 }, 7.0 };
  const Camera parallel = WithProjection(placement, true);
  EXPECT_TRUE(parallel.parallel);
  EXPECT_NEAR(HeightAtFocus(parallel), HeightAtFocus(placement), 1e-9);
  Camera nearer = parallel;
  nearer.pose->parallelScaleMm *= 0.5;
  const Camera back = WithProjection(nearer, false);
  EXPECT_NEAR(HeightAtFocus(back), HeightAtFocus(nearer), 1e-9);
  EXPECT_EQ(back.pose->focalPointMm, placement.pose->focalPointMm);
  EXPECT_NEAR(back.pose->positionMm[1], -150.0, 1e-9);
}

}
