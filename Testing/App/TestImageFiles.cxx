// Images in files: formats by name, and DICOM images without data of the patient.
#include "Scene/Images/ImageFiles.h"

#include <vtkDICOMMetaData.h>
#include <vtkDICOMReader.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace varimarch;

namespace
{

constexpr int FileWidth = 7;
constexpr int FileHeight = 5;

/// The path of a file that is deleted at the end of the test.
class File
{
public:
  explicit File(const std::string& name)
    : path((std::filesystem::temp_directory_path() / ("varimarch-" + name)).string())
  {
  }
  ~File() { std::filesystem::remove(this->path); }

  const std::string path;
};

/// An image whose bytes all differ, with an odd number of them.
vtkSmartPointer<vtkImageData> Picture()
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(FileWidth, FileHeight, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* const bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (int i = 0; i < 3 * FileWidth * FileHeight; ++i)
  {
    bytes[i] = static_cast<unsigned char>(2 * i + 1);
  }
  return picture;
}

vtkSmartPointer<vtkDICOMReader> Read(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkDICOMReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader;
}

TEST(ImageFiles, AreWrittenInTheFormatOfTheirExtension)
{
  EXPECT_EQ(PictureFormatOf("a.b/head.PNG"), PictureFormat::Png);
  EXPECT_EQ(PictureFormatOf("head.dcm"), PictureFormat::Dicom);
  EXPECT_FALSE(PictureFormatOf("dcm"));
  EXPECT_THROW(WritePicture(Picture(), {}, "head.jpg"), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists("head.jpg"));
}

TEST(SecondaryCapture, KeepsThePixels)
{
  const File file("pixels.dcm");
  WritePicture(Picture(), {}, file.path);
  const auto reader = Read(file.path);
  vtkImageData* const read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfScalarComponents(), 3);
  ASSERT_EQ(read->GetScalarType(), VTK_UNSIGNED_CHAR);
  for (int y = 0; y < FileHeight; ++y)
  {
    for (int x = 0; x < FileWidth; ++x)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        EXPECT_EQ(read->GetScalarComponentAsDouble(x, y, 0, channel),
          Picture()->GetScalarComponentAsDouble(x, y, 0, channel));
      }
    }
  }
}

// PS3.3 A.8.1, and C.7.1.1 for the patient.
TEST(SecondaryCapture, HasTheAttributesOfItsKindAndNoneOfAPatient)
{
  const File file("attributes.dcm");
  PictureOrigin origin;
  origin.render.errorTolerance = 0.25;
  WritePicture(Picture(), origin, file.path);
  const auto reader = Read(file.path);
  vtkDICOMMetaData* const data = reader->GetMetaData();
  const auto text = [&](int group, int element)
  { return data->Get(vtkDICOMTag(group, element)).AsString(); };
  EXPECT_EQ(text(0x0002, 0x0010), "1.2.840.10008.1.2.1");
  EXPECT_EQ(text(0x0002, 0x0002), "1.2.840.10008.5.1.4.1.1.7");
  EXPECT_EQ(text(0x0008, 0x0016), "1.2.840.10008.5.1.4.1.1.7");
  EXPECT_EQ(text(0x0002, 0x0003), text(0x0008, 0x0018));
  EXPECT_EQ(text(0x0008, 0x0060), "OT");
  EXPECT_EQ(text(0x0008, 0x0064), "WSD");
  EXPECT_EQ(text(0x0012, 0x0062), "YES");
  EXPECT_EQ(text(0x0028, 0x0004), "RGB");
  EXPECT_EQ(text(0x0028, 0x0301), "NO");
  EXPECT_NE(text(0x0008, 0x2111).find("channel: 0.25 of full"), std::string::npos)
    << text(0x0008, 0x2111);
  for (const vtkDICOMTag& required : { vtkDICOMTag(0x0010, 0x0010), vtkDICOMTag(0x0010, 0x0020),
         vtkDICOMTag(0x0010, 0x0030), vtkDICOMTag(0x0010, 0x0040), vtkDICOMTag(0x0008, 0x0020),
         vtkDICOMTag(0x0008, 0x0030), vtkDICOMTag(0x0008, 0x0050), vtkDICOMTag(0x0008, 0x0090),
         vtkDICOMTag(0x0020, 0x0010), vtkDICOMTag(0x0020, 0x0020), vtkDICOMTag(0x0020, 0x0060) })
  {
    EXPECT_TRUE(data->Has(required)) << required;
    EXPECT_EQ(data->Get(required).AsString(), "") << required;
  }
}

TEST(SecondaryCapture, PromisesNoErrorOfCoarseVoxels)
{
  PictureOrigin ofCopy;
  ofCopy.render.errorTolerance = 0.25;
  ofCopy.isPreview = true;
  PictureOrigin ofLevel;
  ofLevel.render.errorTolerance = 0.25;
  ofLevel.render.level = VolumeLevel::Coarse;
  for (const PictureOrigin& origin : { ofCopy, ofLevel })
  {
    const File file("coarse.dcm");
    WritePicture(Picture(), origin, file.path);
    const std::string text =
      Read(file.path)->GetMetaData()->Get(vtkDICOMTag(0x0008, 0x2111)).AsString();
    EXPECT_NE(text.find("The error is not bounded"), std::string::npos) << text;
  }
}

// PS3.5 6.2: texts have even lengths by a space, UIDs by a zero.
TEST(SecondaryCapture, PadsUidsWithZeros)
{
  const File file("uids.dcm");
  WritePicture(Picture(), {}, file.path);
  std::ifstream stream(file.path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const std::string kind = "1.2.840.10008.5.1.4.1.1.7"; // 25 characters
  EXPECT_EQ(bytes.find(kind + ' '), std::string::npos);
  EXPECT_NE(bytes.find(kind + '\0'), std::string::npos);
}

TEST(SecondaryCapture, IsAStudyOfItsOwn)
{
  const File first("first.dcm");
  const File second("second.dcm");
  WritePicture(Picture(), {}, first.path);
  WritePicture(Picture(), {}, second.path);
  for (const vtkDICOMTag& uid :
    { vtkDICOMTag(0x0008, 0x0018), vtkDICOMTag(0x0020, 0x000d), vtkDICOMTag(0x0020, 0x000e) })
  {
    const std::string ofFirst = Read(first.path)->GetMetaData()->Get(uid).AsString();
    EXPECT_FALSE(ofFirst.empty());
    EXPECT_NE(ofFirst, Read(second.path)->GetMetaData()->Get(uid).AsString());
  }
}

}
