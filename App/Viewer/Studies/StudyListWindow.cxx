#include "Viewer/Studies/StudyListWindow.h"

#include "Readers/VolumeFile.h"
#include "Viewer/Model/RecentScans.h"
#include "Viewer/Studies/StudyTree.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <exception>

namespace varimarch
{

namespace
{

// Data of the items of series.
constexpr int PathRole = Qt::UserRole;
constexpr int SeriesRole = Qt::UserRole + 1;

QString TextOr(const QString& text, const QString& otherwise)
{
  return text.trimmed().isEmpty() ? otherwise : text;
}

QStringList PatientColumns(const IndexedSeries& series)
{
  return { TextOr(PersonText(series.patientName), StudyListWindow::tr("No name")),
    series.patientId };
}

QStringList StudyColumns(const IndexedSeries& series)
{
  return { TextOr(series.studyDescription, StudyListWindow::tr("Study without description")), {},
    DateText(series.studyDate) };
}

QTreeWidgetItem* SeriesItem(const IndexedSeries& series)
{
  auto* const item = new QTreeWidgetItem(
    { TextOr(series.seriesDescription, StudyListWindow::tr("Series %1").arg(series.seriesNumber)),
      {}, {}, series.modality, QString::number(series.imageCount) });
  item->setData(0, PathRole, series.path);
  item->setData(0, SeriesRole, DigestOfSeries(series.seriesUid.toStdString()));
  item->setToolTip(0, series.path);
  return item;
}

// Adds items for all series, which are sorted by patient and study.
void Fill(QTreeWidget* tree, const QVector<IndexedSeries>& all)
{
  tree->clear();
  QTreeWidgetItem* patient = nullptr;
  QTreeWidgetItem* study = nullptr;
  const IndexedSeries* last = nullptr;
  for (const IndexedSeries& series : all)
  {
    const bool isSamePatient =
      last && last->patientName == series.patientName && last->patientId == series.patientId;
    if (!isSamePatient)
    {
      patient = new QTreeWidgetItem(tree, PatientColumns(series));
    }
    if (!isSamePatient || last->studyUid != series.studyUid)
    {
      study = new QTreeWidgetItem(patient, StudyColumns(series));
    }
    study->addChild(SeriesItem(series));
    last = &series;
  }
  tree->expandAll();
}

}

StudyListWindow::StudyListWindow(const QString& file, QWidget* parent)
  : QDialog(parent)
  , index(file)
  , search(new QLineEdit)
  , tree(new QTreeWidget)
  , status(new QLabel)
  , progress(new QProgressBar)
  , cancel(new QPushButton(tr("Cancel")))
  , forget(new QMenu(this))
{
  this->setObjectName("studyList");
  this->setWindowTitle(tr("Study list"));
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->resize(820, 560);
  this->search->setPlaceholderText(tr("Search for names, numbers, dates and descriptions"));
  this->search->setAccessibleName(tr("Search"));
  this->search->setClearButtonEnabled(true);
  this->tree->setAccessibleName(tr("Studies"));
  this->tree->setHeaderLabels(
    { tr("Patient, study, series"), tr("ID"), tr("Date"), tr("Modality"), tr("Images") });
  this->tree->header()->resizeSection(0, 360);
  this->tree->header()->resizeSection(2, 120);
  this->tree->setUniformRowHeights(true);
  this->status->setTextFormat(Qt::PlainText);
  this->status->setWordWrap(true);
  this->progress->setRange(0, 100);
  this->cancel->setObjectName("cancel");
  auto* const row = new QHBoxLayout;
  row->addWidget(this->status, 1);
  row->addWidget(this->progress);
  row->addWidget(this->cancel);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(this->search);
  column->addWidget(this->tree, 1);
  column->addLayout(row);
  column->addWidget(this->MakeButtons());
  this->Connect();
  this->Show();
}

void StudyListWindow::Connect()
{
  connect(this->search, &QLineEdit::textChanged, this->tree,
    [this](const QString& words) { ShowMatching(this->tree, words); });
  connect(this->tree, &QTreeWidget::itemActivated, this, &StudyListWindow::OpenItem);
  connect(this->cancel, &QPushButton::clicked, this,
    [this]
    {
      this->task.Cancel();
      this->Show();
    });
  connect(&this->task, &BackgroundTask::RunningChanged, this, &StudyListWindow::ShowState);
  connect(&this->task, &BackgroundTask::Progress, this->progress,
    [this](double part) { this->progress->setValue(int(100.0 * part)); });
  connect(&this->task, &BackgroundTask::Failed, this,
    [this](const QString& reason)
    {
      this->Show();
      this->status->setText(reason);
    });
}

QWidget* StudyListWindow::MakeButtons()
{
  auto* const add = new QPushButton(tr("Add a folder…"));
  auto* const update = new QPushButton(tr("Find changes"));
  update->setObjectName("update");
  update->setToolTip(tr("Reads files of the folders that are new or have changed"));
  auto* const remove = new QPushButton(tr("Remove a folder"));
  remove->setMenu(this->forget);
  auto* const removeAll = new QPushButton(tr("Remove the whole list"));
  removeAll->setObjectName("removeAll");
  removeAll->setToolTip(tr("Deletes all that the list knows of patients; scans stay"));
  auto* const open = new QPushButton(tr("Open"));
  open->setObjectName("open");
  for (QPushButton* const button : { add, update, remove, removeAll, open })
  {
    button->setAutoDefault(false);
  }
  auto* const buttons = new QWidget;
  auto* const row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(add);
  row->addWidget(update);
  row->addWidget(remove);
  row->addWidget(removeAll);
  row->addStretch();
  row->addWidget(open);
  connect(add, &QPushButton::clicked, this, &StudyListWindow::AddFolder);
  connect(update, &QPushButton::clicked, this, &StudyListWindow::FindChanges);
  connect(this->forget, &QMenu::aboutToShow, this, &StudyListWindow::ListFolders);
  connect(removeAll, &QPushButton::clicked, this, &StudyListWindow::RemoveAll);
  connect(open, &QPushButton::clicked, this, [this] { this->OpenItem(this->tree->currentItem()); });
  return buttons;
}

void StudyListWindow::Try(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const std::exception& problem)
  {
    this->status->setText(QString::fromStdString(problem.what()));
  }
}

