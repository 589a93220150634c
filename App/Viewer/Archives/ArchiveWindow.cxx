#include "Viewer/Archives/ArchiveWindow.h"

#include "Readers/Packed/PrivateFolder.h"
#include "Viewer/Studies/StudyTree.h"

#include <QDate>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <stdexcept>

namespace varimarch
{

namespace
{

// Data of the items: UIDs of the study and the series, and the date as stored.
constexpr int StudyRole = Qt::UserRole;
constexpr int SeriesRole = Qt::UserRole + 1;
constexpr int DateRole = Qt::UserRole + 2;

QString Text(const std::string& text)
{
  return QString::fromStdString(text);
}

QTreeWidgetItem* StudyItem(const ArchiveStudy& study)
{
  const QString name = PersonText(Text(study.patientName));
  const QString none =
    study.hasUnreadableTexts ? ArchiveWindow::tr("Unreadable name") : ArchiveWindow::tr("No name");
  auto* const item = new QTreeWidgetItem({ name.isEmpty() ? none : name, Text(study.patientId),
    DateText(Text(study.date)), Text(study.modalities), QString(), Text(study.description) });
  item->setData(0, StudyRole, Text(study.uid));
  item->setData(0, DateRole, Text(study.date));
  item->setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
  return item;
}

QTreeWidgetItem* SeriesItem(const QTreeWidgetItem& study, const ArchiveSeries& series)
{
  auto* const item =
    new QTreeWidgetItem({ ArchiveWindow::tr("Series %1").arg(Text(series.number)), QString(),
      QString(), Text(series.modality), Text(series.imageCount), Text(series.description) });
  item->setData(0, StudyRole, study.data(0, StudyRole));
  item->setData(0, SeriesRole, Text(series.uid));
  item->setData(0, DateRole, study.data(0, DateRole));
  return item;
}

// Says that texts of studies or series are missing; empty if none are.
template <class Found>
QString UnreadableText(const std::vector<Found>& found)
{
  const auto count = UnreadableCount(found);
  return count == 0 ? QString()
                    : ". " +
      ArchiveWindow::tr("Texts of %1 entries are left out: they are in an unknown set of "
                        "characters, or in another than the archive says.")
        .arg(count);
}

// The folder that gets a scan.
struct FetchPlace
{
  QString folder;
  std::shared_ptr<const PrivateFolder> temporary; ///< null if the user keeps the folder
};

// A new folder in the user's. The archive tells the date, which may be a path.
QString NewFolderIn(const QString& place, const QString& date)
{
  const bool isDate = QDate::fromString(date, "yyyyMMdd").isValid();
  const QString start = place + "/scan-" + (isDate ? date : "0") + '-';
  int number = 1;
  while (QFileInfo::exists(start + QString::number(number)))
  {
    ++number;
  }
  const QString folder = start + QString::number(number);
  if (!QDir().mkdir(folder))
  {
    throw std::runtime_error(ArchiveWindow::tr("The folder \"%1\" cannot be made; choose another.")
                               .arg(folder)
                               .toStdString());
  }
  return folder;
}

// Makes a folder in the user's; a private one without that.
FetchPlace MakePlace(const QString& users, const QString& date)
{
  if (!users.isEmpty())
  {
    return { NewFolderIn(users, date), nullptr };
  }
  const auto temporary = std::make_shared<const PrivateFolder>();
  return { Text(temporary->Path().string()), temporary };
}

// Keeps no part of a scan, which would look like the whole.
void FetchInto(const FetchPlace& place, Archive& archive, const std::string& study,
  const std::string& series, const TaskProgress& goesOn)
{
  try
  {
    archive.Fetch(study, series, place.folder.toStdString(), goesOn);
  }
  catch (...)
  {
    if (!place.temporary)
    {
      QDir(place.folder).removeRecursively();
    }
    throw;
  }
}

}

ArchiveWindow::ArchiveWindow(QWidget* parent)
  : QDialog(parent)
  , choice(new ArchiveChoice)
  , patientName(new QLineEdit)
  , patientId(new QLineEdit)
  , dates(new QLineEdit)
  , modality(new QLineEdit)
  , tree(new QTreeWidget)
  , status(new QLabel)
  , progress(new QProgressBar)
  , cancel(new QPushButton(tr("Cancel")))
{
  this->setObjectName("archive");
  this->setWindowTitle(tr("Archive"));
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->resize(860, 560);
  this->tree->setAccessibleName(tr("Studies"));
  this->tree->setHeaderLabels(
    { tr("Patient"), tr("ID"), tr("Date"), tr("Modality"), tr("Images"), tr("Description") });
  this->tree->header()->resizeSection(0, 240);
  this->tree->header()->resizeSection(2, 120);
  this->status->setObjectName("status");
  this->status->setTextFormat(Qt::PlainText);
  this->status->setWordWrap(true);
  this->cancel->setObjectName("cancel");
  this->cancel->setAutoDefault(false);
  auto* const row = new QHBoxLayout;
  row->addWidget(this->status, 1);
  row->addWidget(this->progress);
  row->addWidget(this->cancel);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(this->choice);
  column->addWidget(this->MakeSearch());
  column->addWidget(this->tree, 1);
  column->addLayout(row);
  this->actions = this->MakeButtons();
  column->addWidget(this->actions);
  this->Connect();
  this->ShowRunning(false);
  this->status->setText(this->choice->Chosen()
      ? tr("Search for studies. What you open is deleted at the end, unless you keep it.")
      : tr("Add an archive (PACS) first. Its administrator knows host, port and titles."));
}

void ArchiveWindow::Connect()
{
  connect(this->choice, &ArchiveChoice::Changed, this,
    [this]
    {
      this->password.reset();
      this->Cancel();
      this->tree->clear();
    });
  connect(this->tree, &QTreeWidget::itemExpanded, this, &ArchiveWindow::ListSeries);
  connect(this->cancel, &QPushButton::clicked, this, &ArchiveWindow::Cancel);
  connect(&this->task, &BackgroundTask::RunningChanged, this, &ArchiveWindow::ShowRunning);
  connect(&this->task, &BackgroundTask::Progress, this, &ArchiveWindow::ShowProgress);
  connect(&this->task, &BackgroundTask::Failed, this,
    [this](const QString& reason)
    {
      this->password.reset(); // it may have been wrong
      this->status->setText(reason);
    });
}

QWidget* ArchiveWindow::MakeSearch()
{
  this->patientName->setPlaceholderText(tr("beginning, as DOE"));
  this->dates->setPlaceholderText(tr("20261126, or 20260101-20261231"));
  this->modality->setPlaceholderText(tr("CT, MR …"));
  auto* const search = new QPushButton(tr("Search"));
  search->setObjectName("search");
  search->setDefault(true);
  auto* const fields = new QWidget;
  auto* const grid = new QGridLayout(fields);
  grid->setContentsMargins(0, 0, 0, 0);
  const struct
  {
    QString label;
    QLineEdit* field;
    const char* name;
  } all[] = { { tr("Patient"), this->patientName, "patientName" },
    { tr("ID"), this->patientId, "patientId" }, { tr("Date"), this->dates, "dates" },
    { tr("Modality"), this->modality, "modality" } };
  int column = 0;
  for (const auto& one : all)
  {
    one.field->setObjectName(one.name);
    one.field->setAccessibleName(one.label);
    grid->addWidget(new QLabel(one.label), 0, column);
    grid->addWidget(one.field, 1, column++);
  }
  grid->addWidget(search, 1, column);
  grid->setColumnStretch(0, 2);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 3);
  grid->setColumnStretch(3, 1);
  connect(search, &QPushButton::clicked, this, &ArchiveWindow::Search);
  return fields;
}

