// Measurements written as a DICOM structured report: pydicom, DCMTK and dicom3tools read them back.

#include "DicomMeasures/DicomMeasures.h"
#include "ScanOfPatient.h"
#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>

#include <gtest/gtest.h>

#include <fstream>

using namespace varimarch;

namespace
{

class DicomMeasures : public testing::Test
{
protected:
  DicomMeasures()
  {
    this->images = WriteScanOfPatient(this->folder);
    this->scan = LoadVolume(FileSource{ this->folder.Path(""), std::nullopt });
    std::array<double, 3> first;
    std::array<double, 3> last;
    this->scan.image->TransformIndexToPhysicalPoint(1, 1, 0, first.data());
    this->scan.image->TransformIndexToPhysicalPoint(3, 2, 1, last.data());
    this->measures = { { MeasureKind::Distance, { { 0.0, 0.0, 0.0 }, { 3.0, 4.0, 12.0 } } },
      { MeasureKind::Angle, { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 } } },
      { MeasureKind::Box, { first, last }, "Gef\xc3\xa4\xc3\x9f" },
      { MeasureKind::Text, { { 1.5, 2.5, -3.5 } }, "look here" } };
  }

  std::string Write(const std::string& name)
  {
    WriteDicomMeasures(this->measures, this->scan, this->images, this->folder.Path(name));
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

  /// The parts of the report that read_measures.py prints; empty if pydicom is not installed.
  std::optional<QJsonObject> ReadByPydicom()
  {
    QProcess python;
    python.start(VARIMARCH_TEST_PYTHON,
      { "-B", VARIMARCH_READ_MEASURES, QString::fromStdString(this->Write("sr.dcm")) });
    EXPECT_TRUE(python.waitForFinished(60000));
    const QByteArray errors = python.readAllStandardError();
    if (errors.contains("No module named 'pydicom'"))
    {
      return {};
    }
    EXPECT_EQ(python.exitCode(), 0) << errors.toStdString();
    return QJsonDocument::fromJson(python.readAllStandardOutput()).object();
  }

  /// Runs a program that checks or prints the report; empty if it is not installed.
  std::optional<QString> Printed(const QString& program, const QStringList& options = {})
  {
    const QString found = QStandardPaths::findExecutable(program);
    if (found.isEmpty())
    {
      return {};
    }
    QProcess run;
    run.setProcessChannelMode(QProcess::MergedChannels);
    run.start(found, options + QStringList{ QString::fromStdString(this->Write("sr.dcm")) });
    EXPECT_TRUE(run.waitForFinished(60000));
    return QString::fromUtf8(run.readAll());
  }

  TemporaryFolder folder;
  std::vector<std::string> images;
  LoadedVolume scan;
  std::vector<Measure> measures;
};

void ExpectNumber(const QJsonValue& found, const char* name, double value, const char* unit)
{
  EXPECT_EQ(found.toObject()["name"].toString(), name);
  EXPECT_NEAR(found.toObject()["value"].toDouble(), value, 1e-6 * std::abs(value) + 1e-9) << name;
  EXPECT_EQ(found.toObject()["unit"].toString(), unit);
}

}

