// Features of DICOM: many files, several series, rescaled values, slices out of place.
#include "PhantomFiles.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>

namespace
{

/// Writes slices of the phantom to a folder of the given name.
void WriteSlices(const TemporaryFolder& folder, const std::string& name, const StoredVolume& volume,
  const std::vector<int>& slices, const DicomOptions& options = {})
{
  for (const int slice : slices)
  {
    folder.Write(
      name + "/slice" + std::to_string(slice) + ".dcm", DicomBytes(volume, slice, options));
  }
}

std::string Warnings(vtkVolumeFileReader* reader)
{
  std::string all;
  for (vtkIdType i = 0; i < reader->GetWarnings()->GetNumberOfValues(); ++i)
  {
    all += reader->GetWarnings()->GetValue(i) + "\n";
  }
  return all;
}

/// The phantom with more slices, all identical.
StoredVolume TallPhantom(int sliceCount)
{
  StoredVolume volume = phantom::Stored(0);
  const std::vector<double> slice(volume.values.begin(), volume.values.begin() + 20);
  volume.values.clear();
  for (int i = 0; i < sliceCount; ++i)
  {
    volume.values.insert(volume.values.end(), slice.begin(), slice.end());
  }
  volume.dimensions[2] = sliceCount;
  return volume;
}

TEST(DicomVolumes, ValuesAreRescaledSliceBySlice)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  for (int slice = 0; slice < 3; ++slice)
  {
    DicomOptions options;
    options.slope = slice + 1.0;
    options.intercept = -1024.0 - slice;
    WriteSlices(folder, "images", volume, { slice }, options);
  }
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_SHORT);
  for (int slice = 0; slice < 3; ++slice)
  {
    EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(1, 2, slice, 0),
      (slice + 1.0) * phantom::ValueAt({ 1, 2, slice }) - 1024.0 - slice);
  }
  EXPECT_STREQ(reader->GetModality(), "CT");
  EXPECT_EQ(reader->GetWindow(), 400.0);
  EXPECT_EQ(reader->GetLevel(), 40.0);
  EXPECT_EQ(Warnings(reader), "");
}

TEST(DicomVolumes, BodyPartAndAcquisitionAreReported)
{
  const auto read = [](const DicomOptions& options)
  {
    const TemporaryFolder folder;
    WriteSlices(folder, "images", phantom::Stored(0), { 0, 1, 2 }, options);
    auto reader = vtkSmartPointer<vtkVolumeFileReader>::New();
    reader->SetFileName(folder.Path("images").c_str());
    reader->Update();
    return reader;
  };
  DicomOptions chest;
  chest.bodyPart = "CHEST";
  chest.contrastAgent = "Iodine";
  chest.echoMs = 90.0; // only meaningful for MR
  EXPECT_STREQ(read(chest)->GetBodyPart(), "CHEST");
  EXPECT_TRUE(read(chest)->HasContrastAgent());
  EXPECT_STREQ(read(chest)->GetWeighting(), "");
  EXPECT_FALSE(read({})->HasContrastAgent());
  EXPECT_STREQ(read({})->GetBodyPart(), "");

  DicomOptions mr;
  mr.modality = "MR";
  EXPECT_STREQ(read(mr)->GetWeighting(), "");
  mr.echoMs = 90.0;
  mr.repetitionMs = 4000.0;
  EXPECT_STREQ(read(mr)->GetWeighting(), "T2");
  mr.echoMs = 12.0;
  EXPECT_STREQ(read(mr)->GetWeighting(), "") << "proton density";
  mr.repetitionMs = 500.0;
  EXPECT_STREQ(read(mr)->GetWeighting(), "T1");
  mr.isAngiography = true;
  EXPECT_STREQ(read(mr)->GetWeighting(), "angiography");
}

