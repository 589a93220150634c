// The list of measurements, and the thickness of slices.

#include "Answers.h"
#include "ScanOfPatient.h"
#include "Scene/Volumes/Placing.h"
#include "SmallStudy.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Panels/MeasuresPanel.h"
#include "Viewer/Panels/ViewBars.h"
#include "Viewer/View/Overlay.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Measures : public testing::Test
{
protected:
  Measures()
  {
    this->model.Open(ProceduralSource(), SmallStudy());
    this->model.Edit(ScenePart::Measures, "measure",
      [](Scene& scene)
      {
        scene.measures = { { MeasureKind::Distance, { { 0, 0, 0 }, { 3, 4, 0 } } },
          { MeasureKind::Angle, { { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 } }, "knee" },
          { MeasureKind::Box, { { -20, -20, -20 }, { 20, 20, 20 } } } };
      });
  }

  QTableWidget* Table() { return this->panel.findChild<QTableWidget*>(); }
  QString Text(int row, int column) { return this->Table()->item(row, column)->text(); }

  SceneModel model;
  MeasuresPanel panel{ &this->model };
};

}

TEST_F(Measures, AreListedWithTheirValues)
{
  this->model.Edit(ScenePart::Measures, "measure",
    [](Scene& scene) {
      scene.measures.push_back({ MeasureKind::Text, { { 0, 0, 2 } }, "here" });
    });
  ASSERT_EQ(this->Table()->rowCount(), 4);
  EXPECT_EQ(this->Text(0, 1), "5.0 mm");
  EXPECT_EQ(this->Text(1, 0), "knee");
  EXPECT_EQ(this->Text(1, 1), QString::fromUtf8("90.0°"));
  EXPECT_TRUE(this->Text(2, 1).contains(" voxels")) << this->Text(2, 1).toStdString();
  EXPECT_EQ(this->Text(3, 0), "here");
  EXPECT_EQ(this->Text(3, 1), "Text");
}

TEST_F(Measures, HaveShorterTextsForBoxesInImages)
{
  const Study& study = *this->model.CurrentStudy();
  const MeasureTexts texts(this->model.CurrentScene(), study);
  const QStringList lines = texts.labels.at(2).split('\n');
  ASSERT_EQ(lines.size(), 2);
  EXPECT_TRUE(texts.values.at(2).startsWith(lines[0] + ", from ")) << lines[0].toStdString();
  EXPECT_TRUE(texts.values.at(2).contains('\n' + lines[1] + ", ")) << lines[1].toStdString();
  EXPECT_EQ(VolumeText(999.0), QString::fromUtf8("999 mm³"));
  EXPECT_EQ(VolumeText(1234.0), "1.23 ml");
}

TEST_F(Measures, GiveTheUnitOfABoxAndSayThatItIsAMean)
{
  Study study = *this->model.CurrentStudy();
  const QString ofCt = MeasureTexts(this->model.CurrentScene(), study).labels.at(2);
  EXPECT_TRUE(ofCt.startsWith("mean ")) << ofCt.toStdString();
  EXPECT_TRUE(ofCt.section('\n', 0, 0).endsWith(" HU")) << ofCt.toStdString();
  study.volume.modality = "MR";
  EXPECT_FALSE(MeasureTexts(this->model.CurrentScene(), study).labels.at(2).contains("HU"));
}

TEST_F(Measures, KeepTheirValuesWhileOthersAreEdited)
{
  const QString ofBox = this->Text(2, 1);
  // The viewer never changes voxels; here they tell which statistics are made anew.
  this->model.CurrentStudy()->volume.image->GetPointData()->GetScalars()->Fill(77.0);
  this->model.Edit(ScenePart::Measures, "measure",
    [](Scene& scene)
    {
      scene.measures[0].pointsMm[1] = { 6, 8, 0 };
      scene.measures.push_back(scene.measures[2]);
    });
  EXPECT_EQ(this->Text(0, 1), "10.0 mm");
  EXPECT_EQ(this->Text(2, 1), ofBox);
  EXPECT_TRUE(this->Text(3, 1).startsWith("mean 77.0 ")) << this->Text(3, 1).toStdString();
}

TEST_F(Measures, ChangeTheirValuesWithTheTimeWhileANameIsTyped)
{
  this->panel.show();
  this->Table()->editItem(this->Table()->item(1, 0));
  auto* const line = this->Table()->findChild<QLineEdit*>();
  ASSERT_TRUE(line && line->isVisible());
  LoadedVolume later = this->model.CurrentStudy()->volume;
  later.image = vtkSmartPointer<vtkImageData>::New();
  later.image->DeepCopy(this->model.CurrentStudy()->volume.image);
  later.image->GetPointData()->GetScalars()->Fill(77.0);
  this->model.ShowTime(later);
  EXPECT_TRUE(this->Text(2, 1).startsWith("mean 77.0 ")) << this->Text(2, 1).toStdString();
  EXPECT_TRUE(line->isVisible());
}

