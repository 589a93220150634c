#ifndef Varimarch_Readers_Pyramids_Imaris_h
#define Varimarch_Readers_Pyramids_Imaris_h

#include "Readers/VolumeFile.h"

#include <cstddef>
#include <vector>

namespace varimarch
{

class Hdf5File;

/// The times of an Imaris file, which says when each was scanned, counted from 1; numbers if it
/// does not.
VolumeTimes ImarisTimes(const Hdf5File& file, std::size_t count);

/// The names and colours of two to four channels; empty for others, which are not read together.
std::vector<VolumeChannel> ImarisChannels(const Hdf5File& file, std::size_t count);

}

#endif
