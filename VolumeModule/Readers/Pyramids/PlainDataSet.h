#ifndef Varimarch_Readers_Pyramids_PlainDataSet_h
#define Varimarch_Readers_Pyramids_PlainDataSet_h

#include "Readers/Pyramids/ArrayAxes.h"

#include <string>
#include <vector>

namespace varimarch
{

class Hdf5File;

/// The name of the data set with the most numbers among those with three axes or more.
/// @throws std::runtime_error if there is none
std::string LargestDataSet(const Hdf5File& file);

/// The axes of a data set as ilastik, Fiji, h5py and netCDF-4 describe them, slowest first: placed
/// by their scales, or else with the sizes of a voxel.
/// @param warnings  receives sentences about sizes that are not known, and scales that are not even
/// @throws std::runtime_error if there is no such data set, or it has less than two axes
ArrayAxes AxesOfDataSet(
  const Hdf5File& file, const std::string& name, std::vector<std::string>& warnings);

}

#endif
