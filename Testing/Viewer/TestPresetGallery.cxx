// The preset gallery: thumbnails of this volume, presets applied by a click, and the user's own.

#include "OverlaidStudy.h"
#include "Scene/Looks/Presets.h"
#include "Viewer/Panels/PresetGallery.h"
#include "Waiting.h"

#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <gtest/gtest.h>

#include <fstream>

using namespace varimarch;

namespace
{

class Gallery : public testing::Test
{
protected:
  Gallery()
  {
    this->panel.resize(400, 600);
    this->panel.show();
    this->model.Open(ProceduralSource(), SmallStudy());
  }

  QListWidget* List() { return this->panel.findChild<QListWidget*>(); }

  QListWidgetItem* Item(const QString& title)
  {
    return this->List()->findItems(title, Qt::MatchExactly).value(0);
  }

  QImage Picture(int row) { return this->List()->item(row)->icon().pixmap(200, 200).toImage(); }

  void Click(const QString& title)
  {
    QTest::mouseClick(this->List()->viewport(), Qt::LeftButton, {},
      this->List()->visualItemRect(this->Item(title)).center());
  }

  void Press(const QString& button) { this->panel.findChild<QPushButton*>(button)->click(); }

  QToolButton* Fold() { return this->panel.findChild<QToolButton*>("fold"); }

  // No part of its histogram is air, soft tissue or bone.
  void OpenCheckerboard()
  {
    LoadedVolume even =
      LoadVolume(ProceduralSource{ ProceduralKind::Checkerboard, { 16, 16, 16 }, 1 });
    ImageStatistics statistics(even.image);
    this->model.Open(ProceduralSource(),
      std::make_shared<const Study>(Study{ std::move(even), std::move(statistics) }));
  }

  const Look& TheLook() const { return this->model.CurrentScene().look; }

  QTemporaryDir folder;
  SceneModel model;
  PresetGallery panel{ &this->model, this->folder.filePath("presets") };
};

}

// A preset gives only its look to a volume over the first one.
TEST_F(Gallery, KnowsThePresetOfAFurtherVolume)
{
  AddPet(this->model);
  this->model.Edit(
    ScenePart::Render, "tolerance", [](Scene& scene) { scene.render.errorTolerance = 0.125; });
  this->Click("PET maximum");
  ASSERT_TRUE(this->List()->currentItem());
  EXPECT_EQ(this->List()->currentItem()->text(), "PET maximum");
  const int steps = this->model.History()->count();
  this->Click("PET maximum");
  EXPECT_EQ(this->model.History()->count(), steps);
}

TEST_F(Gallery, ShowsThisVolumeAsEachPresetDoes)
{
  ASSERT_EQ(this->List()->count(), int(PresetNames().size()));
  const QImage empty = this->Picture(0);
  this->Fold()->click();
  ASSERT_TRUE(QTest::qWaitFor(
    [&] { return this->Picture(this->List()->count() - 1) != empty; }, MostMilliseconds));
  const QImage bone = this->Picture(this->List()->row(this->Item("CT bone")));
  const QImage skin = this->Picture(this->List()->row(this->Item("CT skin")));
  EXPECT_NE(bone, skin);
  EXPECT_GT(qGray(skin.pixel(skin.rect().center())), 20) << "the torso is in the middle";
}

TEST_F(Gallery, FoldsTheLooksForOtherKindsOfScans)
{
  EXPECT_FALSE(this->Item("CT bone")->isHidden());
  ASSERT_TRUE(this->Item("MR maximum")->isHidden());
  EXPECT_TRUE(this->Fold()->text().contains("(6)")) << "four for MR and two for PET";
  QTest::keyClick(this->Fold(), Qt::Key_Space);
  EXPECT_FALSE(this->Item("MR maximum")->isHidden());
  this->Click("MR maximum");
  EXPECT_EQ(this->TheLook().name, "mr-maximum");
  QTest::keyClick(this->Fold(), Qt::Key_Space);
  EXPECT_TRUE(this->Item("MR maximum")->isHidden());
  this->Press("keep");
  EXPECT_FALSE(this->Item("My look 1")->isHidden()) << "one's own looks are never folded";
  AddPet(this->model);
  EXPECT_FALSE(this->Item("PET hot")->isHidden());
  EXPECT_TRUE(this->Item("MR maximum")->isHidden());
  EXPECT_FALSE(this->Item("CT bone")) << "nothing in the PET is like air, soft tissue and bone";
}

TEST_F(Gallery, LeavesOutLooksThatCannotShowTheVolume)
{
  this->OpenCheckerboard();
  EXPECT_FALSE(this->Item("CT bone"));
  EXPECT_TRUE(this->Item("MR maximum"));
}

TEST_F(Gallery, IsHiddenAndShownAgainWithAllItsPictures)
{
  this->Fold()->click();
  const QImage empty = this->Picture(0);
  const int last = this->List()->count() - 1;
  ASSERT_TRUE(QTest::qWaitFor([&] { return this->Picture(last) != empty; }, MostMilliseconds));
  QTest::qWait(100);
  this->panel.hide();
  this->panel.show();
  QTest::qWait(300);
  EXPECT_NE(this->Picture(last), empty);
}

// The list of the new volume is shorter, and its rows are other looks.
TEST_F(Gallery, ShowsNoPictureOfAVolumeThatWasReplacedWhileItWasHidden)
{
  const QImage empty = this->Picture(0);
  this->panel.hide();
  this->OpenCheckerboard();
  QTest::qWait(3000); // the pictures of the first volume would be drawn by now
  for (int row = 0; row < this->List()->count(); ++row)
  {
    EXPECT_EQ(this->Picture(row), empty) << row;
  }
}

