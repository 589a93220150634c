// The phantom must lie in the same place for every stored order and direction of its axes.
#include "PhantomFormats.h"
#include "PhantomLibraryFiles.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkVolumeFileReader.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <functional>

namespace
{

/// Requires that every voxel has the phantom's value at its position.
void ExpectPhantomInPlace(const std::string& path)
{
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfPoints(), 5 * 4 * 3);
  EXPECT_EQ(image->GetExtent()[0], 0);
  EXPECT_EQ(image->GetExtent()[2], 0);
  EXPECT_EQ(image->GetExtent()[4], 0);
  int wrong = 0;
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    const int* dimensions = image->GetDimensions();
    const int i = int(point) % dimensions[0];
    const int j = int(point) / dimensions[0] % dimensions[1];
    const int k = int(point) / dimensions[0] / dimensions[1];
    glm::dvec3 worldMm;
    image->TransformIndexToPhysicalPoint(i, j, k, &worldMm[0]);
    const glm::dvec3 index = phantom::IndexAt(worldMm);
    const glm::dvec3 nearest = glm::round(index);
    const bool isThere = glm::distance(index, nearest) < 1e-4;
    const bool isRight =
      phantom::ValueAt(glm::ivec3(nearest)) == image->GetScalarComponentAsDouble(i, j, k, 0);
    wrong += isThere && isRight ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
}

/// Writes the phantom in each orientation; `write` returns the path to read.
void ExpectAllOrientationsInPlace(
  const std::function<std::string(const TemporaryFolder&, const StoredVolume&)>& write)
{
  for (int orientation = 0; orientation < phantom::orientationCount; ++orientation)
  {
    SCOPED_TRACE("orientation " + std::to_string(orientation));
    const TemporaryFolder folder;
    ExpectPhantomInPlace(write(folder, phantom::Stored(orientation)));
  }
}

TEST(VolumeFileGeometry, NrrdStaysInPlaceInEverySpace)
{
  for (const char* space : { "LPS", "RAS", "LAS", "RPS" })
  {
    SCOPED_TRACE(space);
    ExpectAllOrientationsInPlace(
      [&](const TemporaryFolder& folder, const StoredVolume& volume)
      {
        return folder.Write("phantom.nrrd",
          NrrdHeaderText(volume, space) + "endian: little\nencoding: raw\n\n" + VoxelBytes(volume));
      });
  }
}

TEST(VolumeFileGeometry, MetaImageStaysInPlace)
{
  ExpectAllOrientationsInPlace(
    [](const TemporaryFolder& folder, const StoredVolume& volume)
    {
      return folder.Write("phantom.mha",
        MetaImageHeaderText(volume) + "ElementDataFile = LOCAL\n" + VoxelBytes(volume));
    });
}

TEST(VolumeFileGeometry, NiftiStaysInPlaceByItsAffineForm)
{
  ExpectAllOrientationsInPlace([](const TemporaryFolder& folder, const StoredVolume& volume)
    { return folder.Write("phantom.nii", NiftiBytes(volume, NiftiForm::Affine)); });
}

TEST(VolumeFileGeometry, NiftiStaysInPlaceByItsQuaternionForm)
{
  ExpectAllOrientationsInPlace([](const TemporaryFolder& folder, const StoredVolume& volume)
    { return folder.Write("phantom.nii", NiftiBytes(volume, NiftiForm::Quaternion)); });
}

TEST(VolumeFileGeometry, Nifti2StaysInPlace)
{
  ExpectAllOrientationsInPlace([](const TemporaryFolder& folder, const StoredVolume& volume)
    { return folder.Write("phantom.nii", Nifti2Bytes(volume)); });
}

TEST(VolumeFileGeometry, DicomStaysInPlaceWhateverTheOrderOfItsFiles)
{
  ExpectAllOrientationsInPlace(
    [](const TemporaryFolder& folder, const StoredVolume& volume)
    {
      for (int slice = 0; slice < volume.dimensions[2]; ++slice)
      {
        folder.Write("images/" + std::to_string(slice), DicomBytes(volume, slice));
      }
      return folder.Path("images");
    });
}

