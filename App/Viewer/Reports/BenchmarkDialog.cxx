#include "Viewer/Reports/BenchmarkDialog.h"

#include "Core/Quality/ImageError.h"
#include "Scene/Files/OutputFile.h"
#include "Scene/Median.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Reports/ScanReport.h"
#include "Viewer/View/VtkPictures.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTextDocument>
#include <QTimer>

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <locale>
#include <sstream>

namespace varimarch
{

namespace
{

QString SummaryText(const std::vector<OrbitPicture>& pictures, const QString& theirs)
{
  const OrbitSummary summary = SummaryOf(pictures);
  return BenchmarkDialog::tr("Median of %1 views: ours %2 ms, %3 %4 ms, %5 times as long. "
                             "Difference: RMSE %6, largest %7, in 1/255.")
    .arg(pictures.size())
    .arg(NumberText(summary.medianOursMs, 1))
    .arg(theirs)
    .arg(NumberText(summary.medianTheirsMs, 1))
    .arg(NumberText(summary.medianTheirsMs / summary.medianOursMs, 2))
    .arg(NumberText(summary.rootMeanSquare, 2))
    .arg(NumberText(summary.largest, 1));
}

// Says what a mapper of VTK cannot draw of a scene; empty if it draws everything.
QString MissingIn(MapperKind kind, const Scene& scene)
{
  if (!CanBlend(kind, scene.look.blend))
  {
    return BenchmarkDialog::tr(
      "VTK's CPU mapper does not support this blend mode; choose VTK's GPU mapper.");
  }
  // Segments need a mask, as scissors do.
  return scene.labels && !CanCutByScissors(kind)
    ? BenchmarkDialog::tr("VTK's CPU mapper does not support segments; choose VTK's GPU mapper.")
    : QString();
}

QStringList CellsOf(const OrbitPicture& picture)
{
  return { NumberText(picture.degrees, 0), NumberText(picture.oursMs, 1),
    NumberText(picture.theirsMs, 1), NumberText(picture.rootMeanSquare, 2),
    NumberText(picture.largest, 1) };
}

QStringList ColumnNames()
{
  return { BenchmarkDialog::tr("Angle [°]"), BenchmarkDialog::tr("Ours [ms]"),
    BenchmarkDialog::tr("VTK's [ms]"), BenchmarkDialog::tr("RMSE"),
    BenchmarkDialog::tr("Largest") };
}

QString HtmlRow(const QStringList& cells, const char* tag)
{
  QString row = "<tr>";
  for (const QString& cell : cells)
  {
    row += QStringLiteral("<%1 align='right'>&nbsp;&nbsp;%2</%1>").arg(tag, cell.toHtmlEscaped());
  }
  return row + "</tr>";
}

}

BenchmarkDialog::BenchmarkDialog(SceneModel* model, QSize pictureSize, QWidget* parent)
  : QDialog(parent)
  , model(model)
  , pictureSize(pictureSize)
  , progress(new QProgressBar)
  , summary(new QLabel)
{
  this->setObjectName("benchmark");
  this->setWindowTitle(tr("Benchmark"));
  this->resize(520, 480);
  auto* const column = new QVBoxLayout(this);
  auto* const purpose = new QLabel(tr("Renders the scene from all around with our mapper and with "
                                      "VTK's, and compares times and images."));
  purpose->setWordWrap(true);
  column->addWidget(purpose);
  column->addWidget(this->MakeChoices());
  this->MakeTable();
  column->addWidget(this->progress);
  column->addWidget(this->table, 1);
  this->summary->setObjectName("summary");
  this->summary->setWordWrap(true);
  this->summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(this->summary);
  this->MakeButtons();
  this->ShowState();
}

BenchmarkDialog::~BenchmarkDialog()
{
  const DrawingWithoutDisplay drawing;
  this->orbit.reset();
}

QWidget* BenchmarkDialog::MakeChoices()
{
  this->kind = new QComboBox;
  this->kind->setObjectName("kind");
  this->kind->addItem(tr("VTK's GPU mapper"), int(MapperKind::VtkGpu));
  this->kind->addItem(tr("VTK's CPU mapper"), int(MapperKind::VtkCpu));
  this->count = new QSpinBox;
  this->count->setObjectName("count");
  this->count->setRange(1, 360);
  this->count->setValue(24);
  auto* const choices = new QWidget;
  auto* const form = new QFormLayout(choices);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Compare with"), this->kind);
  form->addRow(tr("Number of views"), this->count);
  return choices;
}

void BenchmarkDialog::MakeTable()
{
  this->table = new QTableWidget(0, ColumnNames().size());
  this->table->setTabKeyNavigation(false); // Tab leads out of it
  this->table->setAccessibleName(tr("Results"));
  this->table->setHorizontalHeaderLabels(ColumnNames());
  this->table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->table->verticalHeader()->hide();
  this->table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
}

void BenchmarkDialog::MakeButtons()
{
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  this->start = buttons->addButton(tr("Start"), QDialogButtonBox::ActionRole);
  this->start->setObjectName("start");
  this->save = buttons->addButton(tr("Export…"), QDialogButtonBox::ActionRole);
  connect(this->start, &QPushButton::clicked, this,
    [this] { this->IsRunning() ? this->Stop() : this->Start(); });
  connect(this->save, &QPushButton::clicked, this, &BenchmarkDialog::Export);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  this->layout()->addWidget(buttons);
}

MapperKind BenchmarkDialog::ChosenKind() const
{
  return MapperKind(this->kind->currentData().toInt());
}

void BenchmarkDialog::Start()
{
  Scene scene = this->model->CurrentScene();
  const QString missing = MissingIn(this->ChosenKind(), scene);
  if (!missing.isEmpty())
  {
    this->summary->setText(missing);
    return;
  }
  scene.size = { this->pictureSize.width(), this->pictureSize.height() };
  this->measured.clear();
  this->table->setRowCount(0);
  this->measuredKind = this->kind->currentText();
  this->study = this->model->CurrentStudy();
  try
  {
    const DrawingWithoutDisplay drawing;
    this->orbit = std::make_unique<OrbitBenchmark>(
      scene, this->study->volume.image, this->ChosenKind(), this->count->value());
    if (scene.labels)
    {
      this->orbit->ShowLabels(this->study->labels, scene.labels->segments);
    }
  }
  catch (const std::exception& problem)
  {
    this->summary->setText(QString::fromStdString(problem.what()));
    return;
  }
  this->ShowState();
  QTimer::singleShot(0, this, &BenchmarkDialog::Continue);
}

void BenchmarkDialog::Continue()
{
  if (!this->orbit)
  {
    return;
  }
  try
  {
    const DrawingWithoutDisplay drawing;
    this->orbit->DrawNext();
  }
  catch (const std::exception& problem)
  {
    this->Stop();
    this->summary->setText(QString::fromStdString(problem.what()));
    return;
  }
  this->measured = this->orbit->Pictures();
  this->AddRow(this->measured.back());
  if (this->orbit->IsDone())
  {
    this->Stop();
    return;
  }
  this->ShowState();
  QTimer::singleShot(0, this, &BenchmarkDialog::Continue);
}

void BenchmarkDialog::Stop()
{
  {
    const DrawingWithoutDisplay drawing;
    this->orbit.reset();
  }
  this->ShowState();
  emit this->Ended();
}

void BenchmarkDialog::done(int result)
{
  if (this->IsRunning())
  {
    this->Stop();
  }
  QDialog::done(result);
}

void BenchmarkDialog::AddRow(const OrbitPicture& picture)
{
  const int row = this->table->rowCount();
  this->table->insertRow(row);
  const QStringList cells = CellsOf(picture);
  for (int column = 0; column < cells.size(); ++column)
  {
    auto* const item = new QTableWidgetItem(cells[column]);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    this->table->setItem(row, column, item);
  }
  this->table->scrollToBottom();
}

void BenchmarkDialog::ShowState()
{
  this->progress->setRange(0, this->count->value());
  this->progress->setValue(int(this->measured.size()));
  this->start->setText(this->IsRunning() ? tr("Stop") : tr("Start"));
  this->start->setEnabled(this->model->CurrentStudy() != nullptr);
  this->kind->setEnabled(!this->IsRunning());
  this->count->setEnabled(!this->IsRunning());
  this->save->setEnabled(!this->measured.empty() && !this->IsRunning());
  this->summary->setText(
    this->measured.empty() ? QString() : SummaryText(this->measured, this->measuredKind));
}

void BenchmarkDialog::Export()
{
  const QString path = ChosenFileToSave(
    this, tr("Export the benchmark"), { tr("Report (*.pdf)"), tr("Table (*.csv)") }, "benchmark");
  if (path.isEmpty())
  {
    return;
  }
  try
  {
    this->Write(path);
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this, tr("Cannot export"), QString::fromStdString(problem.what()));
  }
}

