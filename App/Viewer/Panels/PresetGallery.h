#ifndef Varimarch_Viewer_PresetGallery_h
#define Varimarch_Viewer_PresetGallery_h

#include "Viewer/Model/OwnPresets.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/View/PresetThumbnails.h"

#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace varimarch
{

/// The built-in presets and the user's own, as thumbnails of the current volume. A click applies a
/// preset; a button saves the current look as a new one.
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
  QWidget* MakeButtons();
  void Update(ScenePart part);
  void ListPresets();
  void AddItem(const QString& title, const QString& tip, const Preset& preset);
  void AddOwn(const QString& name);
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
  std::vector<Preset> presets; ///< one for each row, in units of the data; the user's come last
  std::vector<int> drawnRows;  ///< rows whose thumbnails are being rendered
  QListWidget* list;
  QPushButton* keep;
  QPushButton* remove;
  QLabel* problem; ///< error of the last action; hidden if there was none
};

}

#endif
