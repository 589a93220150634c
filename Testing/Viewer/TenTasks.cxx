// Does the tasks of Documentation/TenTasks.md in the real window, and counts the clicks.
//
// Usage: ViewerTasks FOLDER [--language CODE] [--theme light|dark|contrast] [--head FILE]
//   [--task NAME] [--table TenTasks.md]
// on a display that the window fills. Writes a picture of the window after each task into the
// folder; with a table, fails instead if its rows have other numbers.

#include "FakeWebArchive.h"
#include "LeaksOfOthers.h"
#include "PrivateSettings.h"
#include "TaskHand.h"
#include "TaskScans.h"
#include "Viewer/Archives/ArchiveChoice.h"
#include "Viewer/Archives/SendDialog.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Model/Language.h"
#include "Viewer/Model/OwnPresets.h"
#include "Viewer/Open/StartPage.h"
#include "Viewer/Panels/PresetGallery.h"
#include "Viewer/Theme.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/SliceView.h"
#include "Viewer/View/VolumeView.h"

#include <QApplication>
#include <QCheckBox>
#include <QCommandLineParser>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTest>
#include <QToolBar>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <utility>

using namespace varimarch;

namespace
{

class Tasks
{
public:
  /// @param head           a CT of a head for the task of the face; empty: the chest
  /// @param takesPictures  of the window, for which each task waits
  Tasks(const QString& folder, const QString& head, bool takesPictures)
    : folder(folder)
    , head(head)
    , takesPictures(takesPictures)
  {
    KeepAsHospital(this->server.Url());
    this->server.Answer("/studies", "application/dicom+json", "{}");
  }

  const std::vector<Effort>& Efforts() const { return this->efforts; }

  void OpenCd()
  {
    this->MakeWindow();
    this->hand.ExpectFile(QString::fromStdString(this->scans.Ct()));
    this->hand.Click(this->window->findChild<StartPage*>()->findChildren<QAbstractButton*>().at(1));
    this->AwaitScan();
    this->Finish("open-cd", "Open a CD");
  }

  void FindAneurysm()
  {
    this->Begin(this->scans.Ct());
    this->ClickPreset("ct-vessels");
    VolumeView* const view = this->View();
    const QPoint middle = view->rect().center();
    this->hand.Drag(view, middle, middle + QPoint(view->width() / 5, 0));
    this->ClickTool(3); // Distance
    this->hand.Drag(view, middle - QPoint(20, 10), middle + QPoint(30, 20));
    Await([&] { return this->Model()->CurrentScene().measures.size() == 1; },
      "the width is not measured");
    this->Finish("aneurysm", "Find an aneurysm");
  }

  void MeasureUptake()
  {
    this->Begin(this->scans.Ct());
    this->AddScan(this->scans.Pet());
    this->ClickTool(5); // Box
    SliceView* const slice = this->SliceAt(SlicePlane::Axial, TaskScans::Nodule());
    const QPoint there = PlaceOf(*slice, TaskScans::Nodule());
    this->hand.Drag(slice, there - QPoint(12, 12), there + QPoint(12, 12));
    Await([&] { return this->Model()->Texts().values.join("").contains(" SUV"); },
      "the uptake is not measured");
    this->Finish("pet", "PET hot spot with SUV");
  }

  void MeasureNodule()
  {
    this->Begin(this->scans.Ct());
    SliceView* const slice = this->SliceAt(SlicePlane::Axial, TaskScans::Nodule());
    this->hand.RaisePanel(this->window.get(), "segments");
    this->Press("newSegment");
    this->Press("toolRegion");
    this->hand.Type(this->Reachable<QWidget>("smallestValue"), "-400");
    this->hand.Click(slice, PlaceOf(*slice, TaskScans::Nodule()));
    const auto ml = [this] // a ball with a radius of 9 mm has 3.05 ml
    {
      const auto& statistics = this->Model()->CurrentStudy()->segmentStatistics;
      return statistics.empty() ? 0.0 : statistics.front().volumeMm3 / 1000.0;
    };
    Await([&] { return ml() > 2.4 && ml() < 3.8; }, "the nodule has not its volume");
    this->Finish("nodule", "Lung nodule volume");
  }

  void ShowBoneWithoutTable()
  {
    this->Begin(this->scans.Ct());
    this->ClickPreset("ct-bone");
    this->hand.RaisePanel(this->window.get(), "cuts");
    this->hand.Click(this->Reachable<QWidget>("bodyOnly"), { 8, 8 });
    Await([&] { return this->Model()->CurrentScene().cuts.bodyOnly; }, "the table stays");
    this->Finish("bone", "Bone without table");
  }

