#include "Scene/ImageFiles.h"

#include "Scene/OutputFile.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

std::string EncodedPng(vtkImageData* bytePicture, const std::string& scene)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(bytePicture);
  if (!scene.empty())
  {
    writer->AddText("varimarch-scene", scene.c_str());
  }
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* encoded = writer->GetResult();
  return std::string(reinterpret_cast<const char*>(encoded->GetPointer(0)),
    std::size_t(encoded->GetNumberOfValues()));
}

// A text for the attribute Derivation Description.
std::string DerivationOf(const PictureOrigin& origin)
{
  const RenderOptions& render = origin.render;
  const bool hasTolerance =
    IsOurs(origin.mapper) && !render.HasSampleDistance() && render.errorTolerance > 0.0;
  const bool isCoarse = origin.isPreview || render.level == VolumeLevel::Coarse;
  std::ostringstream text;
  text << "Volume rendering by Varimarch, not for diagnostic use. ";
  if (hasTolerance && !isCoarse)
  {
    text << "Error tolerance of a colour channel: " << render.errorTolerance
         << " of full brightness.";
  }
  else
  {
    text << "The error is not bounded.";
  }
  return text.str();
}

}

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
  return EncodedPng(bytePicture, "");
}

void WritePng(vtkImageData* bytePicture, const std::string& path)
{
  WriteFileWhole(path, PngBytes(bytePicture));
}

std::optional<PictureFormat> PictureFormatOf(const std::string& path)
{
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
  return extension == ".png" ? std::optional(PictureFormat::Png)
    : extension == ".dcm"    ? std::optional(PictureFormat::Dicom)
                             : std::nullopt;
}

void WritePicture(vtkImageData* bytePicture, const PictureOrigin& origin, const std::string& path)
{
  const auto format = PictureFormatOf(path);
  if (!format)
  {
    throw std::runtime_error(path + ": expected a name that ends with .png or .dcm");
  }
  if (*format == PictureFormat::Png)
  {
    WriteFileWhole(path, EncodedPng(bytePicture, origin.scene));
    return;
  }
  WriteFileWhole(path,
    [&](const std::string& part)
    { return WriteSecondaryCapture(bytePicture, DerivationOf(origin), part, origin.identity); });
}

}
