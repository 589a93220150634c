#ifndef Varimarch_Benchmarks_BenchMethods_h
#define Varimarch_Benchmarks_BenchMethods_h

#include "Comparison/VoxelStorage.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Model/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

class vtkComparisonMapper;

namespace varimarch
{

/// A mapper with fixed choices and one remaining setting, which a benchmark sweeps.
struct BenchMethod
{
  std::string name;  ///< name on the command line and in tables
  std::string title; ///< name in legends and reports
  MapperKind kind;
  /// One of vtkComparisonMapper::Methods, which then draws instead of the mapper of this kind.
  std::optional<int> comparison = {};
  VoxelStorage storage = VoxelStorage::Bits16; ///< only for comparison methods
  bool correctedTable = false;                 ///< vtkComparisonMapper::CorrectedTable
};

std::vector<std::string> BenchMethodNames();

/// One of the settings that a method is swept over.
struct BenchSetting
{
  std::string label; ///< label, unique within the method, such as "0.5 voxels"
  RenderOptions options;
};

/// A method and the settings at which it is measured, coarsest first.
struct BenchRun
{
  BenchMethod method;
  std::vector<BenchSetting> settings;
};

/// The work-precision runs of a scene: those of the chosen methods that apply to it. Our defaults
/// are swept over error tolerances, all others over sample distances.
/// @param chosen  names of the methods; empty: all
std::vector<BenchRun> WorkPrecisionRuns(
  const Scene& scene, vtkImageData* image, const std::vector<std::string>& chosen);

/// The options with a sample distance, given in smallest voxel spacings.
BenchSetting AtDistance(vtkImageData* image, double voxels, const RenderOptions& options);

/// A scene in a window, drawn by a method of the benchmarks.
class MethodView
{
public:
  /// @throws std::runtime_error if there is no OpenGL
  MethodView(const BenchMethod& method, const Scene& scene, vtkImageData* image);
  ~MethodView();

  OffscreenView& Offscreen() { return this->view; }
  void SetOptions(const RenderOptions& options);

  double UsedSampleDistanceMm() const; ///< the distance of the last frame
  double EstimatedError();             ///< our mapper's estimate, [0, 1]; 0 for others
  std::optional<double> Fetches();     ///< FetchesPerPixel; empty for methods of others
  std::optional<double> Bytes();       ///< GraphicsBytes; empty for VTK's mappers

private:
  OffscreenView view;
  vtkSmartPointer<vtkComparisonMapper> comparison; ///< null unless the method is one of others
};

/// The smallest voxel spacing [mm].
double VoxelMm(vtkImageData* image);

/// Converts 1/255 of the volume's value range to units of the data.
double Variation(vtkImageData* image, double variation255);

}

#endif
