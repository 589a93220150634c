// Formats with few writers: types, byte orders, encodings, scalings and several volumes.
#include "PhantomFormats.h"
#include "PhantomLibraryFiles.h"

#include "Support/ExpectedVtkErrors.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

namespace
{

/// Values whose bytes differ, so that a wrong byte order is detectable.
StoredVolume VolumeEndingAt100(int scalarType)
{
  StoredVolume volume = phantom::Stored(0);
  volume.scalarType = scalarType;
  volume.values.back() = 100;
  return volume;
}

/// A volume whose axes are those of the world, for formats without directions.
StoredVolume StraightVolume(int scalarType)
{
  StoredVolume volume = VolumeEndingAt100(scalarType);
  volume.originMm = { 3.0, -4.5, 7.25 };
  volume.axesMm = glm::dmat3(0.5, 0.0, 0.0, 0.0, 0.75, 0.0, 0.0, 0.0, 2.5);
  return volume;
}

void Read(vtkVolumeFileReader* reader, const std::string& path)
{
  reader->SetFileName(path.c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
}

void ExpectValues(vtkVolumeFileReader* reader, int scalarType, const std::vector<double>& values)
{
  vtkDataArray* const scalars = reader->GetOutput()->GetPointData()->GetScalars();
  ASSERT_TRUE(scalars);
  EXPECT_EQ(scalars->GetDataType(), scalarType);
  ASSERT_EQ(scalars->GetNumberOfValues(), vtkIdType(values.size()));
  for (vtkIdType i = 0; i < scalars->GetNumberOfValues(); ++i)
  {
    ASSERT_NEAR(scalars->GetVariantValue(i).ToDouble(), values[std::size_t(i)], 1e-4) << i;
  }
}

void ExpectStored(const std::string& path, const StoredVolume& volume)
{
  SCOPED_TRACE(path);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, path);
  ExpectValues(reader, volume.scalarType, volume.values);
}

/// The position of a voxel of the file in the world.
glm::dvec3 PositionOf(vtkImageData* image, int i, int j, int k)
{
  glm::dvec3 worldMm;
  image->TransformIndexToPhysicalPoint(i, j, k, &worldMm[0]);
  return worldMm;
}

void ExpectPlaced(vtkVolumeFileReader* reader, const StoredVolume& volume, bool hasOrigin)
{
  const glm::dvec3 origin = hasOrigin ? volume.originMm : glm::dvec3(0.0);
  const glm::dvec3 expected = origin + volume.axesMm * glm::dvec3(1.0, 2.0, 1.0);
  const glm::dvec3 found = PositionOf(reader->GetOutput(), 1, 2, 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(found[axis], expected[axis], 1e-5) << axis;
  }
}

bool Warns(vtkVolumeFileReader* reader, const std::string& words)
{
  for (vtkIdType i = 0; i < reader->GetWarnings()->GetNumberOfValues(); ++i)
  {
    if (reader->GetWarnings()->GetValue(i).find(words) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

std::string Mif(const StoredVolume& volume)
{
  return MifHeaderText(volume, { 0, 1, 2 }, { false, false, false }) + VoxelBytes(volume);
}

TEST(VolumeFormats, EveryTypeAndByteOrderGivesItsValues)
{
  const TemporaryFolder folder;
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_FLOAT })
  {
    const StoredVolume volume = VolumeEndingAt100(type);
    ExpectStored(folder.Write("a.mgh", MghBytes(volume)), volume);
    ExpectStored(folder.Write("a.mgz", Gzipped(MghBytes(volume))), volume);
  }
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE })
  {
    const StoredVolume volume = VolumeEndingAt100(type);
    ExpectStored(folder.Write("a.gipl", GiplBytes(volume)), volume);
    ExpectStored(folder.Write("a.mif", Mif(volume)), volume);
    ExpectStored(folder.Write("a.npy", NpyBytes(volume, { 3, 4, 5 })), volume);
    ExpectStored(folder.Write("b.npy", NpyBytes(volume, { 3, 4, 5 }, false, true)), volume);
  }
  for (const int type : { VTK_SIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_FLOAT })
  {
    const StoredVolume volume = VolumeEndingAt100(type);
    ExpectStored(folder.Write("a.mrc", MrcBytes(volume)), volume);
    ExpectStored(folder.Write("b.mrc", MrcBytes(volume, true)), volume);
  }
  for (const bool isBig : { false, true })
  {
    const StoredVolume volume = VolumeEndingAt100(VTK_FLOAT);
    folder.Write("a+orig.BRIK", VoxelBytes(volume, isBig));
    ExpectStored(folder.Write("a+orig.HEAD", AfniHeaderText(volume, isBig)), volume);
    ExpectStored(folder.Path("a+orig.BRIK"), volume);
  }
}

