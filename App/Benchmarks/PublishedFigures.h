#ifndef Varimarch_Benchmarks_PublishedFigures_h
#define Varimarch_Benchmarks_PublishedFigures_h

#include "CommandLine/Truth.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A picture as a figure of Banquero's paper has it.
struct PublishedFigure
{
  std::string file; ///< file name in the report's folder
  std::string text; ///< caption: what the figure shows, and how our picture was made
};

/// Draws figures 3, 5, 6, 7, 9 and 10 of the paper into a folder, of volumes that are not missing.
/// @param volumes  the folder of volumes
/// @param side     side of each picture of a figure [pixels]
/// @throws std::runtime_error when a file cannot be written
std::vector<PublishedFigure> DrawPublishedFigures(
  const std::string& volumes, int side, const std::string& folder, const OnStep& onStep);

}

#endif
