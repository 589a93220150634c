// A scan of several times in the window: chosen, played, kept in sessions.

#include "Answers.h"
#include "Module/Files/PhantomFiles.h"
#include "ScanOfTimes.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Pipeline/ScenePicking.h"
#include "TorsoWindow.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/Model/TimeSeries.h"
#include "Viewer/Panels/ViewBars.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"
#include "Viewer/View/SliceView.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSlider>
#include <QToolButton>

#include <vtkDataArray.h>
#include <vtkPointData.h>

using namespace varimarch;

namespace
{

class Times : public Window
{
protected:
  void OpenTimes(const QString& name = "times.nrrd")
  {
    this->files.Write("times.nrrd", NrrdOfTimes());
    this->window.Open(QString::fromStdString(this->files.Path(name.toStdString())));
    ASSERT_TRUE(QTest::qWaitFor(
      [&] { return this->Model()->CurrentStudy() && this->Bar()->isVisible(); }, MostMilliseconds));
  }

  TimeBar* Bar() { return this->window.findChild<TimeBar*>(); }
  QSlider* Slider() { return this->Bar()->findChild<QSlider*>("time"); }
  QAction* Action(const char* name) { return this->Bar()->findChild<QAction*>(name); }
  QLabel* Counted() { return this->window.findChild<QLabel*>("countedTimes"); }

  /// The value in the middle of the cube that is shown.
  double Shown()
  {
    vtkImageData* const image = this->Model()->CurrentStudy()->volume.image;
    return ValueAt(image, MiddleOf(image)).value_or(-1.0);
  }

  bool Awaits(int time)
  {
    return QTest::qWaitFor([&]
      { return this->Shown() == ValueAtTime(time) && this->Chosen() == time; },
      MostMilliseconds);
  }

  int Chosen() { return this->Model()->ChosenTime(); }

  void ChooseSpeed(const QString& speed)
  {
    auto* const speeds = this->Bar()->findChild<QComboBox*>("speed");
    speeds->setCurrentText(speed);
    ASSERT_EQ(speeds->currentText(), speed);
  }

  TemporaryFolder files;
};

}

TEST_F(Times, AreChosenWithTheSliderAndKeepTheRest)
{
  this->OpenTorso();
  EXPECT_FALSE(this->Bar()->isVisible()) << "a scan of one time needs no bar";
  this->OpenTimes();
  this->Model()->Edit(ScenePart::Camera, "zoom", [](Scene& scene) { scene.camera.zoom = 2.0; });
  const std::string scene = SceneText(this->Model()->CurrentScene());
  vtkRenderer* const renderer = this->View()->Pipeline()->Renderer();
  this->Slider()->setValue(4);
  ASSERT_TRUE(this->Awaits(4));
  EXPECT_EQ(this->Bar()->findChild<QLabel*>("timeText")->text(), "0.20 s, 5 of 6");
  EXPECT_EQ(this->View()->Pipeline()->Renderer(), renderer) << "the view is not made anew";
  Scene changedBack = this->Model()->CurrentScene();
  std::get<FileSource>(changedBack.volume).time = 0;
  EXPECT_EQ(SceneText(changedBack), scene);
  EXPECT_EQ(this->Action("previousTime")->shortcut(), QKeySequence(Qt::Key_Comma));
  this->Action("previousTime")->trigger();
  ASSERT_TRUE(this->Awaits(3));
  EXPECT_EQ(this->Action("nextTime")->shortcut(), QKeySequence(Qt::Key_Period));
  this->Action("nextTime")->trigger();
  ASSERT_TRUE(this->Awaits(4));
}

TEST_F(Times, AreDrawnInBothKindsOfViews)
{
  this->OpenTimes();
  const auto brightnessOfSlice = [this]
  {
    auto* const slice = this->window.findChild<SliceView*>();
    return slice->grab().toImage().pixelColor(slice->width() / 2 + 4, slice->height() / 2 + 4);
  };
  this->Model()->Edit(ScenePart::Slices, "window",
    [](Scene& scene) {
      scene.slices.windowLevel = { { 700.0, 350.0 } };
    });
  const int first = brightnessOfSlice().green();
  QSignalSpy drawn(this->View(), &VolumeView::Drawn);
  this->Slider()->setValue(5);
  ASSERT_TRUE(this->Awaits(5));
  EXPECT_GT(brightnessOfSlice().green(), first + 100);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !drawn.isEmpty(); }, MostMilliseconds));
  EXPECT_EQ(vtkImageData::SafeDownCast(this->View()->Pipeline()->Mapper()->GetInput()),
    this->Model()->CurrentStudy()->volume.image.Get());
}

