#include "Scene/Images/ImageFiles.h"

#include "Scene/Files/OutputFile.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtksys/SystemTools.hxx>

#include <gdcmDataElement.h>
#include <gdcmDataSet.h>
#include <gdcmElement.h>
#include <gdcmUIDGenerator.h>
#include <gdcmWriter.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <vector>

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

namespace
{

using gdcm::VR;

struct TextAttribute
{
  gdcm::Tag tag;
  VR::VRType representation;
  std::string text;
};

struct NumberAttribute
{
  gdcm::Tag tag;
  std::uint16_t number;
};

// A copy, since the generator uses the memory of a UID again for the next one.
std::string NewUid()
{
  gdcm::UIDGenerator generator;
  return generator.Generate();
}

// The patient and the study. Each must be there, but may be empty, except the UID.
std::vector<TextAttribute> IdentityAttributes(const CaptureIdentity& identity)
{
  std::vector<TextAttribute> attributes = {
    // The patient's name, identity, date of birth and sex.
    { { 0x0010, 0x0010 }, VR::PN, "" }, { { 0x0010, 0x0020 }, VR::LO, "" },
    { { 0x0010, 0x0030 }, VR::DA, "" }, { { 0x0010, 0x0040 }, VR::CS, "" },
    { { 0x0020, 0x000d }, VR::UI, NewUid() }, // study
    { { 0x0008, 0x0020 }, VR::DA, "" },       // date of the study
    { { 0x0008, 0x0030 }, VR::TM, "" },       // time of the study
    { { 0x0008, 0x0050 }, VR::SH, "" },       // accession number
    { { 0x0008, 0x0090 }, VR::PN, "" },       // referring physician
    { { 0x0020, 0x0010 }, VR::SH, "" },       // study ID
  };
  for (TextAttribute& attribute : attributes)
  {
    const auto given = identity.find(attribute.tag.GetElementTag());
    if (given != identity.end())
    {
      attribute.text = given->second;
    }
  }
  return attributes;
}

// The image and its series.
std::vector<TextAttribute> ImageAttributes(const std::string& derivation)
{
  return {
    { { 0x0008, 0x0016 }, VR::UI, "1.2.840.10008.5.1.4.1.1.7" },
    { { 0x0008, 0x0018 }, VR::UI, NewUid() },
    { { 0x0020, 0x000e }, VR::UI, NewUid() },
    { { 0x0008, 0x0060 }, VR::CS, "OT" },
    { { 0x0020, 0x0011 }, VR::IS, "1" },
    { { 0x0020, 0x0013 }, VR::IS, "1" },
    { { 0x0008, 0x0008 }, VR::CS, "DERIVED\\SECONDARY" },
    { { 0x0008, 0x2111 }, VR::ST, derivation },
    { { 0x0008, 0x0064 }, VR::CS, "WSD" },
    { { 0x0018, 0x1016 }, VR::LO, "Varimarch" },
    { { 0x0028, 0x0301 }, VR::CS, "NO" },
    { { 0x0020, 0x0020 }, VR::CS, "" }, // patient orientation, which may be empty
    { { 0x0020, 0x0060 }, VR::CS, "" }, // laterality, which may be empty
    { { 0x0028, 0x0004 }, VR::CS, "RGB" },
  };
}

std::vector<TextAttribute> TextAttributes(
  const std::string& derivation, const CaptureIdentity& identity)
{
  std::vector<TextAttribute> attributes = IdentityAttributes(identity);
  for (const TextAttribute& attribute : ImageAttributes(derivation))
  {
    attributes.push_back(attribute);
  }
  if (identity.empty())
  {
    // Nothing in the image names the patient or a date.
    attributes.push_back({ { 0x0012, 0x0062 }, VR::CS, "YES" });
    attributes.push_back({ { 0x0012, 0x0063 }, VR::LO, "No attribute of the scan is copied" });
  }
  else
  {
    attributes.push_back({ { 0x0008, 0x0005 }, VR::CS, "ISO_IR 192" }); // UTF-8
  }
  return attributes;
}

// The numbers of the module Image Pixel.
std::vector<NumberAttribute> NumberAttributes(int columns, int rows)
{
  return {
    { { 0x0028, 0x0002 }, 3 }, // samples per pixel
    { { 0x0028, 0x0006 }, 0 }, // colours of a pixel lie together
    { { 0x0028, 0x0010 }, std::uint16_t(rows) }, { { 0x0028, 0x0011 }, std::uint16_t(columns) },
    { { 0x0028, 0x0100 }, 8 }, // bits allocated
    { { 0x0028, 0x0101 }, 8 }, // bits stored
    { { 0x0028, 0x0102 }, 7 }, // high bit
    { { 0x0028, 0x0103 }, 0 }, // unsigned
  };
}

// DICOM's values have even lengths: texts are padded with spaces, and all others with zeros.
gdcm::DataElement Element(const gdcm::Tag& tag, VR::VRType representation, std::string bytes)
{
  const bool isText = representation != VR::UI && representation != VR::OB;
  bytes.resize(bytes.size() + bytes.size() % 2, isText ? ' ' : '\0');
  gdcm::DataElement element(tag, 0, representation);
  element.SetByteValue(bytes.data(), std::uint32_t(bytes.size()));
  return element;
}

gdcm::DataElement Element(const NumberAttribute& attribute)
{
  gdcm::Element<VR::US, gdcm::VM::VM1> number;
  number.SetValue(attribute.number);
  gdcm::DataElement element = number.GetAsDataElement();
  element.SetTag(attribute.tag);
  return element;
}

// DICOM's first row is the uppermost.
std::string BytesFromTheTop(vtkImageData* picture)
{
  const int rowCount = picture->GetDimensions()[1];
  const std::size_t rowBytes = 3 * std::size_t(picture->GetDimensions()[0]);
  std::string bytes;
  bytes.reserve(rowCount * rowBytes + 1);
  for (int row = rowCount - 1; row >= 0; --row)
  {
    bytes.append(static_cast<const char*>(picture->GetScalarPointer(0, row, 0)), rowBytes);
  }
  return bytes;
}

}

bool WriteSecondaryCapture(vtkImageData* bytePicture, const std::string& derivation,
  const std::string& path, const CaptureIdentity& identity)
{
  gdcm::Writer writer;
  gdcm::DataSet& data = writer.GetFile().GetDataSet();
  for (const TextAttribute& attribute : TextAttributes(derivation, identity))
  {
    data.Insert(Element(attribute.tag, attribute.representation, attribute.text));
  }
  const int* const size = bytePicture->GetDimensions();
  for (const NumberAttribute& attribute : NumberAttributes(size[0], size[1]))
  {
    data.Insert(Element(attribute));
  }
  data.Insert(Element({ 0x7fe0, 0x0010 }, VR::OB, BytesFromTheTop(bytePicture)));
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(
    gdcm::TransferSyntax::ExplicitVRLittleEndian);
  writer.SetFileName(path.c_str());
  return writer.Write();
}

}