void BenchmarkDialog::Write(const QString& path) const
{
  if (path.endsWith(".csv", Qt::CaseInsensitive))
  {
    WriteFileWhole(path.toStdString(), CsvOf(this->measured));
    return;
  }
  QString rows = HtmlRow(ColumnNames(), "th");
  for (const OrbitPicture& picture : this->measured)
  {
    rows += HtmlRow(CellsOf(picture), "td");
  }
  const int* const voxels = this->study->volume.image->GetDimensions();
  const QString scene = tr("A turn around a volume of %1 x %2 x %3 voxels, rendered at %4 x %5 "
                           "pixels by our mapper and by %6.")
                          .arg(voxels[0])
                          .arg(voxels[1])
                          .arg(voxels[2])
                          .arg(this->pictureSize.width())
                          .arg(this->pictureSize.height())
                          .arg(this->measuredKind);
  QTextDocument document;
  document.setHtml(QStringLiteral("<h1>%1</h1>%2<p>%3</p><p><b>%4</b></p><table>%5</table>")
                     .arg(tr("Benchmark"), OriginHtml(), scene,
                       SummaryText(this->measured, this->measuredKind), rows));
  WritePdf(document, tr("Benchmark"), path);
}

namespace
{

ImageError DifferenceOf(vtkImageData* picture, vtkImageData* from)
{
  return CompareImages(static_cast<const float*>(picture->GetScalarPointer()),
    static_cast<const float*>(from->GetScalarPointer()), std::size_t(from->GetNumberOfPoints()));
}

void Turn(OffscreenView& view, double degrees)
{
  vtkRenderer* const renderer = view.Pipeline().Renderer();
  renderer->GetActiveCamera()->Azimuth(degrees);
  renderer->ResetCameraClippingRange();
}

}