TEST_F(Gallery, MarksTheCurrentLook)
{
  EXPECT_EQ(this->List()->currentItem(), this->Item("CT bone"));
  Look edited = this->TheLook();
  edited.shading.ambient = 0.5;
  this->model.SetLook(edited, "edit");
  EXPECT_FALSE(this->List()->currentItem());
  this->model.History()->undo();
  EXPECT_EQ(this->List()->currentItem(), this->Item("CT bone"));
  this->model.Edit(
    ScenePart::Render, "quality", [](Scene& scene) { scene.render.errorTolerance = 0.5; });
  EXPECT_FALSE(this->List()->currentItem());
}

TEST_F(Gallery, AppliesTheWholeLookByAClickInOneStep)
{
  this->Click("CT lungs");
  EXPECT_EQ(this->TheLook().name, "ct-lung");
  this->Click("CT maximum");
  EXPECT_EQ(this->TheLook().blend, Blend::MaximumIntensity);
  this->Click("CT maximum");
  EXPECT_EQ(this->model.History()->count(), 2);
  this->model.History()->undo();
  EXPECT_EQ(this->TheLook().name, "ct-lung");
  EXPECT_EQ(this->List()->currentItem(), this->Item("CT lungs"));
}

TEST_F(Gallery, AppliesQualityAndBackgroundInTheSameStep)
{
  const auto change = [](Scene& scene)
  {
    scene.render.errorTolerance = 0.5;
    scene.background = { 1.0, 1.0, 1.0 };
  };
  this->model.Edit(ScenePart::Render, "quality and background", change);
  std::vector<ScenePart> parts;
  QObject::connect(
    &this->model, &SceneModel::Changed, [&](ScenePart part) { parts.push_back(part); });
  this->Click("CT bone");
  const Preset bone = BuiltInPreset("ct-bone");
  EXPECT_EQ(this->model.CurrentScene().render.errorTolerance, bone.errorTolerance);
  EXPECT_EQ(this->model.CurrentScene().background, bone.background);
  EXPECT_EQ(parts, (std::vector{ ScenePart::Look, ScenePart::Render, ScenePart::Background }));
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().render.errorTolerance, 0.5);
  EXPECT_EQ(this->model.CurrentScene().background, (std::array{ 1.0, 1.0, 1.0 }));
}

TEST_F(Gallery, IsOperatedByKeys)
{
  this->List()->setCurrentItem(this->Item("CT skin"));
  QTest::keyClick(this->List(), Qt::Key_Return);
  EXPECT_EQ(this->TheLook().name, "ct-skin");
}

TEST_F(Gallery, AddsRenamesAndRemovesOwnPresets)
{
  Look own = this->TheLook();
  own.shading.specularPower = 77.0;
  this->model.SetLook(own, "edit");
  this->model.Edit(ScenePart::Background, "rose",
    [](Scene& scene) {
      scene.background = { 1.0, 0.5, 0.5 };
    });
  this->Press("keep");
  ASSERT_TRUE(this->Item("My look 1"));
  this->Item("My look 1")->setText("Temporal bone");
  this->Click("CT lungs");
  this->Click("Temporal bone");
  EXPECT_EQ(this->TheLook().shading.specularPower, 77.0);
  EXPECT_EQ(this->model.CurrentScene().background, (std::array{ 1.0, 0.5, 0.5 }));
  EXPECT_EQ(this->TheLook().name, "Temporal bone");

  SceneModel later;
  PresetGallery again(&later, this->folder.filePath("presets"));
  later.Open(ProceduralSource(), SmallStudy());
  const QListWidget* const list = again.findChild<QListWidget*>();
  EXPECT_EQ(list->findItems("Temporal bone", Qt::MatchExactly).size(), 1);

  QTimer::singleShot(0, &this->panel,
    [this] { this->panel.findChild<QMessageBox*>()->button(QMessageBox::Yes)->click(); });
  this->Press("remove");
  EXPECT_FALSE(this->Item("Temporal bone"));
  EXPECT_FALSE(QFile::exists(this->folder.filePath("presets/Temporal bone.json")));
}

TEST_F(Gallery, DoesNotRemoveBuiltInPresets)
{
  this->Click("CT lungs");
  EXPECT_FALSE(this->panel.findChild<QPushButton*>("remove")->isEnabled());
  this->Press("keep");
  EXPECT_TRUE(this->panel.findChild<QPushButton*>("remove")->isEnabled());
}

TEST_F(Gallery, ExplainsABrokenFileAndShowsTheOthers)
{
  this->Press("keep");
  std::ofstream(this->folder.filePath("presets/broken.json").toStdString()) << "{";
  this->model.Open(ProceduralSource(), SmallStudy());
  EXPECT_TRUE(this->Item("My look 1"));
  EXPECT_FALSE(this->Item("broken"));
  bool isTold = false;
  for (const QLabel* label : this->panel.findChildren<QLabel*>())
  {
    isTold = isTold || (!label->isHidden() && label->text().contains("broken.json"));
  }
  EXPECT_TRUE(isTold);
}

TEST_F(Gallery, RefusesAUsedName)
{
  this->Press("keep");
  this->Press("keep");
  this->Item("My look 2")->setText("My look 1");
  EXPECT_TRUE(this->Item("My look 2"));
  this->Item("My look 2")->setText("../outside");
  EXPECT_TRUE(this->Item("My look 2"));
}

TEST_F(Gallery, StopsDrawingForAnotherVolumeAndAtTheEnd)
{
  QTest::qWait(700); // while thumbnails are being rendered
  this->model.Open(ProceduralSource(), SmallStudy());
  const QImage empty = this->Picture(0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return this->Picture(0) != empty; }, MostMilliseconds));
}
