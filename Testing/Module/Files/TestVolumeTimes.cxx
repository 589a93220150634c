// Files with several volumes: their times, each of which is read alone.
#include "Module/Files/TimesOfFiles.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace
{

/// A NIfTI file of 4 times, 1.5 s apart, from 3 s on.
std::string NiftiOfTimes()
{
  std::string bytes = NiftiBytes(phantom::Stored(0)).substr(0, 352);
  Put(bytes, 40, std::int16_t(4));
  Put(bytes, 48, std::int16_t(timeCount));
  Put(bytes, 76 + 16, 1.5f);
  bytes[123] = char(2 + 8); // mm and s
  Put(bytes, 136, 3.0f);
  return bytes + VoxelsOfTimes();
}

TEST_F(VolumeTimes, OfNiftiHaveTheirUnit)
{
  std::string bytes = NiftiOfTimes();
  this->ExpectSeconds(this->folder.Write("s.nii", bytes), { 3.0, 4.5, 6.0, 7.5 });
  bytes[123] = char(2 + 16); // ms
  this->ExpectSeconds(this->folder.Write("ms.nii", bytes), { 0.003, 0.0045, 0.006, 0.0075 });
  bytes[123] = char(2 + 32); // Hz
  this->ExpectNumbers(this->folder.Write("hz.nii", bytes));
}

TEST_F(VolumeTimes, OfCompressedFilesAreRead)
{
  const std::string bytes = NiftiOfTimes();
  for (const char* filter : { "gzip", "bzip2", "zstd" })
  {
    const std::string path =
      this->folder.Write(std::string(filter) + ".nii.gz", Compressed(bytes, filter));
    this->ExpectSeconds(path, { 3.0, 4.5, 6.0, 7.5 });
  }
  this->ExpectSeconds(
    this->folder.Write("all.zip", Archived({ { "t.nii", bytes } }, "zip")), { 3.0, 4.5, 6.0, 7.5 });
}

TEST_F(VolumeTimes, OfACompressedFileAreUnpackedOnce)
{
  // The reader has the first file open, and so does not notice the second, whose values differ.
  const std::string bytes = NiftiOfTimes();
  const std::string others = bytes.substr(0, 352) + std::string(bytes.size() - 352, 'x');
  this->reader->SetFileName(this->folder.Write("t.nii.gz", Gzipped(bytes)).c_str());
  this->reader->Update();
  this->folder.Write("t.nii.gz", Gzipped(others));
  for (const int time : { 1, 3 })
  {
    this->reader->SetTimeIndex(time);
    this->reader->Update();
    EXPECT_EQ(ValuesOf(this->reader->GetOutput()), AtTime(time).values) << "time " << time;
  }
  this->reader->Modified();
  this->reader->Update();
  EXPECT_EQ(ValuesOf(this->reader->GetOutput()), std::vector<double>(60, 0x7878));
}

TEST_F(VolumeTimes, ArePipelineTimes)
{
  this->reader->SetFileName(this->folder.Write("t.nii", NiftiOfTimes()).c_str());
  this->reader->UpdateInformation();
  vtkInformation* const information = this->reader->GetOutputInformation(0);
  ASSERT_EQ(information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), timeCount);
  EXPECT_DOUBLE_EQ(information->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE())[1], 7.5);
  for (const double seconds : { 6.0, 3.0, 7.5, 4.6 })
  {
    this->reader->UpdateTimeStep(seconds);
    const int nearest = int(std::lround((seconds - 3.0) / 1.5));
    EXPECT_EQ(ValuesOf(this->reader->GetOutput()), AtTime(nearest).values) << seconds;
    EXPECT_DOUBLE_EQ(
      this->reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()),
      3.0 + 1.5 * nearest);
  }
  this->reader->SetFileName(this->folder.Write("one.nii", NiftiBytes(phantom::Stored(0))).c_str());
  this->reader->UpdateInformation();
  EXPECT_FALSE(information->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
}

