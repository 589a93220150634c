#ifndef Varimarch_Readers_ArchiveInput_h
#define Varimarch_Readers_ArchiveInput_h

#include "Readers/ByteStream.h"

#include <exception>
#include <memory>
#include <string>
#include <vector>

struct archive;

namespace varimarch
{

/// An archive or a compressed stream that libarchive reads. The caller enables the formats and
/// filters that it expects, then opens it.
class ArchiveInput
{
public:
  /// @param path  path for error messages
  explicit ArchiveInput(const std::string& path);
  ~ArchiveInput();
  ArchiveInput(const ArchiveInput&) = delete;
  void operator=(const ArchiveInput&) = delete;

  archive* Handle() { return this->handle; }

  /// Opens the file itself, in which libarchive may jump; ZIP has its directory at the end.
  void OpenFile();
  /// Opens a stream of the file's bytes.
  void OpenBytes(std::unique_ptr<ByteStream> bytes);

  /// Number of the file's bytes that have been read so far.
  std::uint64_t FileBytes();

  /// Passes on the result of a call of libarchive.
  /// @throws std::runtime_error if the call has failed
  long Checked(long result);

private:
  static long ReadChunk(archive*, void* self, const void** chunk);

  std::string path;
  archive* handle;
  std::unique_ptr<ByteStream> bytes;
  std::vector<char> chunk;
  /// An error of the stream, which must not be thrown through libarchive.
  std::exception_ptr error;
};

}

#endif
