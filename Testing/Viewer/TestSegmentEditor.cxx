// Segments that are drawn by hand, with the widgets that a user operates.

#include "OverlaidStudy.h"
#include "Scene/Pipeline/ScenePicking.h"
#include "Viewer/Panels/SegmentsPanel.h"
#include "Viewer/View/SliceView.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

using namespace varimarch;

namespace
{

class DrawnSegments : public testing::Test
{
protected:
  DrawnSegments()
  {
    this->slice.SetSegmentEditor(&this->editor);
    this->slice.resize(300, 300);
    QObject::connect(
      &this->panel, &SegmentsPanel::Selected, &this->editor, &SegmentEditor::SetSegment);
    this->model.Open(ProceduralSource{ ProceduralKind::Torso }, SmallStudy());
    this->box.show();
    this->panel.show();
  }

  void Press(const char* name)
  {
    QTest::mouseClick(this->box.findChild<QPushButton*>(name), Qt::LeftButton);
  }

  /// Waits until no thread works for the segments.
  void Await()
  {
    EXPECT_TRUE(QTest::qWaitFor(
      [&] { return !this->editor.IsWorking() && this->model.AreSegmentsCounted(); }, 30000));
  }

  const RegionStatistics& Counts(int segment, int volume = 0)
  {
    this->Await();
    return this->model.StudyOf(volume)->segmentStatistics.at(segment);
  }

  std::int64_t Voxels(int segment, int volume = 0) { return this->Counts(segment, volume).voxels; }

  /// A segment that a click fills with all voxels.
  void PressForAll()
  {
    this->Press("newSegment");
    this->Press("toolRegion");
    this->SetNumber("smallestValue", -5000.0);
    this->SetNumber("largestValue", 5000.0);
    QTest::mouseClick(&this->slice, Qt::LeftButton, Qt::NoModifier, { 150, 150 });
  }

  /// Drags over the middle of the slice.
  void Stroke(int fromX, int toX)
  {
    QTest::mousePress(&this->slice, Qt::LeftButton, Qt::NoModifier, { fromX, 150 });
    QTest::mouseMove(&this->slice, { (fromX + toX) / 2, 150 });
    QMouseEvent move(QEvent::MouseMove, QPointF(toX, 150), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&this->slice, &move);
    QTest::mouseRelease(&this->slice, Qt::LeftButton, Qt::NoModifier, { toX, 150 });
  }

  void SetNumber(const char* name, double value)
  {
    this->box.findChild<QDoubleSpinBox*>(name)->setValue(value);
  }

  SceneModel model;
  SegmentEditor editor{ &this->model };
  SegmentsPanel panel{ &this->model };
  SegmentEditingBox box{ &this->model, &this->editor };
  SliceView slice{ &this->model, SlicePlane::Axial };
};

}

TEST_F(DrawnSegments, BeginEmptyAndAreInTheTable)
{
  this->Press("newSegment");
  this->Press("newSegment");
  ASSERT_TRUE(this->model.CurrentScene().labels);
  EXPECT_EQ(this->model.CurrentScene().labels->segments[1].name, "Segment 2");
  EXPECT_EQ(this->panel.findChild<QTableWidget*>()->rowCount(), 2);
  EXPECT_EQ(this->Voxels(0), 0);
  EXPECT_TRUE(this->model.HasUnsavedLabels());
  this->model.History()->undo();
  this->model.History()->undo();
  EXPECT_FALSE(this->model.CurrentScene().labels);
  EXPECT_FALSE(this->model.HasUnsavedLabels());
}

TEST_F(DrawnSegments, AreUnsavedUnlessTheirFileHasTheSameVoxels)
{
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 40.0);
  this->Stroke(100, 120);
  EXPECT_TRUE(this->model.HasUnsavedLabels());
  this->model.TakeSavedLabels(
    "/scans/drawn.seg.nrrd", this->model.CurrentScene().labels->segments, "save");
  EXPECT_FALSE(this->model.HasUnsavedLabels());
  this->Stroke(150, 200);
  EXPECT_TRUE(this->model.HasUnsavedLabels());
  this->model.History()->undo();
  EXPECT_FALSE(this->model.HasUnsavedLabels());
  this->model.History()->undo(); // no file is named
  this->model.History()->undo(); // nothing is painted
  EXPECT_TRUE(this->model.HasUnsavedLabels());
  this->model.CloseLabels("close");
  EXPECT_FALSE(this->model.HasUnsavedLabels());
  this->model.History()->undo();
  EXPECT_TRUE(this->model.HasUnsavedLabels());
}

