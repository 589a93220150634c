#ifndef Varimarch_Viewer_Menus_h
#define Varimarch_Viewer_Menus_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTools.h"
#include "Viewer/View/SliceCorners.h"
#include "Viewer/View/ViewLayout.h"

#include <QMenu>

#include <optional>

class QActionGroup;
class QMainWindow;

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

/// The Tools menu: the tools of the left mouse button, which are in a tool bar of the window too,
/// key images, and comparisons.
class ToolMenu : public QMenu
{
  Q_OBJECT

public:
  explicit ToolMenu(QMainWindow* window);

signals:
  void ToolChosen(varimarch::LeftButton button);
  void KeyImageWanted();
  /// @param kind  the mapper to compare with; std::nullopt for none
  void ComparisonChosen(std::optional<varimarch::MapperKind> kind);
  void WipeChosen(bool isOn);
  void BenchmarkWanted();

private:
  struct Tool;

  void AddTools();
  void AddAnnotations(QMenu* menu, QActionGroup* group);
  void AddComparisons();
  QAction* AddTool(const Tool& tool, QMenu* menu, QActionGroup* group);

  QMainWindow* window;
};

}

#endif
