#ifndef Varimarch_Testing_GoodFiles_h
#define Varimarch_Testing_GoodFiles_h

#include "PhantomFiles.h"

#include <cstddef>
#include <string>
#include <vector>

/// A valid file: name, bytes, and the number of redundant bytes at its end.
struct GoodFile
{
  const char* name;
  std::string bytes;
  std::size_t spareBytes = 0;
};

/// The phantom with voxels of one byte.
StoredVolume PhantomOfBytes();

/// Files of formats with few writers.
std::vector<GoodFile> MoreGoodFiles();

#endif
