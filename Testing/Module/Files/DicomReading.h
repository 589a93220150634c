#ifndef Varimarch_Testing_DicomReading_h
#define Varimarch_Testing_DicomReading_h

#include "PhantomDicom.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

/// A folder of DICOM files, and a reader for it.
class DicomReading : public testing::Test
{
protected:
  void Write(const std::string& name, const phantom_dicom::Elements& elements,
    const std::string& syntax = phantom_dicom::ExplicitSyntax)
  {
    this->folder.Write("scan/" + name, phantom_dicom::FileBytes(elements, syntax));
  }

  /// Attributes of a slice of the phantom with an instance UID of its own.
  static phantom_dicom::Elements Slice(int slice, int instance = 0)
  {
    DicomOptions options;
    options.instance = instance;
    return phantom_dicom::SliceElements(phantom::Stored(0), slice, options);
  }

  /// Reads the folder, or a file in it.
  vtkImageData* Read(const std::string& name = {})
  {
    this->reader->SetFileName(this->folder.Path(name.empty() ? "scan" : "scan/" + name).c_str());
    this->reader->Modified();
    this->reader->Update();
    return this->reader->GetOutput();
  }

  std::string Warnings()
  {
    std::string all;
    for (vtkIdType i = 0; i < this->reader->GetWarnings()->GetNumberOfValues(); ++i)
    {
      all += this->reader->GetWarnings()->GetValue(i) + "\n";
    }
    return all;
  }

  void ExpectWarning(const std::string& words)
  {
    EXPECT_NE(this->Warnings().find(words), std::string::npos) << this->Warnings();
  }

  /// Expects the phantom itself, which no other choice of slices makes.
  void ExpectPhantom(double added = 0.0)
  {
    vtkImageData* const image = this->reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfPoints(), 60) << this->reader->GetErrorMessage();
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(
        image->GetScalarComponentAsDouble(1, 2, k, 0), phantom::ValueAt({ 1, 2, k }) + added)
        << "slice " << k;
      double placeMm[3];
      image->TransformIndexToPhysicalPoint(1, 2, k, placeMm);
      const glm::dvec3 index = phantom::IndexAt({ placeMm[0], placeMm[1], placeMm[2] });
      EXPECT_NEAR(glm::distance(index, glm::dvec3(1, 2, k)), 0.0, 1e-5) << "slice " << k;
    }
  }

  TemporaryFolder folder;
  vtkNew<vtkVolumeFileReader> reader;
};

#endif
