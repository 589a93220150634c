// VTK's XML image data, and parallel VTK image data: an XML file that names the files of the
// pieces, each a VTI file. VTK's own reader preserves the geometry, so it is used; its messages are
// collected.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageFacts.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/VtkMessages.h"
#include "Readers/Parsing/VtkProgress.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkDataCompressor.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLImageDataReader.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace varimarch
{
namespace
{

/// An array of VTK image data, with values at the points or in the cells.
struct ImageArray
{
  std::string name;
  int scalarType;
  int componentCount;
  bool isActive; ///< the file names it as the scalars
  bool isInCells;
};

bool IsNumeric(const ImageArray& array)
{
  return IsNumberType(array.scalarType) && !array.name.empty() &&
    array.name != vtkDataSetAttributes::GhostArrayName();
}

ImageGeometry GeometryOf(vtkImageData* image)
{
  const int* extent = image->GetExtent();
  const glm::dvec3 firstIndex(extent[0], extent[2], extent[4]);
  const glm::dmat3 direction =
    glm::transpose(glm::make_mat3(image->GetDirectionMatrix()->GetData()));
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] = direction[axis] * image->GetSpacing()[axis];
  }
  // The file's extent may begin anywhere; the output's begins at 0.
  geometry.originMm = glm::make_vec3(image->GetOrigin()) + geometry.axesMm * firstIndex;
  return geometry;
}

/// The array that is shown: points before cells, the active scalars before others, at most four
/// components before more.
/// @throws std::runtime_error if none is numeric
ImageArray ArrayToShow(const std::string& path, std::vector<ImageArray> arrays)
{
  arrays.erase(std::remove_if(
                 arrays.begin(), arrays.end(), [](const auto& array) { return !IsNumeric(array); }),
    arrays.end());
  if (arrays.empty())
  {
    FailToRead(path, "a numeric array of point or cell data", "none");
  }
  const auto rank = [](const ImageArray& array)
  { return std::tuple(array.isInCells, !array.isActive, array.componentCount > 4); };
  return *std::min_element(arrays.begin(), arrays.end(),
    [&](const ImageArray& a, const ImageArray& b) { return rank(a) < rank(b); });
}

/// An image whose points are voxels with the values of the array. The voxel of a cell is at the
/// cell's centre. Null if the image lacks the array.
vtkSmartPointer<vtkImageData> VoxelsOf(vtkImageData* image, const ImageArray& array)
{
  vtkDataSetAttributes* attributes = image->GetPointData();
  if (array.isInCells)
  {
    attributes = image->GetCellData();
  }
  vtkDataArray* values = attributes->GetArray(array.name.c_str());
  int extent[6];
  image->GetExtent(extent);
  glm::dvec3 firstCentre(0.0);
  for (int axis = 0; array.isInCells && axis < 3; ++axis)
  {
    // A single layer of points is a single layer of flat cells.
    const bool isThick = extent[2 * axis + 1] > extent[2 * axis];
    extent[2 * axis + 1] -= isThick ? 1 : 0;
    firstCentre[axis] = isThick ? 0.5 : 0.0;
  }
  auto voxels = vtkSmartPointer<vtkImageData>::New();
  voxels->SetExtent(extent);
  if (!values || values->GetNumberOfTuples() != voxels->GetNumberOfPoints())
  {
    return nullptr;
  }
  glm::dvec3 origin;
  image->TransformContinuousIndexToPhysicalPoint(
    firstCentre.x, firstCentre.y, firstCentre.z, &origin[0]);
  voxels->SetOrigin(&origin[0]);
  voxels->SetSpacing(image->GetSpacing());
  voxels->SetDirectionMatrix(image->GetDirectionMatrix());
  voxels->GetPointData()->SetScalars(values);
  return voxels;
}

/// The volume of an image with voxels as points, whose first index becomes 0.
/// @throws std::runtime_error if its geometry is not valid
Volume VolumeOf(const std::string& path, vtkImageData* voxels)
{
  Volume volume;
  volume.image = vtkSmartPointer<vtkImageData>::New();
  volume.image->SetDimensions(voxels->GetDimensions());
  volume.image->GetPointData()->SetScalars(voxels->GetPointData()->GetScalars());
  PlaceImage(path, GeometryOf(voxels), volume.image);
  return volume;
}

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

/// Reads a VTI file; the result is that of VoxelsOf.
/// @throws std::runtime_error if the file is not complete
/// @throws ReadCancelled
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

