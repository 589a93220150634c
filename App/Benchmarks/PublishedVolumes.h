#ifndef Varimarch_Benchmarks_PublishedVolumes_h
#define Varimarch_Benchmarks_PublishedVolumes_h

#include "Scene/VolumeLoading.h"

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A row of Banquero's table 1.
struct PublishedSteps
{
  int steps;
  double fps;
};

/// A row of Banquero's table 2, as printed.
struct PublishedRates
{
  std::string plainFps; ///< by ray casting
  std::string fieldFps; ///< with the distance field
  std::string ratio;    ///< the second over the first, as far as the table tells
};

/// A data set of Banquero's tables, and our volume for it.
struct PublishedDataSet
{
  std::string name;   ///< name in the paper
  int side;           ///< voxels along each axis
  std::string file;   ///< path in the folder of volumes
  std::string remark; ///< our volume before it was resampled
  std::vector<PublishedSteps> steps;
  std::optional<PublishedRates> rates;
};

/// All data sets of M. Banquero, E. Ortiz, B. Rossi, "Realtime volume render en videojuegos", 2016.
const std::vector<PublishedDataSet>& PublishedDataSets();

/// The path of the Visible Male in the folder of volumes, which Volt and Banquero used.
extern const char* const VisMaleFile;

/// A volume as bytes with `side` voxels along each axis, in the same place.
/// @throws std::runtime_error when the file cannot be read
LoadedVolume LoadAtSize(const std::string& path, int side);

}

#endif
