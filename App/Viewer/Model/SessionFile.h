#ifndef Varimarch_Viewer_SessionFile_h
#define Varimarch_Viewer_SessionFile_h

#include "Viewer/Model/SceneModel.h"

#include <QObject>
#include <QString>
#include <QTimer>

namespace varimarch
{

/// Writes a scene, complete or not at all. @throws std::runtime_error that names the file
void WriteScene(const Scene& scene, const QString& path);

/// Keeps a copy of the scene on disk while it is edited, so that nothing is lost when the program
/// does not come to its end. The copy goes when it does.
class Autosave : public QObject
{
  Q_OBJECT

public:
  /// @param path  of the copy; its folder is made
  Autosave(SceneModel* model, const QString& path, QObject* parent = nullptr);

  /// Whether a program that did not come to its end has left a copy.
  bool HasCopy() const;
  QString Path() const { return this->path; }

  /// Takes the copy away: the program ends as it should.
  void Remove();

private:
  void Save();

  SceneModel* model;
  QString path;
  QTimer delay;
};

}

#endif
