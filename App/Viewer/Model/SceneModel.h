#ifndef Varimarch_Viewer_SceneModel_h
#define Varimarch_Viewer_SceneModel_h

#include "Scene/Model/Scene.h"
#include "Scene/Segments/SegmentEditing.h"
#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Model/Study.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// Returns a new gesture number, > 0. All edits of one drag, or of one visit to a popover, share a
/// number, which makes them a single undo step.
int NewGesture();

/// The part of a scene that has changed.
enum class ScenePart
{
  Volume, ///< and every other part
  Time,   ///< the time of the volume that the scene names
  Voxels, ///< voxels of another time, or counts of all times; not a part of the scene
  Look,
  Lights,
  Camera,
  Cuts,
  Slices,
  Measures, ///< and annotations
  KeyImages,
  Labels,       ///< another segmentation, or none
  Segments,     ///< their names and looks
  Overlays,     ///< the volumes over the first: which, where, and how they look in slices
  EditedVolume, ///< the volume whose look is edited; not a part of the scene
  Render,
  Background,
};

/// True if the volume whose look is edited is another one.
inline bool IsOtherLookVolume(ScenePart part)
{
  return part == ScenePart::Volume || part == ScenePart::EditedVolume;
}

/// The data behind the window: a volume and its scene as plain data. Panels edit the model and do
/// not know each other; views observe it. Every edit is an undo step. The look's values are in
/// units of the data. The scene's segments are those of the study's labels, in the same order.
/// Volumes are numbered: 0 is the first, i the overlay i - 1.
class SceneModel : public QObject
{
  Q_OBJECT

public:
  /// Edits with the same gesture number, such as all positions of one drag, form one undo step.
  static constexpr int NoGesture = -1;

  explicit SceneModel(QObject* parent = nullptr);

  /// Null before the first volume.
  std::shared_ptr<const Study> CurrentStudy() const { return this->state.study; }
  const Scene& CurrentScene() const { return this->state.scene; }

  /// Texts of the measurements, which are made once for all views.
  const MeasureTexts& Texts();

  /// Replaces the volume, chooses a preset that suits it, and clears the undo history.
  void Open(const VolumeSource& source, std::shared_ptr<const Study> opened);

  /// Replaces a coarse copy of a volume by the volume, and keeps everything else but the labels of
  /// its voxels. The undo history is cleared.
  void Complete(std::shared_ptr<const Study> whole);

  /// Replaces the volume and the scene by a saved one.
  void Restore(const Scene& saved, std::shared_ptr<const Study> opened);

  /// Replaces the volume by another form of it, such as the rectified one, and keeps everything
  /// else. This is an undo step, so the previous form stays in memory.
  void Exchange(
    const VolumeSource& source, const std::shared_ptr<const Study>& form, const QString& name);

  /// The form that the last exchange replaced; null without one.
  std::shared_ptr<const Study> ExchangedStudy() const { return this->exchanged; }

  /// The time of the scan that the scene names, counted from 0. Until it has been read, the voxels
  /// are those of another time, CurrentStudy()->volume.times.current.
  int ChosenTime() const;

  /// Names another time of a scan with several. This is an undo step.
  void ChooseTime(int time, const QString& name, int gesture = NoGesture);

  /// Shows the voxels of a time of a volume, which the scene then names.
  void ShowTime(const LoadedVolume& ofTime, int volume = 0);

  /// Takes the counts of all times of the scan.
  void TakeCounts(std::shared_ptr<const ImageStatistics> allTimes);

  /// Shows labels over a volume. This is an undo step.
  /// @param labelled  the volume with these labels
  void ShowLabels(const SceneLabels& labels, const std::shared_ptr<const Study>& labelled,
    const QString& name, int volume = 0);

  /// Shows the edited volume without labels. This is an undo step.
  void CloseLabels(const QString& name);

  /// Adds a segment without voxels to the edited volume, and labels if there are none. This is an
  /// undo step.
  void AddSegment(const QString& segmentName, const QString& name);

  /// Changes voxels of a volume's labels, which may have been changed already. This is an undo
  /// step, which keeps the changed box and no copy of the labels.
  void ChangeLabels(const LabelChange& change, const QString& name, int volume = 0);

  /// Takes the file that the labels of a volume have been written to.
  /// @param segments  of the scene, with the values that they have in the file
  void TakeSavedLabels(const std::string& path, const std::vector<Segment>& segments,
    const QString& name, int volume = 0);

