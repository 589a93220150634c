#ifndef Varimarch_CommandLine_Commands_h
#define Varimarch_CommandLine_Commands_h

#include "Core/Fields/VariationField.h"
#include "LabelArguments.h"
#include "Scene/Reference/ReferencePicture.h"
#include "SceneArguments.h"
#include "VolumeOutput.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace varimarch
{

// In the arguments of commands, commandText is the whole command line, for the results, and
// jsonPath a file for the results, or empty.

struct RenderArguments
{
  std::string commandText;
  SceneArguments scene;
  LabelArguments labels;
  std::vector<std::string> overlays; ///< files of volumes over the first
  MapperKind renderer = MapperKind::Varimarch;
  std::string outputPath;         ///< path of the PNG or DICOM file
  bool overwrites = false;        ///< true to replace an existing DICOM file
  double graphicsMegabytes = 0.0; ///< limit of our mapper's graphics memory [MB]; 0: no limit
  int repeats = 0;                ///< number of further frames, whose median time is reported
  std::string jsonPath;
};

struct CompareArguments
{
  std::string commandText;
  SceneArguments scene;
  std::string outputFolder;
  int rounds = 5;     ///< number of frames of each mapper, >= 1
  PathSettings paths; ///< paths of the truth, if it is to be traced
  std::string jsonPath;
};

struct InfoArguments
{
  std::string commandText;
  VolumeArguments volume;
  LabelArguments labels;
  int bins = 32; ///< number of bars of the histogram, >= 1
  std::string jsonPath;
};

struct ConvertArguments
{
  VolumeArguments volume;
  VolumeOutput output;
};

struct FieldArguments
{
  VolumeArguments volume;
  VolumeOutput output;
  double tolerance = 0.0; ///< E of VariationField [units of the data], >= 0
  VoxelDistance distance = VoxelDistance::Euclidean;
};

struct LookArguments
{
  SceneArguments scene; ///< only its volume and look
  std::string output;
  bool overwrites = false; ///< true to replace an existing file
};

/// Draws a scene into a PNG or DICOM file.
void RunRender(const RenderArguments& arguments);

/// Draws a scene with our mapper and VTK's, and writes images and tables of their differences.
void RunCompare(const CompareArguments& arguments);

/// Prints a description of a volume.
void RunInfo(const InfoArguments& arguments);

/// Writes a volume in another format.
void RunConvert(const ConvertArguments& arguments);

/// Writes the field of variations of a volume as a volume.
void RunField(const FieldArguments& arguments);

/// Writes the look of a volume or scene in the format of another program.
void RunLook(const LookArguments& arguments);

/// Adds the subcommands that fill these arguments and run.
void AddCommands(CLI::App& program, const std::string& commandText);

}

#endif
