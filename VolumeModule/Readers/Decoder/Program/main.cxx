// The program that decodes files for a reader, which starts it and speaks with it through inherited
// descriptors. Libraries that others maintain parse the files here, so that a file at which one of
// them crashes takes down this process only.
#include "Readers/Decoder/Channel.h"
#include "Readers/Decoder/Fields.h"
#include "Readers/Decoder/ImageForm.h"
#include "Readers/Decoder/Jobs.h"
#include "Readers/Decoder/Wire.h"
#include "Readers/Dicom/Metadata.h"
#include "Readers/Dicom/Pixels.h"
#include "Readers/Dicom/Segmentation.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/VolumeFile.h"

#include <vtkDataArray.h>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace varimarch
{
namespace
{

/// The decoder's side of its connection.
class Replies
{
public:
  Replies(int socket, int memory)
    : channel(socket, memory)
  {
  }

  void Send(MessageKind kind, const std::string& content = {})
  {
    this->channel.Send(kind, content);
  }

  /// Waits for the next job.
  /// @throws ChannelClosed if the reader has ended
  std::string NextJob();

  /// Sends bytes after a result, in as many parts as they need. Memory that was sent is given back
  /// to the system, so that the volume is in memory only once; its content is lost.
  /// @throws ReadCancelled if the reader wants no more
  void SendBytes(char* bytes, std::uint64_t count);

  /// Memory for the next part of the bytes after a result.
  /// @throws ReadCancelled if the reader wants no more
  char* FreeHalf();
  /// Sends what was written to that memory.
  void SendHalf(std::size_t count, std::uint64_t fileBytes);

  /// A progress that is sent to the reader, which ends this process if it cancels.
  ReadProgress Progress();

private:
  Message Receive();

  Channel channel;
  int half = 0;
  int credits = Channel::HalfCount; ///< halves that the reader does not use
  std::chrono::steady_clock::time_point lastSign;
};

/// Gives back the pages that lie between two places, if there are many.
void GiveBackPages(char* begin, std::size_t count)
{
  if (count < Channel::HalfBytes)
  {
    return;
  }
  const auto pageBytes = std::uintptr_t(sysconf(_SC_PAGESIZE));
  const std::uintptr_t first =
    (reinterpret_cast<std::uintptr_t>(begin) + pageBytes - 1) / pageBytes * pageBytes;
  const std::uintptr_t end =
    reinterpret_cast<std::uintptr_t>(begin + count) / pageBytes * pageBytes;
  madvise(reinterpret_cast<void*>(first), end - first, MADV_DONTNEED);
}

Message Replies::Receive()
{
  return this->channel.Receive([] {});
}

std::string Replies::NextJob()
{
  for (;;)
  {
    Message message = this->Receive();
    if (message.kind == MessageKind::Job)
    {
      return std::move(message.content);
    }
    // A Cancel that comes here was sent before its job was known to be done.
    this->credits += message.kind == MessageKind::Credit ? 1 : 0;
  }
}

char* Replies::FreeHalf()
{
  while (this->credits == 0)
  {
    const MessageKind kind = this->Receive().kind;
    if (kind == MessageKind::Cancel)
    {
      throw ReadCancelled();
    }
    this->credits += kind == MessageKind::Credit ? 1 : 0;
  }
  return this->channel.Half(this->half);
}

void Replies::SendHalf(std::size_t count, std::uint64_t fileBytes)
{
  this->Send(
    MessageKind::Bytes, Packed(std::uint32_t(this->half), std::uint64_t(count), fileBytes));
  this->half = (this->half + 1) % Channel::HalfCount;
  --this->credits;
}

void Replies::SendBytes(char* bytes, std::uint64_t count)
{
  for (std::uint64_t done = 0; done < count;)
  {
    const auto part = std::size_t(std::min<std::uint64_t>(count - done, Channel::HalfBytes));
    std::memcpy(this->FreeHalf(), bytes + done, part);
    this->SendHalf(part, 0);
    GiveBackPages(bytes + done, part);
    done += part;
  }
}

ReadProgress Replies::Progress()
{
  return ReadProgress(
    [this](double partDone)
    {
      constexpr auto Pause = std::chrono::milliseconds(20);
      const auto now = std::chrono::steady_clock::now();
      if (now - this->lastSign > Pause)
      {
        this->lastSign = now;
        this->Send(MessageKind::Progress, Packed(partDone));
      }
      return true;
    });
}

/// Private memory that this process has mapped [bytes], which RLIMIT_DATA counts; see proc(5).
double MappedDataBytes()
{
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  for (int field = 0; field < 6; ++field)
  {
    file >> pages;
  }
  return pages * double(sysconf(_SC_PAGESIZE));
}

/// Lets this process take this much more memory than it had at the first call [bytes]; more is
/// refused.
void LimitMemory(double bytes)
{
  static const double atFirst = MappedDataBytes();
  rlimit limit = {};
  getrlimit(RLIMIT_DATA, &limit);
  const double most = atFirst + bytes;
  limit.rlim_cur = most < double(limit.rlim_max) ? rlim_t(most) : limit.rlim_max;
  setrlimit(RLIMIT_DATA, &limit);
}

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

/// Performs a job, and sends its result.
/// @throws std::exception if the job fails
/// @throws ReadCancelled if the reader wants no more of it
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

/// Leaves no core file with a patient's data, gains no rights, and ends with the reader.
void Confine()
{
  const rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  prctl(PR_SET_DUMPABLE, 0);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGPIPE, SIG_IGN);
}

/// Performs jobs until the reader ends.
[[noreturn]] void Serve(Replies& replies)
{
  replies.Send(MessageKind::Hello, DecoderVersion());
  for (;;)
  {
    const std::string job = replies.NextJob();
    try
    {
      PerformJob(job, replies);
    }
    catch (const ReadCancelled&)
    {
      replies.Send(MessageKind::Cancelled);
    }
    catch (const std::bad_alloc&)
    {
      replies.Send(MessageKind::NoMemory);
    }
    catch (const std::exception& error)
    {
      replies.Send(MessageKind::Fault, error.what());
    }
  }
}

}

}

int main()
{
  struct stat status = {};
  if (fstat(varimarch::DecoderSocket, &status) != 0 || !S_ISSOCK(status.st_mode))
  {
    std::fprintf(stderr, "varimarch-decode is started by the readers of volume files only.\n");
    return 2;
  }
  varimarch::Confine();
  try
  {
    varimarch::Replies replies(varimarch::DecoderSocket, varimarch::DecoderMemory);
    varimarch::Serve(replies);
  }
  catch (const varimarch::ChannelClosed&)
  {
    // The reader has ended, or wants no more.
    _exit(0);
  }
}