TEST_F(DrawnSegments, TheNewOneIsDrawn)
{
  this->Press("newSegment");
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 40.0);
  this->Stroke(100, 200);
  EXPECT_EQ(this->Voxels(0), 0);
  EXPECT_GT(this->Voxels(1), 0);
}

TEST_F(DrawnSegments, ABrushPaintsAndErasesInOneStepEach)
{
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 40.0);
  const int steps = this->model.History()->count();
  this->Stroke(100, 200);
  const std::int64_t painted = this->Voxels(0);
  EXPECT_GT(painted, 10);
  EXPECT_EQ(this->model.History()->count(), steps + 1);
  this->Press("toolErase");
  this->SetNumber("brushRadius", 60.0);
  this->Stroke(180, 220);
  EXPECT_LT(this->Voxels(0), painted);
  EXPECT_GT(this->Voxels(0), 0);
  this->model.History()->undo();
  EXPECT_EQ(this->Voxels(0), painted);
  this->model.History()->undo();
  EXPECT_EQ(this->Voxels(0), 0);
  this->model.History()->redo();
  EXPECT_EQ(this->Voxels(0), painted);
}

TEST_F(DrawnSegments, AStrokeIsOneStepWhateverOtherButtonsDo)
{
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 40.0);
  const int steps = this->model.History()->count();
  QTest::mousePress(&this->slice, Qt::LeftButton, Qt::NoModifier, { 140, 150 });
  QTest::mousePress(&this->slice, Qt::RightButton, Qt::NoModifier, { 140, 150 });
  QTest::mouseRelease(&this->slice, Qt::RightButton, Qt::NoModifier, { 140, 150 });
  QTest::mouseRelease(&this->slice, Qt::LeftButton, Qt::NoModifier, { 140, 150 });
  EXPECT_EQ(this->model.History()->count(), steps + 1);
  EXPECT_GT(this->Voxels(0), 0);
}

TEST_F(DrawnSegments, AStrokeEndsWithItsLabels)
{
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 40.0);
  vtkImageData* const numbers = this->model.CurrentStudy()->labels->image;
  QTest::mousePress(&this->slice, Qt::LeftButton, Qt::NoModifier, { 140, 150 });
  EXPECT_EQ(numbers->GetScalarRange()[1], 1.0);
  this->model.CloseLabels("close");
  QTest::mouseRelease(&this->slice, Qt::LeftButton, Qt::NoModifier, { 140, 150 });
  EXPECT_FALSE(this->model.CurrentScene().labels);
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentStudy()->labels->image, numbers);
  EXPECT_EQ(numbers->GetScalarRange()[1], 0.0);
}

TEST_F(DrawnSegments, ADoubleClickPaintsToo)
{
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 40.0);
  QSignalSpy enlarged(&this->slice, &SliceView::DoubleClicked);
  QTest::mouseDClick(&this->slice, Qt::LeftButton, Qt::NoModifier, { 140, 150 });
  QTest::mouseRelease(&this->slice, Qt::LeftButton, Qt::NoModifier, { 140, 150 });
  EXPECT_TRUE(enlarged.isEmpty());
  EXPECT_GT(this->Voxels(0), 0);
}

TEST_F(DrawnSegments, ARegionHasTheValuesOfItsRange)
{
  this->Press("newSegment");
  this->Press("toolRegion");
  vtkImageData* const image = this->model.CurrentStudy()->volume.image;
  // The middle of a voxel: a region begins at the nearest one.
  std::array<double, 3> middle;
  image->TransformIndexToPhysicalPoint(16, 14, 10, middle.data());
  this->model.Edit(
    ScenePart::Slices, "there", [&](Scene& scene) { scene.slices.crosshairMm = middle; });
  const double value = *ValueAt(image, middle);
  this->SetNumber("smallestValue", value - 20.0);
  this->SetNumber("largestValue", value + 20.0);
  QTest::mouseClick(
    &this->slice, Qt::LeftButton, Qt::NoModifier, this->slice.PlaceOf(middle).toPoint());
  ASSERT_GT(this->Voxels(0), 0);
  EXPECT_GE(this->Counts(0).smallest, value - 20.0);
  EXPECT_LE(this->Counts(0).largest, value + 20.0);
  // Nothing has such values.
  this->SetNumber("smallestValue", 90000.0);
  this->SetNumber("largestValue", 90001.0);
  QTest::mouseClick(&this->slice, Qt::LeftButton, Qt::NoModifier, { 150, 150 });
  this->Await();
  EXPECT_TRUE(this->box.findChild<QLabel*>("drawHint")->text().startsWith("Nothing has changed"));
}

