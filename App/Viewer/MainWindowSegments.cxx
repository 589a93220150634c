// The part of MainWindow that shows segmentations over the scan.

#include "Viewer/MainWindow.h"

#include "DicomSegments/DicomSegments.h"
#include "Readers/Dicom/TaggedSeries.h"
#include "Scene/SceneVolumes.h"
#include "Scene/SegmentFiles.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/SegmentEditor.h"
#include "Viewer/Open/FileKind.h"
#include "Viewer/Open/SeriesPicker.h"
#include "Viewer/Panels/SegmentEditingBox.h"
#include "Viewer/Panels/SegmentsPanel.h"
#include "Viewer/SaveDialog.h"
#include "Viewer/WaitCursor.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <iterator>

namespace varimarch
{

namespace
{

// Only DICOM has frames of reference.
bool IsDicom(const Study& study)
{
  return !study.volume.frameOfReference.empty();
}

/// Segments to save, and the volume that they lie on.
struct SegmentsToSave
{
  const Scene& scene;
  std::shared_ptr<const Study> first; ///< may be replaced in the model while a dialog is open
  int volume;

  const SceneLabels& Labels() const { return *SceneLabelsOf(this->scene, this->volume); }
  const Study& Scan() const { return StudyOfVolume(*this->first, this->volume); }
};

struct SavedSegments
{
  std::vector<Segment> segments; ///< with the values that they have in the file
  QStringList losses;            ///< sentences about what the format does not hold
};

std::vector<VolumeSource> SourcesOf(const Scene& scene)
{
  std::vector<VolumeSource> sources;
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    sources.push_back(VolumeSourceOf(scene, volume));
  }
  return sources;
}

// DICOM numbers segments from 1 on.
SavedSegments SaveDicomSegments(const SegmentsToSave& segments, const std::string& path)
{
  RequireNoFileOf(SourcesOf(segments.scene), path);
  const auto& scan = std::get<FileSource>(VolumeSourceOf(segments.scene, segments.volume));
  ReadProgress progress([](double) { return true; });
  const TaggedSeries images(scan.path, scan.series, progress);
  SavedSegments saved = { segments.Labels().segments, {} };
  WriteDicomSegments(*segments.Scan().labels, saved.segments, images.Files(), path);
  for (std::size_t i = 0; i < saved.segments.size(); ++i)
  {
    saved.segments[i].value = int(i) + 1;
  }
  return saved;
}

SavedSegments SaveSegments(const SegmentsToSave& segments, const std::string& path)
{
  if (IsDicom(segments.Scan()) &&
    QString::fromStdString(path).endsWith(".dcm", Qt::CaseInsensitive))
  {
    return SaveDicomSegments(segments, path);
  }
  SavedSegments saved = { segments.Labels().segments, {} };
  for (const std::string& loss :
    WriteSegments(*segments.Scan().labels, saved.segments, SourcesOf(segments.scene), path))
  {
    saved.losses.append(QString::fromStdString(loss));
  }
  return saved;
}

bool MayBelongTo(const LoadedVolume& scan, const SeriesSummary& segmentation)
{
  return scan.frameOfReference.empty() || segmentation.frameOfReference.empty() ||
    scan.frameOfReference == segmentation.frameOfReference;
}

}

QWidget* MainWindow::MakeSegmentsPanel()
{
  auto* const segments = new SegmentsPanel(&this->model);
  connect(segments, &SegmentsPanel::OpenWanted, this, &MainWindow::ChooseSegmentation);
  connect(segments, &SegmentsPanel::Saved, this, &MainWindow::ShowSaved);
  connect(segments, &SegmentsPanel::Selected, this->segmentEditor, &SegmentEditor::SetSegment);
  auto* const box = new SegmentEditingBox(&this->model, this->segmentEditor);
  connect(box, &SegmentEditingBox::SaveWanted, this,
    [this] { this->SaveSegmentation(this->model.EditedVolume()); });
  auto* const panel = new QWidget;
  auto* const column = new QVBoxLayout(panel);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(segments, 1);
  column->addWidget(box);
  return panel;
}

bool MainWindow::SaveSegmentation(int volume)
{
  QStringList filters = { tr("Segmentation of 3D Slicer (*.seg.nrrd)"), tr("NIfTI (*.nii.gz)") };
  if (IsDicom(*this->model.StudyOf(volume)))
  {
    filters.append(tr("DICOM segmentation (*.dcm)"));
  }
  const QString name =
    volume == 0 ? "segmentation" : QStringLiteral("segmentation-%1").arg(volume + 1);
  const QString path = ChosenFileToSave(this, tr("Save the segmentation"), filters, name);
  if (path.isEmpty())
  {
    return false;
  }
  SavedSegments saved;
  try
  {
    const WaitCursor waiting;
    saved = SaveSegments(
      { this->model.CurrentScene(), this->model.CurrentStudy(), volume }, path.toStdString());
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this, tr("Cannot save"), QString::fromStdString(problem.what()));
    return false;
  }
  this->model.TakeSavedLabels(
    path.toStdString(), saved.segments, tr("save the segmentation"), volume);
  this->ShowSaved(path);
  if (!saved.losses.isEmpty())
  {
    QMessageBox::information(this, tr("Saved %1").arg(path), saved.losses.join('\n'));
  }
  return true;
}

