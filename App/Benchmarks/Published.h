#ifndef Varimarch_Benchmarks_Published_h
#define Varimarch_Benchmarks_Published_h

#include "CommandLine/Truth.h"
#include "Scene/Model/Scene.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <vtkImageData.h>

#include <filesystem>
#include <string>
#include <vector>

namespace varimarch
{

// The scenes and the figures of M. Banquero, E. Ortiz, B. Rossi, "Realtime volume render en
// videojuegos", 2016, have in common.

/// E in 1/255 of the values' range: that of figure 10 without artefacts.
constexpr double PublishedVariation255 = 4.0;

/// The path of the Visible Male in the folder of volumes, which Volt and Banquero used.
extern const char* const VisMaleFile;

/// A volume as bytes with `side` voxels along each axis, in the same place.
/// @throws std::runtime_error when the file cannot be read
LoadedVolume LoadAtSize(const std::string& path, int side);

/// A grey ramp, clear below a threshold, and soft enough that rays reach deep into the volume.
Look SoftLook(vtkImageData* image);

/// The paper's loop: plain ray casting, or with the field of variations for E [1/255].
RenderOptions PublishedLoop(vtkImageData* image, bool hasField, double variation255);

/// A picture as a figure of Banquero's paper has it.
struct PublishedFigure
{
  std::string file; ///< file name in the folder of the results
  std::string text; ///< caption: what the figure shows, and how our picture was made
};

/// Draws figures 3, 5, 6, 7, 9 and 10 of the paper into a folder, of volumes that are not missing.
/// @param volumes  the folder of volumes
/// @param side     side of each picture of a figure [pixels]
/// @throws std::runtime_error when a file cannot be written
std::vector<PublishedFigure> DrawPublishedFigures(
  const std::string& volumes, int side, const std::filesystem::path& folder, const OnStep& onStep);

}

#endif