TEST_F(DrawnSegments, AreCleanedUpByButtons)
{
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 50.0);
  this->Stroke(140, 150);
  const std::int64_t large = this->Voxels(0);
  this->SetNumber("brushRadius", 12.0);
  this->Stroke(40, 41);
  ASSERT_GT(this->Voxels(0), large);
  this->Press("keepLargest");
  EXPECT_EQ(this->Voxels(0), large);
  this->model.History()->undo();
  const double ml = this->Counts(0).volumeMm3 / 1000.0;
  this->SetNumber("islandVolume", 0.5 * ml);
  this->Press("removeSmall");
  EXPECT_EQ(this->Voxels(0), large);
  this->SetNumber("smoothing", 30.0);
  this->Press("smooth");
  EXPECT_NE(this->Voxels(0), large);
  this->model.History()->undo();
  EXPECT_EQ(this->Voxels(0), large);
}

TEST_F(DrawnSegments, NoToolTurnsTheSlices)
{
  this->Press("newSegment");
  const auto cursorOnArm = [this]
  {
    QMouseEvent move(QEvent::MouseMove, QPointF(280, 150), Qt::NoButton, {}, {});
    QApplication::sendEvent(&this->slice, &move);
    return this->slice.cursor().shape();
  };
  EXPECT_EQ(cursorOnArm(), Qt::PointingHandCursor);
  for (const char* const tool : { "toolRegion", "toolPaint", "toolErase" })
  {
    this->Press(tool);
    EXPECT_EQ(cursorOnArm(), Qt::CrossCursor) << tool;
  }
}

TEST_F(DrawnSegments, TheCrosshairMovesAgainWithoutATool)
{
  this->Press("newSegment");
  this->Press("toolPaint");
  this->Press("toolNone");
  this->Stroke(150, 160); // from the middle: the arms of the crosshair turn the other slices
  EXPECT_EQ(this->Voxels(0), 0);
  EXPECT_TRUE(this->model.CurrentScene().slices.crosshairMm);
}

// An added PET of larger voxels, moved by hand, has segments of its own.
TEST_F(DrawnSegments, AreThoseOfTheChosenVolume)
{
  this->Press("newSegment");
  AddPet(this->model);
  EXPECT_FALSE(this->model.EditedLabels());
  EXPECT_EQ(this->panel.findChild<QTableWidget*>()->rowCount(), 0);
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 20.0);
  this->model.Edit(ScenePart::Overlays, "move",
    [](Scene& scene) {
      scene.overlays[0].placement.moveMm = { 24.0, 0.0, 0.0 };
    });
  this->Stroke(150, 150);
  EXPECT_EQ(this->Voxels(0), 0) << "the first volume has nothing painted";
  const std::int64_t painted = this->Voxels(0, 1);
  ASSERT_GT(painted, 4);
  EXPECT_NEAR(this->Counts(0, 1).volumeMm3 / double(painted), 512.0, 1e-6);
  // The stroke went through the middle of the slice, where the PET's voxels are that lie 24 mm
  // beside its own middle.
  std::array<double, 3> middle = *this->slice.PointAt({ 150.0, 150.0 });
  middle[0] -= 24.0;
  vtkImageData* const numbers = this->model.StudyOf(1)->labels->image;
  const vtkIdType voxel = numbers->FindPoint(middle.data());
  ASSERT_GE(voxel, 0);
  EXPECT_EQ(static_cast<unsigned char*>(numbers->GetScalarPointer())[voxel], 1);
  EXPECT_TRUE(this->model.HasUnsavedLabels(1));
}

