#ifndef Varimarch_Viewer_ViewMenu_h
#define Varimarch_Viewer_ViewMenu_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/View/SliceCorners.h"
#include "Viewer/View/ViewLayout.h"

#include <QMenu>

namespace varimarch
{

/// The menu of how the scan is seen: standard views of the camera, projection, background, windows
/// of the slices, arrangement of the views, panels, theme.
class ViewMenu : public QMenu
{
  Q_OBJECT

public:
  ViewMenu(SceneModel* model, ViewLayout* layout, QWidget* parent);

  /// Adds a menu with what can be done with the times of a scan.
  void AddTimes(const QList<QAction*>& actions);

  /// The menu of the panels, which the window fills.
  QMenu* Panels() { return this->panels; }

  /// The texts over slices that the user has chosen, in this run or before.
  CornerTexts ChosenCornerTexts() const;

signals:
  void CornerTextsChosen(const varimarch::CornerTexts& shown);

private:
  void AddStandardViews();
  void AddProjection();
  void AddWindows();
  void AddCornerTexts();
  void AddArrangements();
  void AddFullScreen();
  void ListWindows(QMenu* windows);
  void ChooseBackground();

  SceneModel* model;
  ViewLayout* layout;
  QMenu* panels;
};

}

#endif
