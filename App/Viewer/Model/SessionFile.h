#ifndef Varimarch_Viewer_SessionFile_h
#define Varimarch_Viewer_SessionFile_h

#include "Viewer/Model/SceneModel.h"

#include <QObject>
#include <QString>
#include <QTimer>

namespace varimarch
{

/// Writes a scene to a file, which is never left incomplete. @throws std::runtime_error that names
/// the file
void WriteScene(const Scene& scene, const QString& path);

/// The part of a scene that is a user's work: cuts, measurements, a look other than a preset, and
/// segments that look other than in their file. The camera, the slices and the quality are easily
/// set again. Empty if there is no work.
QString WorkText(const Scene& scene, const Study& study);

/// Saves a copy of the scene while it is edited, so that no work is lost if the program ends
/// unexpectedly. A normal exit deletes the copy.
class Autosave : public QObject
{
  Q_OBJECT

public:
  /// @param path  of the copy; its folder is created
  Autosave(SceneModel* model, const QString& path, QObject* parent = nullptr);

  /// True if an earlier run of the program ended unexpectedly and left a copy.
  bool HasCopy() const;
  QString Path() const { return this->path; }

  /// Deletes the copy, because the program ends normally.
  void Remove();

private:
  void Save();

  SceneModel* model;
  QString path;
  QTimer delay;
};

}

#endif