TEST_F(VolumeTimes, OfOmeZarrAreAnAxis)
{
  const std::string path = this->folder.Path("t.zarr");
  const auto writeAxis = [this](const std::string& axis)
  {
    this->folder.Write("t.zarr/.zattrs",
      R"({"multiscales": [{"version": "0.4", "axes": [)" + axis +
        R"(, {"name": "z", "type": "space"}, {"name": "y", "type": "space"},
        {"name": "x", "type": "space"}], "datasets": [{"path": "0", "coordinateTransformations":
        [{"type": "scale", "scale": [1500, 1, 1, 1]},
         {"type": "translation", "translation": [3000, 0, 0, 0]}]}]}]})");
  };
  this->folder.Write("t.zarr/0/.zarray",
    R"({"zarr_format": 2, "shape": [4, 3, 4, 5], "chunks": [1, 3, 4, 5], "dtype": "<i2",
    "compressor": null, "fill_value": 0, "order": "C", "filters": null})");
  for (int time = 0; time < timeCount; ++time)
  {
    this->folder.Write("t.zarr/0/" + std::to_string(time) + ".0.0.0", VoxelBytes(AtTime(time)));
  }
  writeAxis(R"({"name": "t", "type": "time", "unit": "millisecond"})");
  this->ExpectSeconds(path, { 3.0, 4.5, 6.0, 7.5 });
  // The only warning is that of unknown sides: no time is left out.
  ASSERT_EQ(this->reader->GetWarnings()->GetNumberOfValues(), 1);
  EXPECT_NE(this->reader->GetWarnings()->GetValue(0).find("mirrored"), std::string::npos);
  writeAxis(R"({"name": "frame", "type": "time"})");
  this->ExpectNumbers(path);
  const ExpectedVtkErrors errors;
  this->reader->SetTimeIndex(4);
  this->reader->Update();
  EXPECT_NE(
    std::string(this->reader->GetErrorMessage()).find("a time from 0 to 3"), std::string::npos)
    << this->reader->GetErrorMessage();
}

TEST_F(VolumeTimes, BeyondTheLastAreAnError)
{
  const ExpectedVtkErrors errors;
  this->reader->SetFileName(this->folder.Write("t.nii", NiftiOfTimes()).c_str());
  this->reader->SetTimeIndex(4);
  this->reader->Update();
  EXPECT_NE(std::string(this->reader->GetErrorMessage())
              .find("expected a time from 0 to 3, found the time 4"),
    std::string::npos)
    << this->reader->GetErrorMessage();
}

TEST_F(VolumeTimes, ThatTheFileLacksAreAnError)
{
  const ExpectedVtkErrors errors;
  const std::string bytes = NiftiOfTimes();
  this->reader->SetFileName(
    this->folder.Write("cut.nii", bytes.substr(0, bytes.size() - 60)).c_str());
  this->reader->SetTimeIndex(2);
  this->reader->Update();
  EXPECT_EQ(ValuesOf(this->reader->GetOutput()), AtTime(2).values);
  this->reader->SetTimeIndex(3);
  this->reader->Update();
  EXPECT_STRNE(this->reader->GetErrorMessage(), "");
}

