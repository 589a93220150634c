#include "Viewer/Archives/SendDialog.h"

#include "Archive/Archive.h"
#include "Readers/Dicom/TaggedSeries.h"
#include "Readers/Packed/PrivateFolder.h"
#include "Scene/Images/ImageFiles.h"
#include "Scene/Model/Scene.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/Reports/ScanReport.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/VtkPictures.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <cstdio>
#include <exception>

namespace varimarch
{

namespace
{

// The attributes of an image of a scan, which name the patient and the study.
CaptureIdentity IdentityOf(const FileSource& scan, const TaskProgress& goesOn)
{
  ReadProgress progress(goesOn);
  const TaggedSeries series(scan.path, scan.series, progress);
  CaptureIdentity identity;
  for (const DicomTag& tag : series.Tags(series.Count() / 2))
  {
    unsigned int group = 0;
    unsigned int element = 0;
    if (tag.depth == 0 && std::sscanf(tag.tag.c_str(), "(%x,%x)", &group, &element) == 2)
    {
      identity[group << 16 | element] = tag.value;
    }
  }
  return identity;
}

/// All that is sent.
struct Parcel
{
  vtkSmartPointer<vtkImageData> picture;
  PictureOrigin origin;
  std::optional<FileSource> scan; ///< the scan whose patient the image names; empty: nobody
  std::optional<MeasureReport> report;
};

void SendParcel(Parcel parcel, Archive& archive, const TaskProgress& goesOn)
{
  const PrivateFolder folder;
  std::vector<std::string> files = { (folder.Path() / "image.dcm").string() };
  if (parcel.scan)
  {
    parcel.origin.identity = IdentityOf(*parcel.scan, goesOn);
  }
  WritePicture(parcel.picture, parcel.origin, files.front());
  if (parcel.report)
  {
    files.push_back((folder.Path() / "measurements.dcm").string());
    parcel.report->Write(files.back(), goesOn);
  }
  archive.Send(files, goesOn);
}

}

SendDialog::SendDialog(SceneModel* model, QSize pixels, QWidget* parent)
  : QDialog(parent)
  , model(model)
  , pixels(pixels)
  , choice(new ArchiveChoice)
  , overlay(new QCheckBox(tr("Directions and measurements")))
  , identity(new QCheckBox(tr("With the patient and the study of the scan")))
  , report(new QCheckBox(tr("The measurements too, as a structured report")))
  , status(new QLabel)
  , progress(new QProgressBar)
{
  this->setObjectName("send");
  this->setWindowTitle(tr("Send the image to an archive"));
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->resize(520, 0);
  this->overlay->setChecked(true);
  this->identity->setObjectName("identity");
  this->identity->setToolTip(
    tr("Otherwise the image names nobody, and the archive lists it as a study of its own. With "
       "several scans it is the one chosen in the panel Volumes."));
  this->report->setObjectName("report");
  connect(this->identity, &QCheckBox::toggled, this, &SendDialog::ShowPossible);
  connect(model, &SceneModel::Changed, this, &SendDialog::ShowPossible);
  this->status->setObjectName("status");
  this->status->setTextFormat(Qt::PlainText);
  this->status->setWordWrap(true);
  this->progress->setRange(0, 0);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  this->send = buttons->addButton(tr("Send"), QDialogButtonBox::ActionRole);
  this->send->setObjectName("sendImage");
  auto* const column = new QVBoxLayout(this);
  column->addWidget(this->choice);
  column->addWidget(this->overlay);
  column->addWidget(this->identity);
  column->addWidget(this->report);
  column->addWidget(this->progress);
  column->addWidget(this->status);
  column->addWidget(buttons);
  connect(this->send, &QPushButton::clicked, this, &SendDialog::Send);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(&this->task, &BackgroundTask::RunningChanged, this, &SendDialog::ShowRunning);
  connect(&this->task, &BackgroundTask::Failed, this->status, &QLabel::setText);
  this->ShowRunning(false);
  this->ShowPossible();
}

void SendDialog::ShowPossible()
{
  const Scene& scene = this->model->CurrentScene();
  const int edited = this->model->EditedVolume();
  this->identity->setEnabled(std::holds_alternative<FileSource>(VolumeSourceOf(scene, edited)));
  this->report->setEnabled(this->identity->isEnabled() && this->identity->isChecked() &&
    !scene.measures.empty() &&
    MeasureReport::IsPossible(scene, *this->model->CurrentStudy(), edited));
}

void SendDialog::ShowRunning(bool isRunning)
{
  this->progress->setVisible(isRunning);
  this->send->setEnabled(!isRunning);
}

void SendDialog::Send()
{
  const std::optional<NamedArchive> archive = this->choice->Chosen();
  if (!archive)
  {
    this->status->setText(tr("Add an archive first."));
    return;
  }
  const auto password = PasswordOf(*archive, this);
  if (!password)
  {
    return;
  }
  try
  {
    const WaitCursor cursor;
    this->model->CountSegments();
    const Scene scene = this->model->CurrentScene();
    const auto study = ShownStudy(*this->model);
    PictureMaker maker(scene, *study, { this->pixels, false, this->overlay->isChecked() });
    Parcel parcel = { BytesOfImage(maker.Draw()), { scene.render, MapperKind::Varimarch }, {}, {} };
    parcel.origin.isPreview = study->volume.isPreview;
    const int edited = this->model->EditedVolume();
    if (this->identity->isEnabled() && this->identity->isChecked())
    {
      parcel.scan = std::get<FileSource>(VolumeSourceOf(scene, edited));
    }
    if (this->report->isEnabled() && this->report->isChecked())
    {
      parcel.report.emplace(scene, *study, edited);
    }
    this->task.Start([=, address = archive->address, secret = *password](const TaskProgress& goesOn)
      { SendParcel(parcel, *ArchiveAt(address, secret), goesOn); },
      [this] { this->status->setText(tr("The archive has stored the image.")); });
    this->status->setText(tr("Sending…"));
  }
  catch (const std::exception& problem)
  {
    this->status->setText(QString::fromStdString(problem.what()));
  }
}

}
