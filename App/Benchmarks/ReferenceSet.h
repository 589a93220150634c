#ifndef Varimarch_Benchmarks_ReferenceSet_h
#define Varimarch_Benchmarks_ReferenceSet_h

#include "CommandLine/Truth.h"
#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A scene of Data/References, by which other renderers can be judged.
struct JudgedScene
{
  std::string name; ///< name of its files
  Scene scene;
};

/// The scenes of Data/References. All volumes are procedural.
std::vector<JudgedScene> JudgedScenes();

/// Writes the reference's image of each scene as NAME.npy, all that a renderer must know to draw it
/// as NAME.json, and each volume once as NRRD. Data/References/README.md describes the files.
/// @throws std::runtime_error that names the file that cannot be written
void WriteReferences(const std::string& folder, const OnStep& onStep);

/// Writes only the images, drawn by a mapper at its defaults.
/// @throws std::runtime_error that names the file that cannot be written, or if the mapper reports
///         an error
void WritePicturesOf(MapperKind kind, const std::string& folder, const OnStep& onStep);

/// The bytes of a NumPy file of a float image: height x width x 4, the top row first.
std::string NpyBytesOf(vtkImageData* floatPicture);

}

#endif
