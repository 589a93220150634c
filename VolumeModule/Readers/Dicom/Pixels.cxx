#include "Readers/Dicom/Pixels.h"

#include "Readers/Dicom/GdcmCopy.h"
#include "Readers/FileError.h"
#include "Readers/Parsing/VtkMessages.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMReader.h>
#include <vtkDICOMSliceSorter.h>
#include <vtkDICOMUtilities.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkObjectFactory.h>

#include <gdcmImageReader.h>

#include <algorithm>
#include <exception>
#include <map>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace varimarch
{
namespace
{

/// A vtkDICOMReader that fails if GDCM cannot decode compressed pixels. That of vtk-dicom 0.8.14
/// ignores this, so that its image is black, and lets GDCM write more than its buffer holds.
class vtkCheckedDICOMReader : public vtkDICOMReader
{
public:
  static vtkCheckedDICOMReader* New();
  vtkTypeMacro(vtkCheckedDICOMReader, vtkDICOMReader);

protected:
  bool ReadFileDelegated(
    const char* path, int index, unsigned char* buffer, vtkIdType bufferSize) override;
};

vtkStandardNewMacro(vtkCheckedDICOMReader);

bool vtkCheckedDICOMReader::ReadFileDelegated(
  const char* path, int, unsigned char* buffer, vtkIdType bufferSize)
{
  gdcm::ImageReader reader;
  reader.SetFileName(path);
  const bool isRead = reader.Read();
  const auto wanted = std::size_t(bufferSize);
  const std::size_t decoded = isRead ? reader.GetImage().GetBufferLength() : 0;
  bool isDecoded = false;
  if (isRead && decoded == wanted)
  {
    isDecoded = reader.GetImage().GetBuffer(reinterpret_cast<char*>(buffer));
  }
  else if (decoded > wanted)
  {
    std::vector<char> all(decoded);
    isDecoded = reader.GetImage().GetBuffer(all.data());
    std::copy_n(all.begin(), bufferSize, buffer);
  }
  if (!isDecoded)
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
  }
  return isDecoded;
}

constexpr const char* RunLengthSyntax = "1.2.840.10008.1.2.5";

/// Names of codings that are younger than vtk-dicom's list.
const std::map<std::string, std::string> YoungSyntaxes = {
  { "1.2.840.10008.1.2.4.110", "JPEG XL Lossless" },
  { "1.2.840.10008.1.2.4.111", "JPEG XL JPEG Recompression" },
  { "1.2.840.10008.1.2.4.112", "JPEG XL" },
  { "1.2.840.10008.1.2.4.201", "High-Throughput JPEG 2000 (Lossless Only)" },
  { "1.2.840.10008.1.2.4.202", "High-Throughput JPEG 2000 with RPCL Options (Lossless Only)" },
  { "1.2.840.10008.1.2.4.203", "High-Throughput JPEG 2000" },
};

/// "JPEG 2000 Image Compression (1.2.840.10008.1.2.4.91)", or only the UID if it has no known name.
std::string SyntaxName(const std::string& uid)
{
  constexpr std::size_t LongestUid = 64;
  const auto young = YoungSyntaxes.find(uid);
  const std::string name = young != YoungSyntaxes.end()
    ? young->second
    : std::string(vtkDICOMUtilities::GetUIDName(uid.c_str()));
  return name.empty() ? Quoted(uid, LongestUid) : name + " (" + uid + ")";
}

DicomFault DamagedFault(const DicomFile& file)
{
  return { file.path, "a readable DICOM image", "a damaged one" };
}

DicomFault CodingFault(const DicomFile& file)
{
  const std::string syntax = SyntaxName(file.transferSyntax);
  return IsKnownSyntax(file.transferSyntax)
    ? DicomFault{ file.path, "pixels in the coding " + syntax, "damaged or unsupported ones" }
    : DicomFault{ file.path, "a known coding of the pixels", syntax };
}

/// Swaps the first byte of an image of bytes with the second, the third with the fourth, and so on.
void SwapPairsOfBytes(vtkImageData* image)
{
  auto* const bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i + 1 < image->GetNumberOfPoints(); i += 2)
  {
    std::swap(bytes[i], bytes[i + 1]);
  }
}

