#include "Viewer/MainWindow.h"

#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Viewer/Panels/CutsPanel.h"
#include "Viewer/Panels/LookPanel.h"
#include "Viewer/Panels/QualityPanel.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/PictureExport.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/VolumeView.h"

#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSplitter>
#include <QStandardPaths>
#include <QStatusBar>
#include <QUrl>

#include <vtkVolumeFileReader.h>

namespace varimarch
{

namespace
{

// "Volumes (*.nrrd *.nhdr ...)", then a line for each format, for a file dialog.
QString FileFilter()
{
  QStringList all;
  QStringList formats;
  for (int format = 0; format < vtkVolumeFileReader::GetNumberOfFormats(); ++format)
  {
    const QStringList extensions =
      QString::fromStdString(vtkVolumeFileReader::GetFormatExtensions(format))
        .split(' ', Qt::SkipEmptyParts)
        .replaceInStrings(QRegularExpression("^"), "*");
    all += extensions;
    formats += QStringLiteral("%1 (%2)").arg(
      vtkVolumeFileReader::GetFormatDescription(format), extensions.join(' '));
  }
  formats.prepend(MainWindow::tr("Volumes (%1)").arg(all.join(' ')));
  formats.append(MainWindow::tr("All files (*)"));
  return formats.join(";;");
}

}

MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , autosave(&this->model,
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosaved.json")
  , view(new ComparisonView(&this->model))
{
  this->setWindowTitle(tr("Varimarch, not for diagnostic use"));
  this->setCentralWidget(this->MakeViews());
  this->setAcceptDrops(true);
  this->resize(1280, 800);
  this->MakeMenus();
  this->MakeViewMenu();
  this->MakeToolMenu();
  this->MakeHelpMenu();
  this->MakePanels();
  this->MakeStatusBar();
  connect(&this->loader, &VolumeLoader::Loaded, this, &MainWindow::ShowLoaded);
  connect(&this->loader, &VolumeLoader::Failed, this, &MainWindow::ShowFailure);
  connect(&this->loader, &VolumeLoader::Cancelled, this,
    [this]
    {
      this->ShowLoading(false);
      this->statusBar()->showMessage(tr("Loading was cancelled"));
    });
}

QWidget* MainWindow::MakeViews()
{
  this->slices = new QSplitter(Qt::Vertical);
  for (const SlicePlane plane : { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    this->slices->addWidget(new SliceView(&this->model, plane));
  }
  auto* const all = new QSplitter(Qt::Horizontal);
  all->addWidget(this->view);
  all->addWidget(this->slices);
  all->setSizes({ 720, 280 });
  all->setStretchFactor(0, 3);
  all->setStretchFactor(1, 1);
  return all;
}

void MainWindow::MakeMenus()
{
  QMenu* const file = this->menuBar()->addMenu(tr("&File"));
  file->addAction(tr("&Open…"), this, &MainWindow::ChooseFile, QKeySequence::Open);
  file->addAction(
    tr("Open a &folder…"), this, &MainWindow::ChooseFolder, QKeySequence("Ctrl+Shift+O"));
  file->addAction(tr("&Save the session…"), this, &MainWindow::SaveSession, QKeySequence::Save);
  file->addSeparator();
  file->addAction(
    tr("Export a &picture…"), this, &MainWindow::ExportPicture, QKeySequence("Ctrl+E"));
  file->addSeparator();
  file->addAction(tr("&Quit"), this, &QWidget::close, QKeySequence::Quit);

  QMenu* const edit = this->menuBar()->addMenu(tr("&Edit"));
  QAction* const undo = this->model.History()->createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* const redo = this->model.History()->createRedoAction(this, tr("&Redo"));
  redo->setShortcut(QKeySequence::Redo);
  edit->addActions({ undo, redo });
  edit->addSeparator();
  edit->addAction(
    tr("&First look again"), this,
    [this]
    {
      if (const auto study = this->model.CurrentStudy())
      {
        this->model.SetLook(Preset(SuggestedPreset(study->volume).name), tr("first look"));
      }
    },
    QKeySequence("R"));
}

void MainWindow::MakeViewMenu()
{
  QMenu* const menu = this->menuBar()->addMenu(tr("&View"));
  // The keys of the keypad, as other viewers have them.
  const std::tuple<View, QString, QString> views[] = {
    { View::Anterior, tr("&Anterior"), "1" },
    { View::Posterior, tr("&Posterior"), "Shift+1" },
    { View::Left, tr("&Left"), "3" },
    { View::Right, tr("&Right"), "Shift+3" },
    { View::Superior, tr("&Superior"), "7" },
    { View::Inferior, tr("&Inferior"), "Shift+7" },
  };
  for (const auto& [direction, name, key] : views)
  {
    menu->addAction(
      name, this,
      [this, direction = direction]
      {
        if (this->model.CurrentStudy())
        {
          this->model.Edit(ScenePart::Camera, tr("standard view"),
            [direction](Scene& scene)
            {
              scene.camera.view = direction;
              scene.camera.pose.reset();
            });
        }
      },
      QKeySequence(key));
  }
}

void MainWindow::MakeToolMenu()
{
  QMenu* const menu = this->menuBar()->addMenu(tr("&Tools"));
  QAction* const measure = menu->addAction(tr("&Measure a distance"));
  measure->setCheckable(true);
  measure->setShortcut(QKeySequence("M"));
  measure->setStatusTip(tr("Drag from one point to another"));
  connect(measure, &QAction::toggled, this->view->Ours(), &VolumeView::SetMeasuring);
  menu->addAction(tr("&Remove all distances"), this,
    [this]
    {
      this->model.Edit(ScenePart::Distances, tr("remove the distances"),
        [](Scene& scene) { scene.distances.clear(); });
    });
  menu->addSeparator();
  auto* const comparisons = new QActionGroup(this);
  const std::tuple<QString, std::optional<MapperKind>> kinds[] = {
    { tr("&No comparison"), std::nullopt },
    { tr("Compare with VTK's &GPU mapper"), MapperKind::VtkGpu },
    { tr("Compare with VTK's &CPU mapper"), MapperKind::VtkCpu },
  };
  for (const auto& [name, kind] : kinds)
  {
    QAction* const action = comparisons->addAction(menu->addAction(name));
    action->setCheckable(true);
    action->setChecked(!kind);
    connect(action, &QAction::triggered, this, [this, kind = kind] { this->Compare(kind); });
  }
}

void MainWindow::Compare(std::optional<MapperKind> kind)
{
  this->view->CompareWith(kind);
  // Three pictures side by side want the room.
  this->slices->setVisible(!kind);
}

void MainWindow::MakeHelpMenu()
{
  QMenu* const menu = this->menuBar()->addMenu(tr("&Help"));
  menu->addAction(tr("&About Varimarch"), this, &MainWindow::ShowAbout);
}

void MainWindow::MakePanels()
{
  const std::tuple<QString, QString, QWidget*> panels[] = {
    { "look", tr("Look"), new LookPanel(&this->model) },
    { "cuts", tr("Cut away"), new CutsPanel(&this->model) },
    { "quality", tr("Quality"), new QualityPanel(&this->model) },
  };
  for (const auto& [name, title, panel] : panels)
  {
    auto* const dock = new QDockWidget(title);
    dock->setObjectName(name);
    dock->setWidget(panel);
    this->addDockWidget(Qt::RightDockWidgetArea, dock);
  }
}

void MainWindow::MakeStatusBar()
{
  this->progress = new QProgressBar;
  this->progress->setRange(0, 100);
  this->cancel = new QPushButton(tr("Cancel"));
  this->statusBar()->addPermanentWidget(this->progress);
  this->statusBar()->addPermanentWidget(this->cancel);
  this->ShowLoading(false);
  this->statusBar()->showMessage(tr("Open a scan, or drop one here"));
  connect(this->view->Ours(), &VolumeView::Pointed, this->statusBar(),
    [this](const QString& text) { this->statusBar()->showMessage(text); });
  connect(this->cancel, &QPushButton::clicked, &this->loader, &VolumeLoader::Cancel);
  connect(&this->loader, &VolumeLoader::Progress, this->progress,
    [this](double part) { this->progress->setValue(int(100.0 * part)); });
}

void MainWindow::Open(const QString& path)
{
  this->restored.reset();
  if (QFileInfo(path).suffix() != "json")
  {
    this->Load(FileSource{ path.toStdString(), std::nullopt });
    return;
  }
  try
  {
    this->restored = ReadScene(path.toStdString());
    this->Load(this->restored->volume);
  }
  catch (const std::exception& problem)
  {
    this->ShowFailure(QString::fromStdString(problem.what()));
  }
}

void MainWindow::Load(const VolumeSource& source)
{
  this->ShowLoading(true);
  const auto* const file = std::get_if<FileSource>(&source);
  const QString name = file ? QFileInfo(QString::fromStdString(file->path)).fileName() : QString();
  this->statusBar()->showMessage(tr("Loading %1").arg(name));
  this->loader.Load(source);
}

void MainWindow::SaveSession()
{
  if (!this->model.CurrentStudy())
  {
    return;
  }
  const QString path = QFileDialog::getSaveFileName(
    this, tr("Save the session"), "session.json", tr("Sessions (*.json)"));
  if (path.isEmpty())
  {
    return;
  }
  try
  {
    WriteScene(this->model.CurrentScene(), path);
    this->statusBar()->showMessage(tr("Saved %1").arg(path));
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this, tr("Cannot save"), QString::fromStdString(problem.what()));
  }
}

void MainWindow::OfferAutosaved()
{
  if (this->autosave.HasCopy() &&
    QMessageBox::question(this, tr("Varimarch"),
      tr("The last time, the program did not come to its end. Go on where you were?")) ==
      QMessageBox::Yes)
  {
    this->Open(this->autosave.Path());
  }
}

void MainWindow::ShowAbout()
{
  QMessageBox::about(this, tr("About Varimarch"),
    tr("<b>Varimarch %1</b><p>Looks into CT and MR volumes, with an error that is promised.</p>"
       "<p><b>Not for diagnostic use.</b> This program is not a medical device.</p>")
      .arg(QCoreApplication::applicationVersion()));
}

void MainWindow::ChooseFile()
{
  const QString path = QFileDialog::getOpenFileName(this, tr("Open a volume"), {}, FileFilter());
  if (!path.isEmpty())
  {
    this->Open(path);
  }
}

void MainWindow::ChooseFolder()
{
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open a folder of DICOM files"));
  if (!path.isEmpty())
  {
    this->Open(path);
  }
}

void MainWindow::ExportPicture()
{
  if (this->model.CurrentStudy())
  {
    ExportDialog dialog(&this->model, this->view->Ours()->size(), this);
    dialog.exec();
  }
}

void MainWindow::ShowLoaded(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  this->ShowLoading(false);
  if (this->restored)
  {
    this->model.Restore(*this->restored, study);
    this->restored.reset();
  }
  else
  {
    this->model.Open(source, study);
  }
  QStringList messages;
  for (const std::string& warning : study->volume.warnings)
  {
    messages.append(QString::fromStdString(warning));
  }
  messages.append(tr("Look \"%1\": %2. R brings it back.")
                    .arg(QString::fromStdString(this->model.CurrentScene().look.name),
                      QString::fromStdString(SuggestedPreset(study->volume).reason)));
  this->statusBar()->showMessage(messages.join(' '));
}

void MainWindow::ShowFailure(const QString& reason)
{
  this->ShowLoading(false);
  this->statusBar()->showMessage(reason);
  auto* const box =
    new QMessageBox(QMessageBox::Warning, tr("Cannot open"), reason, QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::ShowLoading(bool loading)
{
  this->progress->setVisible(loading);
  this->progress->setValue(0);
  this->cancel->setVisible(loading);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile())
  {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event)
{
  this->Open(event->mimeData()->urls().first().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  this->loader.Cancel();
  this->autosave.Remove();
  QMainWindow::closeEvent(event);
}

}
