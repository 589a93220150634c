// Looks in Hounsfield units on volumes that have none: the values that stand for them are found in
// the histogram.

#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageShiftScale.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

vtkSmartPointer<vtkImageData> Torso()
{
  return ProceduralVolume({ ProceduralKind::Torso, { 64, 64, 64 }, 1 });
}

/// The torso in 8 bits, in which a window of Hounsfield units is 0 to 255.
vtkSmartPointer<vtkImageData> TorsoOfBytes(double first, double last)
{
  vtkNew<vtkImageShiftScale> scaling;
  scaling->SetInputData(Torso());
  scaling->SetShift(-first);
  scaling->SetScale(255.0 / (last - first));
  scaling->ClampOverflowOn();
  scaling->SetOutputScalarTypeToUnsignedChar();
  scaling->Update();
  return scaling->GetOutput();
}

}

TEST(HounsfieldScale, FindsAirSoftTissueAndBoneInBytes)
{
  for (const auto& [first, last] : { std::pair(-1024.0, 3071.0), { -1000.0, 1500.0 } })
  {
    const auto scale = EstimatedHounsfieldScale(ImageStatistics(TorsoOfBytes(first, last)));
    ASSERT_TRUE(scale);
    const double step = (last - first) / 255.0;
    const auto hounsfieldAt = [&, first = first](double hounsfield)
    { return scale->ValueAt(hounsfield) * step + first; };
    EXPECT_NEAR(hounsfieldAt(-1000.0), -1000.0, 1.5 * step);
    EXPECT_NEAR(hounsfieldAt(40.0), 40.0, 60.0);
    // Bone differs between patients, and looks are meant for any of it.
    EXPECT_GT(hounsfieldAt(300.0), 100.0);
    EXPECT_LT(hounsfieldAt(300.0), 450.0);
  }
}

TEST(HounsfieldScale, TakesWhatAWindowCutOffForBone)
{
  const auto scale = EstimatedHounsfieldScale(ImageStatistics(TorsoOfBytes(-160.0, 240.0)));
  ASSERT_TRUE(scale);
  EXPECT_NEAR(scale->ValueAt(300.0), 255.0, 1.0);
}

TEST(HounsfieldScale, IsNotFoundWhereNothingIsLikeBone)
{
  vtkNew<vtkImageData> even;
  even->SetDimensions(16, 16, 16);
  even->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  vtkDataArray* const values = even->GetPointData()->GetScalars();
  values->Fill(7.0);
  EXPECT_FALSE(EstimatedHounsfieldScale(ImageStatistics(even)));
  // Half of it is air, and all of the rest the same.
  for (vtkIdType i = 0; i < values->GetNumberOfTuples() / 2; ++i)
  {
    values->SetComponent(i, 0, 200.0);
  }
  EXPECT_FALSE(EstimatedHounsfieldScale(ImageStatistics(even)));
  LoadedVolume volume = { even.Get(), "", {} };
  volume.modality = "CT";
  EXPECT_EQ(SuggestedPreset(volume, ImageStatistics(even)).name, "mr-maximum");
}

TEST(HounsfieldScale, LeavesHounsfieldUnitsAsTheyAre)
{
  const Look bone = BuiltInPreset("ct-bone").look;
  ASSERT_EQ(bone.domain, Domain::Hounsfield);
  for (const Look& look :
    { InUnitsOfData(bone, Torso()), InUnitsOfData(bone, ImageStatistics(Torso())) })
  {
    EXPECT_EQ(look.domain, Domain::Data);
    EXPECT_EQ(look.opacities.back().value, bone.opacities.back().value);
  }
}

TEST(HounsfieldScale, SpreadsLooksOverBytes)
{
  const auto bytes = TorsoOfBytes(-1024.0, 3071.0);
  const Look look = InUnitsOfData(BuiltInPreset("ct-bone").look, bytes);
  const ImageStatistics statistics(bytes);
  EXPECT_EQ(look.domain, Domain::Data);
  // The skeleton is a few percent of the torso; its surface begins at the first opacity.
  EXPECT_GT(look.opacities.front().value, statistics.Percentile(85.0));
  EXPECT_LT(look.opacities[1].value, statistics.Percentile(99.9));
}