TEST_F(VolumeTimes, OfNrrdAreAnAxisBeforeOrBehindTheVolume)
{
  const std::string head = "NRRD0004\ntype: short\nendian: little\ndimension: 4\n";
  const std::string behind = head + "sizes: 5 4 3 4\nkinds: domain domain domain time\n";
  const std::string spaced =
    behind + "spacings: 0.7 0.8 2.5 250\nunits: \"mm\" \"mm\" \"mm\" \"ms\"\n";
  this->ExpectSeconds(
    this->folder.Write("behind.nrrd", spaced + "encoding: raw\n\n" + VoxelsOfTimes()),
    { 0.0, 0.25, 0.5, 0.75 });
  this->ExpectNumbers(
    this->folder.Write("gz.nrrd", behind + "encoding: gzip\n\n" + Gzipped(VoxelsOfTimes())));
  std::string text;
  StoredVolume mixed = phantom::Stored(0);
  mixed.values.clear();
  for (int time = 0; time < timeCount; ++time)
  {
    text += VoxelText(AtTime(time)) + "\n";
  }
  for (std::size_t i = 0; i < 60; ++i)
  {
    for (int time = 0; time < timeCount; ++time)
    {
      mixed.values.push_back(AtTime(time).values[i]);
    }
  }
  this->ExpectNumbers(this->folder.Write("text.nrrd", behind + "encoding: ascii\n\n" + text));
  const std::string before = head + "sizes: 4 5 4 3\nkinds: list domain domain domain\n";
  const std::string labels =
    "MultiVolume.FrameLabels:=0,1200,2600,3000\nMultiVolume.FrameIdentifyingDICOMTagUnits:=ms\n";
  this->ExpectSeconds(this->folder.Write("slicer.nrrd",
                        before + "encoding: raw\n" + labels + "\n" + VoxelBytes(mixed)),
    { 0.0, 1.2, 2.6, 3.0 });
  this->ExpectNumbers(
    this->folder.Write("mixed.nrrd", before + "encoding: ascii\n\n" + VoxelText(mixed)));
}

TEST_F(VolumeTimes, OfMetaImageAreTheFourthAxis)
{
  const std::string head = "ObjectType = Image\nNDims = 4\nDimSize = 5 4 3 4\n"
                           "ElementSpacing = 1 1 1 2\nElementType = MET_SHORT\n";
  this->ExpectNumbers(
    this->folder.Write("t.mha", head + "ElementDataFile = LOCAL\n" + VoxelsOfTimes()));
  for (int time = 0; time < timeCount; ++time)
  {
    this->folder.Write("part" + std::to_string(time) + ".raw", VoxelBytes(AtTime(time)));
  }
  this->ExpectNumbers(this->folder.Write("t.mhd", head + "ElementDataFile = part%d.raw 0 3 1\n"));
}

TEST_F(VolumeTimes, OfMifAreSeconds)
{
  const std::string head = "mrtrix image\ndim: 5,4,3,4\nvox: 1,1,1,2.5\ndatatype: Int16LE\n"
                           "layout: +0,+1,+2,+3\nfile: . 128\nEND\n";
  this->ExpectSeconds(
    this->folder.Write("t.mif", head + std::string(128 - head.size(), ' ') + VoxelsOfTimes()),
    { 0.0, 2.5, 5.0, 7.5 });
}

TEST_F(VolumeTimes, OfMghAreRepetitions)
{
  std::string bytes(284, '\0');
  const auto put = [&](std::size_t offset, int number)
  {
    for (int byte = 0; byte < 4; ++byte)
    {
      bytes[offset + std::size_t(byte)] = char(number >> (24 - 8 * byte));
    }
  };
  const int fields[] = { 1, 5, 4, 3, timeCount, 4 };
  for (int i = 0; i < 6; ++i)
  {
    put(std::size_t(4 * i), fields[i]);
  }
  bytes += VoxelsOfTimes(timeCount, true);
  this->ExpectNumbers(this->folder.Write("t.mgh", bytes));
  bytes += std::string("\x45\x0f\xc0\0", 4); // a repetition time of 2300 ms
  this->ExpectSeconds(this->folder.Write("t.mgh", bytes), { 0.0, 2.3, 4.6, 6.9 });
  const std::string path = this->folder.Write("t.mgz", Gzipped(bytes));
  this->ExpectSeconds(path, { 0.0, 2.3, 4.6, 6.9 });
  // The end of the file is not unpacked for each time.
  this->reader->Modified();
  this->reader->SetTimeIndex(0);
  this->reader->Update();
  this->folder.Write("t.mgz", Gzipped(bytes.substr(0, bytes.size() - 4) + std::string(4, 'x')));
  this->reader->SetTimeIndex(1);
  this->reader->Update();
  EXPECT_NEAR(this->reader->GetTimeValue(1), 2.3, 1e-6);
}

