#ifndef Varimarch_Readers_MappedVti_h
#define Varimarch_Readers_MappedVti_h

#include "Readers/VolumeFile.h"

#include <optional>
#include <string>

namespace varimarch
{

/// The volume of a VTI file whose voxels stay in it, because they are too many for the memory and
/// the file has them as they are there: one piece with one array, appended raw and uncompressed, as
/// vtkXMLImageDataWriter writes it with EncodeAppendedDataOff and SetCompressorTypeToNone. None for
/// any other file.
/// @throws std::runtime_error if such a file is too short or its geometry is not valid
/// @throws ReadCancelled
std::optional<Volume> MappedVti(
  const std::string& path, const ReadOptions& options, ReadProgress& progress);

}

#endif
