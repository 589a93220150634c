// A volume that was moved by a known motion is found again.

#include "Registration/RigidRegistration.h"
#include "Scene/Volumes/Placing.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace varimarch;

namespace
{

vtkSmartPointer<vtkImageData> Torso()
{
  return ProceduralVolume({ ProceduralKind::Torso, { 64, 56, 48 }, 1 });
}

// Values of another modality: neither the same nor a linear function of them.
vtkSmartPointer<vtkImageData> OtherModality(vtkImageData* image)
{
  auto other = vtkSmartPointer<vtkImageData>::New();
  other->DeepCopy(image);
  vtkDataArray* const values = other->GetPointData()->GetScalars();
  for (vtkIdType voxel = 0; voxel < values->GetNumberOfTuples(); ++voxel)
  {
    values->SetComponent(voxel, 0, 1000.0 - std::abs(values->GetComponent(voxel, 0)));
  }
  return other;
}

// The largest distance of the corners of a box of 100 mm from their places [mm].
double LargestErrorMm(const glm::dmat4& found, const glm::dmat4& true_)
{
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 point(
      corner & 1 ? 50.0 : -50.0, corner & 2 ? 50.0 : -50.0, corner & 4 ? 50.0 : -50.0, 1.0);
    largest = std::max(largest, glm::length(glm::dvec3(found * point - true_ * point)));
  }
  return largest;
}

}

// A voxel has 5 mm and more; half of one is what is asked for.
TEST(Registration, FindsAKnownMotionOfAnotherModality)
{
  const auto fixed = Torso();
  const Placement away = { { 4.0, -3.0, 8.0 }, { 12.0, -9.0, 6.0 } };
  const auto moving = Placed(OtherModality(fixed), away);
  double lastPart = 0.0;
  const Placement found = RegisteredPlacement(fixed, moving, {},
    [&](double part)
    {
      EXPECT_GE(part, lastPart);
      lastPart = part;
      return true;
    });
  EXPECT_GT(lastPart, 0.0);
  // The placement moves the volume back to where it was.
  const glm::dmat4 back = WorldFromPatient(found, moving) * WorldFromPatient(away, fixed);
  EXPECT_LT(LargestErrorMm(back, glm::dmat4(1.0)), 2.5);
}

TEST(Registration, BeginsWhereTheVolumeHasBeenPut)
{
  const auto fixed = Torso();
  const Placement far = { { 0.0, 0.0, 40.0 }, { 150.0, 0.0, 0.0 } };
  const auto moving = Placed(fixed, far);
  const glm::dmat4 nearlyBack = glm::inverse(WorldFromPatient(far, fixed));
  Placement start = PlacementOf(nearlyBack, moving);
  start.moveMm[1] += 8.0;
  const Placement found = RegisteredPlacement(fixed, moving, start);
  EXPECT_LT(LargestErrorMm(WorldFromPatient(found, moving), nearlyBack), 2.5);
}

TEST(Registration, StopsWhenTold)
{
  const auto fixed = Torso();
  EXPECT_THROW(
    RegisteredPlacement(fixed, fixed, {}, [](double) { return false; }), std::runtime_error);
}

TEST(Registration, SaysIfTheVolumesDoNotOverlap)
{
  const auto fixed = Torso();
  try
  {
    RegisteredPlacement(fixed, fixed, { {}, { 5000.0, 0.0, 0.0 } });
    FAIL() << "found a place";
  }
  catch (const std::runtime_error& problem)
  {
    EXPECT_NE(std::string(problem.what()).find("expected volumes that overlap"), std::string::npos)
      << problem.what();
  }
}