TEST(VolumeFormats, FormatsWithoutDirectionsKeepSpacingAndOrigin)
{
  const TemporaryFolder folder;
  const StoredVolume shorts = StraightVolume(VTK_SHORT);
  const StoredVolume bytes = StraightVolume(VTK_UNSIGNED_CHAR);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("a.gipl", GiplBytes(shorts)));
  ExpectPlaced(reader, shorts, true);
  EXPECT_TRUE(Warns(reader, "mirrored"));
  Read(reader, folder.Write("a.slc", SlcBytes(bytes, false)));
  ExpectPlaced(reader, bytes, false);
  Read(reader, folder.Write("a.pvm", PvmBytes(bytes)));
  ExpectPlaced(reader, bytes, false);
}

TEST(VolumeFormats, AnMrcMapHasItsAxesInAnyOrder)
{
  const TemporaryFolder folder;
  StoredVolume volume = StraightVolume(VTK_SHORT);
  volume.axesMm = { { 0.0, 0.0, 2.5e-6 }, { 0.5e-6, 0.0, 0.0 }, { 0.0, 0.75e-6, 0.0 } };
  volume.originMm = { 3e-6, -4e-6, 5e-6 };
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("a.map", MrcBytes(volume)));
  const glm::dvec3 found = PositionOf(reader->GetOutput(), 1, 2, 1);
  const glm::dvec3 expected = volume.originMm + volume.axesMm * glm::dvec3(1.0, 2.0, 1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(found[axis], expected[axis], 1e-12);
  }
}

TEST(VolumeFormats, AnMrcStackOfVolumesHasTimes)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  volume.axesMm = glm::dmat3(1e-7);
  std::string bytes = MrcBytes(volume);
  Put(bytes, 36, std::int32_t(1));   // slices of each volume
  Put(bytes, 88, std::int32_t(401)); // the space group of such stacks
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("a.mrc", bytes));
  EXPECT_EQ(reader->GetNumberOfTimes(), 3);
  ExpectValues(reader, VTK_SHORT, { volume.values.begin(), volume.values.begin() + 20 });
  reader->SetTimeIndex(2);
  reader->Update();
  ExpectValues(reader, VTK_SHORT, { volume.values.begin() + 40, volume.values.end() });
  EXPECT_TRUE(Warns(reader, "mirrored"));
  Put(bytes, 36, std::int32_t(2));
  const ExpectedVtkErrors errors;
  reader->SetFileName(folder.Write("b.mrc", bytes).c_str());
  reader->Update();
  const std::string message = reader->GetErrorMessage();
  EXPECT_NE(message.find("share evenly"), std::string::npos) << message;
}

TEST(VolumeFormats, AnMrcStackOfImagesSaysThatItIsNoVolume)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  volume.axesMm = glm::dmat3(1e-7);
  std::string bytes = MrcBytes(volume);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("a.mrc", bytes));
  EXPECT_FALSE(Warns(reader, "stack of 3 images"));
  Put(bytes, 36, std::int32_t(1));
  Read(reader, folder.Write("a.mrcs", bytes));
  EXPECT_TRUE(Warns(reader, "stack of 3 images"));
  ExpectValues(reader, VTK_SHORT, volume.values);
}

TEST(VolumeFormats, SlcAndPvmDecodeTheirCompression)
{
  const TemporaryFolder folder;
  const StoredVolume bytes = StraightVolume(VTK_UNSIGNED_CHAR);
  ExpectStored(folder.Write("a.slc", SlcBytes(bytes, false)), bytes);
  ExpectStored(folder.Write("b.slc", SlcBytes(bytes, true)), bytes);
  ExpectStored(folder.Write("a.pvm", PvmBytes(bytes)), bytes);
  ExpectStored(folder.Write("b.pvm", DdsBytes(PvmBytes(bytes), 1, 1)), bytes);
  StoredVolume shorts = StraightVolume(VTK_UNSIGNED_SHORT);
  shorts.values[7] = 54321;
  ExpectStored(folder.Write("c.pvm", DdsBytes(PvmBytes(shorts), 2, 10)), shorts);
}

TEST(VolumeFormats, ANumPyArrayIsIndexedByZYX)
{
  const TemporaryFolder folder;
  const StoredVolume volume = StraightVolume(VTK_SHORT);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("c.npy", NpyBytes(volume, { 3, 4, 5 })));
  EXPECT_EQ(PositionOf(reader->GetOutput(), 4, 3, 2), glm::dvec3(4.0, 3.0, 2.0));
  EXPECT_TRUE(Warns(reader, "1 mm"));
  // In Fortran's order the first index, z, runs fastest.
  Read(reader, folder.Write("f.npy", NpyBytes(volume, { 5, 4, 3 }, true)));
  EXPECT_EQ(PositionOf(reader->GetOutput(), 4, 3, 2), glm::dvec3(2.0, 3.0, 4.0));
  ExpectValues(reader, VTK_SHORT, volume.values);
}

