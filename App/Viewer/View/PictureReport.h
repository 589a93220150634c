#ifndef Varimarch_Viewer_PictureReport_h
#define Varimarch_Viewer_PictureReport_h

#include "Scene/Pipeline/ScenePipeline.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

/// Progress and error of the image of our mapper that is shown.
struct PictureNumbers
{
  int averaged = 1;       ///< frames in the mean that is shown; 0 until the first is complete
  int mostAveraged = 1;   ///< frames in the mean when it is complete
  double drawnPart = 1.0; ///< finished fraction of all these frames, [0, 1]
  double errorTolerance = 0.0;
  bool keepsTolerance = true;  ///< false if pixels may exceed the error tolerance
  double estimatedError = 0.0; ///< estimated error of 99.9 % of the pixels, [0, 1]
  bool isCoarse = false;       ///< true for a coarse level or copy of a volume in its file
  /// A bound of the error of coarse voxels in an image that still takes finer ones.
  std::optional<double> refinedError = {};
  bool isRefined = false; ///< true for an image of coarse and fine voxels that needs no finer ones
  bool voxelsFit = true;  ///< false if the fine voxels that are to come may not fit in the memory
  /// The reason why nothing is visible, see EmptyPicture.h; empty if something is.
  std::string reasonForNothing = {};
  /// False for an image whose pixels have no bound: one of fewer rays, or one of a moving view,
  /// which leaves ambient occlusion out.
  bool isFine = true;
  bool isOutOfDate = false; ///< true if the scene has changed since
  bool isMoving = false;    ///< true while the user turns the view
};

PictureNumbers NumbersOf(vtkVariationFieldVolumeMapper* mapper);

/// The parts of a scene that a mapper of VTK leaves out, one line each, such as "masks not
/// supported"; empty if it draws the whole scene.
QStringList LeftOutByVtk(MapperKind kind, const Scene& scene);

/// Text in the corner of an image: its rendering time and its error.
/// @param ours     the numbers of our mapper; empty for VTK's
/// @param seconds  until the whole image was rendered
QString PictureReport(
  const std::optional<PictureNumbers>& ours, MapperKind kind, const Scene& scene, double seconds);

}

#endif
