#include "Viewer/ScanLists.h"

#include "Readers/Packed/PrivateFolder.h"
#include "Viewer/Archives/ArchiveWindow.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Open/TagsWindow.h"
#include "Viewer/Studies/StudyListWindow.h"

#include <QMainWindow>
#include <QMenu>
#include <QStandardPaths>

#include <algorithm>

namespace varimarch
{

ScanLists::ScanLists(SceneModel* model, QMainWindow* window)
  : QObject(window)
  , model(model)
  , window(window)
{
}

void ScanLists::AddRecentScansTo(QMenu* menu)
{
  QMenu* const recent = menu->addMenu(tr("&Recent scans"));
  recent->setObjectName("recent");
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { this->ListRecentScans(recent); });
}

void ScanLists::ListRecentScans(QMenu* menu)
{
  menu->clear();
  for (const RecentScan& scan : this->recentScans.List())
  {
    menu->addAction(scan.Title() + ", " + scan.Opened(), this,
      [this, scan] { emit this->ScanWanted(scan.path, scan.series); });
  }
  menu->addSeparator();
  menu->addAction(tr("Clear the list"), this, [this] { this->recentScans.Clear(); });
}

void ScanLists::AddListsTo(QMenu* menu)
{
  menu->addAction(tr("St&udy list…"), this, &ScanLists::ShowStudies, QKeySequence("Ctrl+L"))
    ->setObjectName("showStudies");
  menu->addAction(tr("Arc&hive (PACS)…"), this, &ScanLists::ShowArchive)
    ->setObjectName("showArchive");
  QAction* const tags =
    menu->addAction(tr("DICOM attri&butes…"), this, &ScanLists::ShowTags, QKeySequence("Ctrl+T"));
  tags->setObjectName("showTags");
  tags->setEnabled(false);
  connect(this->model, &SceneModel::Changed, tags,
    [this, tags]
    { tags->setEnabled(std::holds_alternative<FileSource>(this->model->CurrentScene().volume)); });
}

void ScanLists::ShowStudies()
{
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  auto* const list = new StudyListWindow(folder + "/studies.sqlite", this->window);
  connect(list, &StudyListWindow::SeriesWanted, this, &ScanLists::ScanWanted);
  list->show();
}

void ScanLists::ShowArchive()
{
  auto* const archive = new ArchiveWindow(this->window);
  connect(archive, &ArchiveWindow::Fetched, this,
    [this](const QString& folder, const std::shared_ptr<const PrivateFolder>& temporary)
    {
      if (temporary)
      {
        this->fetched.push_back(temporary);
      }
      emit this->ScanWanted(folder, {});
    });
  archive->show();
}

void ScanLists::ShowTags()
{
  (new TagsWindow(std::get<FileSource>(this->model->CurrentScene().volume), this->window))->show();
}

// A scan of an archive is gone at the end, so it is no recent one.
void ScanLists::Remember(const FileSource& file, const Study& study)
{
  if (!this->IsTemporary(file.path))
  {
    this->recentScans.Add(file, study);
  }
}

bool ScanLists::IsTemporary(const std::string& path) const
{
  return std::any_of(this->fetched.begin(), this->fetched.end(),
    [&](const std::shared_ptr<const PrivateFolder>& folder)
    { return path.rfind(folder->Path().string(), 0) == 0; });
}

}