TEST(VolumeFormats, ANumPyArrayOfFourDimensionsHasComponentsOrVolumes)
{
  const TemporaryFolder folder;
  const StoredVolume volume = StraightVolume(VTK_SHORT);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("components.npy", NpyBytes(volume, { 2, 2, 5, 3 })));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfScalarComponents(), 3);
  ExpectValues(reader, VTK_SHORT, volume.values);
  Read(reader, folder.Write("planar.npy", NpyBytes(volume, { 2, 2, 5, 3 }, true)));
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(1, 0, 0, 2), volume.values[41]);
  Read(reader, folder.Write("times.npy", NpyBytes(volume, { 2, 3, 2, 5 })));
  ExpectValues(reader, VTK_SHORT, { volume.values.begin(), volume.values.begin() + 30 });
  EXPECT_EQ(reader->GetNumberOfTimes(), 2);
  // In Fortran's order the volumes alternate.
  Read(reader, folder.Write("alternating.npy", NpyBytes(volume, { 2, 3, 2, 5 }, true)));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 30);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(1, 0, 0, 0), volume.values[2]);
}

TEST(VolumeFormats, TheFirstOfAlternatingMifVolumesIsRead)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  std::string header = Mif(volume).substr(0, 1024);
  const auto replace = [&](const std::string& from, const std::string& to)
  { header.replace(header.find(from), from.size(), to); };
  // The volumes alternate behind each row.
  replace("dim: 5,4,3", "dim: 5,2,3,2");
  replace("layout: +0,+1,+2", "layout: +0,+2,+3,+1");
  header.resize(1024);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("a.mif", header + VoxelBytes(volume)));
  EXPECT_EQ(reader->GetNumberOfTimes(), 2);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 30);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(2, 0, 0, 0), volume.values[2]);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(2, 1, 0, 0), volume.values[12]);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(2, 0, 1, 0), volume.values[22]);
}

TEST(VolumeFormats, UnknownDistancesOfMifVoxelsAreTheMeanOfTheOthers)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  const auto header = [](const std::string& vox)
  {
    return "mrtrix image\ndim: 5,4,3\n" + vox + "layout: +0,+1,+2\ndatatype: Int16LE\n" +
      "file: voxels 0\nEND\n";
  };
  folder.Write("voxels", VoxelBytes(volume));
  const auto expectSpacing = [&](const std::string& vox, std::array<double, 3> expected)
  {
    vtkNew<vtkVolumeFileReader> reader;
    Read(reader, folder.Write("a.mih", header(vox)));
    EXPECT_TRUE(Warns(reader, "The distance of voxels is not known along ")) << vox;
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(reader->GetOutput()->GetSpacing()[axis], expected[std::size_t(axis)]) << vox;
    }
  };
  expectSpacing("vox: 1,3,nan\n", { 1.0, 3.0, 2.0 });
  expectSpacing("vox: inf,nan,0.5\n", { 0.5, 0.5, 0.5 });
  expectSpacing("vox: 2,3\n", { 2.0, 3.0, 2.5 });
  expectSpacing("", { 1.0, 1.0, 1.0 });
}

TEST(VolumeFormats, ParRecPutsItsSlicesInOrder)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  volume.scalarType = VTK_UNSIGNED_SHORT;
  // Transverse slices lie from left to right, back and head.
  volume.axesMm = glm::dmat3(0.5, 0.0, 0.0, 0.0, 0.75, 0.0, 0.0, 0.0, 2.5);
  StoredVolume stored = volume;
  std::rotate(stored.values.begin(), stored.values.begin() + 40, stored.values.end());
  folder.Write("a.REC", VoxelBytes(stored));
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("a.PAR", ParText(volume, { 2, 0, 1 })));
  ExpectValues(reader, VTK_UNSIGNED_SHORT, volume.values);
  ExpectPlaced(reader, volume, true);
}

TEST(VolumeFormats, MincSlicesHaveTheirOwnScale)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  std::vector<double> real;
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    real.push_back(MincReal(volume.values[i], int(i / 20)));
  }
  for (const auto write : { WriteMinc1, WriteMinc2 })
  {
    vtkNew<vtkVolumeFileReader> reader;
    write(folder.Path("a.mnc"), volume, { true, 2 });
    Read(reader, folder.Path("a.mnc"));
    ExpectValues(reader, VTK_FLOAT, real);
    EXPECT_EQ(reader->GetNumberOfTimes(), 2);
  }
}

// The libraries would read indices behind the end of those that they are given.
TEST(VolumeFormats, MincExtremesAlongOtherAxesAreRefused)
{
  const TemporaryFolder folder;
  for (const auto write : { WriteMinc1, WriteMinc2 })
  {
    const ExpectedVtkErrors errors;
    vtkNew<vtkVolumeFileReader> reader;
    write(folder.Path("a.mnc"), phantom::Stored(0), { true, 0, true });
    reader->SetFileName(folder.Path("a.mnc").c_str());
    reader->Update();
    const std::string message = reader->GetErrorMessage();
    EXPECT_NE(message.find("expected image-min"), std::string::npos) << message;
  }
}

}
