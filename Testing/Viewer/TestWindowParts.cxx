// The window's first page, the arrangement of its views, and its commands by name.

#include "TorsoWindow.h"
#include "Viewer/CommandPalette.h"
#include "Viewer/Open/StartPage.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/ViewLayout.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QPushButton>
#include <QTextBrowser>
#include <QToolBar>
#include <QToolButton>

#include <vtkCamera.h>
#include <vtkRenderer.h>

using namespace varimarch;

TEST_F(Window, OffersScansAndSamplesWhileItIsEmpty)
{
  auto* const page = this->window.findChild<StartPage*>();
  ASSERT_TRUE(page && page->isVisible());
  EXPECT_FALSE(this->View()->isVisible());
  auto* const sample = page->findChild<QAbstractButton*>("sampleTorso");
  QTest::mouseClick(sample, Qt::LeftButton);
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return bool(this->Model()->CurrentStudy()); }, MostMilliseconds));
  EXPECT_FALSE(page->isVisible());
  EXPECT_TRUE(this->View()->isVisible());
}

TEST_F(Window, ShowsADoubleClickedViewAlone)
{
  this->OpenTorso();
  auto* const layout = this->window.findChild<ViewLayout*>();
  const QList<SliceView*> slices = this->window.findChildren<SliceView*>();
  ASSERT_EQ(slices.size(), 3);
  QTest::mouseClick(slices[1], Qt::LeftButton);
  QTest::mouseDClick(slices[1], Qt::LeftButton);
  QTest::qWait(50);
  EXPECT_TRUE(slices[1]->isVisible());
  EXPECT_FALSE(slices[0]->isVisible() || slices[2]->isVisible() || this->View()->isVisible());
  EXPECT_GT(slices[1]->height(), 300);
  QTest::mouseDClick(slices[1], Qt::LeftButton);
  EXPECT_TRUE(slices[0]->isVisible() && slices[2]->isVisible() && this->View()->isVisible());
  QTest::mouseDClick(this->View(), Qt::LeftButton);
  EXPECT_EQ(layout->Alone(), this->window.CentralView());
  EXPECT_FALSE(slices[0]->isVisible());
  EXPECT_EQ(this->Model()->History()->count(), 1) << "the crosshair, put by the first click";

  // A measurement by clicks is not the wish to see a view alone.
  layout->ShowAlone(nullptr);
  slices[0]->SetTool(LeftButton::Distance);
  QTest::mouseDClick(slices[0], Qt::LeftButton);
  EXPECT_FALSE(layout->Alone());
}

TEST_F(Window, ArrangesFourViewsAlike)
{
  this->window.resize(1280, 800);
  this->OpenTorso();
  this->window.findChild<QAction*>("fourAlike")->trigger();
  QTest::qWait(50);
  for (const SliceView* const slice : this->window.findChildren<SliceView*>())
  {
    EXPECT_NEAR(slice->width(), this->View()->width(), 30);
    EXPECT_NEAR(slice->height(), this->View()->height(), 40);
  }
  this->window.Compare(MapperKind::VtkCpu);
  EXPECT_FALSE(this->window.findChild<SliceView*>()->isVisible());
  this->window.Compare(std::nullopt);
  this->window.findChild<QAction*>("volumeLarge")->trigger();
  QTest::qWait(50);
  EXPECT_GT(this->View()->width(), 1.5 * this->window.findChild<SliceView*>()->width());
}

// Beside wide panels a view may have no width, in which no camera shows all.
TEST_F(Window, ShowsAllInAViewThatHadNoWidth)
{
  this->OpenTorso();
  vtkCamera* const camera = this->View()->Pipeline()->Renderer()->GetActiveCamera();
  const double distance = camera->GetDistance();
  const QRect place = this->View()->geometry();
  this->View()->setGeometry(0, 0, 0, place.height());
  EXPECT_LT(camera->GetDistance(), 2.0 * distance);
  this->View()->setGeometry(place);
  EXPECT_EQ(camera->GetDistance(), distance);
}

TEST_F(Window, OffersToHideTheToolsButNotTheTitlesOfPanels)
{
  const std::unique_ptr<QMenu> menu(this->window.createPopupMenu());
  QStringList offered;
  for (const QAction* const action : menu->actions())
  {
    offered << (action->isVisible() ? action->text() : QString());
  }
  const auto title = [this](const char* bar)
  { return this->window.findChild<QToolBar*>(bar)->windowTitle(); };
  EXPECT_TRUE(offered.contains(title("leftButton")));
  EXPECT_FALSE(offered.contains(title("panelBar")));
}

TEST_F(Window, ShowsToolsByIconsBesideTheirWords)
{
  this->window.resize(1280, 720);
  const auto* const bar = this->window.findChild<QToolBar*>("leftButton");
  int seen = 0;
  for (const QToolButton* const button : bar->findChildren<QToolButton*>())
  {
    if (button->text().isEmpty())
    {
      continue; // the arrow that Qt shows where a bar is too narrow
    }
    ++seen;
    EXPECT_FALSE(button->icon().isNull()) << button->text().toStdString();
    EXPECT_EQ(button->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    EXPECT_EQ(button->iconSize(), bar->iconSize());
    EXPECT_TRUE(button->isVisible()) << button->text().toStdString();
  }
  EXPECT_EQ(seen, 9);
  const int narrow = bar->sizeHint().width() - 20;
  this->window.resize(narrow, 500);
  ASSERT_EQ(this->window.width(), narrow);
  const auto* const annotate = bar->findChild<QToolButton*>("annotate");
  EXPECT_EQ(annotate->toolButtonStyle(), Qt::ToolButtonTextOnly) << "words matter more";
  EXPECT_LE(bar->sizeHint().width(), narrow);
}

TEST_F(Window, FindsACommandByItsWords)
{
  this->OpenTorso();
  this->window.findChild<QAction*>("findCommand")->trigger();
  auto* const palette = this->window.findChild<QDialog*>("commandPalette");
  ASSERT_TRUE(palette);
  auto* const search = palette->findChild<QLineEdit*>();
  auto* const list = palette->findChild<QListWidget*>();
  EXPECT_GT(list->count(), 30);
  QTest::keyClicks(search, "paral proj");
  ASSERT_EQ(list->count(), 1);
  EXPECT_EQ(list->item(0)->text(), "View: Parallel projection (5)");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor(
    [&] { return this->Model()->CurrentScene().camera.parallel; }, MostMilliseconds));
}