// The number of pixels with a colour in an image of measurements, which is seen from the front.
int PixelsOf(const std::vector<Measure>& measures, const Study& study, const QColor& color,
  bool hasTexts = true)
{
  Scene scene;
  scene.measures = measures;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, -500.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  QImage image(400, 300, QImage::Format_RGB32);
  image.fill(Qt::black);
  QPainter painter(&image);
  MeasureTexts texts(scene, study);
  if (!hasTexts)
  {
    texts.labels.replaceInStrings(QRegularExpression(".*"), QString());
  }
  DrawMeasures(painter, { scene, texts, study.volume.image }, FrameOf(camera, image.size()),
    { [](const auto&) { return true; }, [](const auto&) { return false; } });
  painter.end();
  int pixels = 0;
  for (int i = 0; i < 400 * 300; ++i)
  {
    pixels += image.pixelColor(i % 400, i / 400) == color ? 1 : 0;
  }
  return pixels;
}

// Overlapping labels would share pixels.
TEST_F(Measures, HaveLabelsThatDoNotOverlap)
{
  const auto labelPixels = [this](int count)
  {
    const Measure measure = { MeasureKind::Distance, { { 0, 0, 0 }, { 10, 0, 0 } }, "aorta" };
    const std::vector<Measure> measures(std::size_t(count), measure);
    return PixelsOf(measures, *this->model.CurrentStudy(), QColor(235, 235, 235));
  };
  EXPECT_GT(labelPixels(1), 20);
  EXPECT_NEAR(labelPixels(3), 3 * labelPixels(1), 6) << "but for pixels on the line";
}

TEST_F(Measures, HaveLabelsThatDoNotCoverThemAtAnEdge)
{
  const auto markPixels = [this](double x, bool hasTexts)
  {
    const Measure measure = { MeasureKind::Distance, { { x, 0, 0 }, { x + 30, 0, -10 } } };
    return PixelsOf({ measure }, *this->model.CurrentStudy(), QColor(255, 210, 80), hasTexts);
  };
  for (const double x : { -100.0, 0.0, 120.0 })
  {
    EXPECT_GT(markPixels(x, false), 40) << x;
    EXPECT_EQ(markPixels(x, true), markPixels(x, false)) << x;
  }
}

TEST_F(Measures, AreRenamedRemovedAndRestored)
{
  this->model.History()->undo();
  this->model.History()->redo();
  this->Table()->item(2, 0)->setText("liver");
  EXPECT_EQ(this->model.CurrentScene().measures[2].name, "liver");
  this->Table()->setCurrentCell(1, 0);
  for (QPushButton* button : this->panel.findChildren<QPushButton*>())
  {
    if (button->text() == "Remove")
    {
      button->click();
    }
  }
  EXPECT_EQ(this->model.CurrentScene().measures[1].kind, MeasureKind::Box);
  EXPECT_EQ(this->Table()->rowCount(), 2);
  EXPECT_EQ(this->Text(1, 0), "liver");
  this->model.History()->undo();
  EXPECT_EQ(this->Text(1, 0), "knee");
}

TEST_F(Measures, AreHiddenByTheBoxBeforeTheirNames)
{
  this->Table()->item(1, 0)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(this->model.CurrentScene().measures[1].visible);
  EXPECT_EQ(this->model.CurrentScene().measures[1].name, "knee");
  EXPECT_TRUE(this->model.CurrentScene().measures[0].visible);
  this->model.History()->undo();
  EXPECT_EQ(this->Table()->item(1, 0)->checkState(), Qt::Checked);
}

// The floats of points as DICOM stores them.
std::string FloatBytes(const std::vector<float>& numbers)
{
  return { reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float) };
}

// Two scans of patients, of the studies 1.2.77 and 1.2.78.
class MeasuresOfTwoScans : public Measures
{
protected:
  void Open(const Placement& placementOfSecond)
  {
    std::vector<std::shared_ptr<const Study>> scans;
    for (int i = 0; i < 2; ++i)
    {
      WriteScanOfPatient(this->folders[i], "ISO_IR 100", i == 0 ? "1.2.77" : "1.2.78");
      LoadedVolume volume = LoadVolume(this->Source(i));
      ImageStatistics statistics(volume.image);
      scans.push_back(std::make_shared<const Study>(Study{ volume, statistics }));
    }
    this->model.Open(this->Source(0), scans[0]);
    OverlaidVolume overlay = OverlayOf(this->Source(1), scans[1]->volume, scans[1]->statistics);
    overlay.placement = placementOfSecond;
    this->model.AddOverlay(overlay, scans[1], "add a scan");
  }

  void Measure(const Measure& measure)
  {
    this->model.Edit(
      ScenePart::Measures, "measure", [&](Scene& scene) { scene.measures = { measure }; });
  }