QWidget* ArchiveWindow::MakeButtons()
{
  auto* const keep = new QPushButton(tr("Keep in…"));
  keep->setObjectName("keep");
  keep->setToolTip(tr("Fetches the study or the series into a folder of yours, and opens it"));
  auto* const open = new QPushButton(tr("Open"));
  open->setObjectName("open");
  open->setToolTip(tr("Fetches the study or the series, which is deleted at the end"));
  auto* const buttons = new QWidget;
  auto* const row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->addStretch();
  for (QPushButton* const button : { keep, open })
  {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  connect(keep, &QPushButton::clicked, this, &ArchiveWindow::Keep);
  connect(open, &QPushButton::clicked, this, [this] { this->Fetch({}); });
  return buttons;
}

ArchiveQuery ArchiveWindow::Query() const
{
  const auto text = [](const QLineEdit* field) { return field->text().trimmed().toStdString(); };
  return { text(this->patientName), text(this->patientId), text(this->dates),
    text(this->modality) };
}

template <class Work, class Done>
void ArchiveWindow::Start(const QString& activity, Work work, Done done)
{
  const std::optional<NamedArchive> archive = this->choice->Chosen();
  if (!archive)
  {
    return;
  }
  if (!this->password)
  {
    this->password = PasswordOf(*archive, this);
  }
  if (!this->password)
  {
    return;
  }
  this->task.Start([address = archive->address, secret = *this->password, work = std::move(work)](
                     const TaskProgress& goesOn)
    { return work(*ArchiveAt(address, secret), goesOn); },
    std::move(done));
  this->status->setText(activity);
}

void ArchiveWindow::Cancel()
{
  if (this->task.IsRunning())
  {
    this->task.Cancel();
    this->status->setText(tr("It was cancelled"));
  }
}

void ArchiveWindow::Search()
{
  this->tree->clear();
  this->Start(
    tr("Searching…"),
    [query = this->Query()](Archive& archive, const TaskProgress& goesOn)
    { return archive.FindStudies(query, goesOn); },
    [this](const std::vector<ArchiveStudy>& found) { this->ShowStudies(found); });
}

void ArchiveWindow::ShowStudies(const std::vector<ArchiveStudy>& studies)
{
  for (const ArchiveStudy& study : studies)
  {
    this->tree->addTopLevelItem(StudyItem(study));
  }
  this->tree->sortItems(0, Qt::AscendingOrder);
  this->status->setText(tr("Studies: %1").arg(studies.size()) + UnreadableText(studies));
}

// The item may be gone when the answer comes.
void ArchiveWindow::ListSeries(QTreeWidgetItem* study)
{
  if (study->childCount() > 0 || study->data(0, SeriesRole).isValid())
  {
    return;
  }
  if (this->task.IsRunning())
  {
    study->setExpanded(false); // a look at a study ends no transfer
    return;
  }
  const QString uid = study->data(0, StudyRole).toString();
  this->Start(
    tr("Searching…"),
    [uid = uid.toStdString()](Archive& archive, const TaskProgress& goesOn)
    { return archive.FindSeries(uid, goesOn); },
    [this, uid](const std::vector<ArchiveSeries>& found)
    {
      for (int i = 0; i < this->tree->topLevelItemCount(); ++i)
      {
        QTreeWidgetItem* const item = this->tree->topLevelItem(i);
        for (const ArchiveSeries& series : found)
        {
          if (item->data(0, StudyRole) == uid)
          {
            item->addChild(SeriesItem(*item, series));
          }
        }
      }
      this->status->setText(tr("Series: %1").arg(found.size()) + UnreadableText(found));
    });
}

void ArchiveWindow::Keep()
{
  const QString folder = this->tree->currentItem()
    ? QFileDialog::getExistingDirectory(this, tr("Keep the scan in a folder"))
    : QString();
  if (!folder.isEmpty())
  {
    this->Fetch(folder);
  }
}

void ArchiveWindow::Fetch(const QString& users)
{
  const QTreeWidgetItem* const item = this->tree->currentItem();
  if (!item)
  {
    this->status->setText(tr("Choose a study or a series first."));
    return;
  }
  this->Start(
    tr("Fetching…"),
    [study = item->data(0, StudyRole).toString().toStdString(),
      series = item->data(0, SeriesRole).toString().toStdString(),
      date = item->data(0, DateRole).toString(),
      users](Archive& archive, const TaskProgress& goesOn)
    {
      FetchPlace place = MakePlace(users, date);
      FetchInto(place, archive, study, series, goesOn);
      return place;
    },
    [this](const FetchPlace& place)
    {
      this->status->setText(tr("Fetched"));
      emit this->Fetched(place.folder, place.temporary);
    });
}

void ArchiveWindow::ShowRunning(bool isRunning)
{
  this->progress->setVisible(isRunning);
  this->cancel->setVisible(isRunning);
  this->actions->setEnabled(!isRunning);
  this->ShowProgress(-1.0);
}

void ArchiveWindow::ShowProgress(double part)
{
  this->progress->setRange(0, part < 0.0 ? 0 : 100);
  this->progress->setValue(int(100.0 * part));
}

}
