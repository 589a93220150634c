#include "Viewer/Open/WarningBar.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Dicom/Metadata.h"
#include "Scene/Model/Scene.h"
#include "Scene/Slices/SlicePicture.h"
#include "Viewer/Model/RecentScans.h"

#include <vtkVolumeFileReader.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <filesystem>
#include <set>

namespace varimarch
{

namespace
{

// Reads a file that nothing else is known of.
DicomRecord RecordOfFile(const std::string& path, ReadProgress& progress)
{
  DicomRecord found;
  ForEachRecord(
    { path }, [&](std::size_t, const DicomRecord& record) { found = record; }, progress);
  return found;
}

// Looks for the other images of a file's series in its folder. Empty if there are none, or if the
// file is no DICOM image. Runs in the thread.
std::optional<WholeSeries> WholeSeriesOf(const std::string& path, const TaskProgress& goesOn)
{
  const char* const format = vtkVolumeFileReader::GetFormatOfFile(path.c_str());
  if (!format || format != std::string("DICOM") || !std::filesystem::is_regular_file(path))
  {
    return std::nullopt;
  }
  const DecoderSession session;
  ReadProgress progress(goesOn);
  const std::string uid = RecordOfFile(path, progress).seriesUid;
  const std::string folder = std::filesystem::path(path).parent_path().string();
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      files.push_back(entry.path().string());
    }
  }
  std::set<std::string> images; // a copy of an image is the same one
  ForEachRecord(
    files,
    [&](std::size_t, const DicomRecord& record)
    {
      if (!uid.empty() && record.seriesUid == uid)
      {
        images.insert(record.imageUid);
      }
    },
    progress);
  return images.size() > 1 ? std::optional(WholeSeries{ folder, uid, int(images.size()) })
                           : std::nullopt;
}

// The warnings of all volumes and their labels.
std::vector<ScanWarning> WarningsOf(const Scene& scene, const Study& study)
{
  std::vector<ScanWarning> all;
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    const Study& one = StudyOfVolume(study, volume);
    const std::string name = volume == 0 ? std::string() : scene.overlays[volume - 1].name;
    std::vector<std::string> sentences = one.volume.warnings;
    if (one.labels)
    {
      sentences.insert(sentences.end(), one.labels->warnings.begin(), one.labels->warnings.end());
    }
    for (const std::string& sentence : sentences)
    {
      all.push_back(
        { one.labelGuard, QString::fromStdString(sentence), QString::fromStdString(name) });
    }
  }
  return all;
}

}

QString ScanWarning::Text() const
{
  return this->name.isEmpty() ? this->sentence : this->name + ": " + this->sentence;
}

WarningBar::WarningBar(SceneModel* model, QWidget* parent)
  : QFrame(parent)
  , model(model)
  , text(new QLabel)
  , remedy(new QPushButton)
{
  this->setObjectName("warnings");
  // Fixed colours that are legible with dark and light themes.
  this->setStyleSheet("#warnings { background: #fff3cd; border-bottom: 1px solid #d9a400; }"
                      "#warnings QLabel { color: #3d2f00; }");
  auto* const sign = new QLabel;
  sign->setPixmap(this->style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(20, 20));
  this->text->setTextFormat(Qt::PlainText);
  this->text->setWordWrap(true);
  this->text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->remedy->setObjectName("remedy");
  connect(this->remedy, &QPushButton::clicked, this, &WarningBar::TakeRemedy);
  auto* const close = new QToolButton;
  close->setIcon(this->style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close->setAutoRaise(true);
  close->setToolTip(tr("Dismiss"));
  close->setAccessibleName(close->toolTip());
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(sign, 0, Qt::AlignTop);
  row->addWidget(this->text, 1);
  row->addWidget(this->remedy, 0, Qt::AlignTop);
  row->addWidget(close, 0, Qt::AlignTop);
  this->hide();
  connect(model, &SceneModel::Changed, this,
    [this](ScenePart part)
    {
      if (part == ScenePart::Volume || part == ScenePart::Labels || part == ScenePart::Overlays)
      {
        this->Show(part == ScenePart::Volume);
      }
    });
}

void WarningBar::LookForSeries(const VolumeSource& source)
{
  this->seriesSearch.Cancel();
  const auto* const file = std::get_if<FileSource>(&source);
  const bool isSingleImage = SingleImageOf(this->model->CurrentStudy()->volume.image).has_value();
  if (!isSingleImage || !file || !file->series.empty())
  {
    return;
  }
  this->seriesSearch.Start([path = file->path](const TaskProgress& goesOn)
    { return WholeSeriesOf(path, goesOn); },
    [this](const std::optional<WholeSeries>& found)
    {
      this->wholeSeries = found;
      this->Show(false);
    });
}

// Edits of segments and of names leave a bar closed that the user has closed, unless one of the
// warnings is new.
void WarningBar::Show(bool isNewVolume)
{
  const Study& study = *this->model->CurrentStudy();
  const SliceLayout slices = study.volume.slices;
  QString remedyText = slices == SliceLayout::Irregular ? tr("Rectify")
    : slices == SliceLayout::Rectified                  ? tr("Show as scanned")
                                                        : QString();
  std::vector<ScanWarning> found = WarningsOf(this->model->CurrentScene(), study);
  if (isNewVolume)
  {
    this->wholeSeries.reset();
  }
  if (this->wholeSeries)
  {
    remedyText = tr("Open all images");
    found.push_back({ study.labelGuard,
      tr("This image belongs to a series of %1 images.").arg(this->wholeSeries->imageCount), {} });
  }
  const auto isShown = [this](const ScanWarning& warning)
  {
    return std::any_of(this->shown.begin(), this->shown.end(),
      [&](const ScanWarning& other) { return warning.IsThatOf(other); });
  };
  const bool isAnyNew = !std::all_of(found.begin(), found.end(), isShown);
  const bool staysOpen = (isNewVolume || !this->isHidden()) && !found.empty();
  this->shown = std::move(found);
  this->remedy->setText(remedyText);
  this->remedy->setVisible(!remedyText.isEmpty());
  this->text->setText(this->Texts().join('\n'));
  this->setVisible(isAnyNew || staysOpen);
}

void WarningBar::TakeRemedy()
{
  if (this->wholeSeries)
  {
    emit this->SeriesWanted(
      QString::fromStdString(this->wholeSeries->folder), DigestOfSeries(this->wholeSeries->uid));
  }
  else
  {
    emit this->OtherFormWanted();
  }
}

QStringList WarningBar::Texts() const
{
  QStringList texts;
  for (const ScanWarning& warning : this->shown)
  {
    texts.append(warning.Text());
  }
  return texts;
}

}
