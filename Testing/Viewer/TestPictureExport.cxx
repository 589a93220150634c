// Exported images: size, transparency, the scene in their metadata, and their files.

#include "Answers.h"
#include "LabelledStudy.h"
#include "Scene/Json/SceneFile.h"
#include "Viewer/View/PictureExport.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

#include <gtest/gtest.h>

#include <algorithm>

using namespace varimarch;

TEST(ExportedPicture, HasTheRequestedSizeAndBackground)
{
  const auto study = SmallStudy();
  const QImage onBackground =
    PictureMaker(SceneOfPatient(), *study, { { 120, 80 }, false, false }).Draw();
  EXPECT_EQ(onBackground.size(), QSize(120, 80));
  EXPECT_EQ(onBackground.pixelColor(0, 0), QColor(0, 0, 255));
  const QImage transparent =
    PictureMaker(SceneOfPatient(), *study, { { 120, 80 }, true, false }).Draw();
  EXPECT_EQ(transparent.pixelColor(0, 0).alpha(), 0);
  EXPECT_GT(transparent.pixelColor(60, 40).alpha(), 200) << "the spine";
}

TEST(ExportedPicture, HasANoticeThatIsLegibleOnAnyBackground)
{
  const auto study = SmallStudy();
  for (const double gray : { 0.0, 0.5, 1.0 })
  {
    Scene scene = SceneOfPatient();
    scene.background = { gray, gray, gray };
    const QImage picture = PictureMaker(scene, *study, { { 800, 600 }, false, false }).Draw();
    int darkest = 255;
    int brightest = 0;
    for (int y = 560; y < 600; ++y)
    {
      for (int x = 0; x < 100; ++x)
      {
        darkest = std::min(darkest, qGray(picture.pixel(x, y)));
        brightest = std::max(brightest, qGray(picture.pixel(x, y)));
      }
    }
    EXPECT_GT(brightest - darkest, 150) << gray;
  }
}

TEST(ExportedPicture, StoresTheSettingsWithoutPatientData)
{
  const auto study = LabelledStudy();
  Scene scene = SceneOfPatient();
  scene.volume = FileSource{ "/scans/DOE^JOHN/head.nrrd", std::nullopt, "1.2.840.99" };
  scene.look.name = "bone of DOE";
  scene.look.description = "as DOE needs it";
  scene.measures.push_back(
    { MeasureKind::Distance, { { 0.0, 0.0, 0.0 }, { 30.0, 40.0, 0.0 } }, "DOE" });
  scene.labels = { "/scans/DOE^JOHN/labels.nrrd", "1.2.840.99", study->labels->segments };
  scene.labels->segments[1].name = "tumour of DOE";
  const QString text =
    PictureMaker(scene, *study, { { 32, 32 }, false, false }).Draw().text("varimarch-scene");
  EXPECT_FALSE(text.contains("DOE")) << text.toStdString();
  EXPECT_FALSE(text.contains("1.2.840.99"));
  const Scene back = SceneFromText(text.toStdString(), "picture");
  EXPECT_EQ(back.look.opacities.size(), 2);
  EXPECT_EQ(back.measures.size(), 1);
  ASSERT_TRUE(back.labels);
  EXPECT_EQ(back.labels->segments.size(), 2);
  EXPECT_EQ(back.size, (std::array<int, 2>{ 32, 32 }));
}

TEST(ExportedPicture, IsNotWrittenIfTheUserCancels)
{
  SceneModel model;
  model.Open(ProceduralSource(), SmallStudy());
  const QTemporaryDir folder;
  ExportDialog dialog(&model, { 40, 300 }, nullptr);
  const Answers save(QMessageBox::Ok, folder.filePath("torso.png"));
  auto* const progress = dialog.findChild<QProgressBar*>();
  auto* const cancel = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel);
  QTimer user;
  bool isCancelled = false;
  QObject::connect(&user, &QTimer::timeout, &dialog,
    [&]
    {
      // The first click cancels the export, the second closes the dialog.
      if (progress->isVisible() || isCancelled)
      {
        isCancelled = true;
        cancel->click();
      }
    });
  user.start(0);
  EXPECT_EQ(dialog.exec(), QDialog::Rejected);
  EXPECT_TRUE(isCancelled);
  EXPECT_FALSE(QFile::exists(folder.filePath("torso.png")));
}

// DICOM holds no transparency, so its image lies over the background.
TEST(ExportedPicture, IsWrittenInTheFormatOfItsName)
{
  SceneModel model;
  model.Open(ProceduralSource(), SmallStudy());
  model.Edit(ScenePart::Background, "blue",
    [](Scene& scene) {
      scene.background = { 0.0, 0.0, 1.0 };
    });
  const QTemporaryDir folder;
  for (const QString name : { "torso.png", "torso.dcm" })
  {
    ExportDialog dialog(&model, { 40, 30 }, nullptr);
    dialog.findChild<QCheckBox*>("transparent")->setChecked(true);
    const Answers save(QMessageBox::Ok, folder.filePath(name));
    EXPECT_EQ(dialog.exec(), QDialog::Accepted) << name.toStdString();
  }
  const QImage png(folder.filePath("torso.png"));
  EXPECT_EQ(png.size(), QSize(40, 30));
  EXPECT_EQ(png.pixelColor(39, 0).alpha(), 0);
  EXPECT_TRUE(png.text("varimarch-scene").contains("background"));
  const LoadedVolume dicom =
    LoadVolume(FileSource{ folder.filePath("torso.dcm").toStdString(), std::nullopt });
  ASSERT_EQ(dicom.image->GetNumberOfScalarComponents(), 3);
  EXPECT_EQ(dicom.image->GetScalarComponentAsDouble(39, 0, 0, 0), 0.0);
  EXPECT_EQ(dicom.image->GetScalarComponentAsDouble(39, 0, 0, 2), 255.0);
}