TEST_F(VolumeTimes, OfAfniMayHaveOtherTypesAndFactors)
{
  const std::string header =
    "type = integer-attribute\nname = DATASET_RANK\ncount = 2\n 3 4\n\n"
    "type = integer-attribute\nname = DATASET_DIMENSIONS\ncount = 3\n 5 4 3\n\n"
    "type = integer-attribute\nname = BRICK_TYPES\ncount = 4\n 1 3 1 1\n\n"
    "type = float-attribute\nname = BRICK_FLOAT_FACS\ncount = 4\n 0 0 0.5 0\n\n"
    "type = string-attribute\nname = BYTEORDER_STRING\ncount = 10\n"
    "'LSB_FIRST~\n\n"
    "type = integer-attribute\nname = TAXIS_NUMS\ncount = 3\n 4 0 77001\n\n"
    "type = float-attribute\nname = TAXIS_FLOATS\ncount = 2\n 0 2000\n\n"
    "type = integer-attribute\nname = ORIENT_SPECIFIC\ncount = 3\n 0 3 4\n\n"
    "type = float-attribute\nname = ORIGIN\ncount = 3\n 0 0 0\n\n"
    "type = float-attribute\nname = DELTA\ncount = 3\n 1 1 1\n";
  StoredVolume ofFloats = AtTime(1);
  ofFloats.scalarType = VTK_FLOAT;
  StoredVolume doubled = AtTime(2);
  for (double& value : doubled.values)
  {
    value *= 2.0;
  }
  this->folder.Write("t.BRIK",
    VoxelBytes(AtTime(0)) + VoxelBytes(ofFloats) + VoxelBytes(doubled) + VoxelBytes(AtTime(3)));
  const std::string path = this->folder.Write("t.HEAD", header);
  this->ExpectSeconds(path, { 0.0, 2.0, 4.0, 6.0 });
}

TEST_F(VolumeTimes, AreFilesWhenTheUserSaysSo)
{
  for (const auto& [number, time] :
    std::map<std::string, int>{ { "8", 0 }, { "9", 1 }, { "10", 2 }, { "11", 3 } })
  {
    this->folder.Write("heart/v2_" + number + ".nii.gz", Gzipped(NiftiBytes(AtTime(time))));
  }
  this->folder.Write("heart/v3_7.nii", "no volume");
  this->reader->FilesAreTimesOn();
  this->ExpectNumbers(this->folder.Path("heart"));
  this->ExpectNumbers(this->folder.Path("heart/v2_9.nii.gz"));

  const ExpectedVtkErrors errors;
  StoredVolume thin = AtTime(2);
  thin.dimensions[2] = 2;
  thin.values.resize(40);
  this->folder.Write("heart/v2_10.nii.gz", NiftiBytes(thin));
  this->reader->SetTimeIndex(1);
  this->reader->Update();
  this->reader->SetTimeIndex(2);
  this->reader->Update();
  EXPECT_NE(std::string(this->reader->GetErrorMessage())
              .find("expected 5 x 4 x 3 voxels as at the other times, found 5 x 4 x 2 voxels"),
    std::string::npos)
    << this->reader->GetErrorMessage();
}

TEST_F(VolumeTimes, AreSoughtInSeveralFiles)
{
  const ExpectedVtkErrors errors;
  this->reader->SetFileName(this->folder.Write("alone_1.nii", NiftiOfTimes()).c_str());
  this->reader->FilesAreTimesOn();
  this->reader->Update();
  EXPECT_NE(
    std::string(this->reader->GetErrorMessage()).find("found a single one"), std::string::npos)
    << this->reader->GetErrorMessage();
  this->reader->SetFileName(this->folder.Path("none/v_1.nii").c_str());
  this->reader->Update();
  EXPECT_NE(std::string(this->reader->GetErrorMessage()).find("found no volume"), std::string::npos)
    << this->reader->GetErrorMessage();
}

}