TEST_F(DrawnSegments, HaveVersionsAndStepsOfTheirVolume)
{
  this->Press("newSegment");
  AddPet(this->model);
  this->Press("newSegment");
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 20.0);
  this->Stroke(150, 150);
  const std::int64_t painted = this->Voxels(0, 1);
  ASSERT_GT(painted, 4);
  this->model.TakeSavedLabels(
    "/scans/pet.seg.nrrd", this->model.EditedLabels()->segments, "save", 1);
  EXPECT_EQ(this->model.VolumeWithUnsavedLabels(), 0);
  this->model.SetEditedVolume(0);
  EXPECT_EQ(this->panel.findChild<QTableWidget*>()->rowCount(), 1);
  this->Stroke(100, 200);
  EXPECT_GT(this->Voxels(0), 0);
  EXPECT_FALSE(this->model.HasUnsavedLabels(1));
  this->model.History()->undo(); // paints in the first
  this->model.History()->undo(); // names the file
  this->model.History()->undo(); // paints in the PET
  EXPECT_EQ(this->Voxels(0, 1), 0);
  this->model.History()->redo();
  EXPECT_EQ(this->Voxels(0, 1), painted);
}

TEST_F(DrawnSegments, OfAnAddedVolumeGrowByItsOwnValues)
{
  AddPet(this->model);
  this->Press("newSegment");
  this->Press("toolRegion");
  this->SetNumber("smallestValue", 900.0);
  this->SetNumber("largestValue", 1100.0);
  QTest::mouseClick(&this->slice, Qt::LeftButton, {}, { 150, 150 });
  EXPECT_EQ(this->Voxels(0, 1), 8 * 8 * 8);
  EXPECT_EQ(this->Counts(0, 1).mean, 1000.0);
  const QTableWidget* const table = this->panel.findChild<QTableWidget*>();
  EXPECT_TRUE(table->item(0, 2)->text().remove(QRegExp("[^0-9]")).startsWith("1000"));
}

// The window goes on while a region grows, and the user may give it up.
TEST_F(DrawnSegments, AreWorkedOutBesideTheWindowUntilTheUserCancels)
{
  auto* const cancel = this->box.findChild<QPushButton*>("cancelSegmentWork");
  this->PressForAll();
  EXPECT_TRUE(this->editor.IsWorking());
  EXPECT_TRUE(cancel->isVisible());
  EXPECT_FALSE(this->box.findChild<QPushButton*>("smooth")->isEnabled());
  const int steps = this->model.History()->count();
  QTest::mouseClick(cancel, Qt::LeftButton);
  EXPECT_FALSE(cancel->isVisible());
  EXPECT_EQ(this->Voxels(0), 0);
  EXPECT_EQ(this->model.History()->count(), steps);
  QTest::mouseClick(&this->slice, Qt::LeftButton, Qt::NoModifier, { 150, 150 });
  EXPECT_EQ(this->Voxels(0), 32 * 28 * 20);
  EXPECT_EQ(this->model.History()->count(), steps + 1);
}

TEST_F(DrawnSegments, AreLeftAloneIfTheirLabelsChangeDuringTheWork)
{
  this->PressForAll();
  this->model.ChangeLabels({ { 3, 3, 2, 2, 1, 1 }, { 0 }, { 1 } }, "paint");
  EXPECT_EQ(this->Voxels(0), 1);
  EXPECT_TRUE(this->box.findChild<QLabel*>("drawHint")->text().contains("left out"));
}

TEST_F(DrawnSegments, HaveNoNumbersUntilTheyAreCounted)
{
  this->Press("newSegment");
  this->model.ChangeLabels({ { 3, 3, 2, 2, 1, 1 }, { 0 }, { 1 } }, "paint");
  const QTableWidget* const table = this->panel.findChild<QTableWidget*>();
  EXPECT_EQ(table->item(0, 1)->text(), QString::fromUtf8("…"));
  // A stroke that has begun goes on when the numbers come.
  this->Press("toolPaint");
  this->SetNumber("brushRadius", 40.0);
  QTest::mousePress(&this->slice, Qt::LeftButton, Qt::NoModifier, { 140, 150 });
  this->Await();
  EXPECT_NE(table->item(0, 1)->text(), QString::fromUtf8("…"));
  QTest::mouseRelease(&this->slice, Qt::LeftButton, Qt::NoModifier, { 140, 150 });
  EXPECT_GT(this->Voxels(0), 1);
  this->model.History()->undo();
  EXPECT_FALSE(this->model.AreSegmentsCounted()) << "a report cannot wait";
  this->model.CountSegments();
  EXPECT_EQ(this->model.CurrentStudy()->segmentStatistics[0].voxels, 1);
  EXPECT_TRUE(this->model.AreSegmentsCounted());
}
