#include "PublishedVolumes.h"

#include <vtkImageResize.h>
#include <vtkImageShiftScale.h>
#include <vtkNew.h>

#include <algorithm>

namespace varimarch
{

namespace
{

// The range of values becomes that of a byte.
vtkSmartPointer<vtkImageData> Bytes(vtkImageData* image)
{
  const double* const range = image->GetScalarRange();
  vtkNew<vtkImageShiftScale> bytes;
  bytes->SetInputData(image);
  bytes->SetShift(-range[0]);
  bytes->SetScale(255.0 / std::max(range[1] - range[0], 1e-30));
  bytes->SetOutputScalarTypeToUnsignedChar();
  bytes->ClampOverflowOn();
  bytes->Update();
  return bytes->GetOutput();
}

}

const char* const VisMaleFile = "vismale/vismale_128x256x256_uint8.mhd";

const std::vector<PublishedDataSet>& PublishedDataSets()
{
  static const std::vector<PublishedDataSet> all = {
    { "SKULL", 256, "ct_skull_phantom/dicom", "another skull, of plastic, 512 x 512 x 140",
      { { 40, 60.0 }, { 60, 59.8 }, { 80, 26.5 }, { 120, 11.1 } },
      PublishedRates{ "48", "59", "1.23" } },
    { "MRI HEAD", 256, "mr_head_studyforrest/mr_head_studyforrest_274x384x384_int16.mha",
      "another head, 274 x 384 x 384", { { 40, 60.0 }, { 60, 54.8 }, { 80, 23.2 }, { 120, 10.3 } },
      PublishedRates{ "50", "60", "1.20" } },
    { "VIS MALE", 128, VisMaleFile, "the same, 128 x 256 x 256", { { 80, 60.0 } },
      PublishedRates{ "45", "> 60", "> 1.33" } },
    { "VIS MALE", 256, VisMaleFile, "the same, 128 x 256 x 256", { { 120, 32.1 } }, std::nullopt },
    { "BONZAI", 256, "bonsai/bonsai_256x256x256_uint8.mhd", "the same", {},
      PublishedRates{ "30", "55", "1.83" } },
    { "TOOTH", 64, "tooth/tooth_103x94x161_uint8.mhd", "the same, 103 x 94 x 161", {},
      PublishedRates{ "> 60", "> 60", "not known" } },
  };
  return all;
}

LoadedVolume LoadAtSize(const std::string& path, int side)
{
  LoadedVolume volume = LoadVolume(FileSource{ path, std::nullopt });
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(volume.image);
  resize->SetOutputDimensions(side, side, side);
  resize->Update();
  const auto resized = Bytes(resize->GetOutput());
  resized->SetDirectionMatrix(volume.image->GetDirectionMatrix());
  volume.image = resized;
  return volume;
}

}