  void StraightenVessel()
  {
    this->Begin(this->scans.Ct());
    const std::vector<glm::dvec3> aorta = TaskScans::Aorta();
    SliceView* const slice = this->SliceAt(SlicePlane::Coronal, aorta.front());
    this->hand.PressKey(this->window.get(), Qt::Key_U); // Curve
    for (const glm::dvec3& place : aorta)
    {
      this->hand.Click(slice, PlaceOf(*slice, place));
      QTest::qWait(100); // the first curve makes room for the view along it
    }
    Await([&] { return this->window->findChild<QDockWidget*>("curve")->isVisible(); },
      "the view along the curve does not open");
    this->Finish("curved", "Vessel curved reformat");
  }

  void CompareTimes()
  {
    this->Begin(this->scans.Ct());
    this->SliceAt(SlicePlane::Axial, TaskScans::Nodule());
    this->AddScan(this->scans.LaterCt());
    this->hand.Click(this->window->findChild<QCheckBox*>("checkerboard"), { 8, 8 });
    Await([&] { return this->Model()->CurrentScene().slices.fusion == SliceFusion::Checkerboard; },
      "the times are not beside each other");
    this->Finish("two-times", "Compare two times");
  }

  void SendToPacs()
  {
    this->Begin(this->scans.Ct());
    this->hand.ChooseFromMenu(this->window->findChild<QAction*>("sendImage"));
    auto* const dialog = this->window->findChild<SendDialog*>();
    this->hand.Click(dialog->findChild<QCheckBox*>("identity"), { 8, 8 });
    this->hand.Click(dialog->findChild<QPushButton*>("sendImage"));
    Await([&] { return this->server.lastBody.contains("DICM"); }, "the archive got nothing");
    const auto* const status = dialog->findChild<QLabel*>("status");
    Await([&] { return status->text() == SendDialog::tr("The archive has stored the image."); },
      "the image is not stored");
    this->Take("send-dialog", dialog);
    this->Finish("send", "Send to PACS");
  }

  void ExportWithoutFace()
  {
    this->Begin(this->head.isEmpty() ? this->scans.Ct() : this->head.toStdString());
    this->hand.RaisePanel(this->window.get(), "cuts");
    this->hand.Click(this->Reachable<QWidget>("noFace"), { 8, 8 });
    Await([&] { return this->Model()->CurrentScene().cuts.faceDepthMm > 0.0; }, "the face stays");
    const QString path = this->folder + "/face-export.png";
    QFile::remove(path);
    this->hand.Expect(
      [this, path](QWidget* dialog)
      {
        this->Take("export-dialog", dialog);
        this->hand.ExpectNameToSave(path);
        this->hand.Click(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save));
      });
    this->hand.ChooseFromMenu(this->window->findChild<QAction*>("exportImage"));
    Await([&] { return QFile::exists(path); }, "the image is not saved");
    this->Finish("face", "De-faced picture");
  }

  void WriteReport()
  {
    this->Begin(this->scans.Ct());
    const QString path = this->folder + "/report.pdf";
    QFile::remove(path);
    this->hand.ExpectNameToSave(path);
    this->hand.ChooseFromMenu(this->window->findChild<QAction*>("exportReport"));
    Await([&] { return QFile::exists(path); }, "the report is not saved");
    this->Finish("report", "Report");
  }

private:
  SceneModel* Model() { return this->window->Model(); }
  VolumeView* View() { return this->window->CentralView()->Ours(); }

  void MakeWindow()
  {
    this->window = std::make_unique<MainWindow>();
    this->window->setGeometry(QApplication::primaryScreen()->availableGeometry());
    this->window->show();
    this->hand.Rest();
  }

  void AwaitScan()
  {
    Await([this] { return this->Model()->CurrentStudy() != nullptr; }, "the scan is not opened");
    QTest::qWait(200);
  }

  // A window with the scan, before the hand is counted.
  void Begin(const std::string& scan)
  {
    this->MakeWindow();
    this->window->Open(QString::fromStdString(scan));
    this->AwaitScan();
    this->hand.Rest();
  }

  void ClickPreset(const std::string& name)
  {
    auto* const list = this->window->findChild<PresetGallery*>()->findChild<QListWidget*>();
    QListWidgetItem* const item = list->findItems(PresetTitle(name), Qt::MatchExactly).value(0);
    list->scrollToItem(item);
    this->hand.Click(list->viewport(), list->visualItemRect(item).center());
    Await([&] { return this->Model()->CurrentScene().look.name == name; }, "no look is chosen");
  }

  /// Clicks a tool of the tool bar.
  /// @param number  counted from 0
  void ClickTool(int number)
  {
    auto* const bar = this->window->findChild<QToolBar*>("leftButton");
    this->hand.Click(bar->widgetForAction(bar->actions().at(number)));
  }

  /// A widget of a panel, which is scrolled to it.
  template <class Kind>
  Kind* Reachable(const char* name)
  {
    auto* const found = this->window->findChild<Kind*>(name);
    for (QWidget* at = found; at; at = at->parentWidget())
    {
      if (auto* const scroll = qobject_cast<QScrollArea*>(at))
      {
        scroll->ensureWidgetVisible(found);
        QTest::qWait(20);
      }
    }
    return found;
  }

