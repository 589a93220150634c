// NIfTI and Analyze headers that are incomplete, contradict themselves, or hold more than a volume.
// The right values are those of nibabel, except where the test says otherwise.
#include "PhantomFiles.h"
#include "VolumeRead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numeric>

namespace
{

// Offsets from nifti1.h.
constexpr std::size_t dimOffset = 40;
constexpr std::size_t intentOffset = 68;
constexpr std::size_t typeOffset = 70;
constexpr std::size_t pixdimOffset = 76;
constexpr std::size_t voxelOffset = 108;
constexpr std::size_t quaternionCode = 252;
constexpr std::size_t affineCode = 254;
constexpr std::size_t affineRows = 280;

void PutDimensions(std::string& bytes, const std::vector<int>& dimensions)
{
  Put(bytes, dimOffset, std::int16_t(dimensions.size()));
  for (std::size_t i = 0; i < dimensions.size(); ++i)
  {
    Put(bytes, dimOffset + 2 + 2 * i, std::int16_t(dimensions[i]));
  }
}

class NiftiVariants : public testing::Test
{
protected:
  VolumeRead Read(const std::string& bytes)
  {
    return ReadVolumeAt(this->folder.Write("variant.nii", bytes));
  }

  TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  const std::string affine = NiftiBytes(volume, NiftiForm::Affine);
  const std::string quaternion = NiftiBytes(volume, NiftiForm::Quaternion);
};

TEST_F(NiftiVariants, AnInvalidAffineGivesWayToTheQuaternion)
{
  const VolumeRead right = this->Read(this->quaternion);
  for (const float wrong : { 0.0f, std::nanf("") })
  {
    std::string bytes = this->quaternion;
    Put(bytes, affineCode, std::int16_t(1));
    for (std::size_t i = 0; i < 12; ++i)
    {
      Put(bytes, affineRows + 4 * i, wrong);
    }
    const VolumeRead read = this->Read(bytes);
    EXPECT_EQ(read.originMm, right.originMm) << read.error;
    EXPECT_TRUE(read.WarnsOf("the qform was used")) << read.warnings;
  }
}

TEST_F(NiftiVariants, AQuaternionThatContradictsTheAffineIsWarnedOf)
{
  std::string both = this->affine;
  std::memcpy(both.data() + quaternionCode, this->quaternion.data() + quaternionCode, 2);
  std::memcpy(both.data() + 256, this->quaternion.data() + 256, 24);
  EXPECT_FALSE(this->Read(both).WarnsOf("mirrored"));
  Put(both, pixdimOffset, -1.0f);
  const VolumeRead read = this->Read(both);
  EXPECT_TRUE(read.WarnsOf("mirrored")) << read.warnings;
  EXPECT_EQ(read.originMm, this->Read(this->affine).originMm);
}

TEST_F(NiftiVariants, VoxelsNeverBeginInsideTheHeader)
{
  // nibabel shows the header's bytes as voxels.
  std::string bytes = this->affine;
  Put(bytes, voxelOffset, 0.0f);
  const VolumeRead read = this->Read(bytes);
  EXPECT_EQ(read.values, this->volume.values);
  EXPECT_TRUE(read.WarnsOf("byte 352")) << read.warnings;
}

/// Product of the sizes of the axes behind the volume.
int VolumesOf(const std::vector<int>& dimensions)
{
  return std::accumulate(dimensions.begin() + 3, dimensions.end(), 1, std::multiplies<>());
}

TEST_F(NiftiVariants, TheFirstOfTheVolumesOfAllFurtherAxesIsRead)
{
  for (const std::vector<int>& dimensions :
    { std::vector<int>{ 5, 4, 3, 2 }, { 5, 4, 3, 2, 3 }, { 5, 4, 3, 1, 1, 4 }, { 5, 4, 3, 1, 7 } })
  {
    std::string bytes = this->affine;
    PutDimensions(bytes, dimensions);
    bytes += std::string(20 * 120, 'x');
    const VolumeRead read = this->Read(bytes);
    EXPECT_EQ(read.values, this->volume.values) << read.error;
    EXPECT_EQ(read.timeCount, VolumesOf(dimensions));
  }
}

TEST_F(NiftiVariants, AShortFifthAxisHoldsComponents)
{
  std::string bytes = this->affine;
  PutDimensions(bytes, { 5, 4, 3, 1, 2 });
  bytes += VoxelBytes(phantom::Stored(1));
  const VolumeRead read = this->Read(bytes);
  ASSERT_EQ(read.componentCount, 2) << read.error;
  EXPECT_EQ(read.values[2], this->volume.values[1]);
  EXPECT_EQ(read.values[3], phantom::Stored(1).values[1]);
}

TEST_F(NiftiVariants, ComplexNumbersAreReadByTheirMagnitude)
{
  StoredVolume floats = this->volume;
  floats.scalarType = VTK_FLOAT;
  std::string bytes = NiftiBytes(floats).substr(0, 352);
  Put(bytes, typeOffset, std::int16_t(32));
  for (int voxel = 0; voxel < 60; ++voxel)
  {
    const float pair[2] = { 3.0f * float(voxel), 4.0f * float(voxel) };
    bytes.append(reinterpret_cast<const char*>(pair), sizeof(pair));
  }
  const VolumeRead read = this->Read(bytes);
  ASSERT_EQ(read.values.size(), 60u) << read.error;
  EXPECT_EQ(read.values[7], 35.0);
  EXPECT_TRUE(read.WarnsOf("complex"));
}

TEST_F(NiftiVariants, AMissingVoxelSizeIsOneMillimetreWithAWarning)
{
  std::string bytes = this->affine;
  Put(bytes, affineCode, std::int16_t(0));
  Put(bytes, pixdimOffset + 12, 0.0f);
  const VolumeRead read = this->Read(bytes);
  EXPECT_EQ(read.spacingMm.z, 1.0) << read.error;
  EXPECT_TRUE(read.WarnsOf("how large a voxel is"));

  PutDimensions(bytes, { 5, 4 });
  const VolumeRead slice = this->Read(bytes);
  EXPECT_EQ(slice.spacingMm.z, 1.0) << slice.error;
  EXPECT_FALSE(slice.WarnsOf("how large a voxel is")) << "a slice has no third axis";
}

TEST_F(NiftiVariants, WhatIsNoVolumeIsNamed)
{
  std::string cifti = this->affine;
  Put(cifti, intentOffset, std::int16_t(3001));
  EXPECT_NE(this->Read(cifti).error.find("CIFTI"), std::string::npos);
  std::string longFloats = this->affine;
  Put(longFloats, typeOffset, std::int16_t(1536));
  EXPECT_NE(this->Read(longFloats).error.find("128 bits"), std::string::npos);
}

TEST_F(NiftiVariants, AnalyzeIsReadByEitherOfItsFiles)
{
  for (const bool isBig : { false, true })
  {
    this->folder.Write("head.hdr", AnalyzeHeaderBytes(this->volume, { 0, 0, 0 }, isBig));
    this->folder.Write("head.img", VoxelBytes(this->volume, isBig));
    for (const char* name : { "head.hdr", "head.img" })
    {
      const VolumeRead read = ReadVolumeAt(this->folder.Path(name));
      EXPECT_EQ(read.values, this->volume.values) << read.error;
      EXPECT_NEAR(read.spacingMm.z, 2.5, 1e-6);
      EXPECT_TRUE(read.WarnsOf("mirrored"));
    }
  }
}

TEST_F(NiftiVariants, TheOriginOfSpmPlacesAnalyze)
{
  this->folder.Write("head.img", VoxelBytes(this->volume));
  const VolumeRead read =
    ReadVolumeAt(this->folder.Write("head.hdr", AnalyzeHeaderBytes(this->volume, { 2, 3, 1 })));
  // Voxel (2, 3, 1), counted from 1, is at the origin; the first axis points to the left.
  EXPECT_NEAR(read.originMm.x, -0.7, 1e-6) << read.error;
  EXPECT_NEAR(read.originMm.y, 2 * 1.1, 1e-6);
  EXPECT_NEAR(read.originMm.z, 0.0, 1e-6);
}

TEST_F(NiftiVariants, AMatrixFileThatCannotBeReadIsWarnedOf)
{
  this->folder.Write("head.img", VoxelBytes(this->volume));
  this->folder.Write("head.mat", "MATLAB 5.0 MAT-file");
  const VolumeRead read =
    ReadVolumeAt(this->folder.Write("head.hdr", AnalyzeHeaderBytes(this->volume)));
  EXPECT_EQ(read.values, this->volume.values) << read.error;
  EXPECT_TRUE(read.WarnsOf("head.mat")) << read.warnings;
}

TEST_F(NiftiVariants, TheMarkOfAPairIsIgnoredInAFileOfItsOwn)
{
  std::string bytes = NiftiBytes(this->volume);
  bytes.replace(344, 3, "ni1");
  const VolumeRead read = this->Read(bytes);
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.values, this->volume.values);
}

}