OrbitBenchmark::OrbitBenchmark(
  const Scene& scene, vtkImageData* image, MapperKind theirs, int pictures)
  : ours(scene, image, MapperKind::Varimarch)
  , theirs(scene, image, theirs)
  , count(pictures)
{
  this->ours.Render();
  this->theirs.Render();
}

void OrbitBenchmark::ShowLabels(
  std::shared_ptr<const LabelMap> labels, const std::vector<Segment>& segments)
{
  for (OffscreenView* const view : { &this->ours, &this->theirs })
  {
    view->Pipeline().SetLabels(labels);
    view->Pipeline().SetSegments(segments);
    view->Render();
  }
}

void OrbitBenchmark::DrawNext()
{
  OrbitPicture picture;
  picture.degrees = 360.0 * double(this->drawn.size()) / this->count;
  picture.oursMs = 1000.0 * this->ours.Render();
  picture.theirsMs = 1000.0 * this->theirs.Render();
  const ImageError error = DifferenceOf(this->theirs.FloatImage(), this->ours.FloatImage());
  picture.rootMeanSquare = error.rootMeanSquare;
  picture.largest = error.largest;
  this->drawn.push_back(picture);
  for (OffscreenView* const view : { &this->ours, &this->theirs })
  {
    Turn(*view, 360.0 / this->count);
  }
}

OrbitSummary SummaryOf(const std::vector<OrbitPicture>& pictures)
{
  OrbitSummary summary = {};
  std::vector<double> ours;
  std::vector<double> theirs;
  for (const OrbitPicture& picture : pictures)
  {
    ours.push_back(picture.oursMs);
    theirs.push_back(picture.theirsMs);
    summary.rootMeanSquare += picture.rootMeanSquare * picture.rootMeanSquare / pictures.size();
    summary.largest = std::max(summary.largest, picture.largest);
  }
  summary.medianOursMs = Median(std::move(ours));
  summary.medianTheirsMs = Median(std::move(theirs));
  summary.rootMeanSquare = std::sqrt(summary.rootMeanSquare);
  return summary;
}

std::string CsvOf(const std::vector<OrbitPicture>& pictures)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "degrees,ours_ms,vtk_ms,rmse_255,largest_255\n";
  for (const OrbitPicture& picture : pictures)
  {
    text << picture.degrees << ',' << picture.oursMs << ',' << picture.theirsMs << ','
         << picture.rootMeanSquare << ',' << picture.largest << '\n';
  }
  return text.str();
}

}
