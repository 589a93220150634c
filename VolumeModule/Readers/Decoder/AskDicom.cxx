// The functions of DICOM files that other libraries parse, as a decoder performs them.
#include "Readers/Decoder/Conversation.h"
#include "Readers/Decoder/DicomDecoding.h"
#include "Readers/Decoder/Fields.h"
#include "Readers/Dicom/Metadata.h"
#include "Readers/FileError.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <filesystem>
#include <optional>
#include <stdexcept>

namespace varimarch
{
namespace
{

/// Jobs of one kind for a list of files.
struct Batch
{
  std::vector<std::string> paths;
  std::vector<std::string> orders;
  /// Takes the answer to an order.
  std::function<void(std::size_t, Conversation&)> take;
  /// Takes the reason why there is no answer.
  std::function<void(std::size_t, const std::string& found)> fail;
};

/// Performs the jobs from `first` on with one decoder, up to the end or the first that fails.
/// @returns the next job
std::size_t PerformSome(const Batch& batch, std::size_t first, ReadProgress& progress)
{
  const std::size_t count = batch.orders.size();
  std::size_t i = first;
  try
  {
    double done = double(first) / double(count);
    ReadProgress waiting(
      [&](double)
      {
        progress.Report(done);
        return true;
      });
    Conversation conversation(batch.paths[first], waiting);
    // While this process takes an answer, the decoder performs the next job.
    conversation.Give(batch.orders[first]);
    for (; i < count; ++i)
    {
      if (i + 1 < count)
      {
        conversation.Give(batch.orders[i + 1]);
      }
      batch.take(i, conversation);
      done = double(i + 1) / double(count);
      progress.Report(done);
    }
  }
  catch (const DecoderFailure& failure)
  {
    batch.fail(i, failure.found);
    ++i;
  }
  catch (const DecoderFault& fault)
  {
    constexpr std::size_t Longest = 200;
    batch.fail(i, "the fault " + Quoted(fault.what(), Longest));
    ++i;
  }
  return i;
}

void Perform(const Batch& batch, ReadProgress& progress)
{
  for (std::size_t next = 0; next < batch.orders.size();)
  {
    next = PerformSome(batch, next, progress);
  }
}

DicomContent UnpackedContentOf(const std::string& bytes)
{
  DicomContent content;
  auto file = std::make_shared<DicomFile>();
  bool hasFile = false;
  std::vector<DicomTable<std::uint16_t>> tables;
  std::vector<std::uint64_t> tableOfFrame;
  TakeValues(
    bytes, content.isDicom, hasFile, *file, content.frames, content.fault, tables, tableOfFrame);
  content.file = hasFile ? file : nullptr;
  std::vector<std::shared_ptr<const DicomTable<std::uint16_t>>> shared = { nullptr };
  for (const auto& table : tables)
  {
    shared.push_back(std::make_shared<const DicomTable<std::uint16_t>>(table));
  }
  for (std::size_t i = 0; i < content.frames.size(); ++i)
  {
    content.frames[i].file = content.file;
    content.frames[i].table = i < tableOfFrame.size() && tableOfFrame[i] < shared.size()
      ? shared[std::size_t(tableOfFrame[i])]
      : nullptr;
  }
  return content;
}

/// Bytes of the decoded pixels of a file.
double DecodedBytes(const DicomFile& file)
{
  return double(file.rows) * file.columns * file.frameCount * file.samples *
    std::max(1.0, file.bitsAllocated / 8.0);
}

/// The image of a file whose scalars lie in the shared memory, or are copied if they do not fit.
vtkSmartPointer<vtkImageData> TakeImage(
  const DicomFile& file, const VoxelLayout& layout, Conversation& conversation)
{
  const std::uint64_t byteCount = CheckedByteCount(file.path, layout);
  const bool isExpected = IsNumberType(layout.scalarType) &&
    layout.dimensions == std::array<std::int64_t, 3>{ file.columns, file.rows, file.frameCount } &&
    layout.componentCount == file.samples && double(byteCount) <= 8.0 * DecodedBytes(file);
  if (!isExpected)
  {
    throw DecoderFailure{ Text(layout) + " from the decoder" };
  }
  if (byteCount > Channel::HalfBytes)
  {
    auto image = AllocatedImage(layout);
    conversation.TakeBytes(image->GetScalarPointer(), byteCount);
    return image;
  }
  const DecoderBytes bytes = conversation.NextBytes();
  if (bytes.count != byteCount)
  {
    throw DecoderFailure{ "another number of bytes than the decoder had promised" };
  }
  const auto scalars =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(layout.scalarType));
  scalars->SetNumberOfComponents(int(layout.componentCount));
  constexpr int IsNotOwned = 1;
  scalars->SetVoidArray(const_cast<char*>(bytes.begin),
    vtkIdType(byteCount / std::uint64_t(scalars->GetDataTypeSize())), IsNotOwned);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(file.columns, file.rows, file.frameCount);
  image->GetPointData()->SetScalars(scalars);
  return image;
}

/// Receives the pixels of a file. Those in the shared memory stay valid up to the next answer.
DecodedPixels TakePixels(const DicomFile& file, Conversation& conversation)
{
  const std::string result = conversation.Result(DecodedBytes(file));
  DecodedPixels pixels;
  VoxelLayout layout = {};
  TakeValues(result, pixels.fault, layout);
  if (!pixels.fault)
  {
    pixels.image = TakeImage(file, layout, conversation);
  }
  conversation.Finish();
  return pixels;
}

}

