#include "Viewer/ViewMenu.h"

#include "Scene/SceneCamera.h"
#include "Viewer/LiveColorDialog.h"
#include "Viewer/Model/Gesture.h"
#include "Viewer/Model/SliceWindows.h"
#include "Viewer/Theme.h"

#include <QActionGroup>
#include <QColorDialog>
#include <QSettings>

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

}
