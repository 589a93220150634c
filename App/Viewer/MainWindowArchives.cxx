// The part of MainWindow that shows the attributes of the scan, and lists of other scans.

#include "Viewer/MainWindow.h"

#include "Viewer/Open/TagsWindow.h"
#include "Viewer/Studies/StudyListWindow.h"

#include <QMenu>
#include <QStandardPaths>

namespace varimarch
{

void MainWindow::MakeArchiveActions(QMenu* menu)
{
  menu->addAction(tr("St&udy list…"), this, &MainWindow::ShowStudies, QKeySequence("Ctrl+L"))
    ->setObjectName("showStudies");
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

void MainWindow::ShowTags()
{
  (new TagsWindow(std::get<FileSource>(this->model.CurrentScene().volume), this))->show();
}

}
