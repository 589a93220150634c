#include "Fuzz/ReadInput.h"

#include "Fuzz/FuzzTarget.h"
#include "Scene/Json/SceneNames.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkVolumeFileReader.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

void RequireSentence(const std::string& message)
{
  RequireOneLine(message);
  Require(message.find("Cannot read \"") == 0 && message.find(": expected ") != message.npos &&
      message.find(", found ") != message.npos && message.back() == '.',
    "the error is not a sentence of what was expected and found: " + message);
}

void RequireImage(vtkImageData* image)
{
  Require(image->GetNumberOfPoints() > 0, "there is neither an image nor an error");
  const int* const extent = image->GetExtent();
  Require(extent[0] == 0 && extent[2] == 0 && extent[4] == 0, "the extent does not begin at 0");
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  Require(scalars && scalars->GetNumberOfTuples() == image->GetNumberOfPoints(),
    "the image has no value for each voxel");
  const int componentCount = scalars->GetNumberOfComponents();
  Require(componentCount >= 1 && componentCount <= 4, "the voxels do not have 1 to 4 components");
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = image->GetSpacing()[axis];
    Require(spacing > 0.0 && std::isfinite(spacing), "the spacing is not finite and > 0");
    Require(std::isfinite(image->GetOrigin()[axis]), "the origin is not finite");
  }
  const double determinant = image->GetDirectionMatrix()->Determinant();
  Require(std::isfinite(determinant) && determinant != 0.0, "the axes do not span space");
}

void CountError(vtkObject*, unsigned long, void* count, void*)
{
  ++*static_cast<int*>(count);
}

}

bool ReadInput(const std::string& path, const RawLayout* raw)
{
  // The reader's errors go to its observer; VTK would log them besides.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  int errorCount = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(CountError);
  observer->SetClientData(&errorCount);
  vtkNew<vtkVolumeFileReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->SetFileName(path.c_str());
  // A library that hangs is ended before libFuzzer takes it for a fault.
  reader->SetLongestSilence(20.0);
  if (raw)
  {
    reader->SetRawDimensions(raw->dimensions.data());
    reader->SetRawScalarType(ValueOf(RawTypeNames(), raw->type));
    reader->SetRawSpacing(raw->spacingMm.data());
    reader->SetRawHeaderBytes(raw->headerBytes);
    reader->SetRawBigEndian(raw->bigEndian);
  }
  reader->Update();
  const std::string message = reader->GetErrorMessage();
  Require(
    errorCount == (message.empty() ? 0 : 1) && (reader->GetErrorCode() == 0) == message.empty(),
    "there is not one event and one code for an error: " + message);
  if (message.empty())
  {
    RequireImage(reader->GetOutput());
    return true;
  }
  Require(reader->GetOutput()->GetNumberOfPoints() == 0, "an image that failed is not empty");
  RequireSentence(message);
  return false;
}

}