TEST_F(DicomMeasures, AreThoseOfThePatientForOtherPrograms)
{
  const auto report = this->ReadByPydicom();
  if (!report)
  {
    GTEST_SKIP() << "pydicom is not installed";
  }
  const QJsonObject& found = *report;
  EXPECT_EQ(found["class"].toString(), "Comprehensive 3D SR Storage");
  EXPECT_EQ(found["modality"].toString(), "SR");
  EXPECT_EQ(found["title"].toString(), "Imaging Measurement Report");
  EXPECT_EQ(found["template"].toString(), "1500");
  EXPECT_EQ(found["patient"].toString(), QString::fromUtf8("M\xc3\xbcller^Ute"));
  EXPECT_EQ(found["study"].toString(), "1.2.77");
  EXPECT_EQ(found["evidence"].toInt(), 3);
  EXPECT_EQ(found["images"].toArray().size(), 3);
  const QJsonArray groups = found["groups"].toArray();
  ASSERT_EQ(groups.size(), 4);
  const auto part = [&](int group, const char* name)
  { return groups[group].toObject()[name].toArray(); };
  EXPECT_EQ(groups[0].toObject()["id"].toString(), "1 distance");
  ExpectNumber(part(0, "numbers")[0], "Length", 13.0, "mm");
  EXPECT_EQ(part(0, "types"), QJsonArray{ "POLYLINE" });
  EXPECT_EQ(part(0, "points")[0].toArray(), (QJsonArray{ 0, 0, 0, 3, 4, 12 }));
  EXPECT_EQ(part(0, "frames"), QJsonArray{ "1.2.52" });
  ExpectNumber(part(1, "numbers")[0], "Angle", 90.0, "deg");
  EXPECT_EQ(part(3, "comments"), QJsonArray{ "look here" });
  EXPECT_EQ(part(3, "types"), QJsonArray{ "POINT" });
  EXPECT_EQ(part(3, "points")[0].toArray(), (QJsonArray{ 1.5, 2.5, -3.5 }));
}

TEST_F(DicomMeasures, HaveTheStatisticsOfTheirVoxels)
{
  this->measures = { this->measures[2] };
  const auto report = this->ReadByPydicom();
  if (!report)
  {
    GTEST_SKIP() << "pydicom is not installed";
  }
  const QJsonObject box = (*report)["groups"].toArray()[0].toObject();
  EXPECT_EQ(box["comments"].toArray(), QJsonArray{ QString::fromUtf8("Gef\xc3\xa4\xc3\x9f") });
  EXPECT_EQ(box["types"].toArray().size(), 12) << "edges";
  const QJsonArray numbers = box["numbers"].toArray();
  ASSERT_EQ(numbers.size(), 5);
  double sum = 0.0;
  for (int voxel = 0; voxel < 3 * 2 * 2; ++voxel)
  {
    sum +=
      this->scan.image->GetScalarComponentAsDouble(1 + voxel % 3, 1 + voxel / 3 % 2, voxel / 6, 0);
  }
  ExpectNumber(numbers[1], "Attenuation Coefficient/Mean", sum / 12.0, "[hnsf'U]");
  EXPECT_EQ(numbers[4].toObject()["name"].toString(), "Attenuation Coefficient/Maximum");
}

TEST_F(DicomMeasures, ArePrintedByDcmtk)
{
  const auto printed = this->Printed("dsrdump", { "+Pl" });
  if (!printed)
  {
    GTEST_SKIP() << "dcmtk is not installed";
  }
  EXPECT_TRUE(printed->contains("Imaging Measurement Report")) << printed->toStdString();
  EXPECT_TRUE(printed->contains("Length")) << printed->toStdString();
  EXPECT_FALSE(printed->contains("E: ")) << printed->toStdString();
}

// dciodvfy of dicom3tools knows the modules of the standard and their conditions.
TEST_F(DicomMeasures, AreAsTheStandardHasThem)
{
  const auto printed = this->Printed("dciodvfy");
  if (!printed)
  {
    GTEST_SKIP() << "dicom3tools is not installed";
  }
  EXPECT_TRUE(printed->contains("Comprehensive3DSR")) << printed->toStdString();
  EXPECT_FALSE(printed->contains("Error")) << printed->toStdString();
}

TEST_F(DicomMeasures, NeverReplaceAnImageOfTheScan)
{
  EXPECT_NE(this->FailureOf("slice1").find("choose another name"), std::string::npos);
}

// Else the patient would have another name in them.
TEST_F(DicomMeasures, NeedTextsInTheNamedCharacterSet)
{
  WriteScanOfPatient(this->folder, "ISO_IR 999");
  EXPECT_NE(this->FailureOf("sr.dcm").find("ISO_IR 999"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(this->folder.Path("sr.dcm")));
}

TEST_F(DicomMeasures, NeedAFrameOfReference)
{
  this->scan.frameOfReference.clear();
  EXPECT_NE(this->FailureOf("sr.dcm").find("frame of reference"), std::string::npos);
  EXPECT_FALSE(std::ifstream(this->folder.Path("sr.dcm")).good());
}
