// Means of voxels that stand for a volume in its file while somebody interacts, and the bound of
// their error.

#include "Module/Paging/TorsoOnDisk.h"

#include <vtkDataSetAttributes.h>
#include <vtkHardwareSelector.h>
#include <vtkIdTypeArray.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

class CoarseLevels : public TorsoOnDisk
{
};

std::vector<vtkIdType> SelectedPoints(MapperScene& scene)
{
  scene.DrawByProcessor();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  selector->SetArea(0, 0, unsigned(scene.size - 1), unsigned(scene.size - 1));
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  auto* const ids = selection->GetNumberOfNodes() == 1
    ? vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList())
    : nullptr;
  return ids ? std::vector<vtkIdType>(ids->Begin(), ids->End()) : std::vector<vtkIdType>();
}

}

// Half a percent is for steps and floats.
TEST_F(CoarseLevels, LookByTheirCoarseLevelAsItsBoundSays)
{
  MapperScene scene(this->ReadTorso(this->WriteTorso()));
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(-1100.0, 0.0);
  scene.opacities->AddPoint(2000.0, 0.004);
  scene.mapper->SetErrorTolerance(1.0 / 1024.0);
  const std::vector<float> voxels = scene.DrawByProcessor();
  EXPECT_EQ(scene.mapper->GetLevelErrorBound(), 0.0);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::CoarseLevel);
  const std::vector<float> coarse = scene.DrawByProcessor();
  const double bound = scene.mapper->GetLevelErrorBound();
  double largest = 0.0;
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    largest = std::max(largest, std::abs(double(coarse[i]) - voxels[i]));
  }
  EXPECT_GT(largest, 0.02) << "the level is not seen";
  EXPECT_LE(largest, bound + 0.005);
  EXPECT_LT(bound, 0.9) << "the bound says nothing";
}

TEST_F(CoarseLevels, HaveTheBoundOfTheLastImageAfterAChange)
{
  MapperScene scene(this->ReadTorso(this->WriteTorso()));
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::CoarseLevel);
  scene.DrawByProcessor();
  const double bound = scene.mapper->GetLevelErrorBound();
  EXPECT_GT(bound, 0.0);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  EXPECT_EQ(scene.mapper->GetLevelErrorBound(), bound);
  scene.DrawByProcessor();
  EXPECT_EQ(scene.mapper->GetLevelErrorBound(), 0.0) << "nothing is seen";
}

TEST_F(CoarseLevels, TellOfTheLevelThatWasDrawnLast)
{
  MapperScene scene(this->ReadTorso(this->WriteTorso()));
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistanceInVoxels(1.0);
  scene.mapper->RenderToImageOn();
  scene.Draw();
  const double distanceMm = scene.mapper->GetUsedSampleDistance();
  const vtkIdType bytes = scene.mapper->GetGraphicsMemoryBytes();
  vtkNew<vtkImageData> voxels;
  scene.mapper->GetColorImage(voxels);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::CoarseLevel);
  scene.Draw();
  EXPECT_NEAR(scene.mapper->GetUsedSampleDistance(), 4.0 * distanceMm, 1e-9);
  EXPECT_GT(scene.mapper->GetGraphicsMemoryBytes(), bytes) << "both levels are kept";
  vtkNew<vtkImageData> coarse;
  scene.mapper->GetColorImage(coarse);
  ASSERT_EQ(coarse->GetNumberOfPoints(), voxels->GetNumberOfPoints());
  const auto* const one = static_cast<const unsigned char*>(voxels->GetScalarPointer());
  const auto* const other = static_cast<const unsigned char*>(coarse->GetScalarPointer());
  EXPECT_FALSE(std::equal(one, one + 4 * voxels->GetNumberOfPoints(), other));
}

TEST_F(CoarseLevels, HaveNoCoarseLevelIfSomeAreBlanked)
{
  vtkImageData* const image = this->ReadTorso(this->WriteTorso());
  image->AllocatePointGhostArray();
  image->GetPointGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  MapperScene scene(image);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::CoarseLevel);
  scene.DrawByProcessor();
  EXPECT_EQ(scene.mapper->GetLevelErrorBound(), 0.0) << "the level does not know which";
}

TEST_F(CoarseLevels, AreSelectedByTheirOwnNumbersInAnyLevel)
{
  MapperScene scene(this->ReadTorso(this->WriteTorso()));
  const std::vector<vtkIdType> voxels = SelectedPoints(scene);
  EXPECT_GT(voxels.size(), 100u);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::CoarseLevel);
  EXPECT_EQ(SelectedPoints(scene), voxels);
}

TEST_F(CoarseLevels, HaveNoBoundWhereMoreThanTheirValuesDecides)
{
  MapperScene scene(this->ReadTorso(this->WriteTorso()));
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::CoarseLevel);
  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.DrawByProcessor();
  EXPECT_EQ(scene.mapper->GetLevelErrorBound(), 1.0);
}