void MainWindow::ChooseSegmentation()
{
  const QString path = this->model.CurrentStudy()
    ? QFileDialog::getOpenFileName(this, tr("Open a segmentation of this scan"), {}, FileFilter())
    : QString();
  if (!path.isEmpty())
  {
    this->OpenSegmentation({ path.toStdString() });
  }
}

void MainWindow::OpenSegmentation(const SceneLabels& labels)
{
  this->ReadSegmentation(labels, this->model.EditedVolume());
}

void MainWindow::ReadSegmentation(const SceneLabels& labels, int volume)
{
  this->ForgetRequest();
  this->labelledVolume = volume;
  this->BeginLoading(QString::fromStdString(labels.path));
  this->loader.LoadLabels(labels, this->model.StudyOf(volume));
}

// A file that is dropped on scans may be a segmentation of one of them, first of all of the chosen
// one. Folders and sessions are opened.
void MainWindow::OpenDropped(const QString& path)
{
  const std::string name = path.toStdString();
  const bool hasScan = this->model.CurrentStudy() != nullptr;
  if (!hasScan || KindOfFile(path) != FileKind::Volume ||
    MayHoldSeveralSeries({ name, std::nullopt }))
  {
    this->Open(path);
    return;
  }
  this->ForgetRequest();
  this->isDropped = true;
  this->labelledVolume = this->model.EditedVolume();
  this->BeginLoading(path);
  std::vector<std::shared_ptr<const Study>> scans = { this->model.EditedStudy() };
  for (int volume = 0; volume < VolumeCount(this->model.CurrentScene()); ++volume)
  {
    if (volume != this->model.EditedVolume())
    {
      scans.push_back(this->model.StudyOf(volume));
    }
  }
  this->loader.LoadBeside(name, scans);
}

void MainWindow::ShowSegmentation(
  const SceneLabels& labels, const std::shared_ptr<const Study>& labelled)
{
  const std::optional<int> volume = this->model.VolumeOf(*labelled);
  if (!volume && this->labelledVolume == 0)
  {
    // Meanwhile the user chose another form of the scan, with another grid.
    this->ReadSegmentation(labels, 0);
    return;
  }
  if (!volume)
  {
    this->ShowLoading(false); // meanwhile the user removed the added scan
    return;
  }
  LogEvent("segmentation opened",
    { { "segments", double(labelled->labels->segments.size()) },
      { "warnings", double(labelled->labels->warnings.size()) } });
  this->ShowLoading(false);
  this->model.SetEditedVolume(*volume);
  this->model.ShowLabels(labels, labelled, tr("open a segmentation"), *volume);
  this->statusBar()->showMessage(tr("Segments: %1").arg(labelled->labels->segments.size()));
  this->RaiseSegments();
}

void MainWindow::RaiseSegments()
{
  auto* const panel = this->findChild<QDockWidget*>("segments");
  panel->show();
  panel->raise();
}

// Asks what a file of few whole values is.
void MainWindow::AskForSegmentation(const SceneLabels& labels,
  const std::shared_ptr<const Study>& labelled, const std::shared_ptr<const Study>& own)
{
  this->ShowLoading(false);
  auto* const box = new QMessageBox(QMessageBox::Question, tr("Varimarch"),
    tr("This file may be a segmentation of the scan that is shown: it lies in the same place, and "
       "has %1 different whole values. Show it as segments of the scan?")
      .arg(labelled->labels->segments.size()),
    QMessageBox::NoButton, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName("possibleSegmentation");
  QPushButton* const asSegments = box->addButton(tr("Show as segments"), QMessageBox::YesRole);
  QPushButton* const asScan = box->addButton(tr("Open as a scan"), QMessageBox::NoRole);
  box->addButton(QMessageBox::Cancel);
  connect(
    asSegments, &QAbstractButton::clicked, this, [=] { this->ShowSegmentation(labels, labelled); });
  connect(asScan, &QAbstractButton::clicked, this,
    [=] {
      this->ShowLoaded(FileSource{ labels.path, std::nullopt }, own);
    });
  box->open();
}

void MainWindow::OfferSegmentations(const FileSource& folder)
{
  const auto study = this->model.CurrentStudy();
  std::vector<SeriesSummary> offered;
  std::copy_if(this->segmentations.begin(), this->segmentations.end(), std::back_inserter(offered),
    [&](const SeriesSummary& one) { return MayBelongTo(study->volume, one); });
  this->segmentations.clear();
  if (offered.empty() || study->labels)
  {
    return;
  }
  auto* const box = new QMessageBox(QMessageBox::Question, tr("Varimarch"),
    tr("Beside the scan the folder holds a segmentation. Show its segments?"),
    QMessageBox::Yes | QMessageBox::No, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName("foundSegmentation");
  connect(box->button(QMessageBox::Yes), &QAbstractButton::clicked, this,
    [=] { this->ShowOffered(folder, offered); });
  box->open();
}

void MainWindow::ShowOffered(const FileSource& folder, const std::vector<SeriesSummary>& offered)
{
  if (offered.size() == 1)
  {
    this->OpenSegmentation({ folder.path, offered.front().uid });
    return;
  }
  auto* const picker = new SeriesPicker(offered, this);
  picker->setAttribute(Qt::WA_DeleteOnClose);
  connect(picker, &SeriesPicker::Chosen, this,
    [=](const QString& uid) {
      this->OpenSegmentation({ folder.path, uid.toStdString() });
    });
  picker->open();
}

}
