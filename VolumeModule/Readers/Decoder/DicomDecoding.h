#ifndef Varimarch_Readers_Decoder_DicomDecoding_h
#define Varimarch_Readers_Decoder_DicomDecoding_h

#include "Readers/Dicom/FileFrames.h"
#include "Readers/Dicom/Pixels.h"
#include "Readers/VolumeFile.h"

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

// Decoders read the files of a series one after the other. A file at which one ends has a fault,
// and another decoder goes on with the next file.

/// Reads the attributes of files, and passes them on in order.
/// @throws ReadCancelled
void ForEachContent(const std::vector<std::string>& paths,
  const std::function<void(std::size_t, const DicomContent&)>& take, ReadProgress& progress);

/// Decodes the pixels of files, and passes them on in order. An image is valid only during the call
/// that it is passed to.
/// @throws ReadCancelled
void ForEachDecoded(const std::vector<const DicomFile*>& files,
  const std::function<void(std::size_t, const DecodedPixels&)>& take, ReadProgress& progress);

}

#endif
