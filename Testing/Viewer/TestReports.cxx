// Reports: the benchmark of an orbit, and the report of a scan.

#include "LabelledStudy.h"
#include "Viewer/Reports/BenchmarkDialog.h"
#include "Viewer/Reports/ScanReport.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace varimarch;

namespace
{

QByteArray BytesOf(const QString& path)
{
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

class Reports : public testing::Test
{
protected:
  Reports()
  {
    this->model.Open(FileSource{ "/scans/DOE^JOHN/head.nrrd", std::nullopt }, SmallStudy());
  }

  SceneModel model;
  QTemporaryDir folder;
};

class Benchmark : public Reports
{
protected:
  template <class Widget>
  Widget* Find(const char* name) const
  {
    return this->dialog.findChild<Widget*>(name);
  }

  void Run()
  {
    QSignalSpy ended(&this->dialog, &BenchmarkDialog::Ended);
    QTest::mouseClick(this->Find<QPushButton>("start"), Qt::LeftButton);
    ASSERT_TRUE(this->dialog.IsRunning());
    ASSERT_TRUE(ended.wait(60000));
  }

  BenchmarkDialog dialog{ &this->model, QSize(64, 48) };
};

}

TEST(OrbitSummary, HasMedianTimesAndTheErrorsOfAllViews)
{
  const OrbitSummary summary =
    SummaryOf({ { 0, 10, 30, 3, 20 }, { 120, 12, 50, 4, 70 }, { 240, 90, 40, 0, 5 } });
  EXPECT_EQ(summary.medianOursMs, 12.0);
  EXPECT_EQ(summary.medianTheirsMs, 40.0);
  EXPECT_NEAR(summary.rootMeanSquare, std::sqrt(25.0 / 3.0), 1e-12);
  EXPECT_EQ(summary.largest, 70.0);
}

TEST_F(Benchmark, GoesAroundOnceAndIsExported)
{
  this->Find<QSpinBox>("count")->setValue(4);
  this->Run();
  ASSERT_EQ(this->dialog.findChild<QTableWidget*>()->rowCount(), 4);
  EXPECT_EQ(this->dialog.findChild<QTableWidget*>()->item(3, 0)->text(), "270");
  EXPECT_TRUE(this->Find<QLabel>("summary")->text().startsWith("Median of 4 views"));
  this->dialog.Write(this->folder.filePath("orbit.csv"));
  const QList<QByteArray> lines = BytesOf(this->folder.filePath("orbit.csv")).split('\n');
  ASSERT_EQ(lines.size(), 6);
  EXPECT_EQ(lines[0], "degrees,ours_ms,vtk_ms,rmse_255,largest_255");
  const QList<QByteArray> numbers = lines[2].split(',');
  EXPECT_EQ(numbers[0], "90");
  EXPECT_GT(numbers[1].toDouble(), 0.0);
  EXPECT_GT(numbers[2].toDouble(), 0.0);
  EXPECT_GT(numbers[3].toDouble(), 0.0) << "the two images are never identical";
  EXPECT_LT(numbers[3].toDouble(), 30.0);
  this->dialog.Write(this->folder.filePath("orbit.pdf"));
  EXPECT_TRUE(BytesOf(this->folder.filePath("orbit.pdf")).startsWith("%PDF"));
  EXPECT_THROW(this->dialog.Write(this->folder.filePath("no/orbit.pdf")), std::runtime_error);
}

TEST_F(Benchmark, StopsOnRequestAndKeepsItsResults)
{
  this->Find<QSpinBox>("count")->setValue(300);
  QSignalSpy ended(&this->dialog, &BenchmarkDialog::Ended);
  QTest::mouseClick(this->Find<QPushButton>("start"), Qt::LeftButton);
  auto* const table = this->dialog.findChild<QTableWidget*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->rowCount() > 0; }, 60000));
  QTest::mouseClick(this->Find<QPushButton>("start"), Qt::LeftButton);
  EXPECT_FALSE(this->dialog.IsRunning());
  EXPECT_EQ(ended.count(), 1);
  const int rows = table->rowCount();
  EXPECT_LT(rows, 300);
  QTest::qWait(50);
  EXPECT_EQ(table->rowCount(), rows);
}

TEST_F(Benchmark, NamesBlendModesThatVtkDoesNotSupport)
{
  Look look = this->model.CurrentScene().look;
  look.blend = Blend::AverageIntensity;
  this->model.SetLook(look, "average");
  this->Find<QComboBox>("kind")->setCurrentText("VTK's CPU mapper");
  QTest::mouseClick(this->Find<QPushButton>("start"), Qt::LeftButton);
  EXPECT_FALSE(this->dialog.IsRunning());
  EXPECT_TRUE(this->Find<QLabel>("summary")->text().contains("does not support this blend mode"));
}