TEST(VolumeFileGeometry, MghStaysInPlace)
{
  ExpectAllOrientationsInPlace([](const TemporaryFolder& folder, const StoredVolume& volume)
    { return folder.Write("phantom.mgh", MghBytes(volume)); });
}

TEST(VolumeFileGeometry, AfniStaysInPlace)
{
  ExpectAllOrientationsInPlace(
    [](const TemporaryFolder& folder, const StoredVolume& volume)
    {
      folder.Write("phantom+orig.BRIK", VoxelBytes(volume));
      return folder.Write("phantom+orig.HEAD", AfniHeaderText(volume));
    });
}

TEST(VolumeFileGeometry, MifStaysInPlaceWhateverTheStrides)
{
  ExpectAllOrientationsInPlace(
    [](const TemporaryFolder& folder, const StoredVolume& volume)
    {
      return folder.Write("phantom.mif",
        MifHeaderText(volume, { 2, 0, 1 }, { true, false, true }) + VoxelBytes(volume));
    });
}

TEST(VolumeFileGeometry, MincStaysInPlace)
{
  for (const auto write : { WriteMinc1, WriteMinc2 })
  {
    ExpectAllOrientationsInPlace(
      [&](const TemporaryFolder& folder, const StoredVolume& volume)
      {
        write(folder.Path("phantom.mnc"), volume, {});
        return folder.Path("phantom.mnc");
      });
  }
}

TEST(VolumeFileGeometry, VtiStaysInPlaceWhereverItsExtentBegins)
{
  ExpectAllOrientationsInPlace(
    [](const TemporaryFolder& folder, const StoredVolume& volume) {
      return folder.Write("phantom.vti", VtiText(volume, { -3, 7, 0 }));
    });
}

TEST(VolumeFileGeometry, CellsOfVtiStayInPlace)
{
  ExpectAllOrientationsInPlace([](const TemporaryFolder& folder, const StoredVolume& volume)
    { return folder.Write("phantom.vti", VtiCellText(volume)); });
}

/// Writes a volume as two pieces of VTI, one behind the other along the last axis, and the file
/// that names them.
std::string WriteInPieces(const TemporaryFolder& folder, const StoredVolume& volume)
{
  const int cut = 1;
  const auto layerValues = std::ptrdiff_t(volume.dimensions[0]) * volume.dimensions[1];
  StoredVolume lower = volume;
  lower.dimensions[2] = cut;
  lower.values.resize(std::size_t(cut * layerValues));
  StoredVolume upper = volume;
  upper.dimensions[2] -= cut;
  upper.values.erase(upper.values.begin(), upper.values.begin() + cut * layerValues);
  upper.originMm += double(cut) * upper.axesMm[2];
  folder.Write("lower.vti", VtiText(lower));
  folder.Write("upper.vti", VtiText(upper, { 0, 0, cut }));
  return folder.Write("phantom.pvti",
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"PImageData\" version=\"0.1\">\n"
    "<PImageData WholeExtent=\"0 4 0 3 0 2\">\n<Piece Source=\"upper.vti\"/>\n"
    "<Piece Source=\"lower.vti\"/>\n</PImageData>\n</VTKFile>\n");
}

TEST(VolumeFileGeometry, PiecesOfVtiStayInPlace)
{
  ExpectAllOrientationsInPlace(WriteInPieces);
}

TEST(VolumeFileGeometry, AnalyzeStaysInPlaceByTheMatrixOfSpm)
{
  ExpectAllOrientationsInPlace(
    [](const TemporaryFolder& folder, const StoredVolume& volume)
    {
      folder.Write("phantom.hdr", AnalyzeHeaderBytes(volume));
      folder.Write("phantom.mat", SpmMatrixBytes(volume));
      return folder.Write("phantom.img", VoxelBytes(volume));
    });
}

TEST(VolumeFileGeometry, PackedFilesStayInPlace)
{
  ExpectAllOrientationsInPlace(
    [](const TemporaryFolder& folder, const StoredVolume& volume) {
      return folder.Write("phantom.zip", Archived({ { "a.nii", NiftiBytes(volume) } }, "zip"));
    });
}

}
