#include "Readers/Decoder/Program/PerformJob.h"

#include "Readers/ByteStream.h"
#include "Readers/Decoder/Fields.h"
#include "Readers/Decoder/ImageForm.h"
#include "Readers/Decoder/Jobs.h"
#include "Readers/Decoder/Program/MemoryLimit.h"
#include "Readers/Dicom/DicomIndex.h"
#include "Readers/Dicom/Pixels.h"
#include "Readers/Dicom/Segmentation.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Pyramids/VoxelPyramid.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <map>
#include <memory>

namespace varimarch
{
namespace
{

void SendImage(const std::string& result, vtkImageData* image, Replies& replies)
{
  replies.Send(MessageKind::Result, result);
  const VoxelLayout layout = FormOf(image).layout;
  replies.SendBytes(static_cast<char*>(image->GetScalarPointer()),
    std::uint64_t(image->GetNumberOfPoints() * layout.componentCount) *
      std::uint64_t(image->GetScalarSize()));
}

void ReadFormat(WireReader& arguments, Replies& replies)
{
  static const std::map<std::string, decltype(&ReadVti)> readers = {
    { "DICOM segmentation",
      [](const std::string& path, const ReadOptions&, ReadProgress& progress)
      { return ReadSegmentation(path, progress); } },
    { "image stack", ReadImageStack },
    { "InVesalius", ReadInv3 },
    { "MINC", ReadMinc },
    { "PVTI", ReadPvti },
    { "TIFF", ReadTiff },
    { "VTI", ReadVti },
  };
  std::string format;
  std::string path;
  ReadOptions options;
  arguments(format, path, options);
  ReadProgress progress = replies.Progress();
  const Volume volume = readers.at(format)(path, options, progress);
  SendImage(Packed(volume, FormOf(volume.image)), volume.image, replies);
}

void ReadContent(WireReader& arguments, Replies& replies)
{
  std::string path;
  arguments(path);
  const DicomContent content = ReadDicomContent(path);
  // Frames with equal tables share one, which may be large.
  std::vector<DicomTable<std::uint16_t>> tables;
  std::vector<std::uint64_t> tableOfFrame;
  for (const DicomFrame& frame : content.frames)
  {
    const bool isNew = frame.table &&
      (tables.empty() || tables.back().first != frame.table->first ||
        tables.back().entries != frame.table->entries);
    if (isNew)
    {
      tables.push_back(*frame.table);
    }
    tableOfFrame.push_back(frame.table ? tables.size() : 0);
  }
  replies.Send(MessageKind::Result,
    Packed(content.isDicom, content.file != nullptr, content.file ? *content.file : DicomFile(),
      content.frames, content.fault, tables, tableOfFrame));
}

void ReadMetadata(WireReader& arguments, Replies& replies)
{
  std::string path;
  int frame = 0;
  arguments(path, frame);
  replies.Send(MessageKind::Result, Packed(MetadataOf(path, frame)));
}

void ReadIndex(WireReader& arguments, Replies& replies)
{
  std::string path;
  arguments(path);
  ReadProgress progress = replies.Progress();
  replies.Send(MessageKind::Result, Packed(FilesOfIndex(path, progress)));
}

void ReadRecord(WireReader& arguments, Replies& replies)
{
  std::string path;
  arguments(path);
  replies.Send(MessageKind::Result, Packed(RecordOf(path)));
}

void ReadTags(WireReader& arguments, Replies& replies)
{
  std::string path;
  arguments(path);
  replies.Send(MessageKind::Result, Packed(TagsOf(path)));
}

void Decode(WireReader& arguments, Replies& replies)
{
  DicomFile file;
  arguments(file);
  const DecodedPixels pixels = DecodePixels(file);
  if (pixels.fault)
  {
    replies.Send(MessageKind::Result, Packed(pixels.fault, VoxelLayout()));
    return;
  }
  SendImage(Packed(pixels.fault, FormOf(pixels.image).layout), pixels.image, replies);
}

void UnpackPacked(WireReader& arguments, Replies& replies)
{
  UnpackingOrder order;
  arguments(order);
  ReadProgress progress = replies.Progress();
  replies.Send(MessageKind::Result, Packed(Unpack(order, progress)));
}

void Decompress(WireReader& arguments, Replies& replies)
{
  std::string path;
  std::uint64_t offset = 0;
  arguments(path, offset);
  const auto stream = OpenArchiveStream(path, offset);
  replies.Send(MessageKind::Result);
  // The first parts are short, since often only the head of a file is wanted.
  constexpr std::size_t Growth = 16;
  std::size_t wanted = 4096;
  for (bool goesOn = true; goesOn; wanted = std::min(Growth * wanted, Channel::HalfBytes))
  {
    const std::size_t got = stream->Read(replies.FreeHalf(), wanted);
    goesOn = got == wanted;
    if (got > 0)
    {
      replies.SendHalf(got, stream->FileBytes());
    }
  }
}

/// The volume that was opened last, since several boxes of it are read in turn.
VoxelPyramid& OpenedPyramid(const PyramidOrder& order)
{
  static std::unique_ptr<VoxelPyramid> opened;
  static std::string key;
  const std::string wanted = Packed(order);
  if (!opened || wanted != key)
  {
    opened.reset();
    opened = order.format == PyramidFormat::Zarr ? OpenZarr(order.path, order.options)
                                                 : OpenHdf5(order.path, order.options);
    key = wanted;
  }
  return *opened;
}

/// Fails if a level that the reader knows of is gone.
void CheckLevel(const PyramidOrder& order, const PyramidForm& form, int level)
{
  if (level < 0 || std::size_t(level) >= form.levels.size())
  {
    FailToRead(order.path, "the level " + std::to_string(level), "a file that has changed");
  }
}

void OpenPyramid(WireReader& arguments, Replies& replies)
{
  PyramidOrder order;
  arguments(order);
  replies.Send(MessageKind::Result, Packed(OpenedPyramid(order).Form()));
}

void FindChunks(WireReader& arguments, Replies& replies)
{
  PyramidOrder order;
  int level = 0;
  arguments(order, level);
  const VoxelPyramid& pyramid = OpenedPyramid(order);
  CheckLevel(order, pyramid.Form(), level);
  replies.Send(MessageKind::Result, Packed(pyramid.Stored(level)));
}

void ReadBox(WireReader& arguments, Replies& replies)
{
  PyramidOrder order;
  int level = 0;
  BrickSource::Box box = {};
  arguments(order, level, box);
  VoxelPyramid& pyramid = OpenedPyramid(order);
  const PyramidForm& form = pyramid.Form();
  CheckLevel(order, form, level);
  if (!LiesIn(box, form.levels[std::size_t(level)]))
  {
    FailToRead(order.path, "a box in one of the levels", "a file that has changed");
  }
  const auto size = SizeOf(box);
  std::vector<char> voxels(CheckedChunkBytes(
    order.path, { size.begin(), size.end() }, vtkDataArray::GetDataTypeSize(form.scalarType)));
  const std::int64_t missing = pyramid.Read(level, box, voxels.data());
  replies.Send(MessageKind::Result, Packed(missing));
  replies.SendBytes(voxels.data(), voxels.size());
}

}

void PerformJob(const std::string& job, Replies& replies)
{
  static const std::map<Job, void (*)(WireReader&, Replies&)> functions = {
    { Job::ReadFormat, ReadFormat },
    { Job::ReadContent, ReadContent },
    { Job::ReadMetadata, ReadMetadata },
    { Job::ReadIndex, ReadIndex },
    { Job::ReadRecord, ReadRecord },
    { Job::ReadTags, ReadTags },
    { Job::DecodePixels, Decode },
    { Job::Unpack, UnpackPacked },
    { Job::Decompress, Decompress },
    { Job::OpenPyramid, OpenPyramid },
    { Job::FindChunks, FindChunks },
    { Job::ReadBox, ReadBox },
  };
  WireReader arguments(job);
  Job kind = Job::ReadFormat;
  double mostMemory = 0.0;
  arguments(kind, mostMemory);
  LimitMemory(mostMemory);
  functions.at(kind)(arguments, replies);
  replies.Send(MessageKind::Done);
}

}
