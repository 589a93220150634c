#ifndef Varimarch_Readers_Pyramids_Hdf5Path_h
#define Varimarch_Readers_Pyramids_Hdf5Path_h

#include <string>

namespace varimarch
{

/// A path such as "brain.h5/volumes/raw", as ilastik writes them: a file, and a data set in it.
struct Hdf5Path
{
  std::string file;
  std::string inner; ///< with a slash at its beginning; empty if the path names no data set
};

/// Splits a path behind the first part that is a regular file. A path without one stays whole.
Hdf5Path Hdf5PathOf(const std::string& path);

}

#endif