void StudyListWindow::Change(const std::function<void()>& change)
{
  this->Try(
    [&]
    {
      change();
      this->Show();
    });
}

void StudyListWindow::Show()
{
  this->Try(
    [this]
    {
      const QVector<IndexedSeries> all = this->index.Series();
      this->seriesCount = all.size();
      Fill(this->tree, all);
      ShowMatching(this->tree, this->search->text());
      this->ShowState();
    });
}

void StudyListWindow::ShowState()
{
  const bool isRunning = this->task.IsRunning();
  this->progress->setVisible(isRunning);
  this->cancel->setVisible(isRunning);
  this->status->setText(isRunning ? tr("Reading the folders…")
      : this->seriesCount == 0
      ? tr("Add a folder with DICOM files. The list stays on this computer and is yours only.")
      : tr("Series: %1. A double-click opens one.").arg(this->seriesCount));
}

void StudyListWindow::AddFolder()
{
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Add a folder"));
  if (!folder.isEmpty())
  {
    this->Read({ folder });
  }
}

void StudyListWindow::FindChanges()
{
  this->Try([this] { this->Read(this->index.Folders()); });
}

void StudyListWindow::Read(const QStringList& folders)
{
  this->progress->setValue(0);
  this->task.Start(
    [index = this->index, folders](const TaskProgress& goesOn)
    {
      ReadProgress progress(goesOn);
      for (int i = 0; i < folders.size(); ++i)
      {
        ReadProgress part =
          progress.Part(double(i) / folders.size(), double(i + 1) / folders.size());
        index.Update(folders[i],
          [&](double done)
          {
            part.Report(done);
            return true;
          });
      }
    },
    [this] { this->Show(); });
}

void StudyListWindow::ListFolders()
{
  this->forget->clear();
  this->Try(
    [this]
    {
      for (const QString& folder : this->index.Folders())
      {
        this->forget->addAction(folder, this,
          [this, folder]
          {
            this->task.Cancel();
            this->Change([&] { this->index.Forget(folder); });
          });
      }
    });
}

void StudyListWindow::RemoveAll()
{
  const auto answer = QMessageBox::question(this, tr("Remove the whole list"),
    tr("Delete all that the list knows of folders and patients? The scans themselves stay."));
  if (answer == QMessageBox::Yes)
  {
    this->task.Cancel();
    this->Change([this] { this->index.RemoveAll(); });
  }
}

void StudyListWindow::OpenItem(QTreeWidgetItem* item)
{
  if (item && item->data(0, PathRole).isValid())
  {
    emit this->SeriesWanted(
      item->data(0, PathRole).toString(), item->data(0, SeriesRole).toString());
  }
}

}
