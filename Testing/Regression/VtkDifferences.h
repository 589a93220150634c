#ifndef Varimarch_Testing_VtkDifferences_h
#define Varimarch_Testing_VtkDifferences_h

#include "Core/Quality/ImageError.h"

#include <string>
#include <vector>

/// The recorded difference of a picture by VTK's own mapper to its baseline.
struct VtkDifference
{
  std::string name;
  varimarch::ImageError error;
};

/// Writes the table VtkDifferences.csv.
/// @throws std::runtime_error if it cannot be written
void WriteDifferencesOfVtk(
  const std::string& folder, const std::vector<VtkDifference>& differences);

/// Compares a difference with the one that the table in `folder` records: VTK's mapper must be
/// neither better nor worse than by half.
/// @return what is wrong, in a sentence; empty: nothing
/// @throws std::runtime_error if the table does not have the name
std::string FaultsOfVtk(
  const std::string& folder, const std::string& name, const varimarch::ImageError& error);

#endif