namespace
{

using Extent = std::array<int, 6>;

/// The names of the pieces' files, relative to the folder of the file itself.
std::vector<std::string> PiecesOf(const std::string& path)
{
  VtkMessages messages;
  vtkNew<vtkXMLDataParser> parser;
  messages.Observe(parser);
  parser->SetFileName(path.c_str());
  const bool isParsed = parser->Parse() != 0;
  vtkXMLDataElement* root = parser->GetRootElement();
  vtkXMLDataElement* image =
    isParsed && root ? root->FindNestedElementWithName("PImageData") : nullptr;
  std::vector<std::string> pieces;
  for (int i = 0; image && i < image->GetNumberOfNestedElements(); ++i)
  {
    const char* source = image->GetNestedElement(i)->GetAttribute("Source");
    if (source)
    {
      pieces.push_back((std::filesystem::path(path).parent_path() / source).string());
    }
  }
  if (pieces.empty())
  {
    FailToRead(path, "parallel VTK image data with pieces", messages.FirstErrorOr("none"));
  }
  return pieces;
}

/// The smallest box with all pieces.
Extent CommonExtent(const std::vector<vtkSmartPointer<vtkImageData>>& pieces)
{
  Extent common;
  pieces.front()->GetExtent(common.data());
  for (vtkImageData* piece : pieces)
  {
    for (std::size_t side = 0; side < 6; ++side)
    {
      const int index = piece->GetExtent()[side];
      common[side] = side % 2 == 0 ? std::min(common[side], index) : std::max(common[side], index);
    }
  }
  return common;
}

/// Copies a piece, row by row, to its place.
void CopyPiece(vtkImageData* piece, vtkImageData* whole)
{
  const int* extent = piece->GetExtent();
  const std::size_t rowBytes = std::size_t(extent[1] - extent[0] + 1) *
    std::size_t(piece->GetNumberOfScalarComponents()) * std::size_t(piece->GetScalarSize());
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      std::memcpy(whole->GetScalarPointer(extent[0], j, k),
        piece->GetScalarPointer(extent[0], j, k), rowBytes);
    }
  }
}

/// Fails if the pieces do not fill the box, or differ in type.
void CheckPieces(const std::string& path, const Extent& box,
  const std::vector<vtkSmartPointer<vtkImageData>>& pieces)
{
  double pointCount = 0.0;
  for (vtkImageData* piece : pieces)
  {
    pointCount += double(piece->GetNumberOfPoints());
    if (piece->GetScalarType() != pieces.front()->GetScalarType() ||
      piece->GetNumberOfScalarComponents() != pieces.front()->GetNumberOfScalarComponents())
    {
      FailToRead(path, "pieces of one type", "different ones");
    }
  }
  const double wholeCount =
    double(box[1] - box[0] + 1) * double(box[3] - box[2] + 1) * double(box[5] - box[4] + 1);
  if (pointCount < wholeCount)
  {
    FailToRead(path, "pieces that fill a box", "gaps between them");
  }
}

}

Volume ReadPvti(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  const std::vector<std::string> files = PiecesOf(path);
  std::vector<vtkSmartPointer<vtkImageData>> pieces;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    ReadProgress part =
      progress.Part(double(i) / double(files.size()), double(i + 1) / double(files.size()));
    ReadableFileSize(files[i]);
    pieces.push_back(ReadVtiFile(files[i], part));
  }
  const Extent box = CommonExtent(pieces);
  CheckPieces(path, box, pieces);
  vtkImageData* first = pieces.front();
  CheckedByteCount(path,
    { { box[1] - box[0] + 1, box[3] - box[2] + 1, box[5] - box[4] + 1 }, first->GetScalarType(),
      first->GetNumberOfScalarComponents() });
  vtkNew<vtkImageData> whole;
  whole->SetExtent(const_cast<int*>(box.data()));
  whole->SetOrigin(first->GetOrigin());
  whole->SetSpacing(first->GetSpacing());
  whole->SetDirectionMatrix(first->GetDirectionMatrix());
  whole->AllocateScalars(first->GetScalarType(), first->GetNumberOfScalarComponents());
  whole->GetPointData()->GetScalars()->SetName(first->GetPointData()->GetScalars()->GetName());
  for (vtkImageData* piece : pieces)
  {
    CopyPiece(piece, whole);
  }
  return VolumeOf(path, whole);
}

}