TEST_F(Times, ArePlayedToTheEndAndAreOneStep)
{
  this->OpenTimes();
  this->ChooseSpeed("24 a second");
  this->Action("repeatTimes")->setChecked(false);
  std::vector<double> shown = { this->Shown() };
  QObject::connect(this->Model(), &SceneModel::Changed, this->Model(),
    [&](ScenePart part)
    {
      if (part == ScenePart::Voxels && shown.back() != this->Shown())
      {
        shown.push_back(this->Shown());
      }
    });
  EXPECT_EQ(this->Action("playTimes")->shortcut(), QKeySequence(Qt::Key_P));
  this->Action("playTimes")->trigger();
  ASSERT_TRUE(this->Action("playTimes")->isChecked());
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return !this->Action("playTimes")->isChecked(); }, MostMilliseconds));
  EXPECT_EQ(shown, (std::vector<double>{ 100, 200, 300, 400, 500, 600 })) << "each time is shown";
  EXPECT_EQ(this->Model()->History()->count(), 1);
  this->Model()->History()->undo();
  ASSERT_TRUE(this->Awaits(0));
  this->Model()->History()->redo();
  ASSERT_TRUE(this->Awaits(5));
}

TEST_F(Times, RepeatUntilTheyArePaused)
{
  this->OpenTimes();
  this->Slider()->setValue(5);
  ASSERT_TRUE(this->Awaits(5));
  this->Action("playTimes")->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return this->Shown() == ValueAtTime(2); }, MostMilliseconds));
  this->Action("playTimes")->trigger();
  const int paused = this->Chosen();
  QTest::qWait(200);
  EXPECT_EQ(this->Chosen(), paused);
}

TEST_F(Times, AreCountedInOneHistogram)
{
  this->OpenTimes();
  ASSERT_TRUE(QTest::qWaitFor(
    [&] { return this->Model()->CurrentStudy()->allTimes != nullptr; }, MostMilliseconds));
  EXPECT_FALSE(this->Counted()->isVisibleTo(this->window.findChild<QWidget*>("lookPanel")));
  const ImageStatistics& statistics = *this->Model()->CurrentStudy()->allTimes;
  EXPECT_EQ(statistics.Largest(), 600.0);
  ASSERT_EQ(statistics.Counts().size(), 601);
  EXPECT_EQ(statistics.Counts()[300], 64) << "the cube of one time";
  EXPECT_EQ(statistics.Counts()[0], 6 * (512 - 64));
  EXPECT_EQ(this->Model()->CurrentStudy()->statistics.Largest(), 100.0)
    << "looks and windows are judged by the time that was opened, and so do not change";
}

TEST_F(Times, StayWhereStepsAreTakenBack)
{
  this->OpenTimes();
  this->Model()->Edit(ScenePart::Camera, "zoom", [](Scene& scene) { scene.camera.zoom = 2.0; });
  this->Slider()->setValue(2);
  ASSERT_TRUE(this->Awaits(2));
  this->Model()->Edit(ScenePart::Camera, "zoom", [](Scene& scene) { scene.camera.zoom = 3.0; });
  this->Model()->History()->undo();
  EXPECT_EQ(this->Shown(), ValueAtTime(2));
  this->Model()->History()->undo();
  ASSERT_TRUE(this->Awaits(0));
  EXPECT_EQ(this->Model()->CurrentScene().camera.zoom, 2.0);
}

