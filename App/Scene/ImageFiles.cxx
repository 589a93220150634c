#include "Scene/ImageFiles.h"

#include "Scene/OutputFile.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

vtkSmartPointer<vtkImageData> BytesOver(
  vtkImageData* floatPicture, const std::array<double, 3>& background)
{
  auto bytes = vtkSmartPointer<vtkImageData>::New();
  bytes->SetDimensions(floatPicture->GetDimensions());
  bytes->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* rgba = static_cast<const float*>(floatPicture->GetScalarPointer());
  auto* rgb = static_cast<unsigned char*>(bytes->GetScalarPointer());
  for (vtkIdType pixel = 0; pixel < bytes->GetNumberOfPoints(); ++pixel, rgba += 4)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double value = rgba[channel] + (1.0 - rgba[3]) * background[channel];
      *rgb++ = static_cast<unsigned char>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
    }
  }
  return bytes;
}

std::string PngBytes(vtkImageData* bytePicture)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(bytePicture);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* encoded = writer->GetResult();
  return std::string(reinterpret_cast<const char*>(encoded->GetPointer(0)),
    std::size_t(encoded->GetNumberOfValues()));
}

void WritePng(vtkImageData* bytePicture, const std::string& path)
{
  WriteFileWhole(path, PngBytes(bytePicture));
}

}