TEST_F(Window, TellsItsKeysAndWhatTheMouseDoes)
{
  this->window.findChild<QAction*>("mouseAndKeys")->trigger();
  const auto* const text = this->window.findChild<QDialog*>("keys")->findChild<QTextBrowser*>();
  for (const char* const line :
    { "Ctrl+K", "Help: Find a command", "Double-click", "Tools: Rotate" })
  {
    EXPECT_TRUE(text->toPlainText().contains(line)) << line;
  }
}

TEST_F(Window, MarksTheViewThatWasClickedLast)
{
  this->OpenTorso();
  auto* const mark = this->window.findChild<QAction*>("markKeyImage");
  QTest::mouseClick(this->window.findChildren<SliceView*>()[1], Qt::LeftButton);
  // Whatever takes the keys then.
  this->window.findChild<QComboBox*>()->setFocus();
  mark->trigger();
  QTest::mouseClick(this->View(), Qt::LeftButton);
  mark->trigger();
  const std::vector<KeyImage>& marked = this->Model()->CurrentScene().keyImages;
  ASSERT_EQ(marked.size(), 2);
  EXPECT_EQ(marked[0].view, KeyView::Coronal);
  EXPECT_EQ(marked[1].view, KeyView::Volume);
}

TEST_F(Window, IsShownByATour)
{
  this->window.findChild<QAbstractButton*>("tourOfStart")->click();
  EXPECT_TRUE(
    QTest::qWaitFor([&] { return this->Model()->CurrentStudy() != nullptr; }, MostMilliseconds))
    << "it needs a volume";
  const QPointer<QDialog> tour = this->window.findChild<QDialog*>("tour");
  ASSERT_TRUE(tour);
  auto* const frame = this->window.findChild<QWidget*>("tourFrame");
  auto* const next = tour->findChild<QPushButton*>("tourNext");
  auto* const back = tour->findChild<QPushButton*>("tourBack");
  EXPECT_FALSE(back->isEnabled());
  EXPECT_TRUE(QTest::qWaitFor([&] { return frame->isVisible(); }, MostMilliseconds));
  std::vector<QRect> places = { frame->geometry() };
  QStringList titles = { tour->findChild<QLabel*>("tourTitle")->text() };
  while (next->text() == "Next")
  {
    next->click();
    EXPECT_TRUE(frame->isVisible()) << titles.last().toStdString();
    EXPECT_TRUE(this->window.rect().contains(frame->geometry()));
    places.push_back(frame->geometry());
    EXPECT_FALSE(titles.contains(tour->findChild<QLabel*>("tourTitle")->text()));
    titles.append(tour->findChild<QLabel*>("tourTitle")->text());
  }
  EXPECT_EQ(titles.size(), 7);
  EXPECT_TRUE(this->window.findChild<QDockWidget*>("measures")->isVisible());
  back->click();
  EXPECT_EQ(tour->findChild<QLabel*>("tourTitle")->text(), titles[5]);
  next->click();
  next->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return tour.isNull(); }, MostMilliseconds));
  EXPECT_FALSE(this->window.findChild<QWidget*>("tourFrame"));
  this->window.findChild<QAction*>("showTour")->trigger();
  const QPointer<QDialog> again = this->window.findChild<QDialog*>("tour");
  ASSERT_TRUE(again);
  QTest::keyClick(again, Qt::Key_Escape);
  EXPECT_TRUE(QTest::qWaitFor([&] { return again.isNull(); }, MostMilliseconds));
}

TEST_F(Window, OffersMoviesOfCutsAndOfLooksThatCanChange)
{
  this->OpenTorso();
  const auto* const cuts = this->window.findChild<QAction*>("exportCuts");
  auto* const looks = this->window.findChild<QMenu*>("exportLookChange");
  EXPECT_FALSE(cuts->isEnabled());
  EXPECT_TRUE(looks->menuAction()->isEnabled());
  this->Model()->Edit(ScenePart::Cuts, "cut", [](Scene& scene) { scene.cuts.box[1] = 0.5; });
  EXPECT_TRUE(cuts->isEnabled());
  const auto isOffered = [&](const char* preset)
  {
    emit looks->aboutToShow();
    return looks->findChild<QAction*>(preset) != nullptr;
  };
  EXPECT_TRUE(isOffered("ct-bone"));
  EXPECT_FALSE(isOffered("ct-maximum")) << "it is a projection";
  Look projection = this->Model()->CurrentScene().look;
  projection.blend = Blend::MaximumIntensity;
  this->Model()->SetLook(projection, "maximum");
  EXPECT_FALSE(isOffered("ct-bone"));
}
