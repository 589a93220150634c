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

namespace varimarch
{

/// Writes a scene to a file, which is never left incomplete. @throws std::runtime_error that names
/// the file
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
  /// The file of the segments of a volume that belong to the copy; empty if the folder cannot be
  /// written to.
  QString SegmentsPath(int volume = 0) const;

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
  bool IsSaved(int volume) const;
  void RemoveSegments(int volume);

  /// The labels that are in the file of a volume's segments.
  struct SavedLabels
  {
    vtkSmartPointer<vtkImageData> numbers; ///< null if there is no file
    int version = 0;
  };

  SceneModel* model;
  QString path;
  std::unique_ptr<QLockFile> lock;
  QTimer delay;
  BackgroundTask segmentWriting;
  std::array<SavedLabels, MostVolumes> saved;
};

}

#endif