  /// True unless the file that the scene names holds the segments of a volume with these voxels, or
  /// there are none.
  bool HasUnsavedLabels(int volume = 0) const;

  /// The first volume with such labels; empty without any.
  std::optional<int> VolumeWithUnsavedLabels() const;

  /// A number that is another one whenever the voxels of a volume's labels are others.
  int LabelVersion(int volume) const;

  /// True unless sizes and statistics of segments are being counted, which a thread does after each
  /// change of their voxels. ScenePart::Labels changes when it is done.
  bool AreSegmentsCounted() const;

  /// Counts at once what is not counted yet, for a report, or for an image in a file: the opacity
  /// of a segment depends on its size.
  void CountSegments();

  /// The number of the volume of a study, which may have other labels or another time by now; empty
  /// if it is no longer shown.
  std::optional<int> VolumeOf(const Study& study) const;

  /// Draws a further volume over the others. This is an undo step, and the volume becomes the
  /// edited one. Requires fewer than MostVolumes.
  void AddOverlay(
    const OverlaidVolume& overlay, std::shared_ptr<const Study> added, const QString& name);

  /// Takes an overlay away. This is an undo step.
  void RemoveOverlay(int overlay, const QString& name);

  /// Moves an overlay to another place in the list. This is an undo step.
  void MoveOverlay(int from, int to, const QString& name);

  /// The volume whose look and segments the panels edit.
  int EditedVolume() const { return this->edited; }
  void SetEditedVolume(int volume);

  /// The study of a volume; null before the first volume.
  std::shared_ptr<const Study> StudyOf(int volume) const;

  /// The edited volume and its look; the study is null before the first volume.
  std::shared_ptr<const Study> EditedStudy() const;
  const Look& EditedLook() const;
  const std::optional<SceneLabels>& EditedLabels() const;
  /// The scene with the look of the edited volume.
  Scene EditedScene() const;

  /// Changes a part of the scene.
  /// @param name  of the undo step, for "Undo NAME"
  void Edit(ScenePart part, const QString& name, const std::function<void(Scene&)>& change,
    int gesture = NoGesture);

  /// Changes several parts of the scene in one step.
  void EditParts(const std::vector<ScenePart>& parts, const QString& name,
    const std::function<void(Scene&)>& change, int gesture = NoGesture);

  /// Replaces the look of the edited volume. A relative look is converted to units of the data.
  void SetLook(const Look& look, const QString& name, int gesture = NoGesture);

  /// Applies a preset to the edited volume, and its quality and background if that is the first
  /// volume, in one step.
  void SetPreset(const Preset& preset, const QString& name);

  QUndoStack* History() { return &this->history; }

signals:
  void Changed(varimarch::ScenePart part);

private:
  class EditStep;
  class LabelStep;

  struct State
  {
    std::shared_ptr<const Study> study;
    Scene scene;
  };

  /// The current scene with another study.
  State WithStudy(std::shared_ptr<const Study> study) const;

  static void TakeTime(State& taken, int volume);
  static void TakeSegments(State& taken, int volume);
  void TakeVersionOfFile(State& taken, int volume);
  static void TakeOverlays(State& taken);
  void PushLabels(State changed, const QString& name);
  void RenewLabels(int volume, int version);
  std::optional<int> VolumeToCount() const;
  void CountInThread();
  void TakeCounted(int volume, const std::shared_ptr<const Study>& counted);
  void PushOverlays(State changed, const QString& name, int newEdited);
  void Replace(const std::vector<ScenePart>& parts, const State& newState);

  State state;
  std::shared_ptr<const Study> exchanged;
  MeasureTexts texts;
  int edited = 0;
  /// Versions of labels by the files that they were read from, or written to last.
  std::map<std::string, int> versionsInFiles;
  int lastLabelVersion = 0;
  BackgroundTask counting;
  QUndoStack history;
};

}

Q_DECLARE_METATYPE(varimarch::ScenePart)
Q_DECLARE_METATYPE(varimarch::FileSource)
Q_DECLARE_METATYPE(varimarch::SceneLabels)
Q_DECLARE_METATYPE(varimarch::VolumeSource)
Q_DECLARE_METATYPE(std::vector<varimarch::SeriesSummary>)
Q_DECLARE_METATYPE(std::shared_ptr<const varimarch::Study>)

#endif