  // The report of a volume, or the last sentence that tells why there is none.
  std::string Saved(int volume)
  {
    const std::string name = "sr" + std::to_string(volume) + ".dcm";
    const std::string path = this->folders[0].Path(name);
    this->model.SetEditedVolume(volume);
    const Answers answers(QMessageBox::Ok, QString::fromStdString(path));
    this->panel.findChild<QPushButton*>("save")->click();
    return QFile::exists(QString::fromStdString(path)) ? this->folders[0].Bytes(name)
                                                       : answers.LastQuestion().toStdString();
  }

private:
  FileSource Source(int scan) const { return { this->folders[scan].Path(""), std::nullopt }; }

  TemporaryFolder folders[2];
};

TEST_F(MeasuresOfTwoScans, AreReportedAsThoseOfTheScanThatIsEdited)
{
  this->Open({ {}, { 10.0, 0.0, 0.0 } });
  this->Measure({ MeasureKind::Distance, { { 0, 0, 0 }, { 3, 4, 0 } } });
  const std::string ofFirst = this->Saved(0);
  EXPECT_NE(ofFirst.find("1.2.77"), std::string::npos);
  EXPECT_NE(ofFirst.find(FloatBytes({ 0, 0, 0, 3, 4, 0 })), std::string::npos);
  const std::string ofSecond = this->Saved(1);
  EXPECT_EQ(ofSecond.find("1.2.77"), std::string::npos);
  EXPECT_NE(ofSecond.find("1.2.78"), std::string::npos);
  EXPECT_NE(ofSecond.find(FloatBytes({ -10, 0, 0, -7, 4, 0 })), std::string::npos);
}

// A box of the report would hold other voxels than the box on the screen.
TEST_F(MeasuresOfTwoScans, AreNotReportedWithABoxThatIsTurnedAgainstTheScan)
{
  this->Open({ { 0.0, 0.0, 10.0 }, {} });
  this->Measure({ MeasureKind::Box, { { -20, -20, -20 }, { 20, 20, 20 } } });
  EXPECT_EQ(this->Saved(1),
    "A box lies along the axes of the first scan, and this one has others. Remove the boxes, or "
    "save a table.");
  EXPECT_NE(this->Saved(0).find("1.2.77"), std::string::npos);
  this->Measure({ MeasureKind::Distance, { { 0, 0, 0 }, { 3, 4, 0 } } });
  EXPECT_NE(this->Saved(1).find("1.2.78"), std::string::npos);
}

TEST_F(Measures, AreGoneToByADoubleClick)
{
  emit this->Table()->cellDoubleClicked(0, 0);
  EXPECT_FALSE(this->model.CurrentScene().slices.crosshairMm) << "a name is edited";
  this->Table()->setCurrentCell(0, 1);
  emit this->Table()->cellDoubleClicked(0, 1);
  EXPECT_EQ(this->model.CurrentScene().slices.crosshairMm, (std::array<double, 3>{ 1.5, 2, 0 }));
}

TEST(Labels, NeverOverlapEvenIfThereIsNoRoomForAll)
{
  LabelPlaces places({ 300.0, 100.0 });
  std::vector<QRectF> taken;
  for (int i = 0; i < 60; ++i)
  {
    const QRectF wanted(140.0 + i % 3, 40.0, 60.0 + i % 2, 15.0);
    if (const auto place = places.Take(wanted))
    {
      for (const QRectF& other : taken)
      {
        EXPECT_FALSE(other.intersects(*place));
      }
      EXPECT_TRUE(QRectF(0, 0, 300, 100).contains(*place));
      taken.push_back(*place);
    }
  }
  EXPECT_GE(taken.size(), 12);
  EXPECT_LT(taken.size(), 30) << "there is room for 24";
}

TEST(Labels, GiveWayToTheTextsAtTheEdges)
{
  const QRectF corner(200.0, 0.0, 100.0, 32.0);
  LabelPlaces places({ 300.0, 100.0 }, { corner });
  const auto place = places.Take({ 210.0, 10.0, 60.0, 15.0 });
  ASSERT_TRUE(place);
  EXPECT_FALSE(place->intersects(corner));
}

TEST_F(Measures, SetTheThicknessOfSlices)
{
  SlabBar bar(&this->model);
  this->model.History()->undo();
  this->model.Edit(ScenePart::Slices, "slab", [](Scene& scene) { scene.slices.slabMm = 12.0; });
  EXPECT_EQ(bar.findChild<QDoubleSpinBox*>()->value(), 12.0);
  bar.findChild<QDoubleSpinBox*>()->setValue(20.0);
  bar.findChild<QComboBox*>()->setCurrentIndex(2);
  EXPECT_EQ(this->model.CurrentScene().slices.slabMm, 20.0);
  EXPECT_EQ(this->model.CurrentScene().slices.slabBlend, SlabBlend::Mean);
  this->model.History()->undo();
  EXPECT_EQ(bar.findChild<QComboBox*>()->currentIndex(), 0);
}
