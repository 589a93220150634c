// Segmentations of 3D Slicer, and label maps of NIfTI. Right values are those that 3D Slicer's
// documentation of the format and the standard of NIfTI give.
#include "PhantomFiles.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <cstring>

namespace
{

class NrrdSegments : public testing::Test
{
protected:
  /// Reads bytes of a file of 2 x 2 x 1 voxels, and returns the values.
  std::vector<int> Read(
    const std::string& pairs, const std::string& axes, const std::vector<int>& bytes)
  {
    const std::string header = "NRRD0004\ntype: unsigned char\nencoding: raw\nspace: "
                               "left-posterior-superior\nspace origin: (1,2,3)\n" +
      axes + pairs + "\n";
    this->reader->SetFileName(
      this->folder.Write("a.seg.nrrd", header + std::string(bytes.begin(), bytes.end())).c_str());
    this->reader->Update();
    vtkDataArray* const scalars = this->reader->GetOutput()->GetPointData()->GetScalars();
    std::vector<int> values;
    for (vtkIdType i = 0; scalars && i < scalars->GetNumberOfValues(); ++i)
    {
      values.push_back(scalars->GetVariantValue(i).ToInt());
    }
    return values;
  }

  const std::string plain = "dimension: 3\nsizes: 2 2 1\nkinds: domain domain domain\n"
                            "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
  const std::string twoLayers = "dimension: 4\nsizes: 2 2 2 1\nkinds: list domain domain domain\n"
                                "space directions: none (1,0,0) (0,1,0) (0,0,1)\n";
  TemporaryFolder folder;
  vtkNew<vtkVolumeFileReader> reader;
};

}

TEST_F(NrrdSegments, HaveTheirNamesColoursAndLabels)
{
  const std::vector<int> values =
    this->Read("Segment0_ID:=Segment_1\nSegment0_Name:=left kidney\nSegment0_Color:=0.5 0.25 1\n"
               "Segment0_LabelValue:=3\nSegment0_Layer:=0\nSegment0_Extent:=0 1 0 0 0 0\n"
               "Segment1_ID:=Segment_2\nSegment1_LabelValue:=5\nSegment1_Layer:=0\n"
               "Segmentation_MasterRepresentation:=Binary labelmap\n",
      this->plain, { 3, 5, 0, 3 });
  EXPECT_EQ(values, (std::vector<int>{ 3, 5, 0, 3 })) << this->reader->GetErrorMessage();
  ASSERT_TRUE(this->reader->HoldsLabels());
  const auto segments = this->reader->GetSegments();
  ASSERT_EQ(segments.size(), 2);
  EXPECT_EQ(segments[0].Value, 3);
  EXPECT_EQ(segments[0].Name, "left kidney");
  ASSERT_TRUE(segments[0].HasColor);
  EXPECT_EQ(segments[0].Color[1], 0.25);
  EXPECT_EQ(segments[1].Value, 5);
  EXPECT_FALSE(segments[1].HasColor);
}

TEST_F(NrrdSegments, InLayersAreNumberedInTheirOrder)
{
  // Label 1 means another segment in each layer. The second segment covers the first.
  const std::vector<int> values =
    this->Read("Segment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
               "Segment1_Name:=tumour\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n"
               "Segment2_Name:=spleen\nSegment2_LabelValue:=2\nSegment2_Layer:=0\n",
      this->twoLayers, { 1, 0, 1, 1, 2, 1, 0, 0 });
  EXPECT_EQ(values, (std::vector<int>{ 1, 2, 3, 0 })) << this->reader->GetErrorMessage();
  EXPECT_EQ(this->reader->GetSegments()[2].Value, 3);
  ASSERT_EQ(this->reader->GetWarnings()->GetNumberOfValues(), 1);
  const std::string warning = this->reader->GetWarnings()->GetValue(0);
  EXPECT_NE(warning.find("\"tumour\" over \"liver\" (1 voxel)"), std::string::npos) << warning;
  EXPECT_NE(warning.find("\"spleen\" over \"tumour\" (1 voxel)"), std::string::npos) << warning;
}

TEST_F(NrrdSegments, OfOldFilesHaveALayerEach)
{
  const std::vector<int> values = this->Read(
    "Segment0_Name:=liver\nSegment1_Name:=spleen\n", this->twoLayers, { 1, 0, 0, 1, 0, 0, 1, 0 });
  EXPECT_EQ(values, (std::vector<int>{ 1, 2, 0, 1 })) << this->reader->GetErrorMessage();
}

TEST_F(NrrdSegments, InLayersOneAfterAnotherAreReadToo)
{
  const std::vector<int> values = this->Read("Segment0_Name:=liver\nSegment1_Name:=spleen\n",
    "dimension: 4\nsizes: 2 2 1 2\nkinds: domain domain domain list\n"
    "space directions: (1,0,0) (0,1,0) (0,0,1) none\n",
    { 1, 0, 0, 1, 0, 1, 0, 0 });
  EXPECT_EQ(values, (std::vector<int>{ 1, 2, 0, 1 })) << this->reader->GetErrorMessage();
}

TEST_F(NrrdSegments, OfAMissingLayerAreRefused)
{
  const ExpectedVtkErrors errors;
  this->Read(
    "Segment0_LabelValue:=1\nSegment0_Layer:=2\n", this->twoLayers, { 1, 0, 1, 1, 2, 1, 0, 0 });
  const std::string message = this->reader->GetErrorMessage();
  EXPECT_NE(
    message.find("Segment0 in one of 2 layers, counted from 0, found layer 2"), std::string::npos)
    << message;
}

TEST(NiftiLabels, AreKnownByTheirIntent)
{
  const TemporaryFolder folder;
  std::string bytes = NiftiBytes(phantom::Stored(0));
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Write("plain.nii", bytes).c_str());
  reader->Update();
  EXPECT_FALSE(reader->HoldsLabels());
  const std::int16_t labelIntent = 1002;
  std::memcpy(bytes.data() + 68, &labelIntent, sizeof labelIntent); // offset of intent_code
  reader->SetFileName(folder.Write("labels.nii", bytes).c_str());
  reader->Update();
  EXPECT_TRUE(reader->HoldsLabels());
  EXPECT_TRUE(reader->GetSegments().empty());
}