TEST_F(Times, OfAddedScansFollowIfThereAreAsMany)
{
  this->OpenTimes();
  this->files.Write("other.nrrd", NrrdOfTimes());
  this->window.AddScan(QString::fromStdString(this->files.Path("other.nrrd")));
  const auto overlays = [this] { return this->Model()->CurrentScene().overlays; };
  ASSERT_TRUE(QTest::qWaitFor([&] { return overlays().size() == 1; }, MostMilliseconds));
  const auto shown = [this]
  {
    vtkImageData* const image = this->Model()->StudyOf(1)->volume.image;
    return ValueAt(image, MiddleOf(image)).value_or(-1.0);
  };
  EXPECT_EQ(shown(), ValueAtTime(0));
  auto* const list = this->window.findChild<QListWidget*>("volumes");
  list->editItem(list->item(1));
  this->Slider()->setValue(4);
  ASSERT_TRUE(this->Awaits(4));
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown() == ValueAtTime(4); }, MostMilliseconds));
  EXPECT_EQ(this->window.findChild<QLabel*>("timeText")->text().count("loading"), 0);
  EXPECT_NE(list->findChild<QLineEdit*>(), nullptr) << "the name that is being typed";
  EXPECT_EQ(std::get<FileSource>(overlays()[0].source).time, 4) << "for sessions";
  EXPECT_EQ(StudyTimes(this->Model()->CurrentScene(), this->Model()->CurrentStudy())
              .Read(2)
              ->overlays[0]
              ->volume.times.current,
    2)
    << "for images in files";
  this->Model()->History()->undo();
  ASSERT_TRUE(this->Awaits(0));
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown() == ValueAtTime(0); }, MostMilliseconds));
  this->files.Write("other.nrrd", NrrdOfTimes().substr(0, 1000));
  QSignalSpy failed(this->window.findChild<TimeSeries*>(), &TimeSeries::Failed);
  this->Slider()->setValue(5);
  ASSERT_TRUE(this->Awaits(5));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, MostMilliseconds));
  EXPECT_TRUE(failed.first().first().toString().contains("other.nrrd"));
  EXPECT_EQ(shown(), ValueAtTime(0)) << "it keeps the time that was read";
  StudyTimes exported(this->Model()->CurrentScene(), this->Model()->CurrentStudy());
  EXPECT_EQ(exported.Read(3)->overlays[0]->volume.times.current, 0) << "as in the window";
  EXPECT_NE(exported.Problem().find("other.nrrd"), std::string::npos) << exported.Problem();
  StudyTimes cancelled(this->Model()->CurrentScene(), this->Model()->CurrentStudy());
  EXPECT_THROW(cancelled.Read(3, [](double) { return false; }), std::runtime_error);
}

TEST_F(Times, OfSessionsAreRestored)
{
  this->OpenTimes();
  this->Slider()->setValue(3);
  ASSERT_TRUE(this->Awaits(3));
  const QString session = QString::fromStdString(this->files.Path("session.json"));
  WriteScene(this->Model()->CurrentScene(), session);
  this->OpenTorso();
  this->window.Open(session);
  ASSERT_TRUE(QTest::qWaitFor([&] { return this->Bar()->isVisible(); }, MostMilliseconds));
  ASSERT_TRUE(this->Awaits(3));
  EXPECT_EQ(this->Slider()->value(), 3);
}

TEST_F(Times, AreKeptWithinTheirMemory)
{
  auto* const series = this->window.findChild<TimeSeries*>();
  series->SetMostBytes(3 * 512 * 2);
  this->OpenTimes();
  std::size_t most = 0;
  QObject::connect(series, &TimeSeries::KeptChanged, this->Model(),
    [&] { most = std::max(most, series->Kept().size()); });
  this->Slider()->setValue(4);
  ASSERT_TRUE(this->Awaits(4));
  ASSERT_TRUE(QTest::qWaitFor(
    [&]
    {
      return series->Kept().count(3) > 0 && series->Kept().count(5) > 0 &&
        this->Model()->CurrentStudy()->allTimes != nullptr;
    },
    MostMilliseconds))
    << "the times beside the chosen one are read before they are wanted";
  EXPECT_EQ(most, 3);
}

