#ifndef Varimarch_Viewer_SceneModel_h
#define Varimarch_Viewer_SceneModel_h

#include "Scene/ImageStatistics.h"
#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"
#include "Viewer/Model/Gesture.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <vector>

namespace varimarch
{

/// A volume in memory, and what of it takes a look at all voxels.
struct Study
{
  LoadedVolume volume;
  ImageStatistics statistics;
};

/// What of a scene has changed.
enum class ScenePart
{
  Volume, ///< and with it everything else
  Look,
  Camera,
  Cuts,
  Slices,
  Measures, ///< distances, angles, boxes
  Render,
  Background,
};

/// The one object that holds what the window shows: a volume, and its scene as plain data. Panels
/// edit it and know nothing of each other; views listen. Every edit is a step that can be undone.
/// Values of its look are in units of the data.
class SceneModel : public QObject
{
  Q_OBJECT

public:
  /// Edits with the same gesture, such as all positions of one drag, are one step.
  static constexpr int NoGesture = -1;

  explicit SceneModel(QObject* parent = nullptr);

  /// None before the first volume.
  std::shared_ptr<const Study> CurrentStudy() const { return this->state.study; }
  const Scene& CurrentScene() const { return this->state.scene; }

  /// Takes another volume, with a preset that suits it, and forgets the steps that were of the
  /// last.
  void Open(const VolumeSource& source, std::shared_ptr<const Study> opened);

  /// Takes a scene as it was saved, with its volume.
  void Restore(const Scene& saved, std::shared_ptr<const Study> opened);

  /// Takes another form of the volume that is shown, such as rectified; all else stays. A step, so
  /// that the form before stays in memory.
  void Exchange(const VolumeSource& source, std::shared_ptr<const Study> form, const QString& name);

  /// The form of the volume that the last exchange took away; none without one.
  std::shared_ptr<const Study> ExchangedStudy() const { return this->exchanged; }

  /// Changes a part of the scene.
  /// @param name  of the step, for "Undo NAME"
  void Edit(ScenePart part, const QString& name, const std::function<void(Scene&)>& change,
    int gesture = NoGesture);

  /// Replaces the look; one in relative values is brought into units of the data.
  void SetLook(const Look& look, const QString& name, int gesture = NoGesture);

  /// The same of a preset: its look, its quality and its background, in one step.
  void SetPreset(const Preset& preset, const QString& name);

  QUndoStack* History() { return &this->history; }

signals:
  void Changed(varimarch::ScenePart part);

private:
  class EditStep;

  struct State
  {
    std::shared_ptr<const Study> study;
    Scene scene;
  };

  void Replace(const std::vector<ScenePart>& parts, const State& newState);

  State state;
  std::shared_ptr<const Study> exchanged;
  QUndoStack history;
};

}

Q_DECLARE_METATYPE(varimarch::ScenePart)
Q_DECLARE_METATYPE(varimarch::FileSource)
Q_DECLARE_METATYPE(varimarch::VolumeSource)
Q_DECLARE_METATYPE(std::vector<varimarch::SeriesSummary>)
Q_DECLARE_METATYPE(std::shared_ptr<const varimarch::Study>)

#endif
