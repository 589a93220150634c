#ifndef Varimarch_Scene_OrbitBenchmark_h
#define Varimarch_Scene_OrbitBenchmark_h

#include "Scene/OffscreenView.h"

#include <string>
#include <vector>

namespace varimarch
{

/// One view of an orbit, drawn by ours and by a mapper of VTK. Errors are those of VTK's picture
/// from ours, in 1/255 of the brightest.
struct OrbitPicture
{
  double degrees; ///< from where the scene has the eye
  double oursMs;
  double theirsMs;
  double rootMeanSquare;
  double largest; ///< of a channel of a pixel
};

/// Draws a scene from all around by two mappers, a view at a time, so that a program can go on
/// with other things between.
class OrbitBenchmark
{
public:
  /// Both have drawn a first picture, which pays for what is made once.
  /// @param theirs  can blend as the scene asks for, see CanBlend
  /// @param image   the scene's volume; must outlive this
  /// @throws std::runtime_error one sentence, where there is no OpenGL
  OrbitBenchmark(const Scene& scene, vtkImageData* image, MapperKind theirs, int pictures);

  bool IsDone() const { return int(this->drawn.size()) == this->count; }
  void DrawNext();

  const std::vector<OrbitPicture>& Pictures() const { return this->drawn; }

private:
  OffscreenView ours;
  OffscreenView theirs;
  int count;
  std::vector<OrbitPicture> drawn;
};

/// What most of the pictures are like, and the worst of the errors; of at least one.
struct OrbitSummary
{
  double medianOursMs;
  double medianTheirsMs;
  double rootMeanSquare; ///< over all pictures
  double largest;
};

OrbitSummary SummaryOf(const std::vector<OrbitPicture>& pictures);

/// A line of names, then one for each picture: "degrees,ours_ms,vtk_ms,rmse_255,largest_255".
std::string CsvOf(const std::vector<OrbitPicture>& pictures);

}

#endif