/// Moves the stored bits of all values to the lowest ones.
template <class Value>
void ShiftBits(const DicomFile& file, Value* values, vtkIdType count)
{
  if constexpr (std::is_integral_v<Value>)
  {
    const int size = 8 * int(sizeof(Value));
    const int above = std::max(0, size - 1 - file.highBit);
    const int unused = std::max(0, size - file.bitsStored);
    std::transform(values, values + count, values,
      [&](Value value)
      { return Value(Value(std::make_unsigned_t<Value>(value) << above) >> unused); });
  }
}

/// True if the reader has read what the header promises.
bool IsComplete(vtkDICOMReader* reader, const DicomFile& file)
{
  vtkImageData* const image = reader->GetOutput();
  const int* const dimensions = image->GetDimensions();
  return reader->GetErrorCode() == vtkErrorCode::NoError && dimensions[0] == file.columns &&
    dimensions[1] == file.rows && dimensions[2] == file.frameCount &&
    image->GetNumberOfScalarComponents() == file.samples && image->GetScalarPointer();
}

/// Reads the file at `path`, which is the file itself or a copy of it. Null if this fails.
vtkSmartPointer<vtkImageData> Read(const DicomFile& file, const std::string& path)
{
  VtkMessages silenced;
  vtkNew<vtkCheckedDICOMReader> reader;
  silenced.Observe(reader);
  silenced.Observe(reader->GetExecutive());
  silenced.Observe(reader->GetSorter());
  reader->SetFileName(path.c_str());
  reader->SortingOff();
  reader->SetMemoryRowOrderToFileNative();
  // vtk-dicom 0.8.14 swaps big-endian values by the size of the rescaled type.
  reader->AutoRescaleOff();
  reader->UpdateInformation();
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    return nullptr;
  }
  // vtk-dicom clears all but the lowest bits, even if the stored ones are higher.
  const bool isShifted = file.highBit != file.bitsStored - 1;
  if (isShifted)
  {
    reader->GetMetaData()->Set(DC::BitsStored, double(file.bitsAllocated));
  }
  reader->Update();
  if (!IsComplete(reader, file))
  {
    return nullptr;
  }
  vtkImageData* const image = reader->GetOutput();
  if (file.hasSwappedBytes)
  {
    SwapPairsOfBytes(image);
  }
  if (isShifted)
  {
    const vtkIdType count = image->GetNumberOfPoints() * file.samples;
    switch (image->GetScalarType())
    {
      vtkTemplateMacro(ShiftBits(file, static_cast<VTK_TT*>(image->GetScalarPointer()), count));
    }
  }
  return image;
}

}

DecodedPixels DecodePixels(const DicomFile& file)
{
  const auto inflated = file.isDeflated ? InflatedCopy(file.path) : nullptr;
  const std::string path = inflated ? inflated->Path() : file.path;
  if (IsUncompressed(file))
  {
    // vtk-dicom gives up all frames of a file that ends early.
    const auto copy =
      file.isTruncated ? LengthenedCopy(path, StoredBytes(file, file.frameCount)) : nullptr;
    const auto image = Read(file, copy ? copy->Path() : path);
    return { image, image ? std::nullopt : std::optional(DamagedFault(file)) };
  }
  // vtk-dicom decodes only the first fragment of a frame in run-length coding.
  const bool isSplit =
    file.transferSyntax == RunLengthSyntax && FragmentCount(path) != std::size_t(file.frameCount);
  const auto copy = isSplit ? UncompressedCopy(path) : nullptr;
  vtkSmartPointer<vtkImageData> image;
  try
  {
    if (IsKnownSyntax(file.transferSyntax) && (copy || !isSplit))
    {
      image = Read(file, copy ? copy->Path() : path);
    }
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    image = nullptr;
  }
  return { image, image ? std::nullopt : std::optional(CodingFault(file)) };
}

}
