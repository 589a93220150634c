#include "Scene/Volumes/Placing.h"

#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

vtkSmartPointer<vtkImageData> TurnedBox()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(11, 21, 31);
  image->SetSpacing(1.0, 2.0, 0.5);
  image->SetOrigin(-4.0, 7.0, 100.0);
  image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  return image;
}

}

TEST(Placing, TurnsAboutTheMiddleThenMoves)
{
  const auto image = TurnedBox();
  double middle[3];
  image->GetCenter(middle);
  const glm::dmat4 motion = WorldFromPatient({ { 0.0, 0.0, 90.0 }, { 5.0, 6.0, 7.0 } }, image);
  // A quarter turn about z takes x to y.
  const glm::dvec4 moved = motion * glm::dvec4(middle[0] + 10.0, middle[1], middle[2], 1.0);
  EXPECT_NEAR(moved.x, middle[0] + 5.0, 1e-9);
  EXPECT_NEAR(moved.y, middle[1] + 16.0, 1e-9);
  EXPECT_NEAR(moved.z, middle[2] + 7.0, 1e-9);
}

TEST(Placing, IsFoundAgainFromItsMotion)
{
  const auto image = TurnedBox();
  const Placement placement = { { 20.0, -35.0, 50.0 }, { 1.0, -2.0, 3.0 } };
  const Placement found = PlacementOf(WorldFromPatient(placement, image), image);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(found.turnDegrees[axis], placement.turnDegrees[axis], 1e-9) << axis;
    EXPECT_NEAR(found.moveMm[axis], placement.moveMm[axis], 1e-9) << axis;
  }
}

TEST(Placing, TakesMeasurementsBackToTheCoordinatesOfThePatient)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(11, 11, 11);
  Placement placement;
  placement.turnDegrees = { 0.0, 0.0, 90.0 };
  placement.moveMm = { 1.0, 2.0, 3.0 };
  Measure measure;
  // The middle is at 5; the turn takes the end of x, at 10, to the end of y.
  measure.pointsMm = { { 6.0, 12.0, 8.0 } };
  const std::vector<Measure> own = InPatientCoordinates({ measure }, placement, image);
  EXPECT_NEAR(own[0].pointsMm[0][0], 10.0, 1e-9);
  EXPECT_NEAR(own[0].pointsMm[0][1], 5.0, 1e-9);
  EXPECT_NEAR(own[0].pointsMm[0][2], 5.0, 1e-9);
  EXPECT_FALSE(AreTurnedAlike(image, Placed(image, placement)));
  placement.turnDegrees = {};
  EXPECT_TRUE(AreTurnedAlike(image, Placed(image, placement)));
}

TEST(Placing, PutsEveryVoxelWhereItsMotionSays)
{
  const auto image = TurnedBox();
  const Placement placement = { { 20.0, -35.0, 50.0 }, { 1.0, -2.0, 3.0 } };
  const auto placed = Placed(image, placement);
  EXPECT_EQ(placed->GetScalarPointer(), image->GetScalarPointer());
  const glm::dmat4 motion = WorldFromPatient(placement, image);
  double voxel[3] = { 3.0, 17.0, 29.0 };
  glm::dvec3 before;
  glm::dvec3 after;
  image->TransformContinuousIndexToPhysicalPoint(voxel, &before.x);
  placed->TransformContinuousIndexToPhysicalPoint(voxel, &after.x);
  const glm::dvec3 expected(motion * glm::dvec4(before, 1.0));
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(after[axis], expected[axis], 1e-9) << axis;
  }
}

TEST(Overlaying, ComparesFramesOfReference)
{
  LoadedVolume first;
  LoadedVolume other;
  EXPECT_EQ(SpaceOf(first, other), CommonSpace::Unknown);
  first.frameOfReference = "1.2.3";
  EXPECT_EQ(SpaceOf(first, other), CommonSpace::Unknown);
  other.frameOfReference = "1.2.4";
  EXPECT_EQ(SpaceOf(first, other), CommonSpace::Different);
  other.frameOfReference = "1.2.3";
  EXPECT_EQ(SpaceOf(first, other), CommonSpace::Same);
}

// Projections such as the usual look of PET cannot be marched with other volumes.
TEST(Overlaying, LooksOverAnotherVolumeAreComposites)
{
  LoadedVolume volume;
  volume.image = ProceduralVolume({ ProceduralKind::Shells, { 16, 16, 16 }, 1 });
  for (const std::string modality : { "PT", "CT", "MR", "NM" })
  {
    volume.modality = modality;
    const OverlaidVolume overlay =
      OverlayOf(FileSource{ "/data/scan", std::nullopt }, volume, ImageStatistics(volume.image));
    EXPECT_EQ(overlay.look.blend, Blend::Composite) << modality;
    EXPECT_EQ(overlay.look.domain, Domain::Data) << modality;
    EXPECT_EQ(overlay.name, modality + " scan");
    EXPECT_EQ(overlay.sliceColors, modality == "PT" ? SliceColors::Hot : SliceColors::Gray);
  }
}
