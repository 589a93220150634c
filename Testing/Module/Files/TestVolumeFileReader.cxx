#include "Support/ExpectedVtkErrors.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace
{

const char* const headCt = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
const char* const headMr = "/usr/share/mricron/templates/ch2.nii.gz";

TEST(VolumeFileReader, OpensTheHeadCtOfInvesalius)
{
  if (!std::filesystem::exists(headCt))
  {
    GTEST_SKIP() << headCt << " is missing: install the package invesalius-examples";
  }
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(headCt);
  reader->Update();

  vtkImageData* image = reader->GetOutput();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(image->GetNumberOfPoints(), 256 * 256 * 108);
  EXPECT_EQ(image->GetScalarType(), VTK_SHORT);
  EXPECT_NEAR(image->GetSpacing()[0], 0.957031, 1e-6);
  EXPECT_NEAR(image->GetSpacing()[1], 0.957031, 1e-6);
  EXPECT_EQ(image->GetSpacing()[2], 1.5);
  EXPECT_EQ(image->GetScalarRange()[0], -1024); // air, in Hounsfield units
  EXPECT_EQ(image->GetScalarRange()[1], 2986);  // tooth
  // Rows run from the back of the head to the front, which is -y in LPS.
  EXPECT_EQ(image->GetDirectionMatrix()->GetElement(1, 1), -1.0);
  EXPECT_STREQ(reader->GetModality(), "CT");
  EXPECT_EQ(reader->GetWindow(), 406.0);
  EXPECT_EQ(reader->GetLevel(), -18.0);
}

TEST(VolumeFileReader, OpensTheHeadMrOfMricron)
{
  if (!std::filesystem::exists(headMr))
  {
    GTEST_SKIP() << headMr << " is missing: install the package mricron-data";
  }
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(headMr);
  reader->Update();

  vtkImageData* image = reader->GetOutput();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  EXPECT_EQ(image->GetNumberOfPoints(), 181 * 217 * 181);
  EXPECT_EQ(image->GetScalarType(), VTK_UNSIGNED_CHAR);
  // The template of Colin Holmes' head has voxel (0, 0, 0) at (-90, -125, -71) mm in RAS.
  EXPECT_EQ(image->GetOrigin()[0], 90.0);
  EXPECT_EQ(image->GetOrigin()[1], 125.0);
  EXPECT_EQ(image->GetOrigin()[2], -71.0);
  EXPECT_EQ(image->GetDirectionMatrix()->GetElement(0, 0), -1.0);
  EXPECT_EQ(image->GetDirectionMatrix()->GetElement(1, 1), -1.0);
  EXPECT_EQ(image->GetDirectionMatrix()->GetElement(2, 2), 1.0);
}

TEST(VolumeFileReader, AMissingFileIsOneErrorAndAnEmptyOutput)
{
  ExpectedVtkErrors errors;
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName("/nowhere/head.nii");
  reader->Update();
  reader->Update();

  EXPECT_EQ(errors.Messages().size(), 1u) << errors.Text();
  EXPECT_EQ(reader->GetErrorCode(), (unsigned long)vtkErrorCode::FileNotFoundError);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_STREQ(reader->GetErrorMessage(),
    "Cannot read \"/nowhere/head.nii\": expected an existing file, found no file of this name.");
}

}