  void Press(const char* name) { this->hand.Click(this->Reachable<QPushButton>(name)); }

  void AddScan(const std::string& scan)
  {
    this->hand.RaisePanel(this->window.get(), "volumes");
    this->hand.Expect(
      [this, scan](QWidget* dialog)
      {
        this->hand.ExpectFile(QString::fromStdString(scan));
        for (QAbstractButton* const button : qobject_cast<QMessageBox*>(dialog)->buttons())
        {
          if (qobject_cast<QMessageBox*>(dialog)->buttonRole(button) == QMessageBox::NoRole)
          {
            this->hand.Click(button); // in a folder
            return;
          }
        }
      });
    this->hand.Click(
      this->window->findChild<QDockWidget*>("volumes")->findChild<QPushButton*>("addScan"));
    Await([this] { return this->Model()->CurrentScene().overlays.size() == 1; },
      "the further scan is not added");
  }

  // A slice through a place, as after scrolling to it, which differs for each scan.
  SliceView* SliceAt(SlicePlane plane, const glm::dvec3& place)
  {
    this->Model()->Edit(ScenePart::Slices, "scroll",
      [&](Scene& scene) {
        scene.slices.crosshairMm = { place.x, place.y, place.z };
      });
    QTest::qWait(100);
    const QList<SliceView*> slices = this->window->findChildren<SliceView*>();
    return *std::find_if(slices.begin(), slices.end(),
      [plane](const SliceView* slice) { return slice->Plane() == plane; });
  }

  static QPoint PlaceOf(const SliceView& slice, const glm::dvec3& place)
  {
    return slice.PlaceOf({ place.x, place.y, place.z }).toPoint();
  }

  void Take(const QString& name, QWidget* widget)
  {
    if (this->takesPictures && !widget->grab().save(this->folder + "/" + name + ".png"))
    {
      throw std::runtime_error("a picture is not written");
    }
  }

  // Takes a picture of the window, and closes it.
  void Finish(const QString& name, const QString& task)
  {
    this->efforts.push_back({ task, this->hand.Clicks(), this->hand.Seconds() });
    if (this->takesPictures)
    {
      AwaitPictures(*this->window);
    }
    this->Take(name, this->window.get());
    this->hand.ExpectToDiscard();
    this->window->close();
    this->window.reset();
    this->hand.ForgetExpected();
    QSettings().remove("window/panels"); // each task begins as on the first day
  }

  QString folder;
  QString head;
  bool takesPictures;
  TaskScans scans;
  FakeWebArchive server;
  TaskHand hand;
  std::unique_ptr<MainWindow> window;
  std::vector<Effort> efforts;
};

int Run(const QCommandLineParser& options)
{
  Tasks tasks(
    options.positionalArguments().value(0), options.value("head"), !options.isSet("table"));
  const std::pair<const char*, void (Tasks::*)()> all[] = { { "open-cd", &Tasks::OpenCd },
    { "aneurysm", &Tasks::FindAneurysm }, { "pet", &Tasks::MeasureUptake },
    { "nodule", &Tasks::MeasureNodule }, { "bone", &Tasks::ShowBoneWithoutTable },
    { "curved", &Tasks::StraightenVessel }, { "two-times", &Tasks::CompareTimes },
    { "send", &Tasks::SendToPacs }, { "face", &Tasks::ExportWithoutFace },
    { "report", &Tasks::WriteReport } };
  for (const auto& [name, task] : all)
  {
    if (!options.isSet("task") || options.value("task") == name)
    {
      (tasks.*task)();
    }
  }
  for (const Effort& effort : tasks.Efforts())
  {
    std::cout << effort.task.toStdString() << ": clicks " << effort.clicks << ", seconds "
              << std::lround(effort.seconds) << '\n';
  }
  const QStringList missing =
    options.isSet("table") ? MissingRows(options.value("table"), tasks.Efforts()) : QStringList();
  for (const QString& row : missing)
  {
    std::cerr << "TenTasks.md lacks the row that begins with " << row.toStdString() << '\n';
  }
  return missing.isEmpty() ? 0 : 1;
}

}

int main(int argumentCount, char** arguments)
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  const PrivateSettings settings;
  QApplication application(argumentCount, arguments);
  QCommandLineParser options;
  options.addPositionalArgument("folder", "of the pictures");
  options.addOption({ "language", "of the window", "code", "en" });
  options.addOption({ "theme", "of the window", "name", "light" });
  options.addOption({ "head", "CT of a head", "file" });
  options.addOption({ "task", "to do alone, named as its picture", "name" });
  options.addOption({ "table", "with the clicks of each task", "file" });
  options.process(application);
  try
  {
    QSettings().setValue("window/theme", options.value("theme"));
    ApplyTheme(ChosenTheme());
    Speak(options.value("language"), &application);
    return Run(options);
  }
  catch (const std::exception& problem)
  {
    std::cerr << "ViewerTasks: " << problem.what() << '\n';
    return 2;
  }
}
