#include "Viewer/HelpActions.h"

#include "Viewer/CommandPalette.h"
#include "Viewer/Model/Language.h"
#include "Viewer/Model/Log.h"
#include "Viewer/PanelTabs.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include <utility>

namespace varimarch
{

namespace
{

constexpr int FramePixels = 4;
constexpr int TextPixels = 340;

const QString NoticeKey = QStringLiteral("notice/read");

QString Notice()
{
  return HelpActions::tr(
    "<b>Not for diagnostic use.</b> This program is not a medical device. It must not be used to "
    "diagnose, to plan or to guide a treatment.");
}

std::function<QWidget*()> Place(QWidget* widget)
{
  return [widget] { return widget; };
}

std::function<QWidget*()> Panel(const QMainWindow* window, const char* name)
{
  return [window, name] { return RaisePanel(window, name); };
}

}

HelpActions::HelpActions(const TourPlaces& places, QMainWindow* window)
  : QObject(window)
  , places(places)
  , window(window)
{
}

void HelpActions::AddTo(QMenu* menu)
{
  QMenuBar* const menus = this->window->menuBar();
  menu
    ->addAction(
      tr("&Find a command…"), this,
      [this, menus] { (new CommandPalette(menus, this->window))->open(); }, QKeySequence("Ctrl+K"))
    ->setObjectName("findCommand");
  menu
    ->addAction(
      tr("&Mouse and keys"), this, [this, menus] { ShowKeys(menus, this->window); },
      QKeySequence(Qt::Key_F1))
    ->setObjectName("mouseAndKeys");
  menu->addAction(tr("&Two-minute tour"), this, &HelpActions::ShowTour)->setObjectName("showTour");
  this->FillLanguages(menu->addMenu(tr("&Language")));
  menu->addAction(tr("Open the l&og folder"), this,
    []
    {
      const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
      QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(LogFileIn(folder)).path()));
    });
  menu->addAction(tr("&About Varimarch"), this, &HelpActions::ShowAbout);
}

void HelpActions::ShowNoticeOnce()
{
  if (QSettings().value(NoticeKey).toBool())
  {
    return;
  }
  auto* const box = new QMessageBox(
    QMessageBox::Information, tr("Varimarch"), Notice(), QMessageBox::NoButton, this->window);
  box->setObjectName("notice");
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* const understood = box->addButton(tr("I understand"), QMessageBox::AcceptRole);
  connect(
    understood, &QAbstractButton::clicked, box, [] { QSettings().setValue(NoticeKey, true); });
  box->open();
}

void HelpActions::FillLanguages(QMenu* menu)
{
  auto* const choices = new QActionGroup(this);
  QVector<Language> offered = Languages();
  offered.prepend({ {}, tr("As on the &desktop") });
  for (const Language& language : offered)
  {
    QAction* const action = choices->addAction(menu->addAction(language.name));
    action->setCheckable(true);
    action->setChecked(language.code == ChosenLanguage());
    connect(action, &QAction::triggered, this,
      [this, language]
      {
        ChooseLanguage(language.code);
        this->window->statusBar()->showMessage(language.code.isEmpty()
            ? tr("The program will use the desktop's language after a restart")
            : tr("The program will use %1 after a restart").arg(language.name));
      });
  }
}

void HelpActions::ShowTour()
{
  emit this->TourBegins();
  if (auto* const shown = this->window->findChild<Tour*>())
  {
    shown->close();
  }
  (new Tour(this->TourSteps(), this->window))->show();
}

std::vector<TourStep> HelpActions::TourSteps()
{
  return {
    { tr("The volume"),
      tr("Drag to turn it, drag with Shift or the middle button to move it, and turn the wheel to "
         "come nearer. A double-click shows it alone, another one all views again."),
      Place(this->places.volume) },
    { tr("Slices"),
      tr("The wheel goes through the slices. Drag the cross to move all three, its arms to tilt "
         "them, and drag with the right button for brightness and contrast. Number keys choose a "
         "usual window."),
      Place(this->places.slice) },
    { tr("Looks"),
      tr("Each image is this scan with another look. Click one; Ctrl+Z takes it back, as it does "
         "every edit."),
      Panel(this->window, "presets") },
    { tr("Transfer function"),
      tr("The curve says how opaque each value is, over the histogram of the scan. Drag its "
         "points, click to add one, and double-click a point for its numbers."),
      Panel(this->window, "look") },
    { tr("Cut away"),
      tr("Remove the table with one click, drag a box or a plane in the volume, or cut with the "
         "scissors of the tool bar."),
      Panel(this->window, "cuts") },
    { tr("Measurements"),
      tr("Choose a measurement in the tool bar and drag in a slice or in the volume. All of them "
         "are listed here and in reports."),
      Panel(this->window, "measures") },
    { tr("Everything else"),
      tr("Ctrl+K finds any command by a word, and F1 lists what the mouse and the keys do. The "
         "menu File saves sessions, images and reports."),
      Place(this->window->menuBar()) },
  };
}

