#ifndef Varimarch_Viewer_ExportActions_h
#define Varimarch_Viewer_ExportActions_h

#include <QObject>
#include <QString>

#include <functional>
#include <string>

class QMainWindow;
class QMenu;
class QWidget;

namespace varimarch
{

class PictureMaker;
class SceneModel;
class TimeBar;
struct Study;

/// Exports what is shown: images, movies and reports, to files or to an archive.
class ExportActions : public QObject
{
  Q_OBJECT

public:
  /// The model that is shown, in a view whose size exported images have, at the speed of the bar of
  /// times.
  struct Context
  {
    SceneModel* model;
    const QWidget* view;
    const TimeBar* timeBar;
  };

  ExportActions(const Context& context, QMainWindow* window);

  void AddTo(QMenu* file);

signals:
  void Saved(const QString& path);

private:
  /// Words of a movie's dialogs.
  struct MovieTexts
  {
    QString title;
    QString waiting;
    QString name; ///< suggested file name
  };

  /// Shows a stage of a change, by the part of it that is done, [0, 1].
  using SceneStage = std::function<void(PictureMaker&, const Study&, double)>;

  void AddChangesTo(QMenu* file);
  void ExportPicture();
  void SendPicture();
  /// Asks for a file and lets a function write it, while a dialog shows its progress.
  void ExportMovie(const MovieTexts& texts,
    const std::function<bool(const QString&, const std::function<bool(double)>&)>& write);
  void ExportTurntable();
  void ExportTimes();
  void ExportReport();
  void ExportChange(const MovieTexts& texts, const SceneStage& show);
  void ExportCuts();
  void ExportLookChange(const std::string& preset);
  void ListLooksToChange(QMenu* menu);

  SceneModel* model;
  const QWidget* view;
  const TimeBar* timeBar;
  QMainWindow* window;
};

}

#endif
