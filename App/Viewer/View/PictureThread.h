#ifndef Varimarch_Viewer_PictureThread_h
#define Varimarch_Viewer_PictureThread_h

#include "Scene/Pipeline/ScenePipeline.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/View/PictureReport.h"

#include <QImage>
#include <QObject>
#include <QSize>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <vector>

namespace varimarch
{

/// The voxels that a pipeline draws.
struct ShownVoxels
{
  vtkSmartPointer<vtkImageData> volume;
  std::shared_ptr<const LabelMap> labels; ///< null without a segmentation
  std::vector<OverlayVoxels> overlays;
};

/// The voxels of a study, not copied.
ShownVoxels VoxelsOf(const Study& study);

/// Takes a part of a scene into the pipeline that draws it. For a new volume the pipeline must be a
/// new one of this scene.
/// @return false for a part that no picture of the volume shows
bool ShowPart(
  ScenePart part, const Scene& scene, const ShownVoxels& voxels, ScenePipeline& pipeline);

struct LoadedVolume;

/// Copies of volumes for another thread, which share their voxels. A volume has one copy for as
/// long as somebody else holds it: whoever draws a time again that was played before knows it by
/// the copy.
class VolumeCopies
{
public:
  vtkSmartPointer<vtkImageData> Of(const LoadedVolume& volume);

private:
  struct Copy
  {
    vtkSmartPointer<vtkImageData> source;
    vtkSmartPointer<vtkImageData> copy;
  };

  void ForgetReleased();

  std::vector<Copy> copies;
};

/// The number of frames in the mean of a view at rest.
constexpr int RefiningPictures = 8;

/// A picture that is wanted.
struct WantedPicture
{
  QSize pixels;
  double picturesPerSecond = 0.0; ///< as OffscreenView::SetPicturesPerSecond
  bool refines = false;           ///< true for a further part or frame of the picture before it
  bool isSingle = false; ///< true for one frame in one piece, at rest also as a float image
};

/// A picture that the thread has drawn.
struct ThreadPicture
{
  QImage image; ///< over the background of the scene; smaller than wanted while the view moves
  PictureNumbers numbers;
  double seconds = 0.0;                    ///< the time to draw it, or this part of it
  vtkSmartPointer<vtkImageData> mask = {}; ///< as ScenePipeline::Mask
  /// The frame as a float image, see OffscreenView::FloatImage; null unless it was wanted.
  vtkSmartPointer<vtkImageData> floats = {};
  WantedPicture wanted;
  int changes = 0; ///< number of changes that had been taken for it
};

/// A thread that draws our pictures of a scene, so that the thread of the window never waits for
/// one. It has a window without a display, a pipeline and a mapper of its own, and shares nothing
/// with others but voxels that nobody changes. Only the newest wish counts: pictures are not
/// queued.
class PictureThread : public QObject
{
  Q_OBJECT

public:
  explicit PictureThread(QObject* parent = nullptr);
  /// Waits until the picture at work is complete.
  ~PictureThread() override;

  /// Takes a part of a scene for the next picture. A new volume forgets the last picture, and none
  /// of the old volume follows.
  void Take(ScenePart part, const Scene& scene, const std::shared_ptr<const Study>& study);

  /// Draws a picture of what was taken, unless another wish comes before it is begun.
  void Draw(const WantedPicture& wanted);

  /// True while a picture is wanted or drawn.
  bool IsBusy() const;

  /// The last picture; null before the first one of a volume.
  const ThreadPicture* Last() const { return this->last ? &*this->last : nullptr; }

  /// True if the last picture shows all that was taken.
  bool IsLastCurrent() const { return this->last && this->last->changes == this->changes; }

signals:
  /// There is another Last() picture.
  void Drawn();

  /// The thread cannot draw here, for want of OpenGL or memory. This is the last signal.
  void Failed();

private:
  struct Work;

  void TakePicture();
  ShownVoxels SharedVoxels(const Study& study);

  std::unique_ptr<Work> work;           ///< shared with the thread
  VolumeCopies shared;                  ///< the volumes that the thread draws
  vtkSmartPointer<vtkImageData> copied; ///< the image whose copy the thread has
  int changes = 0;                      ///< number of changes that were taken
  std::optional<ThreadPicture> last;
};

/// Chooses the size of images that a thread draws while the view moves, so that a large view keeps
/// its rate. The mapper casts fewer rays by itself, but images must still be filled, read back and
/// copied, which takes time for every pixel. Both sides of an image are divided by a whole number.
/// Pixels between rays that are far apart show nothing more, and take time from rays.
class MovingImageSize
{
public:
  /// @param wanted  pixels of the view
  QSize Of(const QSize& wanted) const;

  /// Records an image of that size.
  /// @param seconds           its time for everything but its rays and the pixels between them [s]
  /// @param rayDistance       between rays [pixels of the image], at least 1
  /// @param allocatedSeconds  for the whole image
  void Took(const QSize& wanted, double seconds, double rayDistance, double allocatedSeconds);

  /// The time that is left for the rays of the next image [s]; never less than a half of all.
  double SecondsForRays(double allocatedSeconds) const;

private:
  int DivisorFor(const QSize& wanted) const;

  int divisor = 1;
  double otherSeconds = 0.0; ///< the time of the last image for everything but its rays
};

}

#endif