void HelpActions::ShowAbout()
{
  QMessageBox::about(this->window, tr("About Varimarch"),
    tr("<b>Varimarch %1</b><p>Shows CT and MR volumes with a promised error.</p>")
        .arg(QCoreApplication::applicationVersion()) +
      "<p>" + Notice() + "</p>");
}

// Lies over the window and lets the mouse through.
class Tour::Frame : public QWidget
{
public:
  explicit Frame(QWidget* window)
    : QWidget(window)
  {
    this->setAttribute(Qt::WA_TransparentForMouseEvents);
    this->setObjectName("tourFrame");
  }

protected:
  // Two colours, one of which differs from anything below.
  void paintEvent(QPaintEvent*) override
  {
    QPainter painter(this);
    const QRectF inner = QRectF(this->rect()).adjusted(2.0, 2.0, -2.0, -2.0);
    painter.setPen(QPen(this->palette().color(QPalette::Window), FramePixels));
    painter.drawRect(inner);
    painter.setPen(QPen(this->palette().color(QPalette::Highlight), FramePixels, Qt::DashLine));
    painter.drawRect(inner);
  }
};

Tour::Tour(std::vector<TourStep> steps, QWidget* window)
  : QDialog(window)
  , steps(std::move(steps))
  , frame(new Frame(window))
  , title(new QLabel)
  , text(new QLabel)
  , back(new QPushButton(tr("Back")))
  , next(new QPushButton)
{
  this->setObjectName("tour");
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->title->setObjectName("tourTitle");
  this->text->setWordWrap(true);
  this->text->setFixedWidth(TextPixels);
  this->back->setObjectName("tourBack");
  this->next->setObjectName("tourNext");
  this->next->setDefault(true);
  auto* const end = new QPushButton(tr("End the tour"));
  end->setObjectName("tourEnd");
  auto* const buttons = new QHBoxLayout;
  buttons->addWidget(end);
  buttons->addStretch();
  buttons->addWidget(this->back);
  buttons->addWidget(this->next);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(this->title);
  column->addWidget(this->text);
  column->addLayout(buttons);
  connect(end, &QPushButton::clicked, this, &QDialog::close);
  connect(this->back, &QPushButton::clicked, this, [this] { this->Show(this->current - 1); });
  connect(this->next, &QPushButton::clicked, this,
    [this]
    {
      if (this->current + 1 < int(this->steps.size()))
      {
        this->Show(this->current + 1);
      }
      else
      {
        this->close();
      }
    });
  window->installEventFilter(this);
  this->Show(0);
}

// The window may be what ends.
Tour::~Tour()
{
  delete this->frame;
}

void Tour::Show(int step)
{
  this->current = step;
  const TourStep& shown = this->steps[step];
  if (this->target)
  {
    this->target->removeEventFilter(this);
  }
  this->target = shown.target();
  this->target->installEventFilter(this);
  this->setWindowTitle(tr("Tour: %1 of %2").arg(step + 1).arg(this->steps.size()));
  this->title->setText("<b>" + shown.title.toHtmlEscaped() + "</b>");
  this->text->setText(shown.text);
  this->back->setEnabled(step > 0);
  this->next->setText(step + 1 < int(this->steps.size()) ? tr("Next") : tr("Done"));
  this->PlaceFrame();
}

void Tour::PlaceFrame()
{
  if (!this->target)
  {
    return; // the window ends
  }
  QWidget* const window = this->parentWidget();
  const QPoint corner = this->target->mapTo(window, QPoint(0, 0));
  this->frame->setGeometry(QRect(corner, this->target->size())
                             .adjusted(-FramePixels, -FramePixels, FramePixels, FramePixels)
                             .intersected(window->rect()));
  this->frame->setVisible(this->target->isVisible());
  this->frame->raise();
}

bool Tour::eventFilter(QObject* watched, QEvent* event)
{
  const QEvent::Type type = event->type();
  if (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show ||
    type == QEvent::Hide || type == QEvent::LayoutRequest)
  {
    this->PlaceFrame();
  }
  return QDialog::eventFilter(watched, event);
}

}