TEST_F(Times, ThatCannotBeReadAreLeft)
{
  this->OpenTimes();
  ASSERT_TRUE(QTest::qWaitFor(
    [&] { return this->Model()->CurrentStudy()->allTimes != nullptr; }, MostMilliseconds));
  auto* const series = this->window.findChild<TimeSeries*>();
  series->SetMostBytes(0);
  this->Slider()->setValue(1);
  ASSERT_TRUE(this->Awaits(1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return series->Kept().size() == 2; }, MostMilliseconds));
  this->files.Write("times.nrrd", NrrdOfTimes().substr(0, 1000));
  QSignalSpy failed(series, &TimeSeries::Failed);
  this->Slider()->setValue(4);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, MostMilliseconds));
  EXPECT_TRUE(failed.first().first().toString().contains("times.nrrd"));
  EXPECT_EQ(this->Slider()->value(), 1);
  EXPECT_EQ(this->Chosen(), 1);
}

TEST_F(Times, AreExportedAsPicturesEachOnce)
{
  this->OpenTorso();
  EXPECT_FALSE(this->window.findChild<QAction*>("exportTimes")->isEnabled());
  this->OpenTimes();
  const Answers answers(QMessageBox::Ok, this->Path("times.png"));
  this->window.findChild<QAction*>("exportTimes")->trigger();
  std::vector<QImage> pictures;
  for (int time = 0; time < timesOfScan; ++time)
  {
    pictures.emplace_back(this->Path("times-00%1.png").arg(time));
    ASSERT_FALSE(pictures.back().isNull()) << time;
  }
  EXPECT_FALSE(QFile::exists(this->Path("times-006.png")));
  EXPECT_NE(pictures.front(), pictures.back());
  EXPECT_TRUE(pictures.back().text("varimarch-scene").contains("\"time\": 5"));
}

TEST_F(Times, DrawACurveAtTheCrosshair)
{
  this->OpenTimes();
  auto* const curve = this->window.findChild<TimeCurve*>();
  EXPECT_FALSE(curve->isVisible());
  this->Action("curveOfTimes")->trigger();
  EXPECT_TRUE(curve->isVisible());
  auto* const series = this->window.findChild<TimeSeries*>();
  ASSERT_TRUE(
    QTest::qWaitFor([&] { return series->Kept().size() == timesOfScan; }, MostMilliseconds));
  curve->findChild<QAction*>("copyCurve")->trigger();
  EXPECT_EQ(QGuiApplication::clipboard()->text(),
    "time [s],value\n0,100\n0.05,200\n0.1,300\n0.15,400\n0.2,500\n0.25,600\n");
  const QImage before = curve->grab().toImage();
  this->Model()->Edit(ScenePart::Slices, "crosshair",
    [](Scene& scene) {
      scene.slices.crosshairMm = { { 0.0, 0.0, 0.0 } };
    });
  EXPECT_TRUE(curve->Csv().contains("0.25,0\n")) << "there is no cube in the corner";
  EXPECT_NE(curve->grab().toImage(), before);
  this->Action("curveOfTimes")->trigger();
  EXPECT_FALSE(curve->isVisible());
}

TEST_F(Times, MayBeFilesOfOneName)
{
  for (const int time : { 9, 10, 11 })
  {
    vtkNew<vtkImageData> volume;
    volume->SetDimensions(4, 4, 4);
    volume->AllocateScalars(VTK_SHORT, 1);
    volume->GetPointData()->GetScalars()->Fill(ValueAtTime(time));
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(volume);
    writer->SetFileName(this->Path(QStringLiteral("time%1.vti").arg(time)).toUtf8());
    writer->Write();
  }
  this->window.OpenTimes(this->Path("time10.vti"));
  ASSERT_TRUE(QTest::qWaitFor(
    [&] { return this->Model()->CurrentStudy() && this->Bar()->isVisible(); }, MostMilliseconds));
  EXPECT_EQ(this->Model()->CurrentStudy()->volume.times.values.size(), 3u);
  EXPECT_EQ(this->Shown(), ValueAtTime(9)) << "the first in the order of the numbers";
  this->Slider()->setValue(2);
  EXPECT_TRUE(QTest::qWaitFor([&] { return this->Shown() == ValueAtTime(11); }, MostMilliseconds));
}
