#ifndef Varimarch_CommandLine_VolumeOptions_h
#define Varimarch_CommandLine_VolumeOptions_h

#include "Scene/Scene.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// Which volume to read: the first argument of every subcommand, the layout of a raw file, the
/// choice of a DICOM series, and how its slices are to lie.
class VolumeOptions
{
public:
  void AddTo(CLI::App& command, const std::string& inputDescription);

  const std::string& Input() const { return this->input; }

  /// The file, folder or procedural volume that an input names.
  VolumeSource SourceOf(const std::string& anyInput) const;

  /// For an input that says itself what its voxels are, such as a scene file.
  /// @param kind  of the input, for the message
  /// @throws CLI::ValidationError when there are options for a raw file or a DICOM folder
  ///   nevertheless
  void RefuseFileOptions(const std::string& kind) const;

  /// The volume of a scene file, with what the options override.
  /// @throws CLI::ValidationError when they cannot
  VolumeSource Override(const VolumeSource& inScene) const;

private:
  void RefuseSeries(const std::string& kind) const;
  void RefuseRectify() const;

  std::string input;
  bool rectify = false;
  std::string series;
  std::string rawDimensions;
  std::string rawType;
  std::vector<double> rawSpacing;
  std::string rawByteOrder;
  std::int64_t rawHeaderBytes = 0;
};

}

#endif
