#ifndef Varimarch_Readers_Decoder_Jobs_h
#define Varimarch_Readers_Decoder_Jobs_h

#include <cstdint>

namespace varimarch
{

/// The orders that a decoder takes. After its number follow the most memory that the job may take
/// [bytes], a double, and the arguments.
enum class Job : std::uint32_t
{
  ReadFormat,   ///< name of the format, path, ReadOptions; Volume, image
  ReadContent,  ///< path; DicomContent
  ReadMetadata, ///< path, frame; DicomMetadata
  ReadIndex,    ///< path; paths
  ReadRecord,   ///< path; DicomRecord
  ReadTags,     ///< path; DicomTags
  DecodePixels, ///< DicomFile; fault, or image
  Unpack,       ///< UnpackingOrder; UnpackedContent
  Decompress,   ///< path, offset; only bytes
  OpenPyramid,  ///< PyramidOrder; PyramidForm
  FindChunks,   ///< PyramidOrder, level; StoredChunks
  ReadBox,      ///< PyramidOrder, level, box; number of missing chunks, voxels
};

/// Descriptors that a decoder inherits.
constexpr int DecoderSocket = 3;
constexpr int DecoderMemory = 4;

/// The first message of a decoder. A decoder of another version speaks another language.
const char* DecoderVersion();

}

#endif
