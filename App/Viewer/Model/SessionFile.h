#ifndef Varimarch_Viewer_SessionFile_h
#define Varimarch_Viewer_SessionFile_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/SceneModel.h"

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <string>

namespace varimarch
{

/// Writes a scene to a file, which is never left incomplete.
/// @throws std::runtime_error that names the file, also if the scene is too large to be read again
void WriteScene(const Scene& scene, const QString& path);

/// The part of a scene that is a user's work: cuts, measurements, lights, a look other than a
/// preset, and segments that look other than in their file. The camera, the slices and the quality
/// are easily set again. Empty if there is no work.
QString WorkText(const Scene& scene, const Study& study);

/// Saves a copy of the scene while it is edited, so that no work is lost if the program ends
/// unexpectedly. Segments that are in no file of the user's are saved beside it, in the background.
/// A normal exit deletes the copy. Viewers that run at once have copies of their own: each locks
/// its own, and takes over the latest one that a program has left.
class Autosave : public QObject
{
  Q_OBJECT

public:
  /// @param folder  of the copies; made readable for this user only, because they name the scan
  Autosave(SceneModel* model, const QString& folder, QObject* parent = nullptr);

  /// True if an earlier run of the program ended unexpectedly and left a copy.
  bool HasCopy() const;
  /// The copy of this program; empty if the folder cannot be written to.
  QString Path() const { return this->path; }
  /// One of the MostVolumes files of segments that belong to the copy; empty if the folder cannot
  /// be written to.
  QString SegmentsPath(int file = 0) const;
  /// True for the path of one of these files.
  bool IsSegmentsPath(const std::string& candidate) const;

  /// Saves now, instead of two seconds after an edit. Segments with new voxels follow soon.
  void Save();

  /// Deletes the copy, because the program ends normally.
  void Remove();

private:
  bool TryToLock(const QString& copy);
  void SaveFrom(int volume);
  void SaveSegments(int volume);
  void SaveScene();
  void NameSegments(Scene& scene, int volume) const;
  void RemoveSegments(int file);

  /// The labels in a file of segments. Labels keep their file when volumes change places.
  struct SavedLabels
  {
    vtkSmartPointer<vtkImageData> numbers; ///< null if there is no file
    int version = 0;
  };

  int FileFor(int volume) const;
  bool IsSaved(int volume) const;
  bool IsNeeded(const SavedLabels& labels) const;

  SceneModel* model;
  QString path;
  std::unique_ptr<QLockFile> lock;
  QTimer delay;
  BackgroundTask segmentWriting;
  std::array<SavedLabels, MostVolumes> saved;
};

/// Knows whether the user's work on what is shown is in a file.
class SavedWork
{
public:
  SavedWork(const SceneModel* model, const Autosave* autosave)
    : model(model)
    , autosave(autosave)
  {
  }

  /// True also if there is no work.
  bool IsSaved() const { return this->CurrentWork() == this->saved; }
  /// Notes that the work is in a file now, or that nothing has been done yet.
  void TakeAsSaved() { this->saved = this->CurrentWork(); }
  /// Notes that the work is in no file.
  void TakeAsUnsaved() { this->saved.clear(); }

  /// Segments that were restored from the autosaved copy, which goes, are in no file.
  void ForgetAutosavedFiles(Scene& scene) const;

private:
  /// See WorkText; empty without a volume.
  QString CurrentWork() const;

  const SceneModel* model;
  const Autosave* autosave;
  QString saved; ///< the work that is in a file
};

}

#endif
