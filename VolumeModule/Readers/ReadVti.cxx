// VTK's XML image data. VTK's own reader preserves the geometry, so it is used; its messages are
// collected.
#include "Readers/ByteStream.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageFacts.h"
#include "Readers/VoxelLayout.h"
#include "Readers/VtkImage.h"
#include "Readers/VtkMessages.h"
#include "Readers/VtkProgress.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkDataCompressor.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>

namespace varimarch
{
namespace
{

[[noreturn]] void FailWith(const std::string& path, const VtkMessages& messages)
{
  FailToRead(path, "a complete VTK image file", messages.FirstErrorOr("an incomplete one"));
}

/// The arrays that a header lists.
std::vector<ImageArray> ArraysOf(vtkInformationVector* list, bool areInCells)
{
  const int count = list ? list->GetNumberOfInformationObjects() : 0;
  std::vector<ImageArray> arrays;
  for (int i = 0; i < count; ++i)
  {
    vtkInformation* array = list->GetInformationObject(i);
    const char* name = array->Get(vtkDataObject::FIELD_NAME());
    const int attributes = array->Get(vtkDataObject::FIELD_ACTIVE_ATTRIBUTE());
    arrays.push_back({ name ? name : "", array->Get(vtkDataObject::FIELD_ARRAY_TYPE()),
      array->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()),
      (attributes & (1 << vtkDataSetAttributes::SCALARS)) != 0, areInCells });
  }
  return arrays;
}

ImageArray ArrayToRead(const std::string& path, vtkInformation* output)
{
  std::vector<ImageArray> arrays = ArraysOf(output->Get(vtkDataObject::POINT_DATA_VECTOR()), false);
  const auto inCells = ArraysOf(output->Get(vtkDataObject::CELL_DATA_VECTOR()), true);
  arrays.insert(arrays.end(), inCells.begin(), inCells.end());
  return ArrayToShow(path, arrays);
}

/// Fails for a truncated file, whose missing voxels VTK would leave uninitialized.
void CheckIsWhole(const std::string& path)
{
  constexpr std::uint64_t tailBytes = 1024;
  const std::uint64_t fileBytes = ReadableFileSize(path);
  std::string tail(std::min(fileBytes, tailBytes), '\0');
  OpenStream(path, Compression::None, fileBytes - tail.size())->Read(tail.data(), tail.size());
  const std::size_t mark = tail.rfind("</VTKFile");
  if (mark == std::string::npos || tail.find('>', mark) == std::string::npos)
  {
    FailToRead(path, "a VTK image file that ends with </VTKFile>",
      "another end after " + std::to_string(fileBytes) + " bytes");
  }
}

/// File offset of the bytes after "<AppendedData encoding="raw">_", if there are any.
std::optional<std::uint64_t> RawBytesBegin(const std::string& path)
{
  constexpr auto anywhere = std::numeric_limits<std::streamsize>::max();
  const std::string wanted = "AppendedData";
  std::ifstream file(path, std::ios::binary);
  while (file.ignore(anywhere, '<'))
  {
    const std::streamoff tag = file.tellg();
    std::string name(wanted.size(), '\0');
    if (!file.read(name.data(), std::streamsize(name.size())))
    {
      break;
    }
    if (name == wanted)
    {
      std::string attributes;
      std::getline(file, attributes, '>');
      const bool isRaw = attributes.find("raw") != std::string::npos;
      return isRaw && file.ignore(anywhere, '_') ? std::optional(std::uint64_t(file.tellg()))
                                                 : std::nullopt;
    }
    file.seekg(tag);
  }
  return std::nullopt;
}

/// Fails if the header promises more than any encoding of the file can hold.
void CheckFileHolds(const std::string& path, const VoxelLayout& layout, bool isCompressed)
{
  const double bytes = double(CheckedByteCount(path, layout));
  const double fileBytes = double(ReadableFileSize(path));
  // The densest encodings: LZMA compresses at most about 7000 to 1; text needs two bytes per value.
  const double valueBytes = vtkDataArray::GetDataTypeSize(layout.scalarType);
  double mostBytes = fileBytes * (isCompressed ? 7000.0 : std::max(1.0, valueBytes / 2.0));
  if (const auto begin = isCompressed ? std::nullopt : RawBytesBegin(path))
  {
    // The byte count precedes the data, and the end of the document follows it.
    const auto otherBytes = double(*begin + 4 + sizeof("</AppendedData></VTKFile>") - 1);
    mostBytes = std::max(0.0, fileBytes - otherBytes);
  }
  if (bytes > mostBytes)
  {
    FailToRead(path, Text(layout) + " (" + ByteText(bytes) + ")",
      "a file that holds at most " + ByteText(mostBytes));
  }
}

/// Selects this array only.
void SelectArray(vtkXMLImageDataReader* reader, const ImageArray& array)
{
  reader->GetPointDataArraySelection()->DisableAllArrays();
  reader->GetCellDataArraySelection()->DisableAllArrays();
  (array.isInCells ? reader->GetCellDataArraySelection() : reader->GetPointDataArraySelection())
    ->EnableArray(array.name.c_str());
}

/// Reads the header, and fails if it cannot be true.
/// @returns the array to read
ImageArray ReadHeader(
  const std::string& path, vtkXMLImageDataReader* reader, const VtkMessages& messages)
{
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  vtkInformation* output = reader->GetOutputInformation(0);
  if (!messages.Errors().empty() || reader->GetErrorCode() != vtkErrorCode::NoError ||
    !output->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    FailWith(path, messages);
  }
  const ImageArray array = ArrayToRead(path, output);
  const int* extent = output->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  VoxelLayout layout = { {}, array.scalarType, array.componentCount };
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t intervals = std::int64_t(extent[2 * axis + 1]) - extent[2 * axis];
    layout.dimensions[axis] = array.isInCells && intervals > 0 ? intervals : intervals + 1;
  }
  CheckFileHolds(path, layout, reader->GetXMLParser()->GetCompressor() != nullptr);
  return array;
}

}

vtkSmartPointer<vtkImageData> ReadVtiFile(const std::string& path, ReadProgress& progress)
{
  CheckIsWhole(path);
  VtkMessages messages;
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetReaderErrorObserver(messages.Listener());
  reader->SetParserErrorObserver(messages.Listener());
  messages.Observe(reader);
  messages.Observe(reader->GetExecutive());
  const ImageArray array = ReadHeader(path, reader, messages);
  SelectArray(reader, array);
  // The selection makes the reader parse the file again, with another parser and decompressor.
  reader->UpdateInformation();
  messages.Observe(reader->GetXMLParser());
  if (vtkDataCompressor* compressor = reader->GetXMLParser()->GetCompressor())
  {
    messages.Observe(compressor);
  }
  UpdateWithProgress(reader, progress);
  vtkSmartPointer<vtkImageData> voxels = VoxelsOf(reader->GetOutput(), array);
  if (!messages.Errors().empty() || reader->GetErrorCode() != vtkErrorCode::NoError || !voxels)
  {
    FailWith(path, messages);
  }
  voxels->SetFieldData(reader->GetOutput()->GetFieldData());
  return voxels;
}

Volume ReadVti(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  const vtkSmartPointer<vtkImageData> voxels = ReadVtiFile(path, progress);
  Volume volume = VolumeOf(path, voxels);
  volume.showsPatient = ShowsPatient(voxels);
  volume.holdsColors = HoldsColors(voxels);
  volume.channels = ChannelsIn(voxels);
  return volume;
}

}