TEST(DicomVolumes, TheLargestSeriesIsReadUnlessAnotherIsAskedFor)
{
  const std::string TheTwo = "1 (CT, 3 images, 1.2.44), 2 (CT, 2 images, 1.2.33)";
  const TemporaryFolder folder;
  WriteSlices(folder, "images/a", phantom::Stored(0), { 0, 1 }, { "1.2.33" });
  WriteSlices(folder, "images/b", phantom::Stored(0), { 0, 1, 2 }, { "1.2.44" });
  folder.Write("images/readme.txt", "no image");
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  EXPECT_EQ(reader->ListDICOMSeries().size(), 2u);
  EXPECT_EQ(reader->ListDICOMSeries().front().UID, "1.2.44");
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[2], 3);
  EXPECT_NE(Warnings(reader).find(TheTwo), std::string::npos) << Warnings(reader);

  for (const char* const name : { "1.2.33", "1.2.3", "2" })
  {
    reader->SetDICOMSeriesUID(name);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetDimensions()[2], 2) << name;
    EXPECT_EQ(Warnings(reader), "");
  }

  const ExpectedVtkErrors errors;
  for (const char* const name : { "1.2.55", "3", "0", "1.2." })
  {
    reader->SetDICOMSeriesUID(name);
    reader->Update();
    const std::string message = reader->GetErrorMessage();
    EXPECT_NE(message.find('"' + std::string(name) + '"'), std::string::npos) << message;
    EXPECT_NE(message.find(TheTwo), std::string::npos) << message;
  }
  EXPECT_EQ(errors.Messages().size(), 4u);
}

TEST(DicomVolumes, AnIndexFileTellsWhichImagesBelong)
{
  const TemporaryFolder folder;
  WriteSlices(folder, "disc/CT", phantom::Stored(0), { 0, 1, 2 });
  WriteSlices(folder, "disc/OTHER", TallPhantom(9), { 3, 4, 5, 6, 7, 8 }, { "1.2.44" });
  const std::string index = folder.Write(
    "disc/DICOMDIR", DicomIndexBytes({ "CT\\slice0.dcm", "CT\\slice1.dcm", "CT\\slice2.dcm" }));
  for (const std::string& path : { index, folder.Path("disc") })
  {
    vtkNew<vtkVolumeFileReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    ASSERT_STREQ(reader->GetErrorMessage(), "");
    EXPECT_EQ(Warnings(reader), "");
    ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 5 * 4 * 3);
    EXPECT_EQ(
      reader->GetOutput()->GetScalarComponentAsDouble(4, 3, 2, 0), phantom::ValueAt({ 4, 3, 2 }));
    EXPECT_NEAR(reader->GetOutput()->GetSpacing()[2], 2.5, 1e-6);
  }
}

TEST(DicomVolumes, AnIndexOfMissingImagesIsRefused)
{
  const TemporaryFolder folder;
  const std::string index =
    folder.Write("DICOMDIR", DicomIndexBytes({ "CT\\slice0.dcm", "CT\\slice1.dcm" }));
  const ExpectedVtkErrors errors;
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(index.c_str());
  reader->Update();
  const std::string message = reader->GetErrorMessage();
  EXPECT_EQ(message,
    "Cannot read \"" + folder.Path("CT/slice0.dcm") +
      "\": expected an existing file, found no file of this name.");
  EXPECT_EQ(errors.Messages().size(), 1u) << errors.Text();
}

TEST(DicomVolumes, AFileAloneIsASlice)
{
  const TemporaryFolder folder;
  WriteSlices(folder, "images", phantom::Stored(0), { 0, 1, 2 });
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images/slice1.dcm").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[2], 1);
  EXPECT_EQ(
    reader->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0), phantom::ValueAt({ 0, 0, 1 }));
}

TEST(DicomVolumes, MissingSlicesAreAWarning)
{
  const TemporaryFolder folder;
  std::vector<int> slices(24);
  std::iota(slices.begin(), slices.end(), 0);
  slices.erase(slices.begin() + 9, slices.begin() + 12);
  WriteSlices(folder, "images", TallPhantom(24), slices);
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_NEAR(reader->GetOutput()->GetSpacing()[2], 2.5, 1e-6);
  EXPECT_NE(Warnings(reader).find("mm apart"), std::string::npos) << Warnings(reader);
  EXPECT_NE(
    Warnings(reader).find("3 slices are missing between \"slice8.dcm\" and \"slice12.dcm\"."),
    std::string::npos)
    << Warnings(reader);
}

TEST(DicomVolumes, UnevenSlicesAreAWarningThatNamesTheWidestGap)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  volume.originMm = glm::dvec3(0.0);
  volume.axesMm = glm::dmat3(1.0);
  DicomOptions later;
  later.position = "0\\0\\2.2";
  WriteSlices(folder, "images", volume, { 0, 1 });
  WriteSlices(folder, "images", volume, { 2 }, later);
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_NE(
    Warnings(reader).find("Slices are 1 to 1.2 mm apart, farthest between \"slice1.dcm\" and "
                          "\"slice2.dcm\""),
    std::string::npos)
    << Warnings(reader);
}

