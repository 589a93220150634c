#include "Viewer/Archives/SendDialog.h"

#include "Archive/Archive.h"
#include "DicomMeasures/DicomMeasures.h"
#include "Readers/Dicom/TaggedSeries.h"
#include "Readers/PrivateFolder.h"
#include "Scene/ImageFiles.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/VtkPictures.h"
#include "Viewer/WaitCursor.h"

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
  std::vector<Measure> measures;  ///< to send as a report of the scan
  LoadedVolume volume;            ///< the volume in which they were taken
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
  if (parcel.scan && !parcel.measures.empty())
  {
    files.push_back((folder.Path() / "measurements.dcm").string());
    ReadProgress progress(goesOn);
    const TaggedSeries images(parcel.scan->path, parcel.scan->series, progress);
    WriteDicomMeasures(parcel.measures, parcel.volume, images.Files(), files.back());
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
  this->identity->setEnabled(std::holds_alternative<FileSource>(model->CurrentScene().volume));
  this->identity->setToolTip(
    tr("Otherwise the image names nobody, and the archive lists it as a study of its own"));
  this->report->setObjectName("report");
  this->report->setEnabled(false);
  const auto study = model->CurrentStudy();
  const bool canReport =
    study && !study->volume.frameOfReference.empty() && !model->CurrentScene().measures.empty();
  connect(this->identity, &QCheckBox::toggled, this->report,
    [this, canReport](bool hasIdentity) { this->report->setEnabled(hasIdentity && canReport); });
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
    Parcel parcel = { BytesOfImage(maker.Draw()), { scene.render, MapperKind::Varimarch }, {}, {},
      study->volume };
    parcel.origin.isPreview = parcel.volume.isPreview;
    parcel.volume.image = SharedCopy(parcel.volume);
    if (const auto* const file = std::get_if<FileSource>(&scene.volume);
        file && this->identity->isChecked())
    {
      parcel.scan = *file;
    }
    if (this->report->isEnabled() && this->report->isChecked())
    {
      parcel.measures = scene.measures;
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
