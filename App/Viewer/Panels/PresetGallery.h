#ifndef Varimarch_Viewer_PresetGallery_h
#define Varimarch_Viewer_PresetGallery_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/OwnPresets.h"
#include "Viewer/Model/SceneModel.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QWidget>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;
class QToolButton;

namespace varimarch
{

/// Renders thumbnails of a volume with different presets. A thread renders them one after the other
/// from a small copy of the volume, so that they cost the window little time and memory.
class PresetThumbnails : public QObject
{
  Q_OBJECT

public:
  explicit PresetThumbnails(QObject* parent = nullptr);

  /// Starts over. No thumbnails of earlier calls are emitted afterwards.
  /// @param presets  in units of the data
  void Draw(const std::shared_ptr<const Study>& study, std::vector<Preset> presets, QSize pixels);

  /// Pauses briefly before the next thumbnail, because the user is working.
  void Rest();

signals:
  /// @param index  of the preset
  void Drawn(int index, const QImage& picture);

private:
  BackgroundTask task;
  std::shared_ptr<std::atomic<bool>> rests; ///< asks the latest work to pause
};

/// The built-in presets and the user's own, as thumbnails of the current volume. Those for scans of
/// other kinds are folded away, and those that cannot show the volume are left out. A click applies
/// a preset; a button saves the current look as a new one.
class PresetGallery : public QWidget
{
  Q_OBJECT

public:
  /// @param folder  of the user's presets
  PresetGallery(SceneModel* model, const QString& folder, QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void MakeList();
  void MakeFold();
  QWidget* MakeButtons();
  void Update(ScenePart part);
  void ListPresets();
  void AddBuiltIn(const std::string& name);
  QListWidgetItem* AddItem(int row, const QString& title, const QString& tip, const Preset& preset);
  void AddOwn(const QString& name);
  void Fold(bool isFolded);
  void DrawPictures();
  void ShowPicture(int index, const QImage& picture);
  void MarkCurrent();
  void Choose(int row);
  void Keep();
  void Rename(QListWidgetItem* item);
  void Remove();
  bool IsOwn(int row) const;
  void Attempt(const std::function<void()>& action);

  SceneModel* model;
  OwnPresets ownPresets;
  PresetThumbnails thumbnails;
  /// One for each row, in units of the data: those for this kind of scan, the user's, the others.
  std::vector<Preset> presets;
  int firstOther = 0;         ///< row of the first preset for other kinds of scans
  std::vector<int> drawnRows; ///< rows whose thumbnails are being rendered
  QListWidget* list;
  QToolButton* fold;
  QPushButton* keep;
  QPushButton* remove;
  QLabel* problem; ///< error of the last action; hidden if there was none
};

}

#endif
