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

/// The presets that come with the program and those that the user has kept, as small pictures of
/// this volume. A click takes all of it; one button keeps what is shown at the moment.
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
  std::vector<Preset> presets; ///< of the rows, in units of the data; the user's come last
  std::vector<int> drawnRows;  ///< whose pictures are being drawn
  QListWidget* list;
  QPushButton* keep;
  QPushButton* remove;
  QLabel* problem; ///< with the last preset; hidden when there was none
};

}

#endif