void ForEachContent(const std::vector<std::string>& paths,
  const std::function<void(std::size_t, const DicomContent&)>& take, ReadProgress& progress)
{
  Batch batch;
  batch.paths = paths;
  const double freeBytes = FreeJobMemory();
  for (const std::string& path : paths)
  {
    batch.orders.push_back(Packed(Job::ReadContent, freeBytes, path));
  }
  batch.take = [&](std::size_t i, Conversation& conversation)
  {
    const std::string result = conversation.Result();
    conversation.Finish();
    take(i, UnpackedContentOf(result));
  };
  batch.fail = [&](std::size_t i, const std::string& found)
  {
    DicomContent content;
    content.isDicom = true;
    content.fault = DicomFault{ paths[i], "a readable DICOM file", found };
    take(i, content);
  };
  Perform(batch, progress);
}

void ForEachDecoded(const std::vector<const DicomFile*>& files,
  const std::function<void(std::size_t, const DecodedPixels&)>& take, ReadProgress& progress)
{
  Batch batch;
  const double freeBytes = FreeJobMemory();
  for (const DicomFile* file : files)
  {
    DicomFile order = *file;
    order.palette = {};
    batch.paths.push_back(file->path);
    batch.orders.push_back(
      Packed(Job::DecodePixels, JobMemory(file->path, DecodedBytes(*file), freeBytes), order));
  }
  batch.take = [&](std::size_t i, Conversation& conversation)
  { take(i, TakePixels(*files[i], conversation)); };
  batch.fail = [&](std::size_t i, const std::string& found) {
    take(i, { nullptr, DicomFault{ files[i]->path, "a readable DICOM image", found } });
  };
  Perform(batch, progress);
}

std::vector<std::string> FilesOfIndex(const std::string& index, ReadProgress& progress)
{
  return Answer<std::vector<std::string>>(
    index, Packed(Job::ReadIndex, FreeJobMemory(), index), progress);
}

void ForEachRecord(const std::vector<std::string>& paths,
  const std::function<void(std::size_t, const DicomRecord&)>& take, ReadProgress& progress)
{
  Batch batch;
  batch.paths = paths;
  const double freeBytes = FreeJobMemory();
  for (const std::string& path : paths)
  {
    batch.orders.push_back(Packed(Job::ReadRecord, freeBytes, path));
  }
  batch.take = [&](std::size_t i, Conversation& conversation)
  {
    DicomRecord record;
    TakeValues(conversation.Result(), record);
    conversation.Finish();
    take(i, record);
  };
  batch.fail = [&](std::size_t i, const std::string&) { take(i, {}); };
  Perform(batch, progress);
}

std::vector<DicomTag> TagsOf(const std::string& path)
{
  ReadProgress silent([](double) { return true; });
  return Answer<std::vector<DicomTag>>(path, Packed(Job::ReadTags, FreeJobMemory(), path), silent);
}

DicomMetadata MetadataOf(const std::string& path, int frame)
{
  ReadProgress silent([](double) { return true; });
  return Answer<DicomMetadata>(
    path, Packed(Job::ReadMetadata, FreeJobMemory(), path, frame), silent);
}

}