// The test looks for the words in the laid-out page, since a PDF stores the numbers of glyphs.
TEST_F(Reports, StateTheSettingsWithoutPatientData)
{
  this->model.Edit(ScenePart::Measures, "measure",
    [](Scene& scene)
    {
      scene.measures.push_back(
        { MeasureKind::Distance, { { 0.0, 0.0, 0.0 }, { 30.0, 40.0, 0.0 } }, "head" });
      scene.measures.push_back({ MeasureKind::Text, { { 0.0, 0.0, 0.0 } }, "see here" });
    });
  const QString text = ScanReportHtml(this->model.CurrentScene(), *this->model.CurrentStudy());
  for (const char* const words :
    { "ct-bone", "50.0 mm", "at most 1/64", "32 x 28 x 20", "CT", "see here" })
  {
    EXPECT_TRUE(text.contains(words)) << words;
  }
  EXPECT_FALSE(text.contains("DOE"));
  EXPECT_FALSE(text.contains("head"));
}

TEST_F(Reports, PromiseNoErrorForACoarseCopy)
{
  Study copy = *this->model.CurrentStudy();
  copy.volume.isPreview = true;
  const QString text = ScanReportHtml(this->model.CurrentScene(), copy);
  EXPECT_TRUE(text.contains("32 x 28 x 20, a coarse copy"));
  EXPECT_TRUE(text.contains("not bounded"));
  EXPECT_FALSE(text.contains("at most 1/64"));
}

TEST_F(Reports, FillOnePageAndKeepTheLinesOfABoxApart)
{
  this->model.Edit(ScenePart::Measures, "measure",
    [](Scene& scene)
    {
      scene.measures.assign(
        3, { MeasureKind::Distance, { { 0.0, 0.0, 0.0 }, { 30.0, 40.0, 0.0 } } });
      scene.measures.push_back({ MeasureKind::Box, { { -20, -20, -20 }, { 20, 20, 20 } } });
    });
  const QString text = ScanReportHtml(this->model.CurrentScene(), *this->model.CurrentStudy());
  EXPECT_TRUE(text.contains(QRegularExpression("HU<br>[0-9.]+ m"))) << text.toStdString();
  const QString path = this->folder.filePath("report.pdf");
  WriteScanReport(&this->model, path);
  EXPECT_EQ(BytesOf(path).count("/Type /Page\n"), 1);
}

TEST_F(Reports, ListTheSegmentsWithTheirStatistics)
{
  const auto text = [this]
  { return ScanReportHtml(this->model.CurrentScene(), *this->model.CurrentStudy()); };
  EXPECT_FALSE(text().contains("Segments"));
  this->model.ShowLabels({ "/scans/DOE^JOHN/labels.nrrd" }, LabelledStudy(), "open");
  this->model.Edit(ScenePart::Segments, "rename",
    [](Scene& scene) { scene.labels->segments[0].name = "lower <half>"; });
  const QString table = text().mid(text().indexOf("<h3>Segments</h3>"));
  EXPECT_EQ(table.count("<tr>"), 2) << table.toStdString();
  EXPECT_TRUE(table.contains("lower &lt;half&gt;") && table.contains("Label 5"));
  EXPECT_TRUE(table.contains(QString("%1 voxels").arg(32 * 28 * 10)));
  EXPECT_TRUE(table.contains(QString("%1 voxels").arg(32 * 10)));
  EXPECT_FALSE(text().contains("DOE"));
}

TEST_F(Reports, MarkAnEditedLook)
{
  Look look = this->model.CurrentScene().look;
  look.shading.ambient = 0.5;
  this->model.SetLook(look, "edit");
  EXPECT_TRUE(ScanReportHtml(this->model.CurrentScene(), *this->model.CurrentStudy())
                .contains("ct-bone, edited"));
}

TEST_F(Reports, OmitTheNameOfAnOwnLook)
{
  Look look = this->model.CurrentScene().look;
  look.name = "John Doe";
  this->model.SetLook(look, "load");
  const QString text = ScanReportHtml(this->model.CurrentScene(), *this->model.CurrentStudy());
  EXPECT_FALSE(text.contains("John"));
  EXPECT_TRUE(text.contains("custom look"));
}

TEST_F(Reports, ContainTheImagesOfAScan)
{
  const QString path = this->folder.filePath("report.pdf");
  WriteScanReport(&this->model, path);
  const QByteArray pdf = BytesOf(path);
  EXPECT_TRUE(pdf.startsWith("%PDF"));
  EXPECT_GE(pdf.count("/Subtype /Image"), 4) << "the volume and three slices";
  EXPECT_FALSE(pdf.contains("DOE"));
  EXPECT_THROW(
    WriteScanReport(&this->model, this->folder.filePath("no/report.pdf")), std::runtime_error);
}
