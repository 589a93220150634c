// The notice and the question of a window that starts.

#include "Answers.h"
#include "Module/Files/PhantomFiles.h"
#include "Viewer/MainWindow.h"
#include "Waiting.h"

#include <QAction>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Starting : public testing::Test
{
protected:
  Starting() { this->window.show(); }

  TemporaryFolder folder;
  MainWindow window;
};

}

TEST_F(Starting, SaysOnceThatItIsNotForDiagnosticUse)
{
  QSettings().remove("notice/read");
  this->window.ShowNoticeOnce();
  auto* const notice = this->window.findChild<QMessageBox*>("notice");
  ASSERT_TRUE(notice);
  EXPECT_TRUE(notice->text().contains("Not for diagnostic use"));
  MainWindow again;
  again.ShowNoticeOnce();
  EXPECT_TRUE(again.findChild<QMessageBox*>("notice")) << "the notice has not been confirmed yet";
  notice->buttons().first()->click();
  MainWindow later;
  later.ShowNoticeOnce();
  EXPECT_FALSE(later.findChild<QMessageBox*>("notice"));
}

TEST_F(Starting, AsksForAFileAtStartOnlyIfTheUserWantsThat)
{
  this->folder.Write("head.nii", NiftiBytes(phantom::Stored(0)));
  const Answers answers(QMessageBox::Ok, QString::fromStdString(this->folder.Path("head.nii")));
  this->window.OfferFileAtStart();
  QTest::qWait(200);
  EXPECT_FALSE(this->window.Loader()->IsLoading() || this->window.Model()->CurrentStudy());
  this->window.findChild<QAction*>("askAtStart")->trigger();
  this->window.OfferFileAtStart();
  ASSERT_TRUE(QTest::qWaitFor(
    [this] { return this->window.Model()->CurrentStudy() != nullptr; }, MostMilliseconds));
  EXPECT_TRUE(MainWindow().findChild<QAction*>("askAtStart")->isChecked()) << "remembered";
}