TEST(DicomVolumes, MixedDirectionsAreAWarningThatNamesWhatIsLeftOut)
{
  const TemporaryFolder folder;
  WriteSlices(folder, "images", phantom::Stored(0), { 0, 1, 2 });
  StoredVolume across = phantom::Stored(0);
  across.axesMm = glm::dmat3(across.axesMm[1], across.axesMm[2], across.axesMm[0]);
  DicomOptions options;
  options.instance = 70;
  folder.Write("images/across.dcm", DicomBytes(across, 0, options));
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 60);
  EXPECT_NE(Warnings(reader).find(": \"across.dcm\")."), std::string::npos) << Warnings(reader);
}

TEST(DicomVolumes, CompressionWithLossIsAWarningThatNamesTheFiles)
{
  const TemporaryFolder folder;
  DicomOptions options;
  options.lossy = true;
  WriteSlices(folder, "images", phantom::Stored(0), { 0 });
  WriteSlices(folder, "images", phantom::Stored(0), { 1, 2 }, options);
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_NE(Warnings(reader).find("2 of 3 images were compressed with loss"), std::string::npos)
    << Warnings(reader);
  EXPECT_NE(Warnings(reader).find("\"slice1.dcm\", \"slice2.dcm\""), std::string::npos)
    << Warnings(reader);
}

TEST(DicomVolumes, RepeatedSlicesAreReadOnceWithAWarning)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  WriteSlices(folder, "images/first", volume, { 0, 1, 2 });
  for (int slice = 0; slice < 3; ++slice)
  {
    DicomOptions options;
    options.instance = slice + 100;
    WriteSlices(folder, "images/second", volume, { slice }, options);
  }
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 60);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfScalarComponents(), 1);
  EXPECT_NE(Warnings(reader).find("only the first"), std::string::npos) << Warnings(reader);
}

TEST(DicomVolumes, AScoutOfAnotherSizeIsLeftOutWithAWarning)
{
  const TemporaryFolder folder;
  WriteSlices(folder, "images/slices", phantom::Stored(0), { 0, 1, 2 });
  StoredVolume scout = phantom::Stored(0);
  scout.dimensions = { 10, 6, 1 };
  DicomOptions options;
  options.instance = 50;
  WriteSlices(folder, "images/scout", scout, { 0 }, options);
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 60);
  EXPECT_NE(Warnings(reader).find("2 (10 x 6 pixels: \"slice0.dcm\")"), std::string::npos)
    << Warnings(reader);
}

TEST(DicomVolumes, AnInvalidPositionIsIgnored)
{
  const TemporaryFolder folder;
  DicomOptions options;
  options.position = "1\\2";
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(
    folder.Write("slice.dcm", DicomBytes(phantom::Stored(0), 0, options)).c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 20) << reader->GetErrorMessage();
}

TEST(DicomVolumes, ATiltedGantryShearsTheVolumeWithAWarning)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  volume.axesMm = glm::dmat3(0.7, 0, 0, 0, 1.1, 0, 0, 0.5, 2.5);
  WriteSlices(folder, "images", volume, { 0, 1, 2 });
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_NE(Warnings(reader).find("tilted by 11.3"), std::string::npos) << Warnings(reader);
  double worldMm[3];
  reader->GetOutput()->TransformIndexToPhysicalPoint(1, 1, 2, worldMm);
  EXPECT_NEAR(worldMm[0], volume.originMm.x + 0.7, 1e-5);
  EXPECT_NEAR(worldMm[1], volume.originMm.y + 1.1 + 2 * 0.5, 1e-5);
  EXPECT_NEAR(worldMm[2], volume.originMm.z + 2 * 2.5, 1e-5);
}

TEST(DicomVolumes, AnObserverOfProgressCanStop)
{
  const TemporaryFolder folder;
  WriteSlices(folder, "images", phantom::Stored(0), { 0, 1, 2 });
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(folder.Path("images").c_str());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), (unsigned long)vtkErrorCode::UserError);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(DicomVolumes, RealSeriesAreReadInHounsfieldUnits)
{
  const char* volumes = std::getenv("VARIMARCH_VOLUMES");
  if (!volumes)
  {
    GTEST_SKIP() << "VARIMARCH_VOLUMES does not name a folder of volumes";
  }
  const std::string path = std::string(volumes) + "/ct_abdomen_pancreas/dicom";
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[2], 134);
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[2], 3.0);
  EXPECT_EQ(reader->GetOutput()->GetScalarRange()[0], -1000.0);
  EXPECT_EQ(reader->GetOutput()->GetScalarRange()[1], 1988.0);
}

}
