#include "Viewer/Menus.h"

#include "Scene/Model/SceneCamera.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SliceWindows.h"
#include "Viewer/Theme.h"
#include "Viewer/Tools/ToolIcons.h"

#include <QActionGroup>
#include <QColorDialog>
#include <QMainWindow>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include <tuple>

namespace varimarch
{

namespace
{

QString SettingOf(CornerText text)
{
  return QStringLiteral("slices/text%1").arg(int(text));
}

}

ViewMenu::ViewMenu(SceneModel* model, ViewLayout* layout, QWidget* parent)
  : QMenu(tr("&View"), parent)
  , model(model)
  , layout(layout)
{
  this->AddStandardViews();
  this->addSeparator();
  this->AddProjection();
  this->addAction(tr("&Background…"), this, &ViewMenu::ChooseBackground)
    ->setObjectName("background");
  this->addSeparator();
  this->AddWindows();
  this->AddCornerTexts();
  this->AddArrangements();
  this->AddFullScreen();
  this->addSeparator();
  this->panels = this->addMenu(tr("Pa&nels"));
  this->panels->setObjectName("panels");
  this->addMenu(NewThemeMenu(parent));
}

void ViewMenu::AddStandardViews()
{
  // The keys of the numeric keypad, as in other viewers.
  const std::tuple<View, QString, QString> views[] = {
    { View::Anterior, tr("&Anterior"), "1" },
    { View::Posterior, tr("&Posterior"), "Shift+1" },
    { View::Left, tr("&Left"), "3" },
    { View::Right, tr("&Right"), "Shift+3" },
    { View::Superior, tr("&Superior"), "7" },
    { View::Inferior, tr("&Inferior"), "Shift+7" },
  };
  for (const auto& [direction, name, key] : views)
  {
    const auto show = [this, direction = direction]
    {
      if (this->model->CurrentStudy())
      {
        this->model->Edit(ScenePart::Camera, tr("standard view"),
          [direction](Scene& scene)
          {
            scene.camera.view = direction;
            scene.camera.pose.reset();
          });
      }
    };
    this->addAction(name, this, show, QKeySequence(key));
  }
}

void ViewMenu::AddProjection()
{
  QAction* const parallel = this->addAction(tr("Parall&el projection"));
  parallel->setObjectName("parallelProjection");
  parallel->setCheckable(true);
  parallel->setShortcut(QKeySequence("5"));
  parallel->setStatusTip(tr("No perspective: distant objects look as large as near ones"));
  connect(parallel, &QAction::triggered, this,
    [this](bool on)
    {
      this->model->Edit(ScenePart::Camera, tr("projection"),
        [on](Scene& scene) { scene.camera = WithProjection(scene.camera, on); });
    });
  connect(this->model, &SceneModel::Changed, parallel,
    [this, parallel] { parallel->setChecked(this->model->CurrentScene().camera.parallel); });
}

void ViewMenu::ChooseBackground()
{
  if (!this->model->CurrentStudy())
  {
    return;
  }
  const std::array<double, 3> before = this->model->CurrentScene().background;
  const auto edit = [this, gesture = NewGesture()](const std::array<double, 3>& rgb)
  {
    this->model->Edit(
      ScenePart::Background, tr("background"), [&](Scene& scene) { scene.background = rgb; },
      gesture);
  };
  const QColorDialog* const dialog = OpenLiveColorDialog(
    QColor::fromRgbF(before[0], before[1], before[2]),
    [edit](const QColor& color) {
      edit({ color.redF(), color.greenF(), color.blueF() });
    },
    this->parentWidget());
  connect(dialog, &QDialog::rejected, this, [edit, before] { edit(before); });
}

// Which windows are usual depends on the scan.
void ViewMenu::AddWindows()
{
  QMenu* const windows = this->addMenu(tr("&Window of the slices"));
  windows->setObjectName("windows");
  connect(windows, &QMenu::aboutToShow, this, [this, windows] { this->ListWindows(windows); });
}

void ViewMenu::ListWindows(QMenu* windows)
{
  windows->clear();
  QStringList titles = WindowTitles(*this->model);
  const bool hasOwn = HasWindowOfFile(*this->model);
  titles.prepend(hasOwn ? tr("As in the file") : tr("Automatic"));
  for (int number = 0; number < titles.size(); ++number)
  {
    QAction* const action = windows->addAction(tr("&%1  %2").arg(number).arg(titles[number]), this,
      [this, number] { ChooseWindow(this->model, number); });
    action->setEnabled(bool(this->model->CurrentStudy()));
    action->setStatusTip(tr("Or click a slice and press %1").arg(number));
  }
  if (hasOwn)
  {
    windows->addAction(tr("Automatic"), this, [this] { ChooseAutomaticWindow(this->model); })
      ->setStatusTip(tr("From the darkest to the brightest values of the scan"));
  }
}

void ViewMenu::AddCornerTexts()
{
  QMenu* const menu = this->addMenu(tr("Te&xts over the slices"));
  menu->setObjectName("cornerTexts");
  const std::pair<CornerText, QString> texts[] = {
    { CornerText::Window, tr("&Window, level and zoom") },
    { CornerText::Number, tr("&Number of the slice") },
    { CornerText::Position, tr("&Position") },
    { CornerText::Slab, tr("Thickness of the &slab") },
    { CornerText::Scale, tr("S&cale bar") },
    { CornerText::Directions, tr("&Directions of the patient") },
  };
  const CornerTexts shown = this->ChosenCornerTexts();
  for (const auto& [text, name] : texts)
  {
    QAction* const action = menu->addAction(name);
    action->setCheckable(true);
    action->setChecked(shown.count(text) > 0);
    connect(action, &QAction::toggled, this,
      [this, text = text](bool on)
      {
        QSettings().setValue(SettingOf(text), on);
        emit this->CornerTextsChosen(this->ChosenCornerTexts());
      });
  }
}

CornerTexts ViewMenu::ChosenCornerTexts() const
{
  CornerTexts shown;
  for (const CornerText text : AllCornerTexts())
  {
    if (QSettings().value(SettingOf(text), true).toBool())
    {
      shown.insert(text);
    }
  }
  return shown;
}

void ViewMenu::AddArrangements()
{
  auto* const group = new QActionGroup(this);
  const std::tuple<ViewLayout::Arrangement, QString, const char*> arrangements[] = {
    { ViewLayout::Arrangement::VolumeLarge, tr("&Volume large"), "volumeLarge" },
    { ViewLayout::Arrangement::Equal, tr("&Four views alike"), "fourAlike" },
  };
  for (const auto& [arrangement, name, objectName] : arrangements)
  {
    QAction* const action = group->addAction(this->addAction(name));
    action->setObjectName(objectName);
    action->setCheckable(true);
    action->setStatusTip(tr("Double-click a view to see it alone, and again to see all"));
    connect(action, &QAction::triggered, this,
      [this, arrangement = arrangement] { this->layout->Arrange(arrangement); });
    const auto check = [this, action, arrangement = arrangement]
    { action->setChecked(this->layout->CurrentArrangement() == arrangement); };
    check();
    connect(this->layout, &ViewLayout::Changed, action, check);
  }
}

void ViewMenu::AddTimes(const QList<QAction*>& actions)
{
  auto* const times = new QMenu(tr("&Times"), this);
  times->addActions(actions);
  this->insertMenu(this->panels->menuAction(), times);
  this->insertSeparator(this->panels->menuAction());
}

void ViewMenu::AddFullScreen()
{
  QAction* const full = this->addAction(tr("Full s&creen"));
  full->setObjectName("fullScreen");
  full->setCheckable(true);
  full->setShortcut(QKeySequence(Qt::Key_F11));
  connect(full, &QAction::triggered, this,
    [this](bool on)
    {
      QWidget* const window = this->parentWidget()->window();
      window->setWindowState(window->windowState().setFlag(Qt::WindowFullScreen, on));
    });
}

/// A tool of the left button in the menu.
struct ToolMenu::Tool
{
  LeftButton button;
  QString name;
  const char* key;
  QString tip;
};

ToolMenu::ToolMenu(QMainWindow* window)
  : QMenu(tr("&Tools"), window)
  , window(window)
{
  this->AddTools();
  this->addSeparator();
  this->addAction(tr("&Mark a key image"), this, &ToolMenu::KeyImageWanted, QKeySequence("Ctrl+M"))
    ->setObjectName("markKeyImage");
  this->addSeparator();
  this->AddComparisons();
}

// The menu holds the shortcuts; a tool bar makes the tools visible.
void ToolMenu::AddTools()
{
  const Tool tools[] = {
    { LeftButton::Turn, tr("&Rotate"), "T", tr("Drag to rotate the volume") },
    { LeftButton::Walk, tr("Wa&lk"), "G",
      tr("Walk through the volume: W, A, S, D or arrow keys, E and Q; drag to look around") },
    { LeftButton::Brightness, tr("&Window/Level"), "W",
      tr("Drag sideways for the window, up and down for the level; or drag with Ctrl") },
    { LeftButton::Distance, tr("&Distance"), "M", tr("Drag from one point to another") },
    { LeftButton::Angle, tr("&Angle"), "A",
      tr("Drag from the end of one arm to the vertex, then press at the end of the other") },
    { LeftButton::Box, tr("B&ox"), "B", tr("Drag from corner to corner: mean, deviation, volume") },
    { LeftButton::CutOut, tr("&Scissors"), "X", tr("Draw around the part to remove") },
    { LeftButton::KeepOnly, tr("&Keep inside"), "Shift+X", tr("Draw around the part to keep") },
  };
  auto* const bar = this->window->addToolBar(tr("Tool bar"));
  bar->setObjectName("leftButton");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  const int side = this->window->fontMetrics().height();
  bar->setIconSize({ side, side });
  auto* const group = new QActionGroup(this);
  for (const Tool& tool : tools)
  {
    bar->addAction(this->AddTool(tool, this, group));
  }
  auto* const more = new QToolButton;
  more->setObjectName("annotate");
  more->setText(tr("Annotate"));
  more->setIcon(AnnotationIcon());
  more->setToolTip(tr("Cobb angles, regions, curves, arrows and texts"));
  more->setPopupMode(QToolButton::InstantPopup);
  QMenu* const annotations = this->addMenu(tr("Anno&tate"));
  this->AddAnnotations(annotations, group);
  more->setMenu(annotations);
  bar->addWidget(more);
  // Qt tells only the buttons of actions of the style of the bar.
  more->setToolButtonStyle(bar->toolButtonStyle());
  more->setIconSize(bar->iconSize());
  connect(bar, &QToolBar::toolButtonStyleChanged, more, &QToolButton::setToolButtonStyle);
}

void ToolMenu::AddAnnotations(QMenu* menu, QActionGroup* group)
{
  const Tool tools[] = {
    { LeftButton::CobbAngle, tr("&Cobb angle"), "Shift+A",
      tr("Drag along one line, then another") },
    { LeftButton::Ellipse, tr("&Ellipse"), "O",
      tr("Drag across a slice: area, mean, deviation, smallest and largest value") },
    { LeftButton::Freehand, tr("&Freehand region"), "Shift+O",
      tr("Draw around a region of a slice: area, mean, deviation, smallest and largest value") },
    { LeftButton::Curve, tr("C&urve"), "U",
      tr("Click along a vessel or the jaw: its length, and the volume straightened along it") },
    { LeftButton::Arrow, tr("&Arrow"), "Shift+M", tr("Drag to the thing to show, then type") },
    { LeftButton::Text, tr("&Text"), "Shift+T", tr("Click, then type") },
  };
  for (const Tool& tool : tools)
  {
    this->AddTool(tool, menu, group);
  }
}

QAction* ToolMenu::AddTool(const Tool& tool, QMenu* menu, QActionGroup* group)
{
  QAction* const action = group->addAction(menu->addAction(tool.name));
  action->setIcon(IconOf(tool.button));
  action->setIconVisibleInMenu(false); // menus show which tool is chosen there
  action->setCheckable(true);
  action->setChecked(tool.button == LeftButton::Turn);
  action->setShortcut(QKeySequence(tool.key));
  action->setToolTip(tr("%1 (%2)").arg(tool.tip, action->shortcut().toString()));
  action->setStatusTip(tool.tip);
  connect(action, &QAction::triggered, this,
    [this, button = tool.button] { emit this->ToolChosen(button); });
  return action;
}

void ToolMenu::AddComparisons()
{
  auto* const comparisons = new QActionGroup(this);
  const std::tuple<QString, std::optional<MapperKind>> kinds[] = {
    { tr("&No comparison"), std::nullopt },
    { tr("Compare with VTK's &GPU mapper"), MapperKind::VtkGpu },
    { tr("Compare with VTK's CP&U mapper"), MapperKind::VtkCpu },
  };
  for (const auto& [name, kind] : kinds)
  {
    QAction* const action = comparisons->addAction(this->addAction(name));
    action->setCheckable(true);
    action->setChecked(!kind);
    connect(action, &QAction::triggered, this,
      [this, kind = kind] { emit this->ComparisonChosen(kind); });
  }
  QAction* const wipe = this->addAction(tr("W&ipe between them"));
  wipe->setCheckable(true);
  wipe->setStatusTip(tr("Both images in one place, with a divider to drag"));
  connect(wipe, &QAction::toggled, this, &ToolMenu::WipeChosen);
  this->addAction(tr("Benc&hmark…"), this, &ToolMenu::BenchmarkWanted)->setObjectName("benchmark");
}

}
