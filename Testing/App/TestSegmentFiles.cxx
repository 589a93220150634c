// Segments are read back as they were written, on the grid of the scan.

#include "Module/Files/PhantomFiles.h"
#include "Scene/Segments/LabelMap.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

using namespace varimarch;

namespace
{

class SegmentFiles : public testing::Test
{
protected:
  SegmentFiles()
  {
    this->scan.image = ProceduralVolume({ ProceduralKind::Torso, { 12, 10, 8 }, 1 });
    this->scan.image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
    this->scan.image->SetOrigin(-30.0, 12.5, 7.0);
    LoadedVolume values;
    values.image = vtkSmartPointer<vtkImageData>::New();
    values.image->CopyStructure(this->scan.image);
    values.image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* const value = static_cast<unsigned char*>(values.image->GetScalarPointer());
    for (int i = 0; i < 12 * 10 * 8; ++i)
    {
      value[i] = i % 7 == 0 ? 4 : i % 11 == 0 ? 9 : 0;
    }
    this->labels = LabelMapOf(values, "made here", this->scan);
    this->segments = { { 4, "left kidney", { 0.25, 0.5, 1.0 } }, { 9, "cyst", { 1.0, 0.0, 0.0 } } };
  }

  LabelMap Back(const std::string& name)
  {
    WriteSegments(this->labels, this->segments, { ProceduralSource() }, this->folder.Path(name));
    return LoadLabels({ this->folder.Path(name) }, this->scan);
  }

  void ExpectSameVoxels(const LabelMap& back)
  {
    ASSERT_EQ(back.segments.size(), 2u);
    EXPECT_EQ(back.segments[1].value, 9);
    EXPECT_TRUE(back.warnings.empty());
    const auto* const a = static_cast<unsigned char*>(this->labels.image->GetScalarPointer());
    const auto* const b = static_cast<unsigned char*>(back.image->GetScalarPointer());
    EXPECT_TRUE(std::equal(a, a + 12 * 10 * 8, b));
  }

  TemporaryFolder folder;
  LoadedVolume scan;
  LabelMap labels;
  std::vector<Segment> segments;
};

}

TEST_F(SegmentFiles, OfSlicerHaveNamesAndColours)
{
  const LabelMap back = this->Back("organs.seg.nrrd");
  this->ExpectSameVoxels(back);
  EXPECT_EQ(back.segments[0].name, "left kidney");
  EXPECT_EQ(back.segments[0].rgb, glm::dvec3(0.25, 0.5, 1.0));
}

TEST_F(SegmentFiles, OfNiftiHaveTheirPlaces)
{
  this->ExpectSameVoxels(this->Back("organs.nii.gz"));
  this->ExpectSameVoxels(this->Back("organs.nii"));
}

TEST_F(SegmentFiles, KeepValuesOfMoreThanAByte)
{
  this->segments[0].value = 70000;
  this->segments[1].value = 9;
  const LabelMap back = this->Back("large.seg.nrrd");
  EXPECT_EQ(back.segments[0].value, 70000);
  this->ExpectSameVoxels(back);
}

TEST_F(SegmentFiles, NeverReplaceAFileInTheFolderOfAScan)
{
  std::filesystem::create_directories(this->folder.Path("ct/1"));
  this->folder.Write("ct/1/slice.dcm", "a slice");
  const VolumeSource scan = FileSource{ this->folder.Path("ct"), std::nullopt };
  EXPECT_THROW(RequireNoFileOf({ ProceduralSource(), scan }, this->folder.Path("ct/1/slice.dcm")),
    std::runtime_error);
  EXPECT_NO_THROW(RequireNoFileOf({ scan }, this->folder.Path("ct/1/segments.dcm")));
  this->folder.Write("ct2.dcm", "another file");
  EXPECT_NO_THROW(RequireNoFileOf({ scan }, this->folder.Path("ct2.dcm")));
}

TEST_F(SegmentFiles, NeverReplaceAScan)
{
  const std::string path = this->folder.Path("scan.nii");
  this->folder.Write("scan.nii", "the scan");
  const VolumeSource scan = FileSource{ path, std::nullopt };
  EXPECT_THROW(WriteSegments(this->labels, this->segments, { scan }, path), std::runtime_error);
  EXPECT_THROW(WriteSegments(this->labels, this->segments, { ProceduralSource(), scan }, path),
    std::runtime_error);
  EXPECT_EQ(std::filesystem::file_size(path), 8u);
  EXPECT_THROW(WriteSegments(this->labels, this->segments, { scan }, this->folder.Path("a.png")),
    std::runtime_error);
}
