// The part of MainWindow that shows the attributes of the scan, and lists of other scans.

#include "Viewer/MainWindow.h"

#include "Readers/PrivateFolder.h"
#include "Viewer/Archives/ArchiveWindow.h"
#include "Viewer/Archives/SendDialog.h"
#include "Viewer/Open/TagsWindow.h"
#include "Viewer/Studies/StudyListWindow.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/VolumeView.h"

#include <QMenu>
#include <QStandardPaths>

#include <algorithm>

namespace varimarch
{

void MainWindow::MakeArchiveActions(QMenu* menu)
{
  menu->addAction(tr("St&udy list…"), this, &MainWindow::ShowStudies, QKeySequence("Ctrl+L"))
    ->setObjectName("showStudies");
  menu->addAction(tr("Arc&hive (PACS)…"), this, &MainWindow::ShowArchive)
    ->setObjectName("showArchive");
  QAction* const tags =
    menu->addAction(tr("DICOM attri&butes…"), this, &MainWindow::ShowTags, QKeySequence("Ctrl+T"));
  tags->setObjectName("showTags");
  tags->setEnabled(false);
  connect(&this->model, &SceneModel::Changed, tags,
    [this, tags]
    { tags->setEnabled(std::holds_alternative<FileSource>(this->model.CurrentScene().volume)); });
}

void MainWindow::ShowStudies()
{
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  auto* const list = new StudyListWindow(folder + "/studies.sqlite", this);
  connect(list, &StudyListWindow::SeriesWanted, this, &MainWindow::Open);
  list->show();
}

void MainWindow::ShowArchive()
{
  auto* const archive = new ArchiveWindow(this);
  connect(archive, &ArchiveWindow::Fetched, this, &MainWindow::OpenFetched);
  archive->show();
}

void MainWindow::OpenFetched(
  const QString& folder, const std::shared_ptr<const PrivateFolder>& temporary)
{
  if (temporary)
  {
    this->fetched.push_back(temporary);
  }
  this->Open(folder);
}

void MainWindow::SendPicture()
{
  if (this->model.CurrentStudy())
  {
    (new SendDialog(&this->model, this->view->Ours()->size(), this))->show();
  }
}

bool MainWindow::IsTemporary(const std::string& path) const
{
  return std::any_of(this->fetched.begin(), this->fetched.end(),
    [&](const std::shared_ptr<const PrivateFolder>& folder)
    { return path.rfind(folder->Path().string(), 0) == 0; });
}

void MainWindow::ShowTags()
{
  (new TagsWindow(std::get<FileSource>(this->model.CurrentScene().volume), this))->show();
}

// A scan of an archive is gone at the end, so it is no recent one.
void MainWindow::KeepInMind(const FileSource& file, const Study& study)
{
  if (!this->IsTemporary(file.path))
  {
    this->recentScans.Add(file, study);
  }
  this->OfferSegmentations(file);
}

}
