// The offer to resample a tilted scan on an even grid.

#include "Answers.h"
#include "OpeningWindow.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Open/WarningBar.h"

#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Rectifying : public OpeningWindow
{
protected:
  /// Writes slices of 4 rows, each shifted by more than a row against the one before.
  void WriteTiltedSeries()
  {
    StoredVolume volume = phantom::Stored(0);
    volume.axesMm = glm::dmat3(0.7, 0, 0, 0, 1.1, 0, 0, 1.5, 2.5);
    for (int slice = 0; slice < 3; ++slice)
    {
      this->folder.Write("tilted/" + std::to_string(slice), DicomBytes(volume, slice));
    }
  }

  int RowCount() { return this->window.Model()->CurrentStudy()->volume.image->GetDimensions()[1]; }

  bool HasRows(int count)
  {
    return QTest::qWaitFor([=] { return this->RowCount() == count; }, MostMilliseconds);
  }

  /// The button in the warning bar.
  QPushButton* Remedy() { return this->window.findChild<QPushButton*>("remedy"); }
};

}

TEST_F(Rectifying, OffersToRectifyATiltedScan)
{
  this->WriteTiltedSeries();
  this->Open("tilted");
  ASSERT_TRUE(this->IsOpened());
  EXPECT_EQ(this->RowCount(), 4);
  this->window.Model()->Edit(ScenePart::Cuts, "cut",
    [](Scene& scene) {
      scene.cuts.planes.push_back({ { 1.0, 2.0, 3.0 }, { 0.0, 0.0, 1.0 } });
    });
  ASSERT_TRUE(this->Remedy()->isVisible());
  EXPECT_EQ(this->Remedy()->text(), "Rectify");

  this->Remedy()->click();
  ASSERT_TRUE(this->HasRows(7)) << "3 mm of tilt are 2.7 rows";
  EXPECT_EQ(this->Remedy()->text(), "Show as scanned");
  EXPECT_EQ(this->window.Model()->CurrentScene().cuts.planes.size(), 1u);
  WriteScene(this->window.Model()->CurrentScene(),
    QString::fromStdString(this->folder.Path("session.json")));

  QUndoStack* const history = this->window.Model()->History();
  history->undo();
  EXPECT_EQ(this->RowCount(), 4);
  EXPECT_EQ(this->Remedy()->text(), "Rectify");
  history->redo();
  EXPECT_EQ(this->RowCount(), 7);
  this->Remedy()->click();
  EXPECT_EQ(this->RowCount(), 4) << "the scan must not be read again";
  EXPECT_EQ(std::get<FileSource>(this->window.Model()->CurrentScene().volume).rectified, false);

  const Answers discard(QMessageBox::Discard, {});
  this->Open("session.json");
  ASSERT_TRUE(this->HasRows(7));
  EXPECT_EQ(this->Remedy()->text(), "Show as scanned");
}

TEST_F(Rectifying, SavesDrawnSegmentsBeforeItRectifies)
{
  this->WriteTiltedSeries();
  this->Open("tilted");
  ASSERT_TRUE(this->IsOpened());
  SceneModel* const model = this->window.Model();
  model->AddSegment("liver", "new segment");
  const int* const size = model->CurrentStudy()->volume.image->GetDimensions();
  const std::size_t count = std::size_t(size[0]) * size[1] * size[2];
  model->ChangeLabels({ { 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1 },
                        std::vector<std::uint8_t>(count, 0), std::vector<std::uint8_t>(count, 1) },
    "paint");
  const Answers named(
    QMessageBox::Discard, QString::fromStdString(this->folder.Path("drawn.seg.nrrd")));
  this->Remedy()->click();
  ASSERT_TRUE(this->HasRows(7));
  ASSERT_TRUE(model->CurrentScene().labels);
  EXPECT_EQ(model->CurrentScene().labels->segments.front().name, "liver");
  EXPECT_FALSE(model->HasUnsavedLabels());
}

TEST_F(Rectifying, StaysAsScannedWhenRectifyingIsCancelled)
{
  this->WriteTiltedSeries();
  this->Open("tilted");
  ASSERT_TRUE(this->IsOpened());
  QSignalSpy cancelled(this->window.Loader(), &LoadController::Cancelled);
  this->Remedy()->click();
  this->window.Loader()->Cancel();
  ASSERT_TRUE(cancelled.wait(MostMilliseconds));
  EXPECT_EQ(this->RowCount(), 4);
  EXPECT_FALSE(this->window.Model()->History()->canUndo());
}

TEST_F(Rectifying, OffersNothingForAScanThatIsEven)
{
  this->WriteSeries("1.2.33", 3);
  this->Open("DOE^JANE");
  ASSERT_TRUE(this->IsOpened());
  EXPECT_TRUE(this->window.findChild<WarningBar*>()->isVisible());
  EXPECT_FALSE(this->Remedy()->isVisible());
}
