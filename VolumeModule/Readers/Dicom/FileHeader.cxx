#include "Readers/Dicom/FileHeader.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/GdcmCopy.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/Parsing/VtkMessages.h"
#include "Readers/VoxelLayout.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMLookupTable.h>
#include <vtkDICOMParser.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace varimarch
{
namespace
{

/// UID of the class of DICOMDIR files, which have no other class.
constexpr const char* IndexClass = "1.2.840.10008.1.3.10";

/// UIDs of the classes of segmentations: masks, and labels.
constexpr const char* SegmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr const char* LabelsClass = "1.2.840.10008.5.1.4.1.1.66.7";

constexpr const char* DeflatedSyntax = "1.2.840.10008.1.2.1.99";

/// A parsed file, and the place of its pixels.
struct Parsed
{
  vtkSmartPointer<vtkDICOMMetaData> meta;
  bool hasPixels;
  bool isDamaged; ///< true if the attributes end early or are malformed
  std::int64_t pixelOffset;
  double pixelBytes; ///< bytes from the first pixel to the end of the file
};

Parsed Parse(const std::string& path)
{
  VtkMessages silenced;
  vtkNew<vtkDICOMParser> parser;
  silenced.Observe(parser);
  const auto meta = vtkSmartPointer<vtkDICOMMetaData>::New();
  parser->SetMetaData(meta);
  parser->SetFileName(path.c_str());
  parser->Update();
  return { meta, parser->GetPixelDataFound(), parser->GetErrorCode() != 0,
    std::int64_t(parser->GetFileOffset()),
    double(parser->GetFileSize() - parser->GetFileOffset()) };
}

/// True for any data set that the format is known by, also without the mark at byte 128.
bool IsDataSet(const std::string& path)
{
  std::string head(4096, '\0');
  head.resize(OpenStream(path, Compression::None)->Read(head.data(), head.size()));
  return IsDicom(head);
}

/// The first attribute without which pixels cannot be understood and that the file lacks.
std::string MissingAttribute(const DicomAttributes& attributes)
{
  const struct
  {
    vtkDICOMTag tag;
    const char* name;
  } needed[] = { { DC::Rows, "Rows (0028,0010)" }, { DC::Columns, "Columns (0028,0011)" },
    { DC::BitsAllocated, "Bits Allocated (0028,0100)" } };
  for (const auto& attribute : needed)
  {
    if (attributes.NumberOr(attribute.tag, 0.0) < 1.0)
    {
      return attribute.name;
    }
  }
  return "";
}

DicomTable<std::array<std::uint8_t, 3>> PaletteOf(
  const DicomAttributes& attributes, vtkDICOMMetaData* meta)
{
  DicomTable<std::array<std::uint8_t, 3>> palette;
  VtkMessages silenced;
  vtkNew<vtkDICOMLookupTable> table;
  silenced.Observe(table);
  table->BuildImagePalette(meta);
  palette.first = int(table->GetRange()[0]);
  for (vtkIdType i = 0; i < table->GetNumberOfTableValues(); ++i)
  {
    const unsigned char* const colour = table->GetPointer(i);
    palette.entries.push_back({ colour[0], colour[1], colour[2] });
  }
  const bool isGiven = attributes.Value(DC::RedPaletteColorLookupTableDescriptor).IsValid();
  return isGiven ? palette : DicomTable<std::array<std::uint8_t, 3>>();
}

std::shared_ptr<DicomFile> FileOf(const std::string& path, vtkDICOMMetaData* meta)
{
  const DicomAttributes attributes(meta);
  auto file = std::make_shared<DicomFile>();
  file->path = path;
  file->transferSyntax = attributes.Text(DC::TransferSyntaxUID);
  file->seriesUid = attributes.Text(DC::SeriesInstanceUID);
  file->instanceUid = attributes.Text(DC::SOPInstanceUID);
  file->seriesDescription = attributes.Value(DC::SeriesDescription).AsUTF8String();
  file->frameOfReference = attributes.Text(DC::FrameOfReferenceUID);
  file->modality = attributes.Text(DC::Modality);
  const std::string kind = attributes.Text(DC::SOPClassUID);
  file->isSegmentation = kind == SegmentationClass || kind == LabelsClass;
  file->seriesNumber = attributes.NumberOr(DC::SeriesNumber, 0.0);
  file->rows = int(attributes.NumberOr(DC::Rows, 0.0));
  file->columns = int(attributes.NumberOr(DC::Columns, 0.0));
  file->frameCount = int(std::clamp(attributes.NumberOr(DC::NumberOfFrames, 1.0), 1.0, 1e9));
  file->samples = int(std::max(1.0, attributes.NumberOr(DC::SamplesPerPixel, 1.0)));
  file->bitsAllocated = int(attributes.NumberOr(DC::BitsAllocated, 0.0));
  const double stored = attributes.NumberOr(DC::BitsStored, file->bitsAllocated);
  file->bitsStored =
    stored < 1.0 ? file->bitsAllocated : std::min(int(stored), file->bitsAllocated);
  const double highBit = attributes.NumberOr(DC::HighBit, file->bitsStored - 1);
  file->highBit = int(std::clamp(highBit, file->bitsStored - 1.0, file->bitsAllocated - 1.0));
  file->isSigned = attributes.NumberOr(DC::PixelRepresentation, 0.0) == 1.0;
  file->isFloat = meta->Has(DC::FloatPixelData) || meta->Has(DC::DoubleFloatPixelData);
  file->colours = attributes.Text(DC::PhotometricInterpretation);
  if (file->colours == "PALETTE COLOR")
  {
    file->palette = PaletteOf(attributes, meta);
  }
  return file;
}

/// True if single bytes stand in words of big-endian files, which swap each pair of them (PS3.5
/// 8.1.1).
bool HasSwappedBytes(const DicomFile& file, std::int64_t pixelOffset)
{
  constexpr const char* BigEndianSyntax = "1.2.840.10008.1.2.2";
  constexpr std::int64_t FromTypeToPixels = 8;
  if (file.transferSyntax != BigEndianSyntax || file.bitsAllocated != 8 || file.samples != 1)
  {
    return false;
  }
  std::ifstream stream(file.path, std::ios::binary);
  std::string type(2, '\0');
  stream.seekg(pixelOffset - FromTypeToPixels);
  return stream.read(type.data(), 2) && type == "OW";
}

/// Checks that the file is as large as its pixels need, before memory is taken for them.
void CheckSize(double pixelBytes, DicomHeader& header)
{
  const DicomFile& file = *header.file;
  const double promised = StoredBytes(file, file.frameCount);
  // Blank images may shrink about a thousandfold, hardly more.
  const double largest = pixelBytes * (IsUncompressed(file) ? 1.0 : 20000.0);
  header.completeFrames = file.frameCount;
  if (promised > largest)
  {
    header.fault = { file.path, std::to_string(std::int64_t(promised)) + " bytes of pixels",
      std::to_string(std::int64_t(pixelBytes)) + " before the end of the file", file.seriesUid };
    header.completeFrames = IsUncompressed(file) ? int(largest / StoredBytes(file, 1)) : 0;
    header.file->isTruncated = true;
  }
}

/// A file without pixels, which is at fault only if it should have some.
void ExplainLackOfPixels(const std::string& path, const Parsed& parsed, DicomHeader& header)
{
  const DicomAttributes attributes(parsed.meta);
  const bool isImage = attributes.Value(DC::Rows).IsValid();
  const bool isIndex = attributes.Text(DC::MediaStorageSOPClassUID) == IndexClass;
  const bool isCut = !attributes.Value(DC::SOPClassUID).IsValid() && !isIndex;
  if (parsed.isDamaged || isImage || isCut)
  {
    header.fault = { path, "pixels", "a file that is damaged or ends before them",
      attributes.Text(DC::SeriesInstanceUID) };
  }
}

}

DicomHeader ReadDicomHeader(const std::string& path)
{
  DicomHeader header;
  if (!IsDataSet(path))
  {
    return header;
  }
  Parsed parsed = Parse(path);
  const bool isDeflated =
    DicomAttributes(parsed.meta).Text(DC::TransferSyntaxUID) == DeflatedSyntax;
  if (isDeflated)
  {
    const auto copy = InflatedCopy(path);
    if (!copy)
    {
      header.fault = { path, "a deflated DICOM file", "damaged data" };
      return header;
    }
    parsed = Parse(copy->Path());
  }
  header.meta = parsed.meta;
  if (!parsed.hasPixels)
  {
    ExplainLackOfPixels(path, parsed, header);
    return header;
  }
  const std::string missing = MissingAttribute(DicomAttributes(parsed.meta));
  if (!missing.empty())
  {
    header.fault = { path, "the attribute " + missing, "none",
      DicomAttributes(parsed.meta).Text(DC::SeriesInstanceUID) };
    return header;
  }
  header.file = FileOf(path, parsed.meta);
  header.file->isDeflated = isDeflated;
  header.pixelOffset = parsed.pixelOffset;
  header.file->hasSwappedBytes = HasSwappedBytes(*header.file, parsed.pixelOffset);
  CheckSize(parsed.pixelBytes, header);
  return header;
}

}
