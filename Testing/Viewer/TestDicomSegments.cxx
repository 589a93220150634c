// Segments written as DICOM: our reader and pydicom find the same segments of the same patient.

#include "DicomSegments/DicomSegments.h"
#include "ScanOfPatient.h"

#include <vtkImageData.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace varimarch;

namespace
{

class DicomSegments : public testing::Test
{
protected:
  DicomSegments()
  {
    this->images = WriteScanOfPatient(this->folder);
    this->scan = LoadVolume(FileSource{ this->folder.Path(""), std::nullopt });
    this->labels.image = vtkSmartPointer<vtkImageData>::New();
    this->labels.image->CopyStructure(this->scan.image);
    this->labels.image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int voxel = 0; voxel < 5 * 4 * 3; ++voxel)
    {
      // The third segment is empty, and the last slice.
      this->Numbers()[voxel] = voxel >= 40 ? 0 : voxel % 7 == 0 ? 1 : voxel == 25 ? 2 : 0;
    }
  }

  unsigned char* Numbers()
  {
    return static_cast<unsigned char*>(this->labels.image->GetScalarPointer());
  }

  std::string Write(const std::string& name)
  {
    WriteDicomSegments(this->labels, this->segments, this->images, this->folder.Path(name));
    return this->folder.Path(name);
  }

  std::string FailureOf(const std::string& name)
  {
    try
    {
      this->Write(name);
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder;
  std::vector<std::string> images;
  LoadedVolume scan;
  LabelMap labels;
  std::vector<Segment> segments = { { 40, "left kidney", { 1.0, 0.0, 0.0 } },
    { 7, "Gef\xc3\xa4\xc3\x9f", { 0.25, 0.5, 1.0 } }, { 3, "", { 0.0, 1.0, 0.0 } } };
};

}

TEST_F(DicomSegments, AreReadBack)
{
  const std::string path = this->Write("kidney.dcm");
  const LabelMap back = LoadLabels({ path }, this->scan);
  EXPECT_TRUE(back.warnings.empty()) << back.warnings.front();
  ASSERT_GE(back.segments.size(), 2u);
  EXPECT_EQ(back.segments[0].value, 1);
  EXPECT_EQ(back.segments[0].name, "left kidney");
  EXPECT_NEAR(back.segments[0].rgb.r, 1.0, 0.01);
  EXPECT_NEAR(back.segments[0].rgb.g, 0.0, 0.01);
  EXPECT_EQ(back.segments[1].name, "Gef\xc3\xa4\xc3\x9f");
  EXPECT_NEAR(back.segments[1].rgb.b, 1.0, 0.01);
  const auto* const numbers = static_cast<unsigned char*>(back.image->GetScalarPointer());
  EXPECT_TRUE(std::equal(numbers, numbers + 5 * 4 * 3, this->Numbers()));
}

TEST_F(DicomSegments, AreThoseOfThePatientForOtherPrograms)
{
  const std::string path = this->Write("kidney.dcm");
  QProcess python;
  python.start(
    VARIMARCH_TEST_PYTHON, { "-B", VARIMARCH_READ_SEGMENTS, QString::fromStdString(path) });
  ASSERT_TRUE(python.waitForFinished(60000));
  const QByteArray errors = python.readAllStandardError();
  if (errors.contains("No module named 'pydicom'"))
  {
    GTEST_SKIP() << "pydicom is not installed";
  }
  ASSERT_EQ(python.exitCode(), 0) << errors.toStdString();
  const QJsonObject found = QJsonDocument::fromJson(python.readAllStandardOutput()).object();
  EXPECT_EQ(found["class"].toString(), "Segmentation Storage");
  EXPECT_EQ(found["patient"].toString(), QString::fromUtf8("M\xc3\xbcller^Ute"));
  EXPECT_EQ(found["study"].toString(), "1.2.77");
  EXPECT_EQ(found["frame of reference"].toString(), "1.2.52");
  EXPECT_EQ(found["images"].toInt(), 3);
  EXPECT_EQ(found["labels"].toArray(),
    (QJsonArray{ "left kidney", QString::fromUtf8("Gef\xc3\xa4\xc3\x9f"), "Label 3" }));
  EXPECT_EQ(found["segments"].toArray(), (QJsonArray{ 1, 1, 2 })) << "no frame is empty";
  EXPECT_EQ(found["voxels"].toArray(), (QJsonArray{ 3, 3, 1 }));
  std::array<double, 3> second;
  this->labels.image->TransformIndexToPhysicalPoint(0, 0, 1, second.data());
  EXPECT_NEAR(found["z"].toArray()[2].toDouble(), second[2], 1e-6);
}

// dciodvfy of dicom3tools knows the modules of the standard and their conditions.
TEST_F(DicomSegments, AreAsTheStandardHasThem)
{
  const QString checker = QStandardPaths::findExecutable("dciodvfy");
  if (checker.isEmpty())
  {
    GTEST_SKIP() << "dicom3tools is not installed";
  }
  QProcess check;
  check.setProcessChannelMode(QProcess::MergedChannels);
  check.start(checker, { QString::fromStdString(this->Write("kidney.dcm")) });
  ASSERT_TRUE(check.waitForFinished(60000));
  const QString found = QString::fromLocal8Bit(check.readAll());
  EXPECT_TRUE(found.contains("Segmentation")) << found.toStdString();
  EXPECT_FALSE(found.contains("Error")) << found.toStdString();
}

TEST_F(DicomSegments, NeverReplaceAnImageOfTheScan)
{
  const auto bytes = std::filesystem::file_size(this->images[1]);
  EXPECT_NE(this->FailureOf("slice1").find("not replaced"), std::string::npos);
  EXPECT_EQ(std::filesystem::file_size(this->images[1]), bytes);
}

// Else the patient would have another name in them.
TEST_F(DicomSegments, NeedTextsInTheNamedCharacterSet)
{
  WriteScanOfPatient(this->folder, "ISO_IR 999");
  EXPECT_NE(this->FailureOf("kidney.dcm").find("ISO_IR 999"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(this->folder.Path("kidney.dcm")));
}

TEST_F(DicomSegments, WithoutVoxelsAreRefused)
{
  std::fill(this->Numbers(), this->Numbers() + 5 * 4 * 3, 0);
  EXPECT_NE(this->FailureOf("empty.dcm").find("found none"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(this->folder.Path("empty.dcm")));
}

TEST_F(DicomSegments, NeedAReadableImageOfTheScan)
{
  std::ofstream(this->images[0]) << "no DICOM";
  EXPECT_NE(this->FailureOf("kidney.dcm").find("slice0"), std::string::npos);
}
